#pragma once
// Facts of the wire and of the tables in the VXM manual (VXM-UM-E5): limits, bits, mnemonics, costs. Shared
// by driver and emulator. Nothing here writes or reads the wire.
#include <array>
#include <cstdint>
#include <string_view>

namespace hw::vxm {

// --- motion (Motor Commands p.16-18) --------------------------------------------------------------------
inline constexpr int motors_per_controller = 2, max_motors = 4;
inline constexpr std::int32_t max_index = 16'777'215;
inline constexpr std::int32_t position_min = -8'388'608, position_max = 8'388'607;  ///< 24-bit registers
inline constexpr int min_speed = 1, max_speed = 6000, default_speed = 2000;         ///< steps/s
inline constexpr int min_accel = 1, max_accel = 127, default_accel = 2;
/// Steps/s² per unit of `A` (given in Application Note 106 only). NF90 emulation doubles it.
inline constexpr double accel_unit = 1000.0;
inline constexpr std::int32_t home_give_up_steps = 16'000'000;  ///< "about 16 million"
inline constexpr int hard_stop_safe_speed = 1000;               ///< above it `K` may lose position (p.23)

// --- programs (p.16, 19-21) -----------------------------------------------------------------------------
inline constexpr int program_count = 5, program_bytes = 256;
inline constexpr int max_open_loops = 10, max_open_jumps = 4;
inline constexpr int min_loop = 2, max_loop = 65'535, max_pause = 65'535;
inline constexpr int pma_off = 255;
inline constexpr std::int32_t store_life = 100'000;  ///< erase and write cycles (rsm, p.24)

/// Bytes of program memory, by the text before motor and number (App. P, each command's own paragraph).
struct StoredForm {
  std::string_view head;
  int bytes;
};
inline constexpr std::array<StoredForm, 13> stored_forms{{
    {"I", 4},
    {"IA", 4},
    {"S", 3},
    {"SA", 3},
    {"A", 2},
    {"L", 3},
    {"LA", 3},
    {"LM", 1},
    {"J", 2},
    {"JM", 2},
    {"P", 3},
    {"PA", 3},
    {"U", 2},
}};
inline constexpr int endless_loop_bytes = 1;  ///< L0 (and L-0 in NF90 emulation)
inline constexpr int u91_bytes = 6;           ///< it becomes U92 and an index
inline constexpr int pair_bytes = 2;          ///< ( ) in addition to its indexes

/// U commands that exist; the Slave's are these plus 100 (App. B p.37).
inline constexpr std::array<int, 33> u_commands{0,  1,  2,  3,  4,  5,  6,  7,  8,  9,  11,
                                                12, 13, 14, 15, 16, 17, 18, 19, 21, 22, 23,
                                                30, 31, 32, 33, 50, 51, 77, 90, 91, 92, 99};
inline constexpr std::array<int, 21> slave_u_commands{100, 101, 102, 103, 104, 105, 113, 114, 115, 116, 117,
                                                      118, 119, 123, 130, 131, 132, 133, 150, 151, 190};
inline constexpr int slave_u_offset = 100;

/// Speed ranges of SmM-x from the analog input (App. I p.53).
struct AnalogRange {
  int number, low, high;  ///< steps/s
};
inline constexpr std::array<AnalogRange, 21> analog_ranges{{
    {1, 1, 1000},     {2, 1, 2000},     {3, 1, 3000},     {4, 1, 4000},     {5, 1, 5000},
    {6, 1, 6000},     {11, 1000, 2000}, {12, 1000, 3000}, {13, 1000, 4000}, {14, 1000, 5000},
    {15, 1000, 6000}, {21, 2000, 3000}, {22, 2000, 4000}, {23, 2000, 5000}, {24, 2000, 6000},
    {31, 3000, 4000}, {32, 3000, 5000}, {33, 3000, 6000}, {41, 4000, 5000}, {42, 4000, 6000},
    {51, 5000, 6000},
}};
inline constexpr int analog_min = 0, analog_max = 1024, analog_default = 512;

// --- set-up (set, get; p.25 and appendices) ------------------------------------------------------------
inline constexpr int min_jog_2 = 40;            ///< steps/s, the second jog speed (App. H p.49)
inline constexpr int max_joystick_range = 24;   ///< App. J p.54
inline constexpr int max_pulse_every = 32'767;  ///< App. D p.41
inline constexpr int max_motor_type = 6;
/// A value of set/get. `mnemonic`: the text between set/get and the number, `m` for the motor's digit.
struct SetupFact {
  std::string_view mnemonic;
  std::int32_t min, max, factory;
  bool also_zero;  ///< 0 is allowed too and switches it off
  bool readable;   ///< has a get form
};
inline constexpr std::array<SetupFact, 13> setup_facts{{
    {"MmM", 0, max_motor_type, 0, false, true},        // motor type, 70 % jog power
    {"MAmM", 0, max_motor_type, 0, false, false},      // motor type, full jog power; read back by getMmM
    {"B", 9, 38, 9, false, false},                     // line rate: 9, 19 or 38
    {"DM", 0, 255, 1, false, true},                    // mode bits below
    {"DA", 20, 100, 40, false, true},                  // joystick dead zone
    {"jmM", min_speed, max_speed, 2000, true, true},   // first jog speed
    {"JmM", min_jog_2, max_speed, 2000, false, true},  // second jog speed
    {"jAmM", 1, max_joystick_range, 0, true, true},    // first joystick range
    {"JAmM", 1, max_joystick_range, 0, true, true},    // second joystick range
    {"LmM", -2, 2, 0, false, true},                    // limit switch mode
    {"PmM", 1, max_pulse_every, 0, true, true},        // steps from pulse to pulse
    {"PA", 1, 255, 1, false, true},                    // pulse width in 10 microseconds
    {"I", 0, 255, 7, false, true},                     // input mode bits below
}};
inline constexpr int max_backlash = 255, backlash_of_one = 20;  ///< B1 means 20 steps (App. F p.45)
inline constexpr int limit_ends_program = 2;                    ///< bit of O
inline constexpr int max_limit_report = 3;                      ///< O: bit 0 send O, bit 1 end the program

enum ModeBit : int {  // setDM (App. O p.68)
  mode_always = 1,
  mode_invert_1 = 2,
  mode_invert_2 = 4,
  mode_nf90 = 8,
  mode_invert_3 = 16,
  mode_invert_4 = 32,
  mode_master = 64,
  mode_program_4_first = 128,
};
enum InputModeBit : int {  // setI (App. C p.38)
  inputs_run = 1,
  inputs_stop = 2,      ///< cleared by inputs_capture
  inputs_branch_3 = 4,  ///< cleared by inputs_select
  inputs_fast = 8,      ///< Run and input 1 valid after 100 us instead of 1 ms
  inputs_hard_stop = 16,
  inputs_program_4 = 32,  ///< after Stop
  inputs_select = 64,     ///< inputs 2 and 3 choose program 0 to 3
  inputs_capture = 128,   ///< input 4 records positions
};
enum LimitMode : int {  // setL (App. N p.66)
  limits_detect = 0,
  limits_closed = 1,
  limits_home_closed = 2,
  limits_open = -1,
  limits_home_open = -2,
};

struct Baud {
  int number, rate;
};
inline constexpr std::array<Baud, 3> bauds{{{9, 9600}, {19, 19200}, {38, 38400}}};
inline constexpr const char* rates_in_words = "9600, 19200 or 38400";

// --- status bytes (App. A p.32-33) ----------------------------------------------------------------------
/// `?`: bit 2(m-1) = minus limit of motor m, bit 2(m-1)+1 = plus limit; 1 = not active.
constexpr int limit_bit(int motor, bool plus) { return 2 * (motor - 1) + (plus ? 1 : 0); }
/// `~`: bits 0-3 jog 1- 1+ 2- 2+, bits 4-7 inputs 1-4; 1 = high (not operated).
inline constexpr int first_input_bit = 4;
/// `$`: bits 0-3 outputs 1-4; 1 = high.
inline constexpr int inputs_per_controller = 4, outputs_per_controller = 4;
inline constexpr int lines_per_controller = 8;  ///< its inputs, then its jog inputs

// --- letters --------------------------------------------------------------------------------------------
inline constexpr char prompt = '^', over_travel = 'O', held = ':', waits_for_go = 'W', index_passed = '@';
inline constexpr char busy = 'B', ready = 'R', jog_idle = 'J', jog_moving = 'b';
/// Error reports are two bytes, `E` (C5h with the quirk "e-bar") and one of these (p.30, 68; App. C).
enum ErrorLetter : char {
  error_bus = 'B',      ///< no Slave answers: the controller resets
  error_memory = 'M',   ///< program memory full: K recovers
  error_loops = 'L',    ///< more than ten open loops: K recovers
  error_jumps = 'J',    ///< more than four open jumps: K recovers
  error_nonstop = 'C',  ///< nonstop indexing without end or with another motor: K recovers
  error_erased = 'N',   ///< memory erased by setD0
  error_stopped = 'S',  ///< the Stop input ended a program (no error state)
};
inline constexpr char error_mark = 'E', error_mark_barred = static_cast<char>(0xC5);
inline constexpr std::string_view accepted_in_local = "EFGNVDQ";
inline constexpr std::string_view accepted_while_running = "KDHGVXY!*?~$@";  ///< and res; Z, T at standstill

/// Ends a number or a command (p.26): carriage return, comma, period.
constexpr bool is_ender(char c) { return c == '\r' || c == ',' || c == '.'; }

// Firmware versions, in hundredths.
inline constexpr int newest_firmware = 130, old_firmware = 119;
inline constexpr int firmware_of_listing = 121;  // lists the command before which it holds (App. A p.32)
inline constexpr int firmware_of_outputs = 122;  // $ (App. A p.33)
inline constexpr int firmware_of_pulses = 124;   // setPA, getPA (App. D p.43)
inline constexpr std::string_view firmware_date = "12-29-04";

// --- front panel, in the order of BenchView's bits ------------------------------------------------------
inline constexpr std::array<std::string_view, 12> panel_buttons{
    "1-", "1+", "2-", "2+", "Run", "Stop", "3-", "3+", "4-", "4+", "Slave Run", "Slave Stop"};
inline constexpr int buttons_per_controller = 6;
inline constexpr std::array<std::string_view, 4> panel_lamps{"Power", "On-Line", "Slave Power",
                                                             "Slave On-Line"};
inline constexpr int lamps_per_controller = 2;
/// Bench numbers: inputs and outputs 1-4 and analog 1 are the first controller's, 5-8 and 2 the Slave's.

}  // namespace hw::vxm
