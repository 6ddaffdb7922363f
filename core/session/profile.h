#pragma once
// What the user calls a controller and how he likes to see it. Kept by what the controller is known by: the
// serial number of its USB adapter, else the path of the port, else the address.
#include <array>
#include <string>
#include <string_view>

#include "core/base/units.h"
#include "core/device/backlash.h"
#include "core/device/travel.h"
#include "core/session/address.h"
#include "core/session/saved_places.h"
#include "core/session/user_files.h"

namespace hw {

/// A conversion that no catalog has.
struct OwnUnit {
  std::string name = "mm";
  double per_step = 0;  ///< units per step; 0: not told yet
  bool operator==(const OwnUnit&) const = default;
};
/// AxisProfile::unit_choice that means it.
inline constexpr std::string_view own_unit_choice = "own";

struct AxisProfile {
  std::string name;         ///< the user's: "across"; empty: none
  std::string unit_choice;  ///< UnitChoice::label, or own_unit_choice; empty: the controller's own steps
  OwnUnit own_unit;
  bool reversed = false;  ///< real units count against the steps
  Travel travel;          ///< how far it is let go
  Backlash backlash;
  bool operator==(const AxisProfile&) const = default;
};

struct Profile {
  std::string name;                        ///< of the controller: "VXM stage"; empty: the catalog's
  std::string bus_name;                    ///< of the bus that it is the first of; empty: what is on it
  std::string unit;                        ///< shown now: "steps", "mm"; empty: steps
  std::array<AxisProfile, max_axes> axes;  ///< by AxisId
  SavedPlaces places;                      ///< see find_place()
  Steps jog_step{1};                       ///< chosen step
  Pps jog_speed{};                         ///< while held; 0: the catalog's
  bool operator==(const Profile&) const = default;
};

/// "usb-A10K2LQX", "/dev/ttyS0" or the canonical address. `usb_serial` empty: not a USB adapter.
std::string profile_key(const Address& address, std::string_view usb_serial);

class ProfileStore {
 public:
  explicit ProfileStore(UserFolders folders) : folders_(std::move(folders)) {}
  /// Unknown key: a new profile. A damaged file: a fault, the file is put aside; go on with a new profile.
  [[nodiscard]] Result<Profile> load(std::string_view key) const;
  Result<> save(std::string_view key, const Profile& profile) const;

 private:
  [[nodiscard]] std::filesystem::path file_of(std::string_view key) const;
  UserFolders folders_;
};

}  // namespace hw
