#pragma once
// Runs the blocks in the controller: puts their text into the chosen program, runs it, and follows the block
// that is executed. Ids: `blocks/run` and the rest of the run bar, `blocks/to_program`, `blocks/replace`,
// `blocks/run_from/yes`, `blocks/doubt/once` and the rest of RunDoubt, and those of RunRefusal.
#include <cstdint>
#include <memory>
#include <optional>
#include <string_view>

#include "core/device/sequence_text.h"
#include "panels/blocks/live_block.h"
#include "panels/blocks/run_refusal.h"
#include "panels/program/run_bar.h"
#include "panels/program/run_doubt.h"
#include "panels/program/run_from.h"

namespace hw::panels {

class BlockRun {
 public:
  /// Draws at ImGui's cursor. The row may continue after it. `why_not`: why the blocks cannot be written.
  void draw(gui::Frame& frame, const SequenceText& text, std::string_view why_not, Rehearsed rehearsed);
  /// Draws, beside the bar's row, the question about doubtful positions, or why the blocks were not run.
  /// Returns the row of the list to show; -1: none.
  int draw_refusals(gui::Frame& frame, const SequenceText& text, const BlockRows& rows, const gui::Rect& bar);
  void draw_dialog(gui::Frame& frame, const SequenceText& text);
  /// Asks whether to run the blocks from `step` on, as SequenceText counts the steps.
  void ask_from(gui::Frame& frame, const sequence::Sequence& blocks, int step);

  /// The step that is executed, as SequenceText counts the steps; -1: no step of this text, or unknown.
  [[nodiscard]] int live_step() const { return live_.step(); }
  /// "runs", "held here" and so on: LiveBlock::words().
  [[nodiscard]] std::string_view live_words() const { return live_.words(); }

 private:
  enum class Wanted : std::uint8_t { nothing, to_program, run, run_stepping };
  void take_result(gui::Frame& frame, const SequenceText& text);
  void draw_doubt(gui::Frame& frame, const SequenceText& text, const gui::Rect& row);
  void ask_or_put(gui::Frame& frame, const SequenceText& text, Wanted wanted,
                  std::optional<gui::AgreedDoubts> agreed = {});
  void put(gui::Frame& frame, const SequenceText& text);
  void run(gui::Frame& frame, const SequenceText& text, RunRequest request);

  RunFrom run_from_;
  int from_ = 0;                             ///< the block from which the run begins
  Wanted wanted_ = Wanted::nothing;          ///< action to do when the question is answered
  std::optional<gui::AgreedDoubts> agreed_;  ///< doubts despite which the user wants to run
  RunDoubt doubt_;
  RunRefusal refusal_;
  std::weak_ptr<void> go_ahead_;  ///< expires on a stop while the question is open
  bool asking_ = false;
  LiveBlock live_;
};

}  // namespace hw::panels
