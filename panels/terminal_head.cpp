// Draws the title row of the terminal: the choice of its three lists, their tools, and messages.
#include <algorithm>
#include <array>
#include <span>

#include <fmt/core.h>

#include "gui/model/tab.h"
#include "gui/shell/console.h"
#include "gui/widgets/button.h"
#include "gui/widgets/choice.h"
#include "gui/widgets/message.h"
#include "gui/widgets/text.h"
#include "panels/measures.h"
#include "panels/terminal.h"

namespace hw::panels {

using namespace gui;
namespace {

/// Logical widths: for a message with its sentence, at least for a message, and for the count of lost
/// entries.
constexpr float messages_wanted = 280, messages_at_least = 184, before_messages = 16, lost_width = 140;
constexpr float wide_filter = 128, narrow_filter = 96, least_filter = 72, between_tools = 8;
constexpr ButtonOptions log_menu_look{.style = ButtonStyle::quiet};

struct LogTool {
  const char *id, *label, *tip;
  Icon icon;  ///< replaces a label that does not fit; none: the label is short
  bool* on;   ///< null: an action
};

ButtonOptions look_of_tool(const LogTool& tool, bool words) {
  ButtonOptions look{.style = tool.on ? ButtonStyle::segment : ButtonStyle::quiet,
                     .tip = tool.tip,
                     .on = tool.on && *tool.on};
  if (words) return look;
  look.icon = tool.icon;
  look.wordless = tool.icon != Icon::none;
  look.width = look.wordless ? 28 : 40;
  return look;
}

/// The place for messages at the right of the row stays free even while there are none, so that nothing
/// shifts under the mouse when a message arrives. Tools are drawn without their words if that makes them fit.
/// If it does not, they take the whole row, or become a menu.
struct LogTools {
  bool words = true, in_menu = false;
  float filter = wide_filter, space = between_tools, width = 0;

