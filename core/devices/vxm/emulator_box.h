#pragma once
// One VXM: two motors, program memory, inputs and outputs, front panel. A Master holds its Slave, another
// Box. Time is set from outside: set_time() moves counters and loads, settle() handles due events.
#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/devices/vxm/emulator_box_parts.h"

namespace hw::vxm {

class Box {
 public:
  Box();
  /// Makes this the Master of `slave`, as delivered for three or four motors.
  void link(Box slave);

  // --- power and time: emulator_box.cpp
  void power(bool on, Instant now);        ///< of this controller alone
  void power_slave(bool on, Instant now);  ///< a supply of its own
  [[nodiscard]] bool powered() const { return supply_.on; }
  void reset();  ///< res: like power off and on, but lines and loads stay
  void set_time(Instant now);
  bool settle();  ///< true: something happened
  [[nodiscard]] std::optional<Instant> next_event() const;

  // --- the wire: emulator_wire.cpp
  void receive(char c);
  std::string out;          ///< bytes for the host, taken by the owner
  std::size_t replied = 0;  ///< bytes added to `out` by requests since last set to 0
  Quirks quirks;
  [[nodiscard]] int rate() const;

  // --- hands on the bench: emulator_bench.cpp
  void set_line(int line, bool low);
  void set_analog(int value);
  void plant_changed(int axis);
  [[nodiscard]] motion::Plant& plant(int axis) { return axes_[static_cast<std::size_t>(axis)].plant; }
  [[nodiscard]] const Axis& axis(int axis) const { return axes_[static_cast<std::size_t>(axis)]; }
  [[nodiscard]] const Line& line(int line) const { return terminals_.lines[static_cast<std::size_t>(line)]; }
  [[nodiscard]] bool switch_operated(int axis, Sign side) const;
  void set_fitted(int axis, bool fitted) { axes_[static_cast<std::size_t>(axis)].fitted = fitted; }
  [[nodiscard]] int analog() const { return terminals_.analog.value(); }
  [[nodiscard]] int outputs() const;
  struct Lamps {
    bool power = false, online = false, power_blinks = false, online_blinks = false;
  };
  [[nodiscard]] Lamps lamps() const;
  void block() { supply_.deaf = true; }  ///< receive overrun: deaf until power-off

  [[nodiscard]] Box* slave() { return linked_.empty() ? nullptr : &linked_.front(); }
  [[nodiscard]] const Box* slave() const { return linked_.empty() ? nullptr : &linked_.front(); }
  [[nodiscard]] std::int32_t counter_at(int axis, Instant t) const;
  [[nodiscard]] bool turning(int axis) const { return motion_.active && motion_.axis == axis; }
  [[nodiscard]] Duration ramp_to_rest(int axis) const;
  std::vector<Pulse> pulses;  ///< since last taken

  // --- memory: emulator_memory.cpp
  [[nodiscard]] std::string saved_text() const;
  /// Why the line means nothing, as the end of a sentence; empty: it was taken.
  std::string load_line(std::string_view line);
  void forget_saved() { saved_ = Memory(); }
  void take_saved();
  std::uint64_t stores = 0;  ///< writes to non-volatile memory

  // --- for rehearsals
  std::vector<Trace>* trace = nullptr;
  [[nodiscard]] bool running() const { return run_.on; }
  [[nodiscard]] const Run& run() const { return run_; }
  [[nodiscard]] char error() const { return state_.error; }
  [[nodiscard]] bool limit_was_hit() const { return tally_.limit_was_hit; }
  [[nodiscard]] int moves_begun() const { return tally_.moves_begun; }
  [[nodiscard]] const Program& program(int i) const { return memory_.programs[static_cast<std::size_t>(i)]; }
  void go() { go_signal(); }
  /// Sets the position where a rehearsal begins.
  void set_counter(int axis, std::int32_t value) {
    Axis& a = axes_[static_cast<std::size_t>(axis)];
    a.counter = value;
    a.unwrapped = a.lowest = a.highest = value;
  }
  void set_outputs(int bits) { terminals_.outputs.set_all(bits); }
  void has_run_before() { state_.first_run = false; }

 private:
  // emulator_box.cpp
  void power_up();
  bool settle_own();
  [[nodiscard]] std::optional<Instant> own_event() const;
  [[nodiscard]] std::optional<Instant> lamp_event() const;
  [[nodiscard]] bool any_button_low() const;

  // emulator_wire.cpp
  void local_letter(char c);
  void running_letter(char c);
  void error_letter(char c);
  void online_char(char c);
  void obey(const Reading& reading);
  void obey_letter(char c);
  void obey_word(const Reading& word);
  void bus_char(char c);
  bool status_letter(char c);
  void set_mode_letter(char c);
  void verify();
  void send_slave_position(int axis);
  void reply(std::string_view text);
  void prompt(char c);
  void send_error(char letter);
  [[nodiscard]] std::int32_t last_slowed_at() const;
  [[nodiscard]] int limits_byte() const;
  [[nodiscard]] int inputs_byte() const;
  void digitize();
  void capture();
  void zero_all();

