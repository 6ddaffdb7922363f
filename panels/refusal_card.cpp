#include "panels/refusal_card.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <optional>

#include <imgui_internal.h>

#include "gui/widgets/button.h"
#include "gui/widgets/text.h"
#include "panels/widget_path.h"

namespace hw::panels {

using namespace gui;

namespace {

constexpr float card_width = 336, card_side = 16, card_top = 12, action_height = 32, action_gap = 8;
constexpr float mark = 20, title = 24, cross_size = 32, in_bar = 28, from_border = 8;

enum class CardForm : bool { card, bar };

std::string_view label(const Action& a, CardForm as) {
  return as == CardForm::bar && !a.brief.empty() ? a.brief : a.label;
}

float action_width(const Ui& ui, const Action& a, CardForm as) {
  ButtonOptions o;
  o.moving = a.moving;
  return button_width(ui, label(a, as), o);
}

float slot_width(const Refusal& what, CardForm as) {
  return as == CardForm::bar ? what.slot_in_bar : what.slot_width;
}

/// Places slot and actions one after the other, in as many rows as needed. Logical. Returns their height.
template <class Place>
float place_in_rows(const Ui& ui, const Refusal& what, CardForm as, float width, const Place& place) {
  float x = 0, y = 0;
  const auto next = [&](int index, float wide) {
    if (x > 0 && x + wide > width) x = 0, y += action_height + action_gap;
    place(index, x, y);
    x += wide + action_gap;
  };
  if (const float slot = slot_width(what, as); slot > 0) next(-1, slot);
  for (std::size_t i = 0; i < what.actions.size(); ++i)
    next(static_cast<int>(i), action_width(ui, what.actions[i], as));
  return x > 0 ? y + action_height : 0;
}

float row_of_all(const Ui& ui, const Refusal& what) {
  const float slot = slot_width(what, CardForm::bar);
  float wide = slot > 0 ? slot + action_gap : 0;
  for (const Action& a : what.actions) wide += action_width(ui, a, CardForm::bar) + action_gap;
  return wide;
}

float rows_height(const Ui& ui, const Refusal& what, float width) {
  return place_in_rows(ui, what, CardForm::card, width, [](int, float, float) {});
}

float words_width(const Ui& ui) { return ui.px(card_width - 2 * card_side - mark); }

float card_height(const Ui& ui, const Refusal& what) {
  const float rows = rows_height(ui, what, card_width - 2 * card_side);
  const float words = wrapped_height(ui, Face::body, what.words, words_width(ui));
  return words + ui.px(card_top + title + (rows > 0 ? action_gap + rows : 0) + card_top);
}

/// The place of a bar over the status line, whose sentence says no more than the bar.
Rect bar_place(const Ui& ui) {
  const Widget* status = ui.registry.find("status/text");
  Rect place = status ? status->rect : Rect{ImVec2(0, ui.size_px.y - ui.px(32)), ui.size_px};
  if (const Widget* button = ui.registry.find("status/unsaved")) place.max.x = button->rect.min.x;
  return place;
}

void begin_window(Ui& ui, std::string_view id, const Rect& place) {
  char name[96];
  std::snprintf(name, sizeof name, "##%.*s", static_cast<int>(id.size()), id.data());
  ImGui::SetNextWindowPos(place.min);
  ImGui::SetNextWindowSize(ImVec2(place.width(), place.height()));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0, 0));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, ImVec2(1, 1));
  ImGui::Begin(name, nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                   ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_NoBackground |
                   ImGuiWindowFlags_NoNav);
  // An open list or dialog must stay above the card.
  if (!ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel))
    ImGui::BringWindowToDisplayFront(ImGui::GetCurrentWindow());
  draw_fill(ui, place, ui[Tone::fault_t], 0);
  draw_outline(ui, place, ui[Tone::fault], 0);
  ImGui::GetWindowDrawList()->AddRectFilled(place.min, ImVec2(place.min.x + ui.px(3), place.max.y),
                                            ui[Tone::fault]);
}

}  // namespace

void RefusalCard::begin(Frame& f, const Refusal& what, const Rect& row) {
  Ui& ui = f.ui;
  ui_ = &ui;
  what_ = what;
  find_place(f, row);
  begin_window(ui, what.id, place_);
  show(ui, {.id = what.id, .kind = Kind::text, .label = "Refused", .value = what.words, .card = true},
       place_);
  if (bar_)
    draw_bar_words();
  else
    draw_card_words();
  place_in_rows(ui, what_, CardForm{bar_}, width_, [&](int index, float x, float y) {
    if (index < 0) ImGui::SetCursorScreenPos(ImVec2(rows_.x + ui.px(x), rows_.y + ui.px(y)));
  });
}

