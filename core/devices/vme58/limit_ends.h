#pragma once
// Limit switches. The board has one bit for both ends of an axis; the direction letter at the moment the
// switch is met shows which end it is (decision M33).
#include <array>
#include <cstdint>

#include "core/device/snapshot.h"
#include "core/devices/vme58/codec.h"

namespace hw::vme58 {

class LimitEnds {
 public:
  explicit LimitEnds(Snapshot& snapshot) : snapshot_(snapshot) {}

  struct Change {
    unsigned met = 0;  ///< axes that have just met a switch
    bool any = false;
  };
  /// Takes the limit register, as read.
  Change take(std::uint8_t limits);
  [[nodiscard]] bool on(int axis) const { return bit(limits_, axis); }
  /// A motion begins. `stands`: the axis is at rest now.
  void begins(int axis, bool stands);
  /// The count of the axis has changed in direction `way`.
  void crept(int axis, int way);
  void turns(int axis) { at(axis).turned = true; }
  [[nodiscard]] bool has_turned(int axis) const { return at(axis).turned; }
  /// The axis rests, and no motion has been begun.
  void rests(int axis) { at(axis).from_limit = on(axis); }
  /// A switch ended the motion: the direction letter now belongs to this motion and shows which end.
  void ended_there(int axis) { at(axis).end = 0; }
  /// Whether a switch ended the motion. A switch on which the axis stood at its start counts only if the axis
  /// has not moved away.
  [[nodiscard]] bool met(int axis) const;
  /// Takes the direction letter. It belongs to the latest motion, which may have led away from the switch, so
  /// it counts only when the switch is met, or when the axis was sent the other way and did not move.
  void read_direction(int axis, bool plus, bool rests);
  void show(int axis);
  void forget();

 private:
  struct Axis {
    bool hit = false;         ///< limit flag seen since the motion began
    bool from_limit = false;  ///< the axis stood on a switch then, and has not left it
    bool turned = false;      ///< the axis has moved since then
    std::int8_t end = 0;      ///< end of the switch it stands on; 0: not known
    std::int8_t letter = 0;   ///< direction letter when `end` was last judged
  };
  [[nodiscard]] Axis& at(int axis) { return axes_[static_cast<std::size_t>(axis)]; }
  [[nodiscard]] const Axis& at(int axis) const { return axes_[static_cast<std::size_t>(axis)]; }

  Snapshot& snapshot_;
  std::uint8_t limits_ = 0;
  std::array<Axis, most_axes> axes_{};
};

}  // namespace hw::vme58
