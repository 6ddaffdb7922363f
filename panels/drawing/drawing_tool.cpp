#include "panels/drawing/drawing_tool.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "core/base/index.h"
#include "gui/widgets/area.h"
#include "gui/widgets/choice.h"
#include "gui/widgets/text.h"
#include "gui/widgets/text_field.h"
#include "panels/drawing/drawn_together.h"
#include "panels/widget_path.h"

namespace hw::panels {

using namespace gui;

const std::array<DrawingTool::Named, 8> DrawingTool::numbers{
    {{"drawing/tool_axis/down", &DrawingTool::down_},
     {"drawing/tool_axis/up", &DrawingTool::up_},
     {"drawing/wait_on", &DrawingTool::wait_on_},
     {"drawing/wait_off", &DrawingTool::wait_off_},
     {"drawing/cut_speed", &DrawingTool::cut_speed_},
     {"drawing/travel_speed", &DrawingTool::travel_speed_},
     {"drawing/low_speed", &DrawingTool::low_speed_},
     {"drawing/ramp", &DrawingTool::ramp_}}};
static constexpr std::string_view cut_speed_name = "Speed, tool on", travel_speed_name = "Speed, tool off";
static constexpr const char* scale_of_tool = "drawing/tool_axis/per_unit";
static constexpr std::array<const char*, 2> routine_ids{"drawing/routine/on", "drawing/routine/off"};

void DrawingTool::begin(const Frame& f) {
  output_names_.push_back("none");
  for (const OutputInfo& output : f.catalog.outputs) output_names_.push_back(output.name);
  wait_on_.set(0, 0), wait_off_.set(0, 0);
  down_.set(0, 3), up_.set(5, 3);
  cut_speed_.set(5, 1), travel_speed_.set(10, 1);
  kept_.resize(f.catalog.axes.size());
  follow_units(f);
}

bool DrawingTool::follow_units(const Frame& f) {
  bool changed = false;
  for (std::size_t i = 0; i < kept_.size(); ++i) {
    const int axis = static_cast<int>(i);
    const KeptScale now = kept_scale(f, axis);
    if (now == kept_[i]) continue;
    if (axis == axis_ && now.steps_in_mm > 0) per_unit_.set(now.steps_in_mm, form_);
    kept_[i] = now;
    changed = true;
  }
  return changed;
}

void DrawingTool::put(const Frame& f, ConversionOptions& o) {
  const auto speeds = [&](const NumberOption& high) {
    return high.value() > 0 ? sequence::Speeds{high.value(), low_speed_.value(), ramp_.value()}
                            : sequence::Speeds();
  };
  o.cutting = speeds(cut_speed_), o.travel = speeds(travel_speed_);
  o.cutting_name = fmt::format("\"{}\"", cut_speed_name);
  o.travel_name = fmt::format("\"{}\"", travel_speed_name);
  wrong_.clear();
  if (own_)
    put_routines(f, o);
  else
    put_choices(f, o);
  describe_turned(f, o);
}

/// Numbers here have the sign that is shown for the axis.
static double turned(double steps_in_mm, const KeptScale& kept) {
  return kept.opposite ? -steps_in_mm : steps_in_mm;
}

void DrawingTool::describe_turned(const Frame& f, const ConversionOptions& o) {
  turned_.clear();
  for (std::size_t a = 2; a < o.axes.size(); ++a) {
    const int axis = f.catalog.find_axis(o.axes[a].name);
    if (axis < 0 || !kept_[ix(axis)].opposite) continue;
    turned_ += fmt::format("{}{} counts opposite to its {}: 1 mm here is at {:.6g} {}.",
                           turned_.empty() ? "" : " ", o.axes[a].name, f.catalog.step_word,
                           turned(o.axes[a].per_unit, kept_[ix(axis)]), f.catalog.step_word);
  }
}

void DrawingTool::put_routines(const Frame& f, ConversionOptions& o) {
  const PerUnit per_unit = [&](const std::string& name) {
    const int axis = f.catalog.find_axis(name);
    return turned(axis == axis_ ? per_unit_.value() : steps_in_mm(f, axis), kept_[ix(axis)]);
  };
  for (auto [routine, steps] : {std::pair{0, &o.pen_down}, std::pair{1, &o.pen_up}}) {
    auto read = read_routine(routines_[ix(routine)], f.catalog, per_unit, o.axes);
    if (read)
      *steps = std::move(*read);
    else if (wrong_.empty())
      wrong_ = read.error().sentence();
  }
  const auto back = switches_back(o.pen_down, o.pen_up, f.catalog);
  if (!back && wrong_.empty()) wrong_ = back.error().sentence();
}

PlainTool DrawingTool::tool(const Frame& f) const {
  PlainTool tool;
  if (axis_ >= 0) {
    tool.axis = f.catalog.axes[ix(axis_)].name, tool.per_unit = per_unit_.value();
    tool.down = down_.value(), tool.up = up_.value();
  }
  if (output_ > 0) tool.output = f.catalog.output_number(ix(output_ - 1));
  tool.down_delay_ms = wait_on_.value(), tool.up_delay_ms = wait_off_.value();
  return tool;
}

void DrawingTool::put_choices(const Frame& f, ConversionOptions& o) const {
  PlainTool turned_round = tool(f);
  if (axis_ >= 0) turned_round.per_unit = turned(turned_round.per_unit, kept_[ix(axis_)]);
  put_tool(turned_round, o.axes, o.pen_down, o.pen_up);
}

std::string DrawingTool::wrong() const {
  if (own_ && !wrong_.empty()) return wrong_;
  std::string why = first_wrong({&cut_speed_, &travel_speed_, &low_speed_, &ramp_});
  if (own_ || !why.empty()) return why;
  if (axis_ >= 0) why = first_wrong({&per_unit_.field(), &down_, &up_});
  return why.empty() && (output_ > 0 || axis_ >= 0) ? first_wrong({&wait_on_, &wait_off_}) : why;
}

// ---- kept

void DrawingTool::keep(const Frame& f, KeptOptions& kept) const {
  for (const Named& n : numbers) kept.numbers[n.id] = (this->*n.option).value();
  kept.numbers[scale_of_tool] = per_unit_.value();
  kept.words["drawing/tool"] = output_names_[ix(output_)];
  kept.words["drawing/tool_axis"] = axis_ < 0 ? "none" : f.catalog.axes[ix(axis_)].name;
  kept.numbers["drawing/own_routines"] = own_ ? 1 : 0;
  for (const std::size_t i : {0, 1}) kept.words[routine_ids[i]] = routines_[i];
}

void DrawingTool::take(const Frame& f, const KeptOptions& kept) {
  for (const Named& n : numbers)
    if (const double* number = kept.number(n.id))
      if (*number != 0 || (this->*n.option).value() != 0) (this->*n.option).set(*number, 3);
  if (const std::string* output = kept.word("drawing/tool")) {
    const auto found = std::find(output_names_.begin(), output_names_.end(), *output);
    if (found != output_names_.end()) output_ = static_cast<int>(found - output_names_.begin());
  }
  if (const std::string* axis = kept.word("drawing/tool_axis")) axis_ = f.catalog.find_axis(*axis);
  const double* scale = kept.number(scale_of_tool);
  const double by_unit = axis_ >= 0 ? kept_scale(f, axis_).steps_in_mm : 0;
  if (scale && *scale > 0 && !(by_unit > 0))
    per_unit_.set(*scale, form_);
  else if (axis_ >= 0)
    per_unit_.set(steps_in_mm(f, axis_), form_);
  if (const double* own = kept.number("drawing/own_routines")) own_ = *own != 0;
  for (const std::size_t i : {0, 1})
    if (const std::string* routine = kept.word(routine_ids[i])) routines_[i] = *routine;
}

// ---- drawing

bool DrawingTool::draw(Frame& f, const std::array<int, 2>& drawing_axes, ScaleForm form) {
  Ui& ui = f.ui;
  if (std::exchange(form_, form) != form) per_unit_.set(per_unit_.value(), form);
  section_title(ui, "Tool and speeds");
  list_axes(f, drawing_axes);
  const bool draws = axis_ >= 0 && std::find(axes_.begin(), axes_.end(), axis_) == axes_.end();
  if (draws) axis_ = -1;  // the axis was chosen for drawing since
  bool changed = draws;
  if (toggle_option(f, "drawing/own_routines", "Routines of my own", own_)) {
    if (own_) begin_routines(f, drawing_axes);
    changed = true;
  }
  changed |= own_ ? draw_routines(f) : draw_choices(f);
  changed |= draw_speeds(f);
  return changed;
}

bool DrawingTool::draw_speeds(Frame& f) {
  bool changed = cut_speed_.draw(f, "drawing/cut_speed", cut_speed_name, 0, "mm/s");
  changed |= travel_speed_.draw(f, "drawing/travel_speed", travel_speed_name, 0, "mm/s");
  changed |= low_speed_.draw(f, "drawing/low_speed", "Ramps begin at", 0, "mm/s");
  changed |= ramp_.draw(f, "drawing/ramp", "A ramp takes", 0, "ms");
  wrapped(f.ui, Face::small, Tone::ink3, "Both speeds empty: as set in the controller.");
  gap(f.ui, 4);
  return changed;
}

bool DrawingTool::draw_choices(Frame& f) {
  Ui& ui = f.ui;
  bool changed = false;
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
  return changed;
}

/// Begins routines with the choices made so far.
void DrawingTool::begin_routines(const Frame& f, const std::array<int, 2>& drawing_axes) {
  if (!routines_[0].empty() || !routines_[1].empty()) return;
  ConversionOptions chosen;
  for (const int axis : drawing_axes)
    if (ix(axis) < f.catalog.axes.size()) chosen.axes.push_back({f.catalog.axes[ix(axis)].name, 1});
  put_tool(tool(f), chosen.axes, chosen.pen_down, chosen.pen_up);
  routines_ = {write_routine(chosen.pen_down, f.catalog, chosen.axes),
               write_routine(chosen.pen_up, f.catalog, chosen.axes)};
}

bool DrawingTool::draw_routines(Frame& f) {
  Ui& ui = f.ui;
  static constexpr std::array<const char*, 2> labels{"To switch the tool on", "To switch it off"};
  bool changed = false;
  for (std::size_t i = 0; i < routine_ids.size(); ++i) {
    text(ui, Face::body, Tone::ink2, labels[i]);
    FieldOptions o;
    o.face = Face::code_field;
    o.placeholder = "nothing";
    o.tip = "Steps in their order: an axis to a place (mm), an output on or off, wait a time (ms).";
    const Field field = text_field(ui, routine_ids[i], labels[i], routines_[i], o);
    changed |= field.entered || field.left;
    gap(ui, 4);
  }
  draw_turned(f);
  if (wrong_.empty()) return changed;
  const ImVec2 from = ImGui::GetCursorScreenPos();
  wrapped(ui, Face::small, Tone::fault, wrong_);
  show(ui, {"drawing/routine/wrong", Kind::text, "Routine", wrong_}, {from, ImGui::GetCursorScreenPos()});
  gap(ui, 4);
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
    if (axis_ >= 0) per_unit_.set(steps_in_mm(f, axis_), form_);
  }
  if (axis_ < 0) return changed;
  changed |= per_unit_.draw(f, scale_of_tool, f.catalog.axes[ix(axis_)].name);
  changed |= down_.draw(f, "drawing/tool_axis/down", "Down at", furthest, "mm");
  changed |= up_.draw(f, "drawing/tool_axis/up", "Up at", furthest, "mm");
  draw_turned(f);
  return changed;
}

void DrawingTool::draw_turned(Frame& f) const {
  if (turned_.empty()) return;
  const ImVec2 from = ImGui::GetCursorScreenPos();
  wrapped(f.ui, Face::small, Tone::warn, turned_);
  show(f.ui, {"drawing/tool/turned", Kind::text, "Counts opposite", turned_},
       {from, ImGui::GetCursorScreenPos()});
  gap(f.ui, 4);
}

}  // namespace hw::panels
