#include "panels/program/run_bar.h"

#include <algorithm>
#include <string>
#include <utility>

#include "gui/model/run_places.h"
#include "gui/model/tab.h"
#include "gui/widgets/button.h"
#include "panels/widget_path.h"

namespace hw::panels {

using namespace gui;
namespace {

constexpr std::string_view no_program = "No program runs.", no_link = "There is no link.";

bool runs(const ProgramState& p) { return is_under_way(p) && p.run == RunState::running; }
bool waits(const ProgramState& p) { return is_under_way(p) && p.run != RunState::running; }

/// What runs can be held where the controller steps through programs, or where threads are controlled.
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
      label = {};
    }
    return button(frame.ui, id, label, options).clicked;
  }
  void next() { ImGui::SameLine(0, frame.ui.px(8)); }
  [[nodiscard]] const ProgramState& program() const { return frame.now.program; }

  bool run() {
    const Rehearsed& tried = look.rehearsed;
    const bool waiting = waits(program());
    // Its place is the same with the tick and without, and for both words.
    ButtonOptions widest{.icon = Icon::play, .keys = look.keys ? "ctrl \n" : ""},
        to_go_on{.icon = Icon::play};
    if (!tried.words.empty()) widest.icon_after = Icon::check;
    ButtonOptions o = waiting ? to_go_on : widest;
    o.width = std::max(button_width(frame.ui, "Run", widest), button_width(frame.ui, "Go on", to_go_on));
    if (!tried.holds) o.icon_after = Icon::none;
    o.disabled = look.why_not;
    o.moving = true;
    if (!waiting) o.tip = tried.words.empty() ? look.tip : tried.words;
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const bool pressed = press("run", waiting ? "Go on" : "Run", o);
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
                                   : no_program;
    return press("hold", "Hold",
                 {.icon = Icon::pause, .disabled = why, .tip = "Stops before the next command."});
  }
  bool step() {
    const bool held = is_under_way(program()) && program().run == RunState::held;
    const std::string_view why = !held ? look.why_not : frame.connected() ? std::string_view() : no_link;
    return press("step", "Step",
                 {.icon = Icon::step, .disabled = why, .tip = "One command at a time.", .moving = true});
  }
  bool stop() {
    const bool busy = is_under_way(program()) || frame.tab.desk().job.busy();
    return press("stop", "Stop", {.icon = Icon::stop, .disabled = busy ? "" : no_program, .stops = true});
  }
};

}  // namespace

bool is_under_way(const ProgramState& p) {
  return p.owned && (p.run == RunState::running || p.run == RunState::waiting || p.run == RunState::held);
}

std::string_view why_none_runs(const Frame& f) {
  const ProgramState& p = f.now.program;
  if (!f.connected()) return "There is no link. Run comes back when the controller answers.";
  if (f.tab.desk().job.busy()) return "A program is being transferred.";
  if (runs(p)) return "A program is running. Run comes back when it ends or is stopped.";
  if (!waits(p) && f.now.any_axis_moving()) return "An axis moves. Run comes back when it stands.";
  return {};
}

RunWish run_bar(Frame& f, std::string_view where, const RunBarLook& look) {
  Bar bar{f, where, look};
  RunWish wish = RunWish::none;
  if (bar.run()) wish = RunWish::run;
  bar.next();
  if (bar.hold()) f.send(intent::Pause());
  bar.next();
  if (f.catalog.can.single_step) {
    if (bar.step()) wish = RunWish::run_stepping;
    bar.next();
  }
  if (bar.stop()) f.send(intent::HaltProgram());
  return go_on_or(f, wish);
}

RunWish go_on_or(Frame& f, RunWish wish) {
  const ProgramState& p = f.now.program;
  if (wish == RunWish::none || !waits(p)) return wish;
  if (wish == RunWish::run_stepping && p.run == RunState::held)
    f.send(intent::SingleStep());
  else
    f.send(intent::Resume());
  return RunWish::none;
}

void begin_run(Frame& f, RunWish wish) {
  if (wish == RunWish::none) return;
  Desk& desk = f.tab.desk();
  const int slot = desk.texts.chosen();
  if (std::string why = why_not_run_there(f.tab, desk.texts.text(slot)); !why.empty())
    return f.toast(Mood::warn, std::move(why), &desk.texts);
  const auto goal = wish == RunWish::run_stepping ? ProgramJob::Goal::run_stepping : ProgramJob::Goal::run;
  desk.job.begin(goal, slot, desk.texts, f.now, f.catalog,
                 [&](IntentBody body) { return f.send_and_watch(std::move(body)); });
  const Rehearsals::Outcome* tried = desk.rehearsals.of(slot);
  const bool holds = tried && tried->text == desk.texts.text(slot) && tried->stand.footing == Footing::here;
  if (desk.job.busy() && !holds) desk.rehearse(f.now, f.bench);
}

void say_what_came(Frame& f) {
  Desk& desk = f.tab.desk();
  auto told = desk.job.take_told();
  if (!told.sentence.empty()) f.toast(told.mood, std::move(told.sentence), &desk.texts);
}

}  // namespace hw::panels
