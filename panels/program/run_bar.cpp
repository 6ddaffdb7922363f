#include "panels/program/run_bar.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include <fmt/core.h>

#include "gui/model/tab.h"
#include "gui/widgets/button.h"
#include "gui/widgets/slider.h"
#include "gui/widgets/text.h"
#include "panels/widget_path.h"

namespace hw::panels {

using namespace gui;
namespace {

constexpr std::string_view no_program = "No program runs.", no_link = "There is no link.";

bool runs(const ProgramState& p) { return is_under_way(p) && p.run == RunState::running; }
bool waits(const ProgramState& p) { return is_under_way(p) && p.run != RunState::running; }

/// Whether a run can be held: the controller steps through programs, or controls threads.
bool can_hold(const Catalog& c) { return c.can.single_step || c.program.threads > 0; }

struct Bar {
  Frame& frame;
  std::string_view where;
  const RunBarLook& look;

  bool press(std::string_view verb, std::string_view label, ButtonOptions options) {
    options.height = 40;
    const Path id("{}/{}", where, verb);
    if (look.brief && verb != "run") {
      options.tip = options.tip.empty() ? label : options.tip;
      options.wordless = true;
    }
    return button(frame.ui, id, label, options).clicked;
  }
  void next() { ImGui::SameLine(0, frame.ui.px(8)); }
  [[nodiscard]] const ProgramState& program() const { return frame.now.program; }

