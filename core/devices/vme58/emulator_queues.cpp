// Processing of the queues: one for each axis, one for AA, one for AM (decision M20). A command that moves
// axes stays in its queue until they arrive. AM goes on at once with commands for other axes (decision M50).
#include <algorithm>

#include "core/devices/vme58/emulator_board.h"

namespace hw::vme58 {
namespace {

constexpr Duration shortest_turn = std::chrono::milliseconds(1);  // of a loop whose commands take no time

/// Whether the command may take effect while the preceding move is still under way.
constexpr bool looks_at_move(Op op) { return op == Op::II || op == Op::IN; }

}  // namespace

void Board::put_in_queue(const Command& c) {
  CommandQueue& queue = tasks_[ix(context_)].queue;
  source_ = c.source;
  if (!queue.nests(c)) return text_error();
  if (queue.room() < c.entries()) {
    held_ = c;
    return;
  }
  queue.push(c);
}

void Board::run_queues() {
  for (bool more = true; more;) {
    more = false;
    for (int context = 0; context < contexts; ++context) more |= run_task(context);
  }
}

/// True: a command was carried out.
bool Board::run_task(int context) {
  BoardTask& t = tasks_[ix(context)];
  raise_promised_flags(t);
  bool progress = false;
  while (const Command* c = t.queue.current()) {
    if (t.running != 0) {
      look_ahead(context);
      if (any_occupied(t.running)) break;
      t.running = 0;
      t.queue.advance(std::exchange(t.looked_ahead, 0));
    } else {
      const Step result = step(context, *c);
      if (result == Step::waits) break;
      if (result == Step::done) t.queue.advance();
    }
    progress = true;
    take_events();
  }
  return progress;
}

Board::Step Board::step(int context, const Command& c) {
  BoardTask& t = tasks_[ix(context)];
  source_ = c.source;
  if (t.waiting) return wait_time(t, c);
  if (t.wait_until) {
    if (now() < *t.wait_until) return Step::waits;
    t.wait_until.reset();
  }
  if (any_occupied(waits_for(context, c))) return Step::waits;
  switch (c.op()) {
    case Op::WT: return wait_time(t, c);
    case Op::SW: return line_is_true(static_cast<int>(c.first())) ? Step::waits : Step::done;
    case Op::WA: {
      bool moving = false;
      each_axis(fitted_, [&](int a) { moving = moving || motion_.moving(a); });
      return moving ? Step::waits : Step::done;
    }
    case Op::LS:
    case Op::WS:
    case Op::WH: return open_block(t, c);
    case Op::LE: t.queue.count_turn(); return end_block(t, t.queue.turns_left() > 0);
    case Op::WD: return end_block(t, line_is_true(t.queue.block_operand()));
    case Op::WG: return end_block(t, !std::exchange(t.leave_while, false));
    default: return execute(context, c);
  }
}

unsigned Board::waits_for(int context, const Command& c) const {
  const BoardTask& t = tasks_[ix(context)];
  if (context < most_axes) return 1u << context;
  switch (c.op()) {
    case Op::GO:
    case Op::GD: return t.prepared.axes();
    case Op::KM:
    case Op::KR: return fitted_;
    case Op::CX: return recorder_.contour().axes;
    case Op::AC:
    case Op::VL:
    case Op::VB:
    case Op::JG:
    case Op::HM:
    case Op::HR: {
      unsigned axes = 0;
      for (int a = 0; a < most_axes; ++a)
        if (c.number[ix(a)]) axes |= 1u << a;
      return axes;
    }
    case Op::MA:
    case Op::MR:
    case Op::MT:
    case Op::ML:
    case Op::II:
    case Op::IN: return 0;
    case Op::ID:
    case Op::IP:
    case Op::LS:
    case Op::LE:
    case Op::WS:
    case Op::WD:
    case Op::WH:
    case Op::WG: return context == context_tasks ? 0 : t.last_axes;
    default: return t.last_axes;
  }
}

bool Board::any_occupied(unsigned axes) const {
  bool some = false;
  each_axis(axes, [&](int a) { some = some || motion_.occupied(a); });
  return some;
}

bool Board::all_in_position(unsigned axes) const {
  bool all = true;
  each_axis(axes, [&](int a) { all = all && motion_.in_position(a); });
  return all;
}

void Board::look_ahead(int context) {
  BoardTask& t = tasks_[ix(context)];
  for (;;) {
    const Command* next = t.queue.at(1 + t.looked_ahead);
    if (next == nullptr || !looks_at_move(next->op())) return;
    ++t.looked_ahead;
    (void)execute(context, *next);
  }
}

void Board::raise_promised_flags(BoardTask& t) {
  const auto kept = [this](const BoardTask::Promise& p) {
    if (any_occupied(p.axes) || (p.in_position && !all_in_position(p.axes))) return false;
    set_done(p.axes);
    return true;
  };
  t.promises.erase(std::remove_if(t.promises.begin(), t.promises.end(), kept), t.promises.end());
}

/// The condition that WQ waits for.
bool Board::runs_empty(int context) const {
  const BoardTask& t = tasks_[ix(context)];
  if (!t.queue.empty() || !t.promises.empty()) return false;
  return context != context_tasks || !any_occupied(t.last_axes);
}

// --- waits and loops ---------------------------------------------------------------------------------------

Board::Step Board::wait_time(BoardTask& t, const Command& c) {
  if (!t.waiting) {
    t.waiting = true;
    t.wait_until = now() + Millis(static_cast<std::int64_t>(c.first()));
  }
  if (now() < *t.wait_until) return Step::waits;
  t.waiting = false;
  t.wait_until.reset();
  return Step::done;
}

Board::Step Board::open_block(BoardTask& t, const Command& c) {
  t.turn_began = now();
  t.queue.open_block(static_cast<std::int64_t>(c.first()));
  return Step::moved_on;
}

Board::Step Board::end_block(BoardTask& t, bool again) {
  t.queue.end_block(again);
  if (again && t.turn_began == now()) t.wait_until = now() + shortest_turn;
  if (again) t.turn_began = t.wait_until.value_or(now());
  return Step::moved_on;
}

}  // namespace hw::vme58
