#pragma once
// Limit switches. The board has one bit for both ends of an axis: which one it stands on is told by the
// direction letter (decision M33), when the switch is met.
#include <array>
#include <cstdint>

#include "core/device/snapshot.h"
#include "core/devices/vme58/codec.h"

namespace hw::vme58 {

class LimitEnds {
 public:
  explicit LimitEnds(Snapshot& draft) : draft_(draft) {}

  struct Change {
    unsigned met = 0;  ///< the axes that have just come to a switch
    bool any = false;
  };
  /// The limit register.
  Change take(std::uint8_t limits);
  [[nodiscard]] bool on(int axis) const { return bit(limits_, axis); }
  /// A motion begins; `stands`: the axis is at rest now.
  void begins(int axis, bool stands);
  /// Its count has changed that way.
  void crept(int axis, int way);
  void turns(int axis) { at(axis).turned = true; }
  [[nodiscard]] bool has_turned(int axis) const { return at(axis).turned; }
  /// It rests, and nobody has begun anything.
  void rests(int axis) { at(axis).from_limit = on(axis); }
  /// The motion was ended by a switch: the direction letter, now that it is of this motion, tells which.
  void ended_there(int axis) { at(axis).end = 0; }
  /// A switch has ended the motion. One that the axis stood on when it began has only if it did not come away
  /// from there.
  [[nodiscard]] bool met(int axis) const;
  /// The direction letter is that of the latest motion, which may have led away from the switch: it counts
  /// when the switch is met, and when the axis was sent another way and did not move.
  void hear_direction(int axis, bool plus, bool rests);
  void show(int axis);
  void forget();

 private:
  struct Axis {
    bool hit = false;         ///< its limit flag was seen since the motion began
    bool from_limit = false;  ///< it stood on a switch then, and has not come off it
    bool turned = false;      ///< it has moved since then
    std::int8_t end = 0;      ///< of the switch it stands on, once that is known
    std::int8_t letter = 0;   ///< the board's direction letter when that was last judged
  };
  [[nodiscard]] Axis& at(int axis) { return axes_[static_cast<std::size_t>(axis)]; }
  [[nodiscard]] const Axis& at(int axis) const { return axes_[static_cast<std::size_t>(axis)]; }

  Snapshot& draft_;
  std::uint8_t limits_ = 0;
  std::array<Axis, most_axes> axes_{};
};

}  // namespace hw::vme58
