#include "core/devices/vxm/status_rounds.h"

#include <algorithm>

#include "core/device/driver_faults.h"
#include "core/devices/vxm/codec.h"
#include "core/devices/vxm/facts.h"

namespace hw::vxm {
namespace {

constexpr int io_every = 8;  // rounds in motion between two readings of an input or output
constexpr Duration io_at_least_every = Millis(250);   // where rounds are slow
constexpr Duration io_in_a_stop_every = Millis(500);  // they must not become stale during a long ramp

}  // namespace

Task<Result<>> StatusRounds::poll(Round round) {
  if (!conversation_.station()) co_return not_connected("controller");
  if (presence_.is_halted()) co_return co_await status_.ask_again_while_silent();
  Result<> polled;
  if (presence_.stays_local())
    polled = co_await poll_local();
  else if (round == Round::stopping)
    polled = co_await see_whether_it_stands();
  else
    polled = co_await poll_on_line(round);
  signals_.forget_doubtful();
  if (polled && !under_way_.busy() && !conversation_.echoes() && round != Round::stopping)
    runs_.find_end_of_run();
  headline_.show();
  if (!polled && presence_.is_halted() &&
      conversation_.station()) {  // an error report came in place of the answer
    conversation_.station()->count_answer(conversation_.station()->statistics().last_round_trip, false,
                                          console_.scheduler.now());
    co_return Result<>();
  }
  co_return polled;
}

// As often as the wire allows: a round that took its wire time is followed by the next at once. Where bytes
// take no time (TCP, in process), two hundred rounds a second are enough.
Duration StatusRounds::moving_period() const {
  constexpr std::size_t bytes_of_a_round = 22;  // X, Y and V with their answers
  constexpr Duration without_wire = Millis(5);
  const Duration round =
      conversation_.station() ? conversation_.station()->wire_time(bytes_of_a_round) : Duration::zero();
  if (round == Duration::zero()) return without_wire;
  return std::max(Duration::zero(), round - (console_.scheduler.now() - round_began_));
}

Task<Result<>> StatusRounds::poll_on_line(Round round) {
  ++round_;
  round_began_ = console_.scheduler.now();
  if (conversation_.echoes()) co_return co_await poll_echoing();
  auto settled = co_await legs_.settle();
  if (!settled && settled.error().kind == FaultKind::no_answer && conversation_.station()) {
    // A restart has left it in Local mode, where V is the only question that is answered.
    const std::uint32_t restarts = console_.snapshot.restarts;
    const int misses = conversation_.station()->statistics().misses_in_a_row;
    auto mode = co_await conversation_.state(Priority::poll);
    if (!mode) co_return settled;
    auto found = co_await status_.take(*mode);
    if (console_.snapshot.restarts != restarts) co_return found;
    if (conversation_.station())
      conversation_.station()->resume_misses(misses);  // V does not show the position
  }
  if (!settled) co_return settled;
  // V first: it is answered in every mode, so it shows a restart before X would remain unanswered.
  auto state = co_await conversation_.state(Priority::poll);
  if (!state) co_return fail(state.error());
  auto taken = co_await status_.take(*state);
  if (!taken || presence_.stays_local() || conversation_.echoes()) co_return taken;
  auto inputs = co_await signals_.glance(Priority::poll);
  if (!inputs) co_return inputs;
  const bool is_turn = round_ % io_every == 0 || round_began_ - signals_.asked_at() >= io_at_least_every;
  const bool one_signal = under_way_.busy() && round != Round::everything && is_turn;
  auto read = co_await positions_.read(Priority::poll, !under_way_.busy(), one_signal);
  if (!read) co_return read;
  if (under_way_.busy() && round != Round::everything) co_return Result<>();
  if (under_way_.busy()) co_return co_await signals_.read_all(Priority::poll);
  auto io = co_await signals_.read_all(Priority::poll);
  if (io) io = co_await signals_.glance(Priority::poll);
  if (!io) co_return io;
  co_return co_await knowledge_.catch_up();
}

// Asks for replies that no echo can be mistaken for; the rest waits for the next round without echo.
Task<Result<>> StatusRounds::poll_echoing() {
  auto state = co_await conversation_.state(Priority::poll);
  if (!state) co_return fail(state.error());
  auto taken = co_await status_.take(*state);
  if (!taken || presence_.stays_local()) co_return taken;
  auto read = co_await positions_.read(Priority::poll, !under_way_.busy());
  if (!read) co_return read;
  co_return co_await echo_.end(*state);
}

// During a stop: reads whether anything runs, and the positions. The rest waits for the usual round, unless
// the stop is a long one.
Task<Result<>> StatusRounds::see_whether_it_stands() {
  round_began_ = console_.scheduler.now();
  auto state = co_await conversation_.state(Priority::stop);
  if (!state) co_return fail(state.error());
  auto taken = co_await status_.take(*state);
  if (!taken || presence_.stays_local()) co_return taken;
  if (under_way_.job().active() && under_way_.job().is_leg_over() && !under_way_.job().has_more())
    co_return co_await legs_.end_leg(Priority::stop);
  const bool one_signal = under_way_.busy() && round_began_ - signals_.asked_at() >= io_in_a_stop_every;
  co_return co_await positions_.read(Priority::stop, !under_way_.busy(), one_signal);
}

// Q was sent on purpose: only V and D are answered now.
Task<Result<>> StatusRounds::poll_local() {
  auto state = co_await conversation_.state(Priority::poll);
  if (!state) co_return fail(state.error());
  if (*state == ready || *state == vxm::busy) {
    presence_.was_sent_on_line();
    co_return Result<>();
  }
  const int lines = identification_.has_slave() ? 4 : 2;
  auto reply = co_await conversation_.places(ReplyShape::several_lines(static_cast<std::uint16_t>(lines)),
                                             Priority::poll);
  if (!reply) co_return fail(reply.error());
  const auto places = decode_digitized(*reply, max_motors);
  if (!places) co_return Result<>();
  for (int i = 0; i < console_.snapshot.axis_count && i < static_cast<int>(places->positions.size()); ++i) {
    AxisState& axis = console_.snapshot.axes[i];
    const auto before = axis.position;
    positions_.show(i, places->positions[static_cast<std::size_t>(i)]);
    const bool turns = *state == jog_moving && before != axis.position;
    axis.activity = turns ? Activity::jogging : Activity::idle;
    axis.direction = static_cast<std::int8_t>(!turns ? 0 : axis.position > before ? 1 : -1);
  }
  co_return Result<>();
}

}  // namespace hw::vxm
