#pragma once
// The program: text, what it costs, what is wrong with it, what it would do, and the controller that runs it.
#include <filesystem>
#include <memory>
#include <string>

#include "gui/desk.h"
#include "gui/panel.h"
#include "gui/widgets/button.h"
#include "panels/file_prompt.h"
#include "panels/program_editor.h"
#include "panels/rehearsal_card.h"

namespace hw::gui {

class ProgramPanel final : public Panel {
 public:
  void draw(Frame& frame) override;

 private:
  void follow(Frame& frame);
  void draw_toolbar(Frame& frame);
  void draw_memory(Frame& frame, float left);
  void draw_slots(Frame& frame);
  void draw_file_buttons(Frame& frame);
  static ButtonOptions file_button_look(const Frame& frame, const char* keys);
  static float file_buttons_width(const Frame& frame);
  [[nodiscard]] std::filesystem::path suggested_name(const Frame& frame) const;
  void draw_work(Frame& frame, float bottom);
  float draw_below(Frame& frame);
  void draw_note(Frame& frame, float top, float height);
  float draw_problem_link(Frame& frame, const ProgramReport& report, float right, float middle);
  void draw_ask(Frame& frame, float top);
  void draw_dialogs(Frame& frame);
  void shortcuts(Frame& frame);

  void run(Frame& frame, bool stepping);
  void simulate(Frame& frame);
  void check(Frame& frame);
  void start(Frame& frame, ProgramJob::Goal goal);
  void save(Frame& frame);
  void save_as(Frame& frame, const std::filesystem::path& path);
  void open(Frame& frame, const std::filesystem::path& path);
  void ask_or_open(Frame& frame, const std::filesystem::path& path);
  [[nodiscard]] std::string_view why_not_run(const Frame& frame) const;

  ProgramEditor editor_;
  RehearsalCard rehearsal_;
  FilePrompt open_, save_;
  bool rehearsal_open_ = false;  ///< medium and narrow: the column instead of the line
  bool asking_replace_ = false, asking_clear_ = false;
  std::filesystem::path to_open_;
  std::string question_, words_;
  ProgramNote note_;
  std::string note_time_;
  int next_problem_ = -1;
};

}  // namespace hw::gui
