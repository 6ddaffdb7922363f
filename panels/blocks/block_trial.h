#pragma once
// Blocks as they would run: their text is rehearsed whenever it has changed, which gives the time of each
// block and the path.
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "core/drawing/tool_path.h"
#include "gui/model/rehearsals.h"
#include "gui/shell/frame.h"
#include "panels/blocks/block_work.h"
#include "panels/path/path_canvas.h"

namespace hw::panels {

class BlockTrial {
 public:
  /// Once a frame. Of blocks that cannot be written nothing is known; the others are tried without them.
  void follow(gui::Frame& frame, const std::shared_ptr<const WrittenBlocks>& written);
  /// "2.3 s", of the step as SequenceText counts them; empty: not known, or it takes no time of its own.
  [[nodiscard]] std::string_view time_of(std::size_t step) const;
  /// "1 min 28.7 s", "at least 20 min", or why there is no time; empty: not known.
  [[nodiscard]] std::string_view total() const { return total_; }
  [[nodiscard]] bool ends() const { return ends_; }
  /// It was not tried to its end, which takes too long.
  [[nodiscard]] bool goes_on() const { return goes_on_; }
  /// "without 8": what is not in it since it cannot be written; empty: nothing.
  [[nodiscard]] std::string_view without() const { return without_; }
  /// At ImGui's cursor, logical size, with what the step draws lit. Id: `blocks/path`.
  void draw_path(gui::Frame& frame, int lit_step, float width, float height);
  /// Whose line was clicked in this frame; -1: none.
  [[nodiscard]] int clicked_step() const;

 private:
  void take(gui::Frame& frame, const gui::Rehearsals::Outcome& outcome);
  void forget();

  gui::Rehearsals rehearsals_;
  std::shared_ptr<const WrittenBlocks> tried_;  ///< what is being tried, or was
  int taken_ = 0;                               ///< Rehearsals::Outcome::number
  std::vector<std::string> times_;              ///< by step
  std::string total_, without_, none_;          ///< none_: why there is no path
  bool ends_ = false, goes_on_ = false;
  std::shared_ptr<const drawing::ToolPath> path_;
  PathCanvas canvas_;
};

}  // namespace hw::panels
