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

Look look_of(const ThreadState& t) {
  if (!t.known) return {Icon::clock, "NOT KNOWN", Tone::ink3};
  switch (t.run) {
    case RunState::running: return {Icon::play, "RUNNING", Tone::motion};
    case RunState::waiting: return {Icon::pause, "WAITING", Tone::ink2};
    case RunState::held: return {Icon::pause, "PAUSED", Tone::ink2};
    case RunState::error: return {Icon::diamond_solid, "ERROR", Tone::fault};
    case RunState::idle: break;
  }
  return {Icon::ring, "IDLE", Tone::ink2};
}

constexpr float state_width = 104, line_width = 76, button_wide = 84, stop_wide = 60;

void draw_state(Frame& f, int n, const ThreadState& t, const Rect& row, float x) {
  Ui& ui = f.ui;
  const Look look = look_of(t);
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
  draw_text_line(ui, x, x + ui.px(line_width), middle, Face::body, ui[Tone::ink2], line);
  show(ui, {Path("thread/{}/line", n), Kind::text, "Compiled line", Path("{}", t.line), {}, false, {}},
       {ImVec2(x, row.min.y), ImVec2(x + ui.px(line_width), row.max.y)});
  x += ui.px(line_width);
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

void draw_row(Frame& f, int n, float top) {
  Ui& ui = f.ui;
  const ThreadState& t = f.now.threads[static_cast<std::size_t>(n)];
  const Rect row{ImVec2(ui.px(f.area.x), top), ImVec2(ui.px(f.area.right()), top + ui.px(thread_row_height))};
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

float threads_height(const Catalog& c) {
  const int many = std::min(c.program.threads, max_threads);
  return many > 0 ? thread_row_height * static_cast<float>(many) : 0;
}

void draw_threads(Frame& f, float top) {
  const int many = std::min(f.catalog.program.threads, max_threads);
  for (int n = 0; n < many; ++n) draw_row(f, n, top + f.ui.px(thread_row_height * static_cast<float>(n)));
}

}  // namespace hw::panels
