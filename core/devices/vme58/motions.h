#pragma once
// Works out from sent texts and readings the motion of each axis, its origin, and how it ended. Sends
// nothing.
#include <array>

#include "core/device/catalog.h"
#include "core/devices/vme58/limit_ends.h"
#include "core/devices/vme58/next_round.h"
#include "core/devices/vme58/readings.h"
#include "core/devices/vme58/selection.h"
#include "core/devices/vme58/servo_loops.h"

namespace hw::vme58 {

/// Effect of a motion to the home switch on arrival.
enum class AtHome : std::uint8_t { nothing, sets_counter, stops_dead };

class Motions {
 public:
  Motions(Wire& wire, const Catalog& catalog, const Readings& readings, const Selection& selection,
          LimitEnds& limits, ServoLoops& loops, NextRound& next, Snapshot& snapshot)
      : wire_(wire),
        catalog_(catalog),
        readings_(readings),
        selection_(selection),
        limits_(limits),
        loops_(loops),
        next_(next),
        snapshot_(snapshot) {}

  // ---- readings
  void show(int axis, Instant at);
  /// Shows an axis that does not turn, as last read.
  void show_still(int axis, Instant at);
  void take_done(unsigned axes);
  /// Whether an axis with a motion of the console stands, and its done flag was not seen yet.
  [[nodiscard]] bool waits_for_done() const;
  /// `has_room`: bit per empty queue, those of AA and AM after those of the axes.
  void take_queues(unsigned has_room, bool were_empty, bool empty);
  /// All queues are empty and no axis turns.
  void queues_emptied();
  /// The axis rests for no known reason: its queue must be read to see whether the motion has ended.
  [[nodiscard]] bool asks_queue(int axis) const { return at(axis).asks_queue; }

  // ---- motions of the console
  struct Way {
    unsigned axes = 0;
    Activity activity = Activity::moving;
    std::array<Steps, most_axes> targets{};
    bool has_targets = false;
    AtHome at_home = AtHome::nothing;
  };
  /// The state of an axis before a motion.
  struct Earlier {
    Activity wanted = Activity::idle;
    unsigned group = 0;
    bool ours = false, by_text = false;
  };
  using Before = std::array<Earlier, most_axes>;
  Before begin(const Way& way);
  void did_not_begin(const Way& way, const Before& before, bool may_begin);
  void end(int axis, EndedBy ended_by);
  [[nodiscard]] bool moving(int axis) const { return readings_.moving(axis); }
  [[nodiscard]] bool ours(int axis) const { return at(axis).ours; }
  /// The axis does not turn, and no motion of the console is under way.
  [[nodiscard]] bool at_rest(int axis) const { return !moving(axis) && !ours(axis); }
  /// The axis takes part in a move of several axes.
  [[nodiscard]] bool moves_in_group(int axis) const { return at(axis).group != 0; }
  /// Whether the axis jogs without end; a jog to the end of a travel counts as a move.
  [[nodiscard]] bool jogs(int axis) const {
    return at(axis).wanted == Activity::jogging && !snapshot_.axes[axis].has_target;
  }
  /// The counter is set, or may be, so its next change is no motion.
  void counts(int axis) { at(axis).counted = true; }
  void trust(int axis, Trust how);
  void begins_to_settle(int axis);
  /// -1: all.
  void stopping(int axis, bool at_once);
  void stands(int axis);
  /// A text or program has begun to move the axis after its jog, and that motion continues.
  void moved_by_others(int axis);

  // ---- motions of texts and programs
  void note(const TextCommand& command);
  /// Notes the axes named by lists of AA and AM; their GO may come much later.
  void note_group(const TextCommand& command);
  /// The queue of AA or AM may hold a command that moves the axis.
  [[nodiscard]] bool in_group(int axis) const { return at(axis).in_group; }
  void others_may_move_all();
  void program_begins();
  void program_ends();
  /// A switch has ended a motion of the program.
  [[nodiscard]] bool met_limit() const;
  void come_home();
  /// A queued command was rejected: it may have been the homing.
  void queued_was_rejected();

  // ---- for how long a motion may show nothing
  /// The time of a jog until its first count, and between two counts if it is slower than one count a second.
  [[nodiscard]] Duration jog_gap(int axis, double speed) const;
  /// A jog at `speed` is about to begin.
  void will_jog(int axis, double speed);
  void creeps(int axis, Duration gap);
  void met_switches(unsigned axes);

  /// KL stops the pulses, not the mass: a step motor stays in step only below the speed at which it can start
  /// without a ramp.
  void doubt_killed_position(int axis, double speed);
  /// Marks motions under way as lost: their ends are not seen.
  void lose(bool program_runs);
  void forget();

 private:
  struct Axis {
    Activity wanted = Activity::idle;     ///< activity begun by our last command
    EndedBy ended_by = EndedBy::nothing;  ///< why we ended it, if we did
    bool ours = false;                    ///< a motion of the console is under way
    unsigned group = 0;                   ///< the axes of its move, when there are several
    bool stopping = false;
    bool done = false;     ///< done flag seen since the motion began
    bool counted = false;  ///< the console has set its counter since the last round
    std::int8_t way = 0;   ///< direction of the latest change of position
    AtHome at_home = AtHome::nothing;
    bool by_text = false;  ///< a motion of the user's text or program may be under way
    bool in_group = false;
    bool listed = false;  ///< a list of AA or AM may have prepared a motion for their next GO
    bool asks_queue = false;
    Duration jog_gap{};      ///< time for which a jogging axis may turn without a visible count or speed
    Instant creeps_until{};  ///< counts as turning until then
    Instant still_since{};
  };
  [[nodiscard]] Axis& at(int axis) { return axes_[static_cast<std::size_t>(axis)]; }
  [[nodiscard]] const Axis& at(int axis) const { return axes_[static_cast<std::size_t>(axis)]; }
  [[nodiscard]] int count() const { return static_cast<int>(catalog_.axes.size()); }
  void note_of_axis(int axis, const TextCommand& command, bool one);
  void comes_home(int axis);
  [[nodiscard]] Duration rest_patience(int axis) const;

  Wire& wire_;
  const Catalog& catalog_;
  const Readings& readings_;
  const Selection& selection_;
  LimitEnds& limits_;
  ServoLoops& loops_;
  NextRound& next_;
  Snapshot& snapshot_;
  std::array<Axis, most_axes> axes_{};
};

}  // namespace hw::vme58
