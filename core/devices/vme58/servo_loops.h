#pragma once
// Servo axes: their position is that of the encoder, so a motion has ended when the encoder has reached the
// end of the command.
//
// A stop or a jog has no target: an axis stopped by the console or a text rests when its command rests, and
// shows its following error. Relative moves add to the command, not to the encoder, as each would otherwise
// inherit the error of the previous one.
#include <array>
#include <optional>

#include "core/device/catalog.h"
#include "core/devices/vme58/next_round.h"
#include "core/devices/vme58/parameter_values.h"
#include "core/devices/vme58/servo_place.h"
#include "core/devices/vme58/wire.h"

namespace hw::vme58 {

class ServoLoops {
 public:
  ServoLoops(Wire& wire, const Catalog& catalog, const ParameterValues& values, NextRound& next,
             Snapshot& snapshot)
      : wire_(wire), catalog_(catalog), values_(values), next_(next), snapshot_(snapshot) {}

  // ---- loops
  /// Sets the loop state learned from EA, HN or HF; none: not known.
  void know(int axis, std::optional<bool> closed);
  [[nodiscard]] std::optional<bool> closed(int axis) const { return at(axis).closed; }
  [[nodiscard]] bool is_servo(int axis) const { return catalog_.axes[static_cast<std::size_t>(axis)].servo; }

  // ---- places
  /// Takes a reading of command and encoder, which are already shown. `turns`: the command is moving.
  void look(int axis, Instant at, bool turns);
  /// Notes whether the motion has a target: it is no jog, and no stop has cut it short.
  void goes_to_place(int axis, bool it_does);
  /// The axis follows something other than its command.
  void leaves_its_place(int axis) { at(axis).goes_to_place = false; }
  /// A new motion begins: the end of the previous one is no longer judged.
  void begins(int axis, bool to_a_place);
  /// Something other than its command makes the axis move.
  void begins_to_settle(int axis);
  /// The command has ended, and the encoder has yet to show whether the axis arrives.
  [[nodiscard]] bool settles(int axis) const;
  /// The axis settles and its command has ended: it may be sent on.
  [[nodiscard]] bool only_settles(int axis) const { return settles(axis) && at(axis).place.settles(); }
  /// Corrects an apparent arrival if the encoder is elsewhere, and warns once.
  EndedBy judged(int axis, EndedBy ended_by);

  /// Raw text is sent as typed; this warns of its effect. True: the text may drive its axis to its command.
  bool warn_of_closing(const TextCommand& command);
  void forget();

 private:
  struct Axis {
    ServoPlace place;
    std::optional<bool> closed;
    bool goes_to_place = true;
    bool settling = false;  ///< a motion to a target was seen, its end not yet judged
  };
  [[nodiscard]] Axis& at(int axis) { return axes_[static_cast<std::size_t>(axis)]; }
  [[nodiscard]] const Axis& at(int axis) const { return axes_[static_cast<std::size_t>(axis)]; }
  [[nodiscard]] std::int64_t deadband(int axis) const;

  Wire& wire_;
  const Catalog& catalog_;
  const ParameterValues& values_;
  NextRound& next_;
  Snapshot& snapshot_;
  std::array<Axis, most_axes> axes_{};
};

}  // namespace hw::vme58
