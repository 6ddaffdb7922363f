#include "panels/path/tool_path.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "core/base/index.h"
#include "core/device/pieces_together.h"
#include "core/sequence/steps_in.h"
#include "gui/model/tab.h"
#include "gui/model/units_format.h"
#include "gui/widgets/area.h"
#include "gui/widgets/button.h"
#include "gui/widgets/text.h"
#include "panels/lines.h"
#include "panels/measures.h"
#include "panels/path/path_legend.h"
#include "panels/program/overwrite_question.h"
#include "panels/program/run_bar.h"
#include "panels/widget_path.h"

namespace hw::panels {

using namespace gui;
namespace {

/// The range of steps that counts as one step: a contour with its steps.
std::pair<int, int> counted_as_one(const sequence::Sequence& of, int step) {
  int first = 0;
  for (const sequence::Step& each : of.steps) {
    const sequence::StepList* inner = sequence::steps_in(each);
    const int behind = first + 1 + (inner ? sequence::count_steps(*inner) : 0);
    if (step < behind && std::holds_alternative<sequence::Contour>(each.body)) return {first, behind};
    if (step < behind) break;
    first = behind;
  }
  return {step, step + 1};
}

constexpr float hit_height = 36, legend_width = 248;

std::optional<Catalog> all_axes_of(const Bus& bus) {
  std::vector<const Catalog*> all;
  for (const Tab* member : bus.members) all.push_back(&member->catalog());
  return catalog_together(all);
}

}  // namespace

void ToolPath::draw(Frame& own) {
  if (own.tab.bus && !together_) together_ = all_axes_of(*own.tab.bus);
  Frame f{own, own.tab, together_ ? *together_ : own.catalog, own.now, own.bench};
  draw_all(f);
}

PathSubject ToolPath::subject_of(const Frame& f) const {
  const int at_work = program_.source_at_work();
  PathSubject subject;
  subject.path = program_.path(), subject.commanded = program_.commanded();
  subject.none = program_.under_way() ? "The path is being calculated."
                                      : "Simulate shows the path of the program. Moving axes leave a trace.";
  subject.axes = choice_.axes();
  subject.lit = at_work >= 0 ? at_work : hit_.source;
  subject.lit_count = at_work >= 0 ? 1 : hit_.count;
  subject.lit_pass = at_work >= 0 ? program_.pass_at_work() : hit_.pass;
  subject.at_work = at_work >= 0;
  subject.tool_on = program_.tool_on(f);
  subject.wanted_at = run_from_.goes_to(f, subject.axes);
  if (!subject.wanted_at) subject.wanted_at = run_drawn_.goes_to(f, subject.axes);
  subject.origin = true;
  return subject;
}

void ToolPath::draw_all(Frame& f) {
  report_outcome(f);
  choice_.begin(f);
  if (program_.follow(f, choice_.axes(), choice_.tool())) {
    hit_ = {};
    canvas_.measure(canvas_.measured().on);  // the ends were in the previous axes and units
    canvas_.fit();
  }
  follow_caret(f);
  follow_block(f);
  if (f.ui.keyboard.pressed(Command::simulate)) {
    if (const std::string_view why = program_.why_not_rehearse(); !why.empty())
      f.toast(Severity::warn, std::string(why), &f.tab.desk().programs.texts);
    else
      program_.rehearse(f);
  }
  draw_toolbar(f);
  const ImVec2 top = ImGui::GetCursorScreenPos();
  const float asked = overwrite_question_height(f), bottom = f.ui.px(f.area.bottom()) - asked;
  const float height = (bottom - top.y) / f.ui.scale;
  const bool side = f.area.width >= 620;
  const float width = f.area.width - (side ? legend_width : 0);
  const PathSubject subject = subject_of(f);
  canvas_.draw(f, "path/view", subject, width, height - hit_height);
  if (canvas_.clicked() || canvas_.passed()) describe_hit(f);
  if (canvas_.measured().on) describe_measure(f);
  draw_hit(f, width);
  if (side) {
    ImGui::SetCursorScreenPos(ImVec2(f.ui.px(f.area.x + width), top.y));
    draw_line_down(f);
    draw_path_legend(f, height, program_, subject);
  }
  if (asked > 0) draw_overwrite_question(f, bottom, asked);
  export_.draw_dialog(f, subject, canvas_);
  run_from_.draw_dialog(f, "path");
  if (std::string why = run_from_.take_refusal(); !why.empty()) f.toast(Severity::warn, std::move(why));
  run_drawn_.draw_dialog(f, "path");
}

// ---- words

std::string ToolPath::place_text(const Frame& f, drawing::Point3 p) const {
  const Directions all = directions_of(f, choice_.axes());
  std::string text;
  for (std::size_t n = 0; n < all.count; ++n)
    text += fmt::format("{}{}", n == 0 ? "" : ", ", all.all[n].words(along(p, n)));
  return text;
}

/// Describes the hit: the line that draws it, the place, and when the axes were really there.
void ToolPath::describe_hit(Frame& f) {
  const auto& hit = canvas_.clicked();
  const auto& passed = canvas_.passed();
  hit_ = {hit ? program_.path()->runs[hit->run].source : -1, 1, place_text(f, hit ? hit->at : passed->at)};
  if (hit) hit_.pass = program_.pass_of(hit->run);
  const std::string* text = program_.text();
  if (hit_.source >= 0 && program_.drawn())
    hit_.words = fmt::format("Step {} of {}: {}", hit_.source + 1, program_.drawn()->name, hit_.words);
  else if (const int line = program_.places().line_of(hit_.source); line >= 0 && text)
    hit_.words = fmt::format("Line {}: {} \u00b7 {}", line + 1,
                             program_.places().command_of(hit_.source, *text), hit_.words);
  if (passed)
    hit_.words +=
        fmt::format(" \u00b7 was there {} ago",
                    format_duration(std::max(0.0, std::floor(seconds(f.clock - passed->when)))).view());
}

/// Describes the way between two clicks: its components and the straight length.
void ToolPath::describe_measure(const Frame& f) {
  const PathMeasure& measure = canvas_.measured();
  const auto way = measure.way();
  if (!way)
    return hit_.words.assign(measure.from ? "Click the end of the distance."
                                          : "Click the start of the distance."),
           void();
  hit_.words = place_text(f, *way);
  const PathAxes axes = choice_.axes();
  if (!one_unit(f, axes)) return;
  const DisplayUnit& unit = directions_of(f, axes).all[0].unit();
  hit_.words += fmt::format(" \u00b7 {} straight", length_text(length(*way), unit, true));
  if (!axes.third) hit_.words += fmt::format(" \u00b7 {:.1f}\u00b0", std::atan2(way->y, way->x) * 180 / M_PI);
}

/// Highlights the line of the caret when the caret has moved in the editor.
void ToolPath::follow_caret(const Frame& f) {
  Desk& desk = f.tab.desk();
  if (std::exchange(caret_line_, desk.programs.caret_line) == desk.programs.caret_line || !program_.path())
    return;
  light(f, caret_line_);
}

/// Highlights a line of the drawn text, while that is the program's text.
void ToolPath::light(const Frame& f, int line) {
  const std::string* text = program_.text();
  if (!text || *text != f.tab.desk().programs.texts.text(program_.slot())) return;
  const SourcePlaces::IndexRange some = program_.places().of_line(line);
  hit_ = {some.first, some.count, fmt::format("Line {}: {}", line + 1, line_of(*text, line))};
}

/// The blocks that the text was written from; else null.
const WrittenSequence* ToolPath::blocks_of_text(const Frame& f) const {
  Desk& desk = f.tab.desk();
  const std::string* text = program_.text();
  if (!text || program_.slot() < 0 || program_.older()) return nullptr;
  const WrittenSequence* source =
      desk.programs.source.of(*text, desk.blocks, desk.programs.language(), f.catalog);
  return source && source->sequence == desk.blocks.editor.shared() ? source : nullptr;
}

/// Highlights a newly chosen block.
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
  const ImVec2 top = begin_toolbar(f);
  if (button(ui, "path/simulate", "Simulate",
             {.icon = Icon::play_outline,
              .keys = f.area.width >= 800 ? "F5" : "",
              .disabled = program_.why_not_rehearse(),
              .tip = "Tries the program without moving anything, and draws its path.",
              .height = 40})
          .clicked)
    program_.rehearse(f);
  choice_.draw(f, top.y);
  draw_view_tools(f);
  end_toolbar(f, top);
}

