#pragma once
// The motion of each axis: motions that the console has begun and stopped, the status words and StepNLoop
// states, and the conclusions from both.
#include <array>
#include <cstdint>
#include <vector>

#include "core/device/home_proof.h"
#include "core/devices/arcus/restart_watch.h"

namespace hw::arcus {

class Motions {
 public:
  Motions(const Console& console, const SetUp& setup) : console_(console), setup_(setup) {}

  // ---- commands of the console
  void begun(int axis, Activity activity, Instant at);
  /// One command moves all these axes.
  void begun_together(const std::vector<int>& axes, Activity activity);
  /// The motion just begun ends at `target`; speed 0: the axis's own.
  void goes_to(int axis, Steps target, Pps speed);
  /// The home search just begun goes to this side; speed 0: the axis's own.
  void searches(int axis, Sign side, Pps speed);
  /// The target was changed during the motion.
  void goes_elsewhere(int axis, Steps target);
  /// Another motion of that axis begins: the console's own has ended.
  void another_begins(int axis);
  /// Marks the axis as being stopped, if it moves; -1: all axes.
  void stopping(int axis, bool at_once);
  /// Axes that move together end together.
  void ended_by_us(int axis, EndedBy why);
  /// The stop is over: the axis is shown as it is; -1: all axes.
  void stands(int axis);

  // ---- readings
  void status_is(int axis, std::int64_t word) { tracked_[static_cast<std::size_t>(axis)].status = word; }
  /// The position of the axis has changed by `way`.
  void turned(int axis, Steps way);
  /// The position and speed of the axis were read.
  void seen(int axis);
  void loop_is(int axis, std::int64_t state);
  /// False: a newer reply is already known.
  bool take_loop(int axis, std::int64_t state, Instant asked_at);
  void loops_are_unknown();
  /// The state of the loop is unknown, unless the loop is off.
  void loop_is_unknown(int axis);
  /// Shows the axis by replies to questions asked at `asked_at` or later.
  void show(int axis, Instant asked_at);
  /// `moved`: a bit for each axis that was moving.
  void restarted(unsigned moved);
  void wire_lost();

  // ---- conclusions
  [[nodiscard]] bool runs(int axis) const;  ///< as last read, even if another state is shown
  [[nodiscard]] bool reports_motion(int axis) const;
  [[nodiscard]] bool loop_is_off(int axis) const;
  [[nodiscard]] AxisError error_of(int axis) const;
  [[nodiscard]] RestartWatch::AxisNow now(int axis) const;

 private:
  /// Facts about an axis beyond the snapshot.
  struct AxisTracking {
    Activity wanted = Activity::idle;     ///< what our last command began
    EndedBy ended_by = EndedBy::nothing;  ///< why we ended it, if we did
    std::int64_t status = 0;
    int loop_state = -1;       ///< -1: not read yet
    Instant loop_asked_at{};   ///< when it was asked for
    bool ours = false;         ///< a motion of the console is under way
    bool stopping = false;     ///< a stop was sent
    bool was_stopped = false;  ///< a stop of ours was for the motion that our last command began
    unsigned with = 0;         ///< a bit for each axis of the same motion
    std::int8_t turned = 0;    ///< direction of the latest change of position
    bool turned_back = false;  ///< it differs from the one before
    Instant begun_at{};        ///< when our last command was sent
    Pps top_speed{};           ///< of the motion that it began; 0: not known
    Instant at_rest_at{};      ///< when it was last read at rest before that command; none: it moved
    Steps at_rest{};           ///< where
    HomeProof home;            ///< of a home search
  };
  void show_ended(int axis);
  void doubt_killed_position(int axis);
  [[nodiscard]] EndedBy how_it_ended(int axis) const;
  [[nodiscard]] bool was_cut_short(int axis) const;
  [[nodiscard]] bool misses_its_target(int axis) const;
  [[nodiscard]] std::int64_t loop_tolerance(int axis) const;
  [[nodiscard]] bool loop_error(int axis) const;
  [[nodiscard]] Pps fastest_way_to_zero(int axis) const;
  [[nodiscard]] bool leaves_zero(int axis) const;

  const Console& console_;
  const SetUp& setup_;
  std::array<AxisTracking, max_axes> tracked_{};
};

}  // namespace hw::arcus
