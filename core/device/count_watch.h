#pragma once
// Notices where somebody else has set the count of an axis: another program on the wire, or a hand at the
// controller. It counts elsewhere now, and no motion could have brought it there in the time (CountTrack).
// What lies within a motion looks like one, and nobody can tell them apart.
//
// It does not look at an axis that searches its home or stops out of that, whose motor is free, or of which
// the position is not known or not trusted anyway; nor at any axis while a program, a list or a drawing runs,
// until three readings behind a command that moves or may set a count, and behind a restart or a missing
// answer.
#include <array>
#include <cstdint>
#include <string>

#include "core/device/catalog.h"
#include "core/device/count_track.h"
#include "core/device/snapshot.h"

namespace hw {

class CountWatch {
 public:
  explicit CountWatch(const Catalog& catalog) : catalog_(catalog) {}

  /// Something goes out that may set a count, or move: what is seen next is taken as it is.
  void disturbed() { tracks_ = {}; }
  /// After each whole round of status: a bit for each axis whose count somebody has set. It is told once.
  [[nodiscard]] std::uint32_t look(const Snapshot& now);

 private:
  struct World {
    std::uint32_t restarts = 0;
    std::uint64_t timeouts = 0;
    bool operator==(const World&) const = default;
  };
  struct Track {
    CountTrack readings;
    bool in_counts = false;
  };
  [[nodiscard]] CountReading reading_of(const AxisState& axis) const;
  void look_for_homing(const Snapshot& now);

  const Catalog& catalog_;
  std::array<Track, max_axes> tracks_{};
  std::uint32_t homing_ = 0;  ///< a bit for each axis that searches its home, or stops out of that
  World world_;
};

/// "The count of axis X was changed ..."
[[nodiscard]] std::string describe_count_was_set(const Catalog& catalog, int axis);

}  // namespace hw
