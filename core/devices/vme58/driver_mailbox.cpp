// Urgent commands go through the mailbox (decision M29): past the ring, past full queues. A stop of all axes
// empties the queues too; what still stands in the ring behind them is taken back, or it would act then.
#include <fmt/core.h>

#include "core/base/index.h"
#include "core/devices/vme58/driver.h"

namespace hw::vme58 {
namespace {

constexpr Duration mail_patience = Millis(50);
constexpr Duration mail_look = std::chrono::microseconds(500);
constexpr Duration ring_patience = Millis(5);  // another stop may just be on its way
constexpr Duration standstill_look = Millis(10);
constexpr Duration longest_stop = std::chrono::seconds(60);  // of a ramp that the user made long

}  // namespace

/// The mailbox is free: the board has taken what stood in it (control register, bit 5). False: not in time.
Task<Result<bool>> Vme58Driver::mail_is_taken() {
  Burst burst(*this);
  const Instant give_up = scheduler_.now() + mail_patience;
  for (;;) {
    burst.cycles.assign(1, BusCycle::read(1, reg::control));
    auto looked = co_await run(burst.cycles, Priority::stop);
    if (!looked) co_return fail(looked.error());
    if ((burst.cycles[0].value & control::interrupt_board) == 0) co_return true;
    if (scheduler_.now() > give_up) co_return false;
    co_await scheduler_.sleep_for(mail_look);
  }
}

// A word put over one that the board has not taken would be lost with its request, or instead of it. Behind
// a request that the board never takes back it is put there all the same: it may be a stop.
Task<Result<>> Vme58Driver::mail(std::string_view letters) {
  const std::string word(letters);
  while (mailing_) co_await scheduler_.sleep_for(mail_look);
  mailing_ = true;
  struct Mailing {
    Vme58Driver& driver;
    explicit Mailing(Vme58Driver& d) : driver(d) {}
    ~Mailing() { driver.mailing_ = false; }
  } mailing(*this);
  const auto free = co_await mail_is_taken();
  if (!free) co_return fail(free.error());
  const auto kept = static_cast<std::uint8_t>(control_ | (updating_ ? control::update_data : 0));
  Burst burst(*this);
  append_mail(burst.cycles, word, kept);
  auto sent = co_await run(burst.cycles, Priority::stop);
  if (!sent) co_return sent;
  record(Way::sent, Priority::stop, fmt::format("mailbox {}", word));
  const auto taken = co_await mail_is_taken();
  if (!taken) co_return fail(taken.error());
  if (*taken) co_return Result<>();
  co_return fail(FaultKind::no_answer, fmt::format("The board did not take {} out of its mailbox.", word),
                 "It was put there.", "Watch the machine. If it still moves, switch its power off.");
}

Task<Result<>> Vme58Driver::stop(int axis, bool at_once) {
  const bool asked_twice = stops_.ramps(axis);
  co_return co_await stop_what(axis, at_once || asked_twice, false);
}

// What the jog moves stops; the other axes, and what waits for this one, go on. Letting go is never the
// second stop.
Task<Result<>> Vme58Driver::stop_jog(int axis) { co_return co_await stop_what(axis, false, true); }

/// ST of one axis empties its own queue only: what a program still says, or what waits in those of AA and AM,
/// would move it again.
bool Vme58Driver::stops_alone(int axis) const {
  return !minds_[ix(axis)].in_group && draft_.program.run != RunState::running && !draft_.feed.running;
}

Task<Result<>> Vme58Driver::stop_what(int axis, bool at_once, bool jog) {
  if (!station_)
    co_return fail(FaultKind::lost, "Stop does not reach the board: there is no connection.",
                   "Nothing was sent.", "Switch the power of the drives off.");
  stops_.begin(axis, at_once);
  forget_rejection();
  const bool one = axis >= 0 && !at_once && minds_[ix(axis)].group == 0 && !context_.recording;
  const bool alone = one && (jog || stops_alone(axis));
  if (one && !alone)
    tell(Notice::Kind::info,
         fmt::format("A program or a text may move {} again, so all axes were stopped.", axis_name(axis)));
  const bool recorded = context_.recording;
  if (!alone) end_program(at_once ? EndedBy::abort : EndedBy::stop);
  stopping(alone ? axis : -1, at_once);
  if (axis >= 0 && at_once)
    tell(Notice::Kind::info, "The board's only stop without a ramp, KL, stops every axis.");
  std::string selector = alone ? "A" + axis_name(axis) : std::string();
  Result<> stopped;
  if (alone)
    stopped = co_await stop_axis(std::move(selector));
  else
    stopped = co_await stop_all(at_once ? "KL" : "SA");
  if (stopped && recorded) (void)co_await select_again(Priority::stop);  // else with the next text
  if (stopped) stopped = co_await wait_for_standstill(alone ? axis : -1);
  stops_.end(axis, at_once);
  if (station_) stands(alone ? axis : -1);
  co_return stopped;
}

// The mailbox has no place for an axis: ST goes through the ring, as long as nothing stands there. In AA and
// AM it stops what their queue moves.
Task<Result<>> Vme58Driver::stop_axis(std::string selector) {
  auto free = co_await is_taken(Priority::stop);
  for (const Instant give_up = scheduler_.now() + ring_patience;
       free && !*free && scheduler_.now() < give_up;) {
    co_await scheduler_.sleep_for(mail_look);
    free = co_await is_taken(Priority::stop);
  }
  if (!free) co_return fail(free.error());
  if (*free) {
    const std::string text = addressed(selector, "ST");
    auto written = co_await write(text, Priority::stop);
    if (written || written.error().kind == FaultKind::lost) co_return written;
  }
  const bool group = selector == "AA" || selector == "AM";
  tell(Notice::Kind::warning,
       fmt::format("The board takes no command for {} alone now, so all axes were stopped.",
                   group ? "the axes of " + selector : "axis " + selector.substr(1)));
  stopping(-1, false);
  co_return co_await stop_all("SA");
}

/// SA, SD or KL.
Task<Result<>> Vme58Driver::stop_all(std::string_view word) {
  if (word == "KL") doubt_killed_positions();
  // The mail overtakes text that stands in the ring: taken a moment later it would move behind the stop.
  const bool overtakes = on_its_way_;
  auto mailed = co_await mail(word);
  if (!mailed && mailed.error().kind == FaultKind::lost) co_return mailed;
  const auto taken = co_await is_taken(Priority::stop);
  if (!taken) co_return fail(taken.error());
  if (mailed && *taken && !overtakes) co_return mailed;
  const int begin = advanced(put_, 1 - ring_cells);  // everything, whoever has put it there
  auto withdrawn = co_await withdraw_text(Priority::stop, begin);
  if (!withdrawn) co_return withdrawn;
  if (mailed) mailed = co_await mail(word);  // what it took in between may have begun something
  if (mailed) co_return mailed;
  const std::string text = std::string(word) + "\n";
  auto written = co_await write(text, Priority::stop);
  if (written) co_return written;
  co_return mailed;
}

/// Its pulses end with KL, not its mass: a step motor stays in step only up to the speed at which it may
/// start without a ramp too.
void Vme58Driver::doubt_killed_positions() {
  for (int i = 0; i < axis_count(); ++i) doubt_killed_position(i, draft_.axes[i].speed.value);
}

void Vme58Driver::doubt_killed_position(int i, double speed) {
  const std::int64_t safe = value(i, AxisValue::base_velocity);
  if (catalog_.axes[ix(i)].switchable || speed <= static_cast<double>(safe)) return;
  draft_.axes[i].trust.doubt(Doubt::killed, scheduler_.now());
  tell(Notice::Kind::warning,
       fmt::format("Axis {} was stopped without a ramp at {:.0f} counts/s. Above {} (VB) it may have lost "
                   "steps: its position is doubtful until it is homed or set.",
                   axis_name(i), speed, safe));
}

/// Its motion to the home switch has come there. KM and KR stop dead, from VL.
void Vme58Driver::comes_home(int i) {
  const AtHome how = std::exchange(minds_[ix(i)].at_home, AtHome::nothing);
  if (how == AtHome::sets_counter) trusted(i, Trust::homed);
  if (how == AtHome::stops_dead)
    doubt_killed_position(i, static_cast<double>(value(i, AxisValue::maximum_velocity)));
}

void Vme58Driver::stopping(int axis, bool at_once) {
  for (int i = 0; i < axis_count(); ++i) {
    if (axis >= 0 && i != axis) continue;
    AxisMind& mind = minds_[ix(i)];
    forget_put_velocities(i);
    begins_to_creep(i, {});
    mind.at_home = AtHome::nothing;  // one that waits in a queue goes with it
    mind.servo.goes_to_place = mind.servo.settling = false;
    if (!moving(i) && !mind.ours) continue;
    mind.stopping = true;
    mind.ended_by = at_once ? EndedBy::abort : EndedBy::stop;
    draft_.axes[i].activity = Activity::stopping;
  }
}

// What was being stopped is shown as it is again.
void Vme58Driver::stands(int axis) {
  for (int i = 0; i < axis_count(); ++i) {
    if ((axis >= 0 && i != axis) || !minds_[ix(i)].stopping) continue;
    if (moving(i))
      minds_[ix(i)].stopping = false;
    else
      end_motion(i, minds_[ix(i)].ended_by);
  }
}

Task<Result<>> Vme58Driver::wait_for_standstill(int axis) {
  const Instant give_up = scheduler_.now() + longest_stop;
  for (;;) {
    auto read = co_await read_axes(Priority::stop);
    if (!read) co_return read;
    bool turns = false;
    for (int i = 0; i < axis_count(); ++i) turns = turns || ((axis < 0 || i == axis) && moving(i));
    if (!turns) co_return Result<>();
    if (scheduler_.now() > give_up)
      co_return fail(FaultKind::controller, "The board was told to stop and still moves.",
                     "The stop was sent.", "Stop again: it then stops at once, without a ramp.");
    co_await scheduler_.sleep_for(standstill_look);
    if (!station_) co_return fail(FaultKind::lost, "The connection was lost while the axes were stopping.");
  }
}

}  // namespace hw::vme58
