#pragma once
// Servo axes: where they stand is where their encoder stands, so a motion has ended when that has come to
// where the command has.
//
// A stop and a jog have no place to come to: an axis that the console, or a text, stops rests when its
// command rests, and shows its following error. Relative moves add to the command, not to the encoder, or
// each would carry on the error of the one before.
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
             Snapshot& draft)
      : wire_(wire), catalog_(catalog), values_(values), next_(next), draft_(draft) {}

  // ---- loops
  /// As EA, HN or HF have told; none: not known.
  void know(int axis, std::optional<bool> closed);
  [[nodiscard]] std::optional<bool> closed(int axis) const { return at(axis).closed; }
  [[nodiscard]] bool is_servo(int axis) const { return catalog_.axes[static_cast<std::size_t>(axis)].servo; }

  // ---- places
  /// One reading of command and encoder, which are shown already. `turns`: its command is on its way.
  void look(int axis, Instant at, bool turns);
  /// Its motion is to end somewhere: it is no jog, and not cut short by a stop.
  void goes_to_place(int axis, bool it_does);
  /// It follows something else than its command.
  void leaves_its_place(int axis) { at(axis).goes_to_place = false; }
  /// A new motion: how the one before ended is not asked any more.
  void begins(int axis, bool to_a_place);
  /// Something else than its command sends it on its way.
  void begins_to_settle(int axis);
  /// Its command has ended, and its encoder has yet to show whether it came there.
  [[nodiscard]] bool settles(int axis) const;
  /// So it is, and its command has long been there: it may be sent on.
  [[nodiscard]] bool only_settles(int axis) const { return settles(axis) && at(axis).place.settles(); }
  /// What seems to have come to its target has not while its encoder stands elsewhere. Told once.
  EndedBy judged(int axis, EndedBy ended_by);

  /// Raw text goes as it is typed; it is said what it did. True: it may drive its axis there.
  bool warn_of_closing(const TextCommand& command);
  void forget();

 private:
  struct Axis {
    ServoPlace place;
    std::optional<bool> closed;
    bool goes_to_place = true;
    bool settling = false;  ///< a motion to a place was seen, and nobody has said yet how it ended
  };
  [[nodiscard]] Axis& at(int axis) { return axes_[static_cast<std::size_t>(axis)]; }
  [[nodiscard]] const Axis& at(int axis) const { return axes_[static_cast<std::size_t>(axis)]; }
  [[nodiscard]] std::int64_t deadband(int axis) const;

  Wire& wire_;
  const Catalog& catalog_;
  const ParameterValues& values_;
  NextRound& next_;
  Snapshot& draft_;
  std::array<Axis, most_axes> axes_{};
};

}  // namespace hw::vme58
