#pragma once
// Names and fields of each kind of step in a file: one description for reading and writing. An Io has a
// function (key, value) for each kind of field.
#include <concepts>
#include <string_view>
#include <type_traits>

#include "core/sequence/sequence.h"

namespace hw::sequence {

inline constexpr std::array<std::string_view, std::variant_size_v<Step::Any>> kind_names{
    "speed",         "move",   "arc",    "jog", "home",    "stop", "wait_motion", "delay",   "wait_input",
    "move_on_input", "output", "enable", "pen", "comment", "loop", "custom",      "contour", "speed_stairs"};
inline constexpr std::array<std::string_view, 3> input_moves{"move", "jog", "home"};

/// U, const or not: to be written or read into.
template <class T, class U>
concept Of = std::same_as<std::remove_const_t<T>, U>;

template <class Io, Of<Speeds> S>
void fields(Io& io, S& s) {
  io.positive("high", s.high);
  io.positive("low", s.low);
  io.positive("ramp_ms", s.ramp_ms);
}
template <class Io, Of<Speed> S>
void fields(Io& io, S& s) {
  fields(io, s.speeds);
}
template <class Io, Of<Move> S>
void fields(Io& io, S& m) {
  io.places("to", m.to);
  io.flag("relative", m.relative);
  io.own(m.own);
}
template <class Io, Of<Arc> S>
void fields(Io& io, S& a) {
  io.needed("x", a.x);
  io.needed("y", a.y);
  io.number("degrees", a.degrees);
  io.plane("axes", a.plane);
  io.own(a.own);
}
template <class Io, Of<Jog> S>
void fields(Io& io, S& j) {
  io.axis("axis", j.axis);
  io.sign("direction", j.direction);
  io.own(j.own);
}
template <class Io, Of<Home> S>
void fields(Io& io, S& h) {
  io.axis("axis", h.axis);
  io.sign("direction", h.direction);
  io.own(h.own);
}
template <class Io, Of<Stop> S>
void fields(Io& io, S& s) {
  io.axis_or_all("axis", s.axis);
  io.flag("at_once", s.at_once);
}
template <class Io, Of<WaitMotion> S>
void fields(Io& io, S& w) {
  io.axis_or_all("axis", w.axis);
}
template <class Io, Of<Delay> S>
void fields(Io& io, S& d) {
  io.positive("ms", d.ms);
}
template <class Io, Of<WaitInput> S>
void fields(Io& io, S& w) {
  io.line("input", w.input);
  io.flag("on", w.on);
}
template <class Io, Of<MoveOnInput> S>
void fields(Io& io, S& m) {
  io.line("input", m.input);
  io.flag("on", m.on);
  io.choice("kind", m.kind, input_moves);
  io.axis("axis", m.axis);
  io.number("to", m.to);
  io.sign("direction", m.direction);
  io.flag("stops_first", m.stops_first);
  io.own(m.own);
}
template <class Io, Of<Output> S>
void fields(Io& io, S& o) {
  io.line_or_all("output", o.output);
  io.flag("on", o.on);
  io.word("value", o.value);
}
template <class Io, Of<Enable> S>
void fields(Io& io, S& e) {
  io.axis("axis", e.axis);
  io.flag("on", e.on);
}
template <class Io, Of<Pen> S>
void fields(Io& io, S& p) {
  io.flag("down", p.down);
}
template <class Io, Of<Comment> S>
void fields(Io& io, S& c) {
  io.text("text", c.text);
}
template <class Io, Of<Repeat> S>
void fields(Io& io, S& l) {
  io.count("times", l.times);
  io.steps("steps", l.steps);
}
template <class Io, Of<Custom> S>
void fields(Io& io, S& c) {
  io.text("about", c.about);
  io.text("text", c.text);
}

template <class Io, Of<Contour> S>
void fields(Io& io, S& c) {
  io.needed("x", c.x);
  io.needed("y", c.y);
  io.positive("lead_in", c.lead_in);
  io.flag("ends_ramped", c.ends_ramped);
  io.plane("axes", c.plane);
  io.own(c.own);
  io.steps("steps", c.steps);
}
template <class Io, Of<SpeedStairs::Stair> S>
void fields(Io& io, S& s) {
  io.needed("until", s.until);
  io.needed("speed", s.speed);
}
template <class Io, Of<SpeedStairs> S>
void fields(Io& io, S& s) {
  io.axis("axis", s.axis);
  io.stairs("stairs", s.stairs);
  io.needed("stop_at", s.stop_at);
}

}  // namespace hw::sequence
