#pragma once
// A controller described in data. Setup, I/O, jog, status, terminal completion and help are drawn from it;
// panels know no device by name. Built once per open controller (its options may change the number of axes),
// immutable afterwards, read by any thread.
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/base/units.h"
#include "core/device/jog_guard.h"
#include "core/time/clock.h"

namespace hw {

struct AxisTarget;
struct Snapshot;

struct AxisInfo {
  std::string name;          ///< the maker's: "1", "X"
  std::string description;   ///< "motor 1"
  bool switchable = false;   ///< its motor current can be switched: intent::SetPower
  bool encoder = false;      ///< has a counter of its own that can be set: intent::SetEncoder
  bool home_input = false;   ///< tells whether it stands on its home switch: AxisState::home
  bool alarm_input = false;  ///< of its motor's driver: AxisState::alarm
  bool servo = false;        ///< its position is its encoder's: AxisState::loop, AxisState::command
};

/// A ready-made conversion from steps to a real unit (lead screws, rotary tables).
struct UnitChoice {
  std::string label;  ///< "BiSlide E04, 0.4 inch a turn"
  std::string unit;   ///< "mm", "inch", "°"
  double per_step;    ///< units per step
  int decimals;       ///< that one step needs
};

struct HomingMode {
  std::string id;             ///< for scripts: "limit"
  std::string label;          ///< "to the limit switch"
  std::string maker = {};     ///< the maker's word for it, where it has one: "ZH"
  bool sets_position = true;  ///< the count is set where it ends
};

struct InputInfo {
  std::string name;  ///< "In 1"
  std::string help;
  bool active_low = true;
  int number = -1;         ///< the maker's; -1: its place, from 1 (see Catalog::input_number)
  std::string group = {};  ///< over those that stand together and have the same: "Lines 0 to 7: inputs"
  bool of_output = false;  ///< the level of a line that is an output: shown with the outputs of its group
};
/// What the controller itself uses an output for at times: "In position".
struct OutputDuty {
  std::string name;                         ///< empty: the output has no duty
  std::vector<std::string> while_not_zero;  ///< on duty while none of these parameters and readouts is 0
};
struct OutputInfo {
  std::string name;  ///< "Out 1"
  std::string help;
  bool settable = true;
  OutputDuty duty = {};
  int number = -1;          ///< the maker's; -1: its place, from 1 (see Catalog::output_number)
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
  std::string mnemonic;     ///< what stands between set/get and the value: "j1M", "DM", "HSX"
  std::string label;        ///< "First jog speed of motor 1"
  std::string explanation;  ///< for somebody who has not read the manual
  std::string unit;         ///< "steps/s" or empty
  std::string group;        ///< heading in Setup
  std::int64_t minimum = 0, maximum = 0, fallback = 0;  ///< fallback: the factory value
  std::vector<ParamChoice> choices;                     ///< not empty: exactly these values
  std::vector<std::string> short_choices;               ///< the same in a word each, for a narrow column
  std::vector<ParamBit> bits;                           ///< not empty: a bit field
  int decimals = 0;        ///< the value counts the last of so many decimals: 0.800 is 800
  std::string prefix;      ///< of a name that ends in a number: 4EX07 is 7 with prefix "4EX" ...
  int digits = 0;          ///< ... and 2 digits
  bool also_zero = false;  ///< 0 is allowed too and switches it off (range starts above)
  bool stored = true;      ///< kept by Store
  bool readable = true;
  int axis = -1;
  bool of_move_buffer = false;                ///< shown beside the list of moves too
  std::string warning;                        ///< not empty: asked before it is written, naming the axis ...
  std::optional<std::int64_t> harmless = {};  ///< ... but for this value
  std::string manual;                         ///< "Appendix H"
  /// Not empty: said before the first move of its axis while the value is `unset_value`: why, and what to do.
  std::string before_moving;
  std::int64_t unset_value = 0;
  /// Its unit is in Catalog::step_word and becomes Catalog::loop_word when the loop of its axis is closed;
  /// without an axis, when all are.
  bool follows_loop = false;
  /// The greater it is, the harder the loop of its servo axis drives towards the command: intent::Closing.
  bool drives = false;

