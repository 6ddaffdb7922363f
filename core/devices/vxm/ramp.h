#pragma once
// What D has told to slow down, as far as it shows: D is not answered. Of a program also, whether anything
// begins although it was told to hold.
#include <optional>

#include "core/device/stop.h"
#include "core/devices/vxm/console.h"
#include "core/devices/vxm/hold.h"
#include "core/devices/vxm/nameplate.h"
#include "core/devices/vxm/sight.h"

namespace hw::vxm {

class Ramp {
 public:
  Ramp(const Console& console, const Nameplate& nameplate, const Sight& sight, Hold& hold)
      : console_(console), nameplate_(nameplate), sight_(sight), hold_(hold) {}

  [[nodiscard]] bool is_expected() const { return state_.has_value(); }
  void forget() { state_.reset(); }
  /// It is looked at from now on, and at the longest until the first D must have worked.
  void expect();
  StopProgress watch();

  // ---- of a program
  /// Its stop begins, if none has.
  void expect_of_program();
  /// Nothing is to begin in it, as far as is known.
  [[nodiscard]] bool holds() const { return state_ && state_->holds; }
  void was_held();
  /// It may be held already, by somebody else: an H more would let it go on. Nothing is seen to turn; the
  /// next readings show whether that is so.
  [[nodiscard]] bool must_be_seen_first() const;
  /// What it was to stop stands.
  [[nodiscard]] bool is_over() const { return state_ && state_->over; }
  /// A motor goes the other way, since then at the earliest: what is held does not.
  void saw_one_turn_round(Instant since);
  StopProgress watch_program();

 private:
  struct State {
    Instant began{};
    double from = 0;  ///< steps/s, the most
    bool holds = false;
    double slowest = from;  ///< since then
    Instant looked_at{};
    double speed = 0;  ///< when it was looked at; of the fastest motor that can be seen
    bool over = false;
    bool reversed = false;  ///< a motor has turned round since
  };
  bool goes_on(const StopProgress& progress);
  bool has_begun_anew();
  [[nodiscard]] bool stands_since() const;
  [[nodiscard]] bool seems_to_stand() const;
  [[nodiscard]] bool some_are_hidden() const;

  const Console& console_;
  const Nameplate& nameplate_;
  const Sight& sight_;
  Hold& hold_;
  std::optional<State> state_;
};

}  // namespace hw::vxm
