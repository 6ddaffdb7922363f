#include "panels/blocks/field_lines.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "core/base/index.h"
#include "core/sequence/fields.h"
#include "gui/model/units_format.h"
#include "gui/widgets/button.h"
#include "gui/widgets/choice.h"
#include "gui/widgets/text.h"
#include "panels/blocks/block_measures.h"
#include "panels/kept_legible.h"
#include "panels/widget_path.h"

namespace hw::panels {

using namespace gui;

void draw_step_refusal(Frame& f, const EditedStep& step, float width) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  wrapped(f.ui, Face::small, Tone::fault, step.refused->why, width);
  show(f.ui, {Path("{}/refusal", step.path), Kind::text, "Refused", step.refused->why},
       {at, ImVec2(at.x + f.ui.px(width), ImGui::GetCursorScreenPos().y)});
  ImGui::SetCursorScreenPos(ImVec2(at.x, ImGui::GetCursorScreenPos().y + f.ui.px(4)));
}

template <class Value>
bool FieldLines::field(std::string_view id, std::string_view key, Value& value, NumberRange range,
                       float width) {
  NumberField& state = kept(id, static_cast<double>(value));
  NumberOptions o;
  o.range = range;
  o.width = width;
  o.sentence_below = false;
  const std::string refused = range_sentence(state.text, range);
  o.refused = refused.empty() && is_refused(key) ? std::string_view(step_.refused->why) : refused;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const NumberEvent event = number_field(f_.ui, id, label(key), std::nullopt, state, o);
  show_refusal(at, width, label(key), refused);
  if (!event.field.edited) return false;
  const auto typed = state.value();
  if (!typed || !range_sentence(state.text, range).empty()) return false;
  const auto now = static_cast<Value>(*typed);
  const bool other = now != value;
  changed_ = changed_ || other;
  value = now;
  return other;
}

void FieldLines::number(std::string_view key, double& value) {
  if (key == "degrees") return turn(key, value);
  if (key == "to" && goes_some_way(false)) return;
  put_number(key, value, -1e9);
}

void FieldLines::line_or_all(std::string_view key, int& value) {
  static constexpr std::array<std::string_view, 2> names{"one", "all"};
  const ImVec2 at = begin(key);
  if (const int picked =
          segment(f_.ui, Path("{}/{}/which", path_, key), names, value < 0 ? 1 : 0, {.cell_width = 44});
      picked >= 0 && (picked == 1) != (value < 0))
    value = picked == 1 ? -1 : 1, changed_ = true;
  if (value >= 0) {
    ImGui::SetCursorScreenPos(ImVec2(at.x + f_.ui.px(104), at.y));
    field(Path("{}/{}", path_, key), key, value, {0, 64, 0, {}}, 64);
  }
  end(at);
  show_refused(key);
  all_lines_ = value < 0;
}

void FieldLines::word(std::string_view key, std::uint32_t& value) {
  if (!all_lines_) return;
  const ImVec2 at = begin(key);
  field(Path("{}/{}", path_, key), key, value, {0, 4294967295.0, 0, {}}, 120);
  end(at);
}

void FieldLines::flag(std::string_view key, bool& value) {
  if (all_lines_ && key == "on") return;
  static constexpr std::array<std::string_view, 2> names{"no", "yes"}, states{"off", "on"},
      tool{"up", "down"};
  const bool state = key == "on";
  const auto& words = state ? states : key == "down" ? tool : names;
  const ImVec2 at = begin(key);
  if (const int picked = segment(f_.ui, Path("{}/{}", path_, key), words, value ? 1 : 0, {.cell_width = 52});
      picked >= 0 && (picked == 1) != value)
    value = picked == 1, changed_ = true;
  end(at);
}

void FieldLines::text(std::string_view key, std::string& value) {
  if (several_lines_ && key == "text") return lines(key, value);
  const ImVec2 at = begin(key);
  FieldOptions o;
  o.width = width_ - field_label_width;
  if (text_field(f_.ui, Path("{}/{}", path_, key), label(key), value, o).edited) changed_ = true;
  end(at);
}

void FieldLines::sign(std::string_view key, Sign& value) {
  if (goes_some_way(true)) return;
  static constexpr std::array<std::string_view, 2> names{"-", "+"};
  const ImVec2 at = begin(key);
  if (const int picked = segment(f_.ui, Path("{}/{}", path_, key), names, value == Sign::plus ? 1 : 0, {});
      picked >= 0) {
    const Sign now = picked == 1 ? Sign::plus : Sign::minus;
    changed_ = changed_ || now != value;
    value = now;
  }
  end(at);
}

void FieldLines::choice(std::string_view key, sequence::MoveOnInput::Kind& value,
                        std::span<const std::string_view> names) {
  const ImVec2 at = begin(key);
  if (const int picked =
          segment(f_.ui, Path("{}/{}", path_, key), names, static_cast<int>(value), {.cell_width = 52});
      picked >= 0 && picked != static_cast<int>(value))
    value = static_cast<sequence::MoveOnInput::Kind>(picked), changed_ = true;
  end(at);
}

