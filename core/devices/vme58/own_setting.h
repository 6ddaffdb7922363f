#pragma once
// A setting of each axis that waits in its queue like a motion, VL or AC: it is the user's, and a motion with
// a pace of its own borrows it.
#include <array>
#include <optional>
#include <string_view>

#include "core/devices/vme58/commands.h"
#include "core/devices/vme58/motions.h"
#include "core/devices/vme58/queues.h"

namespace hw::vme58 {

class OwnSetting {
 public:
  OwnSetting(std::string_view letters, AxisValue cell, Readings& readings, const Selection& selection,
             Commands& commands, Queues& queues, const Motions& motions, const Catalog& catalog,
             Snapshot& draft)
      : letters_(letters),
        cell_(cell),
        readings_(readings),
        selection_(selection),
        commands_(commands),
        queues_(queues),
        motions_(motions),
        catalog_(catalog),
        draft_(draft) {}

  /// As the user has it, also while a motion with a pace of its own has another there, or while it waits in a
  /// queue.
  [[nodiscard]] std::int64_t own(int axis) const;
  /// In turn it would be read once in a second or two, and a text may just have set it. One that may wait in
  /// a queue is believed until the queues are empty.
  Task<Result<>> read(int axis, Priority priority);
  Task<Result<>> borrow(int axis, std::int64_t value);
  Task<Result<>> give_back(int axis, Priority priority);
  /// Of all axes that no motion of ours moves.
  Task<Result<>> give_all_back(Priority priority);
  /// What comes behind a motion that is under way, in the same queue, goes at the axis' own. At its end
  /// that is given back once more: a stop may take this out of the queue. A move of several axes stands in
  /// the queue of AM, and what is put into theirs may come before it.
  Task<Result<>> give_back_behind_motions(Priority priority);

  /// Text has set it. What is set while it is borrowed is what is given back.
  void note(const TextCommand& command);
  /// Set-up has; `waits`: what the board shows is another one yet.
  void was_set(int axis, std::int64_t value);
  void was_put(int axis, std::int64_t value, bool waits);
  /// Its queue is emptied: what waits there is never carried out, nor is what was to be put back behind it.
  /// -1: all.
  void forget_put(int axis);
  [[nodiscard]] bool may_wait(int axis) const;
  void take_queues(unsigned all_free);
  /// Of this axis it has been read.
  void take(int axis);
  /// The wire is gone. What is borrowed is still owed.
  void wire_lost();
  /// The board was reset: it is as from the factory.
  void forget() { axes_ = {}; }

 private:
  /// A setting that is written for one motion, and put back behind it.
  struct Borrowed {
    std::int64_t before, for_now;
    bool left_alone = false;    ///< a lost window or an emptied queue came between: what is there is right,
                                ///< unless it is `for_now`
    bool waits_behind = false;  ///< `before` was put into the queue behind the motion already
  };
  /// One that text or set-up has put into a queue, where it may still wait.
  struct Put {
    std::int64_t value;
    bool carried_out = false;  ///< the queues were seen empty since: what is read next is right
  };
  struct Axis {
    std::optional<Borrowed> borrowed;
    std::optional<Put> put;
  };
  [[nodiscard]] Axis& at(int axis) { return axes_[static_cast<std::size_t>(axis)]; }
  [[nodiscard]] const Axis& at(int axis) const { return axes_[static_cast<std::size_t>(axis)]; }
  [[nodiscard]] int count() const { return static_cast<int>(catalog_.axes.size()); }
  [[nodiscard]] std::int64_t shown(int axis) const;

  const std::string_view letters_;
  const AxisValue cell_;  ///< where the data area shows it
  Readings& readings_;
  const Selection& selection_;
  Commands& commands_;
  Queues& queues_;
  const Motions& motions_;
  const Catalog& catalog_;
  Snapshot& draft_;
  std::array<Axis, most_axes> axes_{};
};

}  // namespace hw::vme58
