#include "panels/drawing_options.h"

#include <algorithm>
#include <cmath>

#include "core/base/index.h"
#include "gui/area.h"
#include "gui/tab.h"
#include "gui/widgets/button.h"
#include "gui/widgets/choice.h"
#include "gui/widgets/lamp.h"
#include "gui/widgets/text.h"
#include "panels/path.h"

namespace hw::panels {

using namespace gui;
namespace {

constexpr std::array<std::string_view, 4> file_units{"mm", "in", "cm", "m"};
constexpr float option_label = 116;

/// What an option is called; the cursor then stands where it is chosen. Returns where its row begins.
ImVec2 begin_option(Ui& ui, std::string_view label) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  draw_text_line(ui, at.x, at.x + ui.px(option_label - 4), at.y + ui.px(16), Face::body, ui[Tone::ink2],
                 label);
  ImGui::SetCursorScreenPos(ImVec2(at.x + ui.px(option_label), at.y));
  return at;
}

}  // namespace

void DrawingOptions::begin(const Frame& f) {
  if (std::exchange(begun_, true)) return;
  tool_names_.push_back("none");
  for (const OutputInfo& output : f.catalog.outputs) tool_names_.push_back(output.name);
  for (const AxisInfo& axis : f.catalog.axes) axis_names_.push_back(axis.name);
  for (const std::size_t direction : {0, 1}) take_scale(f, direction);
  set(wait_on, 0, 0), set(wait_off, 0, 0);
  set(cut_speed, 5, 1), set(travel_speed, 10, 1);
  if (going_of(f.catalog) == drawing::Going::stairs) set(tolerance, 0.1, 3);
}

/// Of the axis that goes this way, as the units of the console have it.
void DrawingOptions::take_scale(const Frame& f, std::size_t direction) {
  const DisplayUnit& unit = f.tab.unit(AxisId{static_cast<std::uint8_t>(axes_[direction])});
  const bool known = unit.real && unit.name == "mm" && unit.per_step > 0;
  set(direction == 0 ? per_unit_x : per_unit_y, known ? 1 / unit.per_step : 100, 3);
  changed_ = true;
}

void DrawingOptions::set(Number which, double value, int decimals) {
  fields_[which].set(value, decimals);
  values_[which] = value;
}

void DrawingOptions::draw(Frame& f, const drawing::Drawing* drawing) {
  draw_place(f, drawing);
  draw_tool(f);
  if (drawing) draw_layers(f, *drawing);
}

void DrawingOptions::settle(const Frame& f, const drawing::Drawing* drawing) {
  if (std::exchange(changed_, false)) build(f, drawing);
}

void DrawingOptions::build(const Frame& f, const drawing::Drawing* drawing) {
  ConversionOptions o;
  const std::array per_unit{values_[per_unit_x], values_[per_unit_y]};
  for (std::size_t i = 0; i < std::min<std::size_t>(2, f.catalog.axes.size()); ++i)
    o.axes.push_back({f.catalog.axes[ix(axes_[i])].name, per_unit[i]});
  o.drawing_unit = file_units[ix(unit_)];
  using Origin = drawing::Placing::Origin;
  o.placing.origin = std::array{Origin::as_drawn, Origin::lower_left, Origin::point}[ix(origin_)];
  o.placing.point = point_;
  if (values_[table_right] > values_[table_left] && values_[table_top] > values_[table_bottom]) {
    o.table.emplace();
    o.table->add({values_[table_left], values_[table_bottom]});
    o.table->add({values_[table_right], values_[table_top]});
  }
  o.placing.swapped = swap_, o.placing.mirrored_x = flip_x_, o.placing.mirrored_y = flip_y_;
  if (values_[tolerance] > 0) o.tolerance = values_[tolerance];
  o.keep_order = keep_order_;
  o.cutting.high = values_[cut_speed], o.travel.high = values_[travel_speed];
  if (tool_ > 0) {
    const int output = f.catalog.output_number(ix(tool_ - 1));
    o.pen_down.push_back({sequence::Output{output, true}});
    o.pen_up.push_back({sequence::Output{output, false}});
    if (values_[wait_on] > 0) o.pen_down.push_back({sequence::Delay{values_[wait_on]}});
    if (values_[wait_off] > 0) o.pen_up.push_back({sequence::Delay{values_[wait_off]}});
  }
  if (drawing && !left_out_.empty())
    for (const drawing::Layer& layer : drawing->layers)
      if (layer.shown && std::find(left_out_.begin(), left_out_.end(), layer.name) == left_out_.end())
        o.layers.push_back(layer.name);
  wanted_ = std::move(o);
  ++version_;
}