  bool run() {
    const Rehearsed& tried = look.rehearsed;
    const bool waiting = waits(program());
    // The width is the same with and without the tick, and for both words.
    ButtonOptions widest{.icon = Icon::play, .keys = look.keys ? "ctrl \n" : ""},
        to_go_on{.icon = Icon::play};
    if (!tried.words.empty()) widest.icon_after = Icon::check;
    ButtonOptions o = waiting ? to_go_on : widest;
    o.width = std::max(button_width(frame.ui, "Run", widest), button_width(frame.ui, "Resume", to_go_on));
    if (!tried.holds) o.icon_after = Icon::none;
    o.disabled = look.why_not;
    o.moving = true;
    char tip[400];
    const bool both = !tried.words.empty() && !look.tip.empty();
    const auto end = fmt::format_to_n(tip, sizeof tip, "{}{}{}", look.tip, both ? " " : "", tried.words);
    if (!waiting) o.tip = {tip, std::min(end.size, sizeof tip)};
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const bool pressed = press("run", waiting ? "Resume" : "Run", o);
    if (!tried.words.empty())
      show(frame.ui, {Path("{}/rehearsed", where), Kind::text, "Rehearsed", tried.words},
           {at, ImVec2(at.x + frame.ui.px(o.width), at.y + frame.ui.px(40))});
    return pressed;
  }
  bool hold() {
    const std::string_view why =
        !frame.connected()         ? no_link
        : !can_hold(frame.catalog) ? std::string_view("This controller cannot hold a program. Stop ends it.")
        : runs(program())          ? std::string_view()
        : waits(program())         ? waiting_words()
                                   : no_program;
    return press("hold", "Hold",
                 {.icon = Icon::pause, .disabled = why, .tip = "Stops before the next command."});
  }
  [[nodiscard]] std::string_view waiting_words() const {
    return program().run == RunState::held ? "The program is held. Resume continues it."
                                           : "The program waits. Resume continues it.";
  }
  bool step() {
    const bool held = is_under_way(program()) && program().run == RunState::held;
    const std::string_view why = !held ? look.why_not : frame.connected() ? std::string_view() : no_link;
    return press("step", "Step",
                 {.icon = Icon::step, .disabled = why, .tip = "One command at a time.", .moving = true});
  }
  bool stop() {
    const bool busy = is_under_way(program()) || frame.tab.desk().programs.job.busy();
    return press("stop", "Stop", {.icon = Icon::stop, .disabled = busy ? "" : no_program, .stops = true});
  }
};

}  // namespace

bool is_under_way(const ProgramState& p) {
  return p.owned && (p.run == RunState::running || p.run == RunState::waiting || p.run == RunState::held);
}

std::string_view why_none_runs(const Frame& f) {
  const ProgramState& p = f.now.program;
  if (!f.connected()) return no_link_to_run;
  if (f.tab.desk().programs.job.busy()) return program_in_transfer;
  if (runs(p)) return another_runs;
  if (!waits(p) && f.now.any_axis_moving())
    return "An axis is moving. Run is available again when it has stopped.";
  return {};
}

std::string_view why_no_new_run(const Frame& f) {
  const std::string_view why = why_none_runs(f);
  if (!why.empty()) return why;
  return is_under_way(f.now.program) ? "A program waits. Stop it first." : "";
}

RunRequest run_bar(Frame& f, std::string_view where, const RunBarLook& look) {
  Bar bar{f, where, look};
  RunRequest request = RunRequest::none;
  if (bar.run()) request = RunRequest::run;
  bar.next();
  if (bar.hold()) f.send(intent::Pause());
  bar.next();
  if (f.catalog.can.single_step) {
    if (bar.step()) request = RunRequest::run_stepping;
    bar.next();
  }
  if (bar.stop()) f.send(intent::HaltProgram());
  return go_on_or(f, request);
}

std::optional<RunProgress> run_progress(const Frame& f) {
  const RunFollower& run = f.tab.desk().programs.follower;
  const auto left = run.left_s();
  if (!is_under_way(f.now.program) || !left) return std::nullopt;
  const double whole_s = run.run_s() + *left, left_s = std::ceil(*left);  // tenths would change in each frame
  RunProgress progress;
  progress.share = whole_s > 0 ? static_cast<float>(std::clamp(run.run_s() / whole_s, 0.0, 1.0)) : 0;
  progress.left = left_s < 60 ? format_number(left_s, 0) : format_duration(left_s);
  progress.left.append(left_s < 60 ? " s left" : " left");
  return progress;
}

void draw_run_progress(Frame& f, std::string_view where, const RunProgress& progress, float left,
                       float right) {
  Ui& ui = f.ui;
  const float middle = ImGui::GetCursorScreenPos().y + ui.px(20);
  const float words = right - std::ceil(text_width(ui, Face::body_medium, progress.left));
  const float bar = std::min(ui.px(124), words - ui.px(8) - left);
  draw_text_line(ui, std::max(words, left), right + 1, middle, Face::body_medium, ui[Tone::ink],
                 progress.left);
  if (f.now.program.run == RunState::running) ui.wake_in(0.2);
  if (bar < ui.px(24))
    return show(ui, {Path("{}/left", where), Kind::meter, "Time left", progress.left},
                {ImVec2(std::max(words, left), middle - ui.px(10)), ImVec2(right, middle + ui.px(10))});
  ImGui::SetCursorScreenPos(ImVec2(words - ui.px(8) - bar, middle - ui.px(4)));
  meter(ui, Path("{}/left", where), "Time left", progress.share,
        {.tone = Tone::motion, .words = progress.left, .width = bar / ui.scale});
}

RunRequest go_on_or(Frame& f, RunRequest request) {
  const ProgramState& p = f.now.program;
  if (request == RunRequest::none || !waits(p)) return request;
  if (request == RunRequest::run_stepping && p.run == RunState::held)
    f.send(intent::SingleStep());
  else
    f.send(intent::Resume());
  return RunRequest::none;
}

/// The terms of a run, checked again when the text is loaded. A text that the user has typed is judged only
/// by doubts.
static RunTerms terms_of(Frame& f, const std::string& text, const std::optional<AgreedDoubts>& agreed) {
  Desk& desk = f.tab.desk();
  RunTerms run{agreed.has_value()};
  const WrittenSequence* source =
      desk.programs.source.of(text, desk.blocks, desk.programs.language(), f.catalog);
  if (source)
    run.why_not_now = [&tab = f.tab, sequence = source->sequence, doubts = agreed.value_or(AgreedDoubts())] {
      return why_not_begin_any_more(tab, *sequence, doubts);
    };
  else if (auto read = read_sequence(f.tab, text))
    run.why_not_now = [&tab = f.tab, sequence = std::move(*read), doubts = agreed.value_or(AgreedDoubts())] {
      return why_doubted_meanwhile(tab, sequence, doubts);
    };
  return run;
}

void begin_run(Frame& f, RunRequest request, const std::optional<AgreedDoubts>& agreed) {
  if (request == RunRequest::none) return;
  Desk& desk = f.tab.desk();
  const int slot = desk.programs.texts.chosen();
  const std::string& text = desk.programs.texts.text(slot);
  if (std::string why = agreed ? std::string() : why_not_run_there(f.tab, text); !why.empty())
    return f.toast(Severity::warn, std::move(why), &desk.programs.texts);
  const auto goal =
      request == RunRequest::run_stepping ? ProgramJob::Goal::run_stepping : ProgramJob::Goal::run;
  desk.programs.job.begin(
      goal, slot, desk.programs.texts, f.now, f.catalog,
      [&](IntentBody body) { return f.send_and_watch(std::move(body)); }, terms_of(f, text, agreed));
  const Rehearsals::Outcome* tried = desk.programs.rehearsals.of(desk.programs.texts.start_of(slot));
  const bool holds =
      tried && tried->text == desk.programs.texts.text(slot) && tried->start.match == StartMatch::here;
  if (desk.programs.job.busy() && !holds) desk.programs.requests.rehearse(f.now, f.bench);
}

void report_outcome(Frame& f) {
  Desk& desk = f.tab.desk();
  auto report = desk.programs.job.take_report();
  if (!report.sentence.empty()) f.toast(report.severity, std::move(report.sentence), &desk.programs.texts);
}

}  // namespace hw::panels
