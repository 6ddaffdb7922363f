#include "core/devices/arcus/catalog.h"

#include <algorithm>

#include <fmt/core.h>

#include "core/devices/arcus/guard_text.h"
#include "core/devices/arcus/stopping_way.h"

namespace hw::arcus {
namespace {

constexpr int usual_speed = 1000;  // pulses/s after power-up

std::string axis_letter(const Model& model, int axis) {
  return std::string(model.axis_letters.substr(static_cast<std::size_t>(axis), 1));
}

std::vector<InputInfo> input_infos(const Model& model) {
  std::vector<InputInfo> all;
  for (int n = 1; n <= model.inputs; ++n) {
    InputInfo input{fmt::format("DI{}", n), "Digital input. Programs can read it.", false};
    for (int axis = 0; axis < model.axes(); ++axis)
      if (model.latch_inputs[static_cast<std::size_t>(axis)] == n)
        input.help = fmt::format("Digital input; also captures the position of {} while its latch is on.",
                                 axis_letter(model, axis));
    all.push_back(std::move(input));
  }
  return all;
}

std::vector<OutputInfo> output_infos(const Model& model) {
  std::vector<OutputInfo> all;
  for (int n = 1; n <= model.outputs; ++n) {
    OutputInfo output{fmt::format("DO{}", n), "Digital output.", true};
    for (int axis = 0; axis < model.axes(); ++axis)
      if (model.sync_outputs[static_cast<std::size_t>(axis)] == n) {
        const bool several = model.axes() > 1;
        output.help =
            fmt::format("Digital output. While the sync output of {} is on, only the controller switches it.",
                        axis_letter(model, axis));
        output.duty.name = several ? "Sync " + axis_letter(model, axis) : "Sync output";
        output.duty.while_not_zero = {several ? fmt::format("SYN{}S", axis_letter(model, axis)) : "SYNS"};
      }
    all.push_back(std::move(output));
  }
  return all;
}

ReadoutInfo state_words(std::string label, std::vector<ParamChoice> words, std::string help) {
  ReadoutInfo r;
  r.label = std::move(label);
  r.words = std::move(words);
  r.help = std::move(help);
  return r;
}

}  // namespace

Catalog common_catalog(const Model& model, const Wording& wording) {
  Catalog c;
  c.model = model.name;
  c.short_name = model.title;
  c.step_word = "pulses";
  c.loop_word = "counts";
  for (int axis = 0; axis < model.axes(); ++axis)
    c.axes.push_back({axis_letter(model, axis), fmt::format("axis {}", axis_letter(model, axis)), true, true,
                      true, model.status.alarm != no_bit});
  c.homing_modes = {{"home", "onto the home switch, high speed"},
                    {"limit", "to the limit switch"},
                    {"home-index", "home switch, then encoder index"},
                    {"index", "encoder index only"},
                    {"home-high-low", "onto the home switch, high then low speed"}};
  c.inputs = input_infos(model);
  c.outputs = output_infos(model);
  for (int n = 1; n <= model.analog_inputs; ++n) c.analog.push_back({fmt::format("AI{}", n), "mV", 0, 5000});
  c.params = params(model, wording);
  c.jog_guard = guard_facts(model);
  c.stopping_way = stopping_way;
  c.readout_groups = {"Motion", "StepNLoop", "Latches", "Sync outputs", "Variables"};
  c.variables.count = variables;
  c.variables.stored_from = first_stored_variable;
  c.variables.readout_group = variable_values;
  c.variables.minimum = -max_number - 1;
  c.variables.maximum = max_number;
  c.program.slots = 1;
  c.program.slot_word = "Program";
  c.program.capacity = program_lines;
  c.program.capacity_unit = "lines";
  c.program.threads = model.programs;
  c.program.compiled = true;
  c.program.file_suffix = ".prg";
  c.can.store = true;
  c.can.interpolates = c.can.speed_along_path = model.axes() > 1;
  c.can.broadcast = model.broadcast >= 0;
  c.can.usual_baud = bauds.front().rate;
  for (const Baud& b : bauds) c.can.bauds.push_back(b.rate);
  c.jog_speed = Pps{usual_speed};
  c.jog_speed_min = Pps{1};
  c.jog_speed_max = Pps{static_cast<double>(max_speed)};
  c.position_min = Steps{position_min};
  c.position_max = Steps{position_max};
  c.move_max = Steps{position_max};
  return c;
}

std::vector<ParamChoice> axis_choices(const Model& model, bool all) {
  std::vector<ParamChoice> choices;
  if (all) choices.push_back({-1, "all axes"});
  for (int axis = 0; axis < model.axes(); ++axis) choices.push_back({axis, axis_letter(model, axis)});
  return choices;
}

ReadoutInfo value_readout(std::string label, std::string unit, std::string help) {
  ReadoutInfo r;
  r.label = std::move(label);
  r.unit = std::move(unit);
  r.help = std::move(help);
  return r;
}

ActionInfo make_action(std::string id, std::string label, std::string help, std::string group,
                       std::vector<ActionField> fields, std::string manual) {
  ActionInfo a;
  a.id = std::move(id);
  a.label = std::move(label);
  a.help = std::move(help);
  a.group = std::move(group);
  a.fields = std::move(fields);
  a.manual = std::move(manual);
  return a;
}

ActionField axis_field(const Model& model, bool all) {
  ActionField f;
  f.id = "axis";
  f.label = "Axis";
  f.choices = axis_choices(model, all);
  f.minimum = f.choices.front().value;
  f.maximum = f.choices.back().value;
  f.fallback = f.minimum;
  return f;
}

ActionField switch_field() {
  ActionField f;
  f.id = "on";
  f.label = "State";
  f.choices = {{1, "on"}, {0, "off"}};
  f.maximum = 1;
  f.fallback = 1;
  return f;
}

ActionField number_field(std::string id, std::string label, std::string unit, std::int64_t minimum,
                         std::int64_t maximum, std::int64_t fallback) {
  ActionField f;
  f.id = std::move(id);
  f.label = std::move(label);
  f.unit = std::move(unit);
  f.minimum = minimum;
  f.maximum = maximum;
  f.fallback = fallback;
  return f;
}

ActionField position_field(std::string id, std::string label, std::string unit) {
  ActionField f = number_field(std::move(id), std::move(label), std::move(unit), position_min, position_max);
  f.is_place = true;
  return f;
}

ActionField followed(ActionField field, int axis) {
  field.follows_loop = true;
  field.of_axis = axis;
  return field;
}

void add_readout(Catalog& catalog, Group group, std::string id, ReadoutInfo info) {
  info.id = std::move(id);
  info.group = group;
  catalog.readouts.push_back(std::move(info));
}

void add_readouts(Catalog& catalog, const Model& model, Group group, std::string_view form,
                  const ReadoutInfo& pattern) {
  for (int axis = 0; axis < model.axes(); ++axis) {
    std::string id(form);
    const bool several = model.axes() > 1;
    if (const auto a = id.find('a'); a != id.npos) id.replace(a, 1, several ? axis_letter(model, axis) : "");
    ReadoutInfo info = pattern;
    info.axis = axis;
    if (several) info.label += " of " + axis_letter(model, axis);
    add_readout(catalog, group, std::move(id), std::move(info));
  }
}

void add_common_readouts(Catalog& catalog, const Model& model) {
  ReadoutInfo word =
      value_readout("Status word", "", "The status bits as the controller sends them, in one number.");
  word.for_scripts = true;
  add_readouts(catalog, model, motion, "MSTa", word);
  add_readout(catalog, motion, "MM",
              state_words("Typed moves go", {{0, "absolute"}, {1, "incremental"}},
                          "Sets whether plain move commands in the terminal give a target or a distance. "
                          "Moves from the console restore this mode."));
  ReadoutInfo state = state_words("State",
                                  {{0, "idle"},
                                   {1, "moving"},
                                   {2, "correcting"},
                                   {3, "stopping"},
                                   {4, "aborting"},
                                   {5, "jogging"},
                                   {6, "homing"},
                                   {7, "homing on the index"},
                                   {8, "error too large at rest"},
                                   {9, "too many corrections"},
                                   {10, "stalled"},
                                   {11, "limit error"},
                                   {12, "not in use"},
                                   {13, "homing on the limit"}},
                                  "The state of StepNLoop. Errors stay until you clear them.");
  state.bad = {8, 9, 10, 11};
  add_readouts(catalog, model, loop, "SLSa", state);
  add_readouts(catalog, model, loop, "DXa",
               value_readout("Difference", "counts", "Target minus encoder: the counts still to go."));
  add_readouts(catalog, model, latches, "LTaS",
               state_words("Latch", {{0, "off"}, {1, "waiting"}, {2, "captured"}},
                           "An edge at its input captures both positions once."));
  add_readouts(
      catalog, model, latches, "LTaP",
      value_readout("Captured pulses", "pulses", "Position at the edge. Meaningless while StepNLoop is on."));
  add_readouts(catalog, model, latches, "LTaE",
               value_readout("Captured counts", "counts", "Position of the encoder at the edge."));
  add_readouts(catalog, model, sync_outputs, "SYNaS",
               state_words("Sync output", {{0, "off"}, {1, "waiting"}, {2, "has acted"}},
                           "Compares the encoder with the sync position. Its settings are in Setup; Store "
                           "does not keep them."));
}

namespace {

/// Adds the actions in the order in which the console shows them.
struct CommonActions {
  Catalog& catalog;
  const Model& model;
  std::string_view chapter;
  std::vector<ActionInfo>& actions = catalog.actions;

