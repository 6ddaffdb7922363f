#pragma once
// Gives scripts the units that the console keeps for a controller's axes.
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>

#include "core/script/axis_units.h"
#include "core/session/profile.h"

namespace hw::app {

/// The length unit of an axis in a profile, whether it is shown now or not.
std::optional<script::AxisUnit> unit_of_profile(const Catalog& catalog, const Profile& profile, int axis);

/// Reads the profile of a controller when a script first asks for a unit. Writes nothing.
class KeptUnits {
 public:
  /// `complain` receives the fault of a damaged profile.
  KeptUnits(UserFolders folders, std::function<void(const Fault&)> complain)
      : store_(std::move(folders)), complain_(std::move(complain)) {}
  std::optional<script::AxisUnit> unit_of(const Session& session, int axis);

 private:
  ProfileStore store_;
  std::function<void(const Fault&)> complain_;
  /// By session, because its port may disappear or change owner while it is open.
  std::map<std::weak_ptr<const Session>, Profile, std::owner_less<>> read_;
};

/// Serial number of the USB adapter behind an address; empty: none.
std::string usb_serial_behind(const Address& address);

}  // namespace hw::app
