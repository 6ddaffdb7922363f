#pragma once
// The user's settings for one controller, and the data that follow from them: the display units, and the
// travel limits and backlash that the session was given. GUI thread.
#include <array>
#include <functional>
#include <string>
#include <string_view>

#include "core/device/intent.h"
#include "core/device/refusals.h"
#include "core/session/profile.h"
#include "gui/model/axis_units.h"

namespace hw::gui {

class UserSettings {
 public:
  using Send = std::function<IntentId(IntentBody)>;

  /// `catalog` must outlive this object. `send` reports refusals to the user.
  UserSettings(const Catalog& catalog, std::string key, Send send);

  Profile profile;           ///< call edited() after each change
  std::string default_name;  ///< until the user chooses a name
  std::string key;           ///< under which the profile is saved
  bool changed = false;      ///< to be saved

  /// After a change of the profile: works out the units, and sends changed limits and backlash.
  void edited();
  /// Once a frame.
  void follow(const Snapshot& now) { units_.follow_counting(catalog_, now); }

  [[nodiscard]] std::string_view name() const;
  [[nodiscard]] const AxisUnits& units() const { return units_; }
  [[nodiscard]] const DisplayUnit& unit(AxisId axis) const { return units_.shown(axis); }
  /// Formats a position of an axis in the displayed unit.
  [[nodiscard]] PlaceWords place_words() const;

  /// Speed of held jogs of this axis: its own choice, else that for all axes; 0: the controller's own.
  [[nodiscard]] Pps jog_speed(AxisId axis) const;
  /// For this axis; 0: as for all.
  void choose_jog_speed(AxisId axis, Pps speed);

 private:
  void send_limits();

  const Catalog& catalog_;
  Send send_;
  AxisUnits units_;
  /// Last sent to the session.
  struct Sent {
    std::array<Travel, max_axes> travel;
    std::array<Backlash, max_axes> backlash;
  };
  Sent sent_;
};

}  // namespace hw::gui
