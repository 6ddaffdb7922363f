#pragma once
// The bytes that must reach a controller when this program can no longer send them: left with the watchdog
// process before a held jog begins, taken back when the jog has ended, sent when this program has died or is
// silent. Io thread only.
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "core/link/window.h"
#include "core/time/scheduler.h"

namespace hw {

struct WillStep {
  Millis after{};                  ///< sent this long after a missed sign of life
  std::string bytes{};             ///< bytes for a stream
  std::vector<BusCycle> cycles{};  ///< cycles for a window
};
using LastWill = std::vector<WillStep>;

class WillKeeper {
 public:
  /// A will is taken back by destroying it.
  class Will {
   public:
    virtual ~Will() = default;
    /// This program was silent for so long that the will may have been carried out: everything must be read
    /// again before anything is sent.
    [[nodiscard]] virtual bool may_be_carried_out() const = 0;
  };
  virtual ~WillKeeper() = default;
  /// Null: no watchdog runs.
  virtual std::shared_ptr<Will> leave(Scheduler& scheduler, const WireShare& wire, const LastWill& will) = 0;
  [[nodiscard]] virtual bool is_there() const = 0;
};

}  // namespace hw
