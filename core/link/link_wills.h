#pragma once
// The last wills that one wire has left with the watchdog, see last_will.h. Io thread only.
#include <memory>
#include <vector>

#include "core/link/last_will.h"
#include "core/link/wire_share.h"

namespace hw {

class LinkWills {
 public:
  /// `keeper` carries the wills out; null: no watchdog runs. `emulated`: the controller ends with this
  /// program. `reachable`: the watchdog can use the wire.
  void entrust_to(std::shared_ptr<WillKeeper> keeper, bool emulated, bool reachable);
  /// Null: no watchdog guards the jog.
  std::shared_ptr<WillKeeper::Will> leave(Scheduler& scheduler, const WireShare& wire, const LastWill& will);
  [[nodiscard]] JogEnds jog_ends() const;
  /// One of the wills that are left now may have been carried out.
  [[nodiscard]] bool may_be_carried_out();

 private:
  std::shared_ptr<WillKeeper> keeper_;
  bool emulated_here_ = false, reachable_ = false;
  std::vector<std::weak_ptr<WillKeeper::Will>> left_;
};

}  // namespace hw
