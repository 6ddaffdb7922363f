#pragma once
// The display units of one controller's axes, kept so that a frame only refers to them.
#include <array>

#include "core/device/catalog.h"
#include "core/device/snapshot.h"
#include "core/session/profile.h"
#include "gui/model/units_format.h"

namespace hw::gui {

class AxisUnits {
 public:
  /// After a change of the profile.
  void work_out(const Catalog& catalog, const Profile& profile);
  /// Once a frame: an axis counts in other units with a closed loop than without.
  void follow_counting(const Catalog& catalog, const Snapshot& now);

  [[nodiscard]] const DisplayUnit& shown(AxisId axis) const { return units_[axis.index].shown; }
  /// For lengths and speeds: the same without the sign of an axis that counts against its steps.
  [[nodiscard]] const DisplayUnit& length(AxisId axis) const { return units_[axis.index].length; }
  /// The unit that the controller counts in, whatever is shown.
  [[nodiscard]] const DisplayUnit& counted(AxisId axis) const { return units_[axis.index].counted; }

 private:
  struct Units {
    DisplayUnit shown, length, counted;
    bool in_counts = false;  ///< when last followed
  };
  void name_counting(const Catalog& catalog);

  std::array<Units, max_axes> units_;
};

}  // namespace hw::gui
