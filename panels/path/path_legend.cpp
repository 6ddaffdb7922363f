#include "panels/path/path_legend.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>

#include "gui/model/tab.h"
#include "gui/model/units_format.h"
#include "gui/widgets/area.h"
#include "gui/widgets/text.h"
#include "gui/widgets/touch.h"
#include "panels/path/path_limits.h"
#include "panels/path/path_trace.h"
#include "panels/widget_path.h"

namespace hw::panels {

using namespace gui;
namespace {

constexpr float swatch = 28, swatch_row = 24;

struct Stroke {
  ImU32 colour = 0;
  float width = 1;
  bool dashed = false;
};

/// Draws a line with as many parts as strokes, and its meaning.
void entry(const Frame& f, std::initializer_list<Stroke> strokes, std::string_view words) {
  Ui& ui = f.ui;
  const ImVec2 p = ImGui::GetCursorScreenPos();
  const float y = std::floor(p.y + ui.px(swatch_row / 2)), part = swatch / static_cast<float>(strokes.size());
  ImDrawList* list = ImGui::GetWindowDrawList();
  float begin = 0;
  for (const Stroke& s : strokes) {
    for (float x = 0; x < part; x += s.dashed ? 9 : part)
      list->AddRectFilled(ImVec2(p.x + ui.px(begin + x), y),
                          ImVec2(p.x + ui.px(begin + (s.dashed ? std::min(x + 5, part) : part)), y + s.width),
                          s.colour);
    begin += part;
  }
  draw_text_line(ui, p.x + ui.px(40), ui.px(f.area.right() - 16), p.y + ui.px(swatch_row / 2), Face::body,
                 ui[Tone::ink2], words);
  ImGui::SetCursorScreenPos(ImVec2(p.x, p.y + ui.px(swatch_row)));
}

void draw_lines(const Frame& f, const ProgramPath& program, const PathSubject& s) {
  Ui& ui = f.ui;
  const auto line = [&](Tone tone, float width, std::string_view words, bool dashed = false) {
    entry(f, {{ui[tone], width * ui.hair(), dashed}}, words);
  };
  const std::string& tool = program.facts().tool;
  const std::string_view by = tool;
  line(Tone::ink, 2, tool.empty() ? Path("rehearsed") : Path("rehearsed, tool on ({})", by));
  if (s.at_work) line(Tone::ink3, 1.5f, "remaining");
  if (!tool.empty()) line(Tone::ink3, 1, "rehearsed, tool off", true);
  if (program.commanded()) line(Tone::trace, 1, "as commanded");
  const auto aged = [&ui](std::size_t age) { return Stroke{trace_colour(ui, age), trace_width(ui, age)}; };
  const ImVec2 trace = ImGui::GetCursorScreenPos();
  entry(f, {aged(3)}, "trace, last 10 s");
  entry(f, {aged(2), aged(1), aged(0)}, "minute, 10 min, longer");
  show(ui, {"path/legend/trace", Kind::text, "Trace", "newest brightest"},
       {trace, ImVec2(ui.px(f.area.right() - 16), ImGui::GetCursorScreenPos().y)});
  line(Tone::motion, 3, "current or clicked line");
  const KnownLimits limits = limits_of(f, s);
  const auto any = [](const std::array<KnownEnds, 3>& all) {
    return std::any_of(all.begin(), all.end(), [](const KnownEnds& ends) { return ends.minus || ends.plus; });
  };
  if (any(limits.travel)) line(Tone::warn, 1, "limit of your own");
  if (any(limits.switches))
    line(Tone::warn, 1, f.bench.present ? "limit switch on the bench" : "limit switch, as found");
  if (any(limits.home)) line(Tone::ok, 1, f.bench.present ? "home, on the bench" : "home, as found");
}

/// A long size is below its name, so that its unit at the end is not cut.
void draw_size(Ui& ui, std::string_view size, float right) {
  constexpr std::string_view name = "Size";
  const float both = text_width(ui, Face::body, name) + text_width(ui, Face::body, size) + ui.px(16);
  if (both <= ImGui::GetContentRegionAvail().x) return key_value(ui, "path/size", name, size);
  key_value(ui, "", name, "");
  const ImVec2 at = ImGui::GetCursorScreenPos();
  wrapped(ui, Face::body, Tone::ink, size);
  show(ui, {"path/size", Kind::text, name, size}, {at, ImVec2(right, ImGui::GetCursorScreenPos().y)});
}

void draw_facts(const Frame& f, const ProgramPath& program, const PathSubject& s) {
  Ui& ui = f.ui;
  if (const std::string& refusal = program.refusal(); !refusal.empty()) {
    const ImVec2 at = ImGui::GetCursorScreenPos();
    wrapped(ui, Face::body, Tone::fault, refusal);
    show(ui, {"path/refusal", Kind::text, "Refusal", refusal},
         {at, ImVec2(ui.px(f.area.right() - 16), ImGui::GetCursorScreenPos().y)});
    gap(ui, 8);
  }
  if (!program.rehearsed()) return wrapped(ui, Face::body, Tone::ink2, "Nothing has been rehearsed yet.");
  if (!program.path()) {
    if (program.under_way()) return;
    return wrapped(ui, Face::body, Tone::ink2,
                   s.axes.over_time ? "This axis does not move in the program."
                                    : "These axes do not move in the program.");
  }
  const ProgramPath::Facts& facts = program.facts();
  draw_size(ui, facts.size, ui.px(f.area.right() - 16));
  if (!facts.way_on.empty()) {
    key_value(ui, "path/way_on", facts.tool.empty() ? "Way" : "Tool on", facts.way_on);
    if (!facts.tool.empty()) key_value(ui, "path/way_off", "Tool off", facts.way_off);
  }
  key_value(ui, "path/time", "Time", facts.time);
  if (const auto left = program.seconds_left()) {
    key_value(ui, "path/left", "Left", format_duration(*left).view());
    ui.wake_in(0.1);
  }
  if (program.drawn()) {
    const Path words("{}, as the controllers draw it together.", program.drawn()->name);
    gap(ui, 8);
    const ImVec2 at = ImGui::GetCursorScreenPos();
    wrapped(ui, Face::body, Tone::ink2, words);
    show(ui, {"path/drawn", Kind::text, "Drawing", words},
         {at, ImVec2(ui.px(f.area.right() - 16), ImGui::GetCursorScreenPos().y)});
  } else if (program.of_several()) {
    gap(ui, 8);
    wrapped(ui, Face::body, Tone::ink2, "As if their programs started together.");
  }
  if (facts.every > 1) {
    gap(ui, 8);
    const Path thinned("The path is long: one in {} places is shown.", facts.every);
    const ImVec2 at = ImGui::GetCursorScreenPos();
    wrapped(ui, Face::body, Tone::warn, thinned);
    show(ui, {"path/thinned", Kind::text, "Thinned", thinned},
         {at, ImVec2(ui.px(f.area.right() - 16), ImGui::GetCursorScreenPos().y)});
  }
  if (!program.older()) return;
  gap(ui, 8);
  wrapped(ui, Face::body, Tone::warn, path_is_older);
}

}  // namespace

void draw_path_legend(Frame& f, float height, const ProgramPath& program, const PathSubject& s) {
  Ui& ui = f.ui;
  begin_part(ui, "path/legend", 0, ui.px(height), Tone::panel, 16);
  section_title(ui, "Legend");
  draw_lines(f, program, s);
  group_line(ui);
  section_title(ui, "This path", program.under_way() ? "calculating" : "");
  draw_facts(f, program, s);
  end_part();
}

}  // namespace hw::panels