void ToolPath::draw_view_tools(Frame& f) {
  Ui& ui = f.ui;
  const auto tool = [&](const char* id, const char* label, std::string_view tip,
                        std::string_view disabled = {}, Icon icon = Icon::none) {
    ButtonOptions look{.style = ButtonStyle::quiet, .disabled = disabled, .tip = tip, .height = 40};
    if (icon != Icon::none) look.icon = icon, look.wordless = true, look.width = 36;
    next_in_toolbar(f, 0, look.width > 0 ? look.width : button_width(ui, label, look));
    return button(ui, id, label, look).clicked;
  };
  if (tool("path/fit", "Fit", "Shows the whole path and the origin. On the picture: 0, or a double click."))
    canvas_.fit();
  PathSubject seen;
  seen.axes = choice_.axes();
  const bool brief = f.area.width < 900, tight = f.area.width < 760;
  if (tool("path/fit_table", tight ? "Table" : "Fit table", "Shows the limits too. On the picture: 1.",
           limits_of(f, seen).any() ? "" : "No limit of these axes is known yet."))
    canvas_.fit_limits();
  if (tool("path/nearer", "+", "Nearer. On the picture: +, or the wheel.")) canvas_.zoom(1.5);
  if (tool("path/further", "\u2212", "Further away. On the picture: -, or the wheel.")) canvas_.zoom(1 / 1.5);
  if (tool("path/forget", brief ? "Forget" : "Forget trace", "Clears the trace of the axes.", {},
           tight ? Icon::empty : Icon::none))
    for (const Direction& d : directions_of(f, seen.axes))
      if (d.tab) d.tab->desk().records.trace.clear();
  const std::string_view save = brief ? "Save" : "Save picture";
  next_in_toolbar(f, 0, tight ? 36 : button_width(ui, save, {.style = ButtonStyle::quiet}));
  export_.draw_button(f, save, tight, program_.path() || !canvas_.trace().runs.empty());
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
  const std::string_view sentence =
      hit_.words.empty() ? std::string_view("Click the path to see its line here.") : hit_.words;
  draw_text_line(ui, row.min.x + ui.px(16), right, middle, Face::body,
                 ui[hit_.words.empty() ? Tone::ink3 : Tone::ink], sentence);
  show(ui, {"path/hit", Kind::text, "Clicked", hit_.words}, {row.min, ImVec2(right, row.max.y)});
  ImGui::SetCursorScreenPos(ImVec2(corner.x, row.max.y));
}