  [[nodiscard]] std::string where(const char* section) const {
    return fmt::format("{} {}", chapter, section);
  }
  [[nodiscard]] std::vector<ActionField> with_axis(bool all, std::vector<ActionField> rest) const {
    if (model.axes() > 1) rest.insert(rest.begin(), axis_field(model, all));
    return rest;
  }

  void add_errors_and_modes() {
    actions.push_back(
        make_action("clear", "Clear errors",
                    "Clears limit, alarm and StepNLoop errors. A switch that is still active acts "
                    "again at the next move.",
                    "Motion", with_axis(true, {}), where("Limits")));
    actions.push_back(make_action("absolute", "To a place",
                                  "Plain move commands in the terminal then give the target.", "Motion", {},
                                  where("Moves")));
    actions.back().sets = "MM";
    actions.push_back(make_action("incremental", "By a distance",
                                  "Plain move commands in the terminal then give the distance.", "Motion", {},
                                  where("Moves")));
    actions.back().sets = "MM";
    actions.back().sets_to = 1;
  }

  /// One field for the speed changes of all axes, as the ramp seldom differs from the set value.
  [[nodiscard]] ActionField accel_field() const {
    ActionField f = number_field("accel", "Ramp, 0: as set", "ms", 0, longest_ramp_ms(model));
    f.for_all_rows = true;
    return f;
  }

