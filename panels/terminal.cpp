#include "panels/terminal.h"

#include <algorithm>
#include <array>

#include <fmt/core.h>
#include <imgui_internal.h>

#include "core/session/user_files.h"
#include "gui/model/tab.h"
#include "gui/shell/console.h"
#include "gui/widgets/button.h"
#include "gui/widgets/choice.h"
#include "gui/widgets/message.h"
#include "gui/widgets/text.h"
#include "panels/measures.h"
#include "panels/widget_path.h"

namespace hw::panels {

using namespace gui;

Terminal::Terminal() {
  line_help_.history = [this](std::string& text, int direction) { return older_or_newer(text, direction); };
  line_help_.complete = [this](std::string& text, std::size_t& cursor) { return complete(text, cursor); };
}

void Terminal::draw(Frame& f) {
  Desk& desk = f.tab.desk();
  desk_ = &desk;
  constexpr float head = 44, command_row = 48;
  with_head_ = f.area.height >= head + command_row + 3 * 20;
  if (with_head_) draw_head(f, desk.records.traffic);
  const float bottom = f.ui.px(f.area.bottom());
  const float left_for_log = bottom - ImGui::GetCursorScreenPos().y - f.ui.px(command_row);
  const float height = std::max(left_for_log, f.ui.px(20));
  switch (shows_) {
    case Shows::traffic: rows_.draw(f.ui, desk.records.traffic, height); break;
    case Shows::events: event_view_.draw(f, height); break;
    case Shows::log: log_.draw(f, height); break;
  }
  if (!offered_.empty()) draw_list(f, bottom - f.ui.px(command_row));
  draw_command(f);
  if (const auto path = save_.draw(f.ui)) {
    f.withdraw(&save_);  // the message why the log was not saved
    desk.work.worker().run(
        [path = *path, text = desk.records.traffic.text_of_all()] { return write_file(path, text); },
        [&console = f.console, path = *path, attempt = &save_](Result<> written) {
          if (written)
            console.toast(Severity::ok, fmt::format("The traffic was saved as {}.", path.string()));
          else
            console.toast(Severity::fault, written.error().sentence(), attempt);
        },
        desk.work.alive());
  }
  desk_ = nullptr;
}

// ---- the line
// ----------------------------------------------------------------------------------------------

bool Terminal::older_or_newer(std::string& text, int direction) {
  if (!offered_.empty()) {
    const std::size_t n = offered_.size();
    offered_chosen_ = (offered_chosen_ + n + static_cast<std::size_t>(direction + static_cast<int>(n))) % n;
    text = desk_->help.with(text, offered_[offered_chosen_]);
    took_offer_ = true;
    return true;
  }
  const auto& history = desk_->history;
  if (direction < 0 && history_at_ == history.size()) draft_ = text;
  if (direction < 0 ? history_at_ == 0 : history_at_ >= history.size()) return false;
  direction < 0 ? --history_at_ : ++history_at_;
  text = history_at_ == history.size() ? draft_ : history[history_at_];
  return true;
}

// Tab completes the unambiguous part. If there is none, it lists the candidates.
bool Terminal::complete(std::string& text, std::size_t& cursor) {
  std::string longer = desk_->help.complete(text);
  if (longer != text) {
    text = std::move(longer);
    cursor = text.size();
    return true;
  }
  offered_ = offered_.empty() ? desk_->help.candidates(text) : std::vector<std::size_t>();
  offered_chosen_ = offered_.size();
  if (!offered_.empty()) offered_chosen_ = offered_.size() - 1;
  return false;
}

/// Draws a command of the list. Returns true when it was clicked.
static bool draw_offer(Ui& ui, const CommandInfo& command, bool chosen, float row, float help_at) {
  char id[64];
  const auto end = fmt::format_to_n(id, sizeof id, "terminal/offer/{}", command.form);
  const Touch t = touch(ui,
                        {.id = {id, std::min(end.size, sizeof id)},
                         .kind = Kind::row,
                         .label = command.form,
                         .value = command.help},
                        ImVec2(ImGui::GetContentRegionAvail().x, row));
  if (chosen && !ImGui::IsItemVisible()) ImGui::SetScrollHereY(0.5f);
  if (t.hovered || chosen) draw_fill(ui, t.rect, ui[Tone::hover], 0);
  const float middle = std::floor(t.rect.centre().y);
  const float help_x = t.rect.min.x + help_at;
  draw_text_line(ui, t.rect.min.x + ui.px(16), help_x - ui.px(22), middle, Face::code_field, ui[Tone::ink],
                 command.form);
  if (command.moves)
    draw_icon(ImGui::GetWindowDrawList(), Icon::play, ImVec2(help_x - ui.px(14), middle), ui.px(9),
              ui[Tone::motion]);
  draw_text_line(ui, help_x, t.rect.max.x - ui.px(16), middle, Face::body, ui[Tone::ink2], command.help);
  return t.clicked;
}

/// The list covers everything above the command line, so that it fits in a small terminal. The command line
/// keeps the keyboard.
void Terminal::draw_list(Frame& f, float bottom) {
  Ui& ui = f.ui;
  const float row = ui.px(24), shown = static_cast<float>(std::min<std::size_t>(offered_.size(), 8));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0, 0));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, ui.hair());
  ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, ImVec2(1, 1));
  ImGui::PushStyleColor(ImGuiCol_WindowBg, ui[Tone::raised]);
  ImGui::SetNextWindowPos(ImVec2(ui.px(f.area.x), bottom - shown * row));
  ImGui::SetNextWindowSize(ImVec2(ui.px(f.area.width), shown * row));
  ImGui::Begin("terminal/offered", nullptr,
               ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
                   ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoNav |
                   ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_NoBringToFrontOnFocus);
  ImGui::PopStyleColor();
  ImGui::PopStyleVar(3);
  ui.take_arrows();
  // As with every list, a press outside closes it.
  const bool outside = ImGui::IsMouseClicked(0) && !ImGui::IsWindowHovered(ImGuiHoveredFlags_ChildWindows);
  if (ImGui::IsWindowAppearing()) ImGui::BringWindowToDisplayFront(ImGui::GetCurrentWindow());
  // The help begins after the longest form. A form that would leave no width for its help is cut.
  float help_at = ui.px(140);
  for (const std::size_t offered : offered_)
    help_at =
        std::max(help_at, text_width(ui, Face::code_field, f.catalog.commands[offered].form) + ui.px(40));
  help_at = std::min(help_at, ui.px(f.area.width) / 2);
  for (std::size_t i = 0; i < offered_.size(); ++i) {
    if (!draw_offer(ui, f.catalog.commands[offered_[i]], took_offer_ && i == offered_chosen_, row, help_at))
      continue;
    command_ = desk_->help.with(command_, offered_[i]);
    offered_.clear();
    took_offer_ = false;
    type_into(ui, "terminal/command");
    break;
  }
  ImGui::End();
  if (outside) offered_.clear();
}

