#pragma once
// The motion of the board: counters, ramps, moves, homing, limits, contours, staircases, servo loops, slip,
// and what hangs on the axes. The firmware (text, queues, registers, flags) calls it and hears of what
// happens through events.
//
// Rules between the two:
//  - All positions, distances, speeds and rates are counts, counts/s, counts/s². User units are gone by then.
//  - The firmware checks operands and that an axis is fitted. What only the motion can know (a servo that is
//  switched
//    off, a target out of range once a relative distance is added, MV against its direction) it refuses:
//    `false`. The firmware then sets the command error bit and drops the command; nothing has changed.
//  - Commands from a queue come only when their axes are not occupied(), save those said to change a motion
//  on the fly.
//    Stops, FL, FP, LP and settings come at any time.
//  - Time: the firmware never goes beyond next_event() in one step, so every event is handled at its own
//  time, and
//    takes the events after each call that is not const.
//  - A value: copyable, no pointers to the firmware.
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
      false;  ///< to where the axis is when the move starts; LP shifts such a target along (decision M92)
};

/// MA MR MT ML as prepared, started by GO or GD. More than one axis: a straight line, the longest axis keeps
/// its VL and AC (decision M48).
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
    began,      ///< the axis leaves rest for a move of any kind (PA switches power on)
    rested,     ///< it has come to rest after a move of any kind (PA counts the settling time)
    limit_hit,  ///< a limit switch, `on`: the plus one, ended or ends its move. The motion ramps or cuts as
                ///< SL says; the firmware latches the limit bit and, unless SL is in force, empties the
                ///< queues that drive the axis
    slipped,    ///< the error went beyond ES. With TN the motion has stopped the axis and ended holding; the
                ///< firmware sets the slip flag and, with TN, empties the queues
    nearly_done,  ///< so many counts are left as notify_at() asked for
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
  /// `to` is not behind now() and not beyond next_event().
  void advance_to(Instant to);
  /// What has happened since the last call, oldest first, goes to the end of `sink`.
  void take_events(std::vector<MotionEvent>& sink);
  /// RS and power on: counters, settings and motions as from the factory. Loads and switches stay where they
  /// are.
  void reset();

  // Settings. After a change call changed(): gains, HN, HF, ET, HH take effect at once, speeds with the next
  // motion.
  [[nodiscard]] const AxisSettings& settings(int axis) const { return axes_[ix(axis)].settings; }
  AxisSettings& settings(int axis) { return axes_[ix(axis)].settings; }
  [[nodiscard]] const BoardSettings& board() const { return board_; }
  BoardSettings& board() { return board_; }
  /// HF on a moving servo axis ends its motion; ET and HN begin to watch the encoder.
  void changed(int axis);

  // Commands from the queues.
  bool start(const Move& move);
  /// Signed speed, endless; 0 ramps to rest. On an axis that jogs already: on the fly. Does not occupy the
  /// axis.
  bool jog(int axis, double velocity);
  bool home(int axis, const HomeOrder& order);
  /// RM: both counters become their remainders (decision M65). `divisor` is not 0.
  void remainder(int axis, std::int64_t divisor);
  /// MP, MM.
  void set_direction(int axis, Sign way);
  /// MV: runs to p at v and on from there; occupies the axis until p is passed. May come while the one before
  /// runs on.
  bool move_velocity(int axis, std::int64_t position, double velocity);
  /// SP: rest exactly at p, on the way there at the speed of MV or JG; where p lies behind, by a ramp to rest
  /// and back. May come while MV or JG runs on. Occupies the axis until it rests.
  bool stop_at(int axis, std::int64_t position);
  /// CX. `contour.complete` is true and CV was given.
  bool play(const Contour& contour);
  /// IN: a nearly_done event, once, when so many counts of the present move are left; without one: of the
  /// next.
  void notify_at(int axis, std::int64_t counts_left);

  // At once.
  void stop(int axis);                                   ///< ST SA SD: ramp to rest
  void kill(int axis);                                   ///< KL: no ramp
  void keep_velocity(int axis);                          ///< FL: present speed without end (decision M60)
  bool force_position(int axis, std::int64_t position);  ///< FP: as near as the ramp allows, no way back
  void load_position(int axis, std::int64_t position);   ///< LP: both counters, also while moving

  // What can be read, at now().
  [[nodiscard]] std::int64_t position(int axis) const;  ///< commanded
  [[nodiscard]] std::int64_t encoder(int axis) const;   ///< the command position where there is no encoder
  [[nodiscard]] double velocity(int axis) const;        ///< commanded, never negative
  [[nodiscard]] Sign direction(int axis) const;         ///< of the last motion
  [[nodiscard]] bool moving(int axis) const;  ///< commanded motion of any kind, a ramp down included
  /// The next queued command of this axis has to wait: a move, home search, contour or MV under way, or a
  /// ramp to rest after a stop, JG0 or a limit. Not while it jogs at speed or runs on after MV.
  [[nodiscard]] bool occupied(int axis) const;
  /// IP: the error lies within HD. Always true without an encoder.
  [[nodiscard]] bool in_position(int axis) const;
  [[nodiscard]] bool limit_active(int axis) const;  ///< either switch, whatever LF says
  [[nodiscard]] bool home_active(int axis) const;   ///< the switch alone, by HH and HL
  /// What HE asks for: switch, index and quadrant together.
  [[nodiscard]] bool encoder_home_active(int axis) const;

  // Hands on the bench. Axes are fitted.
  Result<> place(int axis, const AxisPlace& place);
  void operate_limit(int axis, Sign side, bool on);
  void operate_home(int axis, bool on);
  void jam(int axis, bool on);
  /// The load jumps by encoder counts; tracking follows it.
  void slip(int axis, std::int64_t counts);
  /// The encoder's count alone; the load stays where it is.
  void set_encoder(int axis, std::int64_t count);
  /// Where the counter has been since measure_from_here(), and the counts that were made.
  [[nodiscard]] const Span& span(int axis) const { return axes_[ix(axis)].span; }
  void measure_from_here();
  /// Loads, switches, jams.
  void look(BenchView& view) const;

  /// Of a servo axis with a motor: what stands at its output.
  [[nodiscard]] double output_volts(int axis) const { return axes_[ix(axis)].loop.volts(); }
  /// Of an axis whose loop is at work: command position and speed as the latest update has seen them, so that
  /// they and the encoder are of one moment. Else position() and velocity().
  [[nodiscard]] std::int64_t sampled_position(int axis) const;
  [[nodiscard]] double sampled_velocity(int axis) const;

 private:
  void tell(MotionEvent::What what, int axis, bool on = false) { events_.push_back({what, axis, on}); }

  // Runs (emulator_motion.cpp).
  void begin(RunKind kind, unsigned axes, Track track, const motion::Profile& profile, double wanted,
             std::shared_ptr<const Score> score = nullptr);
  /// The same run goes on by another profile from where it is.
  void continue_by(Run& run, const motion::Profile& profile);
  void bring_up_to_date();
  void apply(Run& run, std::int64_t step);
  void look(Run& run);
  void plan(Run& run);
  void plan_axis(Run& run, int axis);
  void mark(Run& run, int axis, int way, std::optional<std::int64_t> counts);
  /// `reached`: the profile has come to its end; `rests`: no further count comes; `cut`: nor anything behind.
  enum class End : std::uint8_t { reached, rests, cut };
  void finish(Run& run, End end);
  void rest(int axis);
  void replan(int axis);
  [[nodiscard]] std::optional<Instant> due(const Run& run) const;
  [[nodiscard]] const Run* run_of(int axis) const {
    return axes_[ix(axis)].run < 0 ? nullptr : &runs_[ix(axes_[ix(axis)].run)];
  }
  Run* run_of(int axis) { return const_cast<Run*>(std::as_const(*this).run_of(axis)); }
  [[nodiscard]] Run& free_run();
  bool met_limit(Run& run, int axis);
  void told_nearly_done(Run& run, int axis);
  [[nodiscard]] std::optional<std::int64_t> counts_left(const Run& run, int axis) const;

  // Moves (emulator_moves.cpp).
  [[nodiscard]] motion::Ramp ramp_of(int axis) const;
  [[nodiscard]] motion::Ramp ramp_of(const Run& run) const;
  void begin_endless(RunKind kind, int axis, Sign way, double speed);
  void go_to(int axis, const Return& goal);
  void turn_back(Run& run, int axis, const Return& goal);
  /// It ramps down, and nothing comes behind that.
  [[nodiscard]] bool ends(const Run& run, int axis) const;
  void stop_run(Run& run);
  void run_to(Run& run, int axis, std::int64_t counts, double speed);
  void leave(Run& run, int axis);
  void aim_again(Run& run, int axis);

  // Homing, contours (emulator_home.cpp, emulator_playing.cpp).
  bool found_home(Run& run, int axis);
  bool follow_cues(Run& run);

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
  std::optional<Instant> update_at_;  ///< next update of the servo loops, while one of them is awake
};

}  // namespace hw::vme58
