#pragma once
// A setting of each axis that waits in its queue like a motion: VL or AC. The value is the user's. A motion
// with a pace of its own borrows the setting.
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
             Snapshot& snapshot)
      : letters_(letters),
        cell_(cell),
        readings_(readings),
        selection_(selection),
        commands_(commands),
        queues_(queues),
        motions_(motions),
        catalog_(catalog),
        snapshot_(snapshot) {}

  /// The user's value, even while a motion with a pace of its own has borrowed the setting or the value waits
  /// in a queue.
  [[nodiscard]] std::int64_t own(int axis) const;
  /// Reads the setting now: the turn of the axis comes only every second or two, and a text may just have set
  /// it. A value that may wait in a queue is trusted until the queues are empty.
  Task<Result<>> read(int axis, Priority priority);
  Task<Result<>> borrow(int axis, std::int64_t value);
  Task<Result<>> give_back(int axis, Priority priority);
  /// Gives back the settings of all axes without a motion of the console.
  Task<Result<>> give_all_back(Priority priority);
  /// Queues the user's value behind a motion under way, for the commands that follow in the same queue. It is
  /// given back again at the end of the motion, as a stop may empty the queue. Moves of several axes are left
  /// out: they wait in the queue of AM, and the value in the axis' own queue may overtake them.
  Task<Result<>> give_back_behind_motions(Priority priority);

  /// A text has set the setting. A value set while it is borrowed is the one given back.
  void note(const TextCommand& command);
  /// The set-up has set the value; `waits`: the board still shows another one.
  void was_set(int axis, std::int64_t value);
  void was_put(int axis, std::int64_t value, bool waits);
  /// The queue of the axis is emptied: neither values waiting there nor those to be given back behind a
  /// motion are carried out. -1: all axes.
  void forget_put(int axis);
  [[nodiscard]] bool may_wait(int axis) const;
  void take_queues(unsigned all_free);
  /// The setting of this axis has been read.
  void take(int axis);
  /// The wire is lost. Borrowed settings must still be given back.
  void wire_lost();
  /// The board was reset: the setting has its factory value.
  void forget() { axes_ = {}; }

 private:
  /// A setting changed for one motion and given back after it.
  struct Borrowed {
    std::int64_t before, for_now;
    bool left_alone = false;  ///< the window was lost or the queue emptied since: the present value is right,
                              ///< unless it is `for_now`
    bool waits_behind = false;  ///< `before` is already queued behind the motion
  };
  /// A value that text or set-up has put into a queue, where it may still wait.
  struct Put {
    std::int64_t value;
    bool carried_out = false;  ///< the queues were seen empty since: the next reading is right
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
  Snapshot& snapshot_;
  std::array<Axis, most_axes> axes_{};
};

}  // namespace hw::vme58
