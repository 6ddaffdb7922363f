#pragma once
// The rules for holding a jog control, over time and edges, so that a jog can never outlive the hold:
// - released before 250 ms: exactly one step of the chosen length;
// - still held at 250 ms: a continuous jog, kept alive at least every 100 ms, stopped by the release;
// - any other end (focus loss, tab switch, control not drawn, late frame, window closing, refusal): no step;
// - one hold at a time: another press ends the first like a release, and counts itself. An ended hold never
// resumes: release and press anew.
// The pump has its own dead-man on the io thread; this class is the one on the input side.
#include <cstdint>
#include <functional>
#include <optional>

#include "core/base/units.h"
#include "core/device/intent.h"

namespace hw::gui {

class JogHold {
 public:
  using Send = std::function<IntentId(IntentBody)>;
  /// The input device: several may press the same control; each releases only its own press.
  enum class Source : std::uint8_t { mouse, keyboard, gamepad };
  struct Control {
    Source source = Source::mouse;
    AxisId axis;
    Sign sign = Sign::plus;
    bool operator==(const Control&) const = default;
  };
  struct Want {
    Steps step;  ///< of one tap, always positive; 0: a tap moves nothing
    Pps speed;   ///< while held; 0: the controller's own
  };

  explicit JogHold(Send send) : send_(std::move(send)) {}

  /// Times are seconds on the clock of the frames, and those of the input, not of the frame that noticed it.
  void press(const Control& control, const Want& want, double at_s);
  void release(const Control& control, double at_s);
  /// Interrupts the hold: a jog is stopped, an unfinished tap is discarded.
  void let_go();
  /// The same for a hold of this input device.
  void take_away(Source source) {
    if (held_ && held_->control.source == source) let_go();
  }
  /// As let_go(), when a Stop has already been sent (a second one would mean "at once, without ramp").
  void forget() { held_.reset(); }
  /// Once a frame while the control is drawn (its key is known) and pressed. A hold not confirmed in a frame
  /// is ended.
  void confirm(const Control& control);
  /// Once a frame, after the panels: starts the jog when due, and keeps it alive. Returns whether it has
  /// ended the hold because this frame came late.
  bool tick(double now_s);

  [[nodiscard]] bool holding() const { return held_.has_value(); }
  [[nodiscard]] bool jogging() const { return held_ && held_->jogging; }
  [[nodiscard]] std::optional<Control> control() const;
  /// The continuous jog started last; 0: none. A refusal of it must end the hold: see let_go().
  [[nodiscard]] IntentId jog_intent() const { return held_ ? held_->intent : 0; }
  /// The move of the last tap; 0: none.
  [[nodiscard]] IntentId tap_intent() const { return tap_; }
  /// Seconds from `now_s` until the next tick() has something to do.
  [[nodiscard]] double due_in_s(double now_s) const;

  static constexpr double continuous_after_s = 0.250;
  static constexpr double keep_alive_every_s = 0.100;
  static constexpr double frozen_after_s = 0.250;  ///< longest gap between frames before a hold is distrusted

 private:
  struct Held {
    Control control;
    Want want;
    double pressed_at_s = 0, seen_at_s = 0, kept_alive_at_s = 0;
    bool jogging = false, confirmed = true;
    IntentId intent = 0;
  };
  enum class End : std::uint8_t { released, interrupted };
  void end(End how);

  Send send_;
  std::optional<Held> held_;
  IntentId tap_ = 0;
};

}  // namespace hw::gui
