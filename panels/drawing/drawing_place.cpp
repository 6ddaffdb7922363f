#include "panels/drawing/drawing_place.h"

#include <algorithm>

#include "core/base/index.h"
#include "gui/widgets/area.h"
#include "gui/widgets/choice.h"
#include "gui/widgets/text.h"
#include "panels/drawing/drawn_together.h"
#include "panels/widget_path.h"

namespace hw::panels {

using namespace gui;

static constexpr std::array<std::string_view, 5> file_units{"mm", "in", "cm", "m", "ft"};

double steps_in_mm(const Frame& f, int axis) {
  const DisplayUnit& unit = unit_of_axis(f, axis);
  const bool known = unit.real && unit.name == "mm" && unit.per_step > 0;
  return known ? 1 / unit.per_step : 100;
}

void DrawingPlace::begin(const Frame& f) {
  for (const AxisInfo& axis : f.catalog.axes) axis_names_.push_back(axis.name);
  for (const std::size_t d : {0, 1}) take_axis(f, d, axes_[d]);
  join_.set(ConversionOptions().touching, 3);
}

void DrawingPlace::take_axis(const Frame& f, std::size_t direction, int axis) {
  axes_[direction] = axis;
  per_unit_[direction].set(steps_in_mm(f, axis), 3);
}

void DrawingPlace::put(const Frame& f, ConversionOptions& o) const {
  for (std::size_t d = 0; d < std::min<std::size_t>(2, f.catalog.axes.size()); ++d)
    o.axes.push_back({f.catalog.axes[ix(axes_[d])].name, per_unit_[d].value()});
  if (unit_ >= 0) o.drawing_unit = file_units[ix(unit_)];
  using Origin = drawing::Placing::Origin;
  o.placing.origin = std::array{Origin::as_drawn, Origin::lower_left, Origin::point}[ix(origin_)];
  o.placing.point = point_;
  o.placing.swapped = swap_, o.placing.mirrored_x = flip_x_, o.placing.mirrored_y = flip_y_;
  if (tolerance_.value() > 0) o.tolerance = tolerance_.value();
  o.touching = join_.value();
  const auto& [left, right, bottom, top] = table_;
  if (right.value() <= left.value() || top.value() <= bottom.value()) return;
  o.table.emplace();
  o.table->add({left.value(), bottom.value()});
  o.table->add({right.value(), top.value()});
}

// ---- drawing

bool DrawingPlace::draw(Frame& f, const drawing::Drawing* drawing) {
  Ui& ui = f.ui;
  section_title(ui, "Scale and place");
  bool changed = draw_unit(f, drawing);
  changed |= draw_axes(f);
  static constexpr std::array<std::string_view, 3> origins{"As drawn", "Corner", "By click"};
  if (const int picked = segment(ui, "drawing/origin", origins, origin_, {.cell_width = 80}); picked >= 0)
    origin_ = picked, changed = true;
  if (wants_origin()) wrapped(ui, Face::small, Tone::ink3, "Click the picture: that place comes to 0, 0.");
  gap(ui, 4);
  changed |= toggle_option(f, "drawing/swap", "Swap the axes", swap_);
  changed |= toggle_option(f, "drawing/flip_x", "Flip left and right", flip_x_);
  changed |= toggle_option(f, "drawing/flip_y", "Flip up and down", flip_y_);
  changed |= tolerance_.draw(f, "drawing/tolerance", "Tolerance", 0, "mm");
  const bool stairs = going_of(f.catalog) == drawing::Going::stairs;
  wrapped(ui, Face::small, Tone::ink3,
          stairs ? "One axis moves at a time: say how far the corners of the stairs may lie beside the line."
                 : "Of chords and curves; empty: half a step.");
  changed |= join_.draw(f, "drawing/join", "Join ends within", 0, "mm");
  changed |= draw_table(f);
  group_line(ui);
  return changed;
}

bool DrawingPlace::draw_unit(Frame& f, const drawing::Drawing* drawing) {
  Ui& ui = f.ui;
  const ImVec2 at = begin_option(ui, "File is in");
  int picked = -1;
  if (drawing && !drawing->unit.empty()) {
    const ImVec2 beside = ImGui::GetCursorScreenPos();
    ImGui::SetCursorScreenPos(ImVec2(beside.x, beside.y + ui.px(6)));
    named_text(ui, "drawing/file_unit", Face::body_bold, Tone::ink, drawing->unit);
  } else {
    picked = dropdown(ui, "drawing/unit", "Unit", file_units, unit_,
                      {.width = fill, .error = drawing && unit_ < 0, .none = "choose it"});
  }
  end_option(ui, at);
  if (picked >= 0) unit_ = picked;
  return picked >= 0;
}

bool DrawingPlace::draw_axes(Frame& f) {
  static constexpr std::array<const char*, 2> ids{"drawing/along_x", "drawing/along_y"};
  static constexpr std::array<const char*, 2> labels{"Its X goes along", "Its Y goes along"};
  bool changed = false;
  for (std::size_t d = 0; d < std::min(ids.size(), f.catalog.axes.size()); ++d) {
    const ImVec2 at = begin_option(f.ui, labels[d]);
    const int picked = dropdown(f.ui, ids[d], labels[d], axis_names_, axes_[d], {.width = fill});
    end_option(f.ui, at);
    if (picked >= 0 && picked != axes_[d]) {
      if (picked == axes_[1 - d]) take_axis(f, 1 - d, axes_[d]);
      take_axis(f, d, picked);
      changed = true;
    }
    const std::string_view name = f.catalog.axes[ix(axes_[d])].name;
    changed |= per_unit_[d].draw(f, Path("drawing/per_unit/{}", name),
                                 Path("{}/mm, {}", f.catalog.step_word, name), 1e-6, {});
  }
  return changed;
}

bool DrawingPlace::draw_table(Frame& f) {
  constexpr double furthest = -1e6;
  struct Side {
    const char *id, *label;
  };
  static constexpr std::array<Side, 4> sides{{{"drawing/table/left", "Table from X"},
                                              {"drawing/table/right", "to X"},
                                              {"drawing/table/bottom", "from Y"},
                                              {"drawing/table/top", "to Y"}}};
  bool changed = false;
  for (std::size_t i = 0; i < sides.size(); ++i)
    changed |= table_[i].draw(f, sides[i].id, sides[i].label, furthest, "mm");
  wrapped(f.ui, Face::small, Tone::ink3, "What leaves the table is named above. Empty: not checked.");
  return changed;
}

}  // namespace hw::panels
