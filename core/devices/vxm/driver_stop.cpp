// Stopping, by decision V102: D ends a move of the console. A stored program is held (H), its motor ramped
// down (D) and ended by K once everything stands. At once is K. In Local mode: on-line (F), then K.
#include <algorithm>

#include <fmt/core.h>

#include "core/base/index.h"
#include "core/devices/vxm/driver.h"

namespace hw::vxm {
namespace {

// At acceleration 1 from the highest speed; nothing takes longer to ramp down.
constexpr Duration longest_ramp = from_seconds(max_speed / (accel_unit * min_accel));
constexpr Duration to_see_a_ramp = Millis(300);

}  // namespace

Task<Result<std::string>> VxmDriver::stop(const StopOrder& order) {
  using What = StopOrder::What;
  if (!talk_.station())
    co_return fail(FaultKind::lost, "Stop does not reach the controller: there is no connection.",
                   "Nothing was sent.", "Use its power switch.");
  if (order.what == What::broadcast) co_return std::string();  // a VXM is alone on its wire
  if (order.what == What::words) co_return co_await stop_by_words(order);
  auto sent = co_await send_stop(order);
  if (!sent) co_return fail(sent.error());
  co_return std::string();
}

Task<Result<>> VxmDriver::send_stop(const StopOrder& order) {
  const bool deaf = mode_ == Mode::unknown || talk_.station()->statistics().misses_in_a_row > 1;
  if (order.times_sent > 1 && deaf) {  // nothing has come back: a command that was left half said swallows it
    auto ended = co_await talk_.say("\r", Priority::stop);
    if (!ended) co_return ended;
  }
  if (mode_ == Mode::unknown) co_return co_await stop_blind(order);
  if (mode_ == Mode::local) co_return co_await stop_local();
  if (halted_) co_return co_await kill(false);
  if (job_.active()) co_return co_await stop_leg(order);
  if (stored_running_) co_return co_await stop_program(order);
  if (killed_at_ > order.first_sent_at) co_return Result<>();  // K has ended everything since
  if (order.at_once) co_return co_await kill(false);
  co_return co_await stop_unknown();
}

// Nothing is known of what the controller does now: H would switch a hold off as well as on, and K costs
// steps.
Task<Result<>> VxmDriver::stop_blind(const StopOrder& order) {
  if (order.what == StopOrder::What::jog && stored_running_) co_return Result<>();
  if (moves_for(order)) note_stop();
  if (order.at_once) co_return co_await kill(false);
  co_return co_await stop_unknown();
}

// As far as is known nothing runs. In Local mode D is answered; nothing may be sent into that answer.
Task<Result<>> VxmDriver::stop_unknown() {
  const Instant sent_at = scheduler_.now();
  auto said = co_await talk_.say("D", Priority::stop);
  if (!said || !talk_.station()) co_return said;
  auto waited = co_await talk_.station()->pause(talk_.station()->wire_time(4) + Millis(2));
  if (!waited || talk_.heard_at() <= sent_at) co_return waited;
  co_return co_await talk_.wait_for_quiet();
}

// K is dropped in Local mode. F disables the buttons that jog.
Task<Result<>> VxmDriver::stop_local() {
  auto said = co_await talk_.say("F", Priority::stop);
  if (!said) co_return said;
  stay_local_ = false;
  mode_ = Mode::on_line;
  co_return co_await kill(false);
}

Task<Result<>> VxmDriver::stop_leg(const StopOrder& order) {
  const bool concerned = moves_for(order);
  if (!concerned && order.what != StopOrder::What::jog) drop_later_legs(order.axis);
  if (!concerned) co_return Result<>();
  note_stop();
  show_stopping();
  if (order.at_once) co_return co_await kill(false);
  co_return co_await ramp_down();
}

// It is looked at from now on, and at the longest until the first D must have worked.
void VxmDriver::expect_ramp() {
  if (!ramp_) ramp_ = Ramp{scheduler_.now(), sight_.fastest()};
  ramp_->looked_at = scheduler_.now();
  ramp_->speed = sight_.fastest();
}

Task<Result<>> VxmDriver::ramp_down() {
  expect_ramp();
  co_return co_await talk_.say("D", Priority::stop);
}

// Held, its motor ramped down; K once that stands. H would let a program go on that is held: one that stands
// when its stop comes is not told to hold, unless it goes on after all.
Task<Result<>> VxmDriver::stop_program(const StopOrder& order) {
  if (order.what == StopOrder::What::jog) co_return Result<>();
  const auto is_held = [this] { return draft_.program.run == RunState::held; };
  if (is_held() || (ramp_ && ramp_->over)) co_return co_await kill(true);
  if (order.at_once) co_return co_await kill(false);
  if (!ramp_) {
    ramp_ = Ramp{scheduler_.now(), sight_.fastest(), hold_.is_on() || seems_to_stand()};
    hold_.expect_nothing_to_begin();
  }
  if (!ramp_->holds) {
    auto held = co_await switch_hold("H", true, Priority::stop);
    if (!held || !talk_.station()) co_return held;
    if (ramp_) ramp_->holds = true;
    hold_.expect_nothing_to_begin();
    // Between two commands the hold is told at once, and D into that listing would be an overrun.
    auto waited = co_await talk_.station()->pause(talk_.station()->wire_time(2) + Millis(1));
    if (!waited) co_return waited;
    if (is_held()) co_return co_await kill(true);
  }
  if (!stored_running_) co_return Result<>();  // it has ended by itself
  co_return co_await ramp_down();
}

/// What the console moves is in its scope.
bool VxmDriver::moves_for(const StopOrder& order) const {
  if (!job_.active()) return false;
  const Leg& leg = job_.legs.front();
  if (order.what == StopOrder::What::jog && leg.activity != Activity::jogging) return false;
  return order.axis < 0 || leg.axis == order.axis || leg.second_axis == order.axis;
}

void VxmDriver::show_stopping() {
  for (const int index : {job_.legs.front().axis, job_.legs.front().second_axis})
    if (index >= 0 && draft_.axes[index].activity != Activity::idle)
      draft_.axes[index].activity = Activity::stopping;
}

void VxmDriver::drop_later_legs(int axis) {
  std::erase_if(job_.legs, [&](const Leg& leg) {
    if (&leg == &job_.legs.front()) return false;
    const bool stops = axis < 0 || leg.axis == axis || leg.second_axis == axis;
    if (stops && axis >= 0 && leg.second_axis >= 0)
      console_.tell(Notice::Kind::warning,
                    fmt::format("Motors {} and {} were to move together: both stay now.", leg.axis + 1,
                                leg.second_axis + 1));
    return stops;
  });
}

// The leg under way ends, and nothing of the move follows it.
void VxmDriver::note_stop() {
  if (!job_.active()) return;
  if (job_.ended_by == EndedBy::nothing)
    job_.cut_whole = job_.legs.front().second_axis < 0 && job_.legs.size() == 1;
  job_.legs.resize(1);
  job_.jog = false;
  if (!job_.leg_over && job_.ended_by == EndedBy::nothing) job_.ended_by = EndedBy::stop;
}

// ---- what has become of it

StopProgress VxmDriver::stop_progress(const StopOrder& order) {
  if (halted_) return StopProgress::stands();          // nothing goes on until K
  const bool ramps_by_words = job_.active() && ramp_;  // what else they stop is told by their answer
  if (order.what == StopOrder::What::words && !ramps_by_words) return StopProgress::stands();
  if (job_.active()) {
    if (!moves_for(order)) return StopProgress::stands();
    if (job_.leg_over) return StopProgress::wait();  // the next round reads where it ended
    return order.at_once ? StopProgress::again() : watch_the_ramp();
  }
  if (stored_running_ && order.what != StopOrder::What::jog)
    return order.at_once ? StopProgress::again() : watch_the_program();
  return StopProgress::stands();
}

// Held before a command, or nothing has turned since D: what moves slower than a step in that time has no
// ramp to speak of.
StopProgress VxmDriver::watch_the_program() {
  if (!ramp_) return StopProgress::again();
  if (draft_.program.run == RunState::held || stands_since_ramp()) {
    ramp_->over = true;
    return StopProgress::again();  // which is K, now
  }
  const StopProgress progress = watch_the_ramp();
  if (!goes_on(progress)) return progress;
  ramp_->holds = ramp_->reversed = false;
  ramp_->from = ramp_->slowest = sight_.fastest();
  return StopProgress::again();
}

// Where no hold is known to be on, anything that begins shows that none is, and so does a D without effect;
// unless all seem to stand, as one does that holds.
bool VxmDriver::goes_on(const StopProgress& progress) {
  if (hold_.is_surely_on()) return ramp_->reversed || has_begun_anew();
  if (hold_.something_has_begun()) return true;
  const bool stands_as_held = hold_.is_on() && sight_.fastest() <= 0;
  return !hold_.is_known() && !stands_as_held && progress.now == StopProgress::Now::again;
}

// It has slowed down and turns faster again: that is the next command, so no hold is on.
bool VxmDriver::has_begun_anew() {
  constexpr double for_sure = 500;  // steps/s; twice what two readings that follow each other leave open
  if (sight_.fastest() > ramp_->from) ramp_->from = ramp_->slowest = sight_.fastest();
  ramp_->slowest = std::min(ramp_->slowest, sight_.fastest());
  return ramp_->slowest < ramp_->from - for_sure && sight_.fastest() > ramp_->slowest + for_sure;
}

// D is not answered. One that did not get through shows by motors that lose no speed; what still turns after
// the longest ramp is killed.
StopProgress VxmDriver::watch_the_ramp() {
  constexpr double least_loss = min_accel * accel_unit * seconds(to_see_a_ramp) / 2;
  const Instant now = scheduler_.now();
  if (!ramp_) return StopProgress::again();
  if (now - ramp_->began > longest_ramp + to_see_a_ramp) return StopProgress::at_once();
  ramp_->speed = std::max(ramp_->speed, sight_.fastest());  // it may not have been seen before
  if (now - ramp_->looked_at < to_see_a_ramp) return StopProgress::wait();
  const double before = std::exchange(ramp_->speed, sight_.fastest());
  ramp_->looked_at = now;
  return ramp_->speed > before - least_loss ? StopProgress::again() : StopProgress::wait();
}

bool VxmDriver::stands_since_ramp() const {
  const Instant now = scheduler_.now();
  const int motors = std::min(draft_.axis_count, motors_per_controller);
  for (int i = 0; i < motors; ++i)
    if (!sight_.has_stood_since(ramp_->began, i)) return false;
  return !some_are_hidden() || now - ramp_->began >= longest_ramp;
}

/// As far as the last readings show.
bool VxmDriver::seems_to_stand() const {
  const int motors = std::min(draft_.axis_count, motors_per_controller);
  for (int i = 0; i < motors; ++i) {
    if (!draft_.axes[i].position_known || !sight_.has_stood_since(draft_.program.started_at, i)) return false;
  }
  return !some_are_hidden();
}

/// Motors 3 and 4 cannot be read while something runs, nor whether there are any: that is known once the
/// controller has been at rest.
bool VxmDriver::some_are_hidden() const {
  return nameplate_.has_slave() || (!nameplate_.is_read() && draft_.axis_count > motors_per_controller);
}

// ---- K

Task<Result<>> VxmDriver::kill(bool standing, Priority priority) {
  const bool something_ran = busy() || halted_;
  auto reply = co_await talk_.kill(priority, kill_patience);
  if (!reply && reply.error().kind == FaultKind::stopped) co_return fail(reply.error());  // it was not sent
  killed_at_ = scheduler_.now();
  if (!standing) doubt_positions();
  if (!reply) {
    kill_not_confirmed(standing ? EndedBy::stop : EndedBy::abort);
    if (reply.error().kind == FaultKind::lost) co_return fail(reply.error());
    co_return fail(FaultKind::no_answer,
                   "K was sent to stop everything, but the controller did not confirm it.",
                   "Nothing else was sent.", "Watch the motors. If one still turns, use the power switch.");
  }
  killed(standing ? EndedBy::stop : EndedBy::abort);
  if (something_ran && draft_.outputs_known && draft_.outputs)
    console_.tell(Notice::Kind::info, "K ended the run; it has also switched the outputs off.");
  show_worst();
  if (console_.changed) console_.changed();
  co_return Result<>();
}

// What it has ended shows by the next V; whether it has ended the hold, by nothing.
void VxmDriver::kill_not_confirmed(EndedBy ended_by) {
  if (hold_.is_on()) hold_.doubt();
  if (job_.active() && !job_.leg_over) job_.ended_by = ended_by;
  if (stored_running_) draft_.program.ended_by = ended_by;
}

// An H more would switch a hold on that has ended. K ends it in either case, and is answered.
Task<Result<>> VxmDriver::settle_hold() {
  if (!hold_.is_doubtful()) co_return Result<>();
  auto settled = co_await kill(true, Priority::intent);
  if (settled || settled.error().kind != FaultKind::no_answer) co_return settled;
  co_return fail(
      FaultKind::no_answer,
      "Whether the hold (H) is on is not known, and the controller does not confirm the K that ends "
      "it.",
      "Nothing else was sent.", "Try again.");
}

// What K leaves: nothing runs, no hold, no error.
void VxmDriver::killed(EndedBy ended_by) {
  killed_at_ = scheduler_.now();
  halted_ = 0;
  hold_.ended();
  ramp_.reset();
  if (job_.active()) {
    job_.legs.resize(1);
    job_.jog = false;
    job_.ended_by = EndedBy::abort;
    job_.leg_over = true;
  }
  if (stored_running_) run_ended(ended_by);
  draft_.program.run = RunState::idle;
  for (int i = 0; i < draft_.axis_count; ++i)
    if (draft_.axes[i].activity == Activity::error) draft_.axes[i].activity = Activity::idle;
  news_.notify();
}

// K above 1000 steps/s may cost steps that the controller does not know of (p.23). An unknown speed counts as
// fast, and what was under way when the wire was lost as still turning.
void VxmDriver::doubt_positions() {
  const auto belongs_to_leg = [this](int i) {
    return job_.active() && (job_.legs.front().axis == i || job_.legs.front().second_axis == i);
  };
  for (int i = 0; i < draft_.axis_count; ++i) {
    AxisState& axis = draft_.axes[i];
    const bool turns = axis.activity == Activity::moving || axis.activity == Activity::jogging ||
                       axis.activity == Activity::homing || axis.activity == Activity::stopping;
    const bool hidden = stored_running_ && i >= motors_per_controller && nameplate_.has_slave();
    const bool unseen =
        axis.activity == Activity::unknown && lost_while_busy_ && (stored_running_ || belongs_to_leg(i));
    if ((!turns && !hidden && !unseen) || axis.trust.doubtful()) continue;
    const double told = axis.speed.value;
    const double speed = told > 0 ? told : stored_running_ && !hidden ? sight_.speed(i) : default_speed;
    if (speed <= hard_stop_safe_speed) continue;
    axis.trust.doubt(Doubt::killed, scheduler_.now());
    console_.tell(Notice::Kind::warning,
                  fmt::format("Motor {} was stopped without a ramp at about {:.0f} steps/s. "
                              "Above {} steps/s it may have lost steps: "
                              "its position is doubtful until it is homed or set to zero.",
                              i + 1, speed, hard_stop_safe_speed));
  }
}

// What runs has come to its end, by itself or by force.
void VxmDriver::run_ended(EndedBy ended_by) {
  if (job_.active()) {
    job_.ended_by = ended_by;
    job_.leg_over = true;
  }
  const bool was_running = std::exchange(stored_running_, false);
  if (!was_running) return;
  const bool untold = draft_.program.ended_by == EndedBy::nothing;
  if (ramp_ && ended_by == EndedBy::target && untold) ended_by = EndedBy::stop;  // its last index was cut
  if (ramp_ && hold_.is_on()) hold_.release_soon();  // that of its stop: it must not keep the next run
  ramp_.reset();
  hold_.nothing_runs_from_before();
  ProgramState& p = draft_.program;
  p.run = RunState::idle;
  if (p.ended_by == EndedBy::nothing || ended_by != EndedBy::target) p.ended_by = ended_by;
  if (ended_by == EndedBy::target) {
    ended_run_ = p.slot;
    draft_.working = true;  // until the switches have told what ended it
  }
  p.owned = false;
  p.stepping = false;
  p.command = -1;
  p.command_told = false;
  p.slot = static_cast<std::int8_t>(slots_.selected());
  for (int i = 0; i < draft_.axis_count; ++i) {
    AxisState& axis = draft_.axes[i];
    const bool turned = axis.activity != Activity::idle && axis.activity != Activity::unknown;
    if (turned && ended_by != EndedBy::target) axis.ended_by = ended_by;
    if (turned) axis.activity = Activity::idle;
    axis.direction = 0;
  }
}

}  // namespace hw::vxm
