#include "core/sequence/words.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "core/base/index.h"

namespace hw::sequence {
namespace {

constexpr std::string_view minus = "\u2212";

std::string_view sign_of(Sign sign) { return sign == Sign::plus ? std::string_view("+") : minus; }

std::string number(double value) {
  const std::string text = fmt::format("{}", value);
  return value < 0 ? std::string(minus) + text.substr(1) : text;
}

std::string axis_of(int axis, const Sequence& of) {
  return axis < 0 ? "all" : axis < static_cast<int>(of.axes.size()) ? of.axes[ix(axis)].name : "?";
}

/// Separates an axis name from the number after it: with a colon where the name itself is a number, such as
/// "1".
std::string before_number(const std::string& axis) {
  const bool digit = !axis.empty() && axis.back() >= '0' && axis.back() <= '9';
  return digit ? axis + ":" : axis;
}

std::string number(double value, const Scale& scale) { return number(scale.shown(value)); }
/// No space before the degree sign.
std::string_view space_before(const Scale& scale) { return scale.unit == "\u00b0" ? "" : " "; }

std::string speeds_of(const Speeds& s, const Scale& scale) {
  const auto speed = [&](double value) { return number(std::fabs(scale.shown(value))); };
  std::string all;
  if (s.high != 0 && s.low != 0)
    all = fmt::format("{} from {}{}{}/s", speed(s.high), speed(s.low), space_before(scale), scale.unit);
  else if (s.high != 0 || s.low != 0)
    all = fmt::format("{}{}{}{}/s", s.low != 0 ? "from " : "", speed(s.high + s.low), space_before(scale),
                      scale.unit);
  if (s.ramp_ms != 0) all += fmt::format("{}{} ms", all.empty() ? "" : ", ", number(s.ramp_ms));
  return all.empty() ? "as the controller has it" : all;
}

std::string state(bool on) { return on ? "on" : "off"; }

struct Summary {
  const Sequence& of;
  const Look& look;

