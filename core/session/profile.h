#pragma once
// The user's name and display settings for a controller. Keyed by the serial number of its USB adapter, else
// the path of the port, else the address.
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

/// A unit that no catalog has.
struct OwnUnit {
  std::string name = "mm";
  double per_step = 0;  ///< units per step; 0: not set
  bool operator==(const OwnUnit&) const = default;
};
/// The AxisProfile::unit_choice for it.
inline constexpr std::string_view own_unit_choice = "own";

struct AxisProfile {
  std::string name;         ///< the user's: "across"; empty: none
  std::string unit_choice;  ///< UnitChoice::label, or own_unit_choice; empty: the controller's own steps
  OwnUnit own_unit;
  bool reversed = false;  ///< real units count opposite to steps
  Travel travel;          ///< allowed range
  Backlash backlash;
  Pps jog_speed{};  ///< of its held jog; 0: Profile::jog_speed
  bool operator==(const AxisProfile&) const = default;
};

struct Profile {
  std::string name;                        ///< of the controller: "VXM stage"; empty: the catalog's
  std::string bus_name;                    ///< of the bus it is first on; empty: named after its members
  std::string unit;                        ///< display unit: "steps", "mm"; empty: steps
  std::array<AxisProfile, max_axes> axes;  ///< by AxisId
  SavedPlaces places;                      ///< see find_place()
  Steps jog_step{1};                       ///< chosen step
  Pps jog_speed{};                         ///< of a held jog; 0: the catalog's
  bool operator==(const Profile&) const = default;
};

/// "usb-A10K2LQX", "/dev/ttyS0" or the canonical address. `usb_serial` empty: no USB adapter.
std::string profile_key(const Address& address, std::string_view usb_serial);

class ProfileStore {
 public:
  explicit ProfileStore(UserFolders folders) : folders_(std::move(folders)) {}
  /// Unknown key: a new profile. A damaged file: a fault; the file is set aside, continue with a new profile.
  [[nodiscard]] Result<Profile> load(std::string_view key) const;
  Result<> save(std::string_view key, const Profile& profile) const;

 private:
  [[nodiscard]] std::filesystem::path file_of(std::string_view key) const;
  UserFolders folders_;
};

}  // namespace hw
