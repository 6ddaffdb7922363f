#pragma once
// How something outside the core adds to what a script can do: the screen.
#include <memory>

#include "core/script/runner.h"

namespace hw::script {

class Stage {
 public:
  virtual ~Stage() = default;
  /// Adds a global table (`ui`) to the script's world.
  virtual void bind(lua_State* L) = 0;
  /// A controller or bus that the script has opened; the newest is the one that ids mean.
  virtual void opened(const std::shared_ptr<SessionGroup>& group) = 0;
  /// Every controller on the screen, those that hands have opened there included.
  [[nodiscard]] virtual std::vector<std::shared_ptr<Session>> controllers() const { return {}; }
  /// One frame, 60 a second of script time.
  virtual void frame(Instant now) = 0;
  /// The script has ended: nothing is held any more.
  virtual void script_over() = 0;
};

inline constexpr Duration frame_period{16'666'667};

}  // namespace hw::script
