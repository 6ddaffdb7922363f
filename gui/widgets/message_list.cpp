// Draws the newest message in a strip, and all messages in the list that the strip opens.
#include <algorithm>
#include <cstdio>
#include <span>

#include <imgui_internal.h>

#include "gui/widgets/button.h"
#include "gui/widgets/message.h"
#include "gui/widgets/region.h"
#include "gui/widgets/text.h"

namespace hw::gui {
namespace {

using Message = Toasts::Toast;

constexpr const char* message_popup = "##messages";
constexpr float cross_width = 28, mark_width = 34;

/// An id made of `head`, the number and `tail`.
std::string_view message_id(std::span<char> buffer, const char* head, int number, const char* tail = "") {
  const int n = std::snprintf(buffer.data(), buffer.size(), "%s%d%s", head, number, tail);
  return {buffer.data(), static_cast<std::size_t>(std::clamp(n, 0, static_cast<int>(buffer.size()) - 1))};
}

/// "now", "2 min": in minutes, so that a console at rest draws only one frame a minute.
std::string_view age_of(Ui& ui, const Message& message, std::span<char> buffer) {
  const double age = message.until_s < 0 ? 0 : std::max(0.0, ui.now_s - message.since_s);
  const bool hours = age >= 3600;
  const double step = hours ? 3600 : 60, whole = std::floor(age / step);
  ui.wake_in((whole + 1) * step - age + 0.001);
  if (age < 60) return "now";
  const int n = std::snprintf(buffer.data(), buffer.size(), hours ? "%.0f h" : "%.0f min", whole);
  return {buffer.data(), static_cast<std::size_t>(n)};
}

/// "3 times, 2 min".
std::string_view count_and_age(Ui& ui, const Message& message, std::span<char> buffer) {
  char of_age[24];
  const std::string_view age = age_of(ui, message, of_age);
  const int size = static_cast<int>(age.size());
  const int n = message.times > 1 ? std::snprintf(buffer.data(), buffer.size(), "%d times, %.*s",
                                                  message.times, size, age.data())
                                  : std::snprintf(buffer.data(), buffer.size(), "%.*s", size, age.data());
  return {buffer.data(), static_cast<std::size_t>(n)};
}

void draw_ground(Ui& ui, const Rect& place, bool hovered) {
  draw_fill(ui, place, ui[hovered ? Tone::hover : Tone::raised]);
  draw_outline(ui, place, ui[Tone::edge]);
}

void draw_mark(Ui& ui, const Message& message, float left, float middle) {
  const SeverityMark mark = severity_mark(message.severity);
  draw_icon(ImGui::GetWindowDrawList(), mark.icon, ImVec2(left + ui.px(18), std::floor(middle)), ui.px(12),
            ui[mark.ink]);
}

bool close_button(Ui& ui, std::string_view id, float right, float middle) {
  const float side = ui.px(cross_width);
  ImGui::SetCursorScreenPos(ImVec2(right - side, std::floor(middle - side / 2)));
  return button(ui, id, "",
                {.style = ButtonStyle::quiet,
                 .icon = Icon::cross,
                 .tip = "Close this message.",
                 .width = cross_width,
                 .height = cross_width})
      .clicked;
}

/// Registers the messages behind the newest: the screen shows only their number.
void name_waiting(Ui& ui, const Toasts& toasts, const Rect& place) {
  char id[24];
  for (std::size_t i = 0; i + 1 < toasts.list().size(); ++i) {
    const Message& message = toasts.list()[i];
    show(ui, {message_id(id, "toast/", message.number), Kind::text, message.shown_text, message.shown_text},
         place);
  }
}

/// The narrowest form: mark and number. The tip shows the sentence.
void draw_brief(Ui& ui, Toasts& toasts, const Rect& place) {
  const Message& newest = toasts.list().back();
  char id[24], count[12];
  name_waiting(ui, toasts, place);
  ImGui::SetCursorScreenPos(place.min);
  const Touch t = touch(ui,
                        {.id = message_id(id, "toast/", newest.number),
                         .kind = Kind::button,
                         .label = newest.shown_text,
                         .value = newest.shown_text,
                         .tip = newest.shown_text},
                        ImVec2(place.width(), place.height()));
  draw_ground(ui, place, t.hovered);
  draw_mark(ui, newest, place.min.x - ui.px(4), place.centre().y);
  draw_text_line(ui, place.min.x + ui.px(26), place.max.x, place.centre().y, Face::body_medium, ui[Tone::ink],
                 message_id(count, "", static_cast<int>(toasts.list().size())));
  draw_ring(ui, t);
  toasts.in_frame.list_wanted |= t.clicked;
}

/// Draws "1 more", right-aligned. Returns its left edge.
float draw_more(Ui& ui, Toasts& toasts, float right, float middle) {
  const int waiting = static_cast<int>(toasts.list().size()) - 1;
  if (waiting == 0) return right;
  char words[24];
  const std::string_view label = message_id(words, "", waiting, " more");
  const ButtonOptions look{.style = ButtonStyle::quiet, .height = 28};
  const float left = right - ui.px(button_width(ui, label, look));
  ImGui::SetCursorScreenPos(ImVec2(left, std::floor(middle - ui.px(14))));
  const Touch t = button(ui, "message/more", label, look);
  toasts.in_frame.list_wanted |= t.clicked;
  name_waiting(ui, toasts, t.rect);
  return left;
}

void draw_sentence(Ui& ui, Toasts& toasts, const Rect& place) {
  const Message& newest = toasts.list().back();
  char id[24], aside[48];
  ImGui::SetCursorScreenPos(place.min);
  const Touch t = touch(ui,
                        {.id = message_id(id, "toast/", newest.number),
                         .kind = Kind::button,
                         .label = newest.shown_text,
                         .value = newest.shown_text},
                        ImVec2(place.width(), place.height()));
  if (t.hovered) draw_fill(ui, t.rect, ui[Tone::hover]);
  const float middle = place.centre().y;
  draw_mark(ui, newest, place.min.x, middle);
  float right = place.max.x - ui.px(4);
  if (place.width() >= ui.px(200)) {
    const std::string_view words = count_and_age(ui, newest, aside);
    const float left = right - std::ceil(text_width(ui, Face::small, words));
    draw_text_line(ui, left, right + 1, middle, Face::small, ui[Tone::ink2], words);
    right = left - ui.px(12);
  }
  draw_text_in_two_lines(ui, place.min.x + ui.px(mark_width), right, middle, Face::body, ui[Tone::ink],
                         newest.shown_text);
  draw_ring(ui, t);
  toasts.in_frame.list_wanted |= t.clicked;
}

}  // namespace

void draw_messages(Ui& ui, Toasts& toasts, const Rect& place) {
  if (toasts.list().empty()) return;
  toasts.in_frame.shown = true;
  show(ui, {"message/strip", Kind::text, "Messages"}, place);
  if (place.width() < ui.px(160)) return draw_brief(ui, toasts, place);
  draw_ground(ui, place, false);
  const int number = toasts.list().back().number;
  const float middle = place.centre().y;
  const float more = draw_more(ui, toasts, place.max.x - ui.px(cross_width + 2), middle);
  draw_sentence(ui, toasts, {place.min, ImVec2(more, place.max.y)});
  char id[32];
  if (close_button(ui, message_id(id, "message/close/", number), place.max.x - ui.px(2), middle))
    toasts.dismiss(number);
}

// ---- list

namespace {

float words_width(const Ui& ui, float width) { return width - ui.px(mark_width + cross_width + 8); }
float row_height(const Ui& ui, const Message& message, float width) {
  return ui.px(8) + wrapped_height(ui, Face::body, message.shown_text, words_width(ui, width)) +
         ui.line(Face::small) + ui.px(8);
}

/// Returns true when its cross was pressed.
bool draw_row(Ui& ui, const Message& message, float width) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float height = row_height(ui, message, width);
  const Rect row{at, ImVec2(at.x + width, at.y + height)};
  char id[40], aside[48];
  show(ui,
       {message_id(id, "message/list/", message.number), Kind::text, message.shown_text, message.shown_text},
       row);
  draw_mark(ui, message, at.x, at.y + ui.px(18));
  ImGui::SetCursorScreenPos(ImVec2(at.x + ui.px(mark_width), at.y + ui.px(8)));
  wrapped(ui, Face::body, Tone::ink, message.shown_text, words_width(ui, width) / ui.scale);
  draw_text(ui, ImVec2(at.x + ui.px(mark_width), row.max.y - ui.px(8) - ui.line(Face::small)), Face::small,
            ui[Tone::ink2], count_and_age(ui, message, aside));
  ImGui::GetWindowDrawList()->AddRectFilled(ImVec2(at.x, row.max.y - ui.hair()), row.max, ui[Tone::line]);
  const bool closed = close_button(ui, message_id(id, "message/list/", message.number, "/close"),
                                   row.max.x - ui.px(4), at.y + ui.px(20));
  ImGui::SetCursorScreenPos(ImVec2(at.x, row.max.y));
  return closed;
}

/// The list is below the strip if it fits there, else above it.
Rect place_message_list(const Ui& ui, const Rect& within, const Rect& status, float height) {
  const Widget* strip = ui.registry.find("message/strip");
  const Rect at = strip ? strip->rect : status;
  const float apart = ui.px(2), width = std::min(ui.px(432), within.width());
  const float right =
      std::clamp(at.max.x, within.min.x + width, std::max(within.max.x, within.min.x + width));
  const float under = at.max.y + apart, over = std::min(at.min.y, status.min.y) - apart;
  const bool fits_under = under + height <= status.min.y;
  const float top = fits_under ? under : std::max(ui.px(top_bar_height), over - height);
  return {ImVec2(right - width, top), ImVec2(right, fits_under ? under + height : over)};
}

void draw_rows(Ui& ui, Toasts& toasts) {
  const float width = ImGui::GetContentRegionAvail().x;
  int closed = 0;
  for (auto message = toasts.list().rbegin(); message != toasts.list().rend(); ++message)
    if (draw_row(ui, *message, width)) closed = message->number;
  if (closed) toasts.dismiss(closed);
  if (toasts.list().size() < 2) return;
  const ButtonOptions look{.style = ButtonStyle::quiet};
  const ImVec2 at = ImGui::GetCursorScreenPos();
  ImGui::SetCursorScreenPos(ImVec2(at.x + width - ui.px(button_width(ui, "Close all", look)), at.y));
  if (button(ui, "message/close_all", "Close all", look).clicked) toasts.dismiss_all();
}

void draw_message_list(Ui& ui, Toasts& toasts, const Rect& within, const Rect& status) {
  if (toasts.in_frame.list_wanted) ImGui::OpenPopup(message_popup);
  if (!ImGui::IsPopupOpen(message_popup)) return;
  float height = 2 * ui.hair() + (toasts.list().size() > 1 ? ui.px(32) : 0);
  const float width = std::min(ui.px(432), within.width()) - 2 * ui.hair();
  for (const Message& message : toasts.list()) height += row_height(ui, message, width);
  const Rect place = place_message_list(ui, within, status, height);
  ImGui::SetNextWindowPos(place.min);
  ImGui::SetNextWindowSize(ImVec2(place.width(), place.height()));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(ui.hair(), ui.hair()));
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(0, 0));
  if (ImGui::BeginPopup(message_popup, ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings)) {
    ui.take_arrows();
    draw_rows(ui, toasts);
    if (toasts.list().empty() || ui.cancelled()) ImGui::CloseCurrentPopup();
    ImGui::EndPopup();
  }
  ImGui::PopStyleVar(2);
}

}  // namespace

void draw_toasts(Ui& ui, Toasts& toasts, const Rect& within, const Rect& status) {
  draw_message_list(ui, toasts, within, status);
  toasts.in_frame = {};
  if (toasts.tick(ui.now_s)) ui.wake_in(0);  // the strip of this frame is already drawn
  ui.wake_in(toasts.due_in_s(ui.now_s));
}

}  // namespace hw::gui
