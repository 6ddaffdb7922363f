#include "core/device/piece_run.h"

#include <fmt/format.h>

#include "core/base/index.h"

namespace hw {

Result<> PieceRun::begin(const intent::RunInPieces& wish) {
  const std::size_t count = wish.pieces ? wish.pieces->all.size() : 0;
  if (wish.first < 0 || ix(wish.first) >= count)
    return fail(FaultKind::refused, fmt::format("There is no piece {} of {}.", wish.first + 1, count),
                "Nothing was sent.");
  if (!running() && !at_rest())
    return fail(FaultKind::refused, "Something runs or moves.", "Nothing was sent.", "Stop it first.");
  pieces_ = wish.pieces;
  piece_ = ix(wish.first), step_ = 0;
  draft_.pieces = PiecesState();
  draft_.pieces.running = true;
  draft_.pieces.done = wish.first;
  draft_.pieces.total = static_cast<std::int32_t>(count);
  return {};
}

bool PieceRun::at_rest() const {
  const ProgramState& p = draft_.program;
  const bool runs = p.owned && p.run != RunState::idle && p.run != RunState::error;
  return !runs && !draft_.any_axis_moving() && !draft_.working && !draft_.feed.running;
}

const IntentBody* PieceRun::due(std::uint64_t rounds) const {
  if (!running() || rounds < shows_in_ || !draft_.link.connected() || !at_rest()) return nullptr;
  if (draft_.pieces.held && step_ == 0) return nullptr;
  return &pieces_->all[piece_].does[step_];
}

void PieceRun::done(std::uint64_t shows_in) {
  shows_in_ = shows_in;
  ++step_;
}

std::string PieceRun::watch(std::uint64_t rounds) {
  if (!running() || step_ < pieces_->all[piece_].does.size()) return {};
  if (rounds < shows_in_ || !at_rest()) return {};
  std::string why = why_not_whole(pieces_->all[piece_]);
  if (!why.empty()) {
    why = fmt::format("Piece {} of {} {} Nothing follows it.", piece_ + 1, pieces_->all.size(), why);
    end();
    return why;
  }
  step_ = 0;
  draft_.pieces.done = static_cast<std::int32_t>(++piece_);
  if (piece_ == pieces_->all.size()) end();
  return {};
}

std::string PieceRun::why_not_whole(const Piece& piece) const {
  if (draft_.program.run == RunState::error) return "ended in an error.";
  for (const AxisTarget& end : piece.ends_at) {
    const AxisState& axis = draft_.axes[end.axis.index];
    if (axis.error != AxisError::none)
      return fmt::format("ended with an error of {}.", catalog_.axes[end.axis.index].name);
    const bool counts_as_written = !axis.in_counts && axis.loop == Loop::none && axis.position_known;
    if (counts_as_written && axis.position != end.value)
      return fmt::format("has left {} at {}, and it ends at {}.", catalog_.axes[end.axis.index].name,
                         axis.position.value, end.value.value);
  }
  return {};
}

void PieceRun::end() {
  pieces_.reset();
  draft_.pieces.running = draft_.pieces.held = false;
}

}  // namespace hw
