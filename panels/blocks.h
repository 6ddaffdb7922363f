#pragma once
// The graphical programmer: a sequence as blocks in a column, and the text that the controller's language
// makes of it, tried as it grows. Ids: `blocks/add_by_name`, `blocks/add/move`, `blocks/ROW` (from 1), its
// fields `blocks/ROW/KEY`, `blocks/ROW/time`, `blocks/end`, `blocks/up`, `blocks/remove`, `blocks/undo`,
// `blocks/open`, `blocks/save`, `blocks/text`, `blocks/path`, `blocks/problem`, and those of BlockRun.
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/device/language.h"
#include "core/sequence/editor.h"
#include "gui/panel.h"
#include "gui/widgets/file_dialog.h"
#include "panels/block_run.h"
#include "panels/block_trial.h"
#include "panels/row_drag.h"
#include "panels/step_form.h"

namespace hw::panels {

class Blocks final : public gui::Panel {
 public:
  void draw(gui::Frame& frame) override;

 private:
  struct Row {
    sequence::StepPath path;
    std::string number, title, summary;
    bool skipped = false, refused = false;
  };
  void work_out(gui::Frame& frame);
  void find_refused();
  void draw_toolbar(gui::Frame& frame);
  void draw_files(gui::Frame& frame);
  void draw_text_side(gui::Frame& frame, float height);
  void draw_path_side(gui::Frame& frame, float top_px, float height);
  void draw_dialogs(gui::Frame& frame);
  void use_keys(gui::Frame& frame);
  [[nodiscard]] int chosen_row() const;
  void ask_open();
  void ask_save(const gui::Frame& frame);
  void ask_or_open(gui::Frame& frame, const std::filesystem::path& path);
  void open(gui::Frame& frame, const std::filesystem::path& path);
  void save(gui::Frame& frame, const std::filesystem::path& path);

  // ---- blocks_list.cpp
  void draw_palette(gui::Frame& frame, float height);
  void draw_finder(gui::Frame& frame, bool all);
  void draw_list(gui::Frame& frame, float left, float width, float height);
  bool pass_over(gui::Ui& ui, std::size_t row);
  void draw_row(gui::Frame& frame, std::size_t row, float width);
  void draw_chosen(gui::Frame& frame, std::size_t row, float left, float width);
  void draw_tools(gui::Frame& frame, const sequence::Step& step);
  void draw_end(gui::Frame& frame, float width, bool palette_aside);
  void draw_total(gui::Frame& frame, float width);
  void add(sequence::Step::Body body);
  void choose(std::optional<sequence::StepPath> path);
  void move(int rows);
  void drop(const RowDrag::Drop& drop);
  void change_chosen(
      std::optional<sequence::StepPath> (sequence::Editor::*change)(const sequence::StepPath&));
  void take_here(const gui::Frame& frame, sequence::Move move);

  sequence::Editor* editor_ = nullptr;            ///< the desk's, in this frame
  std::uint64_t loads_ = 0;                       ///< Editor::loads() then
  std::uint64_t worked_out_ = ~std::uint64_t{0};  ///< Editor::version() then
  std::vector<Row> rows_;
  std::optional<sequence::StepPath> chosen_;  ///< none: the end of the list
  StepForm form_;
  BlockTrial trial_;
  BlockRun run_;
  RowDrag drag_;
  std::string wanted_;  ///< typed to find a block by its name
  SequenceText text_;
  std::string problem_, facts_;
  std::filesystem::path to_open_;
  gui::FileDialog open_, save_;
  bool asking_open_ = false;
};

}  // namespace hw::panels
