#include "panels/log_view.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>

#include <fmt/core.h>

#include "core/base/log_levels.h"
#include "gui/shell/console.h"
#include "gui/widgets/button.h"
#include "gui/widgets/choice.h"
#include "gui/widgets/icons.h"
#include "gui/widgets/text.h"
#include "gui/widgets/text_field.h"
#include "gui/widgets/touch.h"

namespace hw::panels {

using namespace gui;
using log::Level;
namespace {

constexpr float log_row = 20, log_time_x = 16, log_mark_x = 130, subject_x = 146;
constexpr std::array<std::string_view, 4> least_names = {"errors", "warnings", "info", "all lines"};
constexpr std::array<std::string_view, 6> level_names = {"log nothing", "log errors", "log warnings",
                                                         "log info",    "log all",    "log mixed"};
constexpr int mixed_level = 5;  // shown, but not a choice: the parts of the subject have different levels
static_assert(static_cast<int>(Level::debug) + 1 == mixed_level);

struct LevelLook {
  Icon icon;
  Tone tone;
};

LevelLook look_of(Level level) {
  switch (level) {
    case Level::error: return {Icon::diamond_solid, Tone::fault};
    case Level::warning: return {Icon::warning, Tone::warn};
    case Level::info: return {Icon::info, Tone::ink2};
    default: return {Icon::none, Tone::ink3};
  }
}

struct LogToolWidths {
  float family, least, level, gap;
};
constexpr LogToolWidths wide = {112, 112, 128, 8}, narrow = {92, 98, 120, 4};
constexpr float words_at_least = 60, words_at_most = 160;

}  // namespace

LogView::LogView() {
  families_.push_back("all");
  for (const std::string_view family : log::families()) families_.push_back(family);
}

float LogView::draw_tools(PageFrame& f, float left, float right, float top) {
  Ui& ui = f.ui;
  const ButtonOptions copy_look{.style = ButtonStyle::quiet, .tip = "Copies the lines shown."};
  const float copy_width = button_width(ui, "Copy", copy_look);
  const auto room_for_words = [&](const LogToolWidths& w) {
    return (right - left) / ui.scale - (w.family + w.least + w.level + 4 * w.gap + copy_width);
  };
  const LogToolWidths& w = room_for_words(wide) >= words_at_most ? wide : narrow;
  const float words = std::clamp(room_for_words(w), words_at_least, words_at_most);
  float x = left;
  const auto fits = [&](float width) {  // tools that do not fit are left out
    if (x + ui.px(width) > right) return false;
    ImGui::SetCursorScreenPos(ImVec2(x, top));
    x += ui.px(width + w.gap);
    return true;
  };
  wanted_ = f.console.log.view();
  const auto family = std::find(families_.begin() + 1, families_.end(), wanted_.family);
  family_ = family == families_.end() ? 0 : static_cast<std::size_t>(family - families_.begin());
  if (fits(w.family)) draw_family(f, w.family);
  if (fits(w.least)) draw_least(f, w.least);
  if (fits(words))
    text_field(ui, "decisions/words", "Words", wanted_.words, {.placeholder = "Find", .width = words});
  f.console.log.set_view(wanted_);
  if (fits(w.level)) draw_level(f, w.level);
  if (fits(copy_width) && button(ui, "decisions/copy", "Copy", copy_look).clicked) copy(f);
  return x;
}

void LogView::copy(PageFrame& f) {
  std::string text;
  f.console.log.append_text(text, 0, f.console.log.count());
  ImGui::SetClipboardText(text.c_str());
  f.toast(Severity::ok, "The log lines were copied.");
}

void LogView::draw_family(PageFrame& f, float width) {
  DropdownOptions o;
  o.width = width;
  o.tip = "Show lines of this part of the program.";
  const int picked = dropdown(f.ui, "decisions/subject", "Subject", families_, static_cast<int>(family_), o);
  if (picked < 0) return;
  family_ = static_cast<std::size_t>(picked);
  wanted_.family = family_ == 0 ? std::string_view() : families_[family_];
}

void LogView::draw_least(PageFrame& f, float width) {
  DropdownOptions o;
  o.width = width;
  o.tip = "Show lines from this level up.";
  const int picked =
      dropdown(f.ui, "decisions/shown", "Shown", least_names, static_cast<int>(wanted_.least) - 1, o);
  if (picked >= 0) wanted_.least = static_cast<Level>(picked + 1);
}

void LogView::draw_level(PageFrame& f, float width) {
  DropdownOptions o;
  o.width = width;
  o.tip =
      "Level of the chosen subject from now on, here, in the file and on standard error. \u201cLog all\u201d "
      "also logs each decision.";
  const std::string_view path = family_ == 0 ? std::string_view() : families_[family_];
  const std::optional<Level> level = log::common_level(path);
  const int shown = level ? static_cast<int>(*level) : static_cast<int>(level_names.size()) - 1;
  const std::span<const std::string_view> names =
      std::span(level_names).first(level_names.size() - (level ? 1 : 0));
  const int picked = dropdown(f.ui, "decisions/level", "Log", names, shown, o);
  if (picked >= 0 && picked != mixed_level) log::set_level(path, static_cast<Level>(picked));
}

void LogView::draw(PageFrame& f, float height) {
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0, 0));
  ImGui::PushStyleColor(ImGuiCol_ChildBg, f.ui[Tone::well]);
  ImGui::BeginChild("decisions/log", ImVec2(0, height), false,
                    ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoNav);
  ImGui::PopStyleColor();
  ImGui::PopStyleVar();
  register_text(f, draw_rows(f));
  ImGui::EndChild();
}

