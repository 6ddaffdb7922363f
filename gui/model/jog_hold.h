#pragma once
// The hand on a jog control, as rules over time and edges, so that a jog can never outlive it:
//   - let go before 250 ms: exactly one step of the chosen length;
//   - still held at 250 ms: a continuous jog, kept alive at least every 100 ms, stopped by letting go;
//   - whatever else takes the hand away (focus loss, tab switch, a control that is no longer drawn, a frame
//   that
//     came too late, a closing window, a refusal) ends it, without a step;
//   - one thing is held at a time. Another press ends the first as a release would, and counts itself. What
//   was
//     ended so never comes back by itself: it must be let go and pressed anew.
// The pump has its own dead-man on the io thread; this class is the one on the side of the hand.
#include <cstdint>
#include <functional>
#include <optional>

#include "core/base/units.h"
#include "core/device/intent.h"

namespace hw::gui {

class JogHold {
 public:
  using Send = std::function<IntentId(IntentBody)>;
  /// Which hand: several may press the same control; each lets go of its own press only.
  enum class Hand : std::uint8_t { mouse, keyboard, gamepad };
  struct Control {
    Hand hand = Hand::mouse;
    AxisId axis;
    Sign sign = Sign::plus;
    bool operator==(const Control&) const = default;
  };
  struct Want {
    Steps step;  ///< one tap, always positive; 0: a tap moves nothing
    Pps speed;   ///< while held; 0: the controller's own
  };

  explicit JogHold(Send send) : send_(std::move(send)) {}

  /// Times are seconds on the clock of the frames, those of the hand and not of the frame that noticed it.
  void press(const Control& control, const Want& want, double at_s);
  void release(const Control& control, double at_s);
  /// Takes the hand away: a jog is stopped, a tap that has not ended yet is forgotten.
  void let_go();
  /// The same for what this hand holds.
  void take_away(Hand hand) {
    if (held_ && held_->control.hand == hand) let_go();
  }
  /// As let_go(), when a Stop has gone out already (a second one would mean "at once, without ramp").
  void forget() { held_.reset(); }
  /// Once a frame while its control is drawn (its key is known) and pressed. A hold that a frame does not
  /// confirm is let go.
  void confirm(const Control& control);
  /// Once a frame, after the panels: starts the jog when it is time, keeps it alive.
  void tick(double now_s);

  [[nodiscard]] bool holding() const { return held_.has_value(); }
  [[nodiscard]] bool jogging() const { return held_ && held_->jogging; }
  [[nodiscard]] std::optional<Control> control() const;
  /// The continuous jog that was started last; 0: none. Its refusal must end the hold: see let_go().
  [[nodiscard]] IntentId jog_intent() const { return held_ ? held_->intent : 0; }
  /// When the next tick() has something to do, in seconds from `now_s`.
  [[nodiscard]] double due_in_s(double now_s) const;

  static constexpr double continuous_after_s = 0.250;
  static constexpr double keep_alive_every_s = 0.100;
  static constexpr double frozen_after_s =
      0.250;  ///< no frame for so long: the hand is not believed any more

 private:
  struct Held {
    Control control;
    Want want;
    double pressed_at_s = 0, seen_at_s = 0, kept_alive_at_s = 0;
    bool jogging = false, confirmed = true;
    IntentId intent = 0;
  };
  void end(bool with_step);

  Send send_;
  std::optional<Held> held_;
};

}  // namespace hw::gui
