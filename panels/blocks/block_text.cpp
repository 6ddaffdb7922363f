#include "panels/blocks/block_text.h"

#include <algorithm>
#include <cmath>

#include "gui/model/units_format.h"
#include "gui/surface/ui.h"
#include "gui/widgets/area.h"
#include "gui/widgets/button.h"
#include "gui/widgets/icons.h"
#include "gui/widgets/text.h"
#include "panels/lines.h"
#include "panels/widget_path.h"

namespace hw::panels {

using namespace gui;
namespace {

constexpr float text_line = 20;
/// In a text with more lines, scripts read only the visible lines.
constexpr std::size_t few_lines = 500;

struct LinesInSight {
  std::size_t first = 0, behind = 0;
};
LinesInSight lines_in_sight(const Ui& ui, float top, std::size_t count) {
  const float line = ui.px(text_line), from = ImGui::GetWindowPos().y - top;
  const auto bounded = [count](float n) {
    return static_cast<std::size_t>(std::clamp(n, 0.0f, static_cast<float>(count)));
  };
  return {bounded(std::floor(from / line)), bounded(std::ceil((from + ImGui::GetWindowHeight()) / line))};
}

/// The marks of a block, in order of precedence: refused, being executed, chosen.
void draw_line_of_text(Ui& ui, const WrittenBlocks& written, std::size_t n, const BlockTextMarks& marks,
                       ImVec2 at, float right) {
  const std::size_t begin = written.line_begins[n], end = written.line_begins[n + 1] - 1;
  const float line = ui.px(text_line), middle = at.y + line / 2;
  const int step = written.text.step_of_line[n];
  const bool refused = written.refusal_of(step) != nullptr, live = step >= 0 && step == marks.live_step;
  if (refused || live) draw_across(ui, at.y, at.y + line, ui[refused ? Tone::fault_t : Tone::motion_t]);
  if (marks.chosen.has_row(step))
    draw_across(ui, at.y, at.y + line, refused || live ? 0 : ui[Tone::sel], ui[Tone::ink]);
  draw_text_line(ui, at.x, at.x + ui.px(32), middle, Face::code_time, ui[Tone::ink3], Path("{}", n + 1));
  if (refused || live)
    draw_icon(ImGui::GetWindowDrawList(), refused ? Icon::diamond_solid : Icon::play,
              ImVec2(at.x + ui.px(36), std::floor(middle)), ui.px(8),
              ui[refused ? Tone::fault : Tone::motion]);
  draw_text_line(ui, at.x + ui.px(44), right, middle, Face::code_field, ui[refused ? Tone::fault : Tone::ink],
                 std::string_view(written.text.text).substr(begin, end - begin));
}

}  // namespace

bool draw_block_problem(Frame& f, const WrittenBlocks& written, float width) {
  if (written.problem.empty()) return false;
  Ui& ui = f.ui;
  const ImVec2 from = ImGui::GetCursorScreenPos();
  const std::size_t count = written.refused.size();
  // Each block shows its own reason; here the blocks are only counted.
  const Path counted("{} {} refused.", count, count == 1 ? "block is" : "blocks are");
  const std::string_view text = count > 0 ? counted.view() : std::string_view(written.problem);
  bool wanted = false;
  if (count > 0) {
    named_text(ui, "blocks/problem", Face::body, Tone::fault, text);
    ImGui::SetCursorScreenPos(ImVec2(from.x + text_width(ui, Face::body, text) + ui.px(8),
                                     from.y + std::floor((ui.line(Face::body) - ui.line(Face::small)) / 2)));
    wanted = link(ui, "blocks/show_refused", count == 1 ? "Show it" : "Show the first");
    ImGui::SetCursorScreenPos(ImVec2(from.x, from.y + ui.line(Face::body)));
  } else {
    wrapped(ui, Face::body, Tone::fault, text, width);
    show(ui, {"blocks/problem", Kind::text, "Problem", text},
         {from, ImVec2(from.x + ui.px(width), ImGui::GetCursorScreenPos().y)});
  }
  gap(ui, 8);
  return wanted;
}

bool draw_block_text(Frame& f, const WrittenBlocks& written, const BlockTextMarks& marks, float height) {
  Ui& ui = f.ui;
  draw_line_down(f);
  begin_part(ui, "blocks/side", 0, ui.px(height), Tone::panel, 16);
  const float width = ImGui::GetContentRegionAvail().x / ui.scale;
  const ProgramFacts& program = f.catalog.program;
  const bool measured = written.cost > 0 && program.capacity > 0;
  const Path used("{} of {} {}", format_number(written.cost, 0).view(),
                  format_number(program.capacity, 0).view(), program.capacity_unit);
  section_title(ui, "Resulting text", measured ? used.view() : "");
  const bool wanted = draw_block_problem(f, written, width);
  if (!written.remark.empty()) {
    wrapped(ui, Face::small, Tone::ink2, written.remark, width);
    gap(ui, 8);
  }
  const ImVec2 from = ImGui::GetCursorScreenPos();
  const float line = ui.px(text_line);
  const std::string_view text = written.text.text;
  const std::size_t count = written.text.step_of_line.size();
  const LinesInSight seen = lines_in_sight(ui, from.y, count);
  for (std::size_t n = seen.first; n < seen.behind; ++n) {
    draw_line_of_text(ui, written, n, marks, ImVec2(from.x, from.y + static_cast<float>(n) * line),
                      from.x + ui.px(width));
  }
  ImGui::Dummy(ImVec2(1, line * static_cast<float>(count)));
  std::string_view visible_text = text;
  if (count > few_lines)
    visible_text = text.substr(written.line_begins[seen.first],
                               written.line_begins[seen.behind] - written.line_begins[seen.first]);
  show(ui, {"blocks/text", Kind::text, "Resulting text", visible_text},
       {from, ImVec2(from.x + ui.px(width), ImGui::GetCursorScreenPos().y)});
  end_part();
  return wanted;
}

}  // namespace hw::panels