LogView::Rows LogView::draw_rows(PageFrame& f) {
  Ui& ui = f.ui;
  const LogLines& log = f.console.log;
  const ImVec2 corner = ImGui::GetWindowPos(), size = ImGui::GetWindowSize();
  const float row = ui.px(log_row), scroll = std::floor(ImGui::GetScrollY());
  const float pad = ui.px(4) + draw_lost(ui, log.lost(), corner.y + ui.px(4) - scroll);
  if (shown_version_ != log.version()) {
    subject_width_ = 0;
    for (std::size_t i = 0; i < log.count(); ++i)
      subject_width_ = std::max(subject_width_, text_width(ui, Face::body_bold, log.line(i).subject));
  }
  const float words_at = corner.x + std::min(ui.px(subject_x + 12) + std::ceil(subject_width_), size.x / 2);
  const auto first = static_cast<std::size_t>(std::max(0.0f, scroll - pad) / row);
  const Rows visible{std::min(first, log.count()),
                     std::min(log.count(), first + static_cast<std::size_t>(size.y / row) + 2)};
  for (std::size_t i = visible.begin; i < visible.end; ++i) {
    const float top = corner.y + pad + static_cast<float>(i) * row - scroll;
    draw_row(ui, log.line(i), {ImVec2(corner.x, top), ImVec2(corner.x + size.x, top + row)}, words_at);
  }
  if (log.count() == 0)
    draw_text_line(ui, corner.x + ui.px(log_time_x), corner.x + size.x - ui.px(16), corner.y + pad + row / 2,
                   Face::body, ui[Tone::ink3],
                   "No line for this list has been logged yet. Choose \u201clog all\u201d to see each "
                   "decision from now on.");
  ImGui::SetCursorPos(ImVec2(0, static_cast<float>(log.count()) * row + pad + ui.px(4)));
  ImGui::Dummy(ImVec2(0, 0));
  return visible;
}

/// Draws the first row if lines are missing. Returns its height.
float LogView::draw_lost(const Ui& ui, std::uint64_t lost, float top) {
  if (lost == 0) return 0;
  char words[96];
  const auto end =
      fmt::format_to_n(words, sizeof words, "{} lines came too fast for this list: see the file.", lost);
  const ImVec2 corner = ImGui::GetWindowPos();
  draw_text_line(ui, corner.x + ui.px(log_time_x), corner.x + ImGui::GetWindowWidth() - ui.px(16),
                 top + ui.px(log_row) / 2, Face::body, ui[Tone::warn],
                 {words, std::min(end.size, sizeof words)});
  return ui.px(log_row);
}

void LogView::draw_row(const Ui& ui, const log::Line& line, const Rect& place, float words_at) {
  const float middle = std::floor(place.centre().y);
  draw_text(ui, ImVec2(place.min.x + ui.px(log_time_x), std::floor(middle - ui.line(Face::code_time) / 2)),
            Face::code_time, ui[Tone::ink3], line.time);
  const LevelLook mark = look_of(line.level);
  draw_icon(ImGui::GetWindowDrawList(), mark.icon, ImVec2(place.min.x + ui.px(log_mark_x), middle), ui.px(12),
            ui[mark.tone]);
  draw_text_line(ui, place.min.x + ui.px(subject_x), words_at - ui.px(8), middle, Face::body_bold,
                 ui[Tone::ink2], line.subject);
  draw_text_line(ui, words_at, place.max.x - ui.px(16), middle, Face::body, ui[Tone::ink], line.sentence);
}

// Rebuilt only on a change.
void LogView::register_text(PageFrame& f, Rows visible) {
  const LogLines& log = f.console.log;
  if (shown_version_ != log.version() || shown_rows_.begin != visible.begin ||
      shown_rows_.end != visible.end) {
    shown_version_ = log.version(), shown_rows_ = visible;
    shown_text_.clear();
    log.append_text(shown_text_, visible.begin, visible.end);
  }
  const ImVec2 corner = ImGui::GetWindowPos(), size = ImGui::GetWindowSize();
  show(f.ui, {.id = "decisions/log", .kind = Kind::text, .label = "Log", .value = shown_text_},
       {corner, ImVec2(corner.x + size.x, corner.y + size.y)});
}

}  // namespace hw::panels
