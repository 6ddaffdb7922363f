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

/// Positions along the bar: the smaller shown number at the left.
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

/// Where the axis would come to rest if stopped now, with its ramp; nothing while the ramp is unknown.
std::optional<Steps> would_stop_at(const Frame& f, AxisId axis) {
  const AxisState& a = f.now.axes[axis.index];
  if (!f.catalog.stopping_way || !a.position_known || a.direction == 0 || !f.now.axis_moves(axis.index))
    return {};
  const auto way = f.catalog.stopping_way(f.catalog, f.now, axis);
  if (!way) return {};
  return Steps(a.position.value + std::llround(*way * a.direction));
}

/// A split tick, distinct from the target; red beyond an end.
void draw_stop_mark(Ui& ui, float x, float middle, ImU32 colour) {
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  for (const float side : {-1.0f, 1.0f})
    draw.AddRectFilled(ImVec2(x - ui.hair(), middle + side * ui.px(side < 0 ? 6 : 2)),
                       ImVec2(x + ui.hair(), middle + side * ui.px(side < 0 ? 2 : 6)), colour);
  draw.AddRectFilled(ImVec2(x - ui.px(3), middle - ui.px(7)), ImVec2(x + ui.px(3), middle - ui.px(6)),
                     colour);
}

}  // namespace

NumberText travel_words(const Frame& f, AxisId axis) {
  const DisplayUnit& unit = f.tab.unit(axis);
  const Travel& t = f.now.axes[axis.index].travel;
  NumberText words;
  if (!t.any()) return words.append("none"), words;
  if (t.has_minus && t.has_plus) {
    words.append(format_position(t.minus, unit));
    words.append(" to ");
  } else {
    words.append(t.has_plus ? "up to " : "from ");
  }
  words.append(format_with_unit(t.has_plus ? t.plus : t.minus, unit));
  if (!t.has_plus) words.append(" up");
  return words;
}

std::string_view why_travel_does_not_hold(const Frame& f, AxisId axis) {
  const AxisState& a = f.now.axes[axis.index];
  if (!a.travel.any() || a.travel_holds()) return {};
  if (!a.position_known) return "The limits do not apply: the position of the axis is not known.";
  if (a.trust.doubtful()) return "The limits do not apply: the position cannot be trusted.";
  return "The limits do not apply: they were set in other units than the axis counts in now.";
}

void draw_travel_bar(Frame& f, AxisId axis, ImVec2 at, float width) {
  const AxisState& a = f.now.axes[axis.index];
  if (!a.travel.any()) return;
  Ui& ui = f.ui;
  const DisplayUnit& unit = f.tab.unit(axis);
  End low, high;
  Scale scale = scale_of(a, unit, low, high);
  const float aside = ui.px(numbers + beside_numbers), middle = std::floor(at.y + ui.px(height / 2)) + 0.5f;
  scale.left = std::round(at.x + aside), scale.right = std::round(at.x + width - aside);
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  const bool holds = a.travel_holds();
  if (holds)
    draw.AddRectFilled(ImVec2(scale.left, middle - ui.hair() / 2),
                       ImVec2(scale.right, middle + ui.hair() / 2), ui[Tone::edge]);
  else
    for (float x = scale.left; x < scale.right; x += ui.px(6))
      draw.AddRectFilled(ImVec2(x, middle - ui.hair() / 2),
                         ImVec2(std::min(x + ui.px(3), scale.right), middle + ui.hair() / 2), ui[Tone::edge]);
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
                  ui[is_motion(state_of(f.now, axis.index, f.clock)) ? Tone::motion : Tone::ink2]);
  const std::string_view name = f.catalog.axes[axis.index].name;
  if (const auto stop = would_stop_at(f, axis)) {
    const double at_stop = from_steps(*stop, unit);
    const bool past = a.travel.past(a.direction > 0 ? Sign::plus : Sign::minus, *stop).value > 0;
    const float x = scale.x(at_stop);
    draw_stop_mark(ui, x, middle, ui[past && holds ? Tone::fault : Tone::ink]);
    const NumberText words = format_with_unit(*stop, unit);
    show(ui, {Path("dro/{}/stop", name), Kind::text, "Would stop at", words.view(), {}, false, {}},
         {ImVec2(x - ui.px(4), at.y), ImVec2(x + ui.px(4), at.y + ui.px(height))});
  }
  const Path id("dro/{}/travel", name);
  show(ui, {id, Kind::text, "Limits", travel_words(f, axis), {}, false, why_travel_does_not_hold(f, axis)},
       {at, ImVec2(at.x + width, at.y + ui.px(height))});
}

}  // namespace hw::panels
