#include "panels/drawing/drawing_facts.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "core/sequence/steps_in.h"
#include "gui/model/units_format.h"
#include "gui/widgets/area.h"
#include "gui/widgets/slider.h"
#include "gui/widgets/text.h"
#include "panels/widget_path.h"

namespace hw::panels {

using namespace gui;
namespace {

constexpr std::size_t most_left_out = 40, most_remarks = 4;

/// The number of moves of all axes, with the tool on or off. An arc counts as one move.
std::size_t moves_in(const sequence::StepList& steps) {
  std::size_t moves = 0;
  for (const sequence::Step& step : steps) {
    const auto is = [&step](auto kind) { return std::holds_alternative<decltype(kind)>(step.body); };
    if (is(sequence::Move{}) || is(sequence::Arc{})) ++moves;
    if (const sequence::StepList* inner = steps_in(step)) moves += moves_in(*inner);
  }
  return moves;
}

std::vector<std::string> in_words(const std::vector<drawing::LeftOut>& entities) {
  std::vector<std::string> all;
  for (std::size_t i = 0; i < std::min(most_left_out, entities.size()); ++i) {
    const drawing::LeftOut& l = entities[i];
    const std::string at = l.at ? fmt::format(" at {:.6g}, {:.6g}", l.at->x, l.at->y) : std::string();
    all.push_back(fmt::format("{} {}{}, line {}: {}", l.what, l.entity, at, l.line, l.why));
  }
  if (entities.size() > most_left_out)
    all.push_back(
        fmt::format("And {} more: handwheel convert --json lists them.", entities.size() - most_left_out));
  return all;
}

std::string in_mm(double v) { return fmt::format("{} mm", format_number(v, 1).view()); }

}  // namespace

void DrawingFacts::follow(const DrawingJob& job, const ConversionOptions& wanted) {
  if (std::exchange(shown_version_, job.version()) == job.version()) return;
  time_.clear(), beside_.clear(), drawn_.clear(), travel_.clear(), saved_.clear(), size_.clear(),
      chains_.clear(), moves_.clear();
  untimed_ = false;
  left_out_.clear(), left_out_title_.clear(), off_.clear(), understood_.clear(), problem_ = job.fault(),
                                                                                 can_be_cut_ = false;
  if (const drawing::Drawing* d = job.drawing()) {
    left_out_ = in_words(d->left_out), understood_ = in_words(d->understood);
    if (!left_out_.empty()) left_out_title_ = fmt::format("{} in the file", d->left_out.size());
  }
  const DrawingJob::Made* made = job.made();
  if (!made) return;
  const Conversion& c = made->conversion;
  problem_ = made->problem;
  can_be_cut_ = !problem_.empty() && !made->parts.empty();
  if (can_be_cut_) {
    const std::size_t pieces = made->parts.front()->all.size();
    problem_ += fmt::format(" Cut draws it all the same, in {} piece{}.", pieces, pieces == 1 ? "" : "s");
  }
  if (made->duration_s)
    time_ = format_duration(*made->duration_s).view();
  else if (made->at_least_s)
    time_ = fmt::format("at least {}", format_duration(*made->at_least_s).view());
  count_ = moves_in(c.sequence.steps);
  moves_ = fmt::format("{}", count_);
  if (c.curve_mode == drawing::CurveMode::stairs) moves_ += ", an axis each";
  drawn_ = in_mm(c.drawn), travel_ = in_mm(c.way);
  if (const double saved = c.way_as_drawn - c.way; saved >= 0.05) {
    saved_ = in_mm(saved);
    untimed_ = !(wanted.travel.high > 0);
    if (!untimed_) saved_ += fmt::format(", {} s", format_number(saved / wanted.travel.high, 1).view());
  }
  if (made->together) beside_ = fmt::format("{} mm at most", format_number(made->beside, 3).view());
  size_ = fmt::format("{} \u00d7 {} mm", format_number(c.box.high.x - c.box.low.x, 3).view(),
                      format_number(c.box.high.y - c.box.low.y, 3).view());
  if (!c.off_the_table.empty())
    off_ = fmt::format("{} of {} chains leave the table.", c.off_the_table.size(), c.chains.size());
  chains_ = fmt::format("{}", c.chains.size());
  if (const auto lines = made->written.step_of_line.size(); lines > 0)
    chains_ += fmt::format(", {} lines", lines);
}

// ---- drawing

void DrawingFacts::draw_remarks(Frame& f, const std::vector<std::string>& remarks) {
  if (remarks.empty()) return;
  Ui& ui = f.ui;
  const ImVec2 from = ImGui::GetCursorScreenPos();
  for (std::size_t i = 0; i < std::min(most_remarks, remarks.size()); ++i)
    wrapped(ui, Face::small, Tone::ink2, remarks[i]);
  if (const std::size_t more = remarks.size() - std::min(most_remarks, remarks.size()); more > 0)
    wrapped(ui, Face::small, Tone::ink2, Path("And {} more remark{}.", more, more == 1 ? "" : "s"));
  show(ui, {"drawing/remarks", Kind::text, "Remarks", remarks.front()}, {from, ImGui::GetCursorScreenPos()});
}

void DrawingFacts::draw(Frame& f, const DrawingJob& job) {
  Ui& ui = f.ui;
  section_title(ui, "Time", job.busy_with());
  // The bar is always shown, so that the controls below do not move while work is under way.
  const float share = job.busy() ? job.ordered() : job.made() ? 1.0f : 0.0f;
  meter(ui, "drawing/progress", "Done", share,
        {.tone = job.busy() ? Tone::motion : Tone::ink2, .words = job.busy_with()});
  gap(ui, 8);
  const DrawingJob::Made* made = job.made();
  if (!problem_.empty()) {
    const ImVec2 from = ImGui::GetCursorScreenPos();
    wrapped(ui, Face::body, can_be_cut_ ? Tone::warn : Tone::fault, problem_);
    show(ui, {"drawing/problem", Kind::text, "Problem", problem_}, {from, ImGui::GetCursorScreenPos()});
    gap(ui, 8);
  }
  if (!off_.empty()) {
    const ImVec2 from = ImGui::GetCursorScreenPos();
    wrapped(ui, Face::body, Tone::warn, off_);
    show(ui, {"drawing/off", Kind::text, "Off the table", off_}, {from, ImGui::GetCursorScreenPos()});
    gap(ui, 8);
  }
  if (made) {
    if (!time_.empty()) key_value(ui, "drawing/time", made->duration_s ? "Rehearsed" : "Takes", time_);
    key_value(ui, "drawing/moves", "Moves", moves_);
    key_value(ui, "drawing/drawn", "Tool on", drawn_);
    key_value(ui, "drawing/travel", "Tool off", travel_);
    if (!saved_.empty()) key_value(ui, "drawing/saved", "Saved by reordering", saved_, Tone::ok);
    if (untimed_) draw_why_untimed(f);
    if (!beside_.empty()) key_value(ui, "drawing/beside", "Deviation", beside_);
    key_value(ui, "drawing/size", "Size", size_);
    key_value(ui, "drawing/chains", "Chains", chains_);
    draw_remarks(f, made->written.remarks);
    if (!made->written.tool.empty()) wrapped(ui, Face::small, Tone::ink2, made->written.tool);
  } else if (!job.drawing()) {
    wrapped(ui, Face::body, Tone::ink2, "Lines, arcs, circles, polylines, ellipses and splines are cut.");
  }
  group_line(ui);
}

void DrawingFacts::draw_why_untimed(Frame& f) {
  constexpr std::string_view why = "Give both speeds to see the time that this saves.";
  const ImVec2 from = ImGui::GetCursorScreenPos();
  wrapped(f.ui, Face::small, Tone::ink3, why);
  show(f.ui, {"drawing/saved/untimed", Kind::text, "Saved by reordering", why},
       {from, ImGui::GetCursorScreenPos()});
}

void DrawingFacts::draw_left_out(Frame& f) {
  const auto list = [&f](const char* id, std::string_view title, std::string_view caption,
                         const std::vector<std::string>& entities) {
    if (entities.empty()) return;
    section_title(f.ui, title, caption);
    const ImVec2 from = ImGui::GetCursorScreenPos();
    for (const std::string& what : entities) {
      wrapped(f.ui, Face::small, Tone::ink2, what);
      gap(f.ui, 4);
    }
    show(f.ui, {id, Kind::text, title, entities.front()}, {from, ImGui::GetCursorScreenPos()});
  };
  list("drawing/left_out", "Left out", left_out_title_, left_out_);
  list("drawing/understood", "Drawn with assumptions", {}, understood_);
}

}  // namespace hw::panels
