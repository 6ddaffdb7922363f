#pragma once
// The motion of the board: counters, ramps, moves, homing, limits, contours, staircases, servo loops, slip,
// and the loads of the axes. The firmware (text, queues, registers, flags) calls it and receives events.
//
// Rules between firmware and motion:
// - All positions, distances, speeds and rates are counts, counts/s, counts/s². User units are already
// converted.
// - The firmware checks operands and that an axis is fitted. The motion returns `false` for errors that only
// it can know (a servo that is switched off, a target out of range once a relative distance is added, MV
// against its direction). Nothing has changed then; the firmware sets the command error bit and drops the
// command.
// - Commands from a queue come only while their axes are not occupied(), except those documented to change a
// motion on the fly. Stops, FL, FP, LP and settings come at any time.
// - Time: the firmware never advances beyond next_event() in one step, so every event is handled at its own
// time. It takes the events after each non-const call.
// - Motion is a value: copyable, without pointers to the firmware.
#include <array>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "core/base/result.h"
#include "core/base/units.h"
#include "core/device/bench.h"
#include "core/devices/vme58/emulator_axis.h"
#include "core/devices/vme58/emulator_contour.h"
#include "core/devices/vme58/emulator_run.h"
#include "core/devices/vme58/facts.h"
#include "core/time/clock.h"

namespace hw::vme58 {

struct AxisGoal {
  std::int64_t counts = 0;
  bool relative =
      false;  ///< to the position at the start of the move; LP shifts such a target (decision M92)
};

/// A move prepared by MA MR MT ML and started by GO or GD. Several axes move on a straight line; the longest
/// axis keeps its VL and AC (decision M48).
struct Move {
  std::array<std::optional<AxisGoal>, most_axes> goal{};
  [[nodiscard]] unsigned axes() const {
    unsigned all = 0;
    for (int a = 0; a < most_axes; ++a)
      if (goal[static_cast<std::size_t>(a)]) all |= 1u << a;
    return all;
  }
};

struct MotionEvent {
  enum class What : std::uint8_t {
    began,      ///< the axis leaves rest for any move (PA switches power on)
    rested,     ///< the axis rests after any move (PA counts the settling time)
    limit_hit,  ///< a limit switch, `on`: the plus one, ended or ends its move. The motion ramps or cuts as
                ///< SL says; the firmware latches the limit bit and, unless SL is in force, empties the
                ///< queues that drive the axis
    slipped,    ///< the error went beyond ES. With TN the motion has stopped the axis and ended holding; the
                ///< firmware sets the slip flag and, with TN, empties the queues
    nearly_done,  ///< the counts left have come down to those of notify_at()
    output,       ///< an auxiliary output inside a contour: `on` = high (the transistor is off)
    ready,        ///< something that a queue may wait for has changed (occupied, in_position): look again
  };
  What what;
  int axis = 0;
  bool on = false;
};

class Motion {
 public:
  explicit Motion(const Variant& variant);

  // Time.
  [[nodiscard]] Instant now() const { return now_; }
  [[nodiscard]] std::optional<Instant> next_event() const;
  /// `to` must not be before now() or after next_event().
  void advance_to(Instant to);
  /// Appends the events since the last call to `sink`, oldest first.
  void take_events(std::vector<MotionEvent>& sink);
  /// RS and power-on: counters, settings and motions return to factory state. Loads and switches stay as they
  /// are.
  void reset();

  // Settings. Call changed() after a change: gains, HN, HF, ET, HH take effect at once, speeds with the next
  // motion.
  [[nodiscard]] const AxisSettings& settings(int axis) const { return axes_[ix(axis)].settings; }
  AxisSettings& settings(int axis) { return axes_[ix(axis)].settings; }
  [[nodiscard]] const BoardSettings& board() const { return board_; }
  BoardSettings& board() { return board_; }
  /// HF on a moving servo axis ends its motion; ET and HN start watching the encoder.
  void changed(int axis);

  // Commands from the queues.
  bool start(const Move& move);
  /// Jogs endlessly at a signed speed; 0 ramps to rest. Changes a jog under way on the fly. Does not occupy
  /// the axis.
  bool jog(int axis, double velocity);
  bool home(int axis, const HomeOrder& order);
  /// RM: both counters become their remainders (decision M65). `divisor` is not 0.
  void remainder(int axis, std::int64_t divisor);
  /// MP, MM.
  void set_direction(int axis, Sign way);
  /// MV: runs to `position` at `velocity` and continues from there; occupies the axis until `position` is
  /// passed. May follow while the previous MV runs on.
  bool move_velocity(int axis, std::int64_t position, double velocity);
  /// SP: comes to rest exactly at `position`, running at the speed of MV or JG; if it lies behind, ramps to
  /// rest and goes back. May follow while MV or JG runs on. Occupies the axis until it rests.
  bool stop_at(int axis, std::int64_t position);
  /// CX. Requires `contour.complete` and a CV.
  bool play(const Contour& contour);
  /// IN: raises nearly_done once, when `counts_left` counts of the present move remain; without a move, of
  /// the next.
  void notify_at(int axis, std::int64_t counts_left);

  // At once.
  void stop(int axis);           ///< ST SA SD: ramps to rest
  void kill(int axis);           ///< KL: no ramp
  void keep_velocity(int axis);  ///< FL: continues at the present speed (decision M60)
  bool force_position(int axis, std::int64_t position);  ///< FP: as near as the ramp allows, no way back
  void load_position(int axis, std::int64_t position);   ///< LP: both counters, also while moving

