#pragma once
// What the user calls a controller and how he likes to see it. Kept by what the controller is known by: the
// serial number of its USB adapter, else the path of the port, else the address.
#include <array>
#include <string>

#include "core/base/units.h"
#include "core/session/address.h"
#include "core/session/user_files.h"

namespace hw {

struct AxisProfile {
  std::string name;         ///< the user's: "across"; empty: none
  std::string unit_choice;  ///< UnitChoice::label; empty: the controller's own steps
  bool reversed = false;    ///< real units count against the steps
  bool operator==(const AxisProfile&) const = default;
};

struct Profile {
  std::string name;                        ///< of the controller: "VXM stage"; empty: the catalog's
  std::string bus_name;                    ///< of the bus that it is the first of; empty: what is on it
  std::string unit;                        ///< shown now: "steps", "mm"; empty: steps
  std::array<AxisProfile, max_axes> axes;  ///< by AxisId
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
