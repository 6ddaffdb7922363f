#include "panels/program/program.h"

#include <cmath>

#include <fmt/core.h>

#include "gui/input/keyboard.h"
#include "gui/model/tab.h"
#include "gui/model/units_format.h"
#include "gui/shell/console.h"
#include "gui/widgets/button.h"
#include "gui/widgets/choice.h"
#include "gui/widgets/message.h"
#include "gui/widgets/slider.h"
#include "gui/widgets/text.h"
#include "panels/lines.h"
#include "panels/measures.h"
#include "panels/program/run_bar.h"
#include "panels/widget_path.h"

namespace hw::panels {

using namespace gui;
namespace {

bool shows_keys(const Frame& f) { return f.area.width >= 700; }

/// The fault of the text itself; empty: none.
FixedText<240> why_not_fit_to_run(ProgramTexts& texts, int slot, const ProgramFacts& facts) {
  char words[240];
  const auto view_of = [&](const auto& end) {
    return FixedText<240>(std::string_view(words, std::min<std::size_t>(end.size, sizeof words)));
  };
  for (const Problem& p : texts.report(slot).problems)
    if (p.error)
      return view_of(fmt::format_to_n(words, sizeof words,
                                      "Line {}: {} Run is available again when it is corrected.", p.line + 1,
                                      p.sentence));
  const int cost = texts.cost(slot), too_many = cost - facts.capacity;
  if (facts.capacity <= 0 || too_many <= 0) return {};
  return view_of(fmt::format_to_n(
      words, sizeof words,
      "The program needs {} {} and {} fit: {} too many. Run is available again when it is shorter.", cost,
      facts.capacity_unit, facts.capacity, too_many));
}

}  // namespace

void Program::draw(Frame& f) {
  follow(f);
  shortcuts(f);
  draw_toolbar(f);
  draw_slots(f);
  draw_compiled_row(f);
  const float bottom = draw_below(f);
  draw_work(f, bottom);
  draw_dialogs(f);
}

void Program::follow(Frame& f) {
  Desk& desk = f.tab.desk();
  report_outcome(f);
  for (const auto& path : desk.take_dropped("program")) ask_or_open(f, path);
  if (const int line = std::exchange(desk.programs.wanted_line, -1); line >= 0)
    editor_.go_to(desk.programs.texts.chosen(), line, 0);
  if (const double due = desk.autosave_due_in(f.clock); due >= 0) f.ui.wake_in(due + 0.01);
  find_why_not_run(f);
}

static std::string_view why_not_simulate(const Frame& f) {
  Desk& desk = f.tab.desk();
  const int slot = desk.programs.texts.chosen();
  if (!desk.programs.language()) return no_rehearsal;
  if (desk.programs.texts.text(slot).empty()) return "The program is empty.";
  if (desk.programs.rehearsals.under_way(desk.programs.texts.start_of(slot))) return "Calculating.";
  return why_not_rehearse_now(f.now, f.catalog);
}

void Program::shortcuts(Frame& f) {
  const Keyboard& keys = f.ui.keyboard;
  if (keys.pressed(Command::run)) {
    if (why_not_run_.empty())
      run(f, go_on_or(f, RunRequest::run));
    else
      f.toast(Severity::warn, std::string(why_not_run_.view()), &f.tab.desk().programs.texts);
  }
  if (keys.pressed(Command::simulate)) {
    if (const std::string_view why = why_not_simulate(f); !why.empty())
      f.toast(Severity::warn, std::string(why), &f.tab.desk().programs.texts);
    else
      f.tab.desk().programs.requests.rehearse(f.now, f.bench);
  }
  if (keys.pressed(Command::save)) save(f);
  if (keys.pressed(Command::open)) ask_open(f);
}

// ---- toolbar

void Program::find_why_not_run(const Frame& f) {
  ProgramTexts& texts = f.tab.desk().programs.texts;
  why_not_run_ = why_none_runs(f);
  if (!why_not_run_.empty() || is_under_way(f.now.program)) return;
  if (texts.text(texts.chosen()).empty())
    why_not_run_ = "The program is empty.";
  else
    why_not_run_ = why_not_fit_to_run(texts, texts.chosen(), f.catalog.program);
}

void Program::draw_toolbar(Frame& f) {
  Ui& ui = f.ui;
  const ImVec2 at = begin_toolbar(f);
  const auto next = [&] { ImGui::SameLine(0, ui.px(8)); };
  RunBarLook look{.why_not = why_not_run_, .keys = shows_keys(f)};
  if (f.tab.desk().programs.language()) look.rehearsed = rehearsed(f);
  run(f, run_bar(f, "program", look));
  next();
  draw_simulate(f);
  next();
  const float left = ImGui::GetCursorScreenPos().x;
  if (const auto progress = run_progress(f))
    draw_run_progress(f, "program", *progress, left, ui.px(f.area.right() - 16));
  else
    draw_memory(f, left);
  end_toolbar(f, at);
  const Rect row{at, ImVec2(ui.px(f.area.right()), ImGui::GetCursorScreenPos().y)};
  const ProgramTexts& texts = f.tab.desk().programs.texts;
  if (const auto once = doubt_.draw(f, "program", row, texts.text(texts.chosen()));
      once.request != RunRequest::none)
    begin_run(f, once.request, once.agreed);
}

void Program::run(Frame& f, RunRequest request) {
  const ProgramTexts& texts = f.tab.desk().programs.texts;
  if (!doubt_.holds_back(f, request, texts.text(texts.chosen()))) begin_run(f, request);
}

void Program::draw_simulate(Frame& f) {
  if (button(f.ui, "program/simulate", "Simulate",
             {.icon = Icon::play_outline,
              .keys = shows_keys(f) ? "F5" : "",
              .disabled = why_not_simulate(f),
              .tip = "Runs the text in a simulation; nothing moves.",
              .height = 40})
          .clicked)
    f.tab.desk().programs.requests.rehearse(f.now, f.bench);
}

// Draws the memory that the text takes, of the total, while the user types. If the words do not fit, they
// become fewer and then disappear.
void Program::draw_memory(Frame& f, float left) {
  const int capacity = f.catalog.program.capacity;
  if (capacity <= 0) return;
  Ui& ui = f.ui;
  Desk& desk = f.tab.desk();
  const int cost = desk.programs.texts.cost(desk.programs.texts.chosen());
  const bool over = cost > capacity;
  const NumberText number = format_number(cost, 0), all = format_number(capacity, 0);
  const Path beyond(" of {}: {} too many", all.view(), cost - capacity);
  const Path of(" of {} {}", all.view(), f.catalog.program.capacity_unit), brief(" of {}", all.view());
  const Path whole("{}{}", number.view(), over ? beyond.view() : of.view());
  const float right = ui.px(f.area.right() - 16), middle = ImGui::GetCursorScreenPos().y + ui.px(20);
  const float number_width = std::ceil(text_width(ui, Face::body_bold, number));
  const auto left_of = [&](std::string_view rest) {
    return right - number_width - std::ceil(text_width(ui, Face::body, rest));
  };
  std::string_view rest = over ? beyond.view() : of.view();
  for (const std::string_view fewer : {brief.view(), std::string_view()})
    if (left_of(rest) < left) rest = fewer;
  const float words_left = left_of(rest);
  if (words_left >= left) {  // otherwise Check reports it
    draw_text_line(ui, words_left, right, middle, Face::body_bold, ui[over ? Tone::fault : Tone::ink],
                   number);
    draw_text_line(ui, words_left + number_width, right + 1, middle, Face::body,
                   ui[over ? Tone::fault : Tone::ink2], rest);
  }
  const float room = words_left - ui.px(8) - left;
  const float title = std::ceil(text_width(ui, Face::body, "Memory")) + ui.px(8);
  const float bar = std::min(ui.px(124), room - title > ui.px(80) ? room - title : room);
  if (bar >= ui.px(24)) {
    const float x = words_left - ui.px(8) - bar;
    if (room - bar >= title) draw_text_line(ui, x - title, x, middle, Face::body, ui[Tone::ink2], "Memory");
    ImGui::SetCursorScreenPos(ImVec2(x, middle - ui.px(4)));
    meter(ui, "program/memory", "Memory", static_cast<float>(cost) / static_cast<float>(capacity),
          {.over = over, .words = whole, .width = bar / ui.scale});
  } else {
    show(ui, {.id = "program/memory", .kind = Kind::meter, .label = "Memory", .value = whole, .tip = whole},
         {ImVec2(words_left, middle - ui.px(10)), ImVec2(right, middle + ui.px(10))});
  }
}

// ---- actions of the buttons

void Program::start(Frame& f, ProgramJob::Goal goal) {
  Desk& desk = f.tab.desk();
  const auto send = [&](IntentBody body) { return f.send_and_watch(std::move(body)); };
  desk.programs.job.begin(goal, desk.programs.texts.chosen(), desk.programs.texts, f.now, f.catalog, send);
}

void Program::check(Frame& f) {
  Desk& desk = f.tab.desk();
  const int slot = desk.programs.texts.chosen();
  const ProgramReport& report = desk.programs.texts.report(slot);
  int errors = 0;
  for (const Problem& p : report.problems) errors += p.error;
  f.console.toasts().withdraw(&desk.programs.texts);
  const auto report_check = [&](Severity severity, std::string words) {
    f.toast(severity, std::move(words), &desk.programs.texts);
  };
  if (errors == 0 && f.catalog.program.capacity <= 0) return report_check(Severity::ok, "No error.");
  if (errors == 0)
    return report_check(Severity::ok,
                        fmt::format("No error. {} of {} {}.", desk.programs.texts.cost(slot),
                                    f.catalog.program.capacity, f.catalog.program.capacity_unit));
  for (const Problem& p : report.problems) {
    if (!p.error) continue;
    editor_.go_to(slot, p.line, p.column);
    return report_check(Severity::fault, fmt::format("{} error{}. Line {}: {}", errors,
                                                     errors == 1 ? "" : "s", p.line + 1, p.sentence));
  }
}

}  // namespace hw::panels
