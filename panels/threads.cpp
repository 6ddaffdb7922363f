#include "panels/threads.h"

#include <algorithm>

#include "gui/tab.h"
#include "gui/widgets/button.h"
#include "gui/widgets/icons.h"
#include "gui/widgets/text.h"
#include "panels/path.h"

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

constexpr float state_width = 92, line_width = 52, button_wide = 78, stop_wide = 50, least_source = 60;

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

/// The low-level line that the controller tells, and the line of the text that it came from.
void draw_place(Frame& f, int n, const ThreadState& t, const Rect& row, float x, float right) {
  Ui& ui = f.ui;
  const float middle = std::floor(row.centre().y);
  const bool at_work = is_busy(t) || t.run == RunState::error;
  if (!t.known || !at_work || t.line < 0) return;
  const Path line("line {}", t.line);
  // Without room for both the source line goes first.
  const bool both = right - x >= ui.px(line_width + least_source);
  if (both) draw_text_line(ui, x, x + ui.px(line_width), middle, Face::body, ui[Tone::ink2], line);
  show(ui, {Path("thread/{}/line", n), Kind::text, "Compiled line", Path("{}", t.line), {}, false, line},
       {ImVec2(x, row.min.y), ImVec2(x + ui.px(both ? line_width : 8), row.max.y)});
  if (both) x += ui.px(line_width);
  ProgramTexts& texts = f.tab.desk().texts;
  const int source = texts.live_line(0, t.line);
  if (source < 0) {
    const std::string_view why =
        texts.held(0).known ? "its text has changed here" : "text not known: Upload shows it";
    draw_text_line(ui, x, right, middle, Face::small, ui[Tone::ink3], why);
    return;
  }
  const Path number("{}", source + 1);
  const float width = std::ceil(text_width(ui, Face::code_field, number));
  draw_text_line(ui, x, right, middle, Face::code_field, ui[Tone::ink3], number);
  std::string_view words = line_of(texts.text(0), source);
  while (!words.empty() && (words.front() == ' ' || words.front() == '\t')) words.remove_prefix(1);
  draw_text_line(ui, x + width + ui.px(8), right, middle, Face::code_field,
                 ui[t.run == RunState::running ? Tone::motion : Tone::ink], words);
  const Path value("{} {}", source + 1, words.substr(0, 100));
  show(ui, {Path("thread/{}/source", n), Kind::text, "Source line", value, {}, false, words},
       {ImVec2(x, row.min.y), ImVec2(right, row.max.y)});
}

void draw_first_button(Frame& f, int n, const ThreadState& t, std::string_view no_link) {
  ButtonOptions o;
  o.height = 28;
  o.width = button_wide;
  o.disabled = no_link;
  if (t.run == RunState::running || t.run == RunState::waiting) {
    o.icon = Icon::pause;
    if (button(f.ui, Path("thread/{}/pause", n), "Pause", o).clicked) f.send(intent::Pause(n));
  } else if (t.run == RunState::held) {
    o.moving = true;
    o.icon = Icon::play;
    if (button(f.ui, Path("thread/{}/continue", n), "Resume", o).clicked) f.send(intent::Resume(n));
  } else {
    o.moving = true;
    o.icon = Icon::play;
    o.tip = "Runs what the controller holds.";
    if (button(f.ui, Path("thread/{}/run", n), "Run", o).clicked) f.send(intent::RunProgram(n));
  }
}

void draw_row(Frame& f, int n, const Rect& row) {
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
  const float buttons = row.max.x - ui.px(16 + button_wide + 4 + stop_wide);
  draw_place(f, n, t, row, x, buttons - ui.px(12));
  const std::string_view no_link = f.connected() ? std::string_view() : "There is no link.";
  ImGui::SetCursorScreenPos(ImVec2(buttons, top + ui.px(2)));
  draw_first_button(f, n, t, no_link);
  ImGui::SetCursorScreenPos(ImVec2(buttons + ui.px(button_wide + 4), top + ui.px(2)));
  ButtonOptions stop;
  stop.height = 28;
  stop.width = stop_wide;
  stop.disabled = is_busy(t) || t.run == RunState::error ? no_link : "It does not run.";
  if (button(ui, Path("thread/{}/stop", n), "Stop", stop).clicked) f.send(intent::HaltProgram(n));
}

}  // namespace

bool is_busy(const ThreadState& t) {
  return t.run == RunState::running || t.run == RunState::waiting || t.run == RunState::held;
}

std::string_view line_of(std::string_view text, int line) {
  for (; line > 0; --line) {
    const std::size_t end = text.find('\n');
    if (end == text.npos) return {};
    text.remove_prefix(end + 1);
  }
  return text.substr(0, text.find('\n'));
}

namespace {

/// Two beside each other where a row's place is wide enough for both.
int rows_of(int threads, float width) { return width >= 600 ? (threads + 1) / 2 : threads; }
int shown_threads(const Catalog& c) { return std::min(c.program.threads, max_threads); }

}  // namespace

float threads_height(const Catalog& c, float width) {
  return thread_row_height * static_cast<float>(rows_of(shown_threads(c), width));
}

// Down the first column, then down the second.
void draw_threads(Frame& f, float top) {
  Ui& ui = f.ui;
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
