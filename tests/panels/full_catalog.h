#pragma once
// A controller that has everything a catalog can describe: four switchable axes with encoders, readouts,
// actions with fields, variables, threads, buffered moves, broadcast. No device: what panels must manage.
#include "core/device/catalog.h"

namespace hw::test {

inline ReadoutInfo full_readout(const char* id, const char* label, int group, int axis = -1,
                                const char* unit = "") {
  ReadoutInfo r;
  r.id = id, r.label = label, r.group = group, r.axis = axis, r.unit = unit;
  return r;
}

inline ActionField full_field(const char* id, const char* label, std::int64_t low, std::int64_t high,
                              std::int64_t fallback, const char* unit = "", int decimals = 0) {
  ActionField f;
  f.id = id, f.label = label, f.unit = unit;
  f.minimum = low, f.maximum = high, f.fallback = fallback, f.decimals = decimals;
  return f;
}

inline ActionField full_axis_field(bool all = false) {
  ActionField f = full_field("axis", "Axis", all ? -1 : 0, 3, all ? -1 : 0);
  if (all) f.choices.push_back({-1, "all axes"});
  for (int i = 0; i < 4; ++i) f.choices.push_back({i, std::string(1, "XYZU"[i])});
  return f;
}

inline ActionField full_switch_field() {
  ActionField f = full_field("on", "State", 0, 1, 1);
  f.choices = {{1, "on"}, {0, "off"}};
  return f;
}

inline ActionInfo full_action(const char* id, const char* label, const char* group,
                              std::vector<ActionField> fields, bool moves = false, bool while_busy = false) {
  ActionInfo a;
  a.id = id, a.label = label, a.group = group, a.fields = std::move(fields);
  a.help = std::string(label) + ", explained.";
  a.moves = moves, a.while_busy = while_busy;
  return a;
}

inline void add_full_readouts(Catalog& c) {
  c.readout_groups = {"Motion", "StepNLoop", "Latches", "Variables", "Buffer", "Analog inputs"};
  ReadoutInfo mode = full_readout("MM", "Move mode", 0);
  mode.words = {{0, "absolute"}, {1, "incremental"}};
  c.readouts.push_back(mode);
  c.readouts.push_back(full_readout("TR", "Timer", 0, -1, "ms"));
  const auto for_each_axis = [&](const char* id, const char* label, int group, const char* unit,
                                 std::vector<ParamChoice> words, std::vector<std::int64_t> bad) {
    for (int i = 0; i < 4; ++i) {
      const std::string letter(1, "XYZU"[i]);
      ReadoutInfo r =
          full_readout((id + letter).c_str(), (label + (" of " + letter)).c_str(), group, i, unit);
      r.words = words, r.bad = bad;
      c.readouts.push_back(r);
    }
  };
  for_each_axis("SLS", "State", 1, "", {{0, "idle"}, {1, "moving"}, {10, "stalled"}}, {10});
  for_each_axis("DX", "Difference", 1, "counts", {}, {});
  for_each_axis("LTS", "Latch", 2, "", {{0, "off"}, {1, "waiting"}, {2, "captured"}}, {});
  for_each_axis("LTP", "Captured position", 2, "pulses", {}, {});
  c.readouts.push_back(full_readout("BUFFREE", "Free places", 4));
}

inline void add_full_actions(Catalog& c) {
  c.actions = {
      full_action("clear", "Clear errors", "Motion", {full_axis_field(true)}),
      full_action("absolute", "Absolute mode", "Motion", {}),
      full_action("incremental", "Incremental mode", "Motion", {}),
      full_action("change_speed", "Change speed now", "Change during a move",
                  {full_axis_field(), full_field("speed", "New speed", 1, 6'000'000, 1000, "pulses/s"),
                   full_field("accel", "In", 0, 30'000, 0, "ms")},
                  true, true),
      full_action("arc", "Draw arc", "Arcs and circles",
                  {full_field("centre_x", "Centre X", -134'217'728, 134'217'727, 0, "pulses"),
                   full_field("centre_y", "Centre Y", -134'217'728, 134'217'727, 0, "pulses"),
                   full_field("end_angle", "End angle", -3'600'000, 3'600'000, 180'000, "°", 3)},
                  true),
      full_action("latch", "Latch", "Latches", {full_axis_field(), full_switch_field()}, false, true),
      full_action("buffer_on", "Buffered mode on", "Buffer", {}),
      full_action("buffer_off", "Buffered mode off", "Buffer", {}, false, true),
      full_action("joystick", "Joystick", "Joystick", {full_axis_field(), full_switch_field()}, true),
  };
  c.actions[3].fields[1].follows_loop = true;
  c.actions[4].fields[0].follows_loop = c.actions[4].fields[1].follows_loop = true;
  c.actions[4].fields[0].of_axis = 0, c.actions[4].fields[1].of_axis = 1;
  c.actions[6].of_move_buffer = c.actions[7].of_move_buffer = true;
  c.actions[8].follows_analog = true;
}

inline Catalog full_catalog() {
  Catalog c;
  c.model = "full", c.name = "Full Controller", c.short_name = "FULL", c.summary = "everything";
  c.step_word = "pulses", c.loop_word = "counts";
  for (int i = 0; i < 4; ++i) {
    const std::string letter(1, "XYZU"[i]);
    c.axes.push_back({letter, "axis " + letter, true, true, true, true});
  }
  c.homing_modes = {{"home", "onto the home switch"}, {"limit", "to the limit switch"}};
  for (int i = 1; i <= 8; ++i) c.inputs.push_back({"DI" + std::to_string(i), "digital input", false});
  for (int i = 1; i <= 8; ++i) c.outputs.push_back({"DO" + std::to_string(i), "digital output", true});
  for (int i = 1; i <= 8; ++i) c.analog.push_back({"AI" + std::to_string(i), "mV", 0, 5000});
  add_full_readouts(c);
  add_full_actions(c);
  c.variables.count = 100, c.variables.stored_from = 50, c.variables.readout_group = 3;
  c.variables.minimum = -2'147'483'647, c.variables.maximum = 2'147'483'647;
  c.move_list.columns = {full_field("x", "X", -134'217'728, 134'217'727, 0, "pulses"),
                         full_field("y", "Y", -134'217'728, 134'217'727, 0, "pulses"),
                         full_field("speed", "Speed", 1, 6'000'000, 1000, "pulses/s")};
  c.move_list.readout_group = 4, c.analog_readout_group = 5;
  c.move_list.depth = 36, c.move_list.file_suffix = ".moves";
  c.program.slots = 1, c.program.slot_word = "Program", c.program.capacity = 1275;
  c.program.capacity_unit = "lines", c.program.threads = 4, c.program.compiled = true;
  c.program.file_suffix = ".prg";
  c.can.store = true, c.can.interpolates = true, c.can.broadcast = true, c.can.usual_baud = 9600;
  c.can.bauds = {9600, 19200, 115200};
  c.jog_speed = Pps{1000};
  c.position_min = Steps{-134'217'728}, c.position_max = Steps{134'217'727};
  ParamInfo ratio;
  ratio.mnemonic = "SLRX", ratio.label = "Ratio of X", ratio.group = "StepNLoop", ratio.decimals = 3;
  ratio.minimum = 1, ratio.maximum = 999'999, ratio.fallback = 1000;
  ParamInfo name;
  name.mnemonic = "DN", name.label = "Device name", name.group = "Communication", name.prefix = "4EX";
  name.digits = 2, name.maximum = 99;
  ParamInfo ramps;
  ramps.mnemonic = "IACC", ramps.label = "Ramps between buffered moves", ramps.group = "Buffered moves";
  ramps.choices = {{0, "0: jump"}, {1, "1: ramp"}};
  ramps.maximum = 1, ramps.of_move_buffer = true;
  c.params = {ratio, name, ramps};
  return c;
}

}  // namespace hw::test
