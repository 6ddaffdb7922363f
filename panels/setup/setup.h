#pragma once
// Shows all parameters of the controller: present value, wanted value, meaning. Nothing is sent before the
// user presses Write; parameters with a warning must be confirmed first.
#include <string>
#include <vector>

#include "gui/model/desk.h"
#include "gui/shell/panel_entry.h"
#include "gui/widgets/file_dialog.h"
#include "panels/setup/setup_list.h"
#include "panels/setup/setup_row.h"

namespace hw::panels {

class Setup final : public gui::Panel {
 public:
  void draw(gui::Frame& frame) override;

 private:
  enum class Show : std::uint8_t { all, changed, off_factory };

  void follow(gui::Frame& frame);
  void draw_toolbar(gui::Frame& frame);
  void draw_write(gui::Frame& frame);
  void draw_store(gui::Frame& frame);
  void draw_file_buttons(gui::Frame& frame, float top_px);
  void draw_filter(gui::Frame& frame);
  void draw_problems(gui::Frame& frame);
  void draw_list(gui::Frame& frame, float width);
  void draw_facts(gui::Frame& frame, float left);
  void draw_explanation(gui::Frame& frame, const ParamInfo& param, float left, float right);
  void draw_question(gui::Frame& frame);
  void draw_files(gui::Frame& frame);
  void write(gui::Frame& frame, bool confirmed);
  void ask_or_write(gui::Frame& frame);
  void taken_from_file(gui::Frame& frame, const Result<Backup>& file, const std::string& name);
  [[nodiscard]] bool listed(const gui::Frame& frame, std::size_t i) const;
  [[nodiscard]] std::string summary(const gui::Frame& frame) const;

  std::vector<SetupRowState> rows_;
  SetupList order_;
  std::string filter_;
  Show show_ = Show::all;
  bool list_changed_ = false;  ///< the list was changed by search or choice, so it scrolls to its top
  std::size_t chosen_ = 0;
  std::vector<std::string> problems_;  ///< problems of the file opened last
  std::string from_file_;
  bool asking_ = false, asked_to_read_ = false;
  std::string question_title_, question_;
  IntentId storing_ = 0;
  gui::FileDialog open_, save_;
};

}  // namespace hw::panels
