#pragma once
// The terminal: decoded traffic, and a line for sending commands by hand. The events or the program's log can
// be shown instead of the traffic.
#include <string>
#include <vector>

#include "gui/model/desk.h"
#include "gui/shell/panel_entry.h"
#include "gui/widgets/file_dialog.h"
#include "gui/widgets/text_field.h"
#include "panels/event_view.h"
#include "panels/log_view.h"
#include "panels/terminal_log.h"

namespace hw::panels {

class Terminal final : public gui::Panel {
 public:
  Terminal();
  void draw(gui::Frame& frame) override;

 private:
  void draw_head(gui::Frame& frame, gui::TrafficLog& log);
  float draw_tools(gui::Frame& frame, gui::TrafficLog& log, float left_px, float top_px);
  float draw_traffic_tools(gui::Frame& frame, gui::TrafficLog& log, float left_px, float top_px);
  static void draw_messages_behind(gui::Frame& frame, float left_px, float top_px);
  [[nodiscard]] std::string_view menu_label() const;
  [[nodiscard]] float menu_width(const gui::Ui& ui) const;
  [[nodiscard]] float width_for_messages(const gui::Frame& frame, float room) const;
  void draw_log_menu(gui::Frame& frame);
  void draw_menu_of_log(gui::Frame& frame);
  static void draw_lost(gui::Ui& ui, const gui::TrafficLog& log, float left, float right, float middle);
  void act(gui::Frame& frame, gui::TrafficLog& log, std::string_view id);
  void draw_list(gui::Frame& frame, float bottom_px);
  void draw_command(gui::Frame& frame);
  void make_hint(const gui::Frame& frame);
  float draw_to(gui::Frame& frame, float top);
  void send(gui::Frame& frame);
  bool older_or_newer(std::string& text, int direction);
  bool complete(std::string& text, std::size_t& cursor);

  TerminalLog rows_;
  EventView event_view_;
  enum class Shows : std::uint8_t { traffic, events, log };
  LogView log_;
  Shows shows_ = Shows::traffic;
  std::string command_, filter_;
  bool to_all_ = false;  ///< the next line is sent to all devices of the wire
  std::vector<std::string_view> to_names_;
  gui::CommandHelp::Hint hint_;  ///< help
  std::string hint_of_;          ///< the text to which hint_ belongs
  bool hint_to_all_ = false;     ///< hint_ is for all recipients
  gui::LineHelp line_help_;
  bool with_head_ = true;
  gui::Desk* desk_ = nullptr;  ///< set while drawing, for the two functions of LineHelp
  std::size_t history_at_ = 0;
  std::string draft_;                 ///< typed before Up was pressed
  std::vector<std::size_t> offered_;  ///< candidates; not empty: the list is open
  std::size_t offered_chosen_ = 0;
  bool took_offer_ = false;
  gui::FileDialog save_;
};

}  // namespace hw::panels
