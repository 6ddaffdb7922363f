// Every parameter of the VXM that `set`, `get`, B and O reach. The mnemonic is the text between set/get and
// the value, so `B` is the baud rate (setB38). Backlash compensation, set by a bare B20, is called Bx, as in
// the manual's heading.
#include <fmt/core.h>

#include "core/devices/vxm/catalog.h"
#include "core/devices/vxm/facts.h"

namespace hw::vxm {
namespace {

std::vector<ParamChoice> motor_types() {
  return {{0, "0: default, 0.4 to 0.7 A (factory value)"},
          {1, "1: Vexta PK245 (1.2 A)"},
          {2, "2: Slo-Syn M061 (3.8 A)"},
          {3, "3: Slo-Syn M062 (4.7 A), Vexta PK264 (3 A)"},
          {4, "4: Slo-Syn M063 (4.6 A), Vexta PK266 (3 A)"},
          {5, "5: Slo-Syn M091 (4.7 A), Vexta PK268 (3 A)"},
          {6, "6: Slo-Syn M092 (4.6 A), Vexta PK296 (4.5 A)"}};
}

std::vector<ParamChoice> joystick_ranges() {
  std::vector<ParamChoice> all{{0, "0: joystick off"}};
  for (int x = 1; x <= max_joystick_range; ++x)
    all.push_back({x, fmt::format("{0}: {0} to {1} steps/s", x, 250 * x)});
  return all;
}

std::string motor_warning(int m) {
  return fmt::format(
      "Compare the chosen type with the label on motor {0} before you confirm. The controller drives the "
      "motor with the power of this type: a type that does not match can severely damage the motor and the "
      "controller.",
      m);
}

ParamInfo row(std::string mnemonic, std::string group, std::string label, std::string explanation) {
  ParamInfo p;
  p.mnemonic = std::move(mnemonic);
  p.group = std::move(group);
  p.label = std::move(label);
  p.explanation = std::move(explanation);
  return p;
}

void range(ParamInfo& p, std::int64_t low, std::int64_t high, std::int64_t fallback, std::string unit = {}) {
  p.minimum = low, p.maximum = high, p.fallback = fallback, p.unit = std::move(unit);
}

/// Range, factory value and get form, as the wire has them.
void as_in_facts(ParamInfo& p, std::string_view mnemonic, std::string unit = {}) {
  for (const SetupFact& fact : setup_facts) {
    if (fact.mnemonic != mnemonic) continue;
    range(p, fact.min, fact.max, fact.factory, std::move(unit));
    p.also_zero = fact.also_zero, p.readable = fact.readable;
    return;
  }
}

/// A range in which 0 has a meaning of its own.
void as_joystick_range(ParamInfo& p, std::string_view mnemonic) {
  as_in_facts(p, mnemonic);
  p.minimum = 0, p.also_zero = false;
  p.choices = joystick_ranges();
}

ParamInfo motor_type(int m) {
  ParamInfo p = row(fmt::format("M{}M", m), "Motors", fmt::format("Type of motor {}", m),
                    "Choose the type of the connected motor. The controller sets the motor current to match. "
                    "Type 0 is the factory value, for very small motors: a larger motor only buzzes and does "
                    "not move. While you jog with the buttons, the motor gets 70 % of its power.");
  as_in_facts(p, "MmM");
  p.choices = motor_types();
  p.warning = motor_warning(m);
  p.before_moving = fmt::format(
      "Choose the type of motor {} that is on its label. It still has type 0, the factory value: all but "
      "very small motors then only buzz and lose steps.",
      m);
  p.unset_value = 0;
  p.manual = "Setup Commands p.25";
  return p;
}

ParamInfo motor_type_full(int m) {
  ParamInfo p = row(
      fmt::format("MA{}M", m), "Motors", fmt::format("Type of motor {}, jogs at full power", m),
      "The same types, but the jog buttons and the joystick drive the motor at 100 % of its power instead of "
      "70 %. The controller does not report which of the two was set: only the type can be read back.");
  as_in_facts(p, "MAmM");
  p.choices = motor_types();
  p.warning = motor_warning(m);
  p.manual = "Appendix M p.64";
  return p;
}

ParamInfo limit_mode(int m) {
  ParamInfo p = row(
      fmt::format("L{}M", m), "Limit switches", fmt::format("Limit switches of motor {}", m),
      "How the two limit inputs are wired and whether they stop the motor. Velmex slides have normally "
      "closed switches: leave this on automatic, which uses the switches as soon as it has seen one closed. "
      "A rotary table with a home switch needs the "
      "home switch setting, so that the switch acts only while homing.");
  as_in_facts(p, "LmM");
  p.choices = {{0, "0: automatic, normally closed"},
               {1, "1: on, normally closed"},
               {2, "2: home switch only, normally closed"},
               {-1, "-1: on, normally open"},
               {-2, "-2: home switch only, normally open"}};
  p.manual = "Appendix N p.66";
  return p;
}

ParamInfo pulse_every(int m) {
  ParamInfo p =
      row(fmt::format("P{}M", m), "Position pulses", fmt::format("Steps between pulses of motor {}", m),
          "Output 2 gives a pulse each time the motor has turned by this many steps, also while jogging, for "
          "example to trigger a camera. The first pulse comes after half of the distance. "
          "0 switches it off.");
  as_in_facts(p, "PmM", "steps");
  p.manual = "Appendix D p.41";
  return p;
}

ParamInfo jog_first(int m) {
  ParamInfo p = row(fmt::format("j{}M", m), "Jog buttons", fmt::format("First jog speed of motor {}", m),
                    "Top speed when a jog button on the controller's front panel is held longer than 0.3 s. "
                    "0 switches the buttons of this motor off. Jogging from the screen is not affected.");
  as_in_facts(p, "jmM", "steps/s");
  p.manual = "Appendix H p.49";
  return p;
}

ParamInfo jog_second(int m) {
  ParamInfo p =
      row(fmt::format("J{}M", m), "Jog buttons", fmt::format("Second jog speed of motor {}", m),
          "Top speed of the jog buttons while input 2 is low, for example by the button of a digital "
          "joystick. Set it slow to approach a point by hand.");
  as_in_facts(p, "JmM", "steps/s");
  p.manual = "Appendix H p.49";
  return p;
}

ParamInfo joystick_first(int m) {
  ParamInfo p = row(fmt::format("jA{}M", m), "Joystick", fmt::format("First joystick range of motor {}", m),
                    "Range of speeds that an analog joystick gives from a small to a full deflection. Leave "
                    "the joystick at its centre when you switch the controller on: the controller takes its "
                    "position then as no motion.");
  as_joystick_range(p, "jAmM");
  p.manual = "Appendix J p.54";
  return p;
}

ParamInfo joystick_second(int m) {
  ParamInfo p =
      row(fmt::format("JA{}M", m), "Joystick", fmt::format("Second joystick range of motor {}", m),
          "Range of speeds of the analog joystick while input 2 is low, chosen by one of the buttons "
          "on the joystick.");
  as_joystick_range(p, "JAmM");
  p.manual = "Appendix J p.54";
  return p;
}

ParamInfo deadband() {
  ParamInfo p =
      row("DA", "Joystick", "Joystick dead band",
          "How far the analog joystick must leave its centre before a motor turns. Small values make "
          "it hard to move one axis alone, large ones delay a change of direction.");
  as_in_facts(p, "DA", "counts");
  p.manual = "Appendix J p.54";
  return p;
}

ParamInfo mode() {
  ParamInfo p = row(
      "DM", "Mode", "Controller mode",
      "Reverses individual motors, makes this controller the Master of a second one, lets it behave like the "
      "older NF90, or runs program 4 before the first run after power-up: put a homing routine there.");
  as_in_facts(p, "DM");
  p.bits = {{0, "always on"},
            {1, "motor 1 turns the other way"},
            {2, "motor 2 turns the other way"},
            {3, "behave like the older NF90"},
            {4, "motor 3 turns the other way"},
            {5, "motor 4 turns the other way"},
            {6, "this controller is the Master of a second one"},
            {7, "run program 4 first after power-up"}};
  p.warning =
      "This changes the direction of motors, the meaning of commands or the role of the controller at once. "
      "Positions and programs made for the old mode may lead elsewhere with the new one.";
  p.manual = "Appendix O p.68";
  return p;
}

ParamInfo input_mode() {
  ParamInfo p = row("I", "Inputs", "What the inputs do",
                    "Which of the Run and Stop buttons and of the inputs 1 to 4 act, and how: stopping with "
                    "or without a ramp, choosing a program, branching out of a wait, or capturing positions. "
                    "The Stop input is not an emergency stop: an emergency stop must cut the power.");
  as_in_facts(p, "I");
  p.bits = {{0, "Run button and input start programs"},
            {1, "Stop button and input 4 stop programs"},
            {2, "input 3 ends a wait and jumps to program 3"},
            {3, "Run and input 1 react in 0.1 ms instead of 1 ms"},
            {4, "Stop is hard, without a ramp"},
            {5, "after Stop, go on with program 4"},
            {6, "inputs 2 and 3 select program 0 to 3 (clears bit 2)"},
            {7, "input 4 captures positions (clears bit 1)"}};
  p.manual = "Appendix C p.38";
  return p;
}

ParamInfo pulse_width() {
  ParamInfo p =
      row("PA", "Position pulses", "Pulse width",
          "How long each position pulse on output 2 lasts, in units of ten microseconds: 1 is 10 µs, "
          "200 is 2 ms. It applies to the pulses at step distances and to those of U7.");
  as_in_facts(p, "PA", "10 µs");
  p.manual = "Appendix D p.42";
  return p;
}

ParamInfo backlash() {
  ParamInfo p = row("Bx", "Precision", "Backlash compensation",
                    "Each move in the negative direction overruns by this many steps and comes back. Every "
                    "position is then reached from the same side, and play in the screw does not show. 0 is "
                    "off; 1 means 20 steps. It applies to all motors. It is sent as B and the number. The "
                    "manual does not say whether Store keeps it: check it after the next power-up.");
  range(p, 0, max_backlash, 0, "steps");
  p.manual = "Appendix F p.45";
  return p;
}

ParamInfo limit_report() {
  ParamInfo p = row("O", "Limit switches", "When a limit switch is hit",
                    "A limit switch always stops the motor. Choose whether the controller also reports the "
                    "hit by the letter O, and whether a running program ends. A program that does not end "
                    "goes on with its next command from the wrong place. The manual does not say whether "
                    "Store keeps this setting: check it after the next power-up.");
  range(p, 0, max_limit_report, 0);
  p.choices = {{0, "0: stop the motor only"},
               {1, "1: tell the computer"},
               {2, "2: end the program"},
               {3, "3: tell the computer and end the program"}};
  p.manual = "Appendix F p.46";
  return p;
}

ParamInfo baud() {
  ParamInfo p =
      row("B", "Communication", "Baud rate",
          "Speed of the serial line. The console changes its own side together with the controller and goes "
          "back if it receives no reply. The controller keeps the new rate over power-off only after Store. "
          "It does not report its rate, so none is shown until you set one here.");
  as_in_facts(p, "B");
  for (const Baud& b : bauds) p.choices.push_back({b.number, fmt::format("{} baud", b.rate)});
  p.address_option = "baud", p.holds_at_once = true;
  p.manual = "Setup Commands p.25";
  return p;
}

ParamInfo association() {
  ParamInfo p =
      row("PMA", "Two controllers", "Programs started together",
          "Lets the Slave run its own program of the same number whenever the Master runs that program. "
          "Commands for motors 3 and 4 use program 0 of the Slave and erase its commands, so do not couple "
          "program 0 in a system that uses them. The manual does not say that Store keeps it: expect to set "
          "it again after each power-up.");
  range(p, -5, 255, 255);
  p.choices = {{255, "off"}};
  for (int x = 0; x <= 4; ++x) p.choices.push_back({x, fmt::format("program {}", x)});
  p.choices.push_back({-5, "all but program 0"});  // PMA-0; a number has no minus zero
  for (int x = 1; x <= 4; ++x) p.choices.push_back({-x, fmt::format("all but program {}", x)});
  p.stored = false;
  p.manual = "Appendix G p.48";
  return p;
}

}  // namespace

std::vector<ParamInfo> params(int motors) {
  std::vector<ParamInfo> all;
  for (auto make : {motor_type, motor_type_full, limit_mode})
    for (int m = 1; m <= motors; ++m) {
      all.push_back(make(m));
      all.back().axis = m - 1;
    }
  all.push_back(limit_report());
  all.push_back(backlash());
  all.push_back(input_mode());
  all.push_back(mode());
  for (auto make : {jog_first, jog_second, joystick_first, joystick_second})
    for (int m = 1; m <= motors; ++m) {
      all.push_back(make(m));
      all.back().axis = m - 1;
    }
  all.push_back(deadband());
  for (int m = 1; m <= motors; ++m) {
    all.push_back(pulse_every(m));
    all.back().axis = m - 1;
  }
  all.push_back(pulse_width());
  all.push_back(baud());
  if (motors > 2) all.push_back(association());
  return all;
}

}  // namespace hw::vxm
