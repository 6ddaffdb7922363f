#include "panels/path/path_choice.h"

#include <span>

#include "gui/model/tab.h"
#include "gui/surface/ui.h"
#include "gui/widgets/choice.h"

namespace hw::panels {

using namespace gui;
namespace {

AxisId axis_at(int place) { return AxisId{static_cast<std::uint8_t>(place)}; }

}  // namespace

void PathChoice::begin(const Frame& f) {
  if (!axis_names_.empty()) return;
  for (const AxisInfo& axis : f.catalog.axes) axis_names_.push_back(axis.name);
  right_names_ = axis_names_;
  right_names_.push_back("time");
  if (axis_names_.size() == 1) right_ = 1, up_ = 0;
  if (axis_names_.size() > 2) {
    third_names_.push_back("2 axes");
    third_names_.insert(third_names_.end(), axis_names_.begin(), axis_names_.end());
  }
  tool_names_ = {"own tool", "always on"};
  for (const OutputInfo& output : f.catalog.outputs) tool_names_.push_back(output.name);
}

PathAxes PathChoice::axes() const {
  PathAxes axes{axis_at(right_), axis_at(up_)};
  axes.over_time = right_ >= static_cast<int>(axis_names_.size());
  if (axes.over_time)
    axes.right = axes.up;
  else if (third_ > 0)
    axes.third = axis_at(third_ - 1);
  return axes;
}

PathTool PathChoice::tool() const { return {tool_ == 0, tool_ - 2 < 0 ? -1 : tool_ - 2}; }

void PathChoice::draw(Frame& f, float top) {
  Ui& ui = f.ui;
  const auto choose = [&](const char* id, const char* label, std::span<const std::string_view> names,
                          int& chosen, std::string_view tip) {
    ImGui::SameLine(0, ui.px(8));
    ImGui::SetCursorScreenPos(ImVec2(ImGui::GetCursorScreenPos().x, top + ui.px(12)));
    if (const int picked = dropdown(ui, id, label, names, chosen, {.tip = tip}); picked >= 0) chosen = picked;
  };
  if (axis_names_.size() > 1) {
    choose("path/right", "To the right", right_names_, right_,
           "Axis to the right; or time, with the other axis over it.");
    choose("path/up", "Upwards", axis_names_, up_, "Axis upwards; with three axes, to the back.");
  }
  if (!third_names_.empty() && !axes().over_time)
    choose("path/third", "Third", third_names_, third_, "A third axis is shown in perspective.");
  if (tool_names_.size() > 2)
    choose(
        "path/tool", "Tool", tool_names_, tool_,
        "The output of the pen or laser: as in the blocks or the drawing behind the program, or this one.");
}

}  // namespace hw::panels
