#pragma once
// The editor of a controller's program texts: the editor widget, fed from the texts and the snapshot. Each
// slot keeps its own caret, selection and undo.
#include <array>
#include <string>

#include "core/device/snapshot.h"
#include "gui/model/program_texts.h"
#include "gui/model/run_follower.h"
#include "gui/shell/frame.h"
#include "gui/widgets/code_editor.h"

namespace hw::panels {

class ProgramEditor {
 public:
  /// Draws at ImGui's cursor, logical size.
  void draw(gui::Frame& frame, int slot, float width, float height);
  /// Scrolls to a line (from 0) and puts the caret there.
  void go_to(int slot, int line, int byte);
  [[nodiscard]] gui::CodeEditor& editor(int slot) { return slots_[static_cast<std::size_t>(slot)].editor; }

 private:
  void take_changes(gui::Frame& frame, int slot);
  void describe_where(const ProgramState& program, const gui::RunFollower::Place& place);

  struct Slot {
    gui::CodeEditor editor;
    std::uint64_t version = 0;  ///< version of ProgramTexts that the editor shows
  };
  std::size_t live_lines_of_threads(const gui::Frame& frame, gui::ProgramTexts& texts);

  std::array<int, max_threads> thread_lines_{};
  std::array<Slot, max_slots> slots_;
  std::string comment_mark_;
  char live_words_[48] = {};
  std::size_t live_size_ = 0;
};

}  // namespace hw::panels
