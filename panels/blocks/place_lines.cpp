// Draws the lines of a form about axes and places.
#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "core/base/index.h"
#include "gui/widgets/choice.h"
#include "gui/widgets/text.h"
#include "panels/blocks/block_measures.h"
#include "panels/blocks/field_lines.h"
#include "panels/widget_path.h"

namespace hw::panels {

using namespace gui;

constexpr float place_cell = 148;

void FieldLines::places(std::string_view key, sequence::Places& value) {
  constexpr float letter = 24;
  const std::size_t in_line = places_in_line();
  for (std::size_t first = 0; first < of_.axes.size(); first += in_line) {
    const std::size_t behind = std::min(first + in_line, of_.axes.size());
    const ImVec2 at = ImGui::GetCursorScreenPos();
    for (std::size_t a = first; a < behind; ++a) {
      const bool alone = in_line == 1;
      const ImVec2 corner(at.x + f_.ui.px(place_cell * static_cast<float>(a - first)), at.y);
      begin_at(corner, of_.axes[a].name, alone ? field_label_width : letter);
      place(key, a, value[a], alone ? 120 : place_cell - letter - 8, alone);
    }
    ImGui::SetCursorScreenPos(ImVec2(at.x, at.y + f_.ui.px(field_line_height)));
    for (std::size_t a = first; a < behind; ++a) show_place_refused(key, a, value[a]);
  }
}

void FieldLines::plane(std::string_view key, sequence::Plane& value) {
  if (of_.axes.size() < 3) return;
  const sequence::Plane before = value;
  choose_axis(Path("{}/1", key), value.right, false);
  choose_axis(Path("{}/2", key), value.up, false);
  if (value == before) return;
  if (value.right == value.up)  // swap the axes
    (value.right == before.right ? value.right : value.up) =
        value.right == before.right ? before.up : before.right;
  for (const std::string_view place : {"x", "y"})  // in the unit of the other axes
    numbers_.erase(std::string(Path("{}/{}", path_, place).view()));
}

std::size_t FieldLines::places_in_line() const {
  return of_.axes.size() < 3 ? 1 : std::max(ix(static_cast<int>(width_ / place_cell)), ix(1));
}

void FieldLines::place(std::string_view key, std::size_t a, std::optional<double>& value, float width,
                       bool alone) {
  const Path below("{}/{}", key, of_.axes[a].name), id("{}/{}", path_, below.view());
  const sequence::Scale& scale = step_.look.axes[a];
  const ImVec2 at = ImGui::GetCursorScreenPos();
  NumberField& state = kept(id, value, scale);
  NumberOptions o;
  o.range = place_range(scale);
  o.width = width;
  o.sentence_below = false;
  if (state.text.empty()) state.sentence.clear();
  const std::string refused = why_no_place(state, scale);
  o.refused = is_refused(below) ? std::string_view(step_.refused->why) : refused;
  const NumberEvent event = number_field(f_.ui, id, of_.axes[a].name, std::nullopt, state, o);
  if (alone) show_refusal(at, width, FixedText<64>(of_.axes[a].name), refused);
  if (!event.field.edited) return;
  const auto typed = state.value();
  if (!state.text.empty() && !(typed && range_sentence(state.text, o.range).empty())) return;
  const auto now = typed ? std::optional(scale.kept(*typed)) : std::nullopt;
  changed_ = changed_ || now != value;
  value = now;
}

NumberRange FieldLines::place_range(const sequence::Scale& scale) {
  return {-1e9, 1e9, scale.decimals, scale.unit};
}

std::string FieldLines::why_no_place(const NumberField& state, const sequence::Scale& scale) {
  return state.text.empty() ? std::string() : range_sentence(state.text, place_range(scale));
}

void FieldLines::show_place_refused(std::string_view key, std::size_t a, std::optional<double>& value) {
  const Path below("{}/{}", key, of_.axes[a].name);
  const sequence::Scale& scale = step_.look.axes[a];
  if (places_in_line() > 1)
    if (const std::string why = why_no_place(kept(Path("{}/{}", path_, below.view()), value, scale), scale);
        !why.empty()) {
      problem_ = fmt::format("{}: {}{}", of_.axes[a].name, why, why.back() == '.' ? "" : ".");
      wrapped(f_.ui, Face::small, Tone::fault, problem_, width_);
      gap(f_.ui, 4);
    }
  show_refused(below);
  if (double nearest = 0; offers_nearest(below, scale, nearest)) value = nearest;
}

void FieldLines::choose_axis(std::string_view key, int& value, bool or_all) {
  std::array<std::string_view, max_axes + 1> names;
  std::size_t many = 0;
  for (const sequence::Axis& axis : of_.axes)
    if (many < max_axes) names[many++] = axis.name;
  if (or_all) names[many++] = "all";
  const int last = static_cast<int>(many) - 1;
  const std::span<const std::string_view> shown(names.data(), many);
  const ImVec2 at = begin(key);
  constexpr float cell = 36;
  const bool in_a_row =
      static_cast<float>(many) * cell <= width_ - field_label_width;  // eight axes do not fit
  const Path id("{}/{}", path_, key);
  const int picked = in_a_row ? segment(f_.ui, id, shown, value < 0 ? last : value, {.cell_width = cell})
                              : dropdown(f_.ui, id, label(key), shown, value < 0 ? last : value);
  if (picked >= 0) {
    const int now = or_all && picked == last ? -1 : picked;
    changed_ = changed_ || now != value;
    value = now;
  }
  end(at);
}

}  // namespace hw::panels
