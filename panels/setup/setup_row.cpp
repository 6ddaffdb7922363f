#include "panels/setup/setup_row.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "gui/widgets/button.h"
#include "gui/widgets/choice.h"
#include "gui/widgets/icons.h"
#include "gui/widgets/text.h"
#include "panels/kept_legible.h"

namespace hw::panels {

using namespace gui;
namespace {

constexpr float setup_row_height = 40, bit_height = 32, mnemonic_width = 56;

/// Draws a box with a tick and its words. Returns true when it was pressed.
bool bit_box(Ui& ui, std::string_view id, std::string_view label, bool on, std::string_view disabled,
             float width) {
  const Touch t = touch(
      ui, {.id = id, .kind = Kind::toggle, .label = label, .value = on ? "on" : "off", .disabled = disabled},
      ImVec2(width, ui.px(bit_height)));
  const float middle = std::floor(t.rect.centre().y), side = ui.px(16);
  const Rect box{ImVec2(t.rect.min.x + ui.px(2), middle - side / 2),
                 ImVec2(t.rect.min.x + ui.px(2) + side, middle + side / 2)};
  if (t.hovered && t.enabled) draw_fill(ui, t.rect, ui[Tone::hover]);
  draw_fill(ui, box, ui[on ? Tone::ink2 : Tone::well], 2);
  draw_outline(ui, box, ui[t.enabled ? Tone::edge : Tone::line], 2);
  if (on) draw_icon(ImGui::GetWindowDrawList(), Icon::check, box.centre(), ui.px(12), ui[Tone::panel]);
  draw_text_line(ui, box.max.x + ui.px(8), t.rect.max.x, middle, Face::body,
                 ui[t.enabled ? Tone::ink : Tone::ink3], label);
  draw_ring(ui, t);
  return t.clicked;
}

}  // namespace

SetupRow::SetupRow(Frame& frame, SetupEdits& edits, std::size_t i, SetupRowState& state,
                   const SetupRowPlace& place)
    : f_(frame),
      ui_(frame.ui),
      edits_(edits),
      i_(i),
      p_(frame.catalog.params[i]),
      has_(frame.now.params[i]),
      state_(state),
      left_(place.left),
      right_(place.right),
      field_(place.field),
      unit_(shown_unit(frame, p_)) {
  const auto end = fmt::format_to_n(id_, sizeof id_, "setup/{}", p_.mnemonic);
  id_size_ = std::min(end.size, sizeof id_);
}

std::string_view SetupRow::why_not() const {
  return f_.connected() ? std::string_view()
                        : "There is no link. Values can be read and written when it is back.";
}

bool SetupRow::draw(bool hover_counts) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float field_left = right_ - ui_.px(field_);
  ImGui::GetWindowDrawList()->AddRectFilled(ImVec2(left_, at.y), ImVec2(right_, at.y + ui_.hair()),
                                            ui_[Tone::line]);
  draw_words(field_left - ui_.px(12), at.y);
  draw_control(field_left, at.y);
  const float bottom = ImGui::GetCursorScreenPos().y;
  ImGui::SetCursorScreenPos(ImVec2(at.x, bottom));
  const bool pointed = ImGui::IsWindowHovered(ImGuiHoveredFlags_AllowWhenBlockedByActiveItem) &&
                       Rect{ImVec2(left_, at.y), ImVec2(right_, bottom)}.contains(ImGui::GetIO().MousePos);
  const std::string_view focus = ui_.focus.id();
  const bool focused = focus.starts_with(id()) && (focus.size() == id().size() || focus[id().size()] == '/');
  return focused || (pointed && hover_counts);
}

// The note is after the name, or below it if it does not fit. It is never left out.
void SetupRow::draw_words(float right, float y) {
  const float middle = y + ui_.px(setup_row_height / 2);
  const bool off = edits_.off_factory(i_, f_.now);
  draw_text_line(ui_, left_, left_ + ui_.px(mnemonic_width), middle, Face::code_field,
                 ui_[off ? Tone::ink : Tone::ink2], p_.mnemonic);
  const float x = left_ + ui_.px(mnemonic_width);
  const Face face = off ? Face::body_medium : Face::body;
  Tone tone = Tone::ink3;
  const Path words = note(tone);
  if (words.view().empty())
    return draw_text_in_two_lines(ui_, x, right, middle, face, ui_[Tone::ink], p_.label);
  const float label = std::ceil(text_width(ui_, face, p_.label));
  const float wide = std::ceil(text_width(ui_, Face::small, words));
  const bool beside = x + label + ui_.px(8) + wide <= right;
  const float apart = beside ? 0 : ui_.px(8);
  draw_text_line(ui_, x, right, middle - apart, x + label <= right ? face : Face::small, ui_[Tone::ink],
                 p_.label);
  draw_note(words, tone, ImVec2(beside ? right - wide : x, middle + apart));
}

