#include "panels/path/tool_path.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "gui/model/tab.h"
#include "gui/model/units_format.h"
#include "gui/widgets/area.h"
#include "gui/widgets/button.h"
#include "gui/widgets/text.h"
#include "panels/lines.h"
#include "panels/measures.h"
#include "panels/program/overwrite_question.h"
#include "panels/program/run_bar.h"
#include "panels/widget_path.h"

namespace hw::panels {

using namespace gui;
namespace {

constexpr float hit_height = 36, legend_width = 248;

}  // namespace

void ToolPath::draw(Frame& f) {
  say_what_came(f);
  if (program_.follow(f, choice_.track_axes(f.tab))) {
    hit_ = {};
    canvas_.measure(canvas_.measured().on);  // its ends were in the axes and units of before
    canvas_.fit();
  }
  follow_caret(f);
  follow_block(f);
  if (f.ui.keyboard.pressed(Command::simulate)) f.tab.desk().rehearse(f.now, f.bench);
  draw_toolbar(f);
  const ImVec2 top = ImGui::GetCursorScreenPos();
  const float asked = overwrite_question_height(f), bottom = f.ui.px(f.area.bottom()) - asked;
  const float height = (bottom - top.y) / f.ui.scale;
  const bool side = f.area.width >= 620;
  const float width = f.area.width - (side ? legend_width : 0);
  const int at_work = program_.line_at_work(f);
  PathSubject subject;
  subject.path = program_.path(), subject.commanded = program_.commanded();
  subject.none = f.tab.desk().rehearsals.under_way(program_.slot())
                     ? "The path is being worked out."
                     : "Simulate shows where the program goes. What moves leaves a trace.";
  subject.axes = choice_.axes();
  subject.lit = at_work >= 0 ? at_work : hit_.line;
  subject.wanted_at = run_from_.goes_to(f, subject.axes);
  canvas_.draw(f, "path/view", subject, width, height - hit_height);
  if (canvas_.clicked() || canvas_.passed()) say_hit(f);
  if (canvas_.measured().on) say_measure(f);
  draw_hit(f, width);
  if (side) {
    ImGui::SetCursorScreenPos(ImVec2(f.ui.px(f.area.x + width), top.y));
    draw_legend(f, height);
  }
  if (asked > 0) draw_overwrite_question(f, bottom, asked);
  draw_dialogs(f);
}

void ToolPath::draw_dialogs(Frame& f) {
  const PathAxes axes = choice_.axes();
  const bool equal = one_unit(f.tab, axes);
  export_.draw_dialog(f, {program_.path(), canvas_.projection(), equal, f.tab.unit(axes.right).name});
  run_from_.draw_dialog(f, "path");
}

// ---- what is said of it

std::string ToolPath::place_text(const Frame& f, drawing::Point3 p) const {
  const PathAxes axes = choice_.axes();
  const auto on = [&](AxisId a, double units) {
    const DisplayUnit& unit = f.tab.unit(a);
    return fmt::format("{} {}", f.catalog.axes[a.index].name,
                       format_with_unit(to_steps(units, unit), unit).view());
  };
  return fmt::format("{}, {}{}{}", on(axes.right, p.x), on(axes.up, p.y), axes.third ? ", " : "",
                     axes.third ? on(*axes.third, p.z) : "");
}

/// The line that draws it, the place, and when the axes were really there.
void ToolPath::say_hit(Frame& f) {
  const auto& hit = canvas_.clicked();
  const auto& passed = canvas_.passed();
  hit_ = {hit ? program_.path()->runs[hit->run].source : -1, place_text(f, hit ? hit->at : passed->at)};
  const std::string* text = program_.text(f);
  if (hit_.line >= 0)
    hit_.words = fmt::format("Line {}: {} \u00b7 {}", hit_.line + 1, text ? line_of(*text, hit_.line) : "",
                             hit_.words);
  if (passed)
    hit_.words +=
        fmt::format(" \u00b7 was there {} ago",
                    format_duration(std::max(0.0, std::floor(seconds(f.clock - passed->when)))).view());
}

/// The way between two clicks, in its parts and straight.
void ToolPath::say_measure(const Frame& f) {
  const PathMeasure& measure = canvas_.measured();
  const auto way = measure.way();
  if (!way)
    return hit_.words.assign(measure.from ? "Click where to measure to." : "Click where to measure from."),
           void();
  hit_.words = place_text(f, *way);
  const PathAxes axes = choice_.axes();
  if (!one_unit(f.tab, axes)) return;
  hit_.words += fmt::format(" \u00b7 {} straight", length_text(length(*way), f.tab.unit(axes.right), true));
  if (!axes.third) hit_.words += fmt::format(" \u00b7 {:.1f}\u00b0", std::atan2(way->y, way->x) * 180 / M_PI);
}

/// What the caret has come to in the editor since is lit here.
void ToolPath::follow_caret(const Frame& f) {
  Desk& desk = f.tab.desk();
  if (std::exchange(caret_line_, desk.caret_line) == desk.caret_line || !program_.path()) return;
  light(f, caret_line_);
}

/// Of the text that is drawn, while it is that of the program.
void ToolPath::light(const Frame& f, int line) {
  const std::string* text = program_.text(f);
  if (!text || *text != f.tab.desk().texts.text(program_.slot())) return;
  hit_ = {line, fmt::format("Line {}: {}", line + 1, line_of(*text, line))};
}

/// The blocks, if they are what the text was written from; else null.
const WrittenSequence* ToolPath::blocks_of_text(const Frame& f) const {
  Desk& desk = f.tab.desk();
  const std::string* text = program_.text(f);
  if (!text || program_.slot() < 0 || program_.older(f)) return nullptr;
  const WrittenSequence* source = desk.source.of(*text, desk.blocks, desk.language(), f.catalog);
  return source && source->sequence == desk.blocks.editor.shared() ? source : nullptr;
}

/// The block that has been chosen since is lit here.
void ToolPath::follow_block(const Frame& f) {
  const int step = f.tab.desk().blocks.chosen_step;
  if (std::exchange(chosen_step_, step) == step || step < 0 || !program_.path()) return;
  const WrittenSequence* blocks = blocks_of_text(f);
  if (!blocks) return;
  const auto& steps = blocks->written.step_of_line;
  const auto line = std::find(steps.begin(), steps.end(), step);
  if (line != steps.end()) light(f, static_cast<int>(line - steps.begin()));
}

// ---- drawing

void ToolPath::draw_toolbar(Frame& f) {
  Ui& ui = f.ui;
  Desk& desk = f.tab.desk();
  const ImVec2 top = begin_toolbar(f);
  const int slot = desk.texts.chosen();
  const std::string_view why = !desk.language()                  ? "This model has no rehearsal."
                               : desk.texts.text(slot).empty()   ? "The program is empty."
                               : desk.rehearsals.under_way(slot) ? "It is being worked out."
                                                                 : "";
  if (button(ui, "path/simulate", "Simulate",
             {.icon = Icon::play_outline,
              .keys = f.area.width >= 800 ? "F5" : "",
              .disabled = why,
              .tip = "Tries the program without moving anything, and draws its path.",
              .height = 40})
          .clicked)
    desk.rehearse(f.now, f.bench);
  choice_.draw(f, top.y);
  const auto tool = [&](const char* id, const char* label, std::string_view tip) {
    const ButtonOptions look{.style = ButtonStyle::quiet, .tip = tip, .height = 40};
    next_in_toolbar(f, 0, button_width(ui, label, look));
    return button(ui, id, label, look).clicked;
  };
  if (tool("path/fit", "Fit", "Shows all of it. On the picture: 0, or a double click.")) canvas_.fit();
  if (tool("path/nearer", "+", "Nearer. On the picture: +, or the wheel.")) canvas_.zoom(1.5);
  if (tool("path/further", "\u2212", "Further away. On the picture: -, or the wheel.")) canvas_.zoom(1 / 1.5);
  const bool brief = f.area.width < 780;
  if (tool("path/forget", brief ? "Forget" : "Forget trace", "Forgets where the axes have been so far."))
    desk.trace.clear();
  const std::string_view save = brief ? "Save" : "Save picture";
  next_in_toolbar(f, 0, button_width(ui, save, {.style = ButtonStyle::quiet}));
  export_.draw_button(f, save, program_.path() != nullptr);
  end_toolbar(f, top);
}

void ToolPath::draw_legend(Frame& f, float height) {
  Ui& ui = f.ui;
  draw_line_down(f);
  begin_part(ui, "path/legend", 0, ui.px(height), Tone::panel, 16);
  section_title(ui, "Legend");
  const auto entry = [&](Tone tone, float width, bool dashed, std::string_view words) {
    const ImVec2 p = ImGui::GetCursorScreenPos();
    const float y = std::floor(p.y + ui.px(12));
    ImDrawList* list = ImGui::GetWindowDrawList();
    for (float x = 0; x < 28; x += dashed ? 9 : 28)
      list->AddRectFilled(ImVec2(p.x + ui.px(x), y),
                          ImVec2(p.x + ui.px(dashed ? std::min(x + 5, 28.0f) : 28), y + width * ui.hair()),
                          ui[tone]);
    draw_text_line(ui, p.x + ui.px(40), ui.px(f.area.right() - 16), p.y + ui.px(12), Face::body,
                   ui[Tone::ink2], words);
    ImGui::SetCursorScreenPos(ImVec2(p.x, p.y + ui.px(24)));
  };
  entry(Tone::ink, 2, false, "rehearsed, tool on");
  entry(Tone::ink3, 1, true, "rehearsed, tool off");
  if (program_.commanded()) entry(Tone::trace, 1, false, "as it was meant");
  entry(Tone::motion, 1, false, "has been there");
  entry(Tone::motion, 3, false, "line at work, or clicked");
  entry(Tone::warn, 1, false, f.bench.present ? "limit switch on the bench" : "limit switch, as met");
  entry(Tone::ok, 1, false, f.bench.present ? "home, on the bench" : "home, as met");
  group_line(ui);
  section_title(ui, "This path", f.tab.desk().rehearsals.under_way(program_.slot()) ? "working it out" : "");
  if (!program_.rehearsed()) {
    wrapped(ui, Face::body, Tone::ink2, "Nothing has been rehearsed yet.");
  } else if (program_.path()) {
    const ProgramPath::Facts& facts = program_.facts();
    key_value(ui, "path/size", "Size", facts.size);
    key_value(ui, "path/way_on", "Tool on", facts.way_on);
    if (choice_.has_tool()) key_value(ui, "path/way_off", "Tool off", facts.way_off);
    key_value(ui, "path/time", "Time", facts.time);
    if (program_.older(f)) {
      gap(ui, 8);
      wrapped(ui, Face::body, Tone::warn, "The text has been changed since. Simulate draws it anew.");
    }
  } else {
    wrapped(ui, Face::body, Tone::ink2, "These axes do not move in it.");
  }
  end_part();
}

void ToolPath::draw_hit(Frame& f, float width) {
  Ui& ui = f.ui;
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  const Rect row{corner, ImVec2(corner.x + ui.px(width), corner.y + ui.px(hit_height))};
  ImGui::GetWindowDrawList()->AddRectFilled(row.min, ImVec2(row.max.x, row.min.y + ui.hair()),
                                            ui[Tone::line]);
  const float middle = std::floor(row.centre().y);
  float right = row.max.x - ui.px(16);
  draw_hit_links(f, right, std::floor(middle - ui.line(Face::small) / 2));
  const std::string_view said =
      hit_.words.empty() ? std::string_view("Click the path: this line tells what draws it.") : hit_.words;
  draw_text_line(ui, row.min.x + ui.px(16), right, middle, Face::body,
                 ui[hit_.words.empty() ? Tone::ink3 : Tone::ink], said);
  show(ui, {"path/hit", Kind::text, "Clicked", hit_.words}, {row.min, ImVec2(right, row.max.y)});
  ImGui::SetCursorScreenPos(ImVec2(corner.x, row.max.y));
}

/// From the right; `right` comes to where they begin.
void ToolPath::draw_hit_links(Frame& f, float& right, float y) {
  Ui& ui = f.ui;
  const auto pressed = [&](std::string_view id, std::string_view label, std::string_view disabled) {
    right -= std::ceil(text_width(ui, Face::small, label));
    ImGui::SetCursorScreenPos(ImVec2(right, y));
    const bool is = link(ui, id, label, disabled);
    right -= ui.px(12);
    return is;
  };
  const bool measures = canvas_.measured().on;
  if (pressed("path/measure", measures ? "End measuring" : "Measure", "")) {
    canvas_.measure(!measures);
    hit_ = {};
  }
  if (hit_.line < 0 || program_.slot() < 0 || measures) return;
  Desk& desk = f.tab.desk();
  const std::string_view old =
      program_.older(f) ? "The text has been changed since. Simulate draws it anew." : "";
  if (pressed("path/show_line", "Show line", old)) {
    desk.wanted_line = hit_.line;
    f.show_panel("program");
  }
  const auto line_at = static_cast<std::size_t>(hit_.line);
  if (const WrittenSequence* blocks = blocks_of_text(f); blocks &&
                                                         line_at < blocks->written.step_of_line.size() &&
                                                         pressed("path/show_block", "Show block", "")) {
    desk.blocks.wanted_step = blocks->written.step_of_line[line_at];
    f.show_panel("blocks");
  }
  const std::string* text = program_.text(f);
  const WrittenSequence* source =
      text && old.empty() ? desk.source.of(*text, desk.blocks, desk.language(), f.catalog) : nullptr;
  if (!pressed("path/run_here", "Run from here", old.empty() ? why_not_run_from(f, source) : old)) return;
  const std::vector<int>& steps = source->written.step_of_line;
  run_from_.ask(f, *source->sequence, line_at < steps.size() ? steps[line_at] : -1);
}

}  // namespace hw::panels
