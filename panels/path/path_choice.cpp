#include "panels/path/path_choice.h"

#include <span>

#include "gui/model/tab.h"
#include "gui/model/units_format.h"
#include "gui/surface/ui.h"
#include "gui/widgets/choice.h"

namespace hw::panels {

using namespace gui;
namespace {

AxisId axis_at(int place) { return AxisId{static_cast<std::uint8_t>(place)}; }

}  // namespace

void PathChoice::name_all(const Frame& f) {
  if (!axis_names_.empty()) return;
  for (const AxisInfo& axis : f.catalog.axes) axis_names_.push_back(axis.name);
  if (axis_names_.size() > 2) {
    third_names_.push_back("2 axes");
    third_names_.insert(third_names_.end(), axis_names_.begin(), axis_names_.end());
  }
  tool_names_.push_back("always on");
  for (const OutputInfo& output : f.catalog.outputs) tool_names_.push_back(output.name);
}

PathAxes PathChoice::axes() const {
  PathAxes axes{axis_at(right_), axis_at(up_)};
  if (third_ > 0) axes.third = axis_at(third_ - 1);
  return axes;
}

TrackAxes PathChoice::track_axes(const Tab& tab) const {
  const auto scaled = [&](AxisId a) { return TrackAxes::Axis{a.index, from_steps(Steps(1), tab.unit(a))}; };
  const PathAxes chosen = axes();
  TrackAxes track{scaled(chosen.right), scaled(chosen.up), {}, tool_ - 1};
  if (chosen.third) track.third = scaled(*chosen.third);
  return track;
}

void PathChoice::draw(Frame& f, float top) {
  name_all(f);
  Ui& ui = f.ui;
  const auto choose = [&](const char* id, const char* label, std::span<const std::string_view> names,
                          int& chosen, std::string_view tip) {
    ImGui::SameLine(0, ui.px(8));
    ImGui::SetCursorScreenPos(ImVec2(ImGui::GetCursorScreenPos().x, top + ui.px(12)));
    if (const int picked = dropdown(ui, id, label, names, chosen, {.tip = tip}); picked >= 0) chosen = picked;
  };
  choose("path/right", "To the right", axis_names_, right_, "Which axis goes to the right.");
  choose("path/up", "Upwards", axis_names_, up_, "Which axis goes upwards; of three axes, to the back.");
  if (!third_names_.empty())
    choose("path/third", "Third", third_names_, third_, "With a third axis it is seen in perspective.");
  if (tool_names_.size() > 1)
    choose("path/tool", "Tool", tool_names_, tool_, "The output that switches pen or laser.");
}

}  // namespace hw::panels
