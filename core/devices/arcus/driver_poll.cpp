// One status round. While something moves: positions, as often as the wire allows; at rest everything, five
// times a second.
#include <algorithm>

#include <fmt/core.h>

#include "core/base/index.h"
#include "core/devices/arcus/driver.h"

namespace hw::arcus {
namespace {

constexpr int kept_every = 5;  // rounds at rest: about a second
constexpr int io_every = 4;    // rounds in motion per reading of inputs, outputs and threads

}  // namespace

Task<Result<>> ArcusDriver::poll(Round round) {
  if (!conversation_.is_open()) co_return conversation_.no_connection();
  if (round == Round::stopping) co_return co_await stops_.look();
  ++round_;
  const RestartWatch::Look look = known_.watch.begin_look();
  auto motion = co_await known_.status.read(Priority::poll);
  if (!motion) co_return motion;
  auto returned = co_await known_.borrowed.give_back();
  if (returned) returned = co_await work_.guard.let_go();
  if (!returned) co_return returned;
  auto fed = co_await work_.feed.go_on();
  if (!fed) co_return fed;
  const bool wanted = round == Round::everything, at_work = is_at_work();
  if (known_.lines.are_due() || wanted || known_.watch.in_doubt() || !at_work || round_ % io_every == 0) {
    auto io = co_await known_.lines.read(Priority::poll);
    if (!io) co_return io;
    auto threads = co_await known_.threads.read(false, Priority::poll);
    if (!threads) co_return threads;
    auto looked = co_await known_.watch.look_at_motors(look);
    if (!looked) co_return looked;
  }
  auto watched = co_await known_.readouts.read_watched();
  if (!watched) co_return watched;
  if (!at_work) {
    auto rest = co_await read_at_rest();
    if (!rest) co_return rest;
  }
  known_.setup.show_own_speeds();
  show_worst();
  co_return Result<>();
}

/// Between two acts of a drawing the next one waits only for the positions.
bool ArcusDriver::is_at_work() const {
  const PiecesState& pieces = console_.snapshot.pieces;
  return console_.snapshot.any_axis_moving() || (pieces.running && pieces.draws && !pieces.held);
}

// A few values each round: an unwatched readout, an analog input, some parameters.
Task<Result<>> ArcusDriver::read_at_rest() {
  auto read = co_await known_.readouts.read_in_turn();
  if (read && round_ % kept_every == 0) read = co_await known_.setup.read_next_volatile();
  if (read) read = co_await work_.guard.look();
  if (!read) co_return read;
  co_return co_await known_.setup.read_in_turn();
}

// As often as the wire allows; where bytes take no time (TCP, USB, in process) a hundred rounds a second.
Duration ArcusDriver::moving_period() const {
  constexpr std::size_t bytes_of_a_round = 60;
  constexpr Duration without_wire = Millis(10);
  const Duration round =
      conversation_.is_open() ? conversation_.station()->wire_time(bytes_of_a_round) : Duration::zero();
  if (round == Duration::zero()) return without_wire;
  return std::max(Duration::zero(), round - (console_.scheduler.now() - known_.status.round_began()));
}

namespace {

const char* axis_error_words(AxisError error) {
  switch (error) {
    case AxisError::limit_minus: return "hit its - limit";
    case AxisError::limit_plus: return "hit its + limit";
    case AxisError::limit: return "hit a limit";
    case AxisError::alarm: return "was stopped by its alarm";
    case AxisError::stalled: return "did not follow (stall)";
    case AxisError::too_far: return "is too far from its target";
    case AxisError::not_corrected: return "did not reach its target";
    case AxisError::none: break;
  }
  return "";
}

}  // namespace

// Called each round: nothing here allocates while all is well.
void ArcusDriver::show_worst() {
  console_.snapshot.notice.clear();
  for (int i = 0; i < console_.axes(); ++i) {
    const AxisError error = known_.motions.error_of(i);
    if (error == AxisError::none) continue;
    console_.snapshot.notice = fmt::format("Axis {} {}. Clear the errors before the next move.",
                                           console_.axis_name(i), axis_error_words(error));
    return;
  }
  for (int i = 0; i < console_.model().programs; ++i)
    if (console_.snapshot.threads[ix(i)].known && console_.snapshot.threads[ix(i)].run == RunState::error) {
      console_.snapshot.notice = Threads::error_sentence(i, console_.snapshot.threads[ix(i)].line);
      return;
    }
}

}  // namespace hw::arcus