// ---- drawing

void DrawingOptions::number(Frame& f, Number which, std::string_view id, std::string_view label, double least,
                            std::string_view unit) {
  Ui& ui = f.ui;
  const ImVec2 at = begin_option(ui, label);
  NumberField& field = fields_[which];
  NumberOptions o;
  o.range = {least, 1e9, 6, unit};
  o.sentence_below = false;
  if (!field.sentence.empty()) o.tip = field.sentence;
  const NumberEvent event = number_field(ui, id, label, std::nullopt, field, o);
  if (event.field.entered || event.field.left) {
    const auto typed = field.value();
    const bool emptied = field.text.empty() && least <= 0;
    // What is no number leaves the one before: nothing is converted by a scale that nobody has meant.
    if (emptied || (typed && *typed >= least)) values_[which] = emptied ? 0 : *typed, changed_ = true;
  }
  ImGui::SetCursorScreenPos(ImVec2(at.x, at.y + ui.px(36)));
}

void DrawingOptions::toggle(Frame& f, const char* id, const char* label, bool& value) {
  ToggleOptions o;
  o.state = value ? ToggleState::on : ToggleState::off;
  if (toggle_lamp(f.ui, id, label, o).clicked) value = !value, changed_ = true;
  gap(f.ui, 4);
}

void DrawingOptions::draw_place(Frame& f, const drawing::Drawing* drawing) {
  Ui& ui = f.ui;
  section_title(ui, "Scale and place");
  const ImVec2 at = begin_option(ui, "File is in");
  if (drawing && !drawing->unit.empty()) {
    ImGui::SetCursorScreenPos(ImVec2(at.x + ui.px(option_label), at.y + ui.px(6)));
    named_text(ui, "drawing/file_unit", Face::body_bold, Tone::ink, drawing->unit);
  } else if (const int picked = dropdown(ui, "drawing/unit", "Unit", file_units, unit_, {.width = fill});
             picked >= 0) {
    unit_ = picked, changed_ = true;
  }
  ImGui::SetCursorScreenPos(ImVec2(at.x, at.y + ui.px(36)));
  draw_axes(f);
  static constexpr std::array<std::string_view, 3> origins{"As drawn", "Corner", "By click"};
  if (const int picked = segment(ui, "drawing/origin", origins, origin_, {.cell_width = 80}); picked >= 0)
    origin_ = picked, changed_ = true;
  if (wants_origin()) wrapped(ui, Face::small, Tone::ink3, "Click the picture: that place comes to 0, 0.");
  gap(ui, 4);
  toggle(f, "drawing/swap", "Swap the axes", swap_);
  toggle(f, "drawing/flip_x", "Flip left and right", flip_x_);
  toggle(f, "drawing/flip_y", "Flip up and down", flip_y_);
  number(f, tolerance, "drawing/tolerance", "Tolerance", 0, "mm");
  const bool stairs = going_of(f.catalog) == drawing::Going::stairs;
  wrapped(ui, Face::small, Tone::ink3,
          stairs ? "One axis moves at a time: how far the corners of the stairs may lie beside the line."
                 : "Of chords and curves; empty: half a step.");
  draw_table(f);
  group_line(ui);
}

