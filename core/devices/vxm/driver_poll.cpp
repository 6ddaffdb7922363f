// One round of status. While something moves: where it is and whether it still runs, as often as the wire
// bears; at rest everything, five times a second.
#include <cmath>

#include <fmt/core.h>

#include "core/devices/vxm/driver.h"

namespace hw::vxm {
namespace {

constexpr int io_every = 8;  // rounds in motion between two looks at one of the inputs and outputs
constexpr Duration io_at_least_every = Millis(250);  // where rounds are slow

}  // namespace

Task<Result<>> VxmDriver::poll(Round round) {
  if (!talk_.station()) co_return fail(FaultKind::lost, "There is no connection to the controller.");
  if (halted_) co_return co_await ask_whether_it_hears_again();
  Result<> polled;
  if (stay_local_)
    polled = co_await poll_local();
  else if (round == Round::stopping)
    polled = co_await see_whether_it_stands();
  else
    polled = co_await poll_on_line(round);
  signals_.forget_what_is_doubted();
  if (polled && !busy() && !talk_.echoes() && round != Round::stopping) look_what_ended_the_run();
  show_worst();
  if (!polled && halted_ && talk_.station()) {  // its error report came in place of an answer
    talk_.station()->count_answer(talk_.station()->statistics().last_round_trip, false, scheduler_.now());
    co_return Result<>();
  }
  co_return polled;
}

// As often as the wire bears: a round that took its time on the wire is followed by the next at once. Where
// bytes take no time (TCP, in process) two hundred rounds a second are enough.
Duration VxmDriver::moving_period() const {
  constexpr std::size_t bytes_of_a_round = 22;  // X, Y and V with their answers
  constexpr Duration without_wire = Millis(5);
  const Duration round = talk_.station() ? talk_.station()->wire_time(bytes_of_a_round) : Duration::zero();
  if (round == Duration::zero()) return without_wire;
  return std::max(Duration::zero(), round - (scheduler_.now() - round_began_));
}

// After its error report it answers nothing but K. What answers was switched off and on, or somebody else's K
// has reached it.
Task<Result<>> VxmDriver::ask_whether_it_hears_again() {
  if (scheduler_.now() < ask_again_at_) co_return Result<>();
  ask_again_at_ = scheduler_.now() + std::chrono::seconds(1);
  auto reply = co_await talk_.whether_it_hears();
  if (!reply) co_return reply.error().kind == FaultKind::lost ? fail(reply.error()) : Result<>();
  const auto state = decode_state(*reply);
  if (!state || !halted_) co_return Result<>();
  killed(EndedBy::error);
  co_return co_await take_state(*state);
}

Task<Result<>> VxmDriver::poll_on_line(Round round) {
  ++round_;
  round_began_ = scheduler_.now();
  if (talk_.echoes()) co_return co_await poll_echoing();
  auto settled = co_await settle();
  if (!settled) co_return settled;
  // V first: it is answered in every mode, so a restart shows before X is asked in vain.
  auto state = co_await talk_.state(Priority::poll);
  if (!state) co_return fail(state.error());
  auto taken = co_await take_state(*state);
  if (!taken || stay_local_ || talk_.echoes()) co_return taken;
  const bool is_turn = round_ % io_every == 0 || round_began_ - signals_.asked_at() >= io_at_least_every;
  const bool one_signal = busy() && round != Round::everything && is_turn;
  auto read = co_await read_positions(Priority::poll, !busy(), one_signal);
  if (!read) co_return read;
  if (busy() && round != Round::everything) co_return Result<>();
  if (busy()) co_return co_await signals_.read_all(Priority::poll);
  auto io = co_await signals_.read_all(Priority::poll);
  if (!io) co_return io;
  co_return co_await catch_up();
}

// Answers that no echo can be mistaken for; everything else waits for the next round without one.
Task<Result<>> VxmDriver::poll_echoing() {
  auto state = co_await talk_.state(Priority::poll);
  if (!state) co_return fail(state.error());
  auto taken = co_await take_state(*state);
  if (!taken || stay_local_) co_return taken;
  auto read = co_await read_positions(Priority::poll, !busy());
  if (!read) co_return read;
  co_return co_await end_echo(*state);
}

// While a stop is under way: whether anything runs, and where it is. What comes after that waits for the
// usual round.
Task<Result<>> VxmDriver::see_whether_it_stands() {
  round_began_ = scheduler_.now();
  auto state = co_await talk_.state(Priority::stop);
  if (!state) co_return fail(state.error());
  auto taken = co_await take_state(*state);
  if (!taken || stay_local_) co_return taken;
  if (job_.active() && job_.leg_over && !job_.has_more()) co_return co_await end_leg(Priority::stop);
  co_return co_await read_positions(Priority::stop, !busy());
}

// Q was sent on purpose: only V and D are answered now.
Task<Result<>> VxmDriver::poll_local() {
  auto state = co_await talk_.state(Priority::poll);
  if (!state) co_return fail(state.error());
  if (*state == ready || *state == vxm::busy) {
    stay_local_ = false;
    mode_ = Mode::on_line;
    co_return Result<>();
  }
  const int lines = nameplate_.has_slave() ? 4 : 2;
  auto reply =
      co_await talk_.places(ReplyShape::several_lines(static_cast<std::uint16_t>(lines)), Priority::poll);
  if (!reply) co_return fail(reply.error());
  const auto places = decode_digitized(*reply, max_motors);
  if (!places) co_return Result<>();
  for (int i = 0; i < draft_.axis_count && i < static_cast<int>(places->positions.size()); ++i) {
    AxisState& axis = draft_.axes[i];
    const auto before = axis.position;
    show_position(i, places->positions[static_cast<std::size_t>(i)]);
    const bool turns = *state == jog_moving && before != axis.position;
    axis.activity = turns ? Activity::jogging : Activity::idle;
    axis.direction = static_cast<std::int8_t>(!turns ? 0 : axis.position > before ? 1 : -1);
  }
  co_return Result<>();
}

// Z and T are answered at standstill only.
Task<Result<>> VxmDriver::read_positions(Priority priority, bool at_rest, bool and_a_signal) {
  for (int i = 0; i < draft_.axis_count; ++i) {
    if (i >= motors_per_controller && (!at_rest || !nameplate_.has_slave())) break;
    if (i == 1 && and_a_signal) {
      auto asked = co_await signals_.ask_next(priority);
      if (!asked) co_return asked;
    }
    auto position = co_await talk_.position(i + 1, priority);
    if (!position) co_return fail(position.error());
    show_position(i, *position);
  }
  if (and_a_signal) (void)signals_.confirm();
  co_return Result<>();
}

void VxmDriver::show_position(int index, Steps position) {
  AxisState& axis = draft_.axes[index];
  const Sight::Change change = sight_.saw(index, axis, position, talk_.asked_at());
  if (stored_running_ && (change.begun || change.reversed)) program_has_begun_a_way(change.reversed);
  if (stored_running_ && !job_.active()) {  // what a program moves shows by its positions only
    constexpr Duration seems_moving = Millis(150);
    const bool turns = sight_.has_turned_within(seems_moving, index);
    if (change.moved) axis.direction = static_cast<std::int8_t>(position > axis.position ? 1 : -1);
    if (!turns) axis.direction = 0;
    axis.activity = !turns ? Activity::idle : ramp_ ? Activity::stopping : Activity::moving;
  } else if (!job_.active() && axis.activity != Activity::error) {
    axis.activity = Activity::idle;
    axis.direction = 0;
  }
  axis.position = position;
  axis.position_known = true;
  axis.seen_at = talk_.asked_at();  // the answer may have come late
  signals_.forget_what_is_doubted();
}

// What is to be done next must not hide a restart that went unseen: what is asked to clean the line tells
// nobody.
Task<Result<>> VxmDriver::see_to_dirt() {
  if (mode_ != Mode::on_line || halted_ || !talk_.station() || !talk_.station()->is_dirty())
    co_return Result<>();
  auto state = co_await talk_.state(Priority::intent);
  if (!state) co_return fail(state.error());
  co_return co_await take_state(*state);
}

Task<Result<>> VxmDriver::take_state(char state) {
  if (state == jog_idle || state == jog_moving) {
    if (stay_local_) co_return Result<>();
    co_return co_await found_restarted("The controller has gone to Local mode");
  }
  mode_ = Mode::on_line;
  restart_counted_ = false;
  if (state == ready && reset_said_) co_return co_await found_reset_on_line();
  if (state == vxm::busy && !busy()) {
    show_running(-1);  // by the Run button, or from before this connection
  } else if (state == ready && job_.active()) {
    job_.leg_over = true;  // its prompt was lost, or comes in the next moment
    news_.notify();
  } else if (state == ready && stored_running_) {
    run_ended(EndedBy::target);
  } else if (state == ready && draft_.program.run != RunState::error) {
    // Whatever a stray message has said.
    if (draft_.program.run == RunState::held) hold_.doubt();
    draft_.program.run = RunState::idle;
  }
  co_return Result<>();
}

// What could not be read while a program ran, or has become uncertain since.
Task<Result<>> VxmDriver::catch_up() {
  if (!nameplate_.is_read()) {
    auto read = co_await nameplate_.read();
    if (!read) co_return read;
  }
  if (!parameters_.knows_essentials()) {
    auto read = co_await parameters_.read_essentials();
    if (!read) co_return read;
  }
  if (!slots_.knows_sizes()) {
    auto read = co_await slots_.read_sizes();
    if (!read) co_return read;
  }
  co_return co_await parameters_.read_some();
}

// Called each round: nothing here allocates while all is well.
void VxmDriver::show_worst() {
  if (halted_) {
    const ErrorWords words = explain_error(halted_);
    draft_.notice = words.what + " " + words.advice;
    return;
  }
  if (stay_local_) {
    draft_.notice =
        "The controller is in Local mode: its own buttons jog. The next command puts it on-line again.";
    return;
  }
  draft_.notice.clear();
  constexpr std::string_view types[] = {"M1M", "M2M", "M3M", "M4M"};
  constexpr std::string_view untold[] = {
      "Motor 1 is set to type 0, the factory value for the smallest motors. Choose the connected motor in "
      "Parameters, Motors, "
      "before the first move.",
      "Motor 2 is set to type 0, the factory value for the smallest motors. Choose the connected motor in "
      "Parameters, Motors, "
      "before the first move.",
      "Motor 3 is set to type 0, the factory value for the smallest motors. Choose the connected motor in "
      "Parameters, Motors, "
      "before the first move.",
      "Motor 4 is set to type 0, the factory value for the smallest motors. Choose the connected motor in "
      "Parameters, Motors, "
      "before the first move."};
  for (int i = 0; i < draft_.axis_count; ++i)
    if (parameters_.value(types[i]) == 0) {
      draft_.notice = untold[i];
      return;
    }
  if (nameplate_.has_slave() && draft_.axis_count <= motors_per_controller) draft_.notice = unused_slave;
}

}  // namespace hw::vxm