/// Notes another value in the controller, the factory's value, or that the value is lost with the power.
Path SetupRow::note(Tone& tone) const {
  const bool changed = edits_.changed(i_, f_.now);
  if (changed && has_.known) return Path("was {}", text_in(unit_, p_, has_.value));
  if (changed) return Path("edited");
  if (has_.known && !has_.stored) {
    tone = Tone::warn;
    return Path("not stored");
  }
  if (edits_.off_factory(i_, f_.now)) return Path("factory {}", text_in(unit_, p_, p_.fallback));
  if (!p_.stored && f_.catalog.can.store)
    return Path("not kept by Store");  // otherwise it is true for all parameters
  return Path("");
}

void SetupRow::draw_note(std::string_view words, Tone tone, ImVec2 at) {
  const float wide = std::ceil(text_width(ui_, Face::small, words));
  if (!edits_.changed(i_, f_.now))
    return draw_text_line(ui_, at.x, at.x + wide, at.y, Face::small, ui_[tone], words);
  char id[96];
  std::size_t size = 0;
  part_id("was", id, size);
  ImGui::SetCursorScreenPos(ImVec2(at.x, std::floor(at.y - ui_.line(Face::small) / 2)));
  if (!link(ui_, {id, size}, words)) return;
  edits_.undo(i_);
  state_.number.reset();
}

void SetupRow::part_id(std::string_view part, char (&out)[96], std::size_t& size) const {
  const auto end = fmt::format_to_n(out, sizeof out, "setup/{}/{}", p_.mnemonic, part);
  size = std::min(end.size, sizeof out);
}

void SetupRow::draw_control(float left, float y) {
  ImGui::SetCursorScreenPos(ImVec2(left, y + ui_.px(4)));
  if (!p_.bits.empty())
    draw_bits(y);
  else if (!p_.choices.empty())
    draw_choice(y);
  else
    draw_number(y);
}

/// Draws a name that ends in a number. The user may type it in full, or only the number.
void SetupRow::draw_name(float y) {
  const auto shown = edits_.shown(i_, f_.now);
  std::string& text = state_.number.text;
  if (!state_.typing_name) text = shown ? value_text(p_, *shown) : std::string();
  FieldOptions options;
  options.disabled = why_not();
  options.width = field_;
  options.changed = edits_.changed(i_, f_.now);
  options.error = !state_.number.sentence.empty();
  options.face = Face::code_field;
  const Field e = text_field(ui_, id(), p_.label, text, options);
  if (e.edited) state_.typing_name = true, state_.number.sentence.clear();
  if ((e.entered || e.left) && state_.typing_name) {
    std::string_view number = text;
    if (number.starts_with(p_.prefix)) number.remove_prefix(p_.prefix.size());
    const auto value = read_number(number);
    if (value && edits_.set(i_, std::llround(*value)))
      state_.typing_name = false;
    else
      state_.number.sentence =
          fmt::format("{} to {} only", value_text(p_, p_.minimum), value_text(p_, p_.maximum));
  }
  ImGui::SetCursorScreenPos(ImVec2(left_, y + ui_.px(setup_row_height)));
  if (state_.number.sentence.empty()) return;
  draw_text_right(ui_, ImVec2(right_, y + ui_.px(setup_row_height - 2)), Face::small, ui_[Tone::fault],
                  state_.number.sentence);
  keep_legible(ui_, {ImVec2(left_, y + ui_.px(setup_row_height - 2)),
                     ImVec2(right_, y + ui_.px(setup_row_height + 16))});
  ImGui::SetCursorScreenPos(ImVec2(left_, y + ui_.px(setup_row_height + 16)));
}

