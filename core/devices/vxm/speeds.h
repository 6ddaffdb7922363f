#pragma once
// S of each motor, which lasts beyond a run and cannot be read: what the user's commands set, and whether
// that of a move of the console may be in force instead.
#include <array>
#include <optional>

#include "core/base/index.h"
#include "core/devices/vxm/facts.h"

namespace hw::vxm {

class Speeds {
 public:
  /// What the user's last S said, or the power-up value if none was seen.
  [[nodiscard]] int usual(int axis) const { return known_[ix(axis)].value_or(default_speed); }
  /// 0: not known.
  [[nodiscard]] int known(int axis) const { return known_[ix(axis)].value_or(0); }
  void was_set(int motor, int speed) {
    if (motor >= 1 && motor <= max_motors) known_[ix(motor - 1)] = speed;
  }
  [[nodiscard]] bool is_ours(int axis) const { return ours_[ix(axis)]; }
  void borrow(int axis) { ours_[ix(axis)] = true; }
  void give_back(int axis) { ours_[ix(axis)] = false; }
  void give_all_back() { ours_.fill(false); }
  /// The controller has restarted.
  void forget() {
    known_.fill(default_speed);
    ours_.fill(false);
  }

 private:
  std::array<std::optional<int>, max_motors> known_;
  std::array<bool, max_motors> ours_{};
};

}  // namespace hw::vxm
