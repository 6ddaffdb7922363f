#include "panels/program/threads.h"

#include <algorithm>

#include "core/device/refusals.h"
#include "gui/model/tab.h"
#include "gui/widgets/button.h"
#include "gui/widgets/icons.h"
#include "gui/widgets/text.h"
#include "panels/program/rehearsed.h"
#include "panels/widget_path.h"

namespace hw::panels {

using namespace gui;
namespace {

struct Look {
  Icon icon;
  std::string_view word;
  Tone tone;
};

Look look_of(const ThreadState& t, bool connected) {
  if (!connected) return {Icon::plug, "LOST", Tone::fault};
  if (!t.known) return {Icon::clock, "ASKING", Tone::ink3};
  switch (t.run) {
    case RunState::running: return {Icon::play, "RUNNING", Tone::motion};
    case RunState::waiting: return {Icon::pause, "WAITING", Tone::ink2};
    case RunState::held: return {Icon::pause, "PAUSED", Tone::ink2};
    case RunState::error: return {Icon::diamond_solid, "ERROR", Tone::fault};
    case RunState::idle: break;
  }
  return {Icon::ring, "IDLE", Tone::ink2};
}

constexpr float state_width = 92, line_width = 52, button_wide = 78, stop_wide = 50, only_icon = 36;
/// In narrower rows the buttons have only icons, because the source line needs the width.
constexpr float least_for_words = 400;

void draw_state(Frame& f, int n, const ThreadState& t, const Rect& row, float x) {
  Ui& ui = f.ui;
  const Look look = look_of(t, f.connected());
  const float middle = std::floor(row.centre().y);
  draw_icon(ImGui::GetWindowDrawList(), look.icon, ImVec2(x + ui.px(6), middle), ui.px(11), ui[look.tone]);
  draw_text_line(ui, x + ui.px(20), x + ui.px(state_width), middle, Face::body_bold, ui[look.tone],
                 look.word);
  show(ui, {Path("thread/{}/state", n), Kind::text, "State", look.word, {}, false, {}},
       {ImVec2(x, row.min.y), ImVec2(x + ui.px(state_width), row.max.y)});
}

/// The line that a thread executes, as shown in its row.
struct PlaceWords {
  Path line;                ///< "line 23": of the compiled program, as reported by the controller
  Path number;              ///< of its source line in the text; empty: unknown
  std::string_view source;  ///< that line, or why it is unknown
};

PlaceWords place_of(Frame& f, const ThreadState& t) {
  ProgramTexts& texts = f.tab.desk().programs.texts;
  const int source = texts.live_line(0, t.line);
  PlaceWords words{Path("line {}", t.line), Path("{}", ""), {}};
  if (source < 0) {
    words.source = texts.lines_known(0)  ? "its text has changed here"
                   : texts.held(0).known ? "its code cannot be read here"
                                         : "text not known: press Upload";
    return words;
  }
  words.number = Path("{}", source + 1);
  words.source = line_of(texts.text(0), source);
  return words;
}

/// Draws the low-level line reported by the controller, and its source line. If both do not fit, the
/// low-level line is left out; the tip shows a cut source line whole.
void draw_place(Frame& f, int n, const ThreadState& t, const Rect& row, float x, float right) {
  Ui& ui = f.ui;
  const float middle = std::floor(row.centre().y);
  const bool at_work = is_busy(t) || t.run == RunState::error;
  if (!t.known || !at_work || t.line < 0) return;
  const PlaceWords words = place_of(f, t);
  const bool known = !words.number.view().empty();
  const float number = known ? std::ceil(text_width(ui, Face::code_field, words.number)) + ui.px(8) : 0;
  const Face face = known ? Face::code_field : Face::small;
  const bool both = x + ui.px(line_width) + number + text_width(ui, face, words.source) <= right;
  if (both) draw_text_line(ui, x, x + ui.px(line_width), middle, Face::body, ui[Tone::ink2], words.line);
  const float line_end = x + ui.px(both ? line_width : 8);
  show(ui,
       {Path("thread/{}/line", n), Kind::text, "Compiled line", Path("{}", t.line), {}, false, words.line},
       {ImVec2(x, row.min.y), ImVec2(line_end, row.max.y)});
  if (both) x = line_end;
  draw_text_line(ui, x, right, middle, Face::code_field, ui[Tone::ink3], words.number);
  const Tone tone = !known ? Tone::ink3 : t.run == RunState::running ? Tone::motion : Tone::ink;
  draw_text_line(ui, x + number, right, middle, face, ui[tone], words.source);
  if (!known) return;
  const Path value("{} {}", words.number.view(), words.source.substr(0, 100));
  const Path tip("{} (compiled {})", words.source.substr(0, 100), words.line.view());
  show(ui, {Path("thread/{}/source", n), Kind::text, "Source line", value, {}, false, tip},
       {ImVec2(x, row.min.y), ImVec2(right, row.max.y)});
}

}  // namespace

void Threads::draw_first_button(Frame& f, int n, std::string_view no_link, bool words) {
  const ThreadState& t = f.now.threads[static_cast<std::size_t>(n)];
  ButtonOptions o;
  o.height = 28;
  o.width = words ? button_wide : only_icon;
  o.disabled = no_link;
  const auto press = [&](const char* what, const char* word) {
    if (!words && o.tip.empty()) o.tip = word;
    return button(f.ui, Path("thread/{}/{}", n, what), words ? word : "", o).clicked;
  };
  if (t.run == RunState::running || t.run == RunState::waiting) {
    o.icon = Icon::pause;
    if (press("pause", "Pause")) f.send(intent::Pause(n));
  } else if (t.run == RunState::held) {
    o.moving = true;
    o.icon = Icon::play;
    if (press("continue", "Resume")) f.send(intent::Resume(n));
  } else {
    o.moving = true;
    o.icon = Icon::play;
    const Rehearsed tried = f.tab.desk().programs.language() ? rehearsed_thread(f, n) : Rehearsed();
    const Path tip("Runs the program in the controller. {}", tried.words);
    o.tip = tip;
    if (tried.holds) o.icon_after = Icon::check;
    const ImVec2 at = ImGui::GetCursorScreenPos();
    if (press("run", "Run")) run(f, n, false);
    if (!tried.words.empty())
      show(f.ui, {Path("thread/{}/rehearsed", n), Kind::text, "Rehearsed", tried.words},
           {at, ImVec2(at.x + f.ui.px(o.width), at.y + f.ui.px(o.height))});
  }
}

void Threads::run(Frame& f, int n, bool as_it_is) {
  intent::RunProgram request(n);
  request.as_it_is = as_it_is;
  thread_ = n;
  refused_.clear();
  asked_ = f.send_and_watch(std::move(request));
}

void Threads::follow(Frame& f) {
  const IntentOutcome* outcome = f.now.outcome_of(asked_);
  if (f.now.forgotten(asked_)) asked_ = 0;
  if (!outcome || outcome->state == IntentState::pending) return;
  asked_ = 0;
  if (outcome->state == IntentState::done) return;
  const bool torn = torn_program(f.catalog, f.now, intent::RunProgram(thread_)) >= 0;
  if (torn)
    refused_ = outcome->sentence.view();
  else
    f.toast(Severity::fault, std::string(outcome->sentence.view()));
}

void Threads::draw_refusal(Frame& f, int n, const Rect& row) {
  if (n != thread_ || refused_.empty()) return;
  if (torn_program(f.catalog, f.now, intent::RunProgram(n)) < 0)
    return refused_.clear();  // the program was loaded or read since
  const Path id("thread/{}/refused", n), once("thread/{}/as_it_is", n), about("Run, program {}", n);
  const Action actions[] = {{.id = once,
                             .label = "Run it once as it is",
                             .brief = "Run it once",
                             .disabled = f.no_link(),
                             .moving = true}};
  card_.begin(f, {.id = id, .about = about, .words = refused_, .actions = actions}, row);
  const RefusalTouch touched = card_.end();
  if (touched.closed) refused_.clear();
  if (touched.action == 0) run(f, n, true);
}

void Threads::draw_row(Frame& f, int n, const Rect& row) {
  Ui& ui = f.ui;
  const ThreadState& t = f.now.threads[static_cast<std::size_t>(n)];
  const float top = row.min.y;
  ImGui::GetWindowDrawList()->AddRectFilled(row.min, ImVec2(row.max.x, row.min.y + ui.hair()),
                                            ui[Tone::line]);
  float x = row.min.x + ui.px(16);
  draw_text_line(ui, x, x + ui.px(20), std::floor(row.centre().y), Face::body_bold, ui[Tone::ink],
                 Path("{}", n));
  x += ui.px(24);
  draw_state(f, n, t, row, x);
  x += ui.px(state_width);
  const bool words = row.width() >= ui.px(least_for_words);
  const float first = words ? button_wide : only_icon, second = words ? stop_wide : only_icon;
  const float buttons = row.max.x - ui.px(16 + first + 4 + second);
  draw_place(f, n, t, row, x, buttons - ui.px(12));
  const std::string_view no_link = f.connected() ? std::string_view() : "There is no link.";
  ImGui::SetCursorScreenPos(ImVec2(buttons, top + ui.px(2)));
  draw_first_button(f, n, no_link, words);
  ImGui::SetCursorScreenPos(ImVec2(buttons + ui.px(first + 4), top + ui.px(2)));
  ButtonOptions stop;
  stop.height = 28;
  stop.width = second;
  stop.stops = true;
  if (!words) stop.icon = Icon::stop, stop.tip = "Stop";
  stop.disabled = is_busy(t) || t.run == RunState::error ? no_link : "The program does not run.";
  if (button(ui, Path("thread/{}/stop", n), words ? "Stop" : "", stop).clicked)
    f.send(intent::HaltProgram(n));
  draw_refusal(f, n, row);
}

bool is_busy(const ThreadState& t) {
  return t.run == RunState::running || t.run == RunState::waiting || t.run == RunState::held;
}

namespace {

/// The number of rows. Two threads are side by side if both fit.
int rows_of(int threads, float width) { return width >= 600 ? (threads + 1) / 2 : threads; }
int shown_threads(const Catalog& c) { return std::min(c.program.threads, max_threads); }

}  // namespace

float threads_height(const Catalog& c, float width) {
  return thread_row_height * static_cast<float>(rows_of(shown_threads(c), width));
}

// Down the first column, then down the second.
void Threads::draw(Frame& f, float top) {
  Ui& ui = f.ui;
  follow(f);
  const int many = shown_threads(f.catalog), rows = rows_of(many, f.area.width);
  const float half = rows < many ? std::floor(f.area.width / 2) : f.area.width;
  for (int n = 0; n < many; ++n) {
    const float x = f.area.x + (n < rows ? 0 : half),
                y = top + ui.px(thread_row_height * static_cast<float>(n % rows));
    const float end = n < rows && rows < many ? x + half : f.area.right();
    draw_row(f, n, {ImVec2(ui.px(x), y), ImVec2(ui.px(end), y + ui.px(thread_row_height))});
  }
  if (rows == many) return;
  const float middle = ui.px(f.area.x + half);
  ImGui::GetWindowDrawList()->AddRectFilled(
      ImVec2(middle, top),
      ImVec2(middle + ui.hair(), top + ui.px(thread_row_height * static_cast<float>(rows))), ui[Tone::line]);
}

}  // namespace hw::panels
