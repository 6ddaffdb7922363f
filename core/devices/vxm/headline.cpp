#include "core/devices/vxm/headline.h"

#include "core/devices/vxm/codec.h"
#include "core/devices/vxm/facts.h"

namespace hw::vxm {

void Headline::show() const {
  Snapshot& snapshot = console_.snapshot;
  if (presence_.is_halted()) {
    const ErrorWords words = explain_error(presence_.error());
    snapshot.notice = words.what + " " + words.advice;
    return;
  }
  if (presence_.stays_local()) {
    snapshot.notice =
        "The controller is in Local mode: its own buttons jog. The next command puts it on-line again.";
    return;
  }
  snapshot.notice.clear();
  if (identification_.has_slave() && snapshot.axis_count <= motors_per_controller)
    snapshot.notice = unused_slave;
}

}  // namespace hw::vxm
