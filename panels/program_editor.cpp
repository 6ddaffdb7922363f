#include "panels/program_editor.h"

#include "gui/desk.h"
#include "gui/tab.h"

namespace hw::panels {

using namespace gui;

// A text that came from elsewhere (a file, the controller) is one change that can be undone.
void ProgramEditor::take_changes(Frame& f, int slot) {
  ProgramTexts& texts = f.tab.desk().texts;
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

void ProgramEditor::draw(Frame& f, int slot, float width, float height) {
  Ui& ui = f.ui;
  ProgramTexts& texts = f.tab.desk().texts;
  take_changes(f, slot);
  if (comment_mark_.empty()) comment_mark_ = {f.catalog.program.comment, ' '};
  const ProgramState& p = f.now.program;
  const bool runs = p.owned && p.slot == slot && p.run != RunState::idle && p.run != RunState::error;
  EditorLook look;
  look.report = &texts.report(slot);
  look.cost_title = f.catalog.program.capacity_unit;
  look.comment_mark = comment_mark_;
  look.live_line = runs ? texts.live_line(slot, p.command) : -1;
  look.live_told = p.command_told;
  look.live_words = p.run == RunState::held      ? "held here"
                    : p.run == RunState::waiting ? "waits here"
                    : p.command_told             ? ""
                                                 : "worked out";
  look.placeholder = "Type a program, or open one. Simulate tries it before metal moves.";
  look.height = height;
  ImGui::BeginChild("program/editor", ui.px(width, height), false,
                    ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoNav | ImGuiWindowFlags_NoScrollbar |
                        ImGuiWindowFlags_NoScrollWithMouse);
  Slot& s = slots_[static_cast<std::size_t>(slot)];
  if (s.editor.draw(ui, "program/text", look).edited) {
    texts.set_text(slot, s.editor.text());
    s.version = texts.version(slot);
    ui.wake_in(0);  // colours and costs of what was just typed
  }
  ImGui::EndChild();
}

void ProgramEditor::go_to(int slot, int line, int byte) {
  slots_[static_cast<std::size_t>(slot)].editor.go_to({line, byte});
}

}  // namespace hw::panels
