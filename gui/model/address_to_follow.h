#pragma once
// After a controller's name or rate was changed here: the address to reopen its tab at, and the user's
// settings to take along.
#include <optional>
#include <string>
#include <vector>

#include "core/session/address.h"
#include "core/session/profile.h"

namespace hw::gui {

class Tab;

/// The new address of all controllers on the tab's wire. None: the tab is open there already, or no single
/// address reaches them all.
std::optional<Address> address_to_follow(const Tab& tab);

/// The user's names, units and limits for the controllers of one tab, or of a whole bus.
class TabProfiles {
 public:
  explicit TabProfiles(Tab& tab);
  /// Applies them to the same controllers at their new address.
  void apply_to(Tab& tab) const;

 private:
  struct Of {
    std::string id;  ///< the controller's present one
    Profile profile;
  };
  std::vector<Of> all_;
};

}  // namespace hw::gui
