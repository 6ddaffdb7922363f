#pragma once
// Where emulators of one axis each on one wire are, as if their axes were of one controller: while something
// moves every so often, and whenever one begins or ends to move.
#include <memory>
#include <vector>

#include "core/device/track_keeper.h"
#include "core/session/wire.h"

namespace hw {

class TrackTogether {
 public:
  using Benches = std::vector<std::shared_ptr<BenchAccess>>;
  /// An axis for each bench, in their order; outputs are those of the bench at `with_tool`. Its time begins
  /// now.
  TrackTogether(Scheduler& scheduler, Benches benches, std::size_t with_tool);
  /// Something may have happened.
  void look();
  /// When the latest motion began before which all stood, as the track counts; 0: none has.
  [[nodiscard]] double moves_since() const { return moves_since_; }
  [[nodiscard]] std::vector<RehearsedPlace> take() { return track_.take(); }

 private:
  Scheduler& scheduler_;
  const Benches benches_;
  const std::size_t with_tool_;
  const Instant zero_;
  Track track_;
  std::uint32_t moving_ = 0;  ///< bit per axis, when it was looked at last
  double moves_since_ = 0;
  Timer due_;
};

}  // namespace hw
