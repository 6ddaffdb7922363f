#pragma once
// The program panel: text, cost, faults, rehearsal, and the controls that run it.
#include <filesystem>
#include <memory>
#include <string>

#include "core/base/fixed_text.h"
#include "gui/model/desk.h"
#include "gui/shell/panel_entry.h"
#include "gui/widgets/button.h"
#include "gui/widgets/file_dialog.h"
#include "panels/program/compiled_view.h"
#include "panels/program/program_editor.h"
#include "panels/program/rehearsal_card.h"
#include "panels/program/run_doubt.h"
#include "panels/program/threads.h"

namespace hw::panels {

inline constexpr std::string_view text_stays = "There is no link. The text stays here.";

class Program final : public gui::Panel {
 public:
  void draw(gui::Frame& frame) override;

 private:
  void follow(gui::Frame& frame);
  void draw_toolbar(gui::Frame& frame);
  void run(gui::Frame& frame, RunRequest request);
  void draw_simulate(gui::Frame& frame);
  void draw_memory(gui::Frame& frame, float left);
  void draw_slots(gui::Frame& frame);
  float draw_start(gui::Frame& f, float x, float top);
  void draw_more(gui::Frame& f);
  void draw_file_name(gui::Frame& frame, gui::Rect in, float slots_left);
  void draw_file_buttons(gui::Frame& frame);
  void draw_compiled_row(gui::Frame& frame);
  static gui::ButtonOptions file_button_look(const gui::Frame& frame, const char* keys);
  static float file_buttons_width(const gui::Frame& frame);
  void ask_open(const gui::Frame& frame);
  void ask_save(const gui::Frame& frame);
  void draw_work(gui::Frame& frame, float bottom);
  float draw_below(gui::Frame& frame);
  float draw_message(gui::Frame& frame, float top, float bottom);
  void draw_note(gui::Frame& frame, float top, float height);
  float draw_transfer(gui::Frame& frame, float left, float right, float middle);
  float draw_problem_link(gui::Frame& frame, const ProgramReport& report, float right, float middle);
  void draw_dialogs(gui::Frame& frame);
  void shortcuts(gui::Frame& frame);

  void check(gui::Frame& frame);
  void start(gui::Frame& frame, gui::ProgramJob::Goal goal);
  void save(gui::Frame& frame);
  void write(gui::Frame& frame, int slot, const std::filesystem::path& path, bool overwrite);
  void open(gui::Frame& frame, const std::filesystem::path& path);
  void ask_or_open(gui::Frame& frame, const std::filesystem::path& path);
  void ask_or_empty(gui::Frame& frame);
  void find_why_not_run(const gui::Frame& frame);

  ProgramEditor editor_;
  CompiledView compiled_;
  bool view_compiled_ = false;
  RehearsalCard rehearsal_;
  Threads threads_;
  RunDoubt doubt_;
  gui::FileDialog open_, save_;
  bool rehearsal_open_ = false;  ///< medium and narrow windows: true: the column is open instead of the line
  bool asking_replace_ = false, asking_clear_ = false;
  /// The question before a file changed by another program is overwritten. Shared with the job that finds the
  /// change.
  struct Overwrite {
    bool asking = false;
    int slot = 0;
    std::filesystem::path path;
    std::string question;
  };
  std::shared_ptr<Overwrite> overwrite_ = std::make_shared<Overwrite>();
  std::filesystem::path to_open_;  ///< the file that the question is about; empty: a new text
  std::string question_, words_;
  gui::ProgramNote note_;
  std::string note_time_;
  int next_problem_ = -1;
  FixedText<240> why_not_run_;  ///< why the text cannot be run, and until when; empty: it can
};

}  // namespace hw::panels
