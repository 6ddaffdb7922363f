#pragma once
// The wire as it speaks: traffic decoded, and a line to speak to it oneself.
#include <string>
#include <vector>

#include "gui/desk.h"
#include "gui/panel.h"
#include "gui/widgets/text_field.h"
#include "panels/file_prompt.h"
#include "panels/terminal_log.h"

namespace hw::gui {

class TerminalPanel final : public Panel {
 public:
  TerminalPanel();
  void draw(Frame& frame) override;

 private:
  void draw_head(Frame& frame, TrafficLog& log);
  static void draw_lost(Ui& ui, const TrafficLog& log, float left, float right, float middle);
  void act(Frame& frame, TrafficLog& log, std::string_view id);
  void draw_list(Frame& frame);
  void draw_command(Frame& frame);
  void send(Frame& frame);
  bool older_or_newer(std::string& text, int direction);
  bool complete(std::string& text, std::size_t& cursor);

  TerminalLog rows_;
  std::string command_, filter_;
  std::string hint_, hint_of_;  ///< help for the text that it was made of
  LineHelp line_help_;
  Desk* desk_ = nullptr;  ///< while drawing: for the two helpers of the line
  std::size_t history_at_ = 0;
  std::string draft_;                 ///< what was typed before Up was pressed
  std::vector<std::size_t> offered_;  ///< not empty: the list is open
  std::size_t offered_chosen_ = 0;
  bool took_offer_ = false;
  FilePrompt save_;
};

}  // namespace hw::gui
