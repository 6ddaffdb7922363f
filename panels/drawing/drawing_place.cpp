#include "panels/drawing/drawing_place.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/base/index.h"
#include "gui/model/kept_unit.h"
#include "gui/widgets/area.h"
#include "gui/widgets/choice.h"
#include "gui/widgets/text.h"
#include "panels/drawing/drawn_together.h"
#include "panels/widget_path.h"

namespace hw::panels {

using namespace gui;

static constexpr std::array<std::string_view, 7> file_units{"mm", "in", "cm", "m", "ft", "um", "mil"};

KeptScale kept_scale(const Frame& f, int axis) {
  const Tab& owner = owner_of(f, axis);
  const DisplayUnit unit =
      kept_unit(owner.catalog(), owner.settings.profile.axes[draws_together(f) ? 0 : ix(axis)]);
  const auto length = unit.real && unit.per_step != 0 ? millimetres(unit.name) : std::nullopt;
  return {length ? 1 / (std::abs(unit.per_step) * *length) : 0, unit.per_step < 0};
}

double steps_in_mm(const Frame& f, int axis) {
  const double kept = kept_scale(f, axis).steps_in_mm;
  return kept > 0 ? kept : 100;
}

/// The key in the file.
static std::string scale_id(const AxisInfo& axis) { return "drawing/per_unit/" + axis.name; }

static constexpr std::array<const char*, 2> along_ids{"drawing/along_x", "drawing/along_y"};
static constexpr std::array<const char*, 4> table_ids{"drawing/table/left", "drawing/table/right",
                                                      "drawing/table/bottom", "drawing/table/top"};

void DrawingPlace::begin(const Frame& f) {
  for (const AxisInfo& axis : f.catalog.axes) axis_names_.push_back(axis.name);
  scales_.resize(f.catalog.axes.size()), kept_.resize(f.catalog.axes.size());
  for (int form = 0; form < scale_forms; ++form)
    form_words_.push_back(words_of(static_cast<ScaleForm>(form), f.catalog.step_word));
  for (const Path& words : form_words_) form_names_.push_back(words);
  for (const std::size_t d : {0, 1}) take_axis(f, d, axes_[d]);
  join_.set(ConversionOptions().touching, 3);
  times_.set(1, 3);
}

void DrawingPlace::take_axis(const Frame& f, std::size_t direction, int axis) {
  axes_[direction] = axis;
  if (ix(axis) >= scales_.size()) return;
  kept_[ix(axis)] = kept_scale(f, axis).steps_in_mm;
  const double typed = kept_[ix(axis)] > 0 ? 0 : scales_[ix(axis)];
  per_unit_[direction].set(typed > 0 ? typed : steps_in_mm(f, axis), form_);
}

bool DrawingPlace::follow_units(const Frame& f) {
  bool changed = false;
  for (std::size_t d = 0; d < std::min(along_ids.size(), f.catalog.axes.size()); ++d) {
    const double kept = kept_scale(f, axes_[d]).steps_in_mm;
    if (kept == kept_[ix(axes_[d])] || !(kept > 0)) continue;
    take_axis(f, d, axes_[d]);
    changed = true;
  }
  return changed;
}

void DrawingPlace::put(const Frame& f, ConversionOptions& o) const {
  for (std::size_t d = 0; d < std::min<std::size_t>(2, f.catalog.axes.size()); ++d)
    o.axes.push_back({f.catalog.axes[ix(axes_[d])].name, per_unit_[d].value()});
  if (unit_ >= 0) o.drawing_unit = file_units[ix(unit_)];
  o.times = times_.value();
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

std::string DrawingPlace::wrong() const {
  return first_wrong({&times_, &per_unit_[0].field(), &per_unit_[1].field(), &tolerance_, &join_, &table_[0],
                      &table_[1], &table_[2], &table_[3]});
}

/// Warns if the table is incomplete, because it cannot be checked then.
std::string_view DrawingPlace::table_in_words() const {
  const auto& [left, right, bottom, top] = table_;
  const bool none = left.value() == 0 && right.value() == 0 && bottom.value() == 0 && top.value() == 0;
  if (!none && right.value() <= left.value())
    return "Enter a \"to X\" above \"from X\": the table is not checked.";
  if (!none && top.value() <= bottom.value())
    return "Enter a \"to Y\" above \"from Y\": the table is not checked.";
  return "Lines that leave the table are named above.\nEmpty: not checked.";
}

// ---- kept

void DrawingPlace::keep(const Frame& f, KeptOptions& kept) const {
  for (std::size_t i = 0; i < scales_.size(); ++i)
    if (scales_[i] > 0) kept.numbers[scale_id(f.catalog.axes[i])] = scales_[i];
  for (std::size_t d = 0; d < std::min(along_ids.size(), f.catalog.axes.size()); ++d) {
    const AxisInfo& axis = f.catalog.axes[ix(axes_[d])];
    kept.words[along_ids[d]] = axis.name;
    kept.numbers[scale_id(axis)] = per_unit_[d].value();
  }
  kept.numbers["drawing/scale_as"] = static_cast<int>(form_);
  kept.numbers["drawing/swap"] = swap_ ? 1 : 0;
  kept.numbers["drawing/flip_x"] = flip_x_ ? 1 : 0, kept.numbers["drawing/flip_y"] = flip_y_ ? 1 : 0;
  kept.numbers["drawing/join"] = join_.value();
  for (std::size_t i = 0; i < table_.size(); ++i) kept.numbers[table_ids[i]] = table_[i].value();
}

void DrawingPlace::take(const Frame& f, const KeptOptions& kept) {
  for (std::size_t i = 0; i < scales_.size(); ++i)
    if (const double* scale = kept.number(scale_id(f.catalog.axes[i]))) scales_[i] = *scale;
  if (const double* form = kept.number("drawing/scale_as"); form && *form >= 0 && *form < scale_forms)
    form_ = static_cast<ScaleForm>(static_cast<int>(*form));
  std::array<int, 2> axes = axes_;
  for (const std::size_t d : {0, 1})
    if (const std::string* name = kept.word(along_ids[d]))
      if (const int axis = f.catalog.find_axis(*name); axis >= 0) axes[d] = axis;
  for (std::size_t d = 0; axes[0] != axes[1] && d < std::min<std::size_t>(2, f.catalog.axes.size()); ++d)
    take_axis(f, d, axes[d]);
  for (auto [id, option] : {std::pair{"drawing/swap", &swap_}, std::pair{"drawing/flip_x", &flip_x_},
                            std::pair{"drawing/flip_y", &flip_y_}})
    if (const double* on = kept.number(id)) *option = *on != 0;
  if (const double* join = kept.number("drawing/join"); join && *join >= 0) join_.set(*join, 3);
  for (std::size_t i = 0; i < table_.size(); ++i)
    if (const double* side = kept.number(table_ids[i]); side && *side != 0) table_[i].set(*side, 3);
}

// ---- drawing

bool DrawingPlace::draw(Frame& f, const drawing::Drawing* drawing) {
  Ui& ui = f.ui;
  section_title(ui, "Scale and place");
  bool changed = draw_unit(f, drawing);
  changed |= times_.draw(f, "drawing/times", "Times", 1e-6, {});
  changed |= draw_axes(f);
  static constexpr std::array<std::string_view, 3> origins{"As drawn", "Corner", "By click"};
  if (const int picked = segment(ui, "drawing/origin", origins, origin_, {.cell_width = 80}); picked >= 0)
    origin_ = picked, changed = true;
  if (wants_origin())
    wrapped(ui, Face::small, Tone::ink3, "Click a point of the picture to place it at 0, 0.");
  gap(ui, 4);
  changed |= toggle_option(f, "drawing/swap", "Swap the axes", swap_);
  changed |= toggle_option(f, "drawing/flip_x", "Flip left and right", flip_x_);
  changed |= toggle_option(f, "drawing/flip_y", "Flip up and down", flip_y_);
  changed |= tolerance_.draw(f, "drawing/tolerance", "Tolerance", 0, "mm");
  const bool stairs = curve_mode_of(f.catalog) == drawing::CurveMode::stairs;
  wrapped(
      ui, Face::small, stairs && !(tolerance_.value() > 0) ? Tone::warn : Tone::ink3,
      stairs
          ? "Give the largest distance of the stairs from the line: this controller moves one axis at a time."
          : "Largest distance of chords from their curves. Empty: half a step.");
  changed |= join_.draw(f, "drawing/join", "Join ends within", 0, "mm");
  changed |= draw_table(f);
  group_line(ui);
  return changed;
}

/// The file's unit is above the other units, and applies until the user overrides it.
bool DrawingPlace::draw_unit(Frame& f, const drawing::Drawing* drawing) {
  Ui& ui = f.ui;
  const bool file_has_unit = drawing && !drawing->unit.empty();
  const Path sentence("{}, by the file", file_has_unit ? drawing->unit : "");
  if (units_.empty() || (file_has_unit ? unit_of_file_ != sentence.view() : !unit_of_file_.empty())) {
    unit_of_file_ = file_has_unit ? sentence.view() : std::string_view();
    units_.assign(file_units.begin(), file_units.end());
    if (file_has_unit) units_.insert(units_.begin(), unit_of_file_);
  }
  const int before = file_has_unit ? 1 : 0;
  const int chosen = unit_ >= 0 ? unit_ + before : file_has_unit ? 0 : -1;
  const ImVec2 at = begin_option(ui, "File is in");
  const int picked = dropdown(ui, "drawing/unit", "Unit", units_, chosen,
                              {.width = fill, .error = drawing && chosen < 0, .none = "choose it"});
  end_option(ui, at);
  if (picked < 0 || picked == chosen) return false;
  unit_ = picked - before;
  return true;
}

bool DrawingPlace::draw_axes(Frame& f) {
  static constexpr std::array<const char*, 2> labels{"Its X goes along", "Its Y goes along"};
  bool changed = false;
  for (std::size_t d = 0; d < std::min(along_ids.size(), f.catalog.axes.size()); ++d) {
    const ImVec2 at = begin_option(f.ui, labels[d]);
    const int picked = dropdown(f.ui, along_ids[d], labels[d], axis_names_, axes_[d], {.width = fill});
    end_option(f.ui, at);
    if (picked >= 0 && picked != axes_[d]) {
      if (picked == axes_[1 - d]) take_axis(f, 1 - d, axes_[d]);
      take_axis(f, d, picked);
      changed = true;
    }
    const std::string_view name = f.catalog.axes[ix(axes_[d])].name;
    const bool typed = per_unit_[d].draw(f, Path("drawing/per_unit/{}", name), name);
    if (typed) scales_[ix(axes_[d])] = per_unit_[d].value();
    changed |= typed;
  }
  changed |= draw_scale_form(f);
  for (std::size_t d = 0; d < std::min(along_ids.size(), f.catalog.axes.size()); ++d)
    if (kept_scale(f, axes_[d]).opposite) draw_mirrored(f, f.catalog.axes[ix(axes_[d])].name);
  return changed;
}

void DrawingPlace::draw_mirrored(Frame& f, std::string_view axis) {
  const Path why("Flip the drawing: {} counts opposite to its {}, so it would be mirrored.", axis,
                 f.catalog.step_word);
  const Path id("drawing/mirrored/{}", axis);
  const ImVec2 from = ImGui::GetCursorScreenPos();
  wrapped(f.ui, Face::small, Tone::warn, why);
  show(f.ui, {id, Kind::text, "Mirrored", why}, {from, ImGui::GetCursorScreenPos()});
}

bool DrawingPlace::draw_scale_form(Frame& f) {
  const ImVec2 at = begin_option(f.ui, "Scale in");
  const int picked =
      dropdown(f.ui, "drawing/scale_as", "Scale in", form_names_, static_cast<int>(form_), {.width = fill});
  end_option(f.ui, at);
  if (picked < 0) return false;
  form_ = static_cast<ScaleForm>(picked);
  for (ScaleOption& scale : per_unit_) scale.set(scale.value(), form_);
  return true;
}

bool DrawingPlace::draw_table(Frame& f) {
  constexpr double furthest = -1e6;
  static constexpr std::array<const char*, 4> labels{"Table from X", "to X", "from Y", "to Y"};
  bool changed = false;
  for (std::size_t i = 0; i < table_ids.size(); ++i)
    changed |= table_[i].draw(f, table_ids[i], labels[i], furthest, "mm");
  const std::string_view why = table_in_words();  // keeps the larger height, so that nothing below moves
  const bool begun = why.starts_with("Enter");
  const ImVec2 from = ImGui::GetCursorScreenPos();
  wrapped(f.ui, Face::small, begun ? Tone::warn : Tone::ink3, why);
  if (begun)
    show(f.ui, {"drawing/table/unchecked", Kind::text, "Table", why}, {from, ImGui::GetCursorScreenPos()});
  return changed;
}

}  // namespace hw::panels
