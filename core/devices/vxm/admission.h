#pragma once
// Whether a motion or a change may begin now, and the warnings before a motor moves.
#include <array>

#include "core/devices/vxm/console.h"
#include "core/devices/vxm/facts.h"
#include "core/devices/vxm/identification.h"
#include "core/devices/vxm/parameters.h"
#include "core/devices/vxm/presence.h"
#include "core/devices/vxm/under_way.h"

namespace hw::vxm {

class Admission {
 public:
  Admission(const Console& console, const Presence& presence, const Identification& identification,
            const Parameters& setup, const UnderWay& under_way)
      : console_(console),
        presence_(presence),
        identification_(identification),
        parameters_(setup),
        under_way_(under_way) {}

  [[nodiscard]] Result<> may_run() const;
  [[nodiscard]] Result<> may_move(int axis) const;
  /// Whether the set-up or the programs may be changed now.
  [[nodiscard]] Result<> may_change() const;
  /// Warns once per motor.
  void warn_of_motor_type(int axis);

 private:
  const Console& console_;
  const Presence& presence_;
  const Identification& identification_;
  const Parameters& parameters_;
  const UnderWay& under_way_;
  std::array<bool, max_motors> type_warned_{};
};

}  // namespace hw::vxm
