#include "panels/tuning/step_table.h"

#include <cmath>
#include <optional>

#include "gui/model/units_format.h"
#include "gui/widgets/row.h"
#include "gui/widgets/text.h"
#include "panels/widget_path.h"

namespace hw::panels {

using namespace gui;
namespace {

constexpr float step_row_height = 26;

/// Replaces a unit.
constexpr std::string_view bare = "-";

struct Line {
  std::string_view id, label, brief, unit;
  int decimals;
  StepScatter::Of of;
  std::string_view absent;  ///< shown if there is none
};

constexpr Line lines[] = {
    {"overshoot", "Overshoot", "Overshoot", "%", 1,
     [](const StepMeasures& m) { return std::optional(m.overshoot_percent); }, ""},
    {"rise", "Rise, 10 to 90 %", "Rise", "ms", 1,
     [](const StepMeasures& m) { return m.rose ? std::optional(m.rise_ms) : std::nullopt; }, "did not rise"},
    {"settling", "Settling, 2 %", "Settling", "ms", 1,
     [](const StepMeasures& m) { return m.settled ? std::optional(m.settling_ms) : std::nullopt; },
     "not settled"},
    {"steady", "Steady error", "Steady", "", 1,
     [](const StepMeasures& m) { return m.steady_known ? std::optional(m.steady_error) : std::nullopt; }, ""},
    {"crossings", "Target passed", "Passed", bare, 0,
     [](const StepMeasures& m) { return std::optional(m.crossings); }, ""},
    {"largest", "Largest error", "Largest", "", 0,
     [](const StepMeasures& m) { return std::optional(m.largest_error); }, ""},
};

/// " ms", " counts"; a bare number has no unit.
Path unit_of(const Frame& f, const Line& m) {
  if (m.unit == bare) return Path("{}", "");
  return Path(" {}", m.unit.empty() ? std::string_view(f.catalog.step_word) : m.unit);
}

/// The number without unit: "12.0", "3.1 to 5.2", or "12.0 or more" if a gap hid the exact value.
Path measure_number(const Line& m, const StepMeasures& of) {
  const auto value = m.of(of);
  if (!of.any) return Path("{}", "");
  if (!value) return Path("{}", of.gaps > 0 ? "gap in it" : m.absent);
  const NumberText low = format_number(value->low, m.decimals);
  if (value->open()) return Path("{} or more", low.view());
  const NumberText high = format_number(value->high, m.decimals);
  return low.view() == high.view() ? Path("{}", low.view()) : Path("{} to {}", low.view(), high.view());
}
Path measure_words(const Frame& f, const Line& m, const StepMeasures& of) {
  const auto value = of.any ? m.of(of) : std::nullopt;
  const bool number = value.has_value();
  if (number && value->open())
    return Path("{}{} or more", format_number(value->low, m.decimals).view(), unit_of(f, m).view());
  return Path("{}{}", measure_number(m, of).view(), number ? unit_of(f, m).view() : std::string_view());
}

struct Change {
  Path words;
  Tone tone = Tone::ink2;
  Path by;                        ///< first part of the words: the amount
  std::string_view verdict = {};  ///< the second part
};
Change change_in_words(std::string_view words) { return {Path("{}", words), Tone::ink2, Path("{}", words)}; }

/// Less is better in all lines; errors count without their sign. A verdict needs the known scatter between
/// runs without a change.
Change change_of(const Frame& f, const Line& m, const TwoSteps& s, bool roomy) {
  const auto now = m.of(s.now), was = m.of(s.was);
  if (s.number == 0 || s.before == 0 || !s.now.any || !s.was.any || !now || !was) return change_in_words("");
  if (!now->exact() || !was->exact()) return change_in_words("not sure: a gap");
  const double by = std::fabs(now->low) - std::fabs(was->low);
  const double printed = 0.5 * std::pow(10.0, -m.decimals);
  const auto scatter = s.scatter.of(m.of);
  if (scatter && (std::fabs(by) < printed || std::fabs(by) <= *scatter)) return change_in_words("same");
  const bool none = std::fabs(by) < printed;
  const NumberText number = format_number(none ? 0 : by, m.decimals);
  const Path much("{}{}{}", by > 0 && !none ? "+" : "", number.view(),
                  roomy ? unit_of(f, m).view() : std::string_view());
  if (!scatter) return {Path("{}", much.view()), Tone::ink2, much, {}};
  const std::string_view verdict = by < 0 ? "better" : "worse";
  return {Path("{}, {}", much.view(), verdict), by < 0 ? Tone::ok : Tone::warn, much, verdict};
}

}  // namespace

void draw_step_table(Frame& f, const TwoSteps& s, float width) {
  Ui& ui = f.ui;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float left = at.x + ui.px(16), right = at.x + ui.px(width - 16);
  const float share = (right - left) / 4;
  const Column columns[] = {{"Measurements", 0, false},
                            {"", share * 0.85f / ui.scale, true},
                            {"", share * 0.85f / ui.scale, true},
                            {"", share * 1.15f / ui.scale, true}};
  const Columns places(ui, columns, left, right);
  const Rect head{ImVec2(left, at.y), ImVec2(right, at.y + ui.px(32))};
  places.text(ui, 0, head, Face::body_bold, ui[Tone::ink], "Measurements");
  if (s.number) places.text(ui, 1, head, Face::body_bold, ui[Tone::ink], Path("run {}", s.number));
  if (s.number && s.before) {
    places.text(ui, 2, head, Face::body, ui[Tone::ink2], Path("run {}", s.before));
    places.text(ui, 3, head, Face::body, ui[Tone::ink2], "change");
  }
  float y = head.max.y;
  for (const Line& m : lines) {
    const Rect row{ImVec2(left, y), ImVec2(right, y + ui.px(step_row_height))};
    ImGui::GetWindowDrawList()->AddRectFilled(ImVec2(at.x, y), ImVec2(at.x + ui.px(width), y + ui.hair()),
                                              ui[Tone::line]);
    places.text(ui, 0, row, Face::body, ui[Tone::ink2], m.label);
    const auto show_measure = [&](std::size_t column, std::string_view id, Face face, Tone tone,
                                  std::string_view words) {
      places.text(ui, column, row, face, ui[tone], words);
      show(ui, {id, Kind::text, m.label, words}, places.cell(column, row));
    };
    if (s.number)
      show_measure(1, Path("tuning/measure/{}", m.id), Face::body_bold, Tone::ink,
                   measure_words(f, m, s.now));
    if (s.number && s.before) {
      show_measure(2, Path("tuning/measure/{}/before", m.id), Face::body, Tone::ink2,
                   measure_words(f, m, s.was));
      const Change change = change_of(f, m, s, width >= 520);
      show_measure(3, Path("tuning/measure/{}/change", m.id), Face::body, change.tone, change.words);
    }
    y = row.max.y;
  }
  ImGui::SetCursorScreenPos(ImVec2(at.x, y));
  gap(ui, 8);
}

/// Draws a column for each measure. The unit is below the name, and a change takes two lines.
void draw_flat_step_table(Frame& f, const TwoSteps& s, float width) {
  Ui& ui = f.ui;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  constexpr float run_width = 52;
  const float left = at.x + ui.px(16 + run_width), right = at.x + ui.px(width - 16);
  float names = 0;
  for (const Line& m : lines) names += text_width(ui, Face::small, m.brief);
  const float apart = (right - left - names) / static_cast<float>(std::size(lines));
  const float now_y = at.y + ui.px(36), was_y = now_y + ui.px(24), change_y = was_y + ui.px(24);
  const auto line = [&](float y) {
    ImGui::GetWindowDrawList()->AddRectFilled(ImVec2(at.x, y), ImVec2(at.x + ui.px(width), y + ui.hair()),
                                              ui[Tone::line]);
  };
  const auto begin = [&](float y, Face face, Tone tone, std::string_view words) {
    draw_text_line(ui, at.x + ui.px(16), left, y + ui.px(12), face, ui[tone], words);
  };
  const bool compared = s.number != 0 && s.before != 0;
  for (const float y : {now_y, was_y, change_y}) line(y);
  if (s.number) begin(now_y, Face::small_bold, Tone::ink, Path("run {}", s.number));
  if (compared) begin(was_y, Face::small, Tone::ink2, Path("run {}", s.before));
  if (compared) begin(change_y, Face::small, Tone::ink2, "change");
  float x = left;
  for (const Line& m : lines) {
    const float pitch = text_width(ui, Face::small, m.brief) + apart, end = x + pitch - ui.px(4);
    const auto line_of = [&](float y, Face face, Tone tone, std::string_view words) {
      const bool fits = text_width(ui, face, words) <= end - x;
      draw_text_line(ui, x, end, y, fits ? face : Face::small, ui[tone], words);
    };
    const auto register_measure = [&](float y, float height, std::string_view id, std::string_view words) {
      show(ui, {id, Kind::text, m.label, words}, {ImVec2(x, y), ImVec2(end, y + ui.px(height))});
    };
    line_of(at.y + ui.px(11), Face::small, Tone::ink, m.brief);
    const std::string_view unit = m.unit.empty() ? std::string_view(f.catalog.step_word) : m.unit;
    if (m.unit != bare) line_of(at.y + ui.px(26), Face::small, Tone::ink2, unit);
    if (s.number) {
      line_of(now_y + ui.px(12), Face::body_bold, Tone::ink, measure_number(m, s.now));
      register_measure(now_y, 24, Path("tuning/measure/{}", m.id), measure_words(f, m, s.now));
    }
    if (compared) {
      line_of(was_y + ui.px(12), Face::body, Tone::ink2, measure_number(m, s.was));
      register_measure(was_y, 24, Path("tuning/measure/{}/before", m.id), measure_words(f, m, s.was));
      const Change change = change_of(f, m, s, false);
      line_of(change_y + ui.px(12), Face::body, change.tone, change.by);
      line_of(change_y + ui.px(28), Face::small, change.tone, change.verdict);
      register_measure(change_y, 40, Path("tuning/measure/{}/change", m.id), change.words);
    }
    x += pitch;
  }
  ImGui::SetCursorScreenPos(ImVec2(at.x, change_y + ui.px(40)));
  gap(ui, 4);
}

}  // namespace hw::panels
