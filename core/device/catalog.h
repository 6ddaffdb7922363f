#pragma once
// A controller described as data. Setup, I/O, jog, status, terminal completion and help are drawn from it;
// panels know no device by name. Built once per open controller (its options may change the number of axes),
// immutable afterwards, read by any thread.
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/base/units.h"
#include "core/device/bench_facts.h"
#include "core/device/jog_guard.h"
#include "core/time/clock.h"

namespace hw {

struct AxisTarget;
struct Snapshot;

struct AxisInfo {
  std::string name;          ///< the maker's name: "1", "X"
  std::string description;   ///< "motor 1"
  bool switchable = false;   ///< the motor current can be switched: intent::SetPower
  bool encoder = false;      ///< has an encoder counter that can be set: intent::SetEncoder
  bool home_input = false;   ///< reports its home switch: AxisState::home
  bool alarm_input = false;  ///< reports an alarm of its motor driver: AxisState::alarm
  bool servo = false;        ///< a servo axis, positioned by its encoder: AxisState::loop, AxisState::command
};

/// A ready-made conversion from steps to a real unit (lead screws, rotary tables).
struct UnitChoice {
  std::string label;  ///< "BiSlide E04, 0.4 inch a turn"
  std::string unit;   ///< "mm", "inch", "°"
  double per_step;    ///< units per step
  int decimals;       ///< needed to show one step
};

struct HomingMode {
  std::string id;                           ///< for scripts: "limit"
  std::string label;                        ///< "to the limit switch"
  std::string maker = {};                   ///< the maker's word, if any: "ZH"
  bool sets_position = true;                ///< homing sets the count where it ends
  std::optional<Sign> only_direction = {};  ///< none: it homes in both directions
  [[nodiscard]] bool allows(Sign sign) const { return !only_direction || *only_direction == sign; }
};

struct InputInfo {
  std::string name;  ///< "In 1"
  std::string help;
  bool active_low = true;
  int number = -1;         ///< the maker's number; -1: its place, from 1 (see Catalog::input_number)
  std::string group = {};  ///< heading over inputs of the same group: "Lines 0 to 7: inputs"
  bool of_output = false;  ///< the level of an output line: shown with the outputs of its group
};
/// The controller's own use of an output: "In position".
struct OutputDuty {
  std::string name;                         ///< empty: the output has no duty
  std::vector<std::string> while_not_zero;  ///< on duty while all of these parameters and readouts are not 0
};
struct OutputInfo {
  std::string name;  ///< "Out 1"
  std::string help;
  bool settable = true;
  OutputDuty duty = {};
  int number = -1;          ///< the maker's number; -1: its place, from 1 (see Catalog::output_number)
  std::string group = {};   ///< as InputInfo::group
  bool on_the_way = false;  ///< can be switched within a contour
};
struct AnalogInfo {
  std::string name, unit;  ///< "Analog", "counts"
  std::int32_t minimum, maximum;
};

struct ParamChoice {
  std::int64_t value;
  std::string label;
};
struct ParamBit {
  int bit;
  std::string label;
};
struct ParamInfo {
  std::string mnemonic;     ///< the maker's name for it in commands: "j1M", "DM", "HSX"
  std::string label;        ///< "First jog speed of motor 1"
  std::string explanation;  ///< for a user who has not read the manual
  std::string unit;         ///< "steps/s" or empty
  std::string group;        ///< heading in Setup
  std::int64_t minimum = 0, maximum = 0, fallback = 0;  ///< fallback: the factory value
  std::vector<ParamChoice> choices;                     ///< not empty: exactly these values
  std::vector<std::string> short_choices;               ///< one word for each choice, for a narrow column
  std::vector<ParamBit> bits;                           ///< not empty: a bit field
  int decimals = 0;        ///< decimals of the shown number: with 3, a value of 800 is 0.800
  std::string prefix;      ///< of a name that ends in a number: 4EX07 is 7 with prefix "4EX" ...
  int digits = 0;          ///< ... and 2 digits
  bool also_zero = false;  ///< 0 is allowed too and switches it off (range starts above)
  bool stored = true;      ///< kept by Store
  bool readable = true;
  int axis = -1;
  bool of_move_buffer = false;                ///< shown beside the list of moves too
  std::string warning;                        ///< not empty: to be confirmed before it is written ...
  std::optional<std::int64_t> harmless = {};  ///< ... unless it is this value
  std::string manual;                         ///< "Appendix H"
  /// Not empty: why and what to do, shown before the first move of its axis while the value is `unset_value`.
  std::string before_moving;
  std::int64_t unset_value = 0;
  /// Its unit changes from Catalog::step_word to Catalog::loop_word when the loop of its axis is closed;
  /// without an axis, when all loops are.
  bool follows_loop = false;
  /// A greater value drives its servo axis harder towards the command: intent::Closing.
  bool drives = false;
  /// Not empty: the address option with the same meaning: "baud", named as in `choices`, or "id", two digits.
  std::string address_option = {};
  /// If there is an address option: it takes effect when it is set; else after Store and a power cycle.
  bool holds_at_once = false;

