// Connecting, losing the wire, and what remains after a power cycle.
#include <fmt/core.h>

#include "core/device/nothing_known.h"
#include "core/devices/arcus/driver.h"

namespace hw::arcus {

Task<Result<>> ArcusDriver::connect() {
  conversation_.forget_unexpected();
  const Instant began = console_.scheduler.now();
  known_.code.axis_moves();  // unseen
  auto found = co_await find();
  // A device is there, but a question or reply was lost or garbled: tries once more, since a real fault
  // persists.
  const bool received = conversation_.is_open() && conversation_.station()->received_at() > began;
  const bool soon = console_.scheduler.now() - began < Finding::long_asked;
  if (!found && received && soon &&
      (worth_another_try(found.error()) || found.error().kind == FaultKind::refused)) {
    co_await conversation_.wait_for_quiet();
    conversation_.forget_unexpected();
    found = co_await find();
  }
  if (!found) co_return found;
  auto looked = co_await silence_.look_back_over_the_loss();
  if (!looked) co_return looked;
  co_return Result<>();
}

Task<Result<>> ArcusDriver::find() {
  auto identified = co_await finding_.identify();
  if (!identified) co_return identified;
  auto named = co_await finding_.read_name();
  if (!named) co_return named;
  co_return co_await read_state();
}

Task<Result<>> ArcusDriver::read_state() {
  auto motion = co_await known_.status.read_whole(Priority::intent);
  if (!motion) co_return motion;
  auto io = co_await known_.lines.read(Priority::intent);
  if (!io) co_return io;
  auto mode = co_await known_.readouts.read_mode(Priority::intent);
  if (!mode && mode.error().kind != FaultKind::refused) co_return mode;
  co_return co_await known_.threads.read(true, Priority::intent);
}

void ArcusDriver::restarted(std::string_view how_it_shows, unsigned moved) {
  ++console_.snapshot.restarts;
  known_.setup.restarted();
  for (ThreadState& t : console_.snapshot.threads) t = ThreadState();
  console_.snapshot.variables_known.reset();
  console_.snapshot.readouts_known.reset();
  known_.borrowed.forget();
  work_.guard.forget();
  known_.code.restarted();
  if (known_.code.program_may_run()) console_.snapshot.program.ended_by = EndedBy::lost;
  known_.list.end();
  known_.watch.forget();
  known_.motions.restarted(moved);
  console_.report(
      Notice::Kind::warning,
      fmt::format(
          "{}: the controller was switched off and on, or another program did this. Unstored settings and "
          "programs are lost; the set-up is read again. Home the axes before the next absolute move.",
          how_it_shows));
}

void ArcusDriver::wire_lost() {
  if (!conversation_.is_open()) return;
  conversation_.wire_lost();
  finding_.wire_lost();
  known_.borrowed.leave_alone();
  work_.guard.forget();
  known_.list.end();
  known_.motions.wire_lost();
  known_.code.lines().forget();
  nothing_is_known(console_.snapshot);  // keeps thread states: those that ran are stopped first
  for (int i = 0; i < console_.axes(); ++i) console_.snapshot.axes[i].own_speed = Pps{};
}

}  // namespace hw::arcus
