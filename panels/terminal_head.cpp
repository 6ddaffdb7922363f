// The title row of the terminal: the choice of its three lists, their tools, messages.
#include <array>
#include <span>

#include <fmt/core.h>

#include "gui/model/tab.h"
#include "gui/shell/console.h"
#include "gui/widgets/button.h"
#include "gui/widgets/choice.h"
#include "gui/widgets/message.h"
#include "gui/widgets/text.h"
#include "panels/terminal.h"

namespace hw::panels {

using namespace gui;
namespace {

/// Minimum room for a message; and room for the count of lost log entries.
constexpr float messages_at_least = 280, lost_width = 140;
constexpr float wide_filter = 128, narrow_filter = 96, between_tools = 8;
constexpr ButtonOptions log_menu_look{.style = ButtonStyle::quiet};

struct LogTool {
  const char *id, *label, *tip;
  bool* on;  ///< null: an action
};

ButtonOptions look_of_tool(const LogTool& tool) {
  return {.style = tool.on ? ButtonStyle::segment : ButtonStyle::quiet,
          .tip = tool.tip,
          .on = tool.on && *tool.on};
}

/// Tools without room move to the menu: first the log's actions, then the display options.
struct LogTools {
  bool toggles = true, actions = true;
  float filter = wide_filter, space = between_tools, width = 0;
};

LogTools tools_that_fit(Ui& ui, std::span<const LogTool> toggles, std::span<const LogTool> actions,
                        float room) {
  const auto width_of = [&](std::span<const LogTool> tools, float space) {
    float width = 0;
    for (const LogTool& tool : tools) width += button_width(ui, tool.label, look_of_tool(tool)) + space;
    return width;
  };
  LogTools fit;
  const auto measure = [&] {
    fit.width = fit.filter + fit.space + (fit.toggles ? width_of(toggles, fit.space) : 0) +
                (fit.actions ? width_of(actions, 0) : button_width(ui, "More", log_menu_look));
    return fit.width <= room;
  };
  if (measure()) return fit;
  fit.filter = narrow_filter;
  for (const float space : {4.0f, 0.0f}) {
    fit.space = space;
    if (measure()) return fit;
  }
  fit.actions = false;
  if (measure()) return fit;
  fit.toggles = false;
  measure();
  return fit;
}

}  // namespace

void Terminal::draw_head(Frame& f, TrafficLog& log) {
  Ui& ui = f.ui;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const std::string_view events = f.area.width >= 800 ? "What happened" : "Events";
  float x = f.area.x + 16;
  Shows wanted = shows_;
  const auto choose = [&](std::string_view id, std::string_view label, Shows view) {
    const ButtonOptions look{.style = ButtonStyle::segment, .on = shows_ == view};
    ImGui::SetCursorScreenPos(ImVec2(ui.px(x), at.y + ui.px(6)));
    x += button_width(ui, label, look);
    if (button(ui, id, label, look).clicked) wanted = view;
  };
  choose("terminal/view/log", "Terminal", Shows::traffic);
  choose("terminal/view/happened", events, Shows::events);
  choose("terminal/view/decisions", "Log", Shows::log);
  shows_ = wanted;
  const float after = ui.px(x + 12), top = at.y + ui.px(6);
  draw_messages_behind(f, draw_tools(f, log, after, top), top);
  ImGui::SetCursorScreenPos(ImVec2(at.x, at.y + ui.px(44)));
}

/// Of the list that is shown. Returns their right end.
float Terminal::draw_tools(Frame& f, TrafficLog& log, float left, float top) {
  switch (shows_) {
    case Shows::traffic: break;
    case Shows::events: return happened_.draw_tools(f, left, top);
    case Shows::log: return log_.draw_tools(f, left, f.ui.px(f.area.right() - 16), top);
  }
  return draw_traffic_tools(f, log, left, top);
}

/// Messages at the right end of the title row, if it has room for a sentence; else in the status line.
void Terminal::draw_messages_behind(Frame& f, float left, float top) {
  Ui& ui = f.ui;
  const float right = ui.px(f.area.right() - 16), room = right - left - ui.px(16);
  const bool covered = f.console.right_open && f.tier == Tier::medium;
  if (covered || room < ui.px(messages_at_least)) return;
  const float width = std::min(room, ui.px(432));
  draw_messages(ui, f.console.toasts(), {ImVec2(right - width, top), ImVec2(right, top + ui.px(32))});
}

/// At the right; beside them messages, if there is room for both. Returns the end.
float Terminal::draw_traffic_tools(Frame& f, TrafficLog& log, float left, float top) {
  Ui& ui = f.ui;
  TrafficLog::View view = log.view();
  filter_ = view.filter;
  const LogTool toggles[] = {
      {"terminal/decoded", "Decoded", "What the bytes mean, after the manual.", &view.decoded},
      {"terminal/fold", "Polls folded", "What the console asks by itself, in one line that counts.",
       &view.fold_polls},
      {"terminal/hex", "Hex", "Every byte in hexadecimal.", &view.hex},
  };
  const LogTool actions[] = {
      {"terminal/copy", "Copy", "The chosen lines, or all that are shown.", nullptr},
      {"terminal/clear", "Clear", "Empties this list. Nothing is sent.", nullptr},
      {"terminal/save", "Save", "All that is kept, with times, into a file.", nullptr},
  };
  const float right = f.area.right() - 16, whole = right - left / ui.scale;
  const LogTools fit = tools_that_fit(ui, toggles, actions, whole);
  const bool beside = whole - fit.width >= messages_at_least + lost_width + 16;
  const float from = beside ? left / ui.scale : right - fit.width, end = ui.px(from + fit.width);
  float x = from;
  const auto place = [&](float w) {
    ImGui::SetCursorScreenPos(ImVec2(ui.px(x), top));
    x += w;
  };
  for (const LogTool& tool : fit.toggles ? std::span<const LogTool>(toggles) : std::span<const LogTool>()) {
    place(button_width(ui, tool.label, look_of_tool(tool)) + fit.space);
    if (button(ui, tool.id, tool.label, look_of_tool(tool)).clicked) *tool.on = !*tool.on;
  }
  place(fit.filter + fit.space);
  text_field(ui, "terminal/filter", "Filter", filter_, {.placeholder = "Filter", .width = fit.filter});
  view.filter = filter_;
  log.set_view(std::move(view));
  for (const LogTool& tool : fit.actions ? std::span<const LogTool>(actions) : std::span<const LogTool>()) {
    place(button_width(ui, tool.label, look_of_tool(tool)));
    if (button(ui, tool.id, tool.label, look_of_tool(tool)).clicked) act(f, log, tool.id);
  }
  if (!fit.actions) {
    place(0);
    draw_log_menu(f);
  }
  const float lost_from = beside ? end + ui.px(8) : left;
  const float lost_to = beside ? lost_from + ui.px(lost_width) : ui.px(from - 8);
  draw_lost(ui, log, lost_from, lost_to, top + ui.px(16));
  return beside ? lost_to : end;
}

/// The menu of head functions that have no room.
void Terminal::draw_log_menu(Frame& f) {
  if (shows_ == Shows::log) return draw_menu_of_log(f);
  TrafficLog& log = f.tab.desk().traffic;
  TrafficLog::View view = log.view();
  const bool traffic = shows_ == Shows::traffic;
  const std::array<std::string_view, 8> names = {traffic ? "What happened" : "The terminal",
                                                 "The program's log",
                                                 view.decoded ? "Without meanings" : "With meanings",
                                                 view.fold_polls ? "Show all polls" : "Fold polls",
                                                 view.hex ? "As characters" : "In hexadecimal",
                                                 "Copy",
                                                 "Clear",
                                                 "Save"};
  switch (menu(f.ui, "terminal/log_menu", "More", names)) {
    case 0: shows_ = traffic ? Shows::events : Shows::traffic; return;
    case 1: shows_ = Shows::log; return;
    case 2: view.decoded = !view.decoded; break;
    case 3: view.fold_polls = !view.fold_polls; break;
    case 4: view.hex = !view.hex; break;
    case 5: return act(f, log, "terminal/copy");
    case 6: return act(f, log, "terminal/clear");
    case 7: return act(f, log, "terminal/save");
    default: return;
  }
  log.set_view(std::move(view));
}

void Terminal::draw_menu_of_log(Frame& f) {
  constexpr std::array<std::string_view, 5> names = {"The terminal", "What happened", "Log all",
                                                     "Log warnings", "Copy"};
  switch (menu(f.ui, "terminal/log_menu", "More", names)) {
    case 0: shows_ = Shows::traffic; return;
    case 1: shows_ = Shows::events; return;
    case 2: return log::set_level("", log::Level::debug);
    case 3: return log::set_level("", log::Level::warning);
    case 4: return LogView::copy(f);
    default: return;
  }
}

void Terminal::draw_lost(Ui& ui, const TrafficLog& log, float left, float right, float middle) {
  if (log.lost() == 0) return;
  char words[64];
  const auto end = fmt::format_to_n(words, sizeof words, "{} entries missing", log.lost());
  draw_text_line(ui, left, right, middle, Face::small, ui[Tone::warn],
                 {words, std::min(end.size, sizeof words)});
}

void Terminal::act(Frame& f, TrafficLog& log, std::string_view id) {
  if (id == "terminal/save")
    return save_.ask_save("Save the traffic", save_.folder() / "traffic.log", {".log", ".txt"});
  if (id == "terminal/copy") {
    ImGui::SetClipboardText(rows_.copied(log).c_str());
    return f.toast(Severity::ok, "The traffic was copied.");
  }
  log.clear();
  rows_.choose_none();
  rows_.to_the_end();
}

}  // namespace hw::panels
