// Getting a controller to listen and finding out what it is; what is left after a restart or a lost wire.
#include <algorithm>

#include <fmt/core.h>

#include "core/devices/vxm/driver.h"
#include "core/devices/vxm/greeting.h"

namespace hw::vxm {
namespace {

constexpr std::uint16_t greeting_quiet_ms = 20;
constexpr std::uint16_t slow_greeting_quiet_ms = 45;  // bytes come up to 40 ms apart
constexpr int greetings = 4, silences_until_nobody = 2;
constexpr int attempts_to_end_echo = 4;

}  // namespace

Task<Result<>> VxmDriver::find_out_all() {
  auto greeted = co_await greet();
  if (!greeted) co_return greeted;
  connected_before_ = true;
  if (!busy() && !talk_.echoes()) {
    auto caught_up = co_await catch_up();
    if (!caught_up) co_return caught_up;
  }
  auto polled = co_await poll(Round::usual);
  if (polled || !worth_another_try(polled.error())) co_return polled;
  auto quiet = co_await talk_.wait_for_quiet();  // a status byte is asked once a round
  if (!quiet) co_return quiet;
  co_return co_await poll(Round::usual);
}

// V alone first: it moves nothing in any mode. A carriage return ends a command that somebody left half said,
// and what came of it, or of a line that was opened amid garbage, is let pass.
Task<Result<std::string>> VxmDriver::ask_who_listens() {
  std::string bytes;
  int silences = 0;
  for (int n = 0; n < greetings && silences < silences_until_nobody; ++n) {
    if (n > 0) {
      auto ended = co_await talk_.say_anyway("\r");
      if (!ended) co_return fail(ended.error());
      auto quiet = co_await talk_.wait_for_quiet();
      if (!quiet) co_return fail(quiet.error());
    }
    const auto quiet_ms = n > 0 ? slow_greeting_quiet_ms : greeting_quiet_ms;
    auto reply = co_await talk_.greet(quiet_ms);
    if (!reply && reply.error().kind != FaultKind::no_answer) co_return fail(reply.error());
    if (!reply) ++silences;
    if (reply) bytes = *reply;
    if (reply && read_greeting(bytes).is_a_vxm()) break;
  }
  co_return bytes;
}

Task<Result<>> VxmDriver::greet() {
  auto bytes = co_await ask_who_listens();
  if (!bytes) co_return fail(bytes.error());
  Greeting greeting = read_greeting(*bytes);
  const int rate = talk_.station() ? talk_.station()->rate() : 0;
  if (bytes->empty()) co_return nobody_greets(rate);
  if (!greeting.is_a_vxm()) co_return no_vxm_greets(*bytes, rate);
  // It may be the answer to a V before a restart, and F takes away the only sign of that.
  for (int n = 0; n < greetings && talk_.station() && talk_.station()->is_dirty(); ++n) {
    auto again = co_await talk_.greet(greeting_quiet_ms);
    if (!again && again.error().kind != FaultKind::no_answer) co_return fail(again.error());
    if (again && read_greeting(*again).is_a_vxm()) greeting = read_greeting(*again);
  }
  talk_.set_echoes(greeting.echo);
  if (greeting.state == jog_idle || greeting.state == jog_moving)
    co_return co_await found_local(greeting.state);
  if (halted_) killed(EndedBy::error);  // it hears again
  mode_ = Mode::on_line;
  restart_counted_ = false;
  // F: no echo, no carriage returns behind prompts, whoever asked for them.
  auto said = co_await talk_.say_anyway("F");
  if (!said) co_return said;
  auto state = co_await talk_.state(Priority::intent);
  if (!state) co_return fail(state.error());
  if (greeting.echo) {
    auto ended = co_await end_echo(*state);
    if (!ended) co_return ended;
  }
  auto resumed = co_await resume_after_loss(*state);
  if (resumed && std::exchange(left_local_, false) && connected_before_)
    co_return co_await found_left_local();
  co_return resumed;
}

// What was Local mode was left for the sake of a stop, before anybody could ask for the places.
Task<Result<>> VxmDriver::found_left_local() {
  const bool was_moving = draft_.any_axis_moving() || busy();
  forget_what_ran();
  auto read = co_await read_positions(Priority::intent, true);
  if (!read) co_return read;
  Digitized places;
  for (int i = 0; i < draft_.axis_count; ++i) places.positions.push_back(draft_.axes[i].position);
  count_restart("It answered from Local mode", was_moving, places);
  co_return Result<>();
}

// While a program runs F is dropped, and nothing tells an echo from a status byte: only the state and the
// positions are believed until F is taken.
Task<Result<>> VxmDriver::end_echo(char state) {
  if (state != ready) {
    if (!std::exchange(echo_told_, true))
      console_.tell(
          Notice::Kind::warning,
          "The controller echoes what it is sent, and does not end that while its program runs. Until then "
          "inputs, outputs and limits are not read, and it takes nothing but stops.");
    co_return Result<>();
  }
  for (int n = 0; n < attempts_to_end_echo && talk_.echoes(); ++n) {
    auto said = co_await talk_.say_anyway("F");
    if (!said) co_return said;
    auto quiet = co_await talk_.wait_for_quiet();
    if (!quiet) co_return quiet;
    auto reply = co_await talk_.greet(slow_greeting_quiet_ms);
    if (!reply && reply.error().kind != FaultKind::no_answer) co_return fail(reply.error());
    const Greeting greeting = reply ? read_greeting(*reply) : Greeting();
    if (greeting.is_a_vxm() && !greeting.echo) talk_.set_echoes(false);
    if (greeting.is_a_vxm() && greeting.state != ready) co_return Result<>();  // something was begun
  }
  if (talk_.echoes())
    co_return fail(FaultKind::garbled, "The controller echoes what it is sent although it was told F.", {},
                   "Look whether another program talks to it, or something on the way sends bytes back.");
  echo_told_ = false;
  console_.tell(Notice::Kind::info, "The controller echoed what it was sent. Echo has been switched off.");
  co_return Result<>();
}

// Somebody wants something of it: what it would answer could not be told from the echo.
Task<Result<>> VxmDriver::hear_without_echo() {
  if (!talk_.echoes()) co_return Result<>();
  auto state = co_await talk_.state(Priority::intent);
  if (!state) co_return fail(state.error());
  auto ended = co_await end_echo(*state);
  if (!ended || !talk_.echoes()) co_return ended;
  co_return fail(FaultKind::refused,
                 "The controller echoes what it is sent, and does not end that while its program runs.",
                 "Nothing was sent.", "Wait until the program ends, or stop it by the Stop button.");
}

// The first time Local mode is the usual state after power-up. Later it means that the controller was
// restarted.
Task<Result<>> VxmDriver::found_local(char state) {
  if (connected_before_ && !stay_local_) co_return co_await found_restarted("It answers from Local mode");
  stay_local_ = false;
  auto on_line = co_await go_on_line();
  if (!on_line) co_return on_line;
  console_.tell(Notice::Kind::info,
                state == jog_moving
                    ? "Somebody was jogging at the controller's buttons. It is on-line now: they are off."
                    : "The controller was in Local mode. It is on-line now: its jog buttons are off.");
  co_return Result<>();
}

Task<Result<>> VxmDriver::go_on_line() {
  for (const bool again : {false, true}) {
    auto said = co_await talk_.say_anyway("F");
    if (!said) co_return said;
    auto state = co_await talk_.state(Priority::intent);
    if (!state) co_return fail(state.error());
    if (*state == ready || *state == vxm::busy) break;
    if (again)
      co_return fail(
          FaultKind::controller,
          "The controller stays in Local mode although it was asked to go on-line (F).", {},
          "Let go of all buttons at its front panel; if its green lamp flashes, wait until it is steady.");
  }
  mode_ = Mode::on_line;
  restart_counted_ = false;
  co_return Result<>();
}

// Power off and on, or res: positions are zero wherever the motors stand, RAM holds what was stored last. It
// is counted before F takes away the only sign of it; the wire may fail in between.
Task<Result<>> VxmDriver::found_restarted(const char* why) {
  if (!restart_counted_) {
    const bool was_moving = draft_.any_axis_moving() || busy();
    forget_what_ran();
    auto reply = co_await talk_.places(ReplyShape::until_quiet(greeting_quiet_ms), Priority::intent);
    if (!reply && reply.error().kind != FaultKind::no_answer)
      co_return fail(reply.error());  // the next V finds it
    count_restart(why, was_moving, reply ? decode_digitized(*reply, max_motors) : std::nullopt);
  }
  mode_ = Mode::unknown;
  auto on_line = co_await go_on_line();
  if (!on_line) co_return on_line;
  co_return co_await read_positions(Priority::intent, true);
}

void VxmDriver::count_restart(const char* why, bool was_moving, const std::optional<Digitized>& places) {
  restart_counted_ = true;
  const bool zero = !places || std::all_of(places->positions.begin(), places->positions.end(),
                                           [](Steps place) { return place.value == 0; });
  ++draft_.restarts;
  stands_after_restart(zero ? Doubt::restarted : Doubt::none);
  if (!zero)
    return console_.tell(
        Notice::Kind::warning,
        fmt::format("{} although it was on-line. It is put on-line again; its positions are kept. "
                    "Nothing else was sent.",
                    why));
  forget_ram();
  console_.tell(
      Notice::Kind::warning,
      fmt::format(
          "{}: the controller was switched off and on, or reset. Its positions read zero where the motors "
          "stand now, and what was not stored is gone. {}Find home before the next absolute move.",
          why, was_moving ? "The motion that was under way was not taken up again. " : ""));
}

// A res that F followed in one go: nothing but that it was said tells of the restart.
Task<Result<>> VxmDriver::found_reset_on_line() {
  ++draft_.restarts;
  forget_what_ran();
  stands_after_restart(Doubt::reset);
  forget_ram();
  console_.tell(
      Notice::Kind::warning,
      "The controller was reset by res: its positions read zero where the motors stand now, and what was "
      "not stored is gone. Find home before the next absolute move.");
  co_return co_await read_positions(Priority::intent, true);
}

void VxmDriver::forget_what_ran() {
  lost_while_busy_ = reset_said_ = false;
  job_ = Job();
  stored_running_ = false;
  draft_.program.run = RunState::idle;
  draft_.program.owned = false;
  ramp_.reset();
}

/// What reads zero since then stands anywhere: Doubt::none where the positions were kept.
void VxmDriver::stands_after_restart(Doubt why) {
  for (int i = 0; i < draft_.axis_count; ++i) {
    AxisState& axis = draft_.axes[i];
    if (axis.activity != Activity::idle && axis.activity != Activity::unknown) axis.ended_by = EndedBy::lost;
    axis.activity = Activity::idle;
    axis.direction = 0;
    axis.has_target = false;
    if (why != Doubt::none) axis.trust.doubt(why, scheduler_.now());
  }
}

void VxmDriver::forget_ram() {
  hold_.ended();
  halted_ = 0;
  scratch_.forget();
  nameplate_.forget();
  parameters_.forget();
  slots_.forget();
  speeds_.forget();
  draft_.program.command = -1;
  draft_.program.stepping = false;
}

// After a lost wire the state is read afresh. What moved went on without us.
Task<Result<>> VxmDriver::resume_after_loss(char state) {
  if (state == ready && job_.active()) job_.leg_over = true, job_.ended_by = EndedBy::lost;
  if (state == vxm::busy && !job_.active()) {
    const bool others = !stored_running_;
    show_running(-1);
    if (others) hold_.found_running();
  }
  if (state == vxm::busy && job_.active()) show_leg(job_.legs.front());
  if (!std::exchange(lost_while_busy_, false)) co_return Result<>();
  co_return co_await read_positions(Priority::intent, state == ready);
}

void VxmDriver::wire_lost() {
  if (!talk_.station()) return;
  talk_.lost();
  lost_while_busy_ = lost_while_busy_ || busy();
  ended_run_.reset();
  draft_.working = false;
  ramp_.reset();
  hold_.wire_lost();
  if (job_.active() && job_.legs.size() > 1) job_.legs.erase(job_.legs.begin() + 1, job_.legs.end());
  job_.jog = false;  // nothing of ours begins by itself after this
  for (int i = 0; i < draft_.axis_count; ++i) {
    AxisState& axis = draft_.axes[i];
    if (axis.activity != Activity::idle && axis.activity != Activity::unknown) axis.ended_by = EndedBy::lost;
    axis.activity = Activity::unknown;
    axis.position_known = false;
    axis.limits_known = false;
    axis.direction = 0;
  }
  draft_.inputs_known = draft_.outputs_known = draft_.analog_known = 0;
  news_.notify();
}

}  // namespace hw::vxm
