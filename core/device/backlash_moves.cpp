#include "core/device/backlash_moves.h"

#include <fmt/core.h>

#include "core/base/index.h"
#include "core/device/axis_check.h"
#include "core/device/pieces.h"

namespace hw {
namespace {

Steps there(Sign way, Steps by) { return way == Sign::plus ? by : Steps(0) - by; }

/// The distance that the axis goes past its target first; 0: it ends in the right direction anyway, or does
/// not move.
Steps overshoot(const AxisState& axis, Steps way) {
  const Backlash& backlash = axis.backlash;
  if (backlash.by <= Steps(0) || way == Steps(0)) return Steps(0);
  const bool ends_right = (way > Steps(0)) == (backlash.last == Sign::plus);
  return ends_right ? Steps(0) : there(backlash.last, Steps(0) - backlash.by);
}

template <class Motion>
Motion of(const Motion& like, std::vector<AxisTarget> axes) {
  Motion motion = like;
  if constexpr (requires { motion.targets; })
    motion.targets = std::move(axes);
  else
    motion.distances = std::move(axes);
  return motion;
}

intent::RunInPieces in_two(IntentBody first, IntentBody second) {
  Piece piece;
  piece.does.push_back({std::move(first), {}});
  piece.does.push_back({std::move(second), {}});
  auto pieces = std::make_shared<Pieces>();
  pieces->all.push_back(std::move(piece));
  pieces->one_move = true;
  return intent::RunInPieces(std::move(pieces));
}

std::optional<intent::RunInPieces> taken_up(const Snapshot& now, const intent::MoveTo& move) {
  std::vector<AxisTarget> first = move.targets, second;
  for (AxisTarget& target : first) {
    if (target.axis.index >= max_axes) return {};
    const AxisState& axis = now.axes[target.axis.index];
    const Steps over = axis.position_known ? overshoot(axis, target.value - axis.commanded()) : Steps(0);
    if (over == Steps(0)) continue;
    second.push_back(target);
    target.value += over;
  }
  if (second.empty()) return {};
  return in_two(of(move, std::move(first)), of(move, std::move(second)));
}

std::optional<intent::RunInPieces> taken_up(const Snapshot& now, const intent::MoveBy& move) {
  std::vector<AxisTarget> first = move.distances, second;
  for (AxisTarget& distance : first) {
    if (distance.axis.index >= max_axes) return {};
    const Steps over = overshoot(now.axes[distance.axis.index], distance.value);
    if (over == Steps(0)) continue;
    second.push_back({distance.axis, Steps(0) - over});
    distance.value += over;
  }
  if (second.empty()) return {};
  return in_two(of(move, std::move(first)), of(move, std::move(second)));
}

}  // namespace

std::optional<intent::RunInPieces> with_backlash_taken_up(const Snapshot& now, const IntentBody& body) {
  if (now.pieces.running) return {};  // moves of pieces are not changed
  if (const auto* move = std::get_if<intent::MoveTo>(&body)) return taken_up(now, *move);
  if (const auto* move = std::get_if<intent::MoveBy>(&body)) return taken_up(now, *move);
  return {};
}

std::string describe_no_backlash(const intent::SetBacklash& request, std::size_t axes) {
  if (request.axis.index >= axes) return describe_no_axis(request.axis.index);
  if (request.backlash.by < Steps(0))
    return "The backlash is how far a move goes past its target: it cannot be negative. Nothing was changed.";
  return {};
}

}  // namespace hw