/// Beside a row of the left column, over the centre. Rows in the centre are too close together for a card.
std::optional<Rect> RefusalCard::free_place(const Ui& ui, const Rect& row, ImVec2 size) const {
  const ImRect column = ImGui::GetCurrentWindow()->RootWindow->Rect();
  if (column.Min.x > 0) return {};
  const float edge = ui.px(from_border), low = column.Min.y + edge, high = column.Max.y - edge - size.y;
  const float wanted = std::clamp(std::floor(row.centre().y - size.y / 2), low, std::max(low, high));
  const FreePlace::Band band{low, high, ui.px(4)};
  for (float x = column.Max.x; x + size.x <= ui.size_px.x; x += ui.px(24))
    if (const auto place = free_.nearest(ImVec2(x, wanted), size, band)) return place;
  return {};
}

/// Keeps the card's place as long as it is free, so that nothing moves under the pointer.
void RefusalCard::find_place(const Frame& f, const Rect& row) {
  Ui& ui = f.ui;
  const ImVec2 size(ui.px(card_width), card_height(ui, what_));
  free_.look(ui.registry.widgets(), what_.id);
  const bool narrow = f.tier == Tier::narrow;
  const bool same_row = row_.min.x == row.min.x && row_.min.y == row.min.y && row_.max.x == row.max.x;
  const bool same_size = place_.width() == size.x && place_.height() == size.y;
  if (!narrow && !bar_ && same_row && same_size && free_.leaves(place_)) return;
  row_ = row;
  const auto found = narrow ? std::nullopt : free_place(ui, row, size);
  bar_ = !found;
  place_ = found ? *found : bar_place(ui);
  ui.wake_in(0);  // the areas to avoid are only known from the last frame
}

void RefusalCard::draw_card_words() {
  Ui& ui = *ui_;
  const float x = place_.min.x + ui.px(card_side), y = place_.min.y + ui.px(card_top);
  draw_icon(ImGui::GetWindowDrawList(), Icon::cross, ImVec2(x + ui.px(6), y + ui.px(10)), ui.px(12),
            ui[Tone::fault]);
  draw_text_line(ui, x + ui.px(mark), place_.max.x - ui.px(cross_size), y + ui.px(10), Face::body_bold,
                 ui[Tone::ink], what_.about);
  ImGui::SetCursorScreenPos(ImVec2(x + ui.px(mark), y + ui.px(title)));
  wrapped(ui, Face::body, Tone::ink, what_.words, words_width(ui) / ui.scale);
  width_ = card_width - 2 * card_side;
  rows_ = ImVec2(x, place_.min.y + card_height(ui, what_) - ui.px(card_top + rows_height(ui, what_, width_)));
}

/// Draws the words in two lines of small type. The tip shows the full text.
void RefusalCard::draw_bar_words() {
  Ui& ui = *ui_;
  width_ = row_of_all(ui, what_);
  const float right = place_.max.x - ui.px(cross_size + 4 + width_);
  const float middle = std::floor(place_.centre().y);
  float left = place_.min.x + ui.px(card_side);
  draw_text_line(ui, left, right, middle, Face::body_bold, ui[Tone::ink], what_.about);
  left += std::ceil(text_width(ui, Face::body_bold, what_.about)) + ui.px(12);
  draw_text_in_two_lines(ui, left, right - ui.px(8), middle, Face::body, ui[Tone::ink], what_.words);
  rows_ = ImVec2(right, place_.min.y + std::floor((place_.height() - ui.px(in_bar)) / 2));
}

RefusalTouch RefusalCard::end() {
  Ui& ui = *ui_;
  RefusalTouch done;
  place_in_rows(ui, what_, CardForm{bar_}, width_, [&](int index, float x, float y) {
    if (index < 0) return;
    const Action& a = what_.actions[static_cast<std::size_t>(index)];
    ButtonOptions o;
    o.disabled = a.disabled;
    o.moving = a.moving;
    o.height = bar_ ? in_bar : action_height;
    ImGui::SetCursorScreenPos(ImVec2(rows_.x + ui.px(x), rows_.y + ui.px(y)));
    if (button(ui, a.id, label(a, CardForm{bar_}), o).clicked) done.action = index;
  });
  ButtonOptions cross{.style = ButtonStyle::quiet, .icon = Icon::cross, .tip = "Close", .width = cross_size};
  if (bar_) cross.height = in_bar;
  ImGui::SetCursorScreenPos(
      ImVec2(place_.max.x - ui.px(cross_size + 2), bar_ ? rows_.y : place_.min.y + ui.px(2)));
  done.closed = button(ui, Path("{}/close", what_.id), "", cross).clicked;
  ImGui::End();
  ImGui::PopStyleVar(2);
  return done;
}

}  // namespace hw::panels
