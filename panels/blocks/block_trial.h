#pragma once
// Rehearses the text of the blocks whenever it has changed, as Run would start it. Gives the time of each
// block, and the path.
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "core/drawing/tool_path.h"
#include "gui/model/rehearsals.h"
#include "gui/model/unread_programs.h"
#include "gui/shell/frame.h"
#include "panels/blocks/block_work.h"
#include "panels/path/path_canvas.h"
#include "panels/program/rehearsed.h"

namespace hw::panels {

class BlockTrial {
 public:
  /// Call once a frame. Blocks that cannot be written are left out and have no times.
  void follow(gui::Frame& frame, const std::shared_ptr<const WrittenBlocks>& written);
  /// Rehearses the same text again, from the present positions, with all values that can be read from the
  /// controller: its set-up, and the programs and variables that the run reaches.
  void again();
  /// The result to show beside Run; empty: there is no text to run.
  [[nodiscard]] Rehearsed rehearsed(const gui::Frame& frame) const;
  /// Whether the controller has changed since, so that another rehearsal makes sense.
  [[nodiscard]] bool is_old() const;
  /// "2.3 s", for a step as SequenceText counts them; empty: unknown, or the step takes no time of its own.
  [[nodiscard]] std::string_view time_of(std::size_t step) const;
  /// "1 min 28.7 s", "at least 20 min", or why there is no time; empty: unknown.
  [[nodiscard]] std::string_view total() const { return total_; }
  [[nodiscard]] bool ends() const { return ends_; }
  /// Whether the rehearsal did not reach the end, because it takes too long.
  [[nodiscard]] bool goes_on() const { return goes_on_; }
  /// "without 8": blocks left out because they cannot be written; empty: none.
  [[nodiscard]] std::string_view without() const { return without_; }
  /// Stops before the end and their reasons, by line of the text.
  [[nodiscard]] const std::vector<std::string>& stops() const { return stops_; }
  /// Values that could not be read and were assumed; empty: none.
  [[nodiscard]] const std::string& assumed() const { return assumed_; }
  /// Draws the path at ImGui's cursor, logical size, with the lines of the step lit. Id: `blocks/path`.
  void draw_path(gui::Frame& frame, int lit_step, float width, float height);
  /// The step whose line was clicked in this frame; -1: none.
  [[nodiscard]] int clicked_step() const;

 private:
  void take(gui::Frame& frame, const gui::Rehearsals::Outcome& outcome);
  void take_path(const gui::Frame& frame, const Rehearsal& rehearsal);
  void forget();
  void start(gui::Frame& frame, bool at_length);
  [[nodiscard]] bool can_read(const gui::Frame& frame) const;
  [[nodiscard]] bool reads_set_up(gui::Frame& frame);
  [[nodiscard]] bool reads_what_it_reached(gui::Frame& frame, const gui::Rehearsals::Outcome* done);
  [[nodiscard]] const gui::Rehearsals::Outcome* outcome() const { return rehearsals_.of(program_); }

  gui::Rehearsals rehearsals_;
  std::shared_ptr<const WrittenBlocks> tried_;  ///< blocks being rehearsed, or rehearsed last
  int program_ = 0;                             ///< program with which Run would start
  bool again_ = false, at_length_ = false;
  IntentId reading_ = 0;  ///< command that reads the set-up; 0: not now
  gui::UnreadPrograms unread_;
  bool may_read_ = false;           ///< the rehearsal was requested by again(), not by an edit
  bool reads_reached_ = false;      ///< reads what the last rehearsal reached, then repeats it
  int taken_ = 0;                   ///< Rehearsals::Outcome::number
  std::vector<std::string> times_;  ///< times by step
  std::string total_, without_, assumed_;
  std::vector<std::string> stops_;
  bool ends_ = false, goes_on_ = false;
  std::shared_ptr<const drawing::ToolPath> path_;
  PathAxes shown_;  ///< axes of the path
  PathCanvas canvas_;
};

}  // namespace hw::panels
