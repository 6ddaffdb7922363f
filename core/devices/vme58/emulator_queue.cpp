#include "core/devices/vme58/emulator_queue.h"

#include <algorithm>

#include "core/base/index.h"

namespace hw::vme58 {

bool CommandQueue::nests(const Command& command) const {
  if (begins_block(command.op())) return open_.size() < ix(loop_levels);
  if (const auto begin = block_begin_of(command.op())) return !open_.empty() && open_.back() == *begin;
  return true;
}

void CommandQueue::push(const Command& command) {
  if (begins_block(command.op())) open_.push_back(command.op());
  if (block_begin_of(command.op())) open_.pop_back();
  used_ += command.entries();
  commands_.push_back(command);
}

void CommandQueue::advance(std::size_t more) {
  next_ = std::min(next_ + 1 + more, commands_.size());
  drop_done();
}

void CommandQueue::open_block(std::int64_t turns) {
  blocks_.push_back({next_ + 1, turns});
  ++next_;
}

void CommandQueue::end_block(bool again) {
  if (again && !blocks_.empty()) {
    next_ = blocks_.back().begin;
    return;
  }
  if (!blocks_.empty()) blocks_.pop_back();
  advance();
}

bool CommandQueue::has_while() const {
  return std::any_of(commands_.begin(), commands_.end(), [](const Command& c) { return c.op() == Op::WH; });
}

void CommandQueue::drop_done() {
  if (!blocks_.empty()) return;
  for (; next_ > 0; --next_) {
    used_ -= commands_.front().entries();
    commands_.pop_front();
  }
}

}  // namespace hw::vme58
