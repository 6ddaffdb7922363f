// Draws the area between the row of files and the terminal: editor, rehearsal, and below them a line that
// compares text and controller, or the question before a program is overwritten.
#include <cmath>

#include <fmt/core.h>

#include "gui/model/tab.h"
#include "gui/shell/console.h"
#include "gui/widgets/button.h"
#include "gui/widgets/message.h"
#include "gui/widgets/slider.h"
#include "gui/widgets/text.h"
#include "panels/lines.h"
#include "panels/program/overwrite_question.h"
#include "panels/program/program.h"
#include "panels/program/threads.h"

namespace hw::panels {

using namespace gui;
namespace {

constexpr float note_height = 40, line_height = 36, rehearsal_width = 272, least_editor = 56;

bool column_fits(const Frame& f) { return f.tier == Tier::wide && f.area.width >= 760; }

}  // namespace

void Program::draw_work(Frame& f, float bottom) {
  Ui& ui = f.ui;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float height = (bottom - at.y) / ui.scale;
  const int slot = f.tab.desk().programs.texts.chosen();
  if (height < 24) return;
  const bool column = column_fits(f) || rehearsal_open_;
  const float side = column ? rehearsal_width : 0;
  ImGui::SetCursorScreenPos(ImVec2(ui.px(f.area.x), at.y));
  if (view_compiled_)
    compiled_.draw(f, slot, f.area.width - side, height);
  else
    editor_.draw(f, slot, f.area.width - side, height);
  if (!column) return;
  const float x = ui.px(f.area.right() - side);
  ImGui::GetWindowDrawList()->AddRectFilled(ImVec2(x, at.y), ImVec2(x + ui.hair(), bottom), ui[Tone::line]);
  ImGui::SetCursorScreenPos(ImVec2(x + ui.hair(), at.y));
  if (rehearsal_.draw_column(f, slot, side - 1, height))
    f.tab.desk().programs.requests.rehearse(f.now, f.bench);
}

// Draws the parts below the editor, from the bottom up. Returns the bottom of the editor. Thread controls are
// lowest, temporary parts highest, so that they take their height only from the editor.
float Program::draw_below(Frame& f) {
  Ui& ui = f.ui;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  float y = ui.px(f.area.bottom());
  if (const float threads = threads_height(f.catalog, f.area.width); threads > 0) {
    y -= ui.px(threads);
    threads_.draw(f, y);
  }
  if (!column_fits(f) && y - at.y - overwrite_question_height(f) > ui.px(120)) {
    y -= ui.px(line_height);
    ImGui::SetCursorScreenPos(ImVec2(at.x, y));
    const int slot = f.tab.desk().programs.texts.chosen();
    if (rehearsal_.draw_line(f, slot, rehearsal_open_)) rehearsal_open_ = !rehearsal_open_;
  }
  y = draw_message(f, at.y, y);
  ImGui::SetCursorScreenPos(at);
  return y;
}

/// Draws a question, or the line that compares text and controller, above `bottom`. Returns its top.
float Program::draw_message(Frame& f, float top, float bottom) {
  Ui& ui = f.ui;
  Desk& desk = f.tab.desk();
  if (const float height = overwrite_question_height(f); height > 0) {
    draw_overwrite_question(f, bottom - height, height);
    return bottom - height;
  }
  const int slot = desk.programs.texts.chosen();
  const HeldProgram& held = desk.programs.texts.held(slot);
  if (held.known) note_time_ = f.console.time_of_day(held.at);
  note_ = program_note(desk.programs.texts, slot, f.now, f.catalog.program, note_time_);
  words_ = desk.programs.job.words(f.catalog.program, f.now.transfer);
  const bool roomy = bottom - top > ui.px(note_height + least_editor);
  if (!roomy || (words_.empty() && note_.sentence.empty())) return bottom;
  draw_note(f, bottom - ui.px(note_height), note_height);
  return bottom - ui.px(note_height);
}

void Program::draw_note(Frame& f, float top, float height) {
  Ui& ui = f.ui;
  draw_line_across(f, top);
  const float middle = top + ui.px(height / 2), left = ui.px(f.area.x + 16);
  const bool busy = !words_.empty();
  const Severity severity = busy ? Severity::motion : note_.severity;
  const Icon icon = severity == Severity::warn    ? Icon::warning
                    : severity == Severity::fault ? Icon::diamond_solid
                    : busy                        ? Icon::clock
                                                  : Icon::info;
  const Tone tone = severity == Severity::warn    ? Tone::warn
                    : severity == Severity::fault ? Tone::fault
                    : busy                        ? Tone::motion
                                                  : Tone::ink3;
  draw_icon(ImGui::GetWindowDrawList(), icon, ImVec2(left + ui.px(6), middle), ui.px(12), ui[tone]);
  const std::string_view shown_words = busy ? std::string_view(words_) : std::string_view(note_.sentence);
  float right = ui.px(f.area.right() - 16);
  const ProgramReport& report = f.tab.desk().programs.texts.report(f.tab.desk().programs.texts.chosen());
  const float shown_end = left + ui.px(20) + std::ceil(text_width(ui, Face::body, shown_words));
  if (busy && f.now.transfer.running)
    right = draw_transfer(f, shown_end + ui.px(16), right, middle);
  else if (!report.problems.empty() && shown_end + ui.px(110) < right)
    right = draw_problem_link(f, report, right, middle);
  draw_text_line(ui, left + ui.px(20), right, middle, Face::body, ui[Tone::ink2], shown_words);
  show(ui, {.id = "program/note", .kind = Kind::text, .label = "State", .value = shown_words},
       {ImVec2(left, top), ImVec2(right, top + ui.px(height))});
}

/// Draws the progress and Abort, which are left out before the words are. There is no Abort while a program
/// runs, because Abort would stop the program too.
float Program::draw_transfer(Frame& f, float left, float right, float middle) {
  constexpr std::string_view abort = "Abort";
  Ui& ui = f.ui;
  const float abort_width = std::ceil(text_width(ui, Face::small, abort));
  if (left + abort_width > right || f.now.under_way().program) return right;
  right -= abort_width;
  ImGui::SetCursorScreenPos(ImVec2(right, std::floor(middle - ui.line(Face::small) / 2)));
  if (link(ui, "program/abort", abort)) f.send(intent::HaltProgram());
  right -= ui.px(16);
  const TransferState& t = f.now.transfer;
  const float bar = std::min(ui.px(160), right - left);
  if (t.total == 0 || bar < ui.px(40)) return right;
  ImGui::SetCursorScreenPos(ImVec2(right - bar, std::floor(middle - ui.px(4))));
  MeterOptions o;
  o.tone = Tone::motion;
  o.words = words_;
  o.width = bar / ui.scale;
  meter(ui, "program/transfer", "Transfer", static_cast<float>(t.done) / static_cast<float>(t.total), o);
  return right - bar - ui.px(16);
}

// Draws "2 errors, next", which moves from problem to problem.
float Program::draw_problem_link(Frame& f, const ProgramReport& report, float right, float middle) {
  Ui& ui = f.ui;
  int errors = 0;
  for (const Problem& p : report.problems) errors += p.error;
  const int n = errors > 0 ? errors : static_cast<int>(report.problems.size());
  char label[48];
  const auto end = fmt::format_to_n(label, sizeof label, "{} {}{}, show", n, errors > 0 ? "error" : "warning",
                                    n == 1 ? "" : "s");
  const std::string_view shown_words(label, std::min(end.size, sizeof label));
  const float left = right - std::ceil(text_width(ui, Face::small, shown_words));
  ImGui::SetCursorScreenPos(ImVec2(left, std::floor(middle - ui.line(Face::small) / 2)));
  if (link(ui, "program/next_problem", shown_words)) {
    next_problem_ = (next_problem_ + 1) % static_cast<int>(report.problems.size());
    const Problem& p = report.problems[static_cast<std::size_t>(next_problem_)];
    editor_.go_to(f.tab.desk().programs.texts.chosen(), p.line, p.column);
  }
  return left - ui.px(12);
}

}  // namespace hw::panels
