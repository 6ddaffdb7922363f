#pragma once
// The firmware of an Arcus controller in miniature: axes, motions, StepNLoop, inputs and outputs, settings
// and flash. It has no wire: commands, programs and the bench call it. Time comes from outside; pulses are
// counted from closed forms, so nothing ticks.
#include <array>
#include <cstdint>
#include <deque>
#include <optional>
#include <string>
#include <vector>

#include "core/base/index.h"
#include "core/device/bench.h"
#include "core/devices/arcus/emulator_axis.h"
#include "core/devices/arcus/emulator_controller_parts.h"
#include "core/devices/arcus/emulator_settings.h"
#include "core/devices/arcus/emulator_speeds.h"
#include "core/devices/arcus/facts.h"
#include "core/devices/arcus/language/vm.h"
#include "core/motion/course.h"
#include "core/motion/path.h"

namespace hw::arcus {

enum class MotionKind : std::uint8_t { target, jog, homing, correction, interpolated, buffered, joystick };

/// A motion of one or more axes.
struct Motion : motion::Course<motion::Path> {
  MotionKind kind = MotionKind::target;
  bool by_hand = false;  ///< STOP or ABORT: the resting place becomes the target
  SpeedOrder order;      ///< as it began, or as SSPD left it (decision AMB-047)
};

using Targets = std::array<std::optional<std::int64_t>, most_axes>;

/// A queued move of the PMX: `I1000:2000:3000:250`.
struct Segment {
  std::array<std::int64_t, 3> to{};
  std::int64_t speed = 1;
};

struct MoveBuffer {
  bool on = false;
  std::deque<Segment> queue;  ///< the running one first
  int start = 0, end = 0;     ///< ring indexes of the running and of the newest one
  bool used = false;          ///< a place has been taken since BO
  bool running = false;
};

/// Non-volatile memory.
struct Flash {
  explicit Flash(const Model& model) : settings(model) {}
  Settings settings;
  std::array<std::int32_t, variables> values{};  ///< only the upper half is used
  std::vector<std::string> program = std::vector<std::string>(program_lines);
  std::uint64_t stores = 0;
};

class Controller {
 public:
  explicit Controller(const Model& model);

  // Time.
  [[nodiscard]] Instant now() const { return now_; }
  [[nodiscard]] std::optional<Instant> next_event() const;
  /// Advances to `now`, which must not be later than next_event(), and does what is due.
  void advance(Instant now);

  // Power and flash (emulator_memory.cpp).
  void power_up();
  void power_down();
  [[nodiscard]] bool powered() const { return powered_; }
  void store();
  [[nodiscard]] std::string saved_text() const;
  /// The error in the line, as a sentence; empty: none.
  std::string load_line(std::string_view line);
  Flash& flash() { return flash_; }
  [[nodiscard]] const Flash& flash() const { return flash_; }
  [[nodiscard]] int address() const { return host_settings_.address; }
  [[nodiscard]] int rate() const { return host_settings_.rate; }
  [[nodiscard]] bool prefixes_replies() const { return host_settings_.prefixes_replies; }
  [[nodiscard]] bool announces_arrivals() const { return host_settings_.announces_arrivals; }

  // Settings (emulator_registers.cpp).
  [[nodiscard]] const Model& model() const { return *model_; }
  [[nodiscard]] const Settings& settings() const { return settings_; }
  [[nodiscard]] std::int64_t read_setting(Setting id, int which) const;  ///< as a reply shows it
  Refusal write_setting(Setting id, std::int64_t value, int which);
  [[nodiscard]] std::int32_t variable(int n) const { return vm_.variable(n); }
  void set_variable(int n, std::int32_t v) { vm_.set_variable(n, v); }
  [[nodiscard]] bool incremental() const { return incremental_; }
  void set_incremental(bool on) { incremental_ = on; }
  [[nodiscard]] std::int64_t timer_ms() const;
  void set_timer(std::int64_t ms);
  /// Call after a command for this unit was answered.
  void command_answered(bool timeout_was_shown);
  [[nodiscard]] bool timed_out() const { return timeout_.fired(); }