/// "all 4 motors"; if not all devices of the wire are open: "all devices of the wire".
static Path devices_meant_by_all(const Frame& f) {
  if (f.tab.bus) return Path("all {} motors", f.tab.bus->members.size());
  return Path("all devices of the wire");
}

void Terminal::make_hint(const Frame& f) {
  if (hint_of_ == command_ && hint_to_all_ == to_all_) return;
  hint_of_ = command_;
  hint_to_all_ = to_all_;
  hint_ = f.tab.desk().help.hint(command_);
  if (to_all_ && !command_.empty())
    hint_.sentence = fmt::format("to {}: {}", devices_meant_by_all(f).view(), hint_.sentence);
}

void Terminal::draw_command(Frame& f) {
  Ui& ui = f.ui;
  const float top = ui.px(f.area.bottom() - 40);
  ImGui::GetWindowDrawList()->AddRectFilled(
      ImVec2(ui.px(f.area.x), ui.px(f.area.bottom() - 48)),
      ImVec2(ui.px(f.area.right()), ui.px(f.area.bottom() - 48) + ui.hair()), ui[Tone::line]);
  make_hint(f);
  ButtonOptions send_look;
  send_look.icon_after = Icon::enter;
  send_look.disabled = f.connected() ? "" : "There is no link. What you type stays here.";
  send_look.moving = hint_.moves;
  const float send_width = button_width(ui, "Send", send_look);
  const float menu = with_head_ ? 0 : menu_width(ui);
  const float to_width = draw_to(f, f.area.bottom() - 40);
  const float room = f.area.width - 40 - send_width - menu - to_width;
  const float messages = width_for_messages(f, room);
  ImGui::SetCursorScreenPos(ImVec2(ui.px(f.area.x + 16 + to_width), top));
  const FieldOptions look{.placeholder = "Command, or Tab for the list",
                          .hint = hint_.sentence,
                          .prompt = Icon::prompt,
                          .face = Face::code_field,
                          .width = messages > 0 ? room - messages - close_between : room,
                          .keep_focus = true,
                          .help = &line_help_};
  const Field field = text_field(ui, "terminal/command", "Command", command_, look);
  if (field.edited && !took_offer_) offered_.clear();
  if (!with_head_) {
    const float left = ui.px(f.area.right() - 20 - send_width - menu);
    if (messages > 0)
      draw_messages(ui, f.console.toasts(),
                    {ImVec2(left - ui.px(close_between + messages), top),
                     ImVec2(left - ui.px(close_between), top + ui.px(32))});
    ImGui::SetCursorScreenPos(ImVec2(left, top));
    draw_log_menu(f);
  }
  ImGui::SetCursorScreenPos(ImVec2(ui.px(f.area.right() - 16 - send_width), top));
  const bool sent = button(ui, "terminal/send", "Send", send_look).clicked;
  if (ui.cancelled()) offered_.clear();
  if (field.entered && !offered_.empty() && took_offer_) {
    offered_.clear();
    took_offer_ = false;
    return;
  }
  if (sent || field.entered) send(f);
}

