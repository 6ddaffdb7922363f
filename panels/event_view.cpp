#include "panels/event_view.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "gui/model/tab.h"
#include "gui/widgets/button.h"
#include "gui/widgets/choice.h"
#include "gui/widgets/icons.h"
#include "gui/widgets/text.h"
#include "gui/widgets/touch.h"

namespace hw::panels {

using namespace gui;
namespace {

constexpr float event_row = 24, event_time_x = 16, event_mark_x = 94, event_subject_x = 112,
                event_words_x = 150;

struct MarkLook {
  Icon icon;
  Tone tone;
};

MarkLook look_of(const LoggedEvent& event) {
  switch (event.mark) {
    case LoggedEvent::Mark::reached: return {Icon::check, Tone::ok};
    case LoggedEvent::Mark::homed: return {Icon::house, Tone::ok};
    case LoggedEvent::Mark::stopped: return {Icon::stop, Tone::fault};
    case LoggedEvent::Mark::limit: return {Icon::square_solid, Tone::warn};
    case LoggedEvent::Mark::error: return {Icon::diamond_solid, Tone::fault};
    case LoggedEvent::Mark::place_lost: return {Icon::diamond, Tone::warn};
    case LoggedEvent::Mark::link: return {Icon::plug, event.bad ? Tone::fault : Tone::ok};
    case LoggedEvent::Mark::message: break;
  }
  return event.bad ? MarkLook{Icon::warning, Tone::warn} : MarkLook{Icon::info, Tone::ink2};
}

void draw_event(Frame& f, const LoggedEvent& event, const Rect& place, float words_at) {
  Ui& ui = f.ui;
  const float middle = std::floor(place.centre().y);
  char buffer[16];
  const auto time = format_time_of_day(f.tab.desk().records.traffic.clock().of(event.at), false, buffer);
  draw_text(ui, ImVec2(place.min.x + ui.px(event_time_x), std::floor(middle - ui.line(Face::code_time) / 2)),
            Face::code_time, ui[Tone::ink3], time);
  const MarkLook mark = look_of(event);
  draw_icon(ImGui::GetWindowDrawList(), mark.icon, ImVec2(place.min.x + ui.px(event_mark_x), middle),
            ui.px(12), ui[mark.tone]);
  draw_text_line(ui, place.min.x + ui.px(event_subject_x), words_at - ui.px(8), middle, Face::body_bold,
                 ui[Tone::ink], event.subject);
  const NumberText took = duration_of(event);
  const float right = place.max.x - ui.px(16), took_width = std::ceil(text_width(ui, Face::small, took));
  draw_text_line(ui, words_at, right - took_width - ui.px(took_width > 0 ? 12 : 0), middle, Face::body,
                 ui[Tone::ink], event.words);
  draw_text_line(ui, right - took_width, right + 1, middle, Face::small, ui[Tone::ink2], took);
}

/// Left of the words: after the longest name shown, if the width permits.
float words_begin(const Ui& ui, const EventLog& log, float width) {
  float names = 0;
  for (const LoggedEvent& event : log.list())
    names = std::max(names, text_width(ui, Face::body_bold, event.subject));
  return std::min(std::max(ui.px(event_words_x), ui.px(event_subject_x + 12) + std::ceil(names)), width / 2);
}

}  // namespace

float EventView::draw_tools(Frame& f, float left, float top) {
  Ui& ui = f.ui;
  constexpr std::array<std::string_view, 3> names = {"all events", "how it ended", "trouble"};
  const ButtonOptions copy{.style = ButtonStyle::quiet, .tip = "Copies the events shown, with their times."};
  DropdownOptions o;
  o.width = 132;
  o.tip = "Events to show.";
  ImGui::SetCursorScreenPos(ImVec2(left, top));
  const int picked = dropdown(ui, "happened/filter", "Show", names, static_cast<int>(filter_), o);
  if (picked >= 0) filter_ = static_cast<EventFilter>(picked);
  left += ui.px(o.width + 8);
  ImGui::SetCursorScreenPos(ImVec2(left, top));
  if (button(ui, "happened/copy", "Copy", copy).clicked) {
    ImGui::SetClipboardText(shown_text_.c_str());
    f.toast(Severity::ok, "The events were copied.");
  }
  return left + ui.px(button_width(ui, "Copy", copy));
}

void EventView::draw(Frame& f, float height) {
  const EventLog& log = f.tab.desk().records.events;
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0, 0));
  ImGui::PushStyleColor(ImGuiCol_ChildBg, f.ui[Tone::well]);
  ImGui::BeginChild("happened/log", ImVec2(0, height), false,
                    ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoNav);
  ImGui::PopStyleColor();
  ImGui::PopStyleVar();
  draw_rows(f, log);
  register_text(f, log);
  ImGui::EndChild();
}

void EventView::draw_rows(Frame& f, const EventLog& log) {
  Ui& ui = f.ui;
  const ImVec2 corner = ImGui::GetWindowPos(), size = ImGui::GetWindowSize();
  const float row = ui.px(event_row), scroll = std::floor(ImGui::GetScrollY());
  const float words_at = corner.x + words_begin(ui, log, size.x);
  float y = ui.px(4);
  for (auto event = log.list().rbegin(); event != log.list().rend(); ++event) {
    if (!is_shown(*event, filter_)) continue;
    const float top = corner.y + y - scroll;
    if (top + row > corner.y && top < corner.y + size.y)
      draw_event(f, *event, {ImVec2(corner.x, top), ImVec2(corner.x + size.x, top + row)}, words_at);
    y += row;
  }
  if (y <= ui.px(4))
    draw_text_line(ui, corner.x + ui.px(event_time_x), corner.x + size.x, corner.y + ui.px(4) + row / 2,
                   Face::body, ui[Tone::ink3], "No event of this kind has happened yet.");
  ImGui::SetCursorPos(ImVec2(0, y + ui.px(4)));
  ImGui::Dummy(ImVec2(0, 0));
}

void EventView::register_text(Frame& f, const EventLog& log) {
  if (shown_version_ != log.version() || shown_filter_ != filter_) {
    shown_version_ = log.version(), shown_filter_ = filter_;
    shown_text_ = log.text(filter_, f.tab.desk().records.traffic.clock());
  }
  const ImVec2 corner = ImGui::GetWindowPos(), size = ImGui::GetWindowSize();
  show(f.ui, {.id = "happened/log", .kind = Kind::text, .label = "What happened", .value = shown_text_},
       {corner, ImVec2(corner.x + size.x, corner.y + size.y)});
}

}  // namespace hw::panels