  // Moves (emulator_moves.cpp, emulator_homing.cpp, emulator_motion.cpp).
  Refusal move(const Targets& targets);
  Refusal jog(int axis, Sign way);
  Refusal arc(std::int64_t centre_x, std::int64_t centre_y, bool clockwise,
              std::optional<std::pair<std::int64_t, std::int64_t>> end_and_sweep);
  Refusal change_target(int axis, std::int64_t target);
  Refusal change_speed(int axis, std::int64_t speed);
  Refusal home(int axis, HomeMode mode, Sign way);
  void stop(int axis);
  void stop_all();
  void abort(int axis);
  void abort_all();
  void clear_errors(int axis);
  void clear_loop_error(int axis);
  /// Why these axes would refuse a motion; none: they would not.
  [[nodiscard]] Refusal refuses_motion(unsigned axes) const;

  // Buffered moves (emulator_buffer.cpp).
  Refusal buffer_on();
  void buffer_off();
  Refusal buffer_move(const Segment& segment);
  [[nodiscard]] const MoveBuffer& buffer() const { return buffer_; }
  [[nodiscard]] int buffer_free() const;

  // Readings.
  [[nodiscard]] std::int64_t status(int axis) const;
  [[nodiscard]] std::int64_t position(int axis) const;
  [[nodiscard]] std::int64_t encoder(int axis) const { return wrap_position(axes_[ix(axis)].encoder()); }
  [[nodiscard]] std::int64_t speed(int axis) const;
  [[nodiscard]] std::int64_t loop_delta(int axis) const;
  [[nodiscard]] LoopState loop_state(int axis) const;
  [[nodiscard]] std::int64_t current_ma() const;
  [[nodiscard]] bool moving(int axis) const { return axes_[ix(axis)].slot >= 0; }
  [[nodiscard]] Duration ramp_to_rest(int axis) const;
  /// A bit for each axis of its last motion, itself included.
  [[nodiscard]] unsigned moved_with(int axis) const { return axes_[ix(axis)].moved_with; }
  /// Limit, alarm or StepNLoop error latched.
  [[nodiscard]] bool in_error(int axis) const;
  /// With StepNLoop the pulses of an encoder count, else 1.
  [[nodiscard]] double pulses_per_unit(int axis) const { return ratio(axis); }
  Refusal set_position(int axis, std::int64_t value);
  Refusal set_encoder(int axis, std::int64_t value);

  // Programs (emulator_programs.cpp).
  [[nodiscard]] const std::string& program_line(int line) const { return flash_.program[ix(line)]; }
  Refusal set_program_line(int line, std::string_view text);
  void control_program(int program, int what);
  Refusal call_subroutine(int number);
  [[nodiscard]] int program_state(int program) const;
  [[nodiscard]] int program_place(int program) const;
  [[nodiscard]] bool error_returns_to_start() const;
  [[nodiscard]] const language::Vm& vm() const { return vm_; }

  // Inputs and outputs (emulator_signals.cpp).
  [[nodiscard]] std::int64_t inputs() const;
  [[nodiscard]] std::int64_t outputs() const;
  void set_outputs(std::int64_t value);
  void set_output(int number, bool on);
  [[nodiscard]] std::int64_t enables() const { return terminals_.enables; }
  void set_enables(std::int64_t value);
  void set_enable(int number, bool on);
  [[nodiscard]] std::int64_t analog(int number) const {
    return terminals_.analog[static_cast<std::size_t>(number - 1)];
  }
  void arm_latch(int axis, bool on);
  [[nodiscard]] const Latch& latch(int axis) const { return axes_[ix(axis)].latch; }
  void sync_on(int axis);
  void sync_off(int axis);
  [[nodiscard]] int sync_state(int axis) const { return axes_[ix(axis)].sync.state; }

