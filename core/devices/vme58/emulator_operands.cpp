// From typed operands to their meaning: user units, ranges, fitted axes.
#include <cmath>

#include "core/devices/vme58/emulator_board.h"

namespace hw::vme58 {

void Board::obey(const Command& typed) {
  Command command = typed;
  if (!axes_fit(command) || !resolve(command)) return text_error();
  switch (command.fact->when) {
    case When::at_once: return do_at_once(command);
    case When::queued: return put_in_queue(command);
    case When::query: return answer(command);
    case When::recorded: return record(command);
  }
}

unsigned Board::addressed(const Command& c) const {
  if (c.fact->shape != Shape::list || context_ < most_axes) return context_axes();
  unsigned axes = 0;
  for (int a = 0; a < most_axes; ++a)
    if (c.number[ix(a)]) axes |= 1u << a;
  return axes;
}

bool Board::axes_fit(const Command& c) const {
  const unsigned axes = addressed(c);
  if ((axes & ~fitted_) != 0) return false;
  if (!c.fact->needs_encoder && !c.fact->needs_servo) return true;
  // In AA and AM one axis with the required fitting is enough.
  bool some = false;
  each_axis(axes, [&](int a) {
    const AxisFitting f = variant_->fitting(a);
    some = some || (c.fact->needs_servo ? f.kind == AxisKind::servo : f.encoder);
  });
  return some;
}

bool Board::resolve(Command& c) const {
  for (int place = 0; place < most_axes; ++place)
    if (auto& n = c.number[ix(place)]; n && !resolve_number(c, place, *n)) return false;
  switch (c.op()) {
    case Op::RM:
    case Op::UU:
      for (const auto& n : c.number)
        if (n && *n == 0) return false;
      return true;
    case Op::BL:
    case Op::BH: return io_.is_output(static_cast<int>(c.first()));
    case Op::contour_MT:
      return c.operands() == recorder_.contour().axis_count() && contour_axis(c.operands() - 1) >= 0;
    case Op::CR: return recorder_.contour().axis_count() == 2;
    case Op::contour_AN:
    case Op::contour_AF:
      for (const auto& n : c.number)
        if (n && (fitted_ >> static_cast<int>(*n) & 1u) == 0) return false;
      return true;
    default: return true;
  }
}

/// The axis of an operand inside a contour: the first operand belongs to its first axis (decision M68).
int Board::contour_axis(int place) const {
  for (int a = 0; a < most_axes; ++a)
    if (recorder_.contour().has(a) && place-- == 0) return a;
  return -1;
}

/// Counts per user unit of this number; 0: user units are off, or do not apply. The contour velocity has no
/// axis of its own: in AA and AM it is in the units of X.
double Board::unit_of(const Command& c, int place) const {
  if (c.fact->number != Number::counts && c.fact->number != Number::speed) return 0;
  int axis = context_ < most_axes ? context_ : 0;
  if (c.fact->shape == Shape::list && context_ >= most_axes) axis = place;
  if (c.fact->when == When::recorded) axis = contour_axis(place);
  return axis < 0 ? 0 : motion_.settings(axis).user_unit;
}

bool Board::resolve_number(const Command& c, int place, double& value) const {
  const CommandFact& f = *c.fact;
  const bool is_angle = f.shape == Shape::triple && place == 2;
  const Number kind = is_angle ? Number::real : f.number;
  const double unit = is_angle ? 0 : unit_of(c, place);
  if (unit != 0) value *= unit;
  if (kind == Number::whole || kind == Number::counts)
    value = unit != 0 ? std::round(value) : std::trunc(value);
  const bool has_own_range = (f.shape == Shape::pair && place == 1) || is_angle;
  const double min = has_own_range ? f.second_min : f.min, max = has_own_range ? f.second_max : f.max;
  return value >= min && value <= max;
}

}  // namespace hw::vme58
