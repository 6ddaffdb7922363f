#pragma once
// Pieces at work, one after the other: which is due, and why none is. Io thread only.
#include <cstdint>
#include <memory>
#include <string>

#include "core/device/piece_sync.h"
#include "core/device/pieces.h"
#include "core/device/snapshot.h"

namespace hw {

class PieceRun {
 public:
  /// `draft`: shows how far it has come. `wake` is notified when something may be due.
  PieceRun(const Catalog& catalog, Snapshot& draft, Event& wake)
      : catalog_(catalog), draft_(draft), wake_(wake) {}
  ~PieceRun() { end(); }

  /// Takes the place of what is left of another one, behind the piece that is at work.
  [[nodiscard]] Result<> begin(const intent::RunInPieces& wish);
  [[nodiscard]] bool running() const { return pieces_ != nullptr; }
  /// What would be sent behind the user's own words is half of a move that they may have changed.
  [[nodiscard]] bool is_one_move() const { return pieces_ && pieces_->one_move; }
  /// What would put the next piece elsewhere, or take its place, is refused.
  [[nodiscard]] Result<> allows(const IntentBody& body) const;
  /// What the controller is to do now; null: nothing, or it is not known to be at rest. `rounds`: that have
  /// ended.
  [[nodiscard]] const IntentBody* due(std::uint64_t rounds, Instant now);
  /// The next is due as soon as the others who do theirs together with these have nothing on the wire: until
  /// then no round begins here.
  [[nodiscard]] bool waits_for_others() const { return seat_ && seat_->waits_ready(); }
  /// The same at the speeds that are wanted now.
  [[nodiscard]] Result<IntentBody> at_speed(const IntentBody& due) const;
  /// It was asked for; what has come of it shows in that round and those behind it.
  void done(std::uint64_t shows_in, Instant now);
  /// After a round: a piece that has not come to its own end is followed by nothing. The sentence that says
  /// so; empty: all is well.
  [[nodiscard]] std::string watch(std::uint64_t rounds);

  /// Of the moves that are sent from now on, or of the next piece.
  [[nodiscard]] Result<> override_speed(int percent);
  /// The next piece waits.
  void hold(bool on);
  /// Nothing follows any more.
  void end();

 private:
  [[nodiscard]] bool at_rest() const;
  [[nodiscard]] bool may_begin();
  void show_step();
  void show_others();
  [[nodiscard]] std::string why_not_whole(const Piece& piece) const;
  [[nodiscard]] std::string why_not_there(const AxisTarget& end) const;
  [[nodiscard]] std::string why_not_done(const Piece& piece) const;
  std::string end_because(std::string_view what);

  const Catalog& catalog_;
  Snapshot& draft_;
  Event& wake_;
  std::shared_ptr<const Pieces> pieces_;
  std::shared_ptr<PieceSeat> seat_;        ///< null: nobody else does his together with these
  std::size_t piece_ = 0, step_ = 0;       ///< of its `does`
  std::size_t acts_before_ = 0;            ///< of the pieces that are done
  std::uint64_t shows_in_ = 0, seen_ = 0;  ///< rounds: that shows what was asked for; that was watched last
  Instant not_before_{};
  bool doubts_ = false;         ///< something seems not to have come to its own end: the next round tells
  std::uint32_t restarts_ = 0;  ///< of the controller, when they were begun
};

}  // namespace hw