  /// With its unit if the axes have different ones.
  [[nodiscard]] std::string place(double value, int axis) const {
    const Scale& scale = look.of_axis(axis);
    const std::string in_words = number(value, scale);
    return scale.unit == look.all.unit ? in_words
                                       : fmt::format("{}{}{}", in_words, space_before(scale), scale.unit);
  }
  /// Names the axes unless they are the first two.
  [[nodiscard]] std::string point(double x, double y, const Plane& plane) const {
    const auto [right, up] = plane;
    if (plane == Plane()) return fmt::format("{}, {}", place(x, right), place(y, up));
    return fmt::format("{} {}, {} {}", before_number(axis_of(right, of)), place(x, right),
                       before_number(axis_of(up, of)), place(y, up));
  }
  std::string operator()(const Speed& s) const { return speeds_of(s.speeds, look.all); }
  std::string operator()(const Move& m) const {
    std::string all;
    for (std::size_t a = 0; a < of.axes.size(); ++a)
      if (m.to[a])
        all += fmt::format("{}{} {}", all.empty() ? "" : ", ", before_number(of.axes[a].name),
                           place(*m.to[a], static_cast<int>(a)));
    return all.empty() ? "no axis yet" : all;
  }
  std::string operator()(const Arc& a) const {
    const bool circle = std::fabs(a.degrees) == 360;
    const std::string round = circle ? "" : fmt::format(", {}\u00b0", number(std::fabs(a.degrees)));
    return fmt::format("about {}{}{}", point(a.x, a.y, a.plane), round,
                       clockwise(a, look) ? " clockwise" : "");
  }
  std::string operator()(const Jog& j) const {
    return axis_of(j.axis, of) + " " + std::string(sign_of(j.direction));
  }
  std::string operator()(const Home& h) const {
    return fmt::format("{}, to {}", axis_of(h.axis, of), sign_of(h.direction));
  }
  std::string operator()(const Stop& s) const {
    return axis_of(s.axis, of) + (s.at_once ? ", at once" : ", with a ramp");
  }
  std::string operator()(const WaitMotion& w) const { return axis_of(w.axis, of); }
  std::string operator()(const Delay& d) const { return number(d.ms) + " ms"; }
  std::string operator()(const WaitInput& w) const {
    return fmt::format("until input {} is {}", w.input, state(w.on));
  }
  std::string operator()(const MoveOnInput& m) const {
    const std::string what =
        m.kind == MoveOnInput::Kind::move
            ? fmt::format("to {}", place(m.to, m.axis))
            : fmt::format("{} {}", m.kind == MoveOnInput::Kind::jog ? "jog" : "home", sign_of(m.direction));
    return fmt::format("{} {} if input {} is {}", axis_of(m.axis, of), what, m.input, state(m.on));
  }
  std::string operator()(const Output& o) const {
    return o.output < 0 ? fmt::format("all: {}", o.value) : fmt::format("{} {}", o.output, state(o.on));
  }
  std::string operator()(const Enable& e) const { return axis_of(e.axis, of) + " " + state(e.on); }
  std::string operator()(const Pen& p) const { return p.down ? "down" : "up"; }
  std::string operator()(const Comment& c) const { return c.text.substr(0, c.text.find('\n')); }
  std::string operator()(const Repeat& r) const {
    return r.times == 0 ? "for ever" : fmt::format("{} times", r.times);
  }
  std::string operator()(const Custom& c) const {
    return !c.about.empty() ? c.about : c.text.substr(0, c.text.find('\n'));
  }
  std::string operator()(const SpeedStairs& s) const {
    std::string all = axis_of(s.axis, of);
    for (const SpeedStairs::Stair& stair : s.stairs)
      all += fmt::format(", to {} at {}", place(stair.until, s.axis),
                         number(std::fabs(look.of_axis(s.axis).shown(stair.speed))));
    return fmt::format("{}, rest at {}", all, place(s.stop_at, s.axis));
  }
  std::string operator()(const Contour& c) const { return fmt::format("from {}", point(c.x, c.y, c.plane)); }
};

}  // namespace

double Scale::shown(double value) const {
  const double all = value * factor, fine = std::pow(10.0, decimals);
  return factor == 1 ? value : std::round(all * fine) / fine + 0.0;
}

double Scale::kept(double shown) const {
  constexpr double fine = 1e6;  // far finer than a step of any machine
  return factor == 1 ? shown : std::round(shown / factor * fine) / fine + 0.0;
}

const Scale& Look::of_axis(int axis) const { return axis >= 0 && axis < max_axes ? axes[ix(axis)] : all; }

const Scale& Look::of_motion(const Step::Body& body) const {
  if (const auto* jog = std::get_if<Jog>(&body)) return of_axis(jog->axis);
  if (const auto* home = std::get_if<Home>(&body)) return of_axis(home->axis);
  if (const auto* some = std::get_if<MoveOnInput>(&body)) return of_axis(some->axis);
  if (const auto* stairs = std::get_if<SpeedStairs>(&body)) return of_axis(stairs->axis);
  const auto* move = std::get_if<Move>(&body);
  const Plane* plane = plane_of(body);
  if (!move && !plane) return all;
  const Scale* first = nullptr;
  for (std::size_t a = 0; a < axes.size(); ++a) {
    const bool moves = move ? move->to[a].has_value() : ix(plane->right) == a || ix(plane->up) == a;
    if (!moves) continue;
    if (first && (first->unit != axes[a].unit || std::fabs(first->factor) != std::fabs(axes[a].factor)))
      return all;
    if (!first) first = &axes[a];
  }
  return first ? *first : all;
}

Look own_look(const Sequence& of) {
  Look look;
  look.all.unit = of.unit;
  look.axes.fill(look.all);
  return look;
}

bool Look::mirrors(const Plane& plane) const {
  return of_axis(plane.right).factor * of_axis(plane.up).factor < 0;
}

bool clockwise(const Arc& arc, const Look& look) { return (arc.degrees < 0) != look.mirrors(arc.plane); }

std::string_view title_of(const Step::Body& body) {
  static constexpr std::array<std::string_view, std::variant_size_v<Step::Any>> titles{
      "Speed", "Move to",        "Arc",           "Jog",         "Home",        "Stop", "Until still",
      "Delay", "Wait for input", "Move on input", "Output",      "Motor power", "Tool", "Comment",
      "Loop",  "Own text",       "Contour",       "Speed stairs"};
  if (const auto* move = std::get_if<Move>(&body); move && move->relative) return "Move by";
  if (const auto* arc = std::get_if<Arc>(&body); arc && (arc->degrees == 360 || arc->degrees == -360))
    return "Circle";
  return titles[body.index()];
}

std::string summary_of(const Step::Body& body, const Sequence& of) {
  return summary_of(body, of, own_look(of));
}
std::string summary_of(const Step::Body& body, const Sequence& of, const Look& look) {
  return std::visit(Summary{of, look}, body);
}

FixedText<64> label_of_field(std::string_view key, std::string_view unit_shown) {
  struct Label {
    std::string_view key, label;
    enum class Unit : std::uint8_t { none, length, speed, ms } unit = Unit::none;
  };
  using Unit = Label::Unit;
  static constexpr std::array<Label, 29> labels{{{"high", "Speed", Unit::speed},
                                                 {"low", "Low speed", Unit::speed},
                                                 {"ramp_ms", "Ramp", Unit::ms},
                                                 {"ms", "Time", Unit::ms},
                                                 {"x", "Centre right", Unit::length},
                                                 {"y", "Centre up", Unit::length},
                                                 {"degrees", "Degrees"},
                                                 {"to", "Target", Unit::length},
                                                 {"relative", "Relative"},
                                                 {"axis", "Axis"},
                                                 {"until", "Up to", Unit::length},
                                                 {"speed", "At", Unit::speed},
                                                 {"stop_at", "Rest at", Unit::length},
                                                 {"axes/1", "Right"},
                                                 {"axes/2", "Up"},
                                                 {"direction", "Direction"},
                                                 {"at_once", "At once"},
                                                 {"input", "Input"},
                                                 {"output", "Output"},
                                                 {"on", "On"},
                                                 {"kind", "Motion"},
                                                 {"stops_first", "Stop before"},
                                                 {"value", "Value of all"},
                                                 {"down", "Down"},
                                                 {"text", "Text"},
                                                 {"times", "Times"},
                                                 {"about", "Name"},
                                                 {"lead_in", "Lead-in", Unit::length},
                                                 {"ends_ramped", "Ends with a ramp"}}};
  for (const Label& l : labels) {
    if (l.key != key) continue;
    if (l.unit == Unit::none) return l.label;
    std::array<char, 96> words{};
    const std::string_view unit = l.unit == Unit::ms ? "ms" : unit_shown.substr(0, 40);
    const auto end = fmt::format_to_n(words.data(), words.size(), "{}, {}{}", l.label, unit,
                                      l.unit == Unit::speed ? "/s" : "");
    return std::string_view(words.data(), std::min(end.size, words.size()));
  }
  return key;
}

}  // namespace hw::sequence
