#pragma once
// Keeps where the axes of one controller stand, and how far that is to be trusted, for the next session; and
// gives back what the last one has kept as soon as the controller tells what it counts. GUI thread.
#include <array>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "core/device/intent.h"
#include "core/device/snapshot.h"
#include "core/session/kept_positions.h"
#include "gui/model/worker.h"

namespace hw::gui {

class PositionMemory {
 public:
  using Send = std::function<IntentId(IntentBody)>;

  /// From now on. A fault: what the last session kept was damaged, and is forgotten.
  Result<> keep_under(KeptPositions store, std::string key, Instant clock);
  /// Once a frame. What stands for a second is written, by the worker.
  void follow(const Snapshot& now, Instant clock, const Send& send, Worker& worker);
  /// The controller is about to be closed.
  void keep_now(Instant clock, Worker& worker);
  /// Seconds until follow() wants a frame; negative: it does not.
  [[nodiscard]] double due_in(Instant clock) const;

 private:
  using Axes = std::array<KeptPosition, max_axes>;
  static constexpr Duration kept_after = Millis(1000);
  void recall(const Snapshot& now, const Send& send);
  void note(const Snapshot& now, Instant clock);

  KeptPositions store_{UserFolders::none()};
  std::string key_;
  std::vector<KeptPosition> recalled_;  ///< of the last session, until the controller is there
  Axes noted_{}, saved_{};
  int axes_ = 0;
  Instant changed_at_{};
  std::shared_ptr<int> alive_ = std::make_shared<int>(0);
};

}  // namespace hw::gui
