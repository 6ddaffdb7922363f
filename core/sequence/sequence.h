#pragma once
// The steps of a machine in order, independent of any controller's language: from a drawing, or built by the
// user. Positions are in the sequence's own unit; `Axis::per_unit` gives its size in steps of the controller
// (pulses, counts).
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "core/base/units.h"

namespace hw::sequence {

/// Speeds of a motion, in units per second. 0: the controller's own.
struct Speeds {
  double high = 0, low = 0;
  double ramp_ms = 0;
  bool operator==(const Speeds&) const = default;
};
/// None: those of the latest Speed step.
using OwnSpeeds = std::optional<Speeds>;
/// By index in Sequence::axes.
using Places = std::array<std::optional<double>, max_axes>;

struct Step;
using StepList = std::vector<Step>;

/// Sets the speeds of later motions that have none of their own.
struct Speed {
  Speeds speeds;
  bool operator==(const Speed&) const = default;
};
/// Moves axes, several in a straight line where the controller can.
struct Move {
  Places to;
  bool relative = false;
  OwnSpeeds own{};
  bool operator==(const Move&) const = default;
};
/// The two axes of a shape, by their indexes in Sequence::axes.
struct Plane {
  int right = 0, up = 1;
  bool operator==(const Plane&) const = default;
};
/// Around a centre.
struct Arc {
  double x = 0, y = 0;   ///< the centre, to the right and up in its plane
  double degrees = 360;  ///< counterclockwise; 360 and -360 are circles
  OwnSpeeds own{};
  Plane plane{};
  bool operator==(const Arc&) const = default;
};
struct Jog {
  int axis = 0;
  Sign direction = Sign::plus;
  OwnSpeeds own{};
  bool operator==(const Jog&) const = default;
};
struct Home {
  int axis = 0;
  Sign direction = Sign::minus;
  OwnSpeeds own{};
  bool operator==(const Home&) const = default;
};
struct Stop {
  int axis = -1;  ///< -1: all
  bool at_once = false;
  bool operator==(const Stop&) const = default;
};
/// Until the motion has ended.
struct WaitMotion {
  int axis = -1;  ///< -1: all
  bool operator==(const WaitMotion&) const = default;
};
struct Delay {
  double ms = 0;
  bool operator==(const Delay&) const = default;
};
struct WaitInput {
  int input = 1;  ///< the maker's number
  bool on = true;
  bool operator==(const WaitInput&) const = default;
};
/// A motion of one axis if the input has the given state.
struct MoveOnInput {
  enum class Kind : std::uint8_t { move, jog, home };
  int input = 1;
  bool on = true;
  Kind kind = Kind::move;
  int axis = 0;
  double to = 0;                ///< of a move
  Sign direction = Sign::plus;  ///< of a jog or home
  bool stops_first = false;     ///< stops the axis first if it moves
  OwnSpeeds own{};
  bool operator==(const MoveOnInput&) const = default;
};
struct Output {
  int output = 1;  ///< the maker's number; -1: `value` sets all outputs
  bool on = true;
  std::uint32_t value = 0;
  bool operator==(const Output&) const = default;
};
/// Motor power.
struct Enable {
  int axis = 0;
  bool on = true;
  bool operator==(const Enable&) const = default;
};
/// Lifts or lowers the tool (pen, laser ...) by Sequence::pen_up or pen_down.
struct Pen {
  bool down = false;
  bool operator==(const Pen&) const = default;
};
struct Comment {
  std::string text;
  bool operator==(const Comment&) const = default;
};
struct Repeat {
  int times = 0;  ///< 0: for ever
  StepList steps;
  bool operator==(const Repeat&) const;
};
/// Moves, arcs and outputs in one plane, run without a stop at one speed, through corners too.
struct Contour {
  double x = 0, y = 0;      ///< start, to the right and up in its plane
  double lead_in = 0;       ///< length of the run-up before the start, in the first direction
  bool ends_ramped = true;  ///< ramps down beyond the end, in the last direction; false: stops at once
  OwnSpeeds own{};
  StepList steps;
  Plane plane{};
  bool operator==(const Contour&) const;
};
/// One axis with a speed for each stretch, changed without a stop.
struct SpeedStairs {
  struct Stair {
    double until = 0, speed = 0;
    bool operator==(const Stair&) const = default;
  };
  int axis = 0;
  std::vector<Stair> stairs;
  double stop_at = 0;  ///< after the last stair
  bool operator==(const SpeedStairs&) const = default;
};
/// Text in one controller's language, written unchanged.
struct Custom {
  std::string about;
  std::string text;
  bool operator==(const Custom&) const = default;
};

struct Step {
  using Any = std::variant<Speed, Move, Arc, Jog, Home, Stop, WaitMotion, Delay, WaitInput, MoveOnInput,
                           Output, Enable, Pen, Comment, Repeat, Custom, Contour, SpeedStairs>;
  /// Not inline, as every file that copies a step would compile the copying of each kind again.
  struct Body : Any {
    using Any::Any;
    Body(const Body& other);
    Body(Body&& other) noexcept;
    Body& operator=(const Body& other);
    Body& operator=(Body&& other) noexcept;
    ~Body();
  };
  Body body;
  bool skipped = false;  ///< stays in the list but does nothing
  bool operator==(const Step& other) const;
};

struct Axis {
  std::string name;     ///< the controller's name
  double per_unit = 1;  ///< steps per unit
  bool operator==(const Axis&) const = default;
};

struct Sequence {
  std::string unit = "steps";
  std::vector<Axis> axes;
  /// Largest distance of chords from an arc that is sent through a buffer of straight moves. 0: half a step.
  double tolerance = 0;
  StepList pen_up, pen_down;
  StepList steps;
  bool operator==(const Sequence&) const = default;
};

/// The plane of a step; null: none.
inline const Plane* plane_of(const Step::Body& body) {
  if (const auto* arc = std::get_if<Arc>(&body)) return &arc->plane;
  if (const auto* contour = std::get_if<Contour>(&body)) return &contour->plane;
  return nullptr;
}

/// A copy without the steps.
inline Sequence frame_of(const Sequence& s) {
  return {s.unit, s.axes, s.tolerance, s.pen_up, s.pen_down, {}};
}

}  // namespace hw::sequence