void SetupRow::draw_number(float y) {
  if (!p_.prefix.empty()) return draw_name(y);
  const auto shown = edits_.shown(i_, f_.now);
  if (unit_ != state_.unit)
    state_.number.reset(), state_.unit = unit_;  // the number was typed in another unit
  NumberOptions options;
  const double a = unit_.shown(p_.also_zero ? std::min<std::int64_t>(0, p_.minimum) : p_.minimum);
  const double b = unit_.shown(p_.maximum);
  options.range = {std::min(a, b), std::max(a, b), unit_.decimals, unit_.name};
  options.disabled = why_not();
  options.width = field_;
  options.changed = edits_.changed(i_, f_.now);
  const NumberEvent e =
      number_field(ui_, id(), p_.label, shown ? std::optional<double>(unit_.shown(*shown)) : std::nullopt,
                   state_.number, options);
  const float below = ImGui::GetCursorScreenPos().y;
  if (e.committed || (e.entered && state_.number.dirty())) {
    if (edits_.set(i_, unit_.value(e.value)))
      state_.number.reset();
    else
      state_.number.sentence = range_in(unit_, p_) + " only";
  }
  ImGui::SetCursorScreenPos(ImVec2(left_, std::max(below, y + ui_.px(setup_row_height))));
}

void SetupRow::draw_choice(float y) {
  if (state_.views.empty()) {
    for (const ParamChoice& c : p_.choices) state_.names.push_back(c.label);
    state_.views.assign(state_.names.begin(), state_.names.end());
  }
  const auto shown = edits_.shown(i_, f_.now);
  int chosen = -1;
  for (std::size_t c = 0; c < p_.choices.size(); ++c)
    if (shown && p_.choices[c].value == *shown) chosen = static_cast<int>(c);
  const int picked =
      dropdown(ui_, id(), p_.label, state_.views, chosen,
               {.disabled = why_not(), .width = field_, .none = p_.readable ? "not read" : "cannot be read"});
  if (picked >= 0 && picked < static_cast<int>(p_.choices.size()))
    edits_.set(i_, p_.choices[static_cast<std::size_t>(picked)].value);
  ImGui::SetCursorScreenPos(ImVec2(left_, y + ui_.px(setup_row_height)));
}

void SetupRow::draw_bits(float y) {
  const auto shown = edits_.shown(i_, f_.now);
  char words[24];
  const auto end = shown ? fmt::format_to_n(words, sizeof words, "{}", *shown)
                         : fmt::format_to_n(words, sizeof words, "not read");
  const std::string_view value(words, std::min(end.size, sizeof words));
  const float middle = y + ui_.px(setup_row_height / 2);
  draw_text_line(ui_, right_ - std::ceil(text_width(ui_, Face::code_field, value)), right_, middle,
                 Face::code_field, ui_[Tone::ink], value);
  show(ui_, {.id = id(), .kind = Kind::text, .label = p_.label, .value = value},
       {ImVec2(left_, y), ImVec2(right_, y + ui_.px(setup_row_height))});
  const bool two = right_ - left_ > ui_.px(620);
  const float x0 = left_ + ui_.px(mnemonic_width - 2), width = (right_ - x0) / (two ? 2 : 1);
  float row_y = y + ui_.px(setup_row_height - 4);
  for (std::size_t b = 0; b < p_.bits.size(); ++b) {
    const std::int64_t mask = std::int64_t{1} << p_.bits[b].bit;
    const bool on = shown && (*shown & mask);
    char part[96];
    std::size_t size = 0;
    const auto number = fmt::format_int(p_.bits[b].bit);
    part_id({number.data(), number.size()}, part, size);
    const std::string_view fixed = on && !p_.accepts(*shown & ~mask) ? "This bit is always on." : why_not();
    ImGui::SetCursorScreenPos(ImVec2(x0 + (two && b % 2 ? width : 0), row_y));
    if (bit_box(ui_, {part, size}, p_.bits[b].label, on, fixed, width - ui_.px(8)) && shown)
      edits_.set(i_, *shown ^ mask);
    if (!two || b % 2 || b + 1 == p_.bits.size()) row_y += ui_.px(bit_height);
  }
  ImGui::SetCursorScreenPos(ImVec2(left_, row_y + ui_.px(4)));
}

}  // namespace hw::panels