  // Readings, at now().
  [[nodiscard]] std::int64_t position(int axis) const;  ///< commanded
  [[nodiscard]] std::int64_t encoder(int axis) const;   ///< without an encoder, the command position
  [[nodiscard]] double velocity(int axis) const;        ///< commanded, never negative
  [[nodiscard]] Sign direction(int axis) const;         ///< of the last motion
  [[nodiscard]] bool moving(int axis) const;            ///< any commanded motion, ramps down included
  /// The next queued command of this axis must wait: a move, home search, contour or MV is under way, or a
  /// ramp to rest after a stop, JG0 or a limit. False while the axis jogs at speed or runs on after MV.
  [[nodiscard]] bool occupied(int axis) const;
  /// IP: the error is within HD. Always true without an encoder.
  [[nodiscard]] bool in_position(int axis) const;
  [[nodiscard]] bool limit_active(int axis) const;  ///< either switch, whatever LF says
  [[nodiscard]] bool home_active(int axis) const;   ///< the switch alone, by HH and HL
  /// The condition of HE: switch, index and quadrant together.
  [[nodiscard]] bool encoder_home_active(int axis) const;

  // Actions on the bench. The axes must be fitted.
  Result<> place(int axis, const AxisPlace& place);
  void operate_limit(int axis, Sign side, bool on);
  void operate_home(int axis, bool on);
  void jam(int axis, bool on);
  /// Shifts the load by encoder counts; tracking follows.
  void slip(int axis, std::int64_t counts);
  /// Sets only the encoder count; the load stays where it is.
  void set_encoder(int axis, std::int64_t count);
  /// Counters, load and motor; its span since measure_from_here().
  [[nodiscard]] const MotionAxis& axis(int axis) const { return axes_[ix(axis)]; }
  void measure_from_here();
  /// Loads, switches, jams.
  void look(BenchView& view) const;

  /// Command position and speed at the latest update of the loop, so that they match the encoder in time.
  /// Without a working loop: position() and velocity().
  [[nodiscard]] std::int64_t sampled_position(int axis) const;
  [[nodiscard]] double sampled_velocity(int axis) const;

 private:
  void note_event(MotionEvent::What what, int axis, bool on = false) { events_.push_back({what, axis, on}); }

  // Runs (emulator_motion.cpp).
  void begin(RunKind kind, unsigned axes, Track track, const motion::Profile& profile, double wanted,
             std::shared_ptr<const ContourPlan> contour_plan = nullptr);
  /// Continues the run from where it is with another profile.
  void continue_by(Run& run, const motion::Profile& profile);
  void bring_up_to_date();
  void apply(Run& run, std::int64_t step);
  void look(Run& run);
  void plan(Run& run);
  void plan_axis(Run& run, int axis);
  /// `reached`: the profile has ended; `rests`: no further count comes; `cut`: nor does anything planned
  /// behind it.
  enum class End : std::uint8_t { reached, rests, cut };
  void finish(Run& run, End end);
  void rest(int axis);
  void replan(int axis);
  [[nodiscard]] const Run* run_of(int axis) const {
    return axes_[ix(axis)].run < 0 ? nullptr : &runs_[ix(axes_[ix(axis)].run)];
  }
  Run* run_of(int axis) { return const_cast<Run*>(std::as_const(*this).run_of(axis)); }
  [[nodiscard]] Run& free_run();
  bool met_limit(Run& run, int axis);
  void report_nearly_done(Run& run, int axis);
  [[nodiscard]] std::optional<std::int64_t> counts_left(const Run& run, int axis) const;

  // Moves (emulator_moves.cpp).
  [[nodiscard]] motion::Ramp ramp_of(int axis) const;
  [[nodiscard]] motion::Ramp ramp_of(const Run& run) const;
  void begin_endless(RunKind kind, int axis, Sign way, double speed);
  void go_to(int axis, const Return& goal);
  void turn_back(Run& run, int axis, const Return& goal);
  /// The run ramps down, and nothing follows.
  [[nodiscard]] bool ends(const Run& run, int axis) const;
  void stop_run(Run& run);
  void run_to(Run& run, int axis, std::int64_t counts, double speed);
  void leave(Run& run, int axis);
  void aim_again(Run& run, int axis);

  // Homing, contours (emulator_home.cpp, emulator_playing.cpp).
  bool found_home(Run& run, int axis);
  bool follow_events(Run& run);

  // Servo loops, holding, slip, tracking (emulator_servo.cpp, emulator_hold.cpp).
  [[nodiscard]] bool at_work(int axis) const;
  void update_servos();
  void update_servo(int axis);
  void schedule_updates();
  [[nodiscard]] double exact_command(int axis) const;
  void switch_servo(int axis);
  void watch_error(int axis);
  void slipped(int axis);
  void schedule_correction(int axis);
  void correct(int axis);
  void track(int axis, std::int64_t counts);

  Instant now_{};
  std::array<MotionAxis, most_axes> axes_;
  std::array<Run, most_axes> runs_;
  BoardSettings board_;
  std::vector<MotionEvent> events_;
  std::optional<Instant> update_at_;  ///< next update of the servo loops; none while all rest
};

}  // namespace hw::vme58
