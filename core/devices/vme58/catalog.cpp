#include "core/devices/vme58/catalog.h"

#include <fmt/core.h>

#include "core/base/index.h"
#include "core/devices/vme58/board_options.h"
#include "core/devices/vme58/codec.h"
#include "core/devices/vme58/parameters.h"

namespace hw::vme58 {
namespace {

OptionInfo jumpers_option() {
  OptionInfo jumpers{"jumpers", {}};
  for (const char* groups : {"IIO", "III", "OIO", "IOO", "OOO", "OII", "IOI", "OOI"}) {
    std::string inputs;
    for (int g = 0; g < 3; ++g)
      if (groups[g] == 'I')
        inputs += fmt::format("{}{}-{}", inputs.empty() ? "" : ", ", g * lines_of_a_group,
                              (g + 1) * lines_of_a_group - 1);
    jumpers.choices.emplace_back(groups, inputs.empty() ? fmt::format("{}: no inputs", groups)
                                                        : fmt::format("{}: inputs {}", groups, inputs));
  }
  return jumpers;
}

std::vector<OptionInfo> options() {
  OptionInfo variant{"variant", {}};
  for (const Variant& v : variants) {
    std::string what;
    if (v.servos > 0) what = fmt::format("{} servo", v.servos);
    if (v.steppers > 0) what += fmt::format("{}{} step", what.empty() ? "" : ", ", v.steppers);
    if (v.encoders > v.servos) what += " with encoder";
    variant.choices.emplace_back(v.name, fmt::format("{}: {}", v.name, what));
  }
  return {variant, jumpers_option()};
}

std::vector<AxisInfo> axes(const Variant& variant) {
  std::vector<AxisInfo> all;
  for (int i = 0; i < variant.axes(); ++i) {
    const AxisFitting fitting = variant.fitting(i);
    AxisInfo axis;
    axis.name = axis_letters.substr(ix(i), 1);
    axis.description =
        fmt::format("{} axis {}", fitting.kind == AxisKind::servo ? "servo" : "step", axis.name);
    axis.switchable = axis.servo = fitting.kind == AxisKind::servo;
    axis.home_input = true;
    all.push_back(std::move(axis));
  }
  return all;
}

bool is_output(std::uint16_t outputs, int line) { return (outputs >> line & 1) != 0; }

/// Direction of a line and of the adjacent lines with the same direction.
std::string direction_of(std::uint16_t outputs, int line) {
  const bool out = is_output(outputs, line);
  int first = line, last = line;
  while (first > 0 && is_output(outputs, first - 1) == out) --first;
  while (last + 1 < io_lines && is_output(outputs, last + 1) == out) ++last;
  return fmt::format("Lines {} to {}: {}", first, last, out ? "outputs" : "inputs");
}

/// Why a line has its direction.
std::string reason_of_direction(std::uint16_t outputs, int line) {
  const std::string_view way = is_output(outputs, line) ? "an output" : "an input";
  if (line >= first_fixed_output) return "always an output";
  const int first = line / lines_of_a_group * lines_of_a_group;
  return fmt::format("{} by the jumper of lines {} to {}", way, first, first + lines_of_a_group - 1);
}

std::vector<InputInfo> inputs(std::uint16_t outputs) {
  std::vector<InputInfo> all;
  for (int line = 0; line < io_lines; ++line) {
    InputInfo input;
    input.of_output = is_output(outputs, line);
    input.name = fmt::format("{} {}", input.of_output ? "Line" : "In", line);
    input.help = fmt::format("General line {}, {}. {}", line, reason_of_direction(outputs, line),
                             input.of_output ? "The level on this line." : "SW and WS treat low as true.");
    input.active_low = true;
    input.number = line;
    input.group = direction_of(outputs, line);
    all.push_back(std::move(input));
  }
  return all;
}

std::vector<OutputInfo> output_infos(std::uint16_t outputs, const Variant& variant) {
  std::vector<OutputInfo> all;
  for (int line = 0; line < io_lines; ++line) {
    if (!is_output(outputs, line)) continue;
    OutputInfo output;
    output.name = fmt::format("Out {}", line);
    output.help = fmt::format("General line {}, {}: BL{} switches it on (low), BH{} off (high).", line,
                              reason_of_direction(outputs, line), line, line);
    output.number = line;
    output.group = direction_of(outputs, line);
    all.push_back(std::move(output));
  }
  for (int i = 0; i < variant.axes(); ++i) {
    OutputInfo output;
    const std::string_view letter = axis_letters.substr(ix(i), 1);
    output.name = fmt::format("Aux {}", letter);
    output.help = fmt::format(
        "Auxiliary output of {}: AN switches it on (high), AF off; PA lets moves switch it. The board does "
        "not report its state: the last state set from the console is shown.",
        letter);
    output.number = first_auxiliary + i;
    output.group = "Auxiliary: outputs";
    output.on_the_way = true;
    all.push_back(std::move(output));
  }
  return all;
}

Capabilities capabilities() {
  Capabilities can;
  can.reset = true;
  can.interpolates = true;
  can.window = true;
  can.memory_map = true;
  can.contours = true;
  can.usual_baud = 0;
  return can;
}

// ---- actions

ActionField field(std::string id, std::string label, std::string unit, std::int64_t minimum,
                  std::int64_t maximum, std::int64_t fallback, int decimals = 0) {
  ActionField f;
  f.id = std::move(id), f.label = std::move(label), f.unit = std::move(unit);
  f.minimum = minimum, f.maximum = maximum, f.fallback = fallback, f.decimals = decimals;
  return f;
}

template <class Fits>
ActionField axis_field(const Variant& variant, Fits fits) {
  ActionField f = field("axis", "Axis", "", 0, 0, 0);
  for (int i = 0; i < variant.axes(); ++i)
    if (fits(variant.fitting(i))) f.choices.push_back({i, std::string(axis_letters.substr(ix(i), 1))});
  if (f.choices.empty()) return f;
  f.minimum = f.fallback = f.choices.front().value;
  f.maximum = f.choices.back().value;
  return f;
}

ActionField switch_field() {
  ActionField f = field("on", "State", "", 0, 1, 1);
  f.choices = {{1, "on"}, {0, "off"}};
  return f;
}

ActionInfo action(std::string id, std::string label, std::string help, std::string group,
                  std::vector<ActionField> fields, std::string manual) {
  ActionInfo a;
  a.id = std::move(id), a.label = std::move(label), a.help = std::move(help), a.group = std::move(group);
  a.fields = std::move(fields), a.manual = std::move(manual);
  a.while_busy = true;
  return a;
}

// In the order of enum Action. Actions that need an encoder come last: a board without encoders has none of
// them.
std::vector<ActionInfo> actions(const Variant& variant) {
  const auto any = [](const AxisFitting&) { return true; };
  const auto encoder = [](const AxisFitting& f) { return f.encoder; };
  auto position = field("position", "Position", "counts", -position_max, position_max, 0);
  position.is_place = true;
  std::vector<ActionInfo> all;
  all.push_back(action("clear_flags", "Clear flags",
                       "IC: clears the done, slip and command error flags of all axes.", "Flags", {},
                       "Move Synchronization"));
  all.push_back(action("flush", "Empty queue",
                       "FL: drops the commands in the axis' queue. A moving axis goes on at its present "
                       "speed until it is stopped.",
                       "Queues", {axis_field(variant, any)}, "Move Execution"));
  all.back().moves = true;
  all.push_back(
      action("fraction_jog", "Jog slowly",
             "JF: runs the axis at a fractional speed, for very slow motion, until it is stopped.", "Motion",
             {axis_field(variant, any),
              field("speed", "Speed", "counts/s", -velocity_max * 1000, velocity_max * 1000, 500, 3)},
             "Move Execution"));
  all.back().moves = true;
  all.push_back(action(
      "remainder", "Remainder",
      "RM: divides the position and the encoder count by this number and keeps the remainders, for axes that "
      "turn endlessly.",
      "Motion", {axis_field(variant, any), field("divisor", "Divisor", "counts", 1, position_max, 4000)},
      "Move Specification"));
  all.push_back(action("clear_while", "End WH loop", "CW: the WH loop of this axis ends at its next WG.",
                       "Queues", {axis_field(variant, any)}, "Loop Control"));
  all.push_back(action("force_position", "Stop near",
                       "FP: empties the queue and comes to rest as near to this position as the ramp allows.",
                       "Motion", {axis_field(variant, any), position}, "Velocity Staircase"));
  all.back().moves = true;
  if (variant.encoders == 0) return all;
  all.push_back(
      action("encoder_ratio", "Encoder ratio",
             "ER: the ratio of encoder counts to motor counts, for position hold of a step axis.", "Encoder",
             {axis_field(variant, encoder), field("encoder", "Encoder counts", "", 1, position_max, 1),
              field("motor", "Motor counts", "", 1, position_max, 1)},
             "Encoder"));
  all.push_back(action(
      "hold", "Hold",
      "HN: holds the position of a step axis, or closes the loop of a servo axis. HF: the opposite; it "
      "also ends slip watch and tracking.",
      "Encoder", {axis_field(variant, encoder), switch_field()}, "Encoder"));
  all.push_back(action("track", "Track encoder",
                       "ET: the axis follows the count of its encoder input, until HF.", "Encoder",
                       {axis_field(variant, encoder)}, "Encoder"));
  all.back().moves = true;
  all.push_back(action("slip_interrupt", "Interrupt on slip",
                       "IS: a slip of this axis may interrupt the host.", "Encoder",
                       {axis_field(variant, encoder)}, "Encoder"));
  return all;
}

ReadoutInfo readout(std::string_view letters, std::string_view label, int axis, Group group,
                    const char* help) {
  ReadoutInfo r;
  const char letter = axis_letters[ix(axis)];
  r.id = fmt::format("{}{}", letters, letter);
  r.label = fmt::format("{} of {}", label, letter);
  r.group = group;
  r.axis = axis;
  r.help = help;
  return r;
}

// Readouts of one kind stand together: a table shows them as a column.
void add_readouts(Catalog& c, const Variant& variant) {
  c.readout_groups = {"Flags", "Queues", "Memory map", "Loops"};
  c.memory_readout_group = memory_group;
  for (int i = 0; i < variant.axes(); ++i) {
    if (!variant.fitting(i).encoder) continue;
    ReadoutInfo slip = readout(
        "SLIP", "Slip", i, flag_group,
        "Set when encoder and position differ by more than ES; the console clears it with the flags.");
    slip.words = {{0, "none"}, {1, "slipped"}};
    slip.bad = {1};
    c.readouts.push_back(std::move(slip));
  }
  for (int i = 0; i < variant.axes(); ++i)
    c.readouts.push_back(readout("RQ", "Free places in the queue", i, queue_group,
                                 "RQ: empty entries of the axis' queue. The commands in the queue are "
                                 "carried out one after the other."));
  for (int i = 0; i < variant.axes(); ++i) {
    if (variant.fitting(i).kind != AxisKind::servo) continue;
    ReadoutInfo loop =
        readout("HN", "Servo loop", i, loop_group, "EA: whether the loop of the axis is closed.");
    loop.words = {{0, "off"}, {1, "on"}};
    c.readouts.push_back(std::move(loop));
  }
}

/// Sets the values that the data sheet leaves open (decision M47).
void set_factory_values(std::vector<ParamInfo>& params, const BoardOptions& board) {
  for (ParamInfo& p : params) {
    const std::string_view letters = std::string_view(p.mnemonic).substr(0, 2);
    if (letters == "VL") p.fallback = board.velocity;
    if (letters == "AC") p.fallback = board.acceleration;
    if (letters == "VB") p.fallback = board.base_velocity;
  }
}

}  // namespace

Result<Catalog> make_catalog(const DeviceOptions& options_given) {
  const auto board = read_board_options(options_given);
  if (!board) return fail(board.error());
  const Variant& variant = *board->variant;
  Catalog c;
  for (const auto& option : options_given)
    if (is_board_option(option.first)) c.made_from.insert(option);
  c.model = "vme58";
  c.name = fmt::format("Oregon Micro Systems VME58-{}", variant.name);
  c.short_name = "VME58";
  c.summary = "VME, up to 8 servo or step axes";
  c.step_word = "counts";
  c.options = options();
  c.axes = axes(variant);
  c.homing_modes = {{"home", "to the home switch, 0 at its edge", "HM"},
                    {"home-return", "to the home switch, then back onto its edge", "HR"},
                    {"kill", "to the home switch, stop without a ramp, count kept", "KM", false}};
  c.inputs = inputs(board->outputs);
  c.outputs = output_infos(board->outputs, variant);
  c.params = param_infos(variant);
  set_factory_values(c.params, *board);
  c.actions = actions(variant);
  add_readouts(c, variant);
  add_axis_tables(c);
  c.stopping_way = stopping_way;
  add_memory_map(c, variant);
  c.queue_depth = queue_entries;
  c.contour_size = board->contour_size;
  c.commands = command_help();
  c.command_separators = " ;";
  c.program.slots = 1;
  c.program.slot_word = "Program";
  c.program.capacity = 0;  // the board keeps no programs: a run feeds the text into its ring
  c.program.capacity_unit = "characters";
  c.program.file_suffix = ".vme";
  c.program.comment = '#';
  c.program.example =
      "# X and Y go together in a straight line, then Z out and back\n"
      "AA VL20000,20000,20000; AC200000,200000,200000;\n"
      "LP0,0,0;\n"
      "ML30000,10000; GO ID\n"
      "MT,,-20000; GO ID\n"
      "MT,,0; GO ID\n"
      "ML-30000,-10000; GO ID\n";
  c.bench.panel_title = "VME58";
  c.can = capabilities();
  c.can.servo_tuning = variant.servos > 0;
  c.servo_update = board->servo_update;
  c.jog_speed = Pps{2000};
  c.jog_speed_min = Pps{1};
  c.jog_speed_max = Pps{static_cast<double>(velocity_max)};
  c.position_min = Steps{-position_max};
  c.position_max = Steps{position_max};
  c.move_max = Steps{distance_max};
  return c;
}

bool recognises(std::string_view reply) { return reply.find("VME58") != reply.npos; }

}  // namespace hw::vme58