void FieldLines::stairs(std::string_view key, std::vector<sequence::SpeedStairs::Stair>& value) {
  constexpr float cell = 88, words = 96;
  const bool in_one = width_ >= field_label_width + 2 * cell + words + 8;
  for (std::size_t i = 0; i < value.size(); ++i) {
    const ImVec2 at = begin("until");
    stair_number(Path("{}/{}/until", key, i + 1), "until", value[i].until, -1e9, cell);
    if (!in_one) end(at);
    const ImVec2 beside =
        in_one ? begin_at(ImVec2(at.x + f_.ui.px(cell + 8), at.y), label("speed"), words) : begin("speed");
    stair_number(Path("{}/{}/speed", key, i + 1), "speed", value[i].speed, 0, cell);
    end(in_one ? at : beside);
  }
  const ImVec2 at = begin_without_label();
  const bool more = button(f_.ui, Path("{}/{}/add", path_, key), "Add stair", {.icon = Icon::plus}).clicked;
  ImGui::SameLine(0, f_.ui.px(8));
  ButtonOptions fewer;
  fewer.style = ButtonStyle::quiet;
  fewer.icon = Icon::cross;
  fewer.width = 32;
  fewer.tip = "Removes the last stair.";
  fewer.disabled = value.size() < 2 ? "The last stair cannot be removed." : "";
  const bool less = button(f_.ui, Path("{}/{}/remove", path_, key), "", fewer).clicked;
  end(at);
  show_refused(key);
  if (!more && !less) return;
  changed_ = true;
  if (more) return value.push_back(value.empty() ? sequence::SpeedStairs::Stair{} : value.back());
  for (const std::string_view field : {"until", "speed"})
    numbers_.erase(std::string(Path("{}/{}/{}/{}", path_, key, value.size(), field).view()));
  value.pop_back();
}

void FieldLines::own(sequence::OwnSpeeds& value) {
  static constexpr std::array<std::string_view, 2> names{"as before", "its own"};
  const ImVec2 at = begin("high");
  if (const int picked = segment(f_.ui, Path("{}/own", path_), names, value ? 1 : 0, {.cell_width = 76});
      picked >= 0 && (picked == 1) != value.has_value()) {
    value = picked == 1 ? sequence::OwnSpeeds(sequence::Speeds()) : std::nullopt;
    changed_ = true;
  }
  end(at);
  if (value) fields(*this, *value);
}

FixedText<64> FieldLines::label(std::string_view key) const {
  const bool of_plane = (key == "x" || key == "y") && of_.axes.size() > 1;
  if (!of_plane) return sequence::label_of_field(key, scale_of(key).unit);
  const std::string_view what = std::holds_alternative<sequence::Arc>(typed_) ? "Centre" : "Begin";
  return Path("{} {}, {}", what, of_.axes[ix(axis_of(key))].name, scale_of(key).unit).view();
}

int FieldLines::axis_of(std::string_view key) const {
  const sequence::Plane* plane = sequence::plane_of(typed_);
  return !plane ? 0 : key == "x" ? plane->right : plane->up;
}

const sequence::Scale& FieldLines::scale_of(std::string_view key) const {
  static const sequence::Scale plain;
  const sequence::Look& look = step_.look;
  if (key == "x" || key == "y") return look.of_axis(axis_of(key));
  if (key == "high" || key == "low") return look.of_motion(typed_);
  if (key == "lead_in") return look.all;
  if (const auto* stairs = std::get_if<sequence::SpeedStairs>(&typed_)) return look.of_axis(stairs->axis);
  const auto* some = std::get_if<sequence::MoveOnInput>(&typed_);
  return key == "to" && some ? look.of_axis(some->axis) : plain;
}

ImVec2 FieldLines::begin(std::string_view key, const std::string* of_axis) {
  return begin_at(ImGui::GetCursorScreenPos(), of_axis ? FixedText<64>(*of_axis) : label(key),
                  field_label_width);
}

ImVec2 FieldLines::begin_at(ImVec2 at, std::string_view words, float width) {
  draw_text_line(f_.ui, at.x, at.x + f_.ui.px(width - 8), at.y + f_.ui.px(16), Face::body, f_.ui[Tone::ink2],
                 words);
  const ImVec2 field(at.x + f_.ui.px(width), at.y);
  ImGui::SetCursorScreenPos(field);
  return field;
}

ImVec2 FieldLines::begin_without_label() {
  const ImVec2 at = ImGui::GetCursorScreenPos(), field(at.x + f_.ui.px(field_label_width), at.y);
  ImGui::SetCursorScreenPos(field);
  return field;
}

void FieldLines::end(ImVec2 field) {
  ImGui::SetCursorScreenPos(
      ImVec2(field.x - f_.ui.px(field_label_width), field.y + f_.ui.px(field_line_height)));
}

void FieldLines::show_refusal(ImVec2 field, float width, const FixedText<64>& name, std::string_view why) {
  if (why.empty()) return;
  problem_ = fmt::format("{}: {}{}", name.view(), why, why.back() == '.' ? "" : ".");
  const float left = field.x + f_.ui.px(width + 8), right = field.x + f_.ui.px(width_ - field_label_width);
  draw_text_in_two_lines(f_.ui, left, right, field.y + f_.ui.px(16), Face::small, f_.ui[Tone::fault], why);
  keep_legible(f_.ui, {ImVec2(left, field.y), ImVec2(right, field.y + f_.ui.px(32))});
}