  // Hands.
  void operate_input(int number, bool active);
  void operate_analog(int number, std::int32_t millivolts);
  void operate_alarm(int axis, bool on);
  void jam(int axis, bool on);
  /// The bench of decision AMB-093: a load stands still while its motor has no power.
  void load_needs_power();
  /// Call after a switch, the load or the place of an axis was changed.
  void bench_changed(int axis);
  Axis& axis(int n) { return axes_[ix(n)]; }
  [[nodiscard]] const Axis& axis(int n) const { return axes_[ix(n)]; }
  [[nodiscard]] int axes() const { return model_->axes(); }
  [[nodiscard]] std::uint32_t inputs_operated() const { return terminals_.inputs; }
  /// Levels at the terminals: outputs, then enables.
  [[nodiscard]] std::uint32_t output_levels() const;
  /// In Position and Alarm are shown by outputs (EDO=1 and StepNLoop on).
  [[nodiscard]] bool loop_has_outputs() const { return settings_.on(Setting::status_outputs) && closed(0); }

  std::vector<TriggerPulse> trigger_pulses;  ///< of sync outputs, oldest first
  std::vector<int> arrivals;                 ///< axes at their target (AR); the reader removes them
  /// An event for a rehearsal; recorded while `trace` is not null.
  struct Trace {
    Instant at;
    std::string what;
    int line;             ///< of the stored program that caused it; -1: none
    unsigned axes = 0;    ///< started by it, or run into a switch: a bit for each
    int limit = 0;        ///< limit switch hit, -1 or +1; 0: none
    bool reads = false;   ///< a statement read an input
    std::string io = {};  ///< the output switched or the input read ...
    int level = 0;        ///< ... and its level from then on
  };
  std::vector<Trace>* trace = nullptr;
  /// While there is a trace: counter positions before each write, with their axis.
  std::vector<std::pair<int, std::int64_t>> overwritten;
  int moves_begun = 0;
  /// A host talks to it all the time: it never times out.
  bool host_talks = false;
  /// Recorded while there is a trace.
  void note_read(const std::string& input, int value);

 private:
  void note_event(std::string what, unsigned axes = 0, int limit = 0);
  void counter_is_written(int axis) {
    if (trace != nullptr) overwritten.emplace_back(axis, position(axis));
  }
  [[nodiscard]] std::string letter(int axis) const { return std::string(1, model_->axis_letters[ix(axis)]); }

  // Motions (emulator_motion.cpp).
  void begin(MotionKind kind, unsigned axes, const motion::Path& path, const motion::Profile& profile,
             const SpeedOrder& order);
  /// Continues the same motion by another profile from its present place.
  void continue_by(Motion& m, const motion::Profile& profile);
  void bring_up_to_date();
  void apply(Motion& m, std::int64_t step);
  void look(Motion& m);
  void plan(Motion& m);
  void plan_axis(Motion& m, int axis);
  /// `reached`: the profile has come to its end; `cut`: nothing follows; `halted`: the caller goes on.
  enum class End : std::uint8_t { reached, cut, halted };
  void finish(Motion& m, End end);
  void replan(int axis);
  Motion* motion_of(int axis) {
    const int slot = axes_[ix(axis)].slot;
    return slot < 0 ? nullptr : &motions_[ix(slot)];
  }
  [[nodiscard]] const Motion* motion_of(int axis) const {
    const int slot = axes_[ix(axis)].slot;
    return slot < 0 ? nullptr : &motions_[ix(slot)];
  }
  bool hit_switch(Motion& m, int axis);
  void stop_motion(Motion& m);
  void cut(Motion& m);

