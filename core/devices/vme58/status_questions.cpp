#include "core/devices/vme58/status_questions.h"

#include <utility>

#include <fmt/core.h>

#include "core/base/index.h"
#include "core/devices/vme58/catalog.h"

namespace hw::vme58 {

Task<Result<>> StatusQuestions::ask_in_turn() {
  const bool may_ask = !selection_.recording();
  if (may_ask && (next_.wants_flags() || wants_done())) {
    auto asked = co_await read_flags();
    if (!asked) co_return asked;
  } else if (!may_ask) {
    auto looked = co_await look_at_done();
    if (!looked) co_return looked;
  }
  if (may_ask && (readings_.status() & status::slip) != 0 && (slips_ == 0 || in_turn())) {
    auto asked = co_await read_slips();
    if (!asked) co_return asked;
  }
  if (may_ask && next_.wants_loops()) {
    auto asked = co_await read_loops();
    if (!asked) co_return asked;
    next_.loops_were_asked();
  }
  const bool turning = snapshot_.any_axis_moving();
  const bool queues = wants_queues();
  if (may_ask && queues) {
    const auto worked_off = co_await is_worked_off();
    if (!worked_off) co_return fail(worked_off.error());
    if (*worked_off && std::exchange(snapshot_.working, false)) {
      next_.asks_flags();
      motions_.queues_emptied();
    }
  }
  if (!may_ask && !turning) snapshot_.working = false;  // the queues cannot be read
  co_return co_await speeds_.give_all_back(Priority::poll);
}

// An axis may carry out commands of other hosts; a queue that is not empty is read until it is empty.
bool StatusQuestions::wants_queues() {
  bool matters = snapshot_.working || watches(queue_group) || snapshot_.program.run == RunState::running;
  bool at_once = next_.takes_queues(snapshot_.any_axis_moving());
  for (int i = 0; i < axes(); ++i) {
    const bool waiting = bit(snapshot_.queue_known, i) && snapshot_.queue_free[ix(i)] < queue_entries;
    const bool anothers = motions_.moving(i) && !motions_.ours(i);
    matters = matters || waiting || speeds_.velocity.may_wait(i) || anothers;
    at_once = at_once || motions_.asks_queue(i);
  }
  return at_once || (matters && in_turn());
}

Task<Result<bool>> StatusQuestions::is_worked_off() {
  auto queues = co_await queues_.read(Priority::poll);
  if (!queues) co_return fail(queues.error());
  if (!queues_.empty() || snapshot_.any_axis_moving()) co_return false;
  auto looked = co_await readings_.look_at_registers(Priority::poll, true);
  if (!looked) co_return fail(looked.error());
  auto read = co_await readings_.read_axes(Priority::poll, Readings::Copy::is_asked_for);
  if (!read) co_return fail(read.error());
  co_return !snapshot_.any_axis_moving();
}

// ---- flags

Task<Result<>> StatusQuestions::read_flags() {
  const ReplyForm form{ReplyForm::Of::flags, axes()};
  auto reply = co_await conversation_.ask("QI\n", Priority::poll, form);
  if (!reply && reply.error().kind == FaultKind::stopped) co_return fail(reply.error());
  next_.flags_were_asked();
  if (!reply) co_return fail(reply.error());
  const auto flags = decode_all_flags(*reply);
  unsigned done = 0;
  for (int i = 0; i < axes() && i < static_cast<int>(flags.size()); ++i) {
    limits_.read_direction(i, flags[ix(i)].plus, motions_.at_rest(i) && !snapshot_.working);
    if (flags[ix(i)].done) done |= 1u << i;
  }
  take_done(done);
  co_return Result<>();
}

// Also reads the flags for the memory map.
bool StatusQuestions::wants_done() const {
  if ((readings_.status() & status::done) == 0) return false;
  return motions_.waits_for_done() || (watches(memory_group) && in_turn());
}

Task<Result<>> StatusQuestions::look_at_done() {
  if (!wants_done()) co_return Result<>();
  std::vector<BusCycle>& cycles = wire_.burst();
  cycles.push_back(BusCycle::read(1, reg::done));
  auto looked = co_await wire_.run(cycles, Priority::poll);
  if (!looked) co_return looked;
  take_done(cycles.front().value);
  co_return Result<>();
}

void StatusQuestions::take_done(unsigned axes) {
  snapshot_.window.put(reg::done, 1, axes);
  motions_.take_done(axes);
}

// ---- slips and loops

void StatusQuestions::take_slip_flag(bool any) {
  if (!any) slips_ = 0;
  snapshot_.window.put(reg::slip, 1, slips_);
  for (int i = 0; i < axes(); ++i) {
    AxisState& axis = snapshot_.axes[i];
    axis.slipped = bit(slips_, i);
    show("SLIP", i, bit(slips_, i));
    if (axis.loop == Loop::unknown)
      show("HN", i, std::nullopt);
    else
      show("HN", i, axis.loop != Loop::open);
    if (bit(snapshot_.queue_known, i))
      show("RQ", i, snapshot_.queue_free[ix(i)]);
    else
      show("RQ", i, std::nullopt);
  }
}

/// Shows a value in the readout of that axis, if it has one.
void StatusQuestions::show(std::string_view letters, int axis, std::optional<std::int64_t> value) {
  const int place = catalog_.find_readout(fmt::format("{}{}", letters, catalog_.axes[ix(axis)].name));
  if (place < 0) return;
  if (value) snapshot_.readouts[ix(place)] = *value;
  snapshot_.readouts_known.set(ix(place), value.has_value());
  snapshot_.readouts_seen_at[ix(place)] = wire_.now();
}

// RL leaves the flags as they are. A flag that was seen before is not reported again.
Task<Result<>> StatusQuestions::read_slips() {
  const auto before = slips_;
  const ReplyForm form{ReplyForm::Of::slips, axes()};
  auto reply = co_await conversation_.ask("RL\n", Priority::poll, form);
  if (!reply) co_return fail(reply.error());
  for (int i = 0; i < axes() && ix(i) < reply->size(); ++i)
    if ((*reply)[ix(i)] == 'S' && !bit(slips_, i)) slipped(i);
  snapshot_.window.put(reg::slip, 1, slips_);
  if (slips_ != before) co_return co_await read_loops();  // with TN a slip opens the loop
  co_return Result<>();
}

// After a slip the count of a step motor is wrong; a servo motor is where its encoder is.
void StatusQuestions::slipped(int i) {
  slips_ = static_cast<std::uint8_t>(slips_ | 1u << i);
  snapshot_.axes[i].slipped = true;
  if (!catalog_.axes[ix(i)].switchable) snapshot_.axes[i].trust.doubt(Doubt::slipped, wire_.now());
  const std::string& name = catalog_.axes[ix(i)].name;
  if (const int place = catalog_.find_readout("SLIP" + name); place >= 0) snapshot_.readouts[ix(place)] = 1;
  wire_.report(
      Notice::Kind::warning,
      fmt::format("Axis {} has slipped: its encoder and its position differ by more than ES allows.", name));
}

/// Which servo loops are closed, by EA (decision M04).
Task<Result<>> StatusQuestions::read_loops() {
  if (selection_.recording()) co_return Result<>();
  std::string text;
  std::vector<int> asked;
  for (int i = 0; i < axes(); ++i) {
    if (!catalog_.axes[ix(i)].switchable || !snapshot_.axes[i].has_encoder) continue;
    text += fmt::format("A{} EA ", catalog_.axes[ix(i)].name);
    asked.push_back(i);
  }
  if (asked.empty()) co_return Result<>();
  text += selection_.selector() + "\n";
  const ReplyForm form{ReplyForm::Of::loop};
  const auto replies =
      co_await conversation_.ask_several(std::move(text), asked.size(), Priority::poll, form);
  if (!replies && replies.error().kind == FaultKind::no_answer) co_return Result<>();
  if (!replies) co_return fail(replies.error());
  for (std::size_t n = 0; n < asked.size(); ++n) loops_.know(asked[n], (*replies)[n][1] == 'E');
  co_return Result<>();
}

}  // namespace hw::vme58
