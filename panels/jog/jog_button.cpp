#include "panels/jog/jog_button.h"

#include "gui/model/tap_size.h"
#include "gui/model/units_format.h"
#include "panels/jog/jog_units.h"

namespace hw::panels {

using namespace gui;

static std::string_view limit_reason(const AxisState& a, Sign sign) {
  if (a.travel_holds() && a.travel.has(sign) && a.travel.past(sign, a.goal()) >= Steps(0) &&
      a.activity != Activity::jogging)
    return sign == Sign::plus ? "The axis is at the + limit set for it. It can only move \u2212."
                              : "The axis is at the \u2212 limit set for it. It can only move +.";
  if (!a.limits_known) return {};
  if (sign == Sign::plus && a.limit_plus) return "The axis is on its + limit. It can only move \u2212.";
  if (sign == Sign::minus && a.limit_minus) return "The axis is on its \u2212 limit. It can only move +.";
  return {};
}

Path tap_and_hold(const Tab& tab, AxisId axis) {
  const DisplayUnit& unit = tab.settings.units().length(axis);
  const Pps speed = held_speed(tab, axis);
  const NumberText step = format_with_unit(tap_of(tab, axis), unit);
  if (speed.value <= 0) return Path("A tap moves it {}.", step.view());
  return Path("A tap moves it {}; held, it runs at {}.", step.view(), format_speed(speed, unit).view());
}

void draw_jog_button(Ui& ui, Tab& tab, AxisId axis, Sign sign, std::string_view label, HoldOptions o) {
  const std::string& name = tab.catalog().axes[axis.index].name;
  const std::string_view refused = tab.why_not_move(axis);
  o.disabled = refused.empty() ? limit_reason(tab.now().axes[axis.index], sign) : refused;
  const Path tip = tap_and_hold(tab, axis);
  o.tip = tip;
  const auto held = tab.jog.control();
  o.lit = held && held->axis == axis && held->sign == sign;
  const Hold hold = hold_button(ui, Path("jog/{}/{}", name, letter(sign)), label, o);
  const JogHold::Control control{JogHold::Source::mouse, axis, sign};
  if (hold.started)
    tab.jog.press(control, {tap_of(tab, axis), tab.settings.jog_speed(axis)}, hold.pressed_at_s);
  if (hold.held) tab.jog.confirm(control);
  if (!hold.ended) return;
  if (o.disabled.empty())
    tab.jog.release(control, hold.released_at_s);
  else if (held == control)
    tab.jog.let_go();  // the button was disabled while held
}

}  // namespace hw::panels
