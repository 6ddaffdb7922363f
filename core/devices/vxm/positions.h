#pragma once
// Reads and shows the positions, and the motions that they reveal.
#include "core/devices/vxm/console.h"
#include "core/devices/vxm/conversation.h"
#include "core/devices/vxm/hold.h"
#include "core/devices/vxm/nameplate.h"
#include "core/devices/vxm/ramp.h"
#include "core/devices/vxm/sight.h"
#include "core/devices/vxm/signals.h"
#include "core/devices/vxm/under_way.h"

namespace hw::vxm {

class Positions {
 public:
  Positions(const Console& console, Conversation& talk, const Nameplate& nameplate, Signals& signals,
            Sight& sight, Hold& hold, Ramp& ramp, const UnderWay& under_way)
      : console_(console),
        talk_(talk),
        nameplate_(nameplate),
        signals_(signals),
        sight_(sight),
        hold_(hold),
        ramp_(ramp),
        under_way_(under_way) {}

  /// Reads all readable positions: at rest, the Slave's too.
  Task<Result<>> read(Priority priority, bool at_rest, bool and_a_signal = false);
  /// Shows the position received last.
  void show(int axis, Steps position);
  /// N was sent.
  void are_zero();

 private:
  void program_has_begun_a_way(const Sight::Change& way);

  const Console& console_;
  Conversation& talk_;
  const Nameplate& nameplate_;
  Signals& signals_;
  Sight& sight_;
  Hold& hold_;
  Ramp& ramp_;
  const UnderWay& under_way_;
};

}  // namespace hw::vxm
