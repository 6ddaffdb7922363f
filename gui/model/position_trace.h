#pragma once
// The actual positions of one controller's axes, as far as they were known. GUI thread.
#include <array>
#include <cstddef>
#include <deque>
#include <optional>

#include "core/device/snapshot.h"

namespace hw::gui {

class PositionTrace {
 public:
  struct Place {
    std::array<Steps, max_axes> position{};
    std::array<Instant, max_axes> counted_since{};  ///< AxisState::trust
    Instant at{};
    Instant until{};       ///< still there then
    bool goes_on = false;  ///< continues the place before: nothing was unknown in between
  };
  /// The places where an axis met its switches, in its present count: the first position on each when
  /// entering it. Cleared when the count is set anew, as the switches then have other positions.
  struct Met {
    std::optional<Steps> minus, plus;  ///< travel limits
    std::optional<Steps> home;         ///< its switch, or where the axis came to rest after homing
  };
  /// Once a frame: keeps a place where an axis has moved since the last one.
  void follow(const Snapshot& now);
  /// Oldest first. The oldest are dropped when the trace becomes long.
  [[nodiscard]] const std::deque<Place>& places() const { return places_; }
  /// How many places were kept since clear(), dropped ones included: places().back() is the last of them.
  [[nodiscard]] std::uint64_t count() const { return count_; }
  /// Time of the first place since clear(), dropped or not.
  [[nodiscard]] Instant first_at() const { return first_at_; }
  /// Grows with clear().
  [[nodiscard]] std::uint64_t begun() const { return begun_; }
  void clear();
  [[nodiscard]] const Met& met(AxisId axis) const { return followed_[axis.index].met; }

 private:
  struct Followed {
    Met met;
    Instant counted_since{};
    bool in_counts = false, homing = false;
  };
  void meet(const AxisState& axis, Followed& followed);

  std::array<Followed, max_axes> followed_{};
  std::deque<Place> places_;
  std::uint64_t count_ = 0, begun_ = 0;
  Instant first_at_{};
  bool broken_ = true;
};

}  // namespace hw::gui