  void add_changes_under_way() {
    actions.push_back(make_action(
        "change_speed", "Change speed now",
        "Before the motion, choose a straight ramp and the window for speed changes (SSPDM in Setup). The "
        "speed can then be changed while the axis moves.",
        "Change during a move",
        with_axis(false, {followed(number_field("speed", "New speed", "pulses/s", 1, max_speed, 1000)),
                          accel_field()}),
        where("On-The-Fly Speed Change")));
    actions.back().while_busy = actions.back().moves = true;
    actions.push_back(
        make_action("change_target", "Change target now",
                    "Gives the running move of one axis a new target. The axis reverses if it has already "
                    "passed the target.",
                    "Change during a move",
                    with_axis(false, {followed(position_field("target", "New target", "pulses"))}),
                    where("On-The-Fly Target Position Change")));
    actions.back().while_busy = actions.back().moves = true;
  }

  void add_latches_and_sync() {
    actions.push_back(
        make_action("latch", "Latch",
                    "On: waits for an edge at the latch input and captures both positions, which are "
                    "set to 0 until then.",
                    "Latches", with_axis(false, {switch_field()}), where("Latch Inputs")));
    actions.back().while_busy = true;
    actions.push_back(
        make_action("sync", "Sync output",
                    "On: the sync condition switches the digital output. Off: you switch it again.",
                    "Sync outputs", with_axis(false, {switch_field()}), where("Sync Outputs")));
    actions.back().while_busy = true;
  }