/// Draws the links from the right. Moves `right` to their left end.
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
  if (const DrawnTogether* drawn = program_.drawn(); drawn && hit_.source >= 0 && !measures) {
    if (pressed("path/run_here", "Run from here", why_not_run_drawn(f, *drawn)))
      run_drawn_.ask(f, *drawn, hit_.source);
    return;
  }
  const int line = program_.places().line_of(hit_.source);
  if (line < 0 || program_.slot() < 0 || measures) return;
  Desk& desk = f.tab.desk();
  const std::string_view old = program_.older() ? path_is_older : "";
  if (pressed("path/show_line", "Show line", old)) {
    desk.programs.wanted_line = line;
    f.show_panel("program");
  }
  if (const WrittenSequence* blocks = blocks_of_text(f); blocks &&
                                                         ix(line) < blocks->written.step_of_line.size() &&
                                                         pressed("path/show_block", "Show block", "")) {
    desk.blocks.wanted_step = blocks->written.step_of_line[ix(line)];
    f.show_panel("blocks");
  }
  if (pressed("path/run_here", "Run from here", old.empty() ? why_no_new_run(f) : old))
    ask_to_run_from_hit(f);
}

/// The clicked source, or an earlier source of the same step that moves before it.
int ToolPath::first_to_move(const WrittenSequence& written, int step) const {
  const auto [first, behind] = counted_as_one(*written.sequence, step);
  const std::vector<int>& steps = written.written.step_of_line;
  if (!program_.path()) return hit_.source;
  for (const drawing::ToolPath::Run& run : program_.path()->runs) {
    const int line = program_.places().line_of(run.source);
    if (line < 0 || ix(line) >= steps.size() || (hit_.pass && run.pass != *hit_.pass)) continue;
    if (steps[ix(line)] >= first && steps[ix(line)] < behind) return run.source;
  }
  return hit_.source;
}

/// A text from blocks or a drawing has known steps; for any other text the step must be worked out.
void ToolPath::ask_to_run_from_hit(Frame& f) {
  Desk& desk = f.tab.desk();
  const std::string* text = program_.text();
  if (!text || !program_.rehearsal()) return;
  const SourcePlace& place = program_.places().all[ix(hit_.source)];
  const Rehearsal& rehearsal = *program_.rehearsal();
  if (const WrittenSequence* source =
          desk.programs.source.of(*text, desk.blocks, desk.programs.language(), f.catalog)) {
    const std::vector<int>& steps = source->written.step_of_line;
    const int step = ix(place.line) < steps.size() ? steps[ix(place.line)] : -1;
    return run_from_.ask(
        f, *source->sequence,
        {step, hit_.pass, rehearsal.axes,
         begun_between(rehearsal, program_.places().of_command, first_to_move(*source, step), hit_.pass)});
  }
  run_from_.ask(f, {*text, place.line, place.byte, hit_.pass, rehearsal.axes,
                    begun_between(rehearsal, program_.places().of_command, hit_.source, hit_.pass)});
}

}  // namespace hw::panels
