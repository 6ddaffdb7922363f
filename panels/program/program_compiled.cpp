// Draws the row of a controller that stores programs compiled: shows the compiled text, sends it and reads it
// back.
#include "gui/model/tab.h"
#include "gui/widgets/button.h"
#include "gui/widgets/text.h"
#include "panels/lines.h"
#include "panels/program/program.h"

namespace hw::panels {

using namespace gui;

void Program::draw_compiled_row(Frame& f) {
  if (!f.catalog.program.compiled) return;
  Ui& ui = f.ui;
  Desk& desk = f.tab.desk();
  constexpr float height = 40;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const std::string_view busy = !f.connected()             ? text_stays
                                : desk.programs.job.busy() ? program_in_transfer
                                                           : "";
  ButtonOptions view{.style = ButtonStyle::quiet, .tip = "The lines that are stored in the controller."};
  view.on = view_compiled_;
  const ButtonOptions quiet{.style = ButtonStyle::quiet, .disabled = busy};
  const auto next = [&] { ImGui::SameLine(0, ui.px(4)); };
  ImGui::SetCursorScreenPos(ImVec2(ui.px(f.area.x + 4), at.y + ui.px(4)));
  if (button(ui, "program/view", "View compiled", view).clicked) view_compiled_ = !view_compiled_;
  next();
  if (button(ui, "program/compile", "Compile", {.style = ButtonStyle::quiet}).clicked) check(f);
  next();
  if (button(ui, "program/download", "Download", quiet).clicked) start(f, ProgramJob::Goal::load);
  next();
  if (button(ui, "program/upload", "Upload", quiet).clicked) start(f, ProgramJob::Goal::fetch);
  next();
  if (button(ui, "program/empty", "Empty in controller", quiet).clicked) asking_clear_ = true;
  next();
  if (button(ui, "program/new", "New", {.style = ButtonStyle::quiet}).clicked) ask_or_empty(f);
  draw_line_across(f, at.y + ui.px(height) - ui.hair());
  ImGui::SetCursorScreenPos(ImVec2(at.x, at.y + ui.px(height)));
}

}  // namespace hw::panels
