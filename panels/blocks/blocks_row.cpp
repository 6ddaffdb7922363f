// Draws a block of the column, and the fields below the chosen block.
#include <algorithm>
#include <cmath>

#include "core/base/index.h"
#include "gui/model/tab.h"
#include "gui/widgets/button.h"
#include "gui/widgets/text.h"
#include "panels/blocks/block_icons.h"
#include "panels/blocks/block_measures.h"
#include "panels/blocks/blocks.h"
#include "panels/kept_legible.h"
#include "panels/widget_path.h"

namespace hw::panels {

using namespace gui;
namespace seq = sequence;

const RefusedStep* Blocks::refusal_of(std::size_t row) const {
  return work_.up_to_date() ? work_.written()->refusal_of(static_cast<int>(row)) : nullptr;
}

std::string_view Blocks::complaint_of(std::size_t row) const {
  const std::string_view typed = drafts_.problem_of(static_cast<int>(row));
  const RefusedStep* refused = typed.empty() ? refusal_of(row) : nullptr;
  return refused ? std::string_view(refused->why) : typed;
}

bool Blocks::is_open(std::size_t row) const { return chosen_.row() == static_cast<int>(row); }

void Blocks::draw_row(Frame& f, std::size_t row, float width) {
  Ui& ui = f.ui;
  const BlockRows::Words& words = rows_.words(row, look_.look());
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float left = block_indent * static_cast<float>(rows_.depth(row));
  const bool open = is_open(row);
  ImGui::SetCursorScreenPos(ImVec2(at.x + ui.px(left), at.y));
  const Touch t = touch(ui, {Path("blocks/{}", row + 1), Kind::button, words.title, words.summary},
                        ImVec2(ui.px(width - left), ui.px(block_height)));
  draw_card(f, row, t);
  draw_words(f, row, t.rect);
  drag_.see(ui, row, t);
  draw_ring(ui, t);
  const std::string_view complaint = complaint_of(row);
  float bottom = t.rect.max.y;
  if (!complaint.empty() && !open) {
    const Rect in{ImVec2(t.rect.min.x + ui.px(64), t.rect.max.y - ui.px(4)),
                  ImVec2(t.rect.max.x - ui.px(12), t.rect.max.y + ui.px(refusal_height - 4))};
    draw_text_in_lines(ui, in, Face::small, ui[Tone::fault], complaint, 2);
    keep_legible(ui, in);
    show(ui, {Path("blocks/{}/refusal", row + 1), Kind::text, "Refused", complaint}, in);
    bottom += ui.px(refusal_height);
  }
  ImGui::SetCursorScreenPos(ImVec2(at.x, bottom + ui.px(block_gap)));
  if (open) {
    const float below = ImGui::GetCursorScreenPos().y;
    draw_chosen(f, row, left, width);
    open_height_px_ = ImGui::GetCursorScreenPos().y - below;
    bottom += open_height_px_;
  }
  draw_brackets(f, row, at, bottom);
  if (t.clicked && !drag_.carries()) click(row);
}

/// Draws the background of a block, as high as all its content.
void Blocks::draw_card(Frame& f, std::size_t row, const Touch& t) {
  Ui& ui = f.ui;
  ImDrawList* list = ImGui::GetWindowDrawList();
  const bool refused = !complaint_of(row).empty(), chosen = chosen_.has_row(static_cast<int>(row));
  const bool live = run_.live_step() == static_cast<int>(row), skipped = rows_.step(row).skipped;
  Rect card = t.rect;
  if (is_open(row))
    card.max.y += open_height_px_;
  else if (refused)
    card.max.y += ui.px(refusal_height);
  const Tone ground = refused     ? Tone::fault_t
                      : live      ? Tone::motion_t
                      : chosen    ? Tone::sel
                      : t.hovered ? Tone::hover
                                  : Tone::raised;
  if (!skipped || chosen) draw_fill(ui, card, ui[ground]);
  if (skipped)
    draw_dashed_outline(ui, card, ui[Tone::edge]);
  else if (chosen || refused)
    draw_outline(ui, card, ui[refused ? Tone::fault : Tone::edge]);
  if (chosen || live || refused)
    list->AddRectFilled(card.min, ImVec2(card.min.x + ui.px(3), card.max.y),
                        ui[refused  ? Tone::fault
                           : chosen ? Tone::ink
                                    : Tone::motion]);
}

void Blocks::draw_words(Frame& f, std::size_t row, const Rect& card) {
  Ui& ui = f.ui;
  const BlockRows::Words& words = rows_.words(row, look_.look());
  const seq::Step& step = rows_.step(row);
  const bool refused = !complaint_of(row).empty(), live = run_.live_step() == static_cast<int>(row);
  const float middle = std::floor(card.centre().y), x = card.min.x, right = card.max.x - ui.px(12);
  const Tone ink = step.skipped ? Tone::ink3 : live ? Tone::motion : Tone::ink;
  const Tone ink2 = step.skipped ? Tone::ink3 : Tone::ink2;
  draw_text_line(ui, x + ui.px(10), x + ui.px(44), middle, Face::small, ui[Tone::ink3], words.number);
  const ImVec2 icon(std::floor(x + ui.px(52)), middle);
  if (refused || live)
    draw_icon(ImGui::GetWindowDrawList(), refused ? Icon::diamond_solid : Icon::play, icon, ui.px(12),
              ui[refused ? Tone::fault : Tone::motion]);
  else
    draw_block_icon(ImGui::GetWindowDrawList(), step.body, icon, ui.px(12), ui[ink2]);
  const std::string_view at_right = step.skipped ? "left out"
                                    : refused    ? refusal_of(row) ? "not written" : "not taken"
                                    : live       ? run_.live_words()
                                                 : trial_.time_of(row);
  const Face face = live ? Face::small_bold : Face::small;
  const float words_width = at_right.empty() ? 0 : std::ceil(text_width(ui, face, at_right)) + ui.px(8);
  draw_text_right(ui, ImVec2(right, middle - ui.line(face) / 2), face,
                  ui[refused ? Tone::fault
                     : live  ? Tone::motion
                             : Tone::ink3],
                  at_right);
  show(ui, {Path("blocks/{}/time", row + 1), Kind::text, live ? "State" : "Rehearsed", at_right},
       {ImVec2(right - words_width, card.min.y), ImVec2(right, card.max.y)});
  const auto& lines = work_.written()->lines_of_step;
  const int count = work_.up_to_date() && !refused && row < lines.size() ? lines[row] : 0;
  const float lines_right = right - std::max(words_width, ui.px(block_time_width));
  const bool with_lines = lines_right - x > ui.px(280);
  if (with_lines && count > 0) {
    const Path lines_shown("{}", count);
    draw_text_right(ui, ImVec2(lines_right, middle - ui.line(Face::small) / 2), Face::small, ui[Tone::ink3],
                    lines_shown);
    show(ui, {Path("blocks/{}/lines", row + 1), Kind::text, "Lines", lines_shown},
         {ImVec2(lines_right - ui.px(24), card.min.y), ImVec2(lines_right, card.max.y)});
  }
  const float end = with_lines ? lines_right - ui.px(28) : right - words_width;
  const float title = std::ceil(text_width(ui, Face::body_bold, words.title));
  const float summary = x + std::max(ui.px(160), ui.px(72) + title);
  draw_text_line(ui, x + ui.px(64), std::min(summary, end), middle, Face::body_bold, ui[ink], words.title);
  draw_text_line(ui, summary, end, middle, Face::body, ui[ink2], words.summary);
}

/// Draws the brackets at the left of the blocks in loops.
void Blocks::draw_brackets(Frame& f, std::size_t row, ImVec2 corner, float bottom) {
  Ui& ui = f.ui;
  ImDrawList* list = ImGui::GetWindowDrawList();
  const int next = row + 1 < rows_.size() ? rows_.depth(row + 1) : 0;
  for (int level = 0; level < rows_.depth(row); ++level) {
    const float x = corner.x + ui.px(block_indent * static_cast<float>(level) + 5);
    list->AddRectFilled(ImVec2(x, corner.y - ui.px(block_gap)), ImVec2(x + ui.px(3), bottom), ui[Tone::edge]);
    if (next <= level)
      list->AddRectFilled(ImVec2(x, bottom - ui.px(3)), ImVec2(x + ui.px(10), bottom), ui[Tone::edge]);
  }
}

void Blocks::draw_chosen(Frame& f, std::size_t row, float left, float width) {
  Ui& ui = f.ui;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float inner = width - left - 24;
  ImGui::Indent(ui.px(left + 12));
  const std::uint64_t version = editor_->version();
  draw_tools(f, rows_.step(row));
  gap(ui, 4);
  if (editor_->version() == version && chosen_.any() && !chosen_.several()) {
    const Path path("blocks/{}", row + 1);
    const EditedStep step{path, rows_.step(row).body, editor_->sequence(), look_.look(), refusal_of(row)};
    const bool is_tool = std::holds_alternative<seq::Pen>(step.body);
    if (auto body = form_.draw(f, step, inner)) editor_->replace(*chosen_.head(), std::move(*body));
    if (is_tool)
      if (auto frame = tool_.draw(f, path, inner)) editor_->replace_frame(std::move(*frame));
  }
  ImGui::Unindent(ui.px(left + 12));
  ImGui::SetCursorScreenPos(ImVec2(at.x, ImGui::GetCursorScreenPos().y + ui.px(8)));
}

void Blocks::draw_tools(Frame& f, const seq::Step& step) {
  Ui& ui = f.ui;
  const float left = ImGui::GetCursorScreenPos().x, edge = left + ImGui::GetContentRegionAvail().x;
  const bool tight = edge - left < ui.px(tools_in_words);
  const auto tool = [&](const char* id, const char* label, Icon icon = Icon::none,
                        std::string_view why_not = {}, std::string_view tip = {}) {
    ButtonOptions look;
    look.disabled = why_not, look.tip = tip;
    look.style = ButtonStyle::outlined;
    look.icon = icon;
    look.wordless = tight && icon != Icon::none;
    if (look.wordless && tip.empty()) look.tip = label;
    const float width = ui.px(button_width(ui, label, look));
    if (ImGui::GetCursorScreenPos().x + width > edge) {
      ImGui::NewLine();
      ImGui::SetCursorScreenPos(ImVec2(left, ImGui::GetCursorScreenPos().y));
    }
    const bool clicked = button(ui, id, label, look).clicked;
    ImGui::SameLine(0, ui.px(4));
    return clicked;
  };
  const bool several = chosen_.several(), skipped = step.skipped;
  const seq::StepPath at = *chosen_.head();
  for (const Lesson& lesson : BlockTeach::lessons(step.body)) {
    if (several || !lesson.id) continue;
    if (!tool(lesson.id, lesson.label, Icon::none, teach_.why_not(f, *editor_, at, lesson.what))) continue;
    if (auto body = teach_.teach(f, *editor_, at, lesson.what)) editor_->replace(at, std::move(*body));
    return form_.forget();
  }
  if (tool("blocks/up", "", Icon::chevron_up)) return move(-1);
  if (tool("blocks/down", "", Icon::chevron_down)) return move(1);
  if (tool("blocks/remove", "", Icon::cross)) return remove();
  if (tool("blocks/duplicate", "Duplicate", tight ? Icon::copy : Icon::none)) return duplicate();
  if (tool("blocks/skip", skipped ? "Take in" : "Leave out")) return skip(!skipped);
  if (!several && std::holds_alternative<seq::Repeat>(step.body)) {
    if (tool("blocks/unloop", "Take out of loop")) return choose(editor_->take_out_of_loop(at));
  } else if (tool("blocks/loop", "Into a loop")) {
    return put_into_loop();
  }
  if (!several) {
    std::string_view why = why_none();
    if (why.empty()) why = why_no_new_run(f);
    if (tool("blocks/run_here", "Run from here", Icon::play_outline, why,
             "Shows the moves to the start of this block, and asks first."))
      run_.ask_from(f, editor_->sequence(), chosen_.row());
  }
  ImGui::NewLine();
  if (several)
    named_text(ui, "blocks/chosen", Face::small, Tone::ink2,
               Path("{} blocks are chosen", chosen_.span().count));
}

}  // namespace hw::panels
