#include "core/devices/arcus/catalog_params.h"

#include <algorithm>

#include <fmt/core.h>

namespace hw::arcus {
namespace {

enum class Kind : std::uint8_t { plain, on_off, choices, bits };

struct Words {
  Setting id;
  const char* group;
  const char* label;  ///< {} stands for the axis letter
  const char* explanation;
  const char* unit;
  const char* section;        ///< of the manual's feature chapter
  const char* off = nullptr;  ///< words for the values 0 and 1
  const char* on = nullptr;
};

// clang-format off
constexpr Words all_words[] = {
    {Setting::high_speed, "Speed", "High speed",
     "The speed that moves, jogs and home searches reach after their ramp. With StepNLoop it is in encoder counts instead of pulses{together}.",
     "pulses/s", "Motion Profile"},
    {Setting::low_speed, "Speed", "Low speed",
     "The speed at which ramps begin and end, and at which the slow part of a home search runs. Its unit is that of the high speed.",
     "pulses/s", "Motion Profile"},
    {Setting::accel, "Speed", "Acceleration time",
     "How long the ramp from low to high speed takes. The controller adjusts a time that its table A.0 does not allow for the present speeds; the adjusted time is read back.",
     "ms", "Motion Profile"},
    {Setting::decel, "Speed", "Deceleration time",
     "How long the ramp from high to low speed takes when separate deceleration is on. It is adjusted like the acceleration time.",
     "ms", "Motion Profile"},
    {Setting::axis_high_speed, "Speed of one axis", "High speed of {}",
     "A high speed for moves of {} alone. It applies only when high speed, low speed and acceleration of {} are all set; 0 leaves {} at the speeds for all axes.",
     "pulses/s", "Motion Profile"},
    {Setting::axis_low_speed, "Speed of one axis", "Low speed of {}",
     "A low speed for moves of {} alone. It applies only when high speed, low speed and acceleration of {} are all set; 0 leaves {} at the speeds for all axes.",
     "pulses/s", "Motion Profile"},
    {Setting::axis_accel, "Speed of one axis", "Acceleration time of {}",
     "A ramp time for moves of {} alone. It applies only when high speed, low speed and acceleration of {} are all set; 0 leaves {} at the time for all axes.",
     "ms", "Motion Profile"},
    {Setting::axis_decel, "Speed of one axis", "Deceleration time of {}",
     "The ramp down of {} alone, when separate deceleration is on and {} uses its own speeds; 0 takes the time for all axes.",
     "ms", "Motion Profile"},
    {Setting::separate_decel, "Speed", "Separate deceleration",
     "Choose whether ramps down use the deceleration time, or the acceleration time like ramps up.",
     "", "Motion Profile", "0: brake with the acceleration time", "1: brake with the deceleration time"},
    {Setting::s_curve, "Speed", "Ramp form{of}",
     "Straight ramps change speed evenly. S-curves begin and end each ramp softly and spare the mechanics, but the speed cannot be changed during a move.",
     "", "Motion Profile", "0: straight (trapezoid)", "1: S-curve"},
    {Setting::speed_window, "Speed", "Window for speed changes{of}",
     "To change the speed while the axis moves, choose a window of table A.0 before the motion: the old and the new speed must both lie in it. 0 is for ordinary moves.",
     "", "On-The-Fly Speed Change"},
    {Setting::buffer_accel, "Buffered moves", "Ramps between buffered moves",
     "Each buffered move has its own speed. The speed can jump from one move to the next, or change in ramps of the acceleration time.",
     "", "Buffered Linear Interpolation Moves", "0: jump from speed to speed", "1: ramp in between"},
    {Setting::polarity, "Polarity", "Polarity{of}",
     "Change a bit if a lamp shows the opposite of its switch. The bits say which level of each signal is active, and which way the motor turns for a positive move.",
     "", "Polarity"},
    {Setting::input_polarity, "Polarity", "Polarity of the digital inputs",
     "Choose whether an input is on while current flows through it, or while none flows. This applies to all inputs.",
     "", "Digital Inputs/Outputs", "0: on while current flows", "1: on while no current flows"},
    {Setting::output_polarity, "Polarity", "Polarity of the digital outputs",
     "Before you change this, check what is connected to the outputs: they switch at once. It sets whether an output that is on conducts or blocks, for all outputs.",
     "", "Digital Inputs/Outputs", "0: on conducts", "1: on blocks"},
    {Setting::enable_polarity, "Polarity", "Polarity of the enable outputs",
     "Choose the level that switches a motor driver on. With the wrong level, motors have power while the console shows them off.",
     "", "Digital Inputs/Outputs", "0: as wired at the factory", "1: inverted"},
    {Setting::boot_outputs, "At power-up", "Digital outputs at power-up",
     "These outputs are on as soon as the controller has power, before any program or host sends a command. Takes effect at the next power-up after Store.",
     "", "Digital Inputs/Outputs"},
    {Setting::boot_enables, "At power-up", "Motor power at power-up",
     "These motors get power as soon as the controller does. The other motors turn freely until they are switched on. Takes effect at the next power-up after Store.",
     "", "Digital Inputs/Outputs"},
    {Setting::boot_programs, "At power-up", "Programs that start at power-up",
     "These stored programs start by themselves when the controller gets power, and may move the machine. Takes effect at the next power-up after Store.",
     "", "Standalone Program Specification"},
    {Setting::ignore_errors, "Limits and alarms", "Go on after a limit",
     "A limit or alarm always stops its axis. Choose whether the error must be cleared before the next move.",
     "", "Limits", "0: an error must be cleared first", "1: the next move may follow at once"},
    {Setting::sync_condition, "Sync outputs", "When the sync output{of} acts",
     "The sync output acts when the encoder has this relation to the sync position. Switch it on and off with the sync actions.",
     "", "Sync Outputs"},
    {Setting::sync_position, "Sync outputs", "Sync position{of}",
     "The position with which the sync output compares the encoder.",
     "counts", "Sync Outputs"},
    {Setting::sync_width, "Sync outputs", "Sync pulse{of}",
     "How long the output stays on when the encoder equals the sync position; 0 means as long as it is equal.",
     "ms", "Sync Outputs"},
    {Setting::joystick, "Joystick", "Axes under the joystick",
     "As soon as this is written, these axes follow the voltage at their analog input (X to U: AI1 to AI4) and accept no other move. Their StepNLoop is switched off.",
     "", "Joystick Control"},
    {Setting::joystick_max, "Joystick", "Joystick voltage of {} at full +",
     "Move the stick to its + end and enter the voltage that the analog input shows. At this voltage {} runs at full speed in the positive direction.",
     "mV", "Joystick Control"},
    {Setting::joystick_min, "Joystick", "Joystick voltage of {} at full -",
     "Move the stick to its - end and enter the voltage that the analog input shows. At this voltage {} runs at full speed in the negative direction. Halfway between the two ends, the axis stands still.",
     "mV", "Joystick Control"},
    {Setting::loop, "StepNLoop", "StepNLoop{of}",
     "Closed loop: after each move the controller compares the encoder with the target and corrects the difference. While it is on, positions and speeds count in encoder counts instead of pulses.",
     "", "StepNLoop Closed Loop Control", "0: off, positions in pulses", "1: on, positions in counts"},
    {Setting::loop_ratio, "StepNLoop", "Pulses for one count{of}",
     "To find this ratio of motor pulses to encoder counts, set pulse and encoder counter to 0, move by 1000 pulses and divide 1000 by the encoder counter. If it is negative, change the direction polarity.",
     "pulses/count", "StepNLoop Closed Loop Control"},
    {Setting::loop_tolerance, "StepNLoop", "In-position tolerance{of}",
     "At the end of a move, an error up to this many counts is not corrected.",
     "counts", "StepNLoop Closed Loop Control"},
    {Setting::loop_range, "StepNLoop", "Largest error{of}",
     "If encoder and target differ by more than this, the axis stops at once with an error that must be cleared. The likely cause is a jammed axis, or an encoder that does not count.",
     "counts", "StepNLoop Closed Loop Control"},
    {Setting::loop_attempts, "StepNLoop", "Correction attempts{of}",
     "How many times the controller tries to correct the end position before it gives up with an error.",
     "", "StepNLoop Closed Loop Control"},
    {Setting::loop_idle_tolerance, "StepNLoop", "Idle tolerance",
     "If a larger error than this is left after a correction, the controller corrects once more, with the idle current instead of the run current.",
     "counts", "StepNLoop Closed Loop Control"},
    {Setting::comm_timeout, "Communication", "Communication time-out",
     "If the controller receives nothing for this long, its time-out bit comes on and a program can react. 0 switches it off. A connected console sends several queries a second.",
     "ms", "Communication Time-out Feature"},
    {Setting::error_return, "Programs", "Where the error routine returns",
     "After an error a program jumps to its SUB 31. When that ends, the program repeats the line that failed, or begins again.",
     "", "Standalone Program Specification", "0: at the line that failed", "1: at line 0"},
    {Setting::device_name, "Communication", "Device name",
     "Its last two digits are the address of the controller. After a change, Store, switch the power off and on, and open it at the new address.",
     "", "Device Number"},
    {Setting::baud_code, "Communication", "Baud rate",
     "The speed of the serial line. After a change, Store, switch the power off and on, and open it at the new rate.",
     "", "Baud Rate Setting"},
    {Setting::line_type, "Communication", "Kind of line",
     "The line driver that the controller uses. To change it, write the new kind over the present line, Store, switch the power off, rewire, and switch on.",
     "", "RS-232/RS-485 Selection", "0: RS-232", "1: RS-485"},
    {Setting::response_type, "Communication", "Address in replies",
     "Choose whether each reply begins with # and the address of the replying device. The console understands both. Takes effect at the next power-up after Store.",
     "", "Response type selection", "0: the reply alone", "1: #, address, reply"},
    {Setting::auto_response, "Communication", "Reports when it is in position",
     "The controller can send a message at the end of each move. On a line with several devices, such messages can collide with replies. Takes effect at the next power-up after Store.",
     "", "Auto-response Feature", "0: sends replies only", "1: reports the end of each move"},
    {Setting::modbus, "Communication", "Modbus protocol",
     "Switches the line to the Modbus protocol, which the maker describes in a separate document. It needs RS-485. This console cannot talk to a controller in this mode.",
     "", "Storing to Flash", "0: ASCII commands", "1: Modbus"},
    {Setting::modbus_number, "Communication", "Modbus number",
     "The address of the controller on a Modbus line. Without Modbus it has no effect.",
     "", "Storing to Flash"},
    {Setting::run_current, "Motor current", "Run current",
     "Do not exceed the current on the motor's label. This is the motor current during a move: more current gives more torque and more heat.",
     "mA", "Idle Current and Run Current"},
    {Setting::idle_current, "Motor current", "Idle current",
     "The motor current at rest. A lower current keeps the motor cool; at 0 it turns freely.",
     "mA", "Idle Current and Run Current"},
    {Setting::idle_time, "Motor current", "Delay before idle current",
     "The time at rest after which the current goes down to the idle current.",
     "ms", "Idle Current and Run Current"},
    {Setting::status_outputs, "StepNLoop", "Outputs that show the state",
     "While StepNLoop is on, DO1 can show that the axis is in position, and DO3 that there is an error. You cannot switch them during this time.",
     "", "StepNLoop Closed Loop Control", "0: all outputs are for general use", "1: DO1 in position, DO3 alarm"},
    {Setting::home_correction, "Homing", "Distance past the home switch",
     "Homing with high and low speed backs off this far beyond the edge of the switch before it searches for the edge at low speed.",
     "", "Homing"},
    {Setting::limit_correction, "Homing", "Distance off the limit switch",
     "Homing to the limit switch backs off by this distance, and zero is where it then stops.",
     "", "Homing"},
    {Setting::return_to_zero, "Homing", "Return to zero after homing",
     "Homing at high speed stops the motor a little beyond zero. Choose whether the motor then returns to zero.",
     "", "Homing", "0: stay where the ramp ends", "1: go back to zero"},
};

constexpr const char* joystick_values[3][2] = {
    {"Joystick speed of {}", "The speed of {} at both ends of the stick."},
    {"Joystick speed change of {}", "The largest change of the speed of {} in one step: small values make it follow the stick softly."},
    {"Joystick dead band of {}", "Within this range around the middle voltage, {} stands still. A stick that does not return exactly to its middle then causes no motion."},
};
constexpr const char* joystick_limits[4][2] = {
    {"Joystick: - end of {}", "At this position {} stops in the negative direction, however far you hold the stick. Enter the four joystick limits in ascending order: otherwise they have no effect."},
    {"Joystick: slower below, {}", "From here towards the negative end the speed of {} under the joystick goes down to zero."},
    {"Joystick: slower above, {}", "From here towards the positive end the speed of {} under the joystick goes down to zero."},
    {"Joystick: + end of {}", "At this position {} stops in the positive direction, however far you hold the stick."},
};
// clang-format on

const Words* words_of(Setting id) {
  const auto* found =
      std::find_if(std::begin(all_words), std::end(all_words), [&](const Words& w) { return w.id == id; });
  return found == std::end(all_words) ? nullptr : found;
}

void replace_all(std::string& text, std::string_view from, std::string_view to) {
  for (auto at = text.find(from); at != text.npos; at = text.find(from, at + to.size()))
    text.replace(at, from.size(), to);
}

// "{}" is the axis letter; "{of}" is " of X" where the setting is one of several axes.
std::string worded(std::string text, std::string_view letter, bool per_axis) {
  replace_all(text, "{of}", per_axis ? " of " + std::string(letter) : "");
  replace_all(text, "{}", letter);
  return text;
}

// "HSPD=1000 when SNL is enabled means that the target high speed is 1000 encoder counts per second": both
// manuals, StepNLoop Closed Loop Control, notes.
bool is_speed(Setting id) {
  return id == Setting::high_speed || id == Setting::low_speed || id == Setting::axis_high_speed ||
         id == Setting::axis_low_speed;
}

bool is_axis_form(const SettingFact& fact) { return fact.form.find('a') != fact.form.npos; }

void add_choices(ParamInfo& p, const Model& model, Setting id, const Words& words) {
  if (words.off) p.choices = {{0, words.off}, {1, words.on}};
  if (id == Setting::baud_code)
    for (const Baud& b : bauds) p.choices.push_back({b.code, fmt::format("{} baud", b.rate)});
  if (id == Setting::sync_condition)
    p.choices = {{1, "1: encoder equals the position"},
                 {2, "2: encoder is below the position"},
                 {3, "3: encoder is above the position"}};
  if (id == Setting::sync_condition) p.short_choices = {"equal", "below", "above"};
  if (id == Setting::speed_window) {
    p.choices = {{0, "0: ordinary moves"}};
    std::int64_t lower = 1;
    for (const SpeedRow& row : model.speeds) {
      p.choices.push_back({row.window, fmt::format("{}: {} to {} pulses/s", row.window, lower, row.upper)});
      lower = row.upper + 1;
    }
  }
}

void add_bits(ParamInfo& p, const Model& model, Setting id, const Wording& wording) {
  const auto number_bits = [&](int count, const char* what) {
    for (int i = 0; i < count; ++i) p.bits.push_back({i, fmt::format("{} {}", what, i + 1)});
  };
  if (id == Setting::polarity) p.bits = wording.polarity_bits;
  if (id == Setting::boot_outputs) number_bits(model.outputs, "Output DO");
  if (id == Setting::boot_programs)
    for (int i = 0; i < model.programs; ++i) p.bits.push_back({i, fmt::format("Program {}", i)});
  if (id == Setting::boot_enables || id == Setting::joystick)
    for (int i = 0; i < model.axes(); ++i)
      p.bits.push_back({i, fmt::format("Motor {}", model.axis_letters[static_cast<std::size_t>(i)])});
}

void add_joystick_words(ParamInfo& p, const Model& model, const SettingFact& fact, int place) {
  const bool limit = fact.id == Setting::joystick_limits;
  const int axis = limit ? place / 4 : place % 4, kind = limit ? place % 4 : place / 4;
  const auto& words = limit ? joystick_limits[kind] : joystick_values[kind];
  const std::string_view letter = model.axis_letters.substr(static_cast<std::size_t>(axis), 1);
  p.label = worded(words[0], letter, true);
  p.explanation = worded(words[1], letter, true);
  p.group = "Joystick";
  p.axis = axis;
  p.unit = limit ? "pulses" : kind == 2 ? "mV" : "pulses/s";
}

}  // namespace

std::string mnemonic_of(const Model& model, const SettingFact& fact, int place) {
  std::string name(fact.form);
  if (const auto a = name.find('a'); a != name.npos)
    name[a] = model.axis_letters[static_cast<std::size_t>(place)];
  if (const auto n = name.find('n'); n != name.npos) name.replace(n, 1, std::to_string(place + 1));
  return name;
}

std::int64_t longest_ramp_ms(const Model& model) {
  std::int64_t longest = 0;
  for (const SpeedRow& row : model.speeds) longest = std::max(longest, row.upper * 1000 / row.delta);
  return longest;
}

std::vector<ParamInfo> params(const Model& model, const Wording& wording) {
  std::vector<ParamInfo> all;
  for (const SettingFact& fact : model.settings)
    for (int place = 0; place < fact.count; ++place) {
      ParamInfo p;
      p.mnemonic = mnemonic_of(model, fact, place);
      p.minimum = fact.min, p.maximum = fact.max, p.fallback = fact.factory;
      p.also_zero = fact.also_zero;
      p.stored = fact.stored;
      const bool per_axis = is_axis_form(fact);
      if (per_axis || model.axes() == 1) p.axis = place;
      if (const Words* words = words_of(fact.id)) {
        const std::string_view letter =
            model.axis_letters.substr(per_axis ? static_cast<std::size_t>(place) : 0, 1);
        p.group = words->group;
        p.label = worded(words->label, letter, per_axis);
        p.explanation = worded(words->explanation, letter, per_axis);
        if (!fact.stored) p.explanation += " Store does not keep it: it is lost when the power goes off.";
        replace_all(p.explanation, "{together}",
                    model.axes() > 1 ? ", but not in moves of several axes together" : "");
        p.unit = words->unit;
        p.follows_loop = is_speed(fact.id);
        p.manual = fmt::format("{} {}", wording.feature_chapter, words->section);
        add_choices(p, model, fact.id, *words);
        add_bits(p, model, fact.id, wording);
      } else {
        add_joystick_words(p, model, fact, place);
        p.manual = fmt::format("{} Joystick Control", wording.feature_chapter);
      }
      p.of_move_buffer = fact.id == Setting::buffer_accel;
      if (fact.notation == Notation::thousandths) p.decimals = 3;
      if (fact.notation == Notation::name) p.prefix = model.name_prefix, p.digits = 2;
      if (fact.id == Setting::device_name) p.address_option = "id";
      if (fact.id == Setting::baud_code) p.address_option = "baud";
      if (fact.id == Setting::modbus)
        p.warning =
            "With Modbus on, the controller no longer understands this console from the next power-up after "
            "Store. Only a Modbus program can switch it back.";
      if (fact.id == Setting::joystick)
        p.warning =
            "These axes follow their analog inputs at once and may begin to move. Take your hands off the "
            "machine and the stick before you confirm.";
      if (!p.warning.empty()) p.harmless = 0;
      if (p.unit == "ms" && fact.max > max_number) p.maximum = longest_ramp_ms(model);
      all.push_back(std::move(p));
    }
  return all;
}

}  // namespace hw::arcus