  void add_programs() {
    actions.push_back(
        make_action("subroutine", "Run subroutine",
                    "Runs a stored subroutine beside the running programs. Only its own end or the power "
                    "switch ends it: Stop ends its present move, but its next line may start another.",
                    "Programs", {number_field("number", "Subroutine", "", 0, subroutines - 1)},
                    where("Standalone Programming")));
    actions.back().moves = actions.back().while_busy = true;
  }
};

}  // namespace

void add_common_actions(Catalog& catalog, const Model& model, std::string_view chapter) {
  CommonActions common{catalog, model, chapter};
  common.add_errors_and_modes();
  common.add_changes_under_way();
  common.add_latches_and_sync();
  common.add_programs();
}

void add_axis_tables(Catalog& catalog, const Model& model) {
  using Shows = AxisColumn::Shows;
  AxisColumn speed{Shows::action, "change_speed", "speed"};
  AxisColumn target{Shows::action, "change_target", "target"};
  speed.verb_on = "Change", target.verb_on = "Go";
  speed.while_moving = target.while_moving = true;
  AxisColumn arm{Shows::action, "latch", ""};
  arm.state = "LT*S", arm.verb_on = "Arm", arm.verb_off = "Disarm";
  AxisColumn watch{Shows::action, "sync", ""};
  watch.state = "SYN*S", watch.verb_on = "Watch", watch.verb_off = "Stop";
  catalog.axis_tables = {
      {"Motion", "", {{Shows::motion, "clear", "state"}}},
      {"StepNLoop",
       "",
       {{Shows::toggle, "SL*", ""}, {Shows::readout, "SLS*", "does"}, {Shows::readout, "DX*", "off by"}}},
      {"Change during a move", "", {speed, target}},
  };
  if (catalog.find_action("joystick") >= 0) {
    AxisColumn stick{Shows::toggle, "joystick", ""};
    stick.state = "JE";
    catalog.axis_tables.push_back({"Joystick", "", {stick}});
  }
  catalog.axis_tables.push_back(
      {"Latch",
       model.axes() == 1 ? std::string("on the latch input") : [&] {
         std::string inputs = "on";
         for (int axis = 0; axis < model.axes(); ++axis)
           inputs += fmt::format("{} DI{}", axis > 0 ? "," : "", model.latch_inputs[static_cast<std::size_t>(axis)]);
         return inputs;
       }(),
       {{Shows::readout, "LT*S", "state"},
        {Shows::readout, "LT*P", "place"},
        {Shows::readout, "LT*E", "encoder"},
        arm}});
  AxisColumn pulse{Shows::param, "SYN*T", "for, ms"};
  pulse.state = "SYN*C", pulse.state_for = 1, pulse.otherwise = "while so";  // 1: when equal
  const auto output = [&](int axis) { return model.sync_outputs[static_cast<std::size_t>(axis)]; };
  catalog.axis_tables.push_back(
      {"Sync output",
       model.axes() == 1 ? fmt::format("on the encoder, DO{}", output(0))
                         : fmt::format("on the encoder, DO{} to DO{}", output(0), output(model.axes() - 1)),
       {{Shows::readout, "SYN*S", "state"},
        {Shows::param, "SYN*C", "on when"},
        {Shows::param, "SYN*P", "position"},
        pulse,
        watch}});
}

std::vector<CommandInfo> commands_of(std::span<const CommandRow> rows) {
  std::vector<CommandInfo> all;
  for (const CommandRow& row : rows)
    all.push_back({row.form, row.example, row.help, row.moves, false, row.manual});
  return all;
}

}  // namespace hw::arcus
