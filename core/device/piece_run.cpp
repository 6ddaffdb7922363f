#include "core/device/piece_run.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "core/base/index.h"

namespace hw {

Result<> PieceRun::begin(const intent::RunInPieces& request) {
  if (!request.pieces || request.pieces->all.empty())
    return fail(FaultKind::refused, "There are no pieces.", "Nothing was sent.");
  if (!running() && !at_rest())
    return fail(FaultKind::refused, "A program is running or an axis is moving.", "Nothing was sent.",
                "Stop it first.");
  if (std::string why = why_not_begun(*request.pieces, catalog_, snapshot_); !why.empty())
    return fail(FaultKind::refused, std::move(why), "Nothing was sent.", "Switch it off first.");
  end();  // ends the rest of an earlier run
  pieces_ = request.pieces, seat_ = request.seat;
  if (seat_) seat_->take(wake_);
  piece_ = step_ = acts_before_ = 0;
  begun_ = doubts_ = false;
  restarts_ = snapshot_.restarts;
  const PiecesState before = std::exchange(snapshot_.pieces, PiecesState());
  snapshot_.pieces.running = true;
  snapshot_.pieces.drawing = pieces_->drawing;
  snapshot_.pieces.rest_of = before.rest_of, snapshot_.pieces.rest_step = before.rest_step;
  snapshot_.pieces.draws = seat_ || std::any_of(pieces_->all.begin(), pieces_->all.end(),
                                                [](const Piece& piece) { return piece.draws >= 0; });
  snapshot_.pieces.speed_can_change = snapshot_.pieces.draws || pieces_->text_at;
  snapshot_.pieces.total = static_cast<std::int32_t>(pieces_->all.size());
  return {};
}

Result<> PieceRun::allows(const IntentBody& body) const {
  const auto is = [&body](auto... kinds) { return (std::holds_alternative<decltype(kinds)>(body) || ...); };
  using namespace intent;
  const bool disturbs = is(SetPosition(0), SetEncoder(0), LoadProgram(0, {}), ClearProgram(0), RunProgram(0),
                           FeedMoves({}), SingleStep());
  const bool moves = std::holds_alternative<MoveTo>(body) || std::holds_alternative<MoveBy>(body) ||
                     std::holds_alternative<JogStart>(body) || std::holds_alternative<Home>(body);
  if (running() && moves && snapshot_.pieces.draws && step_ > 0)
    return fail(FaultKind::refused,
                "A piece is being drawn, and would continue from another place with its tool on.",
                "Nothing was sent.", "Stop it first.");
  if (is_one_move() && (moves || disturbs || std::holds_alternative<Act>(body)))
    return fail(FaultKind::refused, "A move that takes up backlash is under way.", "Nothing was sent.",
                "Wait until it has ended, or stop it.");
  if (!running() || !disturbs) return {};
  return fail(FaultKind::refused,
              "A sequence is running in pieces, and this command would disturb its next piece.",
              "Nothing was sent.", "Stop it first.");
}

Result<> PieceRun::override_speed(int percent) {
  constexpr int least = 10, most = 200;
  if (percent < least || percent > most)
    return fail(FaultKind::refused, fmt::format("Choose a speed from {} to {} percent.", least, most),
                "Nothing was changed.");
  if (!snapshot_.pieces.speed_can_change)
    return fail(FaultKind::refused,
                "Nothing is running in pieces, so there is no speed to change: a program runs at the speeds "
                "written in it.",
                "Nothing was changed.");
  if (!snapshot_.pieces.draws) {
    const std::size_t next = step_ == 0 ? piece_ : piece_ + 1;
    if (next == pieces_->all.size())
      return fail(FaultKind::refused, "The last piece is running, at the speeds written in it.",
                  "Nothing was changed.");
    if (auto text = pieces_->text_at(pieces_->all[next], percent); !text) return fail(text.error());
  }
  snapshot_.pieces.percent = percent;
  return {};
}

bool PieceRun::at_rest() const {
  const ProgramState& p = snapshot_.program;
  const bool runs = p.owned && p.run != RunState::idle && p.run != RunState::error;
  return !runs && !snapshot_.any_axis_moving() && !snapshot_.working && !snapshot_.feed.running;
}

const IntentBody* PieceRun::due(std::uint64_t rounds, Instant now) {
  if (!running() || rounds < shows_in_ || !snapshot_.link.connected() || !at_rest()) return nullptr;
  if (now < not_before_ || snapshot_.restarts != restarts_ || doubts_) return nullptr;
  const std::vector<PieceAct>& does = pieces_->all[piece_].does;
  while (step_ < does.size() && may_begin()) {  // after the last act the next round shows the outcome
    if (does[step_].what) return &*does[step_].what;
    not_before_ = now + does[step_++].then;
    if (now < not_before_) break;
  }
  return nullptr;
}

bool PieceRun::may_begin() {
  if (!seat_) return step_ > 0 || !snapshot_.pieces.held;
  if (seen_ < shows_in_) return false;  // the round that should show it has failed
  seat_->has_done(acts_before_ + step_);
  return seat_->may_begin(acts_before_ + step_);
}

void PieceRun::hold(bool on) {
  if (seat_ && on) seat_->hold();
  if (seat_ && !on) seat_->go_on();
  snapshot_.pieces.held = running() && (seat_ ? seat_->is_held() : on);
}

Result<IntentBody> PieceRun::at_speed(const IntentBody& due) const {
  if (const auto* move = std::get_if<intent::MoveTo>(&due); move && seat_ && move->speed.value > 0) {
    const double speed = move->speed.value * snapshot_.pieces.percent / 100;
    const Pps possible(std::clamp(speed, catalog_.jog_speed_min.value, catalog_.jog_speed_max.value));
    return IntentBody(intent::MoveTo(move->targets, possible));
  }
  const auto* load = std::get_if<intent::LoadProgram>(&due);
  if (!load || !pieces_->text_at || snapshot_.pieces.percent == 100) return due;
  auto text = pieces_->text_at(pieces_->all[piece_], snapshot_.pieces.percent);
  if (!text) return fail(text.error());
  return IntentBody(intent::LoadProgram(load->slot, std::move(*text)));
}

bool PieceRun::sends(const IntentBody& act) {
  const bool prepares = std::holds_alternative<intent::LoadProgram>(act) ||
                        std::holds_alternative<intent::SetOutput>(act) ||
                        std::holds_alternative<intent::SetParam>(act);
  return std::exchange(begun_, begun_ || !prepares);
}

void PieceRun::done(std::uint64_t shows_in, Instant now) {
  shows_in_ = shows_in;
  not_before_ = now + pieces_->all[piece_].does[step_].then;
  ++step_;
  doubts_ = false;
  if (begun_ && pieces_->drawing != 0) snapshot_.pieces.rest_of = 0, snapshot_.pieces.rest_step = 0;
}

/// The step that the controller reports; else the first of the piece.
void PieceRun::show_step() {
  const Piece& piece = pieces_->all[piece_];
  const bool threads = catalog_.program.threads > 0;
  const int command = threads ? snapshot_.threads.front().line : snapshot_.program.command;
  const bool reported = snapshot_.program.owned && command >= 0 && ix(command) < piece.step_of_command.size();
  int step = reported ? piece.step_of_command[ix(command)] : -1;
  const bool draws = piece.draws >= 0 && step_ == ix(piece.draws) + 1;
  const int row = draws ? std::min(snapshot_.feed.sent, static_cast<int>(piece.step_of_row.size())) - 1 : -1;
  if (row >= 0) step = piece.step_of_row[ix(row)];
  if (step_ <= piece.step_of_act.size()) step = piece.step_of_act[step_ - 1];
  snapshot_.pieces.step = std::max({snapshot_.pieces.step, piece.first_step, step});
}

std::string PieceRun::watch(std::uint64_t rounds) {
  seen_ = rounds;
  if (!running()) return {};
  if (seat_ && seat_->has_ended())
    return end(), std::string();  // the other controllers' run has given the reason
  if (snapshot_.restarts != restarts_) {
    const bool one_move = is_one_move();
    end();
    return one_move
               ? "The controller was switched off and on, or reset, while a move took up backlash. Its last "
                 "part was dropped."
               : "The controller was switched off and on, or reset, while a sequence was running in pieces. "
                 "The remaining pieces were dropped.";
  }
  show_others();
  if (step_ == 0) return {};
  show_step();
  const Piece& piece = pieces_->all[piece_];
  if (list_broke_off(piece)) return end_now("was not fully accepted by the controller.");
  if (rounds < shows_in_ || !at_rest()) return {};
  const bool whole = step_ == piece.does.size();
  std::string why = why_not_done(piece);
  if (whole && why.empty()) why = why_not_whole(piece);
  if (!why.empty()) return end_because(why);
  doubts_ = false;
  if (!whole) return {};
  acts_before_ += std::exchange(step_, 0);
  if (seat_) seat_->has_done(acts_before_);
  snapshot_.pieces.done = static_cast<std::int32_t>(++piece_);
  if (piece_ < pieces_->all.size()) {
    snapshot_.pieces.step = std::max(snapshot_.pieces.step, pieces_->all[piece_].first_step);
    return {};
  }
  if (seat_) seat_->finish();
  end();
  return {};
}

void PieceRun::show_others() {
  if (!seat_) return;
  snapshot_.pieces.held = seat_->is_held();
  snapshot_.pieces.rests = seat_->rests();
}

/// Confirmed by two rounds: in the first a position may have been read just before the axes came to rest.
std::string PieceRun::end_because(std::string_view what) {
  return std::exchange(doubts_, true) ? end_now(what) : std::string();
}

std::string PieceRun::end_now(std::string_view what) {
  std::string why =
      fmt::format("Piece {} of {} {} No further piece is sent.", piece_ + 1, pieces_->all.size(), what);
  end();
  return why;
}

/// The driver has reported why. Moves left in the buffer would continue, with the tool on.
bool PieceRun::list_broke_off(const Piece& piece) const {
  const FeedState& list = snapshot_.feed;
  return piece.draws >= 0 && step_ == ix(piece.draws) + 1 && !list.running && list.sent < list.total;
}

std::string PieceRun::why_not_whole(const Piece& piece) const {
  if (snapshot_.program.run == RunState::error) return "ended with an error.";
  for (const AxisTarget& end : piece.ends_at)
    if (std::string why = why_not_there(end); !why.empty()) return why;
  return {};
}

/// For the latest act, if it was a move: the tool may be on.
std::string PieceRun::why_not_done(const Piece& piece) const {
  const auto& what = piece.does[step_ - 1].what;
  const auto* move = what ? std::get_if<intent::MoveTo>(&*what) : nullptr;
  if (!move) return {};
  for (const AxisTarget& end : move->targets) {
    const EndedBy by = snapshot_.axes[end.axis.index].ended_by;
    if (by == EndedBy::limit) return fmt::format("hit a limit of {}.", catalog_.axes[end.axis.index].name);
    if (std::string why = why_not_there(end); !why.empty()) return why;
  }
  return {};
}

std::string PieceRun::why_not_there(const AxisTarget& end) const {
  const AxisState& axis = snapshot_.axes[end.axis.index];
  const std::string& name = catalog_.axes[end.axis.index].name;
  if (axis.error != AxisError::none) return fmt::format("ended with an error of {}.", name);
  if (axis.trust.doubtful()) return fmt::format("left {} at a position that cannot be trusted.", name);
  const bool counts_as_written = !axis.in_counts && axis.loop == Loop::none && axis.position_known;
  if (counts_as_written && axis.position != end.value)
    return fmt::format("left {} at {}; it should have ended at {}.", name, axis.position.value,
                       end.value.value);
  return {};
}

void PieceRun::end() {
  const bool whole = snapshot_.pieces.done >= snapshot_.pieces.total;
  const bool begun =
      begun_ || snapshot_.pieces.done > 0;  // the others may have moved although this one has not
  if (pieces_ && pieces_->drawing != 0 && begun) {
    snapshot_.pieces.rest_of = whole ? 0 : pieces_->drawing;
    snapshot_.pieces.rest_step = whole ? 0 : std::max(snapshot_.pieces.step, pieces_->all[piece_].first_step);
  }
  pieces_.reset();
  if (seat_) seat_->leave();
  seat_.reset();
  PiecesState& shown = snapshot_.pieces;
  shown.running = shown.held = shown.rests = shown.draws = shown.speed_can_change = false;
}

}  // namespace hw