  [[nodiscard]] bool accepts(std::int64_t v) const {
    if (!choices.empty()) {
      for (const ParamChoice& c : choices)
        if (c.value == v) return true;
      return false;
    }
    return (v >= minimum && v <= maximum) || (also_zero && v == 0);
  }
};

/// A value that the controller reports beside positions and inputs: a state, a counter, a latched position.
struct ReadoutInfo {
  std::string id;     ///< the maker's word: "SLSX"
  std::string label;  ///< "StepNLoop of X"
  int group = 0;      ///< index into Catalog::readout_groups
  int axis = -1;
  std::string unit;
  std::vector<ParamChoice> words;  ///< not empty: the meanings of the values
  std::vector<std::int64_t> bad;   ///< values that are faults
  bool for_scripts = false;        ///< a bare number of no use to a person: not drawn in Control
  std::string help;
};

/// One value that an action needs.
struct ActionField {
  std::string id;     ///< part of the widget's path: "centre_x"
  std::string label;  ///< "Centre X"
  std::string unit;
  std::int64_t minimum = 0, maximum = 0, fallback = 0;
  int decimals = 0;
  std::vector<ParamChoice> choices;  ///< not empty: exactly these values
  bool follows_loop = false;         ///< as ParamInfo::follows_loop
  bool is_place = false;             ///< a target position: it relies on the count
  bool for_all_rows = false;         ///< one value for all axes, drawn under the AxisTables
  int of_axis = -1;                  ///< -1: the axis chosen in the field "axis", else the only one
};
/// An action of this controller that is not a verb of all controllers: intent::Act. Drawn as a button with
/// its fields.
struct ActionInfo {
  std::string id;     ///< path: "arc", "latch_on"
  std::string label;  ///< on the button: "Draw arc"
  std::string help;
  std::string group;            ///< heading; that of a readout group puts it beside the group's values
  bool moves = false;           ///< starts or changes motion
  bool while_busy = false;      ///< makes sense while a motion or program runs
  bool of_move_buffer = false;  ///< shown beside the list of moves too
  bool is_arc =
      false;  ///< of the first two axes: its fields are the centre and the sweep, + is counter-clockwise
  bool follows_analog = false;  ///< its axis follows an analog input: drawn with the analog inputs
  std::string sets = {};        ///< the readout that shows its effect ...
  std::int64_t sets_to = 0;     ///< ... and its value; actions of one readout are drawn as a choice
  std::vector<ActionField> fields;
  std::string manual;
  /// The outermost places that it reaches with these values from the present positions; null: only its own
  /// places.
  std::vector<AxisTarget> (*reaches)(const Snapshot& now, const std::vector<std::int64_t>& values) = nullptr;
};

/// A column of an AxisTable. The cell of an axis for which the catalog has no such id is empty.
struct AxisColumn {
  enum class Shows : std::uint8_t {
    motion,   ///< activity and speed of the axis, and the action `id` that clears its error
    readout,  ///< the word or number of a readout
    param,    ///< a parameter, written as soon as it is chosen or typed
    toggle,   ///< a lamp: a parameter that is 0 or 1, or an action with a field "on"
    action,   ///< an action with its fields and button; one that switches has two verbs
  };
  Shows shows = Shows::readout;
  std::string id;          ///< '*' stands for the name of the axis, or for nothing: "LT*S"
  std::string title;       ///< heading; empty: the label of what the column shows
  std::string state = {};  ///< id of the readout or parameter (or its bit n) that is not 0 while it is on
  std::string verb_on = {}, verb_off = {};  ///< on the button; empty: the label of the action
  bool while_moving = false;                ///< possible only while the axis moves
  /// A parameter that matters only while the parameter `state` is `state_for`; else `otherwise` is shown.
  std::int64_t state_for = 0;
  std::string otherwise = {};
};
/// A table of the Control panel with a row per axis. Nothing is shown both here and elsewhere in the panel.
struct AxisTable {
  std::string title;
  std::string note = {};  ///< at the right of the title: "on DI1 to DI4"
  std::vector<AxisColumn> columns;
};

/// Numbered variables of the controller's programs.
struct VariableFacts {
  int count = 0;             ///< 0: none
  std::string prefix = "V";  ///< V0, V1 ...
  int stored_from = 0;       ///< Store keeps variables from this number on
  int readout_group = -1;    ///< the group to watch them by
  std::int64_t minimum = 0, maximum = 0;
};

/// Moves that the console can feed into a buffer of the controller: intent::FeedMoves.
struct MoveListFacts {
  std::vector<ActionField> columns;  ///< empty: the controller has no buffer
  int depth = 0;                     ///< places in the buffer
  int readout_group = -1;            ///< the readouts of the buffer
  std::string file_suffix;
};

struct CommandInfo {
  /// "SmMx": a letter stands for a number where the example has digits. "J[axis][+/-]", "DO[1-8]=[value]": a
  /// bracket stands for an axis name, a sign, a number or a value.
  std::string form;
  std::string example;  ///< "S1M500"
  std::string help;     ///< "speed of motor m, 1 to 6000 steps/s"
  bool moves = false;   ///< Enter moves, or may move, something now
  bool stored = false;  ///< stored in the program; moves nothing now
  std::string manual = {};
};

/// One value in the memory window of a controller: Catalog::memory. Big-endian.
struct MemoryCell {
  int offset = 0;
  int bytes = 2;      ///< 1, 2 or 4
  std::string name;   ///< "X Encoder Position"
  std::string group;  ///< heading: "Registers", "Axis X"
  int axis = -1;
  bool is_signed = false;
  std::vector<ParamBit> bits;  ///< not empty: a bit field
  std::string help;
};
/// A ring of characters in that window, one in each cell of two bytes.
struct MemoryRing {
  std::string name;  ///< "Commands"
  int offset = 0, cells = 0;
  int put_index = 0, get_index = 0;  ///< offsets of its two indexes
};

struct ProgramFacts {
  int slots = 0;              ///< 0: no stored programs
  std::string slot_word;      ///< "Program"
  int capacity = 0;           ///< per slot, in `capacity_unit`
  std::string capacity_unit;  ///< "bytes"
  int threads = 0;            ///< > 0: programs that can run at once, all in the text of slot 0
  bool compiled = false;      ///< compiled code is stored, not the text: View shows the listing
  std::string file_suffix;    ///< ".vxm"
  char comment = ';';
  std::string example;  ///< short, shows the language, and ends by itself: the demo opens with it
};

/// An option chosen before a controller is opened or its emulator started: key=value of an address.
struct OptionInfo {
  std::string key;  ///< "motors"
  std::vector<std::pair<std::string, std::string>>
      choices;  ///< value and label: "4", "4 motors"; first: usual
};

struct Capabilities {
  bool single_step = false;        ///< supports Pause, Resume and SingleStep
  bool outputs_while_held = true;  ///< outputs can be switched while a program is held
  bool stop_clears_outputs = false;
  bool store = false;           ///< non-volatile memory with a limited write life
  std::int32_t store_life = 0;  ///< writes
  bool one_axis_at_a_time = false;
  bool homes = true;
  bool reset = false;
  bool interpolates = false;  ///< moves several axes together on a straight line ...
  /// ... whose speed is that along its path; else it is that of its longest axis.
  bool speed_along_path = false;
  bool arcs = false;          ///< moves its first two axes along an arc, from rest to rest
  bool broadcast = false;     ///< accepts text sent to all devices on a wire, without replies
  bool usb = false;           ///< has USB, beside any serial line
  bool window = false;        ///< a board in a memory window on a bus: no serial line at all
  bool memory_map = false;    ///< its window is described in Catalog::memory and shown in Snapshot::window
  bool contours = false;      ///< records paths at constant velocity and plays them
  bool servo_tuning = false;  ///< has servo axes whose gains can be tuned: intent::Sample, Session::samples()
  int usual_baud = 9600;
  std::vector<int> bauds;
};

struct Catalog {
  std::string model;       ///< "vxm": as in an address
  int address = -1;        ///< of this device on a shared line; -1: it has none
  std::string name;        ///< "Velmex VXM"
  std::string short_name;  ///< "VXM"
  std::string summary;     ///< "stepping motors, 2 or 4"
  std::string step_word = "steps";
  std::string loop_word;  ///< unit of an axis whose AxisState::in_counts is set: "counts"
  std::vector<OptionInfo> options;
  std::map<std::string, std::string> made_from;  ///< address options that differ from the usual
  std::vector<AxisInfo> axes;
  std::vector<UnitChoice> units;
  std::vector<HomingMode> homing_modes;
  std::vector<InputInfo> inputs;
  std::vector<OutputInfo> outputs;
  std::vector<AnalogInfo> analog;
  int analog_readout_group = -1;  ///< watched while analog inputs are shown large; -1: they are always polled
  std::vector<ParamInfo> params;
  std::vector<std::string> readout_groups;
  std::vector<ReadoutInfo> readouts;
  std::vector<ActionInfo> actions;
  std::vector<AxisTable> axis_tables;
  VariableFacts variables;
  MoveListFacts move_list;
  std::vector<MemoryCell> memory;  ///< if Capabilities::memory_map
  std::vector<MemoryRing> memory_rings;
  int memory_readout_group = -1;  ///< watched while the window is shown, so that its rings are read too
  Duration servo_update{};        ///< period of the servo loops, if Capabilities::servo_tuning
  int queue_depth = 0;            ///< entries of each axis' command queue (Snapshot::queue_free); 0: none
  int contour_size = 0;           ///< entries of a contour, if Capabilities::contours
  std::vector<CommandInfo> commands;
  std::string command_separators;  ///< characters between the commands of one line; empty: one command a line
  ProgramFacts program;
  /// How far a moving axis travels after a stop with its ramp, as far as its set-up is known. Null: not
  /// known.
  std::optional<double> (*stopping_way)(const Catalog& catalog, const Snapshot& now, AxisId axis) = nullptr;
  JogGuardFacts jog_guard;
  BenchFacts bench;
  Capabilities can;
  Pps jog_speed{2000}, jog_speed_min{1}, jog_speed_max{6000};
  Steps position_min{}, position_max{}, move_max{};

