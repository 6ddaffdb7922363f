#include "core/devices/vme58/limit_ends.h"

#include <utility>

namespace hw::vme58 {

LimitEnds::Change LimitEnds::take(std::uint8_t limits) {
  const std::uint8_t before = std::exchange(limits_, limits);
  for (int i = 0; i < most_axes; ++i) {
    Axis& axis = at(i);
    if (on(i)) {
      axis.hit = true;
    } else {
      if (std::exchange(axis.from_limit, false)) axis.hit = false;
      axis.end = 0;
    }
  }
  return {limits & ~static_cast<unsigned>(before), limits != before};
}

void LimitEnds::begins(int axis, bool stands) {
  at(axis).hit = at(axis).turned = false;
  if (stands) rests(axis);
}

// An axis that turns on the switch it stood on is moving away from it, whatever the direction letter says.
void LimitEnds::crept(int axis, int way) {
  if (!at(axis).from_limit || !on(axis)) return;
  at(axis).end = static_cast<std::int8_t>(-way);
  at(axis).letter = static_cast<std::int8_t>(way);
}

bool LimitEnds::met(int axis) const { return at(axis).hit && !(at(axis).from_limit && at(axis).turned); }

void LimitEnds::read_direction(int axis, bool plus, bool rests) {
  const auto letter = static_cast<std::int8_t>(plus ? 1 : -1);
  Axis& a = at(axis);
  const bool turned_round = rests && a.from_limit && a.letter != 0 && a.letter != letter;
  if (on(axis) && (a.end == 0 || turned_round)) a.end = a.letter = letter;
  if (!on(axis) || rests) a.letter = letter;
  show(axis);
}

void LimitEnds::show(int axis) {
  AxisState& shown = snapshot_.axes[axis];
  const std::int8_t end = at(axis).end;
  shown.limits_known = !on(axis) || end != 0;
  shown.limit_minus = on(axis) && end < 0;
  shown.limit_plus = on(axis) && end > 0;
}

void LimitEnds::forget() {
  limits_ = 0;
  axes_ = {};
}

}  // namespace hw::vme58
