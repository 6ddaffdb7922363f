#include "panels/program/program_editor.h"

#include <algorithm>
#include <iterator>

#include <fmt/format.h>

#include "gui/model/desk.h"
#include "gui/model/tab.h"
#include "panels/program/threads.h"

namespace hw::panels {

using namespace gui;

// A text from elsewhere (a file, the controller) is one undoable change.
void ProgramEditor::take_changes(Frame& f, int slot) {
  ProgramTexts& texts = f.tab.desk().programs.texts;
  Slot& s = slots_[static_cast<std::size_t>(slot)];
  if (s.version == texts.version(slot)) return;
  const bool first = s.version == 0;
  s.version = texts.version(slot);
  TextModel& model = s.editor.model();
  if (first)
    s.editor.load(texts.text(slot));
  else if (model.text() != texts.text(slot)) {
    model.replace({TextPlace(), model.end()}, texts.text(slot));
    model.move_to(TextPlace(), false);
  }
}

/// On a controller that runs several programs, each thread reports its line.
std::size_t ProgramEditor::live_lines_of_threads(const Frame& f, ProgramTexts& texts) {
  std::size_t n = 0;
  for (int t = 0; t < std::min(f.catalog.program.threads, max_threads); ++t) {
    const ThreadState& thread = f.now.threads[static_cast<std::size_t>(t)];
    if (!thread.known || !is_busy(thread)) continue;
    if (const int line = texts.live_line(0, thread.line); line >= 0) thread_lines_[n++] = line;
  }
  return n;
}

void ProgramEditor::draw(Frame& f, int slot, float width, float height) {
  Ui& ui = f.ui;
  ProgramTexts& texts = f.tab.desk().programs.texts;
  take_changes(f, slot);
  if (comment_mark_.empty()) comment_mark_ = {f.catalog.program.comment, ' '};
  const ProgramState& p = f.now.program;
  EditorLook look;
  look.report = &texts.report(slot);
  look.cost_title = f.catalog.program.capacity_unit;
  look.comment_mark = comment_mark_;
  const RunFollower::Place place = f.tab.desk().programs.follower.place();
  if (place.slot == slot) {
    look.live_line = texts.live_line(slot, place.command);
    look.live_reported = p.command_reported;
    describe_where(p, place);
    look.live_words = {live_words_, live_size_};
    if (place.next_in_s > 0 && p.run == RunState::running) ui.wake_in(place.next_in_s + 0.01);
  }
  const std::size_t live = live_lines_of_threads(f, texts);
  if (live > 0) {
    look.live_line = thread_lines_[0];
    look.also_live = {thread_lines_.data(), live};
    look.live_reported = true;
    look.live_words = {};
  }
  look.placeholder = "Type a program, or open one. Simulate tries it before metal moves.";
  look.height = height;
  ImGui::BeginChild("program/editor", ui.px(width, height), false,
                    ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoNav | ImGuiWindowFlags_NoScrollbar |
                        ImGuiWindowFlags_NoScrollWithMouse);
  Slot& s = slots_[static_cast<std::size_t>(slot)];
  if (s.editor.draw(ui, "program/text", look).edited) {
    texts.set_text(slot, s.editor.text());
    s.version = texts.version(slot);
    ui.wake_in(0);  // shows colours and costs of the latest typing
  }
  f.tab.desk().programs.caret_line = s.editor.model().caret().line;
  ImGui::EndChild();
}

/// "pass 7 of 20, worked out"
void ProgramEditor::describe_where(const ProgramState& p, const RunFollower::Place& place) {
  const std::string_view how = p.run == RunState::held      ? "held here"
                               : p.run == RunState::waiting ? "waits here"
                               : p.command_reported         ? ""
                                                            : "worked out";
  char* end = live_words_;
  const auto add = [&](const char* format, const auto&... values) {
    const auto room = static_cast<std::size_t>(std::end(live_words_) - end);
    end += std::min(fmt::format_to_n(end, room, fmt::runtime(format), values...).size, room);
  };
  if (place.passes > 1)
    add("pass {} of {}", place.pass, place.passes);
  else if (place.passes == 0 && place.pass > 1)
    add("pass {}", place.pass);
  if (!how.empty()) add("{}{}", end == live_words_ ? "" : ", ", how);
  live_size_ = static_cast<std::size_t>(end - live_words_);
}

void ProgramEditor::go_to(int slot, int line, int byte) {
  slots_[static_cast<std::size_t>(slot)].editor.go_to({line, byte});
}

}  // namespace hw::panels
