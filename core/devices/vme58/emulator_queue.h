#pragma once
// The queue of an axis, of AA or of AM: its commands and the board's place among them. A loop's block stays
// until the loop is left.
//
//   entries   LS3  MR100  GO  LE  MA0  GO
//                              ^ current: LE goes back to behind LS3, or on
#include <cstdint>
#include <deque>
#include <optional>
#include <vector>

#include "core/devices/vme58/emulator_parser.h"

namespace hw::vme58 {

class CommandQueue {
 public:
  /// Free entries (RQ).
  [[nodiscard]] int room() const { return queue_entries - used_; }
  [[nodiscard]] bool empty() const { return commands_.empty(); }
  /// Whether `command`, if it begins or ends a loop, fits the loops already open (decisions M62, M63).
  [[nodiscard]] bool nests(const Command& command) const;
  /// Requires nests(command) and enough room.
  void push(const Command& command);
  void clear() { *this = CommandQueue(); }

  /// The command under way or next; null: none.
  [[nodiscard]] const Command* current() const { return at(0); }
  /// The command `ahead` places behind current(); null: none.
  [[nodiscard]] const Command* at(std::size_t ahead) const {
    return next_ + ahead < commands_.size() ? &commands_[next_ + ahead] : nullptr;
  }
  /// Moves past the current command and `more` behind it.
  void advance(std::size_t more = 0);

  /// The current command opens a block to be run `turns` times: enters the block.
  void open_block(std::int64_t turns);
  /// The current command ends the innermost block: back to its start with `again`, else on. For LE, the
  /// caller counts the turns.
  void end_block(bool again);
  /// Turns left for LE, including the present one.
  [[nodiscard]] std::int64_t turns_left() const { return blocks_.empty() ? 0 : blocks_.back().turns; }
  void count_turn() {
    if (!blocks_.empty()) --blocks_.back().turns;
  }
  /// The operand of the command that opened the innermost block (WS).
  [[nodiscard]] int block_operand() const {
    return blocks_.empty() ? 0 : static_cast<int>(commands_[blocks_.back().begin - 1].first());
  }
  /// The command that opened the innermost block; null: none is open.
  [[nodiscard]] const Command* block_head() const {
    return blocks_.empty() ? nullptr : &commands_[blocks_.back().begin - 1];
  }
  /// The queue contains a WH, waiting or running, that CW can end.
  [[nodiscard]] bool has_while() const;

 private:
  struct Block {
    std::size_t begin;
    std::int64_t turns;
  };
  void drop_done();

  std::deque<Command> commands_;
  std::size_t next_ = 0;
  int used_ = 0;
  std::vector<Block> blocks_;  ///< being run, outermost first
  std::vector<Op> open_;       ///< opened by the commands put in, outermost first
};

}  // namespace hw::vme58
