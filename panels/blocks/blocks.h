#pragma once
// The graphical programmer: shows a sequence as blocks in a column, beside its text in the controller's
// language, and rehearses it after each change. Ids: `blocks/ROW` (from 1), its fields `blocks/ROW/KEY`,
// `blocks/ROW/time`, `blocks/end`, `blocks/up`, `blocks/remove`, `blocks/undo`, `blocks/from_text`,
// `blocks/path`, and those of its parts.
#include <optional>

#include "core/sequence/editor.h"
#include "gui/shell/panel_entry.h"
#include "panels/blocks/block_choice.h"
#include "panels/blocks/block_drafts.h"
#include "panels/blocks/block_files.h"
#include "panels/blocks/block_look.h"
#include "panels/blocks/block_palette.h"
#include "panels/blocks/block_rows.h"
#include "panels/blocks/block_run.h"
#include "panels/blocks/block_sides.h"
#include "panels/blocks/block_teach.h"
#include "panels/blocks/block_trial.h"
#include "panels/blocks/block_work.h"
#include "panels/blocks/row_drag.h"
#include "panels/blocks/step_form.h"
#include "panels/blocks/text_to_blocks.h"
#include "panels/blocks/tool_routines.h"

namespace hw::panels {

class Blocks final : public gui::Panel {
 public:
  void draw(gui::Frame& frame) override;

 private:
  void follow(gui::Frame& frame);
  void draw_toolbar(gui::Frame& frame);
  void draw_sides(gui::Frame& frame, float width, float height);
  void use_keys(gui::Frame& frame);

  // ---- blocks_list.cpp
  void draw_palette(gui::Frame& frame, float width, float height);
  void draw_list(gui::Frame& frame, const BlockSides::Columns& columns, float height);
  void draw_title(gui::Frame& frame);
  void draw_rows(gui::Frame& frame, float width);
  void scroll_to(const gui::Frame& frame, int row, float top_px);
  void draw_row_at(gui::Frame& frame, int row, ImVec2 at, float width);
  [[nodiscard]] float top_of(const gui::Frame& frame, int row) const;
  [[nodiscard]] float rows_height(const gui::Frame& frame) const;
  void draw_end(gui::Frame& frame, float width, bool palette_aside);
  void draw_total(gui::Frame& frame, float width);
  void draw_again(gui::Frame& frame, float width);

  // ---- blocks_row.cpp
  void draw_row(gui::Frame& frame, std::size_t row, float width);
  void draw_card(gui::Frame& frame, std::size_t row, const gui::Touch& touch);
  void draw_words(gui::Frame& frame, std::size_t row, const gui::Rect& card);
  void draw_brackets(gui::Frame& frame, std::size_t row, ImVec2 corner, float bottom);
  void draw_chosen(gui::Frame& frame, std::size_t row, float left, float width);
  void draw_tools(gui::Frame& frame, const sequence::Step& step);
  /// Why the blocks can neither be run nor put into the program; empty: they can.
  [[nodiscard]] std::string_view why_none() const;
  [[nodiscard]] const RefusedStep* refusal_of(std::size_t row) const;
  /// The problem shown on the closed card of a block; empty: none.
  [[nodiscard]] std::string_view complaint_of(std::size_t row) const;
  /// Whether the block shows its fields, because it alone is chosen.
  [[nodiscard]] bool is_open(std::size_t row) const;

  // ---- blocks_change.cpp
  void add(gui::Frame& frame, const BlockCandidates& ways);
  void choose(std::optional<sequence::StepPath> path);
  void choose_all(const sequence::StepSpan& span);
  void choose_moved(const sequence::StepSpan& span);
  void put_form_away();
  void open_form();
  /// Chooses the block and brings the list to the front.
  void bring_up(const gui::Frame& frame, sequence::StepPath path);
  void choose_first_refused(const gui::Frame& frame);
  void click(std::size_t row);
  void move(int rows);
  void drop(const RowDrag::Drop& drop);
  void remove();
  void take_back();
  void make_again();
  void duplicate();
  void put_into_loop();
  void skip(bool skipped);

  sequence::Editor* editor_ = nullptr;  ///< the desk's editor, for this frame
  BlockChoice chosen_;
  float open_height_px_ = 0;  ///< height of the open block below its row, as last drawn
  float beside_rows_px_ = 0;  ///< height of the list's content above and below its rows, as last drawn
  int in_sight_ = -1;         ///< row last scrolled to
  BlockSides sides_;
  BlockLook look_;
  BlockTeach teach_;
  BlockRows rows_;
  BlockWork work_;
  StepForm form_;
  ToolRoutines tool_;
  BlockDrafts drafts_;
  BlockTrial trial_;
  BlockRun run_;
  RowDrag drag_;
  BlockPalette palette_;
  BlockFiles files_;
  TextToBlocks from_text_;
};

}  // namespace hw::panels
