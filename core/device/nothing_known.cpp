#include "core/device/nothing_known.h"

namespace hw {

void nothing_is_known(Snapshot& known) {
  for (int i = 0; i < known.axis_count; ++i) {
    AxisState& axis = known.axes[i];
    if (known.axis_moves(i)) axis.ended_by = EndedBy::lost;
    axis.activity = Activity::unknown;
    axis.phase = Phase::unknown;
    axis.position_known = axis.limits_known = false;
    axis.direction = 0;
    axis.speed = Pps{};
    axis.ramp = 0;
  }
  for (ThreadState& thread : known.threads) thread.known = false;
  known.inputs_known = known.outputs_known = known.analog_known = 0;
  known.readouts_known.reset();
  known.variables_known.reset();
  known.queue_known = 0;
  known.window.known = known.window.rings_known = false;
}

void set_up_is_unknown(Snapshot& known) {
  for (ParamState& param : known.params) param = ParamState();
  known.unsaved_setup = false;
}

}  // namespace hw
