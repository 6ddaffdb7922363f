#pragma once
// Through this interface the link doctor examines a port itself, apart from its controller. Another thread
// does the work.
#include <optional>
#include <string>

#include "core/time/clock.h"

namespace hw::gui {

struct ExaminedPort {
  std::string holder;                     ///< another program that has the port open
  std::optional<Duration> adapter_waits;  ///< the latency timer of a USB adapter
  std::string adapter_timer;              ///< file that sets the latency timer
  bool adapter_timer_can_be_set = false;
  std::string refused;  ///< why the timer was not set
};

class PortExaminer {
 public:
  virtual ~PortExaminer() = default;
  /// Examines the port; the console's wake() announces the findings. GUI thread.
  virtual void examine(const std::string& path) = 0;
  /// The findings; null: the port was not examined yet.
  virtual const ExaminedPort* find(const std::string& path) = 0;
  /// Sets the latency timer, then examines the port again.
  virtual void set_adapter_timer(const std::string& path, int milliseconds) = 0;
};

}  // namespace hw::gui
