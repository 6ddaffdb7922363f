#include "panels/control/analog_bar.h"

#include <algorithm>
#include <cmath>

#include "gui/model/tab.h"
#include "gui/surface/ui.h"
#include "gui/widgets/slider.h"
#include "gui/widgets/text.h"
#include "panels/widget_path.h"

namespace hw::panels {

using namespace gui;

void draw_analog_bar(Frame& f, std::string_view id, int n, float width) {
  Ui& ui = f.ui;
  const AnalogInfo& info = f.catalog.analog[static_cast<std::size_t>(n - 1)];
  const std::int32_t value = f.now.analog[static_cast<std::size_t>(n - 1)];
  const bool known = (f.now.analog_known >> (n - 1)) & 1u;
  const bool old = !f.connected() || is_stale(f.now.io_seen_at, f.clock, f.now.poll_period);
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float middle = std::floor(at.y + ui.px(analog_bar_height / 2)), right = at.x + ui.px(width);
  if (ImGui::IsRectVisible(at, ImVec2(right, at.y + ui.px(analog_bar_height))))
    f.tab.watched.look_at_group(f.catalog.analog_readout_group);
  draw_text_line(ui, at.x, right, middle, Face::body, ui[Tone::ink], info.name);
  const Path number("{}", value);
  const std::string_view shown = known ? number.view() : std::string_view("?");
  const float unit = std::ceil(text_width(ui, Face::small, info.unit));
  draw_text_line(ui, right - unit, right + 1, middle, Face::small, ui[Tone::ink2], info.unit);
  const float number_right = right - unit - ui.px(6);
  const float number_width = std::ceil(text_width(ui, Face::body_bold, shown));
  draw_text_line(ui, number_right - number_width, number_right + 1, middle, Face::body_bold,
                 ui[known && !old ? Tone::ink : Tone::ink3], shown);
  const float left = at.x + ui.px(40), end = number_right - ui.px(52);
  ImGui::SetCursorScreenPos(ImVec2(left, std::floor(middle - ui.px(4))));
  MeterOptions o;
  o.old = !known || old;
  o.words = shown;
  o.width = std::max(24.0f, (end - left) / ui.scale);
  const float span = static_cast<float>(std::max(1, info.maximum - info.minimum));
  meter(ui, id, info.name, known ? static_cast<float>(value - info.minimum) / span : 0, o);
  ImGui::SetCursorScreenPos(ImVec2(at.x, at.y + ui.px(analog_bar_height)));
}

}  // namespace hw::panels
