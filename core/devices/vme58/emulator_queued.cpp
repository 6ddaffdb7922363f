// Queued commands, carried out when their turn comes.
#include "core/devices/vme58/emulator_board.h"

namespace hw::vme58 {

Board::Step Board::execute(int context, const Command& c) {
  source_ = c.source;
  switch (c.op()) {
    case Op::AC:
    case Op::VL:
    case Op::VB: return set_speeds(context, c);
    case Op::MA:
    case Op::MR:
    case Op::MT:
    case Op::ML: return prepare(context, c);
    case Op::GO: return go(context, false);
    case Op::GD: return go(context, true);
    case Op::JG:
    case Op::JF: return jog(context, c);
    case Op::HM:
    case Op::HR:
    case Op::KM:
    case Op::KR: return home(context, c);
    case Op::MP:
    case Op::MM:
    case Op::MV:
    case Op::SP: return staircase(context, c);
    case Op::RM: motion_.remainder(context, static_cast<std::int64_t>(c.first())); return Step::done;
    case Op::CX: return play_contour(context);
    case Op::ID: return raise_done(context, false);
    case Op::IP: return raise_done(context, true);
    case Op::II: return promise_each(context);
    case Op::IN: return notify(context, c);
    case Op::AN: switch_aux(axes_of(context), true); return Step::done;
    case Op::AF: switch_aux(axes_of(context), false); return Step::done;
    case Op::BL: drive_line(static_cast<int>(c.first()), true); return Step::done;
    case Op::BH: drive_line(static_cast<int>(c.first()), false); return Step::done;
    default: return Step::done;
  }
}

/// The queue waits until the axes have arrived; AM's queue continues at once.
Board::Step Board::motion_began(int context, unsigned axes) {
  BoardTask& t = tasks_[ix(context)];
  t.last_axes = axes;
  t.driven |= axes;
  if (context == context_tasks) return Step::done;
  t.running = axes;
  return Step::runs;
}

Board::Step Board::set_speeds(int context, const Command& c) {
  each(c, context, [&](int a, double value) {
    AxisSettings& s = motion_.settings(a);
    (c.op() == Op::AC ? s.acceleration : c.op() == Op::VL ? s.velocity : s.base_velocity) = value;
    motion_.changed(a);
  });
  return Step::done;
}

Board::Step Board::prepare(int context, const Command& c) {
  Move& move = tasks_[ix(context)].prepared;
  const bool relative = c.op() == Op::MR || c.op() == Op::ML;
  each(c, context, [&](int a, double counts) {
    move.goal[ix(a)] = AxisGoal{static_cast<std::int64_t>(counts), relative};
  });
  return Step::done;
}

Board::Step Board::go(int context, bool clear_done) {
  const Move move = std::exchange(tasks_[ix(context)].prepared, Move());
  const unsigned axes = move.axes();
  if (axes == 0) return Step::done;  // decision M51
  if (clear_done) flags_.clear_done(axes);
  if (!motion_.start(move)) return refused();
  return motion_began(context, axes);
}

Board::Step Board::jog(int context, const Command& c) {
  BoardTask& t = tasks_[ix(context)];
  unsigned axes = 0;
  each(c, context, [&](int a, double velocity) {
    if (motion_.jog(a, velocity))
      axes |= 1u << a;
    else
      command_error();
  });
  if (axes != 0) t.last_axes = axes;
  t.driven |= axes;
  return Step::done;
}

Board::Step Board::home(int context, const Command& c) {
  HomeOrder order;
  order.way = c.op() == Op::HM || c.op() == Op::KM ? Sign::plus : Sign::minus;
  order.kill = c.op() == Op::KM || c.op() == Op::KR;
  unsigned axes = 0;
  const auto begin = [&](int a, double position) {
    order.position = static_cast<std::int64_t>(position);
    if (motion_.home(a, order))
      axes |= 1u << a;
    else
      command_error();
  };
  if (order.kill)
    each_axis(axes_of(context), [&](int a) { begin(a, 0); });
  else
    each(c, context, begin);
  return axes == 0 ? Step::done : motion_began(context, axes);
}

Board::Step Board::staircase(int context, const Command& c) {
  const auto position = static_cast<std::int64_t>(c.first());
  bool accepted = true;
  switch (c.op()) {
    case Op::MP: motion_.set_direction(context, Sign::plus); return Step::done;
    case Op::MM: motion_.set_direction(context, Sign::minus); return Step::done;
    case Op::MV: accepted = motion_.move_velocity(context, position, *c.number[1]); break;
    default: accepted = motion_.stop_at(context, position); break;
  }
  return accepted ? motion_began(context, 1u << context) : refused();
}

Board::Step Board::play_contour(int context) {
  if (!recorder_.contour().complete || motion_.board().contour_velocity <= 0)
    return refused();  // decisions M21, M71
  if (!motion_.play(recorder_.contour())) return refused();
  return motion_began(context, recorder_.contour().axes);
}

// --- done flags --------------------------------------------------------------------------------------------

/// Decision M53: the axes of the last move. Before any move, all axes that the mode addresses, so that ID of
/// a single axis that has never moved sets its flag: a host that sends ID after its set-up would otherwise
/// wait for ever. The data sheet does not say.
unsigned Board::flagged_axes(int context) const {
  const BoardTask& t = tasks_[ix(context)];
  return context < most_axes || t.last_axes == 0 ? axes_of(context) : t.last_axes;
}

Board::Step Board::raise_done(int context, bool in_position) {
  const unsigned axes = flagged_axes(context);
  if (context == context_tasks) {
    tasks_[ix(context)].promises.push_back({axes, in_position});
    raise_promised_flags(tasks_[ix(context)]);
    return Step::done;
  }
  if (in_position && !all_in_position(axes)) return Step::waits;
  set_done(axes);
  return Step::done;
}

Board::Step Board::promise_each(int context) {
  BoardTask& t = tasks_[ix(context)];
  each_axis(flagged_axes(context), [&](int a) { t.promises.push_back({1u << a, false}); });
  raise_promised_flags(t);
  return Step::done;
}

/// Before GO the command applies to the coming move, after it to the one under way.
Board::Step Board::notify(int context, const Command& c) {
  each(c, context, [this](int a, double left) { motion_.notify_at(a, static_cast<std::int64_t>(left)); });
  return Step::done;
}

}  // namespace hw::vme58
