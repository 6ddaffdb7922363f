#pragma once
// Keeps the positions of one controller's axes, and their trust, for the next session; restores those of the
// last session as soon as the controller reports its counts. GUI thread.
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

  /// Starts keeping. A fault: the data of the last session was damaged, and is forgotten.
  Result<> keep_under(KeptPositions store, std::string key, Instant clock);
  /// Once a frame. A value unchanged for a second is written, by the worker.
  void follow(const Snapshot& now, Instant clock, const Send& send, Worker& worker);
  /// Before the controller is closed.
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
  std::vector<KeptPosition> recalled_;  ///< from the last session, until the controller is connected
  Axes noted_{}, saved_{};
  int axes_ = 0;
  Instant changed_at_{};
  std::shared_ptr<int> alive_ = std::make_shared<int>(0);
};

}  // namespace hw::gui
