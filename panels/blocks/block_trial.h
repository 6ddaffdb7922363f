#pragma once
// Rehearses the text of the blocks whenever it has changed, as Run would start it, for the time of each block
// and the path.
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
  /// Call once a frame. Blocks that cannot be written have no times; the others are rehearsed without them.
  void follow(gui::Frame& frame, const std::shared_ptr<const WrittenBlocks>& written);
  /// Rehearses the same text again, from where the axes stand now, with all values that can be read from the
  /// controller: its set-up, and the programs and variables that the run reaches.
  void again();
  /// The words beside Run; empty: there is nothing to run.
  [[nodiscard]] Rehearsed rehearsed(const gui::Frame& frame) const;
  /// The controller has changed since, so that rehearsing it again makes sense.
  [[nodiscard]] bool is_old() const;
  /// "2.3 s", of the step as SequenceText counts them; empty: unknown, or the step takes no time of its own.
  [[nodiscard]] std::string_view time_of(std::size_t step) const;
  /// "1 min 28.7 s", "at least 20 min", or why there is no time; empty: unknown.
  [[nodiscard]] std::string_view total() const { return total_; }
  [[nodiscard]] bool ends() const { return ends_; }
  /// The rehearsal did not reach the end, which takes too long.
  [[nodiscard]] bool goes_on() const { return goes_on_; }
  /// "without 8": blocks left out because they cannot be written; empty: none.
  [[nodiscard]] std::string_view without() const { return without_; }
  /// Early stops and their reasons, by line of the text.
  [[nodiscard]] const std::vector<std::string>& stops() const { return stops_; }
  /// Values that could not be read and were assumed; empty: none.
  [[nodiscard]] const std::string& assumed() const { return assumed_; }
  /// Draws at ImGui's cursor, logical size, with the lines of the step lit. Id: `blocks/path`.
  void draw_path(gui::Frame& frame, int lit_step, float width, float height);
  /// Step whose line was clicked in this frame; -1: none.
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
  std::shared_ptr<const WrittenBlocks> tried_;  ///< being rehearsed, or rehearsed last
  int program_ = 0;                             ///< by which it would be started
  bool again_ = false, at_length_ = false;
  IntentId reading_ = 0;  ///< its set-up; 0: not now
  gui::UnreadPrograms unread_;
  bool may_read_ = false;           ///< asked for by again(), not by an edit
  bool reads_reached_ = false;      ///< what the last rehearsal reached; then it is repeated
  int taken_ = 0;                   ///< Rehearsals::Outcome::number
  std::vector<std::string> times_;  ///< by step
  std::string total_, without_, assumed_;
  std::vector<std::string> stops_;
  bool ends_ = false, goes_on_ = false;
  std::shared_ptr<const drawing::ToolPath> path_;
  PathAxes shown_;  ///< of the path
  PathCanvas canvas_;
};

}  // namespace hw::panels
