#pragma once
// S and A of each motor, which outlast a run and cannot be read: the values set by the user's commands, and
// whether that of a move of the console may be in force instead.
#include <array>
#include <optional>

#include "core/base/index.h"
#include "core/devices/vxm/codec_text.h"
#include "core/devices/vxm/facts.h"

namespace hw::vxm {

/// S or A of all motors.
class LastSent {
 public:
  explicit LastSent(int after_power_up) : after_power_up_(after_power_up) {}

  /// Value of the user's last command, or the power-up value if none was seen.
  [[nodiscard]] int usual(int axis) const { return known_[ix(axis)].value_or(after_power_up_); }
  /// 0: not known.
  [[nodiscard]] int known(int axis) const { return known_[ix(axis)].value_or(0); }
  void was_set(int motor, int value) {
    if (motor >= 1 && motor <= max_motors) known_[ix(motor - 1)] = value;
  }
  [[nodiscard]] bool is_ours(int axis) const { return ours_[ix(axis)]; }
  void borrow(int axis) { ours_[ix(axis)] = true; }
  void give_back(int axis) { ours_[ix(axis)] = false; }
  void give_all_back() { ours_.fill(false); }
  /// The controller has restarted.
  void forget() {
    known_.fill(after_power_up_);
    ours_.fill(false);
  }

 private:
  int after_power_up_;
  std::array<std::optional<int>, max_motors> known_;
  std::array<bool, max_motors> ours_{};
};

struct Speeds {
  LastSent speed{default_speed}, acceleration{default_accel};

  void note(const TextCommand& c) {
    if (c.verb == Verb::speed) speed.was_set(c.motor, static_cast<int>(c.value));
    if (c.verb == Verb::acceleration) acceleration.was_set(c.motor, static_cast<int>(c.value));
  }
  void forget() { speed.forget(), acceleration.forget(); }
};

/// Of one leg; 0: as set in the controller.
struct LegPace {
  int speed = 0, acceleration = 0;
  bool operator==(const LegPace&) const = default;
};

}  // namespace hw::vxm
