#pragma once
// Watches the motors slow down after D, which has no reply. For a program, also watches whether a motion
// begins despite the hold.
#include <optional>

#include "core/device/stop.h"
#include "core/devices/vxm/console.h"
#include "core/devices/vxm/hold.h"
#include "core/devices/vxm/identification.h"
#include "core/devices/vxm/motor_readings.h"

namespace hw::vxm {

class Ramp {
 public:
  Ramp(const Console& console, const Identification& identification, const MotorReadings& readings,
       Hold& hold)
      : console_(console), identification_(identification), readings_(readings), hold_(hold) {}

  [[nodiscard]] bool is_expected() const { return state_.has_value(); }
  void forget() { state_.reset(); }
  /// Watches the ramp from now on, at the longest until the first D must have worked.
  void expect();
  StopProgress watch();

  // ---- stop of a program
  /// Begins the stop, unless begun.
  void expect_of_program();
  /// Whether the program is held, as far as known, so that no motion should begin in it.
  [[nodiscard]] bool holds() const { return state_ && state_->holds; }
  void was_held();
  /// Another host may already hold it, and another H would release it. No motor is seen to turn; the next
  /// readings confirm that or not.
  [[nodiscard]] bool must_be_seen_first() const;
  /// The program is held, or its motors stand.
  [[nodiscard]] bool is_over() const { return state_ && state_->over; }
  /// A motor has reversed, at `since` at the earliest: the program is not held.
  void saw_one_turn_round(Instant since);
  StopProgress watch_program();

 private:
  struct State {
    Instant began{};
    double from = 0;  ///< steps/s, the highest seen
    bool holds = false;
    double slowest = from;  ///< steps/s, since then
    Instant looked_at{};
    double speed = 0;  ///< steps/s at `looked_at`, of the fastest visible motor
    bool over = false;
    bool reversed = false;  ///< a motor has reversed since
  };
  bool goes_on(const StopProgress& progress);
  bool has_begun_anew();
  [[nodiscard]] bool stands_since() const;
  [[nodiscard]] bool seems_to_stand() const;
  [[nodiscard]] bool some_are_hidden() const;

  const Console& console_;
  const Identification& identification_;
  const MotorReadings& readings_;
  Hold& hold_;
  std::optional<State> state_;
};

}  // namespace hw::vxm
