#include "core/devices/arcus/language/loop_watch.h"

#include <limits>

namespace hw::arcus::language {
namespace {

/// Values that change only by a command, on the bench or by a program: after each of these the host asks for
/// the next turn anyway. Values that change with motion or time are not steady.
bool is_steady(const Operand& what) {
  if (what.kind != Operand::Kind::quantity) return true;
  switch (what.quantity) {
    case Quantity::inputs:
    case Quantity::input:
    case Quantity::enables:
    case Quantity::enable:
    case Quantity::analog: return true;
    default: return false;
  }
}

}  // namespace

void LoopWatch::runs(std::uint16_t line, Turn turn) {
  if (!tracking_) return;
  const Turn offset = turn - start_;
  if (steps_ == trace_.size() || offset > std::numeric_limits<std::uint16_t>::max()) {
    tracking_ = false;
    return;
  }
  trace_[steps_++] = {line, static_cast<std::uint16_t>(offset)};
}

void LoopWatch::has_read(const Operand& what, std::int32_t value) {
  if (!tracking_ || what.kind == Operand::Kind::number) return;
  for (int i = 0; i < reads_; ++i) {
    const Seen& seen = seen_[static_cast<std::size_t>(i)];
    if (!(seen.what == what)) continue;
    if (seen.value != value) tracking_ = false;
    return;
  }
  if (reads_ == seen_.size() || !is_steady(what)) {
    tracking_ = false;
    return;
  }
  seen_[reads_++] = {what, value};
}

void LoopWatch::goes_round(std::uint16_t head, Turn turn) {
  const bool same_loop = tracking_ && steps_ > 0 && trace_[0].line == head;
  if (!same_loop) return track(turn);
  idle_ = true;
  tracking_ = false;
  period_ = turn - start_;
  start_ = turn;
}

void LoopWatch::track(Turn turn) {
  tracking_ = true;
  idle_ = false;
  steps_ = reads_ = 0;
  start_ = turn;
}

LoopWatch::Place LoopWatch::place_at(Turn turn) const {
  if (turn <= start_) return {trace_[0].line, start_};
  const Turn round = start_ + (turn - start_) / period_ * period_;
  for (int i = 0; i < steps_; ++i) {
    const Step& step = trace_[static_cast<std::size_t>(i)];
    if (round + step.offset >= turn) return {step.line, round + step.offset};
  }
  return {trace_[0].line, round + period_};
}

std::optional<std::uint16_t> LoopWatch::ran_last(Turn turn) const {
  if (turn < start_) return std::nullopt;
  const Turn round = start_ + (turn - start_) / period_ * period_;
  std::optional<std::uint16_t> last;
  for (int i = 0; i < steps_ && round + trace_[static_cast<std::size_t>(i)].offset <= turn; ++i)
    last = trace_[static_cast<std::size_t>(i)].line;
  return last;
}

}  // namespace hw::arcus::language
