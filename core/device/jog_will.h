#pragma once
// The last will of the held jogs of one controller: left with the watchdog before the first jog is sent, and
// taken back when every stop after them is over. Io thread.
#include "core/device/driver.h"

namespace hw {

class JogWill {
 public:
  explicit JogWill(Driver& driver) : driver_(driver) {}
  /// `held`: a bit per axis. `stops`: a stop of the controller is under way. `station`: null: no wire.
  void follow(unsigned held, bool stops, Station* station) {
    const unsigned wanted = held | (stops ? left_for_ : 0);
    if (wanted == left_for_ && (wanted == 0 || station)) return;
    left_for_ = station ? wanted : 0;
    will_ = left_for_ != 0 ? station->leave_will(driver_.last_will(left_for_)) : nullptr;
  }
  [[nodiscard]] bool may_be_carried_out() const { return will_ && will_->may_be_carried_out(); }

 private:
  Driver& driver_;
  unsigned left_for_ = 0;
  std::shared_ptr<WillKeeper::Will> will_;
};

}  // namespace hw
