// HM HR KM KR: run to the edge at which home acts, by the switch alone (HS) or where switch, index and
// quadrant meet (HE). If home acts already, it is found where the axis stands (decisions M40, M41).
#include "core/devices/vme58/emulator_motion.h"

namespace hw::vme58 {

bool Motion::home(int a, const HomeOrder& order) {
  bring_up_to_date();
  MotionAxis& x = axes_[ix(a)];
  if (x.off() || x.run >= 0) return false;
  x.homing = order;
  begin_endless(RunKind::home, a, order.way, settings(a).velocity);
  return true;
}

/// True: this is the home edge, and the run ramps down from it or is cut.
bool Motion::found_home(Run& r, int a) {
  MotionAxis& x = axes_[ix(a)];
  if (!x.homing) return false;
  if (!x.home_active() || (x.settings.home_needs_index && !x.index_active())) return false;
  const HomeOrder order = *x.homing;
  x.homing.reset();
  if (order.kill) {
    finish(r, End::cut);
    return true;
  }
  // The edge gets the position; a motor that trails its command keeps its error.
  const std::int64_t edge = x.has_motor ? x.encoder() : x.position;
  const std::int64_t by = order.position - edge;
  x.set_position(x.position + by);
  if (x.servo())
    x.zero += by;
  else
    x.set_encoder(x.expected(x.position));
  stop_run(r);
  return true;
}

}  // namespace hw::vme58