  [[nodiscard]] float width_of(Ui& ui, const LogTool& tool) const {
    const ButtonOptions look = look_of_tool(tool, words);
    return look.width > 0 ? look.width : button_width(ui, tool.label, look);
  }
};

LogTools tools_that_fit(Ui& ui, std::span<const LogTool> toggles, std::span<const LogTool> actions,
                        float room) {
  struct Shape {
    bool words;
    float filter, space, messages;
  };
  constexpr Shape shapes[] = {{true, wide_filter, between_tools, messages_wanted},
                              {true, narrow_filter, 4, messages_wanted},
                              {false, narrow_filter, 4, messages_wanted},
                              {false, least_filter, 0, messages_at_least},
                              {false, least_filter, 0, -before_messages}};
  LogTools fit;
  for (const Shape& shape : shapes) {
    fit = {shape.words, false, shape.filter, shape.space};
    fit.width = fit.filter + fit.space;
    for (const LogTool& tool : toggles) fit.width += fit.width_of(ui, tool) + fit.space;
    for (const LogTool& tool : actions) fit.width += fit.width_of(ui, tool);
    if (fit.width + before_messages + shape.messages <= room) return fit;
  }
  fit.in_menu = true;
  fit.width = fit.filter + fit.space + button_width(ui, "More", log_menu_look);
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

/// Draws the tools of the list that is shown. Returns their right end.
float Terminal::draw_tools(Frame& f, TrafficLog& log, float left, float top) {
  switch (shows_) {
    case Shows::traffic: break;
    case Shows::events: return event_view_.draw_tools(f, left, top);
    case Shows::log: return log_.draw_tools(f, left, f.ui.px(f.area.right() - 16), top);
  }
  return draw_traffic_tools(f, log, left, top);
}

/// Draws messages at the right end of the title row if a sentence fits there. Otherwise the status line shows
/// them.
void Terminal::draw_messages_behind(Frame& f, float left, float top) {
  Ui& ui = f.ui;
  const float right = ui.px(f.area.right() - 16), room = right - left - ui.px(before_messages);
  if (f.console.right_covers() || room < ui.px(messages_at_least)) return;
  const float width = std::min(room, ui.px(432));
  draw_messages(ui, f.console.toasts(), {ImVec2(right - width, top), ImVec2(right, top + ui.px(32))});
}

/// The width for messages beside the menu, where there is no title row. The command line gives it at its end,
/// so that nothing else moves. 0: there is no hint, or too little width.
float Terminal::width_for_messages(const Frame& f, float room) const {
  constexpr float command_at_least = 220, legible = 240;
  if (with_head_ || f.console.right_covers() || f.console.toasts().list().empty()) return 0;
  const float width = std::min(room - command_at_least - close_between, messages_wanted);
  return width < legible ? 0 : width;
}

/// Draws the tools of the traffic. Returns their right end.
float Terminal::draw_traffic_tools(Frame& f, TrafficLog& log, float left, float top) {
  Ui& ui = f.ui;
  TrafficLog::View view = log.view();
  filter_ = view.filter;
  const LogTool toggles[] = {
      {"terminal/decoded", "Decoded", "Shows the meaning of the bytes, from the manual.", Icon::meaning,
       &view.decoded},
      {"terminal/fold", "Polls folded", "Shows the console's own polls in one line with a count.",
       Icon::folded, &view.fold_polls},
      {"terminal/hex", "Hex", "Shows every byte in hexadecimal.", Icon::none, &view.hex},
  };
  const LogTool actions[] = {
      {"terminal/copy", "Copy", "Copies the selected lines, or all lines shown.", Icon::copy, nullptr},
      {"terminal/clear", "Clear", "Empties this list. Nothing is sent.", Icon::empty, nullptr},
      {"terminal/save", "Save", "Saves all recorded lines, with times, into a file.", Icon::save, nullptr},
  };
  const float lost = log.lost() > 0 ? lost_width : 0;
  const float room = f.area.right() - 16 - left / ui.scale - lost;
  const LogTools fit = tools_that_fit(ui, toggles, actions, room);
  float x = left / ui.scale;
  const auto place = [&](float width) {
    ImGui::SetCursorScreenPos(ImVec2(ui.px(x), top));
    x += width;
  };
  const auto draw = [&](const LogTool& tool, float space) {
    place(fit.width_of(ui, tool) + space);
    return button(ui, tool.id, tool.label, look_of_tool(tool, fit.words)).clicked;
  };
  if (!fit.in_menu)
    for (const LogTool& tool : toggles)
      if (draw(tool, fit.space)) *tool.on = !*tool.on;
  place(fit.filter + fit.space);
  text_field(ui, "terminal/filter", "Filter", filter_, {.placeholder = "Filter", .width = fit.filter});
  view.filter = filter_;
  log.set_view(std::move(view));
  if (fit.in_menu) {
    place(button_width(ui, "More", log_menu_look));
    draw_log_menu(f);
  } else {
    for (const LogTool& tool : actions)
      if (draw(tool, 0)) act(f, log, tool.id);
  }
  draw_lost(ui, log, ui.px(x + 8), ui.px(x + lost), top + ui.px(16));
  return ui.px(x + lost);
}

/// The label of the menu, which is the title where there is no title row.
std::string_view Terminal::menu_label() const {
  if (with_head_) return "More";
  switch (shows_) {
    case Shows::traffic: break;
    case Shows::events: return "Events";
    case Shows::log: return "Log";
  }
  return "Terminal";
}

float Terminal::menu_width(const Ui& ui) const {
  ButtonOptions look = log_menu_look;
  if (!with_head_) look.icon_after = Icon::chevron_down;
  return button_width(ui, menu_label(), look);
}

/// Draws the menu of tools that do not fit into the title row.
void Terminal::draw_log_menu(Frame& f) {
  if (shows_ == Shows::log) return draw_menu_of_log(f);
  TrafficLog& log = f.tab.desk().records.traffic;
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
  switch (menu(f.ui, "terminal/log_menu", menu_label(), names, {}, 32, !with_head_)) {
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
  switch (menu(f.ui, "terminal/log_menu", menu_label(), names, {}, 32, !with_head_)) {
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
