#pragma once
// Runs the pieces of a sequence one after the other: decides which act is due, and why none is. Io thread
// only.
#include <cstdint>
#include <memory>
#include <string>

#include "core/device/piece_sync.h"
#include "core/device/pieces.h"
#include "core/device/snapshot.h"

namespace hw {

class PieceRun {
 public:
  /// `snapshot` shows the progress. `wake` is notified when something may be due.
  PieceRun(const Catalog& catalog, Snapshot& snapshot, Event& wake)
      : catalog_(catalog), snapshot_(snapshot), wake_(wake) {}
  ~PieceRun() { end(); }

  /// Replaces the rest of a running sequence, after its present piece.
  [[nodiscard]] Result<> begin(const intent::RunInPieces& request);
  [[nodiscard]] bool running() const { return pieces_ != nullptr; }
  /// The pieces are the two halves of one move, which a typed command may have changed.
  [[nodiscard]] bool is_one_move() const { return pieces_ && pieces_->one_move; }
  /// Refuses an intent that would move the start of the next piece, or take its place.
  [[nodiscard]] Result<> allows(const IntentBody& body) const;
  /// The next thing to do; null: nothing, or the controller is not known to be at rest. `rounds`: status
  /// rounds so far.
  [[nodiscard]] const IntentBody* due(std::uint64_t rounds, Instant now);
  /// The next act is due as soon as the other controllers have nothing on the wire; no status round may begin
  /// until then.
  [[nodiscard]] bool waits_for_others() const { return seat_ && seat_->waits_ready(); }
  [[nodiscard]] bool runs_together() const { return running() && seat_; }
  /// Another controller that runs it together with this one has ended it.
  [[nodiscard]] bool others_have_ended() const { return runs_together() && seat_->has_ended(); }
  /// `due` at the present speed override.
  [[nodiscard]] Result<IntentBody> at_speed(const IntentBody& due) const;
  /// `act` is sent now. The first act that may move anything replaces the rest of an earlier drawing. Returns
  /// whether such an act had been sent before, see refused().
  bool sends(const IntentBody& act);
  /// The act was refused. `had_begun`: as sends() returned it.
  void refused(bool had_begun) { begun_ = had_begun; }
  /// The act was performed; its outcome shows from that status round on.
  void done(std::uint64_t shows_in, Instant now);
  /// After a status round: breaks off if a piece did not end as it should, and returns a sentence that says
  /// why; empty: all is well.
  [[nodiscard]] std::string watch(std::uint64_t rounds);

  /// Applies to the moves sent from now on, or to the next piece.
  [[nodiscard]] Result<> override_speed(int percent);
  /// Keeps the next piece back.
  void hold(bool on);
  /// Drops all remaining pieces.
  void end();

 private:
  [[nodiscard]] bool at_rest() const;
  [[nodiscard]] bool may_begin();
  void show_step();
  void show_others();
  [[nodiscard]] std::string why_not_whole(const Piece& piece) const;
  [[nodiscard]] std::string why_not_there(const AxisTarget& end) const;
  [[nodiscard]] std::string why_not_done(const Piece& piece) const;
  [[nodiscard]] bool list_broke_off(const Piece& piece) const;
  std::string end_because(std::string_view what);
  std::string end_now(std::string_view what);

  const Catalog& catalog_;
  Snapshot& snapshot_;
  Event& wake_;
  std::shared_ptr<const Pieces> pieces_;
  std::shared_ptr<PieceSeat> seat_;   ///< null: no other controller takes part
  std::size_t piece_ = 0, step_ = 0;  ///< index into Piece::does
  std::size_t acts_before_ = 0;       ///< acts in the pieces that are done
  std::uint64_t shows_in_ = 0,
                seen_ =
                    0;  ///< status rounds: the first that shows the present act; the last that was watched
  Instant not_before_{};
  bool begun_ = false;          ///< an act that may move an axis was sent
  bool doubts_ = false;         ///< a piece may have failed: the next round shows it
  std::uint32_t restarts_ = 0;  ///< restarts of the controller when the run began
};

}  // namespace hw
