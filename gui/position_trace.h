#pragma once
// Where the axes of one controller have really been, as far as their positions were known. GUI thread.
#include <array>
#include <cstddef>
#include <deque>

#include "core/device/snapshot.h"

namespace hw::gui {

class PositionTrace {
 public:
  struct Place {
    std::array<Steps, max_axes> position{};
    std::array<Instant, max_axes> counted_since{};  ///< AxisState::trust
    Instant at{};
    bool goes_on = false;  ///< from the place before: nothing was unknown in between
  };
  /// Once a frame: kept where an axis has moved since the last place.
  void follow(const Snapshot& now);
  /// Oldest first. The oldest go when it becomes long.
  [[nodiscard]] const std::deque<Place>& places() const { return places_; }
  /// How many have been kept since clear(), those that have gone included: places().back() is the last of
  /// them.
  [[nodiscard]] std::uint64_t count() const { return count_; }
  /// Grows with clear().
  [[nodiscard]] std::uint64_t begun() const { return begun_; }
  void clear();

 private:
  std::deque<Place> places_;
  std::uint64_t count_ = 0, begun_ = 0;
  bool broken_ = true;
};

}  // namespace hw::gui
