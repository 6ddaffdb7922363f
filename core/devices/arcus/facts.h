#pragma once
// Facts that the PMX-4EX-SA and the DMX-K-SA share on the wire and in the tables of their manuals, and the
// structure of their differences: each device fills in a `Model` in its own facts.h. Shared by emulator and
// driver; nothing here writes or reads the wire.
#include <array>
#include <cstdint>
#include <span>
#include <string_view>

namespace hw::arcus {

inline constexpr int most_axes = 4;
inline constexpr std::int64_t position_min = -134'217'728, position_max = 134'217'727;  ///< 28 bits
inline constexpr std::int64_t max_speed = 6'000'000;                                    ///< pulses/s
inline constexpr std::int64_t max_radius = 134'216'773;                                 ///< arcs, in pulses
inline constexpr std::int64_t max_number = 2'147'483'647;    ///< of a program or a time-out
inline constexpr int min_current = 100, max_current = 2500;  ///< mA, of a driver that is built in
inline constexpr std::int64_t full_turn = 360'000;           ///< of an arc, in thousandths of a degree

// --- standalone programs (PMX manual ch. 6, DMX manual ch. 7) -------------------------------------------
inline constexpr int program_lines = 1275, max_line_text = 63;
inline constexpr int subroutines = 32, error_subroutine = 31;
inline constexpr int variables = 100, first_stored_variable = 50;

// --- names, replies to ID --------------------------------------------------------------------------------
inline constexpr std::string_view pmx_product = "Performax-4EX-SA", dmx_product = "DriveMax-K-SA";

// --- line rates (tables 6.14 and 7.9) -------------------------------------------------------------------
struct Baud {
  int code, rate;
};
inline constexpr std::array<Baud, 5> bauds{{{1, 9600}, {2, 19200}, {3, 38400}, {4, 57600}, {5, 115200}}};
inline constexpr const char* rates_in_words = "9600, 19200, 38400, 57600 or 115200";

// --- StepNLoop (tables 6.12 and 7.6) --------------------------------------------------------------------
enum class LoopState : std::uint8_t {
  idle = 0,
  moving = 1,
  correcting = 2,
  stopping = 3,
  aborting = 4,
  jogging = 5,
  homing = 6,
  index_homing = 7,
  range_error = 8,
  attempt_error = 9,
  stall_error = 10,
  limit_error = 11,
  off = 12,
  limit_homing = 13,
};

// --- homing: the five routines of both manuals ----------------------------------------------------------
enum class HomeMode : std::uint8_t {
  home = 0,          ///< PMX 0, DMX H: home switch at high speed
  limit = 1,         ///< PMX 1, DMX L
  home_index = 2,    ///< PMX 2, DMX ZH
  index = 3,         ///< PMX 3, DMX Z
  home_high_low = 4  ///< PMX 4, DMX HL
};

// --- speeds (table A.0) ---------------------------------------------------------------------------------
/// One row: for high speeds up to and including `upper` (decision AMB-050), in pulses/s.
struct SpeedRow {
  std::int64_t upper;
  int window;                  ///< SSPDM; the first row is also window 0
  std::int64_t min_low_speed;  ///< pulses/s
  std::int64_t min_accel_ms;
  std::int64_t delta;  ///< longest ramp: (HS - LS) / delta seconds
};

// --- settings -------------------------------------------------------------------------------------------
/// Every setting with a get and a set form, under model-independent names.
enum class Setting : std::uint8_t {
  device_name,
  baud_code,
  high_speed,
  low_speed,
  accel,
  decel,
  axis_high_speed,
  axis_low_speed,
  axis_accel,
  axis_decel,
  separate_decel,
  s_curve,
  speed_window,
  buffer_accel,
  polarity,
  input_polarity,
  output_polarity,
  enable_polarity,
  boot_outputs,
  boot_enables,
  ignore_errors,
  sync_condition,
  sync_position,
  sync_width,
  joystick,
  joystick_values,
  joystick_limits,
  joystick_max,
  joystick_min,
  loop,
  loop_ratio,
  loop_tolerance,
  loop_range,
  loop_attempts,
  loop_idle_tolerance,
  comm_timeout,
  error_return,
  boot_programs,
  auto_response,
  line_type,
  idle_current,
  run_current,
  idle_time,
  modbus_number,
  modbus,
  status_outputs,
  home_correction,
  limit_correction,
  response_type,
  return_to_zero,
};
inline constexpr std::size_t setting_count = static_cast<std::size_t>(Setting::return_to_zero) + 1;

enum class Notation : std::uint8_t {
  integer,
  thousandths,  ///< 0.800
  name,         ///< prefix and two digits: 4EX07
};

/// One row of a model's table of settings. `form` is the get form; `a` stands for the axis letter, `n` for an
/// index from 1. The set form appends `=value`.
struct SettingFact {
  Setting id;
  std::string_view form;
  int count;  ///< axes or indexes; 1 when there is neither
  std::int64_t min, max, factory;
  bool stored;             ///< by STORE
  bool also_zero = false;  ///< 0 is allowed as well as min..max
  Notation notation = Notation::integer;
};

// --- status words: two separate tables (decision AMB-133) -----------------------------------------------
inline constexpr int no_bit = -1;
struct StatusBits {
  int accelerating, decelerating, constant, alarm, plus_limit, minus_limit, home, plus_error, minus_error,
      alarm_error, latch, index, timed_out;
};

// --- polarity -------------------------------------------------------------------------------------------
/// A bit of a polarity word; the signal is inverted when the bit has the value `inverts`.
struct PolarityBit {
  int bit;
  bool inverts;
};
struct PolarityBits {
  PolarityBit home, alarm, limit, direction, latch, in_position, alarm_output, outputs, inputs, jump, enable;
};
inline constexpr PolarityBit no_polarity{no_bit, true};

// --- refusals -------------------------------------------------------------------------------------------
/// Why a command was refused. The model has a text for each.
enum class Refusal : std::uint8_t {
  none,
  unknown,  ///< "?" and the command as it came
  bad_index,
  limit_error,
  alarm,
  loop_error,
  moving,
  incremental,   ///< arcs in INC mode
  not_targeted,  ///< T without a target move
  no_subroutine,
  timer_runs,
  buffer_full,
  speed,  ///< SSPD refused (PMX), or no number and no motion (DMX)
  speed_s_curve,
  speed_window,
  needs_rs485,
};
inline constexpr std::size_t refusal_count = static_cast<std::size_t>(Refusal::needs_rs485) + 1;

/// All differences between the two products, as data.
struct Model {
  std::string_view name;              ///< "pmx-4ex-sa"
  std::string_view title;             ///< "PMX-4EX-SA"
  std::string_view axis_letters;      ///< "XYZU"
  std::string_view name_prefix;       ///< of the device name: "4EX"
  std::string_view product, version;  ///< replies to ID and VER
  char reply_end;
  int broadcast;  ///< the address that all obey and none answers; -1: none
  int inputs, outputs, enables, analog_inputs, programs;
  std::array<int, most_axes> latch_inputs;  ///< input of each axis
  std::array<int, most_axes> sync_outputs;
  std::int64_t counts_denominator,
      counts_numerator;      ///< encoder counts per pulse on the bench as it is built
  std::int64_t index_every;  ///< pulses between index marks on that bench
  StatusBits status;
  PolarityBits polarity;
  std::span<const SpeedRow> speeds;
  std::span<const SettingFact> settings;
  std::array<std::string_view, refusal_count> refusals;
  int buffer_places = 0;                          ///< of buffered moves; 0: has none
  int in_position_output = 0, alarm_output = 0;   ///< outputs that StepNLoop may take; 0: none
  bool positions_may_be_written_in_loop = false;  ///< P= with StepNLoop on (decision AMB-039)

  [[nodiscard]] constexpr int axes() const { return static_cast<int>(axis_letters.size()); }
  [[nodiscard]] constexpr std::string_view refusal(Refusal r) const {
    return refusals[static_cast<std::size_t>(r)];
  }
};

}  // namespace hw::arcus
