#pragma once
// The graphical programmer: a sequence as blocks in a column, and the text that the controller's language
// makes of it, tried as it grows. Ids: `blocks/ROW` (from 1), its fields `blocks/ROW/KEY`, `blocks/ROW/time`,
// `blocks/end`, `blocks/up`, `blocks/remove`, `blocks/undo`, `blocks/from_text`, `blocks/path`, and those of
// its parts.
#include <optional>

#include "core/sequence/editor.h"
#include "gui/shell/panel_entry.h"
#include "panels/blocks/block_files.h"
#include "panels/blocks/block_palette.h"
#include "panels/blocks/block_rows.h"
#include "panels/blocks/block_run.h"
#include "panels/blocks/block_trial.h"
#include "panels/blocks/block_work.h"
#include "panels/blocks/row_drag.h"
#include "panels/blocks/step_form.h"
#include "panels/blocks/text_to_blocks.h"

namespace hw::panels {

class Blocks final : public gui::Panel {
 public:
  void draw(gui::Frame& frame) override;

 private:
  void follow(gui::Frame& frame);
  void draw_toolbar(gui::Frame& frame);
  void draw_sides(gui::Frame& frame, float height);
  void use_keys(gui::Frame& frame);

  // ---- blocks_list.cpp
  void draw_palette(gui::Frame& frame, float height);
  void draw_list(gui::Frame& frame, float left, float width, float height);
  void draw_rows(gui::Frame& frame, float width);
  void draw_row_at(gui::Frame& frame, int row, ImVec2 at, float width);
  void draw_row(gui::Frame& frame, std::size_t row, float width);
  void draw_chosen(gui::Frame& frame, std::size_t row, float left, float width);
  void draw_tools(gui::Frame& frame, const sequence::Step& step);
  void draw_end(gui::Frame& frame, float width, bool palette_aside);
  void draw_total(gui::Frame& frame, float width);
  [[nodiscard]] bool is_refused(std::size_t row) const;
  void add(sequence::Step::Body body);
  void choose(std::optional<sequence::StepPath> path);
  void move(int rows);
  void drop(const RowDrag::Drop& drop);
  void change_chosen(
      std::optional<sequence::StepPath> (sequence::Editor::*change)(const sequence::StepPath&));
  void take_here(const gui::Frame& frame, sequence::Move move);

  sequence::Editor* editor_ = nullptr;  ///< the desk's, in this frame
  struct Chosen {
    std::optional<sequence::StepPath> path;  ///< none: the end of the list
    int row = -1;
    float height_px = 0;      ///< of what it shows below its row, as drawn last
    std::uint64_t loads = 0;  ///< Editor::loads() then
  };
  Chosen chosen_;
  BlockRows rows_;
  BlockWork work_;
  StepForm form_;
  BlockTrial trial_;
  BlockRun run_;
  RowDrag drag_;
  BlockPalette palette_;
  BlockFiles files_;
  TextToBlocks from_text_;
};

}  // namespace hw::panels
