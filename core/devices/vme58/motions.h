#pragma once
// What is under way on each axis, who began it, and how it ends: worked out of what was sent and what is
// read. Sends nothing.
#include <array>

#include "core/device/catalog.h"
#include "core/devices/vme58/limit_ends.h"
#include "core/devices/vme58/next_round.h"
#include "core/devices/vme58/readings.h"
#include "core/devices/vme58/selection.h"
#include "core/devices/vme58/servo_loops.h"

namespace hw::vme58 {

/// What a motion to the home switch does there.
enum class AtHome : std::uint8_t { nothing, sets_counter, stops_dead };

class Motions {
 public:
  Motions(Wire& wire, const Catalog& catalog, const Readings& readings, const Selection& selection,
          LimitEnds& limits, ServoLoops& loops, NextRound& next, Snapshot& draft)
      : wire_(wire),
        catalog_(catalog),
        readings_(readings),
        selection_(selection),
        limits_(limits),
        loops_(loops),
        next_(next),
        draft_(draft) {}

  // ---- what is read
  void show(int axis, Instant at);
  /// As last read, where nothing turns.
  void show_still(int axis, Instant at);
  void take_done(unsigned axes);
  /// Some done flag is set, and an axis of ours stands.
  [[nodiscard]] bool waits_for_done() const;
  /// `has_room`: bit per queue that is all empty, those of AA and AM behind those of the axes.
  void take_queues(unsigned has_room, bool were_empty, bool empty);
  /// All queues are empty and no axis turns.
  void all_worked_off();
  /// It rests without a reason: its queue tells whether it has ended.
  [[nodiscard]] bool asks_queue(int axis) const { return at(axis).asks_queue; }

  // ---- the console's own
  struct Way {
    unsigned axes = 0;
    Activity activity = Activity::moving;
    std::array<Steps, most_axes> targets{};
    bool has_targets = false;
    AtHome at_home = AtHome::nothing;
  };
  /// What an axis did before.
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
  /// Nothing of ours is under way, and nothing turns.
  [[nodiscard]] bool at_rest(int axis) const { return !moving(axis) && !ours(axis); }
  /// Several axes move as one.
  [[nodiscard]] bool in_company(int axis) const { return at(axis).group != 0; }
  /// A jog without an end of its own; one that is sent to the end of a travel is a move.
  [[nodiscard]] bool jogs(int axis) const {
    return at(axis).wanted == Activity::jogging && !draft_.axes[axis].has_target;
  }
  /// Its counter is set, or may be: what changes then is no motion.
  void counts(int axis) { at(axis).counted = true; }
  void trust(int axis, Trust how);
  void begins_to_settle(int axis);
  /// -1: all.
  void stopping(int axis, bool at_once);
  void stands(int axis);
  /// A text or a program has begun to move it behind its jog, and that goes on.
  void is_anothers(int axis);

  // ---- what others begin
  void note(const TextCommand& command);
  /// Lists of AA and AM name the axes that they move, and a GO may come long behind its list.
  void note_group(const TextCommand& command);
  /// In the queue of AA or AM something may wait that moves it.
  [[nodiscard]] bool in_group(int axis) const { return at(axis).in_group; }
  void others_may_move_all();
  void program_begins();
  void program_ends();
  /// A switch has ended some motion of it.
  [[nodiscard]] bool met_limit() const;
  void come_home();
  /// What waited in a queue was rejected: it may have been the homing.
  void queued_was_rejected();

  // ---- for how long a motion may show nothing
  /// A jog's: until its first count, and between two counts when it is slower than one a second.
  [[nodiscard]] Duration jog_gap(int axis, double speed) const;
  /// A jog with that speed is about to begin.
  void will_jog(int axis, double speed);
  void creeps(int axis, Duration gap);
  void met_switches(unsigned axes);

  /// Its pulses end with KL, not its mass: a step motor stays in step only up to the speed at which it may
  /// start without a ramp too.
  void doubt_killed_position(int axis, double speed);
  /// Nobody has seen how it ended, or it will not.
  void lose(bool program_runs);
  void forget();

 private:
  struct Axis {
    Activity wanted = Activity::idle;     ///< what our last command began
    EndedBy ended_by = EndedBy::nothing;  ///< why we ended it, if we did
    bool ours = false;                    ///< a motion of the console is under way
    unsigned group = 0;                   ///< the axes of its move, when there are several
    bool stopping = false;
    bool done = false;     ///< its done flag was seen since the motion began
    bool counted = false;  ///< the console has set its counter since the last round
    std::int8_t way = 0;   ///< direction of the latest change of position
    AtHome at_home = AtHome::nothing;
    bool by_text = false;  ///< a motion of the user's text or program may be under way
    bool in_group = false;
    bool listed = false;  ///< a list of AA or AM may have prepared a motion that their next GO begins
    bool asks_queue = false;
    Duration jog_gap{};      ///< of a jog: it turns, though so long no count and no velocity may show it
    Instant creeps_until{};  ///< and so it is taken to turn until then
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
  Snapshot& draft_;
  std::array<Axis, most_axes> axes_{};
};

}  // namespace hw::vme58
