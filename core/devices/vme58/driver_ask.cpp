// What a round of status asks by command, while the board takes commands: flags, slips and queues.
#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "core/base/index.h"
#include "core/devices/vme58/driver.h"

namespace hw::vme58 {
namespace {

constexpr int queue_rounds = 5;

}  // namespace

Task<Result<>> Vme58Driver::ask_in_turn() {
  const bool may_ask = !selection_.recording();
  if (may_ask && (flags_wanted_ || wants_done())) {
    auto asked = co_await read_flags(Priority::poll);
    if (!asked) co_return asked;
  } else if (!may_ask && wants_done()) {
    auto looked = co_await read_done();
    if (!looked) co_return looked;
  }
  if (may_ask && (readings_.status() & status::slip) != 0 && (slips_ == 0 || round_ % queue_rounds == 0)) {
    auto asked = co_await read_slips();
    if (!asked) co_return asked;
  }
  if (may_ask && loops_wanted_) {
    auto asked = co_await read_loops(Priority::poll);
    if (!asked) co_return asked;
    loops_wanted_ = false;
  }
  // An axis may work at what others have sent; what is not empty is read until it is.
  const bool turning = draft_.any_axis_moving();
  bool matters = draft_.working || bit(watched_, queue_group) || draft_.program.run == RunState::running;
  bool at_once = queues_due_ && !turning;
  for (int i = 0; i < axis_count(); ++i) {
    const bool waiting = bit(draft_.queue_known, i) && draft_.queue_free[ix(i)] < queue_entries;
    const auto& velocity = minds_[ix(i)].put_velocity;
    const bool may_wait = velocity && !velocity->carried_out;
    matters = matters || waiting || may_wait || (moving(i) && !minds_[ix(i)].ours);
    at_once = at_once || minds_[ix(i)].asks_queue;
  }
  queues_due_ = turning && (queues_due_ || draft_.working);
  if (may_ask && (at_once || (matters && round_ % queue_rounds == 0))) {
    const auto worked_off = co_await is_worked_off();
    if (!worked_off) co_return fail(worked_off.error());
    if (*worked_off && std::exchange(draft_.working, false)) {
      flags_wanted_ = true;
      for (int i = 0; i < axis_count(); ++i) {
        AxisMind& mind = minds_[ix(i)];
        mind.by_text = false;
        if (mind.ours) continue;
        if (draft_.axes[i].ended_by == EndedBy::nothing) comes_home(i);
        mind.at_home = AtHome::nothing;
      }
    }
  }
  if (!may_ask && !turning) draft_.working = false;  // nobody can tell
  co_return co_await give_speeds_back(Priority::poll);
}

/// Every queue is empty and nothing turns. What AM has begun leaves its queue at once, and a switch may just
/// have emptied one: switches and axes are looked at after the queues.
Task<Result<bool>> Vme58Driver::is_worked_off() {
  auto queues = co_await read_queues(Priority::poll);
  if (!queues) co_return fail(queues.error());
  if (!queues_empty_ || draft_.any_axis_moving()) co_return false;
  const auto registers = co_await readings_.read_registers(Priority::poll, true);
  if (!registers) co_return fail(registers.error());
  readings_.take(*registers);
  auto read = co_await readings_.read_axes(Priority::poll, Readings::Copy::is_asked_for);
  if (!read) co_return fail(read.error());
  co_return !draft_.any_axis_moving();
}

/// The board reads no further: no queue can be asked for, and the one that the text is meant for is full
/// (what waits does not fit: fewer entries are free than it takes).
void Vme58Driver::show_full_queue() {
  draft_.queue_known = 0;
  Context context = selection_.context();
  if (conversation_.waits_in_wq()) return;
  for (const TextCommand& command : read_commands(conversation_.last_sent(), context)) {
    if (!command.fact || command.fact->when != When::queued || command.context.mode != where::single)
      continue;
    draft_.queue_known = 1u << command.context.axis;
    draft_.queue_free[ix(command.context.axis)] = 0;
  }
}

// One bit for both ends of an axis: the direction letter tells which one it stands on (decision M33). It is
// that of the latest motion, which may have led away from the switch: it counts when the switch is met, and
// when the axis was sent another way and did not move.
Task<Result<>> Vme58Driver::read_flags(Priority priority) {
  const ReplyForm flags_form{ReplyForm::Of::flags, axis_count()};
  auto reply = co_await conversation_.ask("QI\n", priority, flags_form);
  if (!reply && reply.error().kind == FaultKind::stopped) co_return fail(reply.error());
  flags_wanted_ = false;
  if (!reply) co_return fail(reply.error());
  const auto flags = decode_all_flags(*reply);
  unsigned done = 0;
  for (int i = 0; i < axis_count() && i < static_cast<int>(flags.size()); ++i) {
    AxisMind& mind = minds_[ix(i)];
    const auto letter = static_cast<std::int8_t>(flags[ix(i)].plus ? 1 : -1);
    const bool rests = !moving(i) && !mind.ours && !draft_.working;
    const bool turned_round = rests && mind.from_limit && mind.letter != 0 && mind.letter != letter;
    if (bit(limits_, i) && (mind.limit_end == 0 || turned_round)) mind.limit_end = mind.letter = letter;
    if (!bit(limits_, i) || rests) mind.letter = letter;
    if (flags[ix(i)].done) done |= 1u << i;
    show_limits(i);
  }
  take_done(done);
  co_return Result<>();
}

/// An axis of ours stands, and some done flag is set. Or somebody looks at the registers.
bool Vme58Driver::wants_done() const {
  if ((readings_.status() & status::done) == 0) return false;
  for (int i = 0; i < axis_count(); ++i) {
    const AxisMind& mind = minds_[ix(i)];
    if (mind.ours && !mind.stopping && !moving(i) && !settles(i) && mind.wanted != Activity::jogging)
      return true;
  }
  return bit(watched_, memory_group) && round_ % queue_rounds == 0;
}

Task<Result<>> Vme58Driver::read_done() {
  std::vector<BusCycle>& cycles = wire_.burst();
  cycles.push_back(BusCycle::read(1, reg::done));
  auto looked = co_await wire_.run(cycles, Priority::poll);
  if (!looked) co_return looked;
  take_done(cycles.front().value);
  co_return Result<>();
}

void Vme58Driver::take_done(unsigned axes) {
  draft_.window.put(reg::done, 1, axes);
  for (int i = 0; i < axis_count(); ++i) {
    AxisMind& mind = minds_[ix(i)];
    if (!bit(axes, i) || !mind.ours || mind.stopping) continue;
    mind.done = true;
    if (!moving(i)) show_still(i, now());
  }
}

// RL leaves the flags as they are. Of a flag that was seen before nothing more is told. A step motor that has
// slipped is not where its count says; a servo motor is where its encoder is.
Task<Result<>> Vme58Driver::read_slips() {
  const auto before = slips_;
  const ReplyForm form{ReplyForm::Of::slips, axis_count()};
  auto reply = co_await conversation_.ask("RL\n", Priority::poll, form);
  if (!reply) co_return fail(reply.error());
  for (int i = 0; i < axis_count() && ix(i) < reply->size(); ++i) {
    if ((*reply)[ix(i)] != 'S' || bit(slips_, i)) continue;
    slips_ = static_cast<std::uint8_t>(slips_ | 1u << i);
    draft_.axes[i].slipped = true;
    if (!catalog_.axes[ix(i)].switchable) draft_.axes[i].trust.doubt(Doubt::slipped, now());
    if (const int place = catalog_.find_readout(fmt::format("SLIP{}", axis_name(i))); place >= 0)
      draft_.readouts[ix(place)] = 1;
    tell(Notice::Kind::warning,
         fmt::format("Axis {} has slipped: its encoder and its position differ by more than ES allows.",
                     axis_name(i)));
  }
  draft_.window.put(reg::slip, 1, slips_);
  if (slips_ != before) co_return co_await read_loops(Priority::poll);  // TN opens the loop then
  co_return Result<>();
}

/// Which servo loops are closed, by EA (decision M04).
Task<Result<>> Vme58Driver::read_loops(Priority priority) {
  if (selection_.recording()) co_return Result<>();
  std::string text;
  std::vector<int> asked;
  for (int i = 0; i < axis_count(); ++i) {
    if (!catalog_.axes[ix(i)].switchable || !variant_.fitting(i).encoder) continue;
    text += fmt::format("A{} EA ", axis_name(i));
    asked.push_back(i);
  }
  if (asked.empty()) co_return Result<>();
  text += selection_.selector() + "\n";
  const auto replies = co_await conversation_.ask_several(std::move(text), asked.size(), priority, {ReplyForm::Of::loop});
  if (!replies && replies.error().kind == FaultKind::no_answer) co_return Result<>();
  if (!replies) co_return fail(replies.error());
  for (std::size_t n = 0; n < asked.size(); ++n) {
    const std::string& letters = (*replies)[n];
    if (letters.size() == 6 && (letters[1] == 'E' || letters[1] == 'D'))
      know_loop(asked[n], letters[1] == 'E');
  }
  co_return Result<>();
}

// The queues of AA and AM stand beside those of the axes (decision M20).
Task<Result<>> Vme58Driver::read_queues(Priority priority) {
  const bool were_empty = std::exchange(queues_empty_, false);
  std::string text;
  for (int i = 0; i < axis_count(); ++i) text += fmt::format("A{} RQ ", axis_name(i));
  text += fmt::format("AA RQ AM RQ {}\n", selection_.selector());
  auto replies = co_await conversation_.ask_several(std::move(text), ix(axis_count()) + 2, priority, {ReplyForm::Of::numbers});
  // A full ring or a WQ holds questions back: that is an answer too.
  if (!replies && replies.error().kind == FaultKind::no_answer) {
    draft_.queue_known = 0;
    co_return Result<>();
  }
  if (!replies) co_return fail(replies.error());
  bool empty = true;
  unsigned full_room = 0;
  for (std::size_t i = 0; i < replies->size(); ++i) {
    const auto numbers = decode_numbers((*replies)[i]);
    if (!numbers)
      co_return fail(FaultKind::garbled,
                     fmt::format("The board answered \"{}\" to RQ, which means nothing.", (*replies)[i]),
                     "It is asked again.");
    const auto full = [](std::int64_t free) { return free >= queue_entries; };
    const bool none_waits = std::all_of(numbers->begin(), numbers->end(), full);
    empty = empty && none_waits;
    if (none_waits) full_room |= 1u << i;
    if (i >= ix(axis_count()) || numbers->size() != 1) continue;
    draft_.queue_free[i] = static_cast<std::int16_t>(numbers->front());
    draft_.queue_known |= 1u << i;
  }
  queues_empty_ = empty;
  take_queues(were_empty);
  const unsigned all_groups = 3u << axis_count();
  if ((full_room & all_groups) == all_groups)
    for (AxisMind& mind : minds_) mind.in_group = false;
  for (int i = 0; i < axis_count(); ++i) {
    AxisMind& mind = minds_[ix(i)];
    const unsigned all_of_it = all_groups | 1u << i;
    if (mind.put_velocity && (full_room & all_of_it) == all_of_it) mind.put_velocity->carried_out = true;
    if (!std::exchange(mind.asks_queue, false) || !mind.ours) continue;
    const unsigned its = mind.group != 0 ? all_groups : 1u << i;
    const AxisState& axis = draft_.axes[i];
    if ((full_room & its) != its)
      mind.still_since = now();  // the move stands in the queue: it is under way, or has yet to begin
    else
      end_motion(i, axis.has_target && axis.command == axis.target ? EndedBy::target : EndedBy::elsewhere);
  }
  co_return Result<>();
}

/// What has waited in a queue has begun by now; of a jog that shows a little later.
void Vme58Driver::take_queues(bool were_empty) {
  if (were_empty || !queues_empty_) return;
  for (int i = 0; i < axis_count(); ++i)
    if (const Duration gap = minds_[ix(i)].jog_gap; gap > Duration::zero()) {
      begins_to_creep(i, gap);
      if (draft_.axes[i].activity == Activity::idle) draft_.axes[i].activity = Activity::moving;
    }
}

}  // namespace hw::vme58
