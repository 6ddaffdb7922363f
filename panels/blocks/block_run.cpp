#include "panels/blocks/block_run.h"

#include <string>
#include <utility>

#include "gui/input/keyboard.h"
#include "gui/model/run_places.h"
#include "gui/model/tab.h"
#include "gui/widgets/button.h"
#include "gui/widgets/message.h"
#include "panels/blocks/block_measures.h"

namespace hw::panels {

using namespace gui;

void BlockRun::draw(Frame& f, const SequenceText& text, std::string_view why_not, Rehearsed rehearsed) {
  take_result(f, text);
  live_.follow(f, text);
  RunBarLook look;
  look.why_not = why_none_runs(f);
  if (look.why_not.empty() && !is_under_way(f.now.program)) look.why_not = why_not;
  look.brief = f.area.width < 860;
  look.rehearsed = rehearsed;
  look.tip = text.tool;
  RunRequest request = run_bar(f, "blocks", look);
  if (f.ui.keyboard.pressed(Command::run)) {
    if (look.why_not.empty())
      request = go_on_or(f, RunRequest::run);
    else
      f.toast(Severity::warn, std::string(look.why_not), &f.tab.desk().programs.texts);
  }
  if (request != RunRequest::none && !doubt_.holds_back(f, request, text.text))
    ask_or_put(f, text, request == RunRequest::run ? Wanted::run : Wanted::run_stepping);
  ImGui::SameLine(0, f.ui.px(f.area.width < closer_below ? 4 : 8));
  const ButtonOptions to_program{
      .disabled = why_not, .tip = "Puts the text into the program editor.", .height = 40};
  const char* label = f.area.width < brief_below ? "To program" : "To the program";
  if (button(f.ui, "blocks/to_program", label, to_program).clicked) ask_or_put(f, text, Wanted::to_program);
}

/// A refused run is shown beside Run; other messages are toasts.
void BlockRun::take_result(Frame& f, const SequenceText& text) {
  if (std::string why = run_from_.take_refusal(); !why.empty())
    refusal_.set(std::move(why), text.text, from_);
  Desk& desk = f.tab.desk();
  auto report = desk.programs.job.take_report();
  if (report.sentence.empty()) return;
  const ProgramJob::Goal goal = desk.programs.job.goal();
  const bool of_run = goal == ProgramJob::Goal::run || goal == ProgramJob::Goal::run_stepping;
  const std::string& run = desk.programs.texts.text(desk.programs.texts.chosen());
  if (of_run && report.severity == Severity::fault) {
    if (run == text.text) return refusal_.set(std::move(report.sentence), text.text);
    if (run == run_from_.text()) return refusal_.set(std::move(report.sentence), text.text, from_);
  }
  f.toast(report.severity, std::move(report.sentence), &desk.programs.texts);
}

void BlockRun::ask_from(Frame& f, const sequence::Sequence& blocks, int step) {
  refusal_.forget();
  from_ = step;
  run_from_.ask(f, blocks, {.step = step});
}

int BlockRun::draw_refusals(Frame& f, const SequenceText& text, const BlockRows& rows, const Rect& row) {
  draw_doubt(f, text, row);
  return refusal_.draw(f, text, rows, row);
}

void BlockRun::draw_doubt(Frame& f, const SequenceText& text, const Rect& row) {
  const RunDoubt::AcceptedRun once = doubt_.draw(f, "blocks", row, text.text);
  if (once.request == RunRequest::none) return;
  ask_or_put(f, text, once.request == RunRequest::run ? Wanted::run : Wanted::run_stepping, once.agreed);
}

void BlockRun::ask_or_put(Frame& f, const SequenceText& text, Wanted wanted,
                          std::optional<AgreedDoubts> agreed) {
  refusal_.forget();
  const ProgramTexts& texts = f.tab.desk().programs.texts;
  if (wanted != Wanted::to_program && !agreed)  // if the run is held back, the program is not replaced either
    if (std::string why = why_not_run_there(f.tab, text.text); !why.empty())
      return refusal_.set(std::move(why), text.text);
  wanted_ = wanted, agreed_ = std::move(agreed);
  go_ahead_ = f.tab.desk().until_stopped();
  asking_ = texts.edited(texts.chosen()) && texts.text(texts.chosen()) != text.text;
  if (!asking_) put(f, text);
}

void BlockRun::put(Frame& f, const SequenceText& text) {
  ProgramTexts& texts = f.tab.desk().programs.texts;
  if (texts.text(texts.chosen()) != text.text) texts.set_text(texts.chosen(), text.text);
  switch (std::exchange(wanted_, Wanted::nothing)) {
    case Wanted::nothing: return;
    case Wanted::to_program: return f.show_panel("program");
    case Wanted::run: return run(f, text, RunRequest::run);
    case Wanted::run_stepping: return run(f, text, RunRequest::run_stepping);
  }
}

/// If a stop came or another run began while the question was open, the text is only put into the program.
void BlockRun::run(Frame& f, const SequenceText& text, RunRequest request) {
  if (go_ahead_.expired()) return refusal_.set(std::string(put_but_not_run), text.text);
  const std::string_view why = why_no_new_run(f);
  if (why.empty()) return begin_run(f, request, std::exchange(agreed_, std::nullopt));
  refusal_.set(std::string(why), text.text);
}

void BlockRun::draw_dialog(Frame& f, const SequenceText& text) {
  run_from_.draw_dialog(f, "blocks");
  if (!asking_) return;
  const Dialog what{.title = "Replace the text?",
                    .sentences = "The program has unsaved changes. The text of the blocks would replace it.",
                    .yes = wanted_ == Wanted::to_program ? "Replace" : "Replace and run",
                    .no = "Keep the text"};
  if (dialog(f.ui, "blocks/replace", asking_, what) == Answer::yes) put(f, text);
}

}  // namespace hw::panels