  // Speeds.
  [[nodiscard]] SpeedOrder order(int axis) const;            ///< of a move of this axis alone
  [[nodiscard]] SpeedOrder path_order(unsigned axes) const;  ///< of an interpolated move
  [[nodiscard]] RampOrder ramps_of(const Motion& m) const;
  [[nodiscard]] RampOrder stop_ramps(const Motion& m) const;
  void begin_index(MotionKind kind, int axis, std::int64_t pulses) {
    begin_index(kind, axis, pulses, order(axis));
  }
  void begin_index(MotionKind kind, int axis, std::int64_t pulses, const SpeedOrder& by);
  void begin_endless(MotionKind kind, int axis, Sign way, bool slowly);

  // StepNLoop (emulator_loop.cpp).
  [[nodiscard]] bool closed(int axis) const { return settings_.on(Setting::loop, axis); }
  [[nodiscard]] double ratio(int axis) const {
    return closed(axis) ? static_cast<double>(settings_.get(Setting::loop_ratio, axis)) / 1000.0 : 1.0;
  }
  [[nodiscard]] std::int64_t target_at(int axis, std::int64_t offset) const;
  [[nodiscard]] std::int64_t target(int axis) const;
  void freeze_target(int axis);
  void rest_here(int axis);
  void watch_loop(Motion& m, int axis, int way, Sign load_way);
  bool stalled(Motion& m, int axis);
  void settle_loop(int axis);
  void loop_fails(int axis, LoopState state);

  // Homing (emulator_homing.cpp).
  void home_looks(Motion& m, int axis);
  void home_stage_ended(int axis);
  void home_switch_found(Motion& m, int axis);
  void home_done(int axis);
  void zero(int axis);
  void watch_homing(Motion& m, int axis, int way, Sign load_way);

  // Buffered moves.
  [[nodiscard]] bool buffer_has_loop() const;
  void next_segment(Pps speed);
  void segment_ended(Pps speed);
  [[nodiscard]] motion::Profile segment_profile(const motion::Path& path, const Segment& s, Pps now,
                                                double from, bool last) const;

  // Programs.
  void programs_power_up();
  void load_programs();
  void run_programs();
  [[nodiscard]] std::optional<Instant> program_turn() const;

  // Signals.
  void hold_loads();
  [[nodiscard]] bool inverted(const PolarityBit& bit, int axis) const;
  [[nodiscard]] Sign load_way(int axis, Sign way) const;
  [[nodiscard]] bool home_active(int axis) const;
  [[nodiscard]] bool limit_active(int axis, Sign side) const;
  /// The bit of X applies to all axes (decision AMB-089).
  [[nodiscard]] bool limits_inverted() const { return inverted(model_->polarity.limit, 0); }
  [[nodiscard]] bool alarm_active(int axis) const;
  [[nodiscard]] bool latch_input_active(int axis) const;
  [[nodiscard]] bool sync_condition(int axis, std::int64_t encoder) const;
  void update_sync(int axis);
  void watch_sync(Motion& m, int axis, int way, Sign load_way);
  void end_sync_pulse(int axis);
  [[nodiscard]] bool sync_output_on(int axis) const;

  // Joystick (emulator_joystick.cpp).
  [[nodiscard]] bool joystick_on(int axis) const {
    return (settings_.get(Setting::joystick) >> axis & 1) != 0;
  }
  [[nodiscard]] bool joystick_slows(int axis) const;
  [[nodiscard]] bool joystick_at_end(int axis) const;
  void joystick_tick();
  void joystick_turn(int axis);
  [[nodiscard]] double joystick_target(int axis) const;
  void schedule_joystick();
  void joystick_stops(int axis);

  const Model* model_;
  Instant now_{};
  bool powered_ = true;
  Flash flash_;
  Settings settings_;
  language::Vm vm_;
  bool program_is_new_ = true;  ///< lines have been written since the interpreter read them
  std::vector<Axis> axes_;
  std::array<Motion, most_axes> motions_;
  MoveBuffer buffer_;
  bool incremental_ = false;
  Terminals terminals_;
  bool load_needs_power_ = false;
  HostSettings host_settings_;
  Instant timer_end_{};
  HostTimeout timeout_;
  JoystickTurns joystick_;
};

}  // namespace hw::arcus