bool FieldLines::is_refused(std::string_view key) const {
  return step_.refused && step_.refused->field == key;
}

void FieldLines::show_refused(std::string_view key) {
  if (!is_refused(key)) return;
  refusal_shown_ = true;
  draw_step_refusal(f_, step_, width_);
}

bool FieldLines::offers_nearest(std::string_view key, const sequence::Scale& scale, double& nearest) {
  if (!is_refused(key) || !step_.refused->nearest) return false;
  nearest = *step_.refused->nearest;
  const ImVec2 at = begin_without_label();
  const Path words("Use {}",
                   format_number(scale.shown(nearest), scale.decimals == 6 ? 0 : scale.decimals).view());
  ButtonOptions look;
  look.style = ButtonStyle::outlined;
  const bool taken = button(f_.ui, Path("{}/nearest", path_), words, look).clicked;
  end(at);
  if (!taken) return false;
  numbers_.erase(std::string(Path("{}/{}", path_, key).view()));
  return changed_ = true;
}

void FieldLines::lines(std::string_view key, std::string& value) {
  std::size_t begins = 0;
  for (int n = 1; begins <= value.size(); ++n) {
    const std::size_t end = std::min(value.find('\n', begins), value.size());
    std::string line = value.substr(begins, end - begins);
    const Path id = n == 1 ? Path("{}/{}", path_, key) : Path("{}/{}/{}", path_, key, n);
    const ImVec2 at = n == 1 ? begin(key) : begin_without_label();
    FieldOptions o;
    o.width = width_ - field_label_width;
    o.face = Face::code_field;
    const Field field = text_field(f_.ui, id, label(key), line, o);
    this->end(at);
    const bool goes = field.left && line.empty() && n > 1;
    if (field.edited) value.replace(begins, end - begins, line);
    if (field.entered) {
      value.insert(begins + line.size(), "\n");
      type_into(f_.ui, Path("{}/{}/{}", path_, key, n + 1));
    }
    if (goes) value.erase(begins - 1, 1);
    changed_ = changed_ || field.edited || field.entered || goes;
    if (goes) return;
    begins += line.size() + 1;
  }
}

NumberField& FieldLines::kept(std::string_view id, std::optional<double> value,
                              const sequence::Scale& scale) {
  const auto found = numbers_.find(id);
  if (found != numbers_.end()) return found->second;
  NumberField& made = numbers_[std::string(id)];
  if (value) made.set(scale.shown(*value), scale.decimals);
  while (value && made.text.find('.') != std::string::npos &&
         (made.text.back() == '0' || made.text.back() == '.'))
    made.text.pop_back();
  return made;
}

void FieldLines::put_number(std::string_view key, double& value, double low) {
  sequence::Scale scale = scale_of(key);
  if (low == 0) scale.factor = std::fabs(scale.factor);
  const ImVec2 at = begin(key);
  const Path id("{}/{}", path_, key);
  double shown = scale.shown(value);
  kept(id, value, scale);
  if (field(id, key, shown, {low, 1e9, 6, {}}, 120)) value = scale.kept(shown);
  end(at);
  show_refused(key);
  if (double nearest = 0; offers_nearest(key, scale, nearest)) value = nearest;
}

void FieldLines::stair_number(std::string_view below, std::string_view key, double& value, double low,
                              float width) {
  sequence::Scale scale = scale_of(key);
  if (low == 0) scale.factor = std::fabs(scale.factor);
  const Path id("{}/{}", path_, below);
  double shown = scale.shown(value);
  kept(id, value, scale);
  if (field(id, key, shown, {low, 1e9, 6, {}}, width)) value = scale.kept(shown);
}

void FieldLines::turn(std::string_view key, double& value) {
  static constexpr std::array<std::string_view, 2> names{"clockwise", "counter"};
  const sequence::Plane* plane = sequence::plane_of(typed_);
  const double sign = plane && step_.look.mirrors(*plane) ? -1 : 1;
  const bool clockwise = value * sign < 0;
  const ImVec2 at = begin(key);
  double size = std::fabs(value);
  if (field(Path("{}/{}", path_, key), key, size, {0, 360, 3, "\u00b0"}, 80))
    value = clockwise ? -size * sign : size * sign;
  end(at);
  const ImVec2 below = begin("direction");
  const int picked = segment(f_.ui, Path("{}/way", path_), names, clockwise ? 0 : 1, {.cell_width = 72});
  if (picked >= 0 && (picked == 0) != clockwise) value = -value, changed_ = true;
  end(below);
}

void FieldLines::whole(std::string_view key, int& value, double low, double high) {
  const ImVec2 at = begin(key);
  field(Path("{}/{}", path_, key), key, value, {low, high, 0, {}}, 80);
  end(at);
  show_refused(key);
}

}  // namespace hw::panels