void DrawingOptions::draw_axes(Frame& f) {
  Ui& ui = f.ui;
  struct Direction {
    const char *id, *label;
    Number field;
  };
  static constexpr std::array<Direction, 2> directions{{{"drawing/along_x", "Its X goes along", per_unit_x},
                                                        {"drawing/along_y", "Its Y goes along", per_unit_y}}};
  for (std::size_t d = 0; d < std::min(directions.size(), f.catalog.axes.size()); ++d) {
    const ImVec2 at = begin_option(ui, directions[d].label);
    const int picked =
        dropdown(ui, directions[d].id, directions[d].label, axis_names_, axes_[d], {.width = fill});
    if (picked >= 0 && picked != axes_[d]) {
      const int other = axes_[1 - d];
      if (picked == other) axes_[1 - d] = axes_[d], take_scale(f, 1 - d);
      axes_[d] = picked, take_scale(f, d);
    }
    ImGui::SetCursorScreenPos(ImVec2(at.x, at.y + ui.px(36)));
    const std::string_view name = f.catalog.axes[ix(axes_[d])].name;
    number(f, directions[d].field, Path("drawing/per_unit/{}", name),
           Path("{}/mm, {}", f.catalog.step_word, name), 1e-6, {});
  }
}

void DrawingOptions::draw_table(Frame& f) {
  constexpr double furthest = -1e6;
  number(f, table_left, "drawing/table/left", "Table from X", furthest, "mm");
  number(f, table_right, "drawing/table/right", "to X", furthest, "mm");
  number(f, table_bottom, "drawing/table/bottom", "from Y", furthest, "mm");
  number(f, table_top, "drawing/table/top", "to Y", furthest, "mm");
  wrapped(f.ui, Face::small, Tone::ink3, "What leaves the table is named above. Empty: not checked.");
}

void DrawingOptions::draw_tool(Frame& f) {
  Ui& ui = f.ui;
  section_title(ui, "Tool and speeds");
  const ImVec2 at = begin_option(ui, "Output");
  if (const int picked = dropdown(ui, "drawing/tool", "Output", tool_names_, tool_, {.width = fill});
      picked >= 0)
    tool_ = picked, changed_ = true;
  ImGui::SetCursorScreenPos(ImVec2(at.x, at.y + ui.px(36)));
  if (tool_ > 0) {
    number(f, wait_on, "drawing/wait_on", "Wait when on", 0, "ms");
    number(f, wait_off, "drawing/wait_off", "Wait when off", 0, "ms");
    wrapped(ui, Face::small, Tone::warn,
            "A stop ends the motion and leaves the output as it is: switch it off by hand.");
    gap(ui, 4);
  }
  number(f, cut_speed, "drawing/cut_speed", "Tool on", 0, "mm/s");
  number(f, travel_speed, "drawing/travel_speed", "Tool off", 0, "mm/s");
  toggle(f, "drawing/keep_order", "Keep the order of the file", keep_order_);
  group_line(ui);
}

void DrawingOptions::draw_layers(Frame& f, const drawing::Drawing& drawing) {
  section_title(f.ui, "Layers");
  for (const drawing::Layer& layer : drawing.layers) {
    const auto found = std::find(left_out_.begin(), left_out_.end(), layer.name);
    ToggleOptions o;
    o.state = layer.shown && found == left_out_.end() ? ToggleState::on : ToggleState::off;
    o.word = o.state == ToggleState::on ? "drawn" : "left out";
    if (!layer.shown) o.disabled = "It is frozen or off in the file.";
    const Path id("drawing/layer/{}", layer.name);
    if (toggle_lamp(f.ui, id, layer.name.empty() ? std::string_view("without a name") : layer.name, o)
            .clicked) {
      if (found == left_out_.end())
        left_out_.push_back(layer.name);
      else
        left_out_.erase(found);
      changed_ = true;
    }
    gap(f.ui, 4);
  }
  group_line(f.ui);
}

}  // namespace hw::panels
