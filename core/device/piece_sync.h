#pragma once
// Controllers on one wire that do their pieces together: an act begins when all have ended the one before and
// none of them has a round of status on the wire, so that their commands follow each other without a question
// between them. A hold holds all, and what ends for one ends for all. Io thread only, but for the destructor.
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
    std::optional<std::size_t> done;  ///< acts, all pieces counted through; none: it does not take part yet
    bool held = false;
    bool ready = false;  ///< for the next act: it asks nothing until all are
    Event* wake = nullptr;
  };
  void wake_all() const;
  [[nodiscard]] bool all_have_done(std::size_t acts) const;
  void none_is_ready();

  std::vector<Member> members_;
  std::size_t begun_ = 0;  ///< acts, by whoever was first
  std::atomic<bool> ended_ = false;
};

/// The place of one of them. Left or dropped before finish(), it ends all: whether its intent was refused, a
/// stop came before it, or its run has ended early.
class PieceSeat {
 public:
  PieceSeat(std::shared_ptr<PieceSync> sync, std::size_t place) : sync_(std::move(sync)), place_(place) {}
  ~PieceSeat();
  PieceSeat(const PieceSeat&) = delete;
  PieceSeat& operator=(const PieceSeat&) = delete;

  /// `wake` is notified when others have come so far that there may be something to do.
  void take(Event& wake) { me().wake = &wake; }
  void leave();
  /// So many acts have ended here.
  void has_done(std::size_t acts);
  /// It is the turn of that act, counted from 0. False: others are not as far, or not ready, see
  /// waits_ready(). Asked only while this one has nothing on the wire.
  [[nodiscard]] bool may_begin(std::size_t act);
  /// All have done what comes before, and some of the others have a round on the wire: this one is woken when
  /// they have ended it, and asks nothing until then.
  [[nodiscard]] bool waits_ready() const;
  /// All of it has ended here.
  void finish() { finished_ = true; }
  [[nodiscard]] bool has_ended() const { return sync_->ended_; }

  void hold();
  /// The last one that says so lets all go on.
  void go_on();
  [[nodiscard]] bool is_held() const;
  /// Held, and nobody is at anything.
  [[nodiscard]] bool rests() const;

 private:
  [[nodiscard]] PieceSync::Member& me() { return sync_->members_[place_]; }

  std::shared_ptr<PieceSync> sync_;
  std::size_t place_;
  bool finished_ = false;
};

}  // namespace hw
