#include "panels/program/overwrite_question.h"

#include "gui/model/tab.h"
#include "gui/widgets/button.h"
#include "gui/widgets/message.h"
#include "gui/widgets/text.h"

namespace hw::panels {

using namespace gui;

float overwrite_question_height(const Frame& f) {
  const ProgramJob& job = f.tab.desk().programs.job;
  if (job.stage() != ProgramJob::Stage::asking) return 0;
  return wrapped_height(f.ui, Face::body, job.question(), f.ui.px(f.area.width - 52)) +
         f.ui.px(12 + 8 + 32 + 12);
}

void draw_overwrite_question(Frame& f, float top, float height) {
  Ui& ui = f.ui;
  Desk& desk = f.tab.desk();
  ImGui::SetCursorScreenPos(ImVec2(ui.px(f.area.x), top));
  tinted(ui, Severity::warn, height);
  const float left = ui.px(f.area.x + 16);
  draw_icon(ImGui::GetWindowDrawList(), Icon::warning, ImVec2(left + ui.px(6), top + ui.px(22)), ui.px(12),
            ui[Tone::warn]);
  ImGui::SetCursorScreenPos(ImVec2(left + ui.px(20), top + ui.px(12)));
  wrapped(ui, Face::body, Tone::ink, desk.programs.job.question(), f.area.width - 52);
  ImGui::SetCursorScreenPos(ImVec2(left + ui.px(20), top + height - ui.px(44)));
  const auto send = [&](IntentBody body) { return f.send_and_watch(std::move(body)); };
  const auto choice = [&](const char* id, const char* label, ButtonStyle style, ProgramJob::Answer answer) {
    if (button(ui, id, label, {.style = style}).clicked)
      desk.programs.job.answer(answer, desk.programs.texts, send);
    ImGui::SameLine(0, ui.px(8));
  };
  choice("program/ask/overwrite", "Overwrite it", ButtonStyle::outlined, ProgramJob::Answer::overwrite);
  choice("program/ask/fetch", "Load it here instead", ButtonStyle::outlined,
         ProgramJob::Answer::fetch_instead);
  choice("program/ask/leave", "Leave it", ButtonStyle::outlined, ProgramJob::Answer::leave);
}

}  // namespace hw::panels