  // emulator_setup.cpp
  void store(const Reading& word);
  void store_group();
  void select_program(const Reading& word);
  void associate(const Reading& word);
  void set_value(const Reading& word);
  void get_value(const Reading& word);
  void set_motor_value(Head head, int axis, int value, bool minus);
  void set_inputs(int value);
  void save();
  void erase();
  void update_rules();
  [[nodiscard]] bool slave_found() const;
  Box* need_slave();  ///< null: EB is sent and everything reset

  // emulator_motion.cpp
  void sync();
  void turn(int axis, Sign sign, std::int64_t steps);
  void note_pulses(int axis, Sign sign, std::int64_t steps);
  void apply_turn(int axis, Sign sign, std::int64_t steps);
  bool start_motion(MotionKind kind, int axis, Sign sign, const motion::Profile& profile);
  void begin_index(int axis, std::int64_t distance, int home);
  void decelerate();
  void cut_motion(MotionEnd end);
  bool end_motion_if_due();
  [[nodiscard]] std::optional<Instant> motion_event() const;
  [[nodiscard]] motion::Ramp ramp(int axis) const;
  [[nodiscard]] Sign physical(int axis, Sign sign) const;
  [[nodiscard]] bool home_switch_wired(int axis) const;
  [[nodiscard]] bool limit_active(int axis, Sign side) const;
  [[nodiscard]] std::optional<std::int64_t> turns_until_stop(int axis, Sign sign, bool homing) const;
  void note_closed(int axis);
  void note_slowing(Instant when, std::int32_t counter) { state_.slowing = {when, counter}; }

  // emulator_run.cpp
  void start_run(int program);
  bool run_if_due();
  bool go_on();
  bool execute_next();
  void perform(const Command& command, int at);
  bool left_out(const Frame& frame, const Program& program, int& unit) const;
  void begin_moves();
  void begin_next_moves();
  void moves_done();
  void take_motion_end(Box& box);
  bool report_first_of_pair();
  void end_frame();
  void finish_run();
  void end_stopped_run();
  void kill();
  void raise(char letter);
  void hold_toggle();
  void go_signal();
  void stop_input();
  void restore_out();
  void note(std::string what);

  // emulator_flow.cpp
  void do_loop(const Command& command, int at);
  void jump_back(Frame& frame, int target);
  void do_jump(int program);
  void do_call(int program, bool pick);
  void do_index(const Command& command);
  void do_index_to(const Command& command);
  void do_group(const Command& command);
  void plan_relative(const Command& command, bool with_next);
  void plan_ways_back(int but_axis);
  void plan_index_to(const Command& command, bool with_next);
  void do_speed(const Command& command);
  void do_pause(const Command& command);
  void do_user(const Command& command, int at);
  void do_skip(int u);
  void set_output(int number, bool on);
  [[nodiscard]] bool reversed(int axis) const;
  [[nodiscard]] bool in_pick() const;
  [[nodiscard]] int open_loops() const;
  [[nodiscard]] int open_jumps() const;

  // emulator_wait.cpp
  void begin_wait(int u, bool on_slave);
  [[nodiscard]] std::optional<Instant> wait_event() const;
  bool wait_if_due();
  void end_wait();
  [[nodiscard]] Duration valid_time() const;
  [[nodiscard]] const Box& wait_box() const;
  [[nodiscard]] bool branch_low() const;

  // emulator_nonstop.cpp
  void begin_nonstop(int signal);
  [[nodiscard]] bool allowed_in_nonstop(const Command& command) const;
  void nonstop_index(const Command& command);
  void nonstop_signal();
  void end_nonstop(int u, int at);
  void nonstop_motion_ended();

  // emulator_jog.cpp
  bool update_jog();
  [[nodiscard]] bool jog_allowed() const;
  [[nodiscard]] int jog_speed(int axis) const;
  [[nodiscard]] int joystick_speed(int axis) const;
  [[nodiscard]] int joystick_axis() const;
  [[nodiscard]] bool wants_jog(int axis, Sign sign) const;
  void jog_start();
  void jog_turn(int axis, Sign sign, int speed, bool joystick);
  void jog_end();
  [[nodiscard]] std::optional<Instant> jog_event() const;
  [[nodiscard]] std::optional<Instant> run_button_event() const;
  bool run_button_if_due();

  Instant now_{};
  std::vector<Box> linked_;
  bool is_slave_ = false;
  Supply supply_;
  HostSide host_;
  Memory memory_, saved_;
  Rules rules_;
  State state_;
  Terminals terminals_;
  std::array<Axis, 2> axes_;
  Motion motion_;
  Jog jog_;
  Run run_;
  RunTally tally_;
};

}  // namespace hw::vxm
