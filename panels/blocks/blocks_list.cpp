// Draws the column of blocks.
#include <algorithm>
#include <cmath>
#include <utility>

#include <imgui_internal.h>

#include "core/base/index.h"
#include "gui/model/tab.h"
#include "gui/model/units_format.h"
#include "gui/widgets/area.h"
#include "gui/widgets/button.h"
#include "gui/widgets/message.h"
#include "gui/widgets/text.h"
#include "panels/blocks/block_measures.h"
#include "panels/blocks/block_text.h"
#include "panels/blocks/blocks.h"
#include "panels/measures.h"
#include "panels/program/run_bar.h"
#include "panels/widget_path.h"

namespace hw::panels {

using namespace gui;
namespace seq = sequence;
void Blocks::draw_palette(Frame& f, float width, float height) {
  Ui& ui = f.ui;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  ImGui::SetCursorScreenPos(ImVec2(ui.px(f.area.x), at.y));
  begin_part(ui, "blocks/palette", ui.px(width), ui.px(height), Tone::panel, 8);
  gap(ui, 8);
  if (const BlockCandidates ways = palette_.draw(f, editor_->sequence(), true); !ways.empty()) add(f, ways);
  gap(ui, 8);
  end_part();
}

void Blocks::draw_list(Frame& f, const BlockSides::Columns& columns, float height) {
  Ui& ui = f.ui;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const bool palette_aside = columns.palette > 0;
  if (palette_aside)
    ImGui::GetWindowDrawList()->AddRectFilled(at, ImVec2(at.x + ui.hair(), ui.px(f.area.bottom())),
                                              ui[Tone::line]);
  // Without this ImGui still scrolls over the height of the last frame. The rows below a block that was
  // closed or removed would then jump in the next frame, away from the pointer.
  ImGui::SetNextWindowContentSize(ImVec2(0, beside_rows_px_ + rows_height(f)));
  begin_part(ui, "blocks/list", ui.px(columns.list), ui.px(height), Tone::panel, 12);
  const float inner = ImGui::GetContentRegionAvail().x / ui.scale;
  draw_title(f);
  if (!palette_aside) {
    if (const BlockCandidates ways = palette_.draw(f, editor_->sequence(), false); !ways.empty())
      add(f, ways);
    gap(ui, 8);
  }
  if (columns.side == 0 && draw_block_problem(f, *work_.written(), inner)) choose_first_refused(f);
  const float above = ImGui::GetCursorScreenPos().y;
  draw_rows(f, inner);
  const float below = ImGui::GetCursorScreenPos().y;
  if (const auto dropped = drag_.finish(ui)) drop(*dropped);
  draw_end(f, inner, palette_aside);
  draw_total(f, inner);
  gap(ui, 16);
  const float begin = ImGui::GetCurrentWindow()->DC.CursorStartPos.y;
  beside_rows_px_ = ImGui::GetCursorScreenPos().y - begin - (below - above);
  end_part();
}

/// While a program runs, the title shows how much of it is left.
void Blocks::draw_title(Frame& f) {
  Ui& ui = f.ui;
  const auto progress = run_progress(f);
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float right = at.x + ImGui::GetContentRegionAvail().x;
  const std::string_view columns = progress ? "" : "lines, rehearsed";
  section_title(ui, "Blocks", columns);
  if (!progress && files_.wants_room())
    files_.draw_name(f, at.x + ui.px(64), right - text_width(ui, Face::small, columns) - ui.px(12),
                     at.y + ui.px(20));
  if (!progress) return;
  const ImVec2 below = ImGui::GetCursorScreenPos();
  ImGui::SetCursorScreenPos(ImVec2(at.x, std::floor((at.y + below.y) / 2 - ui.px(20))));
  draw_run_progress(f, "blocks", *progress, at.x + ui.px(64), right);
  ImGui::SetCursorScreenPos(below);
}

/// Top of a row in pixels, below the first row. Refused blocks are higher than others, and an open block is
/// higher still.
float Blocks::top_of(const Frame& f, int row) const {
  const float pitch = f.ui.px(block_height) + f.ui.px(block_gap);
  const int open = chosen_.row();
  const float y = static_cast<float>(row) * pitch + (open >= 0 && row > open ? open_height_px_ : 0.0f);
  int complaints = drafts_.before(row);
  if (work_.up_to_date()) {
    complaints += work_.written()->refused_before(row);
    for (int r = drafts_.next(-1); r >= 0 && r < row; r = drafts_.next(r))
      if (work_.written()->refusal_of(r)) --complaints;  // a block shows only one of the two
    if (open >= 0 && row > open && work_.written()->refusal_of(open)) --complaints;
  }
  return y + static_cast<float>(complaints) * f.ui.px(refusal_height);
}

float Blocks::rows_height(const Frame& f) const { return top_of(f, static_cast<int>(rows_.size())); }

/// With very many rows, only visible rows are drawn; scripts do not find the others.
void Blocks::draw_rows(Frame& f, float width) {
  constexpr int very_many = 500, beyond_sight = 3;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const int count = static_cast<int>(rows_.size()), chosen = chosen_.row();
  int first = 0, behind = count;
  if (count >= very_many) {
    const float above = ImGui::GetWindowPos().y - at.y, below = above + ImGui::GetWindowHeight();
    const auto row_at = [&](float y) {
      int low = 0, high = count;
      while (low < high) {
        const int middle = (low + high) / 2;
        if (top_of(f, middle + 1) > y)
          high = middle;
        else
          low = middle + 1;
      }
      return low;
    };
    first = std::max(row_at(above) - beyond_sight, 0);
    behind = std::min(row_at(below) + beyond_sight + 1, count);
  }
  const auto draw_one = [&](int row) { draw_row_at(f, row, ImVec2(at.x, at.y + top_of(f, row)), width); };
  if (chosen >= 0 && chosen < first) draw_one(chosen);
  for (int row = first; row < behind; ++row) draw_one(row);
  if (chosen >= behind) draw_one(chosen);
  if (std::exchange(in_sight_, chosen) != chosen && chosen >= 0) scroll_to(f, chosen, at.y);
  ImGui::SetCursorScreenPos(ImVec2(at.x, at.y + rows_height(f)));
}

/// Scrolls to the row and, as far as they fit, its fields. `top`: top of the first row.
void Blocks::scroll_to(const Frame& f, int row, float top) {
  const float begin = top + top_of(f, row), end = begin + f.ui.px(block_height + block_gap) + open_height_px_;
  const float view = ImGui::GetWindowPos().y, room_above = begin - view;
  const float by = std::min(std::max(end - (view + ImGui::GetWindowHeight()), 0.0f), room_above);
  if (by != 0) ImGui::SetScrollY(ImGui::GetScrollY() + by);
}

void Blocks::draw_row_at(Frame& f, int row, ImVec2 at, float width) {
  if (ix(row) >= rows_.size()) return;  // a row above was removed in this frame
  ImGui::SetCursorScreenPos(at);
  draw_row(f, ix(row), width);
}

static void draw_sentence(Frame& f, std::string_view id, std::string_view label, Tone tone,
                          std::string_view words, float width) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  wrapped(f.ui, Face::small, tone, words, width);
  show(f.ui, {.id = id, .kind = Kind::text, .label = label, .value = words},
       {at, ImVec2(at.x + f.ui.px(width), ImGui::GetCursorScreenPos().y)});
  gap(f.ui, 6);
}