  [[nodiscard]] bool accepts(std::int64_t v) const {
    if (!choices.empty()) {
      for (const ParamChoice& c : choices)
        if (c.value == v) return true;
      return false;
    }
    return (v >= minimum && v <= maximum) || (also_zero && v == 0);
  }
};

/// A value beside positions and inputs that the controller tells: a state, a counter, a latched position.
struct ReadoutInfo {
  std::string id;     ///< the maker's word for it: "SLSX"
  std::string label;  ///< "StepNLoop of X"
  int group = 0;      ///< index into Catalog::readout_groups
  int axis = -1;
  std::string unit;
  std::vector<ParamChoice> words;  ///< not empty: what the values mean
  std::vector<std::int64_t> bad;   ///< values that are faults
  bool for_scripts = false;        ///< a bare number that tells a person nothing: not drawn in Control
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
  bool is_place = false;             ///< a position that an axis is sent by: it takes the count for true
  bool for_all_rows = false;         ///< in an AxisTable one value for all axes, under the tables
  int of_axis = -1;  ///< whose value it is; -1: of what is chosen in the field "axis", else of the only one
};
/// Something the controller can be told to do that is no verb of all controllers: intent::Act. Drawn as a
/// button with its fields.
struct ActionInfo {
  std::string id;     ///< path: "arc", "latch_on"
  std::string label;  ///< on the button: "Draw arc"
  std::string help;
  std::string group;            ///< heading; may be a readout group's, whose values then stand beside it
  bool moves = false;           ///< starts or changes motion
  bool while_busy = false;      ///< makes sense while a motion or program runs
  bool of_move_buffer = false;  ///< shown beside the list of moves too
  bool is_arc =
      false;  ///< of the first two axes: its fields are the centre and the way round, + against the clock
  bool follows_analog = false;  ///< its axis follows an analog input: they are shown with it
  std::string sets = {};        ///< the readout that shows what it has done ...
  std::int64_t sets_to = 0;     ///< ... and its value then; those of one readout are a choice
  std::vector<ActionField> fields;
  std::string manual;
  /// The outermost places of its way with these values from where the axes stand; null: its places are all.
  std::vector<AxisTarget> (*reaches)(const Snapshot& now, const std::vector<std::int64_t>& values) = nullptr;
};

/// A column of an AxisTable: what stands in the row of each axis. Of axes for which nothing of that id is in
/// the catalog the cell is empty.
struct AxisColumn {
  enum class Shows : std::uint8_t {
    motion,   ///< what the axis does, its speed, and the action `id` that clears the error that holds it
    readout,  ///< its words or number
    param,    ///< its value, that is written as soon as it is chosen or typed
    toggle,   ///< a param that is 0 or 1, or the action that switches with a field "on", as a lamp
    action,   ///< the action: its fields and its button; one that switches has two verbs
  };
  Shows shows = Shows::readout;
  std::string id;     ///< '*' is the name of the axis, or nothing: "LT*S"
  std::string title;  ///< over the column; empty: the label of what stands there
  std::string state =
      {};  ///< id of what is not 0 while it is on: a readout, a param, or bit n of a param of all
  std::string verb_on = {}, verb_off = {};  ///< on the button of an action; empty: its label
  bool while_moving = false;                ///< only an axis that moves can be told so
  /// Of a param: it means something only while the param `state` is `state_for`; else `otherwise` stands
  /// there.
  std::int64_t state_for = 0;
  std::string otherwise = {};
};
/// A table of the Control panel with a row per axis. What stands in one stands nowhere else there.
struct AxisTable {
  std::string title;
  std::string note = {};  ///< at the right of the title: "on DI1 to DI4"
  std::vector<AxisColumn> columns;
};

/// Numbered variables of the controller's programs.
struct VariableFacts {
  int count = 0;             ///< 0: none
  std::string prefix = "V";  ///< V0, V1 ...
  int stored_from = 0;       ///< from this number on kept by Store
  int readout_group = -1;    ///< watched as this group
  std::int64_t minimum = 0, maximum = 0;
};

/// Moves that the console can feed into a buffer of the controller, one after the other: intent::FeedMoves.
struct MoveListFacts {
  std::vector<ActionField> columns;  ///< empty: no such buffer
  int depth = 0;                     ///< places in the buffer
  int readout_group = -1;            ///< what the buffer tells of itself
  std::string file_suffix;
};

struct CommandInfo {
  /// "SmMx": a letter where the example has digits stands for a number. "J[axis][+/-]", "DO[1-8]=[value]":
  /// a bracket stands for an axis name, a sign, a number or a value.
  std::string form;
  std::string example;  ///< "S1M500"
  std::string help;     ///< "speed of motor m, 1 to 6000 steps/s"
  bool moves = false;   ///< Enter would (or might) move something now
  bool stored = false;  ///< goes into the program, does nothing now
  std::string manual;
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
/// A ring of characters in such a window, one to a cell of two bytes.
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
  int threads = 0;            ///< > 0: programs that run at once, all of them in the text of slot 0
  bool compiled = false;      ///< what is stored is not the text: View shows the listing
  std::string file_suffix;    ///< ".vxm"
  char comment = ';';
  std::string example;  ///< a short one that shows the language and ends by itself: the demo begins with it
};

/// What can be chosen before a controller is opened or its emulator started: key=value of an address.
struct OptionInfo {
  std::string key;  ///< "motors"
  std::vector<std::pair<std::string, std::string>>
      choices;  ///< value and label: "4", "4 motors"; first: usual
};

enum class LampColour : std::uint8_t { green, yellow, red };
struct BenchButton {
  std::string name;  ///< "Run", "1-"
  bool moves = false;
  int row = 0;               ///< on its front panel
  int supply = 0;            ///< on whose front panel
  bool stops = false;        ///< a Stop: drawn as one
  std::string caption = {};  ///< over it and its neighbours of the same caption: "Motor 1"
};
struct BenchLamp {
  std::string name;
  LampColour colour;
  int supply = 0;
};
/// A box on the bench with a power switch of its own.
struct BenchSupply {
  std::string name;      ///< of a second box beside the device: "Slave"; empty: the device itself
  bool breaker = false;  ///< it has a circuit breaker that is pushed in by hand
};
/// What can be done to the emulated device by hand.
struct BenchFacts {
  std::string panel_title;  ///< "VXM front panel"
  std::vector<BenchSupply> supplies{BenchSupply{}};
  std::vector<BenchButton> buttons;
  std::vector<BenchLamp> lamps;
};

struct Capabilities {
  bool single_step = false;        ///< Pause, Resume, SingleStep
  bool outputs_while_held = true;  ///< they can be switched while a program is held
  bool stop_clears_outputs = false;
  bool store = false;           ///< non-volatile memory with a limited write life
  std::int32_t store_life = 0;  ///< writes
  bool one_axis_at_a_time = false;
  bool homes = true;
  bool reset = false;
  bool interpolates = false;  ///< moves several axes together on a straight line
  bool arcs = false;          ///< moves its first two axes along an arc, from rest to rest
  bool broadcast = false;     ///< takes text meant for all devices of a wire, without replies
  bool usb = false;           ///< has a USB wire of its own, beside any serial line
  bool window = false;        ///< a board in a memory window on a bus: no serial line at all
  bool memory_map = false;    ///< its window is described in Catalog::memory and shown in Snapshot::window
  bool contours = false;      ///< paths at constant velocity that are recorded and then played
  bool servo_tuning = false;  ///< has servo axes whose gains can be tuned: intent::Sample, Session::samples()
  int usual_baud = 9600;
  std::vector<int> bauds;
};

struct Catalog {
  std::string model;       ///< "vxm": as in an address
  int address = -1;        ///< by which this one device is spoken to on a shared line; -1: it has none
  std::string name;        ///< "Velmex VXM"
  std::string short_name;  ///< "VXM"
  std::string summary;     ///< "stepping motors, 2 or 4"
  std::string step_word = "steps";
  std::string loop_word;  ///< of an axis whose AxisState::in_counts is set: "counts"
  std::vector<OptionInfo> options;
  std::map<std::string, std::string> made_from;  ///< options of the address that make it another than usual
  std::vector<AxisInfo> axes;
  std::vector<UnitChoice> units;
  std::vector<HomingMode> homing_modes;
  std::vector<InputInfo> inputs;
  std::vector<OutputInfo> outputs;
  std::vector<AnalogInfo> analog;
  int analog_readout_group = -1;  ///< asked for while analog inputs are shown large; -1: they are polled
  std::vector<ParamInfo> params;
  std::vector<std::string> readout_groups;
  std::vector<ReadoutInfo> readouts;
  std::vector<ActionInfo> actions;
  std::vector<AxisTable> axis_tables;
  VariableFacts variables;
  MoveListFacts move_list;
  std::vector<MemoryCell> memory;  ///< where Capabilities::memory_map
  std::vector<MemoryRing> memory_rings;
  int memory_readout_group = -1;  ///< watched while the window is shown: its rings are read then too
  Duration servo_update{};        ///< of the servo loops, where Capabilities::servo_tuning
  int queue_depth = 0;            ///< entries of each axis' command queue (Snapshot::queue_free); 0: none
  int contour_size = 0;           ///< entries of a contour, where Capabilities::contours
  std::vector<CommandInfo> commands;
  std::string command_separators;  ///< characters between the commands of one line; empty: one command a line
  ProgramFacts program;
  /// How far an axis that moves still goes if it is stopped now, with its ramp, as far as its set-up is
  /// known.
  std::optional<double> (*stopping_way)(const Catalog& catalog, const Snapshot& now, AxisId axis) = nullptr;
  JogGuardFacts jog_guard;
  BenchFacts bench;
  Capabilities can;
  Pps jog_speed{2000}, jog_speed_min{1}, jog_speed_max{6000};
  Steps position_min{}, position_max{}, move_max{};

  /// Several of its kind can share a wire.
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
  /// The maker's number of the input at `place`, from 0, and back; -1: there is none.
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
