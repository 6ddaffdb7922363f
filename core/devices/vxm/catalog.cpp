#include "core/devices/vxm/catalog.h"

#include <fmt/core.h>

#include "core/base/lengths.h"
#include "core/device/stopping_way.h"
#include "core/devices/vxm/facts.h"

namespace hw::vxm {
namespace {

// Manual p.11. Decimals: enough to tell two neighbouring steps apart.
std::vector<UnitChoice> units() {
  constexpr double mm = mm_per_inch;
  return {
      {"UniSlide C, P40 or BiSlide E25: 0.025 inch a turn", "inch", 0.0000625, 5},
      {"UniSlide C, P40 or BiSlide E25 in mm: 0.635 mm a turn", "mm", 0.0000625 * mm, 3},
      {"UniSlide B, P20 or BiSlide E50: 0.05 inch a turn", "inch", 0.000125, 4},
      {"UniSlide B, P20 or BiSlide E50 in mm: 1.27 mm a turn", "mm", 0.000125 * mm, 3},
      {"UniSlide W1, P10 or BiSlide E01: 0.1 inch a turn", "inch", 0.00025, 4},
      {"UniSlide W1, P10 or BiSlide E01 in mm: 2.54 mm a turn", "mm", 0.00025 * mm, 3},
      {"UniSlide W2, P5 or BiSlide E02: 0.2 inch a turn", "inch", 0.0005, 4},
      {"UniSlide W2, P5 or BiSlide E02 in mm: 5.08 mm a turn", "mm", 0.0005 * mm, 2},
      {"UniSlide W4, P2.5 or BiSlide E04: 0.4 inch a turn", "inch", 0.001, 3},
      {"UniSlide W4, P2.5 or BiSlide E04 in mm: 10.16 mm a turn", "mm", 0.001 * mm, 2},
      {"UniSlide K1, Q1 or BiSlide M01: 1 mm a turn", "mm", 0.0025, 3},
      {"UniSlide K2, Q2 or BiSlide M02: 2 mm a turn", "mm", 0.005, 3},
      {"Rotary table B4872: 5° a turn of the motor", "°", 0.0125, 2},
      {"Rotary table B4836: 10° a turn of the motor", "°", 0.025, 2},
      {"Rotary table B4818: 20° a turn of the motor", "°", 0.05, 2},
      {"Rotary table B5990: 4° a turn of the motor", "°", 0.01, 2},
      {"Turns of the motor, 400 steps each", "turns", 0.0025, 3},
  };
}

// In the order of inputs 1 to 8 in scripts and in the snapshot. The `~` byte carries the jog inputs in its
// low four bits and In 1 to In 4 in its high four (Appendix A).
std::vector<InputInfo> inputs() {
  return {
      {"In 1", "Programs wait for it (U0, U1, U30, U31, U50, U51) and branch on it (U11, U21). Pin 5.", true},
      {"In 2", "Branches (U12, U22), selects a program or the second jog speed. Pin 6.", true},
      {"In 3", "Ends a wait by a jump to program 3, or selects a program. Pin 7.", true},
      {"In 4", "Stop: the same line as the Stop button. Programs do not start while it is low. Pin 8.", true},
      {"Jog 1-", "Jogs motor 1 in the negative direction in Local mode. Pin 10 and the button.", true},
      {"Jog 1+", "Jogs motor 1 in the positive direction in Local mode. Pin 11 and the button.", true},
      {"Jog 2-", "Jogs motor 2 in the negative direction in Local mode. Pin 12 and the button.", true},
      {"Jog 2+", "Jogs motor 2 in the positive direction in Local mode. Pin 13 and the button.", true},
  };
}

std::vector<OutputInfo> outputs() {
  return {
      {"Out 1", "U5 switches it on, U4 off; PA, U1, U31 and U51 hold it on for their time. Pin 14.", true},
      {"Out 2", "U15 switches it on, U14 off; it also carries position pulses (U7, setP). Pin 15.", true},
      {"Out 3", "An option of the controller: U17 switches it on, U16 off.", true},
      {"Out 4", "An option of the controller: U19 switches it on, U18 off.", true},
  };
}

// In the order of the bits of a BenchView.
BenchFacts bench(int motors) {
  const std::size_t controllers = motors > motors_per_controller ? 2 : 1;
  BenchFacts b;
  b.panel_title = "VXM front panel";
  b.supplies = {{"", true}};
  if (controllers > 1) b.supplies.push_back({"Slave", true});
  for (std::size_t i = 0; i < controllers * buttons_per_controller; ++i) {
    const std::string_view name = panel_buttons[i];
    const bool jog = name.ends_with('-') || name.ends_with('+');
    b.buttons.push_back({std::string(name), jog || name.ends_with("Run"), jog ? 0 : 1,
                         static_cast<int>(i / buttons_per_controller), name.ends_with("Stop"),
                         jog ? fmt::format("Motor {}", name[name.size() - 2]) : std::string()});
  }
  for (std::size_t i = 0; i < controllers * lamps_per_controller; ++i)
    b.lamps.push_back({std::string(panel_lamps[i]), i % 2 ? LampColour::yellow : LampColour::green,
                       static_cast<int>(i / lamps_per_controller)});
  return b;
}

Capabilities capabilities() {
  Capabilities can;
  can.single_step = true;
  can.outputs_while_held = false;  // a run of a command needs K first, ...
  can.stop_clears_outputs = true;  // ... which switches them off
  can.store = true;
  can.store_life = store_life;
  can.one_axis_at_a_time = true;
  can.reset = true;
  can.usual_baud = bauds.front().rate;
  for (const Baud& b : bauds) can.bauds.push_back(b.rate);
  return can;
}

Result<int> motor_count(const DeviceOptions& options) {
  const auto found = options.find("motors");
  if (found == options.end()) return motors_per_controller;
  const std::string& text = found->second;
  if (text.size() == 1 && text[0] >= '1' && text[0] <= '0' + max_motors) return text[0] - '0';
  return fail(FaultKind::text, fmt::format("motors={} is not possible with a VXM.", text),
              "Nothing was opened.",
              "Give motors=1 or 2 for one controller, motors=3 or 4 for a Master with its Slave.");
}

}  // namespace

Result<Catalog> make_catalog(const DeviceOptions& options) {
  const auto motors = motor_count(options);
  if (!motors) return fail(motors.error());
  Catalog c;
  c.model = "vxm";
  c.name = "Velmex VXM";
  c.short_name = "VXM";
  c.summary = "stepping motors, 2 or 4";
  c.options = {{"motors", {{"2", "2 motors"}, {"4", "4 motors"}}}};
  if (const auto given = options.find("motors"); given != options.end()) c.made_from.insert(*given);
  for (int m = 1; m <= *motors; ++m) c.axes.push_back({fmt::format("{}", m), fmt::format("motor {}", m)});
  c.units = units();
  c.homing_modes = {{"limit", "to the limit switch", "", false},
                    {"limit-zero", "to the limit switch, and zero there"},
                    {"switch", "onto the home switch of a rotary table, and zero there"}};
  c.inputs = inputs();
  c.outputs = outputs();
  c.analog = {{"Analog", "counts", analog_min, analog_max}};
  c.params = params(*motors);
  c.commands = commands(*motors);
  c.command_separators = ",. ";
  c.program.slots = program_count;
  c.program.slot_word = "Program";
  c.program.capacity = program_bytes;
  c.program.capacity_unit = "bytes";
  c.program.file_suffix = ".vxm";
  c.program.example =
      "; Five strokes of motor 1, with a pulse on output 1 at the end of each\n"
      "S1M4000\n"
      "A1M4\n"
      "LM0\n"
      "U4\n"
      "I1M1600\n"
      "U5\n"
      "P2\n"
      "I1M-1600\n"
      "L5\n";
  c.bench = bench(*motors);
  c.can = capabilities();
  // The controller reports neither its speed nor its S and A: the values are those requested, seen, or in
  // force after power-up.
  c.stopping_way = stopping_way_by_ramp;
  c.jog_speed = Pps{default_speed};
  c.jog_speed_min = Pps{min_speed};
  c.jog_speed_max = Pps{max_speed};
  c.position_min = Steps{position_min};
  c.position_max = Steps{position_max};
  c.move_max = Steps{max_index};
  return c;
}

bool recognises(std::string_view reply) {
  while (!reply.empty() && (reply.front() == '^' || reply.front() == 'V')) reply.remove_prefix(1);
  if (reply.size() == 2 && reply.back() == '\r') reply.remove_suffix(1);
  return reply == "B" || reply == "R" || reply == "J" || reply == "b";
}

}  // namespace hw::vxm
