#include "core/device/nothing_known.h"

#include "core/device/axis_motion.h"

namespace hw {

void nothing_is_known(Snapshot& known) {
  for (int i = 0; i < known.axis_count; ++i) {
    AxisState& axis = known.axes[i];
    lose_motion(axis);
    axis.position_known = axis.limits_known = false;
    axis.speed = Pps{};
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
