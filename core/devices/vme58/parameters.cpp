#include "core/devices/vme58/parameters.h"

#include "core/devices/vme58/codec.h"

namespace hw::vme58 {
namespace {

constexpr std::int64_t most_gain = 100'000'000;  // hundredths; the board takes any non-negative number

constexpr ParameterFact number(std::string_view letters, Fitting fitting, std::optional<AxisValue> shown,
                               std::int64_t minimum, std::int64_t maximum, std::int64_t factory,
                               const char* group, const char* label, const char* explanation,
                               const char* unit, int decimals = 0) {
  ParameterFact f;
  f.letters = letters, f.fitting = fitting, f.shown = shown;
  f.minimum = minimum, f.maximum = maximum, f.factory = factory, f.decimals = decimals;
  f.group = group, f.label = label, f.explanation = explanation, f.unit = unit;
  return f;
}
constexpr ParameterFact either(std::string_view letters, std::string_view off, std::string_view on,
                               std::int64_t factory, Fitting fitting, const char* group, const char* label,
                               const char* explanation, const char* off_words, const char* on_words) {
  ParameterFact f;
  f.letters = letters, f.fitting = fitting, f.off = off, f.on = on;
  f.maximum = 1, f.factory = factory;
  f.group = group, f.label = label, f.explanation = explanation;
  f.off_words = off_words, f.on_words = on_words;
  return f;
}
/// A gain that acts on a standing error.
constexpr ParameterFact driving(ParameterFact f) {
  f.drives = true;
  return f;
}
constexpr ParameterFact of_board(ParameterFact f) {
  f.whole_board = true;
  return f;
}

using enum AxisValue;

// clang-format off
constexpr ParameterFact facts[] = {
    number("VL", Fitting::any, maximum_velocity, 0, velocity_max, default_velocity, "Speeds and ramps",
           "Top speed of {}", "The speed that moves and home searches of {} reach when the way is long enough.", "counts/s"),
    number("AC", Fitting::any, acceleration, 0, acceleration_max, default_acceleration, "Speeds and ramps",
           "Ramp rate of {}", "How fast {} speeds up and slows down, stops included. A small value makes every stop long.", "counts/s²"),
    number("VB", Fitting::any, base_velocity, 0, velocity_max, 0, "Speeds and ramps",
           "Start speed of {}", "Ramps of {} begin and end at this speed at once, which helps a stepper past its resonance. Keep it below the top speed.", "counts/s"),
    driving(number("KP", Fitting::servo, proportional_gain, 0, most_gain, 0, "Servo loop",
           "Proportional gain of {}", "The output of {} grows with the distance between where it is sent and where it is. Too little is soft, too much oscillates.", "", 2)),
    number("KD", Fitting::servo, differential_gain, 0, most_gain, 0, "Servo loop",
           "Derivative gain of {}", "Damps {}: the output works against quick changes of the error. Raise it with the proportional gain.", "", 2),
    driving(number("KI", Fitting::servo, integral_gain, 0, most_gain, 0, "Servo loop",
           "Integral gain of {}", "Removes the small error that friction or a steady load leaves on {}. Too much makes it swing slowly.", "", 2)),
    number("KV", Fitting::servo, velocity_feed_forward, 0, most_gain, 0, "Servo loop",
           "Velocity feed-forward of {}", "Adds output in proportion to the commanded speed of {}, so that less error is needed to follow it.", "", 2),
    number("KA", Fitting::servo, acceleration_feed_forward, 0, most_gain, 0, "Servo loop",
           "Acceleration feed-forward of {}", "Adds output in proportion to the commanded acceleration of {}, so that it keeps up on ramps.", "", 2),
    number("KO", Fitting::servo, offset, -most_gain, most_gain, 0, "Servo loop",
           "Output offset of {}", "A constant output of {} against a steady load, such as the weight on a vertical axis.", "", 2),
    number("KN", Fitting::servo, std::nullopt, 0, integration_exponent_max, 0, "Servo loop",
           "Integration interval of {}", "The integral of {} is taken over 2^n updates of the loop, where n is this number.", ""),
    either("HN", "HF", "HN", 0, Fitting::step_with_encoder, "Position hold",
           "Position hold of {}", "After each move the board compares the encoder of {} with the position and corrects it within the hold settings below.", "HF: off", "HN: on"),
    number("HV", Fitting::step_with_encoder, std::nullopt, 0, velocity_max, 0, "Position hold",
           "Hold speed of {}", "The highest speed with which {} corrects its position while it holds.", "counts/s"),
    number("HG", Fitting::step_with_encoder, std::nullopt, 0, most_gain, 0, "Position hold",
           "Hold gain of {}", "The error of {} times this gain is the speed of its correction, up to the hold speed.", "", 2),
    number("HD", Fitting::encoder, std::nullopt, 0, distance_max, 0, "Position hold",
           "Deadband of {}", "{} counts as in position while its error is at most this many counts.", "counts"),
    number("ES", Fitting::encoder, std::nullopt, 0, distance_max, 0, "Slip",
           "Slip tolerance of {}", "When encoder and position of {} differ by more than this, the slip flag is set. 0 switches the watch off.", "counts"),
    either("TN", "TF", "TN", 0, Fitting::encoder, "Slip",
           "Stop {} on slip", "Choose what happens when {} slips beyond its tolerance: only the flag is set, or its motion, queue and hold end too.", "TF: flag only", "TN: end the motion too"),
    either("LN", "LF", "LN", 1, Fitting::any, "Switches",
           "Limit switches of {}", "Choose whether the limit switches end the motion of {}. When they are off, only you can stop it before the end of its travel.", "LF: ignored", "LN: end the motion"),
    either("SL", "SF", "SL", 0, Fitting::any, "Switches",
           "Stop of {} at a limit", "Choose whether {} stops at once at a limit switch, or with its ramp and with the rest of its queue kept.", "SF: at once", "SL: with the ramp"),
    either("HH", "HL", "HH", 0, Fitting::any, "Switches",
           "Home switch of {}", "Choose which level of the home input of {} means that the axis is on its home switch.", "HL: active low", "HH: active high"),
    either("HE", "HS", "HE", 0, Fitting::encoder, "Switches",
           "Home signal of {}", "Choose whether home of {} is its switch alone, or the switch together with the encoder's index mark.", "HS: the switch", "HE: switch and index"),
    either("PA", "PA0", "PA1", 0, Fitting::any, "Outputs",
           "Automatic power of {}", "Choose whether the auxiliary output of {} goes high by itself for each move and low afterwards, to switch a drive between run and idle current.", "PA0: off", "PA1: on for moves"),
    number("SE", Fitting::any, std::nullopt, 0, whole_max, 0, "Outputs",
           "Settling time of {}", "With automatic power the auxiliary output of {} stays high for this time after a move.", "ms"),
    either("BI", "UN", "BI", 1, Fitting::servo, "Outputs",
           "Analog output of {}", "Choose whether the torque output of {} swings both ways around zero, or has one polarity beside a direction line. The jumper must agree.", "UN: one polarity", "BI: both ways"),
    number("PI", Fitting::any, std::nullopt, 0, whole_max, 0, "Outputs",
           "PWM period of {}", "The period of the pulse-width output of {}. The data sheet gives no unit; see the manual of the drive.", ""),
    of_board(number("PN", Fitting::any, std::nullopt, ramp_linear, ramp_cosine, ramp_linear, "Speeds and ramps",
           "Form of all ramps", "How speed changes on every axis: in a straight line, along a half cosine (soft), or by a parabola that is cut off at a point (1 to 10).", "")),
    of_board(number("CV", Fitting::any, std::nullopt, 0, velocity_max, 0, "Speeds and ramps",
           "Speed along contours", "Set the constant speed of contours before one is played. 0 means that it has not been set.", "counts/s")),
};
// clang-format on

bool axis_has(const ParameterFact& fact, const AxisFitting& axis) {
  switch (fact.fitting) {
    case Fitting::any: return true;
    case Fitting::servo: return axis.kind == AxisKind::servo;
    case Fitting::encoder: return axis.encoder;
    case Fitting::step_with_encoder: return axis.encoder && axis.kind == AxisKind::stepper;
  }
  return false;
}

}  // namespace

std::vector<Parameter> parameters_of(const Variant& variant) {
  std::vector<Parameter> all;
  for (int axis = 0; axis < variant.axes(); ++axis)
    for (const ParameterFact& fact : facts)
      if (!fact.whole_board && axis_has(fact, variant.fitting(axis)))
        all.push_back(
            {&fact, axis, std::string(fact.letters) + axis_letters[static_cast<std::size_t>(axis)]});
  for (const ParameterFact& fact : facts)
    if (fact.whole_board) all.push_back({&fact, -1, std::string(fact.letters)});
  return all;
}

std::string set_text(const ParameterFact& fact, std::int64_t value) {
  if (!fact.on.empty()) return std::string(value != 0 ? fact.on : fact.off);
  if (fact.whole_board && fact.letters == "PN") {
    if (value == ramp_linear) return "PF";
    if (value == ramp_cosine) return "CN";
  }
  return std::string(fact.letters) + encode_number(value, fact.decimals);
}

}  // namespace hw::vme58
