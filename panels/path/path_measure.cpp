#include "panels/path/path_measure.h"

namespace hw::panels {

using namespace gui;

void PathMeasure::set_end(drawing::Point3 end) {
  if (!from || to)
    from = end, to.reset();
  else
    to = end;
}

std::optional<drawing::Point3> PathMeasure::way() const {
  const auto& end = to ? to : pointer;
  return from && end ? std::optional(*end - *from) : std::nullopt;
}

void draw_measure(const PathGround& g, const PathMeasure& measure) {
  if (!measure.on || !measure.from) return;
  const Ui& ui = g.frame.ui;
  ImDrawList* list = ImGui::GetWindowDrawList();
  const auto cross = [&](ImVec2 end) {
    const float arm = ui.px(5);
    list->AddLine(ImVec2(end.x - arm, end.y), ImVec2(end.x + arm, end.y), ui[Tone::warn], ui.hair());
    list->AddLine(ImVec2(end.x, end.y - arm), ImVec2(end.x, end.y + arm), ui[Tone::warn], ui.hair());
  };
  cross(g.at(*measure.from));
  const auto way = measure.way();
  if (!way) return;
  const ImVec2 to = g.at(*measure.from + *way);
  list->AddLine(g.at(*measure.from), to, ui[Tone::warn], ui.hair());
  cross(to);
}

}  // namespace hw::panels
