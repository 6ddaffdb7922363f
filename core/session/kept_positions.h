#pragma once
// Rest positions of a controller's axes and their trust, kept for the next session under the key of its
// profile, in the state folder.
#include <chrono>
#include <string_view>
#include <vector>

#include "core/device/trust.h"
#include "core/session/user_files.h"

namespace hw {

/// One instant on both clocks: the session clock restarts with each session.
struct TwoClocks {
  Instant session{};
  std::chrono::system_clock::time_point day{};
};

class KeptPositions {
 public:
  explicit KeptPositions(UserFolders folders) : folders_(std::move(folders)) {}
  [[nodiscard]] bool enabled() const { return folders_.enabled; }
  /// By AxisId; empty: nothing is kept. A damaged file: a fault; the file is set aside.
  [[nodiscard]] Result<std::vector<KeptPosition>> load(std::string_view key, TwoClocks now) const;
  /// May block: for workers, and for the end of the program.
  Result<> save(std::string_view key, const std::vector<KeptPosition>& axes, TwoClocks now) const;

 private:
  [[nodiscard]] std::filesystem::path file_of(std::string_view key) const;
  UserFolders folders_;
};

}  // namespace hw
