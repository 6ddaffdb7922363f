#include "core/device/piece_run.h"

#include <algorithm>

#include <fmt/format.h>

#include "core/base/index.h"

namespace hw {

Result<> PieceRun::begin(const intent::RunInPieces& wish) {
  if (!wish.pieces || wish.pieces->all.empty())
    return fail(FaultKind::refused, "There are no pieces.", "Nothing was sent.");
  if (!running() && !at_rest())
    return fail(FaultKind::refused, "Something runs or moves.", "Nothing was sent.", "Stop it first.");
  pieces_ = wish.pieces;
  piece_ = step_ = 0;
  restarts_ = draft_.restarts;
  draft_.pieces = PiecesState();
  draft_.pieces.running = true;
  draft_.pieces.draws = std::any_of(pieces_->all.begin(), pieces_->all.end(),
                                    [](const Piece& piece) { return piece.draws >= 0; });
  draft_.pieces.speed_can_change = draft_.pieces.draws || pieces_->text_at;
  draft_.pieces.total = static_cast<std::int32_t>(pieces_->all.size());
  return {};
}

Result<> PieceRun::allows(const IntentBody& body) const {
  const auto is = [&body](auto... kinds) { return (std::holds_alternative<decltype(kinds)>(body) || ...); };
  using namespace intent;
  const bool disturbs = is(SetPosition(0), SetEncoder(0), LoadProgram(0, {}), ClearProgram(0), RunProgram(0),
                           FeedMoves({}), SingleStep());
  const bool moves = std::holds_alternative<MoveTo>(body) || std::holds_alternative<MoveBy>(body) ||
                     std::holds_alternative<JogStart>(body) || std::holds_alternative<Home>(body);
  if (running() && moves && draft_.pieces.draws && step_ > 0)
    return fail(FaultKind::refused,
                "A piece is being drawn, and would go on from elsewhere with its tool on.",
                "Nothing was sent.", "Stop it first.");
  if (!running() || !disturbs) return {};
  return fail(FaultKind::refused, "A sequence is under way in pieces, and this would disturb the next one.",
              "Nothing was sent.", "Stop it first.");
}

Result<> PieceRun::override_speed(int percent) {
  constexpr int least = 10, most = 200;
  if (percent < least || percent > most)
    return fail(FaultKind::refused, fmt::format("The speed goes from {} to {} percent.", least, most),
                "Nothing was changed.");
  if (!draft_.pieces.speed_can_change)
    return fail(FaultKind::refused,
                "Nothing is under way in pieces whose speed could be changed: a program runs at the speeds "
                "that stand in it.",
                "Nothing was changed.");
  if (!draft_.pieces.draws) {
    const std::size_t next = step_ == 0 ? piece_ : piece_ + 1;
    if (next == pieces_->all.size())
      return fail(FaultKind::refused, "The last piece is at work, at the speeds that stand in it.",
                  "Nothing was changed.");
    if (auto text = pieces_->text_at(pieces_->all[next], percent); !text) return fail(text.error());
  }
  draft_.pieces.percent = percent;
  return {};
}

bool PieceRun::at_rest() const {
  const ProgramState& p = draft_.program;
  const bool runs = p.owned && p.run != RunState::idle && p.run != RunState::error;
  return !runs && !draft_.any_axis_moving() && !draft_.working && !draft_.feed.running;
}

const IntentBody* PieceRun::due(std::uint64_t rounds, Instant now) const {
  if (!running() || rounds < shows_in_ || !draft_.link.connected() || !at_rest()) return nullptr;
  if (now < not_before_) return nullptr;
  const Piece& piece = pieces_->all[piece_];
  const bool asked_for = step_ >= piece.does.size();  // the next round shows what has come of it
  if (asked_for || (draft_.pieces.held && step_ == 0) || draft_.restarts != restarts_) return nullptr;
  return &piece.does[step_].what;
}

Result<IntentBody> PieceRun::at_speed(const IntentBody& due) const {
  const auto* load = std::get_if<intent::LoadProgram>(&due);
  if (!load || !pieces_->text_at || draft_.pieces.percent == 100) return due;
  auto text = pieces_->text_at(pieces_->all[piece_], draft_.pieces.percent);
  if (!text) return fail(text.error());
  return IntentBody(intent::LoadProgram(load->slot, std::move(*text)));
}

void PieceRun::done(std::uint64_t shows_in, Instant now) {
  shows_in_ = shows_in;
  not_before_ = now + pieces_->all[piece_].does[step_].then;
  ++step_;
}

/// As far as the controller tells; else the piece's first.
void PieceRun::show_step() {
  const Piece& piece = pieces_->all[piece_];
  const bool threads = catalog_.program.threads > 0;
  const int command = threads ? draft_.threads.front().line : draft_.program.command;
  const bool told = draft_.program.owned && command >= 0 && ix(command) < piece.step_of_command.size();
  int step = told ? piece.step_of_command[ix(command)] : -1;
  const bool draws = piece.draws >= 0 && step_ == ix(piece.draws) + 1;
  const int row = draws ? std::min(draft_.feed.sent, static_cast<int>(piece.step_of_row.size())) - 1 : -1;
  if (row >= 0) step = piece.step_of_row[ix(row)];
  draft_.pieces.step = std::max({draft_.pieces.step, piece.first_step, step});
}

std::string PieceRun::watch(std::uint64_t rounds) {
  if (!running()) return {};
  if (draft_.restarts != restarts_) {
    end();
    return "The controller was switched off and on, or reset, while pieces were under way. Nothing follows.";
  }
  if (step_ == 0) return {};
  show_step();
  if (step_ < pieces_->all[piece_].does.size()) return {};
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
    if (axis.trust.doubtful())
      return fmt::format("has left {} where its position is not to be trusted.",
                         catalog_.axes[end.axis.index].name);
    const bool counts_as_written = !axis.in_counts && axis.loop == Loop::none && axis.position_known;
    if (counts_as_written && axis.position != end.value)
      return fmt::format("has left {} at {}, and it ends at {}.", catalog_.axes[end.axis.index].name,
                         axis.position.value, end.value.value);
  }
  return {};
}

void PieceRun::end() {
  pieces_.reset();
  draft_.pieces.running = draft_.pieces.held = draft_.pieces.draws = draft_.pieces.speed_can_change = false;
}

}  // namespace hw
