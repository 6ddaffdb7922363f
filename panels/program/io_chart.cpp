#include "panels/program/io_chart.h"

#include <algorithm>
#include <cmath>

#include "gui/surface/theme.h"
#include "gui/widgets/text.h"
#include "gui/widgets/touch.h"
#include "panels/widget_path.h"

namespace hw::panels {

using namespace gui;
namespace {

constexpr float lane_height = 22, lane_name_width = 76, on_height = 10, look_height = 14;

struct TimeScale {
  float left, right;
  double duration_s;
  [[nodiscard]] float at(double t) const {
    const double share = duration_s > 0 ? std::clamp(t / duration_s, 0.0, 1.0) : 0;
    return std::floor(left + static_cast<float>(share) * (right - left));
  }
};

void draw_spans(Ui& ui, const std::vector<IoLane::Span>& spans, const TimeScale& scale, float middle,
                Tone tone) {
  const float half = ui.px(on_height / 2);
  for (const IoLane::Span& span : spans) {
    const float from = scale.at(span.from), to = std::max(scale.at(span.to), from + ui.px(2));
    draw_fill(ui, {ImVec2(from, middle - half), ImVec2(to, middle + half)}, ui[tone], 0);
  }
}

void draw_lane(Ui& ui, const IoLane& lane, const TimeScale& scale, float middle) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(ImVec2(scale.left, middle), ImVec2(scale.right, middle + ui.hair()), ui[Tone::edge]);
  draw_spans(ui, lane.waits, scale, middle, Tone::warn_t);
  draw_spans(ui, lane.on, scale, middle, Tone::ok);
  const float half = ui.px(look_height / 2);
  for (const double t : lane.looks) {
    const float x = scale.at(t);
    list.AddRectFilled(ImVec2(x, middle - half), ImVec2(x + ui.hair(), middle + half), ui[Tone::ink]);
  }
}

}  // namespace

void draw_io_chart(Ui& ui, const std::vector<IoLane>& lanes, double duration_s, std::optional<double> now_s) {
  if (lanes.empty()) return;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float right = at.x + ImGui::GetContentRegionAvail().x, row = ui.px(lane_height);
  const TimeScale scale{at.x + ui.px(lane_name_width), right - ui.px(2), duration_s};
  for (std::size_t i = 0; i < lanes.size(); ++i) {
    const float top = at.y + row * static_cast<float>(i), middle = std::floor(top + row / 2);
    draw_text_line(ui, at.x, scale.left - ui.px(4), middle, Face::small, ui[Tone::ink2], lanes[i].name);
    draw_lane(ui, lanes[i], scale, middle);
    show(ui,
         {.id = Path("rehearsal/io/{}", i + 1),
          .kind = Kind::text,
          .label = lanes[i].name,
          .value = lanes[i].words,
          .tip = lanes[i].words},
         {ImVec2(at.x, top), ImVec2(right, top + row)});
  }
  const float height = row * static_cast<float>(lanes.size());
  if (now_s) {
    const float x = scale.at(*now_s);
    ImGui::GetWindowDrawList()->AddRectFilled(ImVec2(x, at.y), ImVec2(x + ui.px(2), at.y + height),
                                              ui[Tone::motion]);
  }
  ImGui::Dummy(ImVec2(right - at.x, height));
  gap(ui, 8);
}

}  // namespace hw::panels
