#pragma once
// What this computer knows of a port beside the controller behind it, as the link doctor sees it. Who looks
// stands behind this interface, on another thread.
#include <optional>
#include <string>

#include "core/time/clock.h"

namespace hw::gui {

struct ExaminedPort {
  std::string holder;                     ///< another program that has it open
  std::optional<Duration> adapter_waits;  ///< the latency timer of a USB adapter
  std::string adapter_timer;              ///< the file that sets it
  bool adapter_timer_can_be_set = false;
  std::string refused;  ///< why the timer was not set
};

class PortExaminer {
 public:
  virtual ~PortExaminer() = default;
  /// Looks at it; what was found is announced by the console's wake(). GUI thread.
  virtual void examine(const std::string& path) = 0;
  /// Null: it has not been looked at yet.
  virtual const ExaminedPort* find(const std::string& path) = 0;
  /// Then looks at it again.
  virtual void set_adapter_timer(const std::string& path, int milliseconds) = 0;
};

}  // namespace hw::gui