/// Draws the total time, or why it is unknown, the stops before the end, and the assumed values.
void Blocks::draw_total(Frame& f, float width) {
  Ui& ui = f.ui;
  const ProgramFacts& program = f.catalog.program;
  if (work_.written()->cost > 0 && program.capacity > 0) {
    gap(ui, 8);
    const Path used("{} of {} {}", format_number(work_.written()->cost, 0).view(),
                    format_number(program.capacity, 0).view(), program.capacity_unit);
    key_value(ui, "blocks/memory", "Memory", used);
  }
  if (trial_.total().empty()) return;
  gap(ui, 8);
  const std::string_view without = trial_.without();
  const Path key("Rehearsed{}{}", without.empty() ? "" : " ", without);
  if (trial_.ends())
    key_value(ui, "blocks/total", key, trial_.total());
  else if (trial_.goes_on())
    key_value(ui, "blocks/at_least", key, trial_.total());
  else
    draw_sentence(f, "blocks/no_end", "Rehearsed", Tone::ink2, trial_.total(), width);
  for (std::size_t i = 0; i < trial_.stops().size(); ++i)
    draw_sentence(f, Path("blocks/stop/{}", i + 1), "Stop", Tone::warn, trial_.stops()[i], width);
  if (!trial_.assumed().empty())
    draw_sentence(f, "blocks/assumed", "Assumed", Tone::ink2, trial_.assumed(), width);
  draw_again(f, width);
}

/// Offers a new rehearsal after changes, or when assumed values can be read now.
void Blocks::draw_again(Frame& f, float width) {
  const bool old = trial_.is_old(),
             assumes = !trial_.assumed().empty() && f.tab.desk().programs.requests.can_read_more(f.now);
  if ((!old && !assumes) || is_under_way(f.now.program)) return;
  Ui& ui = f.ui;
  if (old) wrapped(ui, Face::small, Tone::warn, trial_.rehearsed(f).words, width);
  gap(ui, 8);
  const std::string_view why =
      f.now.any_axis_moving() ? "An axis is moving." : why_not_rehearse_now(f.now, f.catalog);
  if (button(ui, "blocks/again", "Rehearse from here", {.keys = "F5", .disabled = why}).clicked)
    trial_.again();
}

/// Draws the place of the next block if no block is chosen.
void Blocks::draw_end(Frame& f, float width, bool palette_aside) {
  Ui& ui = f.ui;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const Touch t = touch(ui, {"blocks/end", Kind::button, "Next block here"}, ImVec2(ui.px(width), ui.px(32)));
  draw_dashed_outline(ui, t.rect, ui[chosen_.any() ? Tone::edge : Tone::ink2]);
  draw_text_centred(ui, t.rect, Face::body, ui[chosen_.any() ? Tone::ink3 : Tone::ink2],
                    rows_.size() > 0 ? "Next block here"
                    : palette_aside  ? "Choose a block at the left to insert it here"
                                     : "Type the name of a block above to insert it here");
  draw_ring(ui, t);
  if (t.clicked) choose(std::nullopt);
  ImGui::SetCursorScreenPos(ImVec2(at.x, t.rect.max.y));
}

}  // namespace hw::panels
