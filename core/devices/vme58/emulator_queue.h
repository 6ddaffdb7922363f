#pragma once
// The queue of an axis, of AA or of AM: what waits there and where in it the board is. A block of a loop
// stays until the loop is left.
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
  /// Entries that are free (RQ).
  [[nodiscard]] int room() const { return queue_entries - used_; }
  [[nodiscard]] bool empty() const { return commands_.empty(); }
  /// Whether begin and end of loops make sense with what stands before (decisions M62, M63).
  [[nodiscard]] bool nests(const Command& command) const;
  /// `command` nests and there is room.
  void push(const Command& command);
  void clear() { *this = CommandQueue(); }

  /// What is to be done next, or being done; null: nothing.
  [[nodiscard]] const Command* current() const { return at(0); }
  /// So many places behind it.
  [[nodiscard]] const Command* at(std::size_t ahead) const {
    return next_ + ahead < commands_.size() ? &commands_[next_ + ahead] : nullptr;
  }
  /// The current one is done, and `more` behind it: on to the next.
  void advance(std::size_t more = 0);

  /// The current command opens a block that is run `turns` times: on into the block.
  void open_block(std::int64_t turns);
  /// The current command ends the innermost block. With `again` back to its begin; else on. LE counts by
  /// itself.
  void end_block(bool again);
  /// Turns that LE still has to do, this one included.
  [[nodiscard]] std::int64_t turns_left() const { return blocks_.empty() ? 0 : blocks_.back().turns; }
  void count_turn() {
    if (!blocks_.empty()) --blocks_.back().turns;
  }
  /// The number behind WS of the innermost block.
  [[nodiscard]] int block_operand() const {
    return blocks_.empty() ? 0 : static_cast<int>(commands_[blocks_.back().begin - 1].first());
  }
  /// What opened the innermost block; null: none is open.
  [[nodiscard]] const Command* block_head() const {
    return blocks_.empty() ? nullptr : &commands_[blocks_.back().begin - 1];
  }
  /// A WH stands in it, waiting or being run: CW means something.
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
  std::vector<Op> open_;       ///< begun in what has been put in, outermost first
};

}  // namespace hw::vme58
