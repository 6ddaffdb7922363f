#include "panels/terminal_log.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/core.h>
#include <imgui_internal.h>

#include "gui/widgets/button.h"
#include "gui/widgets/icons.h"
#include "gui/widgets/text.h"
#include "gui/widgets/touch.h"

namespace hw::panels {

using namespace gui;
namespace {

// Columns in logical pixels from the left edge.
constexpr float time_x = 16, arrow_x = 122, raw_x = 140, meaning_x = 292, row_logical = 20;

/// Received bytes in `tone`, substitutes for unprintable ones in ink3.
float draw_raw(const Ui& ui, ImVec2 at, Tone tone, std::string_view raw) {
  constexpr std::string_view open = "\u2039", close = "\u203A";
  const float left = at.x;
  while (!raw.empty()) {
    const bool mark = raw.starts_with(open);
    std::size_t end = mark ? raw.find(close) : raw.find(open);
    end = end == raw.npos ? raw.size() : mark ? end + close.size() : end;
    const std::string_view part = raw.substr(0, end);
    draw_text(ui, at, Face::code_field, ui[mark && tone == Tone::ink ? Tone::ink3 : tone], part);
    at.x += text_width(ui, Face::code_field, part);
    raw.remove_prefix(end);
  }
  return at.x - left;
}

std::uint64_t first_of(std::uint64_t a, std::uint64_t b) { return std::min(a, b); }

}  // namespace

bool TerminalLog::chosen(const TrafficLog::Row& row) const {
  if (anchor_ == none) return false;
  return row.last >= first_of(anchor_, caret_) && row.first <= std::max(anchor_, caret_);
}

void TerminalLog::draw(Ui& ui, TrafficLog& log, float height) {
  const bool looking = log.update_rows();
  if (looking) ui.wake_in(0);
  if (!log.view().fold_polls) ui.wake_in(0.25);  // a poll requests no frame, but unfolded polls must appear
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0, 0));
  ImGui::PushStyleColor(ImGuiCol_ChildBg, ui[Tone::well]);
  ImGui::BeginChild("terminal/log", ImVec2(0, height), false,
                    ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoNav);
  ImGui::PopStyleColor();
  ImGui::PopStyleVar();
  const float row_height = ui.px(row_logical);
  // At the end of the list only whole rows are shown: the last row is at the bottom, and the first row is not
  // cut.
  const float rows_high = static_cast<float>(log.row_count()) * row_height + ui.px(8);
  const float past = std::max(0.0f, rows_high - height);
  const float whole = past > 0 ? height + std::ceil(past / row_height) * row_height : rows_high;
  if (follow_) ImGui::SetScrollY(std::max(0.0f, whole - height));
  draw_rows(ui, log, row_height);
  choose(ui, log, row_height);
  ImGui::SetCursorPos(ImVec2(0, whole));
  ImGui::Dummy(ImVec2(0, 0));
  // Only input on this list scrolls away from its end; new rows while the mouse is down elsewhere do not.
  const bool wheel = ImGui::GetIO().MouseWheel != 0 && ImGui::IsWindowHovered();
  const bool bar = GImGui->ActiveId == ImGui::GetWindowScrollbarID(ImGui::GetCurrentWindow(), ImGuiAxis_Y);
  if (wheel || bar || dragging_) follow_ = ImGui::GetScrollY() >= whole - height - row_height;
  ImGui::EndChild();
}

void TerminalLog::draw_rows(Ui& ui, TrafficLog& log, float row_height) {
  const ImVec2 corner = ImGui::GetWindowPos();
  size_ = ImGui::GetWindowSize();
  const float scroll = std::floor(ImGui::GetScrollY());
  const float top = corner.y - scroll + ui.px(4);
  // At the end of the list the first row is whole, without a strip of the previous row.
  const float above = follow_ ? scroll : std::max(0.0f, scroll - ui.px(4));
  const auto begin = static_cast<std::size_t>(above / row_height);
  const std::size_t end =
      std::min(log.row_count(), begin + static_cast<std::size_t>(size_.y / row_height) + 2);
  for (std::size_t i = begin; i < end; ++i) {
    const float y = top + static_cast<float>(i) * row_height;
    draw_row(ui, log, log.row(i), {ImVec2(corner.x, y), ImVec2(corner.x + size_.x, y + row_height)});
  }
  register_text(ui, log, {begin, end});
  if (to_toggle_) log.toggle(*std::exchange(to_toggle_, std::nullopt));
}

