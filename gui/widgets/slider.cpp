#include "gui/widgets/slider.h"

#include <cmath>

#include <imgui_internal.h>

#include "gui/widgets/text.h"

namespace hw::gui {
namespace {

double to_share(double v, const SliderOptions& o) {
  if (o.max <= o.min) return 0;
  const double share =
      o.logarithmic ? std::log(v / o.min) / std::log(o.max / o.min) : (v - o.min) / (o.max - o.min);
  return std::clamp(share, 0.0, 1.0);
}
double from_share(double share, const SliderOptions& o) {
  double v = o.logarithmic ? o.min * std::pow(o.max / o.min, share) : o.min + share * (o.max - o.min);
  if (o.step > 0) v = std::round(v / o.step) * o.step;
  return std::clamp(v, o.min, o.max);
}

double stepped(double v, int direction, const SliderOptions& o) {
  if (o.logarithmic || o.step <= 0) {
    const double next = from_share(std::clamp(to_share(v, o) + direction * 0.02, 0.0, 1.0), o);
    if (next != v || o.step <= 0) return next;
  }
  return std::clamp(v + direction * o.step, o.min, o.max);
}

int keys_of_ring(const Touch& t) {
  int direction = 0;
  if (!t.ring) return 0;
  for (ImWchar c : ImGui::GetIO().InputQueueCharacters) direction += (c == '+') - (c == '-');
  return direction;
}

void draw_slider(Ui& ui, const Touch& t, float grip_x) {
  ImDrawList* list = ImGui::GetWindowDrawList();
  const float y = std::floor(t.rect.centre().y), half = ui.px(2);
  const Rect track{ImVec2(t.rect.min.x, y - half), ImVec2(t.rect.max.x, y + half)};
  const bool on = t.enabled;
  list->AddRectFilled(track.min, track.max, ui[Tone::well], half);
  draw_outline(ui, track, ui[on ? Tone::edge : Tone::line], 2);
  list->AddRectFilled(track.min, ImVec2(grip_x, track.max.y), ui[on ? Tone::ink2 : Tone::line], half);
  const Rect grip{ImVec2(grip_x - ui.px(8), y - ui.px(12)), ImVec2(grip_x + ui.px(8), y + ui.px(12))};
  draw_fill(ui, grip, ui[!on ? Tone::panel : t.held || t.hovered ? Tone::ink2 : Tone::ink]);
  if (!on) draw_outline(ui, grip, ui[Tone::line]);
  if (t.held) draw_fill(ui, grip, ui[Tone::ink]);
}

}  // namespace

bool slider(Ui& ui, std::string_view id, std::string_view label, double& value, const SliderOptions& o) {
  const Touch t = touch(ui, {id, Kind::slider, label, o.value_text, o.disabled, false, o.tip},
                        ImVec2(width_px(ui, o.width), ui.px(32)));
  const float grip = ui.px(8), run = std::max(1.0f, t.rect.width() - 2 * grip);
  double next = value;
  if (t.held && ImGui::IsMouseDown(0))
    next = from_share(std::clamp((ImGui::GetIO().MousePos.x - t.rect.min.x - grip) / run, 0.0f, 1.0f), o);
  if (const int direction = t.enabled ? keys_of_ring(t) : 0; direction != 0)
    next = stepped(value, direction, o);
  if (t.double_clicked && t.enabled && o.normal >= o.min && o.normal <= o.max) next = o.normal;
  const bool changed = next != value;
  value = next;
  draw_slider(ui, t, std::floor(t.rect.min.x + grip + run * static_cast<float>(to_share(value, o))));
  draw_ring(ui, t);
  return changed;
}

void meter(Ui& ui, std::string_view id, std::string_view label, float share, const MeterOptions& o) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const Rect r{at, ImVec2(at.x + width_px(ui, o.width), at.y + ui.px(o.height))};
  const Tone tone = o.over ? Tone::fault : o.old ? Tone::line : o.tone;
  const float full = std::floor(r.width() * std::clamp(o.over ? 1.0f : share, 0.0f, 1.0f) + 0.5f);
  draw_fill(ui, r, ui[Tone::well], 2);
  if (full > 0)
    ImGui::GetWindowDrawList()->AddRectFilled(
        r.min, ImVec2(r.min.x + full, r.max.y), ui[tone], ui.px(2),
        full >= r.width() ? ImDrawFlags_RoundCornersAll : ImDrawFlags_RoundCornersLeft);
  draw_outline(ui, r, ui[o.over ? Tone::fault : Tone::edge], 2);
  ImGui::Dummy(ImVec2(r.width(), r.height()));
  if (!id.empty()) show(ui, {id, Kind::meter, label, o.words, {}, false, o.tip}, r);
}

}  // namespace hw::gui
