#include "panels/position/travel_bar.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "gui/model/axis_look.h"
#include "gui/model/tab.h"
#include "gui/widgets/text.h"
#include "gui/widgets/touch.h"
#include "panels/widget_path.h"

namespace hw::panels {

using namespace gui;
namespace {

constexpr float height = 16, numbers = 44, beside_numbers = 6;

/// The positions along the bar, with the smaller shown number at the left.
struct Scale {
  double low = 0, high = 1;  ///< as shown
  float left = 0, right = 1;
  [[nodiscard]] float x(double place) const {
    const double part = (place - low) / (high - low);
    return std::round(left + static_cast<float>(std::clamp(part, 0.0, 1.0)) * (right - left));
  }
};

struct End {
  bool set = false;
  double at = 0;
};

/// An end that is not set is drawn at the axis position or zero, whichever is further.
Scale scale_of(const AxisState& axis, const DisplayUnit& unit, End& low, End& high) {
  const double here = from_steps(axis.position, unit);
  low = {axis.travel.has_minus, from_steps(axis.travel.minus, unit)};
  high = {axis.travel.has_plus, from_steps(axis.travel.plus, unit)};
  if (unit.per_step < 0) std::swap(low, high);
  Scale scale;
  scale.low = low.set ? low.at : std::min(here, std::min(0.0, high.at)) - 1;
  scale.high = high.set ? high.at : std::max(here, std::max(0.0, low.at)) + 1;
  if (scale.high <= scale.low) scale.high = scale.low + 1;
  return scale;
}

void draw_end(Ui& ui, const End& end, const DisplayUnit& unit, float x, float number_left, float middle,
              bool right) {
  if (!end.set) return;
  const ImU32 warn = ui[Tone::warn];
  ImGui::GetWindowDrawList()->AddRectFilled(ImVec2(x - ui.hair(), middle - ui.px(5)),
                                            ImVec2(x + ui.hair(), middle + ui.px(5)), warn);
  const NumberText number = format_number(end.at, unit.real && std::abs(end.at) < 1000 ? 1 : 0);
  const float width = std::ceil(text_width(ui, Face::small, number));
  const float left = right ? number_left : number_left + ui.px(numbers) - width;
  draw_text_line(ui, left, left + width + 1, middle, Face::small, ui[Tone::ink2], number);
}

void draw_triangle(Ui& ui, float x, float top, ImU32 colour) {
  const float w = ui.px(4), h = ui.px(6);
  ImGui::GetWindowDrawList()->AddTriangleFilled(ImVec2(x, top), ImVec2(x + w, top + h),
                                                ImVec2(x - w, top + h), colour);
}

/// The position at which the axis would come to rest if stopped now, with its ramp; nullopt while the ramp is
/// unknown.
std::optional<Steps> would_stop_at(const Tab& tab, AxisId axis) {
  const AxisState& a = tab.now().axes[axis.index];
  const Catalog& catalog = tab.catalog();
  if (!catalog.stopping_way || !a.position_known || a.direction == 0 || !tab.now().axis_moves(axis.index))
    return {};
  const auto way = catalog.stopping_way(catalog, tab.now(), axis);
  if (!way) return {};
  return Steps(a.position.value + std::llround(*way * a.direction));
}

/// Draws a split tick, distinct from the target; it is red beyond an end.
void draw_stop_mark(Ui& ui, float x, float middle, ImU32 colour) {
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  for (const float side : {-1.0f, 1.0f})
    draw.AddRectFilled(ImVec2(x - ui.hair(), middle + side * ui.px(side < 0 ? 6 : 2)),
                       ImVec2(x + ui.hair(), middle + side * ui.px(side < 0 ? 2 : 6)), colour);
  draw.AddRectFilled(ImVec2(x - ui.px(3), middle - ui.px(7)), ImVec2(x + ui.px(3), middle - ui.px(6)),
                     colour);
}

void draw_rule(Ui& ui, const Scale& scale, float middle, bool holds) {
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  const float half = ui.hair() / 2, dash = holds ? scale.right - scale.left : ui.px(3);
  for (float x = scale.left; x < scale.right; x += holds ? dash : 2 * dash)
    draw.AddRectFilled(ImVec2(x, middle - half), ImVec2(std::min(x + dash, scale.right), middle + half),
                       ui[Tone::edge]);
}

void draw_where_it_would_stop(Ui& ui, const Tab& tab, AxisId axis, const Scale& scale, float middle) {
  const auto stop = would_stop_at(tab, axis);
  if (!stop) return;
  const AxisState& a = tab.now().axes[axis.index];
  const bool past = a.travel.past(a.direction > 0 ? Sign::plus : Sign::minus, *stop).value > 0;
  const float x = scale.x(from_steps(*stop, tab.settings.unit(axis)));
  draw_stop_mark(ui, x, middle, ui[past && a.travel_holds() ? Tone::fault : Tone::ink]);
  const NumberText words = format_with_unit(*stop, tab.settings.unit(axis));
  show(ui,
       {Path("dro/{}/stop", tab.catalog().axes[axis.index].name),
        Kind::text,
        "Would stop at",
        words.view(),
        {},
        false,
        {}},
       {ImVec2(x - ui.px(4), middle - ui.px(7)), ImVec2(x + ui.px(4), middle + ui.px(7))});
}

Tone tone_of_position(const Tab& tab, AxisId axis) {
  return is_motion(state_of(tab.now(), axis.index, tab.clock())) ? Tone::motion : Tone::ink2;
}

}  // namespace

NumberText travel_words(const Tab& tab, AxisId axis) {
  const DisplayUnit& unit = tab.settings.unit(axis);
  const Travel& t = tab.now().axes[axis.index].travel;
  NumberText words;
  if (!t.any()) return words.append("none"), words;
  const Sign below = unit.per_step < 0 ? Sign::plus : Sign::minus, above = -below;
  if (t.has(below) && t.has(above)) {
    words.append(format_position(t.end(below), unit));
    words.append(" to ");
  } else {
    words.append(t.has(above) ? "up to " : "from ");
  }
  words.append(format_with_unit(t.end(t.has(above) ? above : below), unit));
  if (!t.has(above)) words.append(" up");
  return words;
}

std::string_view why_travel_does_not_hold(const Tab& tab, AxisId axis) {
  const AxisState& a = tab.now().axes[axis.index];
  if (!a.travel.any() || a.travel_holds()) return {};
  if (!a.position_known) return "The limits do not apply: the position of the axis is not known.";
  if (a.trust.doubtful()) return "The limits do not apply: the position cannot be trusted.";
  return "The limits do not apply: they were set in other units than the axis counts in now.";
}

static void show_travel(Ui& ui, const Tab& tab, AxisId axis, const Rect& place) {
  const NumberText words = travel_words(tab, axis);
  const std::string_view why_not = why_travel_does_not_hold(tab, axis);
  show(ui,
       {Path("dro/{}/travel", tab.catalog().axes[axis.index].name),
        Kind::text,
        "Limits",
        words,
        {},
        false,
        why_not.empty() ? words.view() : why_not},
       place);
}

void draw_travel_bar(Frame& f, AxisId axis, ImVec2 at, float width) {
  const AxisState& a = f.now.axes[axis.index];
  if (!a.travel.any()) return;
  Ui& ui = f.ui;
  const DisplayUnit& unit = f.tab.settings.unit(axis);
  End low, high;
  Scale scale = scale_of(a, unit, low, high);
  const float aside = ui.px(numbers + beside_numbers), middle = std::floor(at.y + ui.px(height / 2)) + 0.5f;
  scale.left = std::round(at.x + aside), scale.right = std::round(at.x + width - aside);
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  draw_rule(ui, scale, middle, a.travel_holds());
  draw_end(ui, low, unit, scale.left, at.x, middle, false);
  draw_end(ui, high, unit, scale.right, scale.right + ui.px(beside_numbers), middle, true);
  if (scale.low < 0 && scale.high > 0)
    draw.AddCircle(ImVec2(scale.x(0), middle), ui.px(3), ui[Tone::ink2], 12, ui.hair());
  if (a.has_target) {
    const float x = scale.x(from_steps(a.target, unit));
    draw.AddRectFilled(ImVec2(x - ui.hair(), middle - ui.px(4)), ImVec2(x + ui.hair(), middle + ui.px(4)),
                       ui[Tone::motion]);
  }
  if (a.position_known)
    draw_triangle(ui, scale.x(from_steps(a.position, unit)), middle + ui.px(2),
                  ui[tone_of_position(f.tab, axis)]);
  draw_where_it_would_stop(ui, f.tab, axis, scale, middle);
  show_travel(ui, f.tab, axis, {at, ImVec2(at.x + width, at.y + ui.px(height))});
}

void draw_travel_line(Ui& ui, const Tab& tab, AxisId axis, ImVec2 at, float width) {
  const AxisState& a = tab.now().axes[axis.index];
  if (!a.travel.any()) return;
  const DisplayUnit& unit = tab.settings.unit(axis);
  End low, high;
  Scale scale = scale_of(a, unit, low, high);
  const float y = std::floor(at.y) + 0.5f, tick = ui.px(4);
  scale.left = std::round(at.x), scale.right = std::round(at.x + width);
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  const auto mark = [&](float x, float half_width, float above, float below, Tone tone) {
    draw.AddRectFilled(ImVec2(x - half_width, y - above), ImVec2(x + half_width, y + below), ui[tone]);
  };
  draw_rule(ui, scale, y, a.travel_holds());
  if (low.set) mark(scale.left, ui.hair(), tick, ui.hair(), Tone::warn);
  if (high.set) mark(scale.right, ui.hair(), tick, ui.hair(), Tone::warn);
  if (scale.low < 0 && scale.high > 0) mark(scale.x(0), ui.hair() / 2, ui.px(2), ui.px(2), Tone::ink2);
  if (a.has_target) mark(scale.x(from_steps(a.target, unit)), ui.hair(), tick, ui.hair(), Tone::motion);
  if (a.position_known)
    mark(scale.x(from_steps(a.position, unit)), ui.px(2), ui.px(2), ui.px(1), tone_of_position(tab, axis));
  draw_where_it_would_stop(ui, tab, axis, scale, y);
  show_travel(ui, tab, axis, {ImVec2(at.x, y - tick), ImVec2(at.x + width, y + ui.px(2))});
}

}  // namespace hw::panels