/// Draws the choice of recipients, if there is one: the devices of the wire, or all of them at once. Returns
/// its width.
float Terminal::draw_to(Frame& f, float top) {
  const std::string_view own = f.tab.id();
  if (own.empty() && !f.catalog.can.broadcast) return 0;
  to_names_.clear();
  int chosen = 0;
  if (f.tab.bus)
    for (const Tab* member : f.tab.bus->members) {
      if (member == &f.tab) chosen = static_cast<int>(to_names_.size());
      to_names_.push_back(member->id());
    }
  else
    to_names_.push_back(own.empty() ? std::string_view("this") : own);
  if (f.catalog.can.broadcast) to_names_.push_back("all");
  if (!f.catalog.can.broadcast) to_all_ = false;
  if (to_all_) chosen = static_cast<int>(to_names_.size()) - 1;
  constexpr float width = 72;
  ImGui::SetCursorScreenPos(f.ui.px(f.area.x + 16, top));
  DropdownOptions o;
  o.width = width;
  o.tip = "The device that the line goes to. all: every device of the wire; none of them replies.";
  const int picked = dropdown(f.ui, "terminal/to", "To", to_names_, chosen, o);
  if (picked >= 0) {
    to_all_ = f.catalog.can.broadcast && picked + 1 == static_cast<int>(to_names_.size());
    if (!to_all_ && f.tab.bus && f.tab.bus->members[static_cast<std::size_t>(picked)] != &f.tab)
      f.console.activate(*f.tab.bus->members[static_cast<std::size_t>(picked)]);
  }
  return width + 8;
}

void Terminal::send(Frame& f) {
  if (command_.empty()) return;
  if (!f.connected())
    return f.toast(Severity::warn, "There is no link. Nothing was sent; what you typed stays here.", &f.tab);
  f.send(intent::SendText(command_, to_all_));
  if (to_all_)
    f.toast(Severity::plain,
            fmt::format("Sent to {}. None of them replies to that.", devices_meant_by_all(f).view()));
  to_all_ = false;  // the choice is for one line, so that the next line does not go to all by oversight
  auto& history = f.tab.desk().history;
  if (history.empty() || history.back() != command_) history.push_back(command_);
  constexpr std::size_t remembered = 200;
  if (history.size() > remembered) history.erase(history.begin());
  history_at_ = history.size();
  command_.clear();
  draft_.clear();
  offered_.clear();
  took_offer_ = false;
  rows_.to_the_end();
}

}  // namespace hw::panels
