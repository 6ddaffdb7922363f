#pragma once
// Notices when the count of an axis is set from elsewhere: by another program on the wire, or by a person at
// the controller. Looks for a count that no motion could have reached in the time (CountTrack). A count that
// was set within the reach of a motion looks like that motion and is not noticed.
//
// Ignores an axis that homes, or stops from homing; whose motor is free; or whose position is unknown or not
// trusted anyway. Ignores all axes while a program, a list or a drawing runs, and for three readings after a
// command that moves or may set a count, a restart or a missing answer.
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

  /// A command is sent that may set a count or move: the next readings are accepted.
  void disturbed() { tracks_ = {}; }
  /// To be called after each whole status round. A bit for each axis whose count was set, reported once.
  [[nodiscard]] std::uint32_t look(const Snapshot& now);

 private:
  struct Epoch {
    std::uint32_t restarts = 0;
    std::uint64_t timeouts = 0;
    bool operator==(const Epoch&) const = default;
  };
  struct Track {
    CountTrack readings;
    bool in_counts = false;
  };
  [[nodiscard]] CountReading reading_of(const AxisState& axis) const;
  void look_for_homing(const Snapshot& now);

  const Catalog& catalog_;
  std::array<Track, max_axes> tracks_{};
  std::uint32_t homing_ = 0;  ///< a bit for each axis that homes, or stops from homing
  Epoch epoch_;
};

/// "The count of axis X was changed ..."
[[nodiscard]] std::string describe_count_was_set(const Catalog& catalog, int axis);

}  // namespace hw
