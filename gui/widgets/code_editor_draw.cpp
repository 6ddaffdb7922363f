// Draws the visible lines of the editor with their marks, costs and problem rows.
#include <algorithm>
#include <cstdio>

#include "gui/model/units_format.h"
#include "gui/widgets/button.h"
#include "gui/widgets/code_editor.h"
#include "gui/widgets/icons.h"
#include "gui/widgets/text.h"

namespace hw::gui {
namespace {

constexpr float number_right = 34, mark_x = 52, right_margin = 16;

Tone tone_of(TokenKind kind) {
  switch (kind) {
    case TokenKind::moves: return Tone::motion;
    case TokenKind::flow: return Tone::flow;
    case TokenKind::comment: return Tone::ink3;
    case TokenKind::bad: return Tone::fault;
    case TokenKind::plain: break;
  }
  return Tone::ink;
}

bool is_live(const EditorLook& look, int line) {
  return line == look.live_line ||
         std::find(look.also_live.begin(), look.also_live.end(), line) != look.also_live.end();
}

const LineReport* report_of(const EditorLook& look, int line) {
  if (!look.report || line >= static_cast<int>(look.report->lines.size())) return nullptr;
  return &look.report->lines[static_cast<std::size_t>(line)];
}

}  // namespace

void CodeEditor::draw_lines(Ui& ui, const EditorLook& look, const Metrics& m) {
  if (text_.empty() && !look.placeholder.empty() && !typing_) {
    ImGui::SetCursorScreenPos(ImVec2(m.origin.x, m.origin.y + ui.px(2)));
    wrapped(ui, Face::body, Tone::ink3, look.placeholder,
            (m.view.max.x - m.origin.x) / ui.scale - right_margin);
  }
  const int first = line_at(m, m.view.min.y);
  for (int line = first; line < model_.line_count(); ++line) {
    const float top = top_of(m, line);
    if (top >= m.view.max.y) break;
    const Rect row{ImVec2(m.view.min.x, top), ImVec2(m.view.max.x, top + m.line)};
    draw_ground(ui, look, m, line, row);
    ImGui::PushClipRect(ImVec2(m.view.min.x + m.text_x - ui.px(4), m.view.min.y), m.view.max, true);
    draw_selection(m, line, row);
    draw_code(ui, look, m, line, row);
    ImGui::PopClipRect();
    draw_right(ui, look, m, line, row);
    draw_gutter(ui, look, m, line, row);
  }
  int number = 0;
  for (const int line : problem_lines_) {
    ++number;
    const float top = top_of(m, line) + m.line;
    if (top + m.problem < m.view.min.y || top >= m.view.max.y) continue;
    if (const Problem* problem = problem_in(look, line, true))
      draw_problem_row(ui, look, m, *problem, number);
  }
  if (typing_) draw_caret(ui, m);
}

void CodeEditor::draw_ground(Ui& ui, const EditorLook& look, const Metrics& m, int line, const Rect& row) {
  ImDrawList* list = ImGui::GetWindowDrawList();
  const bool error = std::binary_search(problem_lines_.begin(), problem_lines_.end(), line);
  if (error)
    list->AddRectFilled(row.min, ImVec2(row.max.x, row.max.y + m.problem), ui[Tone::fault_t]);
  else if (is_live(look, line))
    list->AddRectFilled(row.min, row.max, ui[Tone::motion_t]);
  else if (typing_ && line == model_.caret().line && !model_.has_selection())
    list->AddRectFilled(row.min, row.max, ui[Tone::panel]);
}

void CodeEditor::draw_selection(const Metrics& m, int line, const Rect& row) {
  const TextRange chosen = model_.selection();
  if (!model_.has_selection() || line < chosen.begin.line || line > chosen.end.line) return;
  const float from = line == chosen.begin.line ? x_of(m, chosen.begin) : m.origin.x;
  // A selected line end is drawn half a character wide.
  const int size = static_cast<int>(model_.line(line).size());
  const float to =
      line == chosen.end.line ? x_of(m, chosen.end) : x_of(m, {line, size}) + std::floor(m.advance * 0.5f);
  ImGui::GetWindowDrawList()->AddRectFilled(ImVec2(from, row.min.y), ImVec2(to, row.max.y),
                                            ImGui::GetColorU32(ImGuiCol_TextSelectedBg));
}

void CodeEditor::draw_code(Ui& ui, const EditorLook& look, const Metrics& m, int line, const Rect& row) {
  const std::string& text = model_.line(line);
  const int size = static_cast<int>(text.size());
  const LineReport* report = report_of(look, line);
  const auto part = [&](int begin, int end, Tone tone) {
    begin = std::clamp(begin, 0, size);
    end = std::clamp(end, begin, size);
    if (begin == end) return;
    draw_text(ui, ImVec2(x_of(m, {line, begin}), row.min.y), Face::code, ui[tone],
              std::string_view(text).substr(static_cast<std::size_t>(begin),
                                            static_cast<std::size_t>(end - begin)));
  };
  int done = 0;
  if (report)
    for (const Token& token : report->tokens) {
      part(done, token.begin, Tone::ink);
      part(token.begin, token.end, tone_of(token.kind));
      done = std::max(done, token.end);
    }
  part(done, size, Tone::ink);
  if (const Problem* p = problem_in(look, line, true)) {
    const int from = std::clamp(p->column, 0, size),
              to = std::clamp(p->column + std::max(1, p->length), from, size);
    const float x0 = x_of(m, {line, from}), x1 = std::max(x_of(m, {line, to}), x0 + m.advance);
    ImGui::GetWindowDrawList()->AddRectFilled(ImVec2(x0, row.max.y - ui.px(3)),
                                              ImVec2(x1, row.max.y - ui.px(1)), ui[Tone::fault]);
  }
}

void CodeEditor::draw_gutter(Ui& ui, const EditorLook& look, const Metrics& m, int line, const Rect& row) {
  const bool live = is_live(look, line);
  const bool error = std::binary_search(problem_lines_.begin(), problem_lines_.end(), line);
  const bool here = typing_ && line == model_.caret().line;
  const Tone tone = error ? Tone::fault : live ? Tone::motion : here ? Tone::ink : Tone::ink3;
  char number[12];
  const int n = std::snprintf(number, sizeof number, "%d", line + 1);
  draw_text_right(ui, ImVec2(row.min.x + ui.px(number_right), row.min.y + ui.px(2)), Face::code_field,
                  ui[tone], {number, static_cast<std::size_t>(n)});
  const ImVec2 mark(row.min.x + ui.px(mark_x), std::floor(row.centre().y));
  ImDrawList* list = ImGui::GetWindowDrawList();
  const Problem* warning = problem_in(look, line, false);
  if (live)
    draw_icon(list, look.live_reported ? Icon::play : Icon::play_outline, mark, ui.px(11), ui[Tone::motion]);
  else if (error)
    draw_icon(list, Icon::diamond_solid, mark, ui.px(11), ui[Tone::fault]);
  else if (warning)
    draw_icon(list, Icon::warning, mark, ui.px(11), ui[Tone::warn]);
  const Rect gutter{row.min, ImVec2(row.min.x + m.text_x, row.max.y)};
  if (warning && ImGui::IsWindowHovered() && gutter.contains(ImGui::GetIO().MousePos))
    tooltip(ui, warning->sentence);
}

void CodeEditor::draw_right(Ui& ui, const EditorLook& look, const Metrics& m, int line, const Rect& row) {
  const float right = row.max.x - ui.px(right_margin);
  const float left = x_of(m, {line, static_cast<int>(model_.line(line).size())}) + ui.px(16);
  const LineReport* report = report_of(look, line);
  const int cost = report ? report->cost : 0;
  float end = right;
  char words[48] = {};
  if (!look.cost_title.empty() && !text_.empty()) {
    if (cost > 0 && line == 0)
      std::snprintf(words, sizeof words, "%s", count_of(cost, look.cost_title).c_str());
    else if (cost > 0)
      std::snprintf(words, sizeof words, "%d", cost);
    else if (line == 0)
      std::snprintf(words, sizeof words, "%.*s", static_cast<int>(look.cost_title.size()),
                    look.cost_title.data());
    const float w = std::ceil(text_width(ui, Face::small, words));
    if (right - w > left)
      draw_text_right(ui, ImVec2(right, row.min.y + ui.px(4)), Face::small,
                      ui[is_live(look, line) ? Tone::motion : Tone::ink3], words);
    end = right - std::max(ui.px(16), w) - ui.px(12);
  }
  const Problem* warning = problem_in(look, line, false);
  const bool live = line == look.live_line && !look.live_words.empty();
  if (line == look.live_line) {
    char shown[96];
    std::snprintf(shown, sizeof shown, "line %d, %.*s", line + 1, static_cast<int>(look.live_words.size()),
                  look.live_words.data());
    show(ui, {look.live, Kind::text, "live line", shown, {}, false, {}}, row);
  }
  const bool warned = !live && warning && line == model_.caret().line;
  if (!live && !warned) return;
  const std::string_view shown = live ? look.live_words : std::string_view(warning->sentence);
  const Face face = live ? Face::small_bold : Face::small;
  const float w = std::ceil(text_width(ui, face, shown));
  if (end - w > left)
    draw_text_right(ui, ImVec2(end, row.min.y + ui.px(4)), face, ui[live ? Tone::motion : Tone::warn], shown);
}

void CodeEditor::draw_problem_row(Ui& ui, const EditorLook& look, const Metrics& m, const Problem& problem,
                                  int number) {
  char id[96], fix_id[104];
  std::snprintf(id, sizeof id, "%.*s/%d", static_cast<int>(look.problems.size()), look.problems.data(),
                number);
  std::snprintf(fix_id, sizeof fix_id, "%s/fix", id);
  const float top = top_of(m, problem.line) + m.line, left = m.view.min.x + m.text_x;
  const Rect row{ImVec2(m.view.min.x, top), ImVec2(m.view.max.x, top + m.problem)};
  const bool fixable = !problem.fix_label.empty() && look.read_only.empty();
  const ButtonOptions style{.style = ButtonStyle::danger, .height = 26};
  const float button_w = fixable ? ui.px(button_width(ui, problem.fix_label, style)) : 0;
  const float room = m.view.max.x - ui.px(right_margin) - button_w - (fixable ? ui.px(8) : 0);
  const float middle = top + std::floor(m.problem * 0.5f) - ui.px(2);
  const float two_lines = 2 * ui.line(Face::body);
  const bool long_one = left + text_width(ui, Face::body, problem.sentence) > room;
  const bool cut = long_one && wrapped_height(ui, Face::body, problem.sentence, room - left) > two_lines;
  if (long_one && !cut) {
    ImGui::SetCursorScreenPos(ImVec2(left, top - ui.px(2)));
    wrapped(ui, Face::body, Tone::fault, problem.sentence, (room - left) / ui.scale);
  } else {
    draw_text_line(ui, left, room, middle, Face::body, ui[Tone::fault], problem.sentence);
  }
  show(ui,
       {id, Kind::text, "problem", problem.sentence, {}, false, cut ? problem.sentence : std::string_view()},
       row);
  if (!fixable) return;
  const float x =
      std::min(left + std::ceil(text_width(ui, Face::body, problem.sentence)) + ui.px(8), room + ui.px(8));
  ImGui::SetCursorScreenPos(ImVec2(x, middle - ui.px(13)));
  if (button(ui, fix_id, problem.fix_label, style).clicked) {
    model_.replace({{problem.line, problem.column}, {problem.line, problem.column + problem.length}},
                   problem.fix_text);
    reveal_ = true;
  }
}

void CodeEditor::draw_caret(Ui& ui, const Metrics& m) {
  const TextPlace caret = model_.caret();
  const float x = x_of(m, caret), top = top_of(m, caret.line);
  if (x < m.view.min.x + m.text_x - ui.px(2)) return;
  ImGui::GetWindowDrawList()->AddRectFilled(
      ImVec2(x, top + ui.px(3)), ImVec2(x + std::max(ui.hair(), ui.px(1.5f)), top + m.line - ui.px(3)),
      ui[Tone::ink]);
}

}  // namespace hw::gui
