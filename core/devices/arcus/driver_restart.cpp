// Noticing that the controller was switched off and on, and what is left of it then, or behind a lost wire.

#include <fmt/core.h>

#include "core/base/index.h"
#include "core/devices/arcus/driver.h"

namespace hw::arcus {

RestartWatch::Ways ArcusDriver::ways_of_watch() {
  return {[this](int axis) { return motions_.now(axis); },
          [this](std::string_view how_it_shows, unsigned moved) { restarted(how_it_shows, moved); }};
}

void ArcusDriver::restarted(std::string_view how_it_shows, unsigned moved) {
  ++console_.draft.restarts;
  setup_.restarted();
  for (ThreadState& t : console_.draft.threads) t = ThreadState();
  console_.draft.variables_known.reset();
  console_.draft.readouts_known.reset();
  borrowed_.forget();
  code_.restarted();
  if (code_.program_may_run()) console_.draft.program.ended_by = EndedBy::lost;
  list_.end();
  watch_.forget();
  motions_.restarted(moved);
  console_.tell(
      Notice::Kind::warning,
      fmt::format(
          "{}: the controller was switched off and on, or another program did it. What was not stored is "
          "gone; it is read afresh. Find home before the next absolute move.",
          how_it_shows));
}

std::string ArcusDriver::leaves_behind() const {
  const std::string left = stored_.leaves_behind(), borrowed = borrowed_.leaves_behind();
  return left.empty() || borrowed.empty() ? left + borrowed : left + ' ' + borrowed;
}

void ArcusDriver::wire_lost() {
  if (!talk_.is_open()) return;
  talk_.wire_lost();
  lost_at_ = console_.scheduler.now();
  borrowed_.leave_alone();
  list_.end();
  motions_.wire_lost();
  console_.draft.transfer = TransferState();
  for (int i = 0; i < console_.axes(); ++i) {
    AxisState& axis = console_.draft.axes[i];
    if (console_.draft.axis_moves(i)) axis.ended_by = EndedBy::lost;
    axis.activity = Activity::unknown;
    axis.phase = Phase::unknown;
    axis.position_known = false;
    axis.limits_known = false;
    axis.direction = 0;
    axis.speed = axis.own_speed = Pps{};
  }
  for (ThreadState& t : console_.draft.threads) t.known = false;  // those that ran are stopped first
  console_.draft.inputs_known = console_.draft.outputs_known = console_.draft.analog_known = 0;
  console_.draft.readouts_known.reset();
  console_.draft.variables_known.reset();
}

}  // namespace hw::arcus
