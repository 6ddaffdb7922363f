#pragma once
// Records the positions of one-axis emulators on one wire, as if their axes belonged to one controller:
// periodically during motion, and whenever an axis begins or ends to move.
#include <memory>
#include <vector>

#include "core/device/track.h"
#include "core/session/wire.h"

namespace hw {

class TrackTogether {
 public:
  using Benches = std::vector<std::shared_ptr<BenchAccess>>;
  /// One axis per bench, in order; outputs are those of the bench at `with_tool`. Time is zero now.
  TrackTogether(Scheduler& scheduler, Benches benches, std::size_t with_tool);
  /// Call when something may have changed.
  void look();
  /// When motion last began with all axes at rest before, in seconds of the track; 0: never.
  [[nodiscard]] double moves_since() const { return moves_since_; }
  [[nodiscard]] std::vector<RehearsedPlace> take() { return track_.take(); }

 private:
  Scheduler& scheduler_;
  const Benches benches_;
  const std::size_t with_tool_;
  const Instant zero_;
  Track track_;
  std::uint32_t moving_ = 0;  ///< bit per axis, at the latest look()
  double moves_since_ = 0;
  Timer due_;
};

}  // namespace hw
