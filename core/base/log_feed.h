#pragma once
// Log lines for a reader in this program (the console's list), beside stderr and the file.
#include <functional>
#include <string>

#include "core/base/log.h"
#include "core/base/ring.h"

namespace hw::log {

struct Line {
  std::string time;  ///< of day, local: "14:02:04.123"
  Level level = Level::debug;
  std::string subject;  ///< "driver.vxm"
  std::string sentence;
};

/// Collects all lines written during its lifetime, for one reader thread. When it is full, the newest lines
/// are dropped and counted; stderr and the file have them.
class Feed {
 public:
  /// `wake`: any thread, behind each line; it must not log. May be null.
  explicit Feed(std::function<void()> wake);
  ~Feed();
  Feed(const Feed&) = delete;
  Feed& operator=(const Feed&) = delete;

  Ring<Line> lines;

 private:
  friend struct Desk;
  std::function<void()> wake_;
};

}  // namespace hw::log
