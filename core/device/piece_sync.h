#pragma once
// Keeps controllers on one wire in step while they run their pieces together: an act begins when all have
// ended the act before it and no status round is on the wire, so that no question comes between their
// commands. A hold holds all of them; if one ends, all end. Io thread only, except the destructor.
#include <atomic>
#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include "core/time/scheduler.h"

namespace hw {

class PieceSeat;

class PieceSync {
 public:
  [[nodiscard]] static std::vector<std::shared_ptr<PieceSeat>> seats(std::size_t members);

 private:
  friend class PieceSeat;
  struct Member {
    std::optional<std::size_t>
        done;  ///< acts done, counted over all pieces; none: this controller does not take part yet
    bool held = false;
    bool ready = false;  ///< ready for the next act: sends no question until all are ready
    Event* wake = nullptr;
  };
  void wake_all() const;
  [[nodiscard]] bool all_have_done(std::size_t acts) const;
  void none_is_ready();

  std::vector<Member> members_;
  std::size_t begun_ = 0;  ///< acts begun by the first member
  std::atomic<bool> ended_ = false;
};

/// The seat of one controller. If it is left or dropped before finish(), all end: its intent was refused, a
/// stop came first, or its run ended early.
class PieceSeat {
 public:
  PieceSeat(std::shared_ptr<PieceSync> sync, std::size_t place) : sync_(std::move(sync)), place_(place) {}
  ~PieceSeat();
  PieceSeat(const PieceSeat&) = delete;
  PieceSeat& operator=(const PieceSeat&) = delete;

  /// `wake` is notified when the progress of the others may have made an act due.
  void take(Event& wake) { me().wake = &wake; }
  void leave();
  /// This controller has ended that many acts.
  void has_done(std::size_t acts);
  /// Whether this act (from 0) may begin. False: the others are behind, or not ready, see waits_ready(). To
  /// be called only while this controller has nothing on the wire.
  [[nodiscard]] bool may_begin(std::size_t act);
  /// All have ended the act before, but some have a status round on the wire: this controller is woken when
  /// they are ready, and sends nothing until then.
  [[nodiscard]] bool waits_ready() const;
  /// This controller has ended all of its acts.
  void finish() { finished_ = true; }
  [[nodiscard]] bool has_ended() const { return sync_->ended_; }

  void hold();
  /// All continue when the last one has called this.
  void go_on();
  [[nodiscard]] bool is_held() const;
  /// Held, and no controller is busy.
  [[nodiscard]] bool rests() const;

 private:
  [[nodiscard]] PieceSync::Member& me() { return sync_->members_[place_]; }

  std::shared_ptr<PieceSync> sync_;
  std::size_t place_;
  bool finished_ = false;
};

}  // namespace hw
