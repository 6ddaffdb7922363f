#pragma once
// Interface by which code outside the core, the screen, extends a script's environment.
#include <memory>

#include "core/script/runner.h"

namespace hw::script {

class Stage {
 public:
  virtual ~Stage() = default;
  /// Adds a global table (`ui`) to the script's world.
  virtual void bind(lua_State* L) = 0;
  /// The script has opened a controller or bus; ids refer to the newest.
  virtual void opened(const std::shared_ptr<SessionGroup>& group) = 0;
  /// Every controller on the screen, including those opened by the user.
  [[nodiscard]] virtual std::vector<std::shared_ptr<Session>> controllers() const { return {}; }
  /// One frame, 60 a second of script time.
  virtual void frame(Instant now) = 0;
  /// The script has ended: release everything held.
  virtual void script_over() = 0;
};

inline constexpr Duration frame_period{16'666'667};

}  // namespace hw::script