void TerminalLog::draw_row(Ui& ui, TrafficLog& log, const TrafficLog::Row& row, const Rect& place) {
  ImDrawList* list = ImGui::GetWindowDrawList();
  if (chosen(row)) list->AddRectFilled(place.min, place.max, ui[Tone::sel]);
  if (row.kind != TrafficLog::RowKind::record) return draw_fold(ui, log, row, place);
  const TrafficLog::Line& line = log.line(row);
  const float middle = std::floor(place.centre().y);
  const float text_y = place.min.y;
  draw_text(ui, ImVec2(place.min.x + ui.px(time_x), std::floor(middle - ui.line(Face::code_time) / 2)),
            Face::code_time, ui[Tone::ink3], line.time);
  const bool sent = line.way == Way::sent;
  const bool strange = line.kind == TrafficKind::unparsed;
  const Tone tone = strange ? Tone::warn : Tone::ink;
  draw_icon(list, sent ? Icon::arrow_right : Icon::arrow_left, ImVec2(place.min.x + ui.px(arrow_x), middle),
            ui.px(10),
            ui[strange ? Tone::warn
               : sent  ? Tone::ink2
                       : Tone::motion]);
  const float width = draw_raw(ui, ImVec2(place.min.x + ui.px(raw_x), text_y), tone, line.raw);
  if (line.meaning.empty()) return;
  const float left =
      std::max(place.min.x + ui.px(meaning_x), place.min.x + ui.px(raw_x + 16) + std::ceil(width));
  draw_text_line(ui, left, place.max.x - ui.px(16), middle, Face::body, ui[strange ? Tone::warn : Tone::ink2],
                 line.meaning);
}

void TerminalLog::draw_fold(Ui& ui, TrafficLog& log, const TrafficLog::Row& row, const Rect& place) {
  const TrafficLog::Line& line = log.line(row);
  const float middle = std::floor(place.centre().y);
  const float left = place.min.x + ui.px(time_x + 22);
  const std::string_view verb = row.open ? "Hide" : "Show";
  // The link to unfold is never cut, nor hidden by the scroll bar.
  const float room = place.max.x - ui.px(16 + 6) - std::ceil(text_width(ui, Face::small, verb)) - left;
  const float width = std::min(room, std::ceil(text_width(ui, Face::small, line.raw)));
  draw_text_line(ui, left, left + width, middle, Face::small, ui[Tone::ink3], line.raw);
  char id[48];
  const auto end = fmt::format_to_n(id, sizeof id, "terminal/fold/{}", row.first);
  ImGui::SetCursorScreenPos(ImVec2(left + width + ui.px(6), std::floor(middle - ui.line(Face::small) / 2)));
  if (link(ui, {id, std::min(end.size, sizeof id)}, verb)) {
    to_toggle_ = row;
    follow_ = false;
  }
}

void TerminalLog::choose(Ui& ui, TrafficLog& log, float row_height) {
  const ImVec2 corner = ImGui::GetWindowPos();
  const bool over = ImGui::IsWindowHovered() && GImGui->HoveredId == 0;  // not over a link
  const float scrollbar = ImGui::GetScrollMaxY() > 0 ? ImGui::GetStyle().ScrollbarSize : 0;
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  const auto under_mouse = [&]() -> const TrafficLog::Row* {
    const float y = mouse.y - corner.y + ImGui::GetScrollY() - ui.px(4);
    if (log.row_count() == 0) return nullptr;
    const auto i = static_cast<std::ptrdiff_t>(std::floor(y / row_height));
    return &log.row(static_cast<std::size_t>(
        std::clamp<std::ptrdiff_t>(i, 0, static_cast<std::ptrdiff_t>(log.row_count()) - 1)));
  };
  if (ImGui::IsMouseClicked(0)) active_ = over;
  if (over && ImGui::IsMouseClicked(0) && mouse.x < corner.x + size_.x - scrollbar) {
    ui.focus.set("terminal/log");
    dragging_ = true;
    if (const auto* row = under_mouse()) {
      if (!ImGui::GetIO().KeyShift || anchor_ == none) anchor_ = row->first;
      caret_ = row->last;
    }
  }
  if (dragging_ && ImGui::IsMouseDown(0))
    if (const auto* row = under_mouse()) caret_ = row->last >= anchor_ ? row->last : row->first;
  if (!ImGui::IsMouseDown(0)) dragging_ = false;
  if (!active_ || !ImGui::GetIO().KeyCtrl) return;
  if (ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_A), false) && log.row_count() > 0) {
    anchor_ = log.row(0).first;
    caret_ = log.row(log.row_count() - 1).last;
  }
  if (ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_C), false))
    ImGui::SetClipboardText(copied(log).c_str());
}

std::string TerminalLog::copied(TrafficLog& log) const {
  std::size_t begin = 0, end = log.row_count();
  if (anchor_ != none) {
    const auto from = first_of(anchor_, caret_), to = std::max(anchor_, caret_);
    while (begin < end && log.row(begin).last < from) ++begin;
    while (end > begin && log.row(end - 1).first > to) --end;
  }
  std::string text;
  log.append_rows(text, begin, end);
  return text;
}

// The visible text, for scripts and screen readers; rebuilt only on a change.
void TerminalLog::register_text(Ui& ui, TrafficLog& log, Span visible) {
  if (shown_version_ != log.version() || shown_begin_ != visible.begin) {
    shown_version_ = log.version();
    shown_begin_ = visible.begin;
    shown_text_.clear();
    log.append_rows(shown_text_, visible.begin, visible.end);
  }
  const ImVec2 corner = ImGui::GetWindowPos();
  show(ui, {.id = "terminal/log", .kind = Kind::text, .label = "Traffic", .value = shown_text_},
       {corner, ImVec2(corner.x + size_.x, corner.y + size_.y)});
}

}  // namespace hw::panels
