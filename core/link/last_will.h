#pragma once
// What must reach a controller when this program can no longer say it: left with another process before a
// held jog begins, taken back when the jog has ended, carried out when this program has died or is silent.
// Io thread only.
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "core/link/window.h"
#include "core/time/scheduler.h"

namespace hw {

struct LastWords {
  Millis after{};                  ///< this program's last sign of life was missed
  std::string bytes{};             ///< on a stream
  std::vector<BusCycle> cycles{};  ///< on a window
};
using LastWill = std::vector<LastWords>;

class WillKeeper {
 public:
  /// Destroyed: taken back.
  class Will {
   public:
    virtual ~Will() = default;
    /// This program was silent for so long that it may have been carried out: nothing may be said on the wire
    /// before everything is read afresh.
    [[nodiscard]] virtual bool may_be_carried_out() const = 0;
  };
  virtual ~WillKeeper() = default;
  /// Null: nobody is there who would carry it out.
  virtual std::shared_ptr<Will> leave(Scheduler& scheduler, const WireShare& wire, const LastWill& will) = 0;
  [[nodiscard]] virtual bool is_there() const = 0;
};

}  // namespace hw