  /// Several devices of this kind can share a wire.
  [[nodiscard]] bool addressed() const { return address >= 0; }
  /// The two digits of `address`, as in id= of an address; empty: it has none.
  [[nodiscard]] std::string id() const {
    if (!addressed()) return {};
    return {static_cast<char>('0' + address / 10 % 10), static_cast<char>('0' + address % 10)};
  }
  [[nodiscard]] int find_axis(std::string_view axis_name) const {
    for (std::size_t i = 0; i < axes.size(); ++i)
      if (axes[i].name == axis_name) return static_cast<int>(i);
    return -1;
  }
  /// The maker's number of the input at `place` (from 0), and back; -1: there is none.
  [[nodiscard]] int input_number(std::size_t place) const { return number_at(inputs, place); }
  [[nodiscard]] int find_input(std::int64_t number) const { return place_of(inputs, number); }
  [[nodiscard]] int output_number(std::size_t place) const { return number_at(outputs, place); }
  [[nodiscard]] int find_output(std::int64_t number) const { return place_of(outputs, number); }
  [[nodiscard]] int find_action(std::string_view id) const {
    for (std::size_t i = 0; i < actions.size(); ++i)
      if (actions[i].id == id) return static_cast<int>(i);
    return -1;
  }
  [[nodiscard]] int find_readout(std::string_view id) const {
    for (std::size_t i = 0; i < readouts.size(); ++i)
      if (readouts[i].id == id) return static_cast<int>(i);
    return -1;
  }
  [[nodiscard]] int find_param(std::string_view mnemonic) const {
    for (std::size_t i = 0; i < params.size(); ++i)
      if (params[i].mnemonic == mnemonic) return static_cast<int>(i);
    return -1;
  }

 private:
  template <class Line>
  static int number_at(const std::vector<Line>& lines, std::size_t place) {
    return lines[place].number >= 0 ? lines[place].number : static_cast<int>(place) + 1;
  }
  template <class Line>
  static int place_of(const std::vector<Line>& lines, std::int64_t number) {
    for (std::size_t i = 0; i < lines.size(); ++i)
      if (number_at(lines, i) == number) return static_cast<int>(i);
    return -1;
  }
};

}  // namespace hw
