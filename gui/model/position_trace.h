#pragma once
// Where the axes of one controller have really been, as far as their positions were known. GUI thread.
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
    Instant until{};       ///< it was still there
    bool goes_on = false;  ///< from the place before: nothing was unknown in between
  };
  /// Where an axis has met its switches, as its counter counts now: on the way in it stood there first. Gone
  /// when the count is set anew, for then they lie elsewhere.
  struct Met {
    std::optional<Steps> minus, plus;  ///< travel limits
    std::optional<Steps> home;         ///< its switch, or where it came to rest behind its homing
  };
  /// Once a frame: kept where an axis has moved since the last place.
  void follow(const Snapshot& now);
  /// Oldest first. The oldest go when it becomes long.
  [[nodiscard]] const std::deque<Place>& places() const { return places_; }
  /// How many have been kept since clear(), those that have gone included: places().back() is the last of
  /// them.
  [[nodiscard]] std::uint64_t count() const { return count_; }
  /// When the first of them was, whether it has gone or not.
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
