#pragma once
// Blocks on their way into the controller: their text takes the place of the chosen program and is run there,
// and the block that the controller is at is known. Ids: `blocks/run` and the rest of the run bar,
// `blocks/to_program`, `blocks/replace`, `blocks/run_from/yes`.
#include <cstdint>
#include <memory>
#include <string_view>

#include "core/device/sequence_text.h"
#include "panels/program/run_bar.h"
#include "panels/program/run_from.h"

namespace hw::panels {

class BlockRun {
 public:
  /// At ImGui's cursor, in a row with what follows. `why_not`: what keeps the blocks from being written.
  void draw(gui::Frame& frame, const SequenceText& text, std::string_view why_not);
  void draw_dialog(gui::Frame& frame, const SequenceText& text);
  /// Asks whether all from there on shall be run. `step`: as SequenceText counts them.
  void ask_from(gui::Frame& frame, const sequence::Sequence& blocks, int step) {
    run_from_.ask(frame, blocks, {.step = step});
  }

  /// What the controller is at, as SequenceText counts the steps; -1: nothing of this text, or nobody knows.
  [[nodiscard]] int live_step() const { return live_step_; }
  /// "runs", "held here", "waits here", with "worked out" where the controller does not tell.
  [[nodiscard]] std::string_view live_words() const { return live_words_; }

 private:
  enum class Wanted : std::uint8_t { nothing, to_program, run, run_stepping };
  void follow(gui::Frame& frame, const SequenceText& text);
  void ask_or_put(gui::Frame& frame, const SequenceText& text, Wanted wanted);
  void put(gui::Frame& frame, const SequenceText& text);
  void run(gui::Frame& frame, RunWish wish);

  RunFrom run_from_;
  Wanted wanted_ = Wanted::nothing;  ///< behind the question
  std::weak_ptr<void> go_ahead_;     ///< a stop while it stands takes it away
  bool asking_ = false;
  int live_step_ = -1;
  std::string_view live_words_;
};

}  // namespace hw::panels
