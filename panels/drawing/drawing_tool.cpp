#include "panels/drawing/drawing_tool.h"

#include <algorithm>

#include "core/base/index.h"
#include "gui/widgets/area.h"
#include "gui/widgets/choice.h"
#include "gui/widgets/text.h"
#include "panels/drawing/drawing_place.h"
#include "panels/widget_path.h"

namespace hw::panels {

using namespace gui;

void DrawingTool::begin(const Frame& f) {
  output_names_.push_back("none");
  for (const OutputInfo& output : f.catalog.outputs) output_names_.push_back(output.name);
  wait_on_.set(0, 0), wait_off_.set(0, 0);
  down_.set(0, 3), up_.set(5, 3);
  cut_speed_.set(5, 1), travel_speed_.set(10, 1);
}

// Lowered before it is switched on; switched off before it is lifted.
void DrawingTool::put(const Frame& f, ConversionOptions& o) const {
  o.cutting.high = cut_speed_.value(), o.travel.high = travel_speed_.value();
  if (axis_ >= 0) {
    const std::size_t place = o.axes.size();
    o.axes.push_back({f.catalog.axes[ix(axis_)].name, per_unit_.value()});
    for (auto [to, routine] : {std::pair{down_.value(), &o.pen_down}, std::pair{up_.value(), &o.pen_up}}) {
      sequence::Move move;
      move.to[place] = to;
      routine->push_back({move});
      routine->push_back({sequence::WaitMotion{static_cast<int>(place)}});
    }
  }
  if (output_ > 0) {
    const int output = f.catalog.output_number(ix(output_ - 1));
    o.pen_down.push_back({sequence::Output{output, true}});
    o.pen_up.insert(o.pen_up.begin(), {sequence::Output{output, false}});
  }
  if (wait_on_.value() > 0) o.pen_down.push_back({sequence::Delay{wait_on_.value()}});
  if (wait_off_.value() > 0) o.pen_up.push_back({sequence::Delay{wait_off_.value()}});
}

// ---- drawing

bool DrawingTool::draw(Frame& f, const std::array<int, 2>& drawing_axes) {
  Ui& ui = f.ui;
  section_title(ui, "Tool and speeds");
  list_axes(f, drawing_axes);
  const bool draws = axis_ >= 0 && std::find(axes_.begin(), axes_.end(), axis_) == axes_.end();
  if (draws) axis_ = -1;  // it has been made one of those since
  bool changed = draws;
  const ImVec2 at = begin_option(ui, "Output");
  if (const int picked = dropdown(ui, "drawing/tool", "Output", output_names_, output_, {.width = fill});
      picked >= 0)
    output_ = picked, changed = true;
  end_option(ui, at);
  if (!axes_.empty()) changed |= draw_axis(f);
  if (output_ > 0 || axis_ >= 0) {
    changed |= wait_on_.draw(f, "drawing/wait_on", "Wait when on", 0, "ms");
    changed |= wait_off_.draw(f, "drawing/wait_off", "Wait when off", 0, "ms");
  }
  changed |= cut_speed_.draw(f, "drawing/cut_speed", "Tool on", 0, "mm/s");
  changed |= travel_speed_.draw(f, "drawing/travel_speed", "Tool off", 0, "mm/s");
  return changed;
}

void DrawingTool::list_axes(const Frame& f, const std::array<int, 2>& drawing_axes) {
  axes_.clear(), axis_names_.clear();
  axis_names_.push_back("none");
  for (std::size_t i = 0; i < f.catalog.axes.size(); ++i) {
    const int axis = static_cast<int>(i);
    if (axis == drawing_axes[0] || axis == drawing_axes[1]) continue;
    axes_.push_back(axis);
    axis_names_.push_back(f.catalog.axes[i].name);
  }
}

bool DrawingTool::draw_axis(Frame& f) {
  Ui& ui = f.ui;
  constexpr double furthest = -1e6;
  const ImVec2 at = begin_option(ui, "Axis");
  const auto found = std::find(axes_.begin(), axes_.end(), axis_);
  const int chosen = found == axes_.end() ? 0 : static_cast<int>(found - axes_.begin()) + 1;
  const int picked = dropdown(ui, "drawing/tool_axis", "Axis", axis_names_, chosen, {.width = fill});
  end_option(ui, at);
  bool changed = picked >= 0 && picked != chosen;
  if (changed) {
    axis_ = picked == 0 ? -1 : axes_[ix(picked - 1)];
    if (axis_ >= 0) per_unit_.set(steps_in_mm(f, axis_), 3);
  }
  if (axis_ < 0) return changed;
  changed |= per_unit_.draw(f, "drawing/tool_axis/per_unit",
                            Path("{}/mm, {}", f.catalog.step_word, f.catalog.axes[ix(axis_)].name), 1e-6, {});
  changed |= down_.draw(f, "drawing/tool_axis/down", "Down at", furthest, "mm");
  changed |= up_.draw(f, "drawing/tool_axis/up", "Up at", furthest, "mm");
  return changed;
}

}  // namespace hw::panels
