#pragma once
// Building blocks of the board's motion. A run takes one or more axes along a track (core/motion/course.h);
// an axis has counters, a load, and perhaps a motor.
#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <variant>
#include <vector>

#include "core/base/index.h"
#include "core/devices/vme58/emulator_axis.h"
#include "core/devices/vme58/facts.h"
#include "core/motion/contour.h"
#include "core/motion/course.h"
#include "core/motion/path.h"
#include "core/motion/plant.h"
#include "core/motion/servo.h"
#include "core/time/clock.h"

namespace hw::vme58 {

/// HM HR KM KR. `kill`: stop dead at the edge, the counter keeps its value (decisions M40, M41).
struct HomeOrder {
  Sign way = Sign::plus;
  bool kill = false;
  std::int64_t position = 0;  ///< assigned to the home edge; unused with `kill`
};

/// The track of a run: a line of pulses, or a contour in fine steps.
class Track {
 public:
  Track() = default;
  explicit Track(const motion::Path& path) : path_(path) {}
  explicit Track(std::shared_ptr<const motion::Contour> contour) : contour_(std::move(contour)) {}

  [[nodiscard]] std::int64_t steps() const { return contour_ ? contour_->steps() : path_.steps(); }
  [[nodiscard]] std::int64_t offset(std::size_t axis, std::int64_t step) const {
    return contour_ ? contour_->offset(axis, step) : path_.offset(axis, step);
  }
  [[nodiscard]] double exact(std::size_t axis, double step) const {
    return contour_ ? contour_->exact(axis, step) : path_.exact(axis, step);
  }
  [[nodiscard]] int direction(std::size_t axis, std::int64_t step) const {
    return contour_ ? contour_->direction(axis, step) : path_.direction(axis, step);
  }
  [[nodiscard]] std::int64_t next_turn(std::int64_t step) const {
    return contour_ ? contour_->next_turn(step) : path_.next_turn(step);
  }
  [[nodiscard]] std::optional<std::int64_t> first_at(std::size_t axis, std::int64_t step,
                                                     std::int64_t offset) const {
    return contour_ ? contour_->first_at(axis, step, offset) : path_.first_at(axis, step, offset);
  }
  /// Counts of the axis per step at that place: -1 to 1.
  [[nodiscard]] double slope(std::size_t axis, double step) const {
    if (contour_) return contour_->share(axis, step) / motion::Contour::steps_per_count;
    return path_.share(axis, step) * path_.pulses_per_step();
  }

 private:
  motion::Path path_;
  std::shared_ptr<const motion::Contour> contour_;
};

/// An action due at a step of a contour being played.
struct ContourEvent {
  enum class What : std::uint8_t { at_speed, output, end };
  What what;
  std::int64_t step;
  unsigned outputs = 0;  ///< bit per axis
  bool high = false;
};

/// A contour prepared for playing. Shared by runs and never changed.
struct ContourPlan {
  std::vector<ContourEvent> events;  ///< in the order of their steps
  bool kill = false;
};

enum class RunKind : std::uint8_t { move, jog, staircase, home, contour };

struct Run : motion::Course<Track> {
  RunKind kind = RunKind::move;
  unsigned over_limit = 0;  ///< axes that ramp down beyond their switch (SL)
  double wanted = 0;        ///< commanded speed in steps/s, whatever the present one
  std::shared_ptr<const ContourPlan> plan;
  std::size_t event = 0;
};

/// Range and number of counts of a counter, for rehearsals.
struct Span {
  std::int64_t lowest = 0, highest = 0, travel = 0;
};

/// Where an axis goes after coming to rest.
struct Return {
  std::int64_t position = 0;
  double speed = 0;
};

struct MotionAxis {
  AxisFitting fitting;
  AxisSettings settings;
  motion::Plant plant;

  std::int64_t position = 0;  ///< the command register
  Span span;
  std::int64_t shaft = 0;  ///< of an ideal servo: counts turned
  std::int64_t zero = 0;   ///< encoder register when the encoder stands at 0
  Sign direction = Sign::plus;
  int arrived_by = 0;      ///< direction of the last count of its run
  int run = -1;            ///< index of the axis' run; -1: none
  bool under_way = false;  ///< between the `began` and `rested` events
  bool was_holding = false;
  bool was_in_position = true, slipped = false;

  std::optional<HomeOrder> homing;     ///< the edge is still to come
  std::optional<std::int64_t> goal;    ///< absolute target of its own run; not shifted by LP
  std::optional<std::int64_t> passes;  ///< MV: occupied until this position is passed
  std::optional<Return> then_to;       ///< destination after coming to rest
  std::optional<double> then_jog;      ///< after coming to rest: jogs the other way
  std::optional<std::int64_t> notify;  ///< IN
  std::optional<Instant> correct_at;   ///< position maintenance: its next pulses
  std::int64_t correct_by = 0;

  bool has_motor = false;
  motion::ServoLoop loop;
  bool index_passed = false;  ///< between the last two updates of the loop

  [[nodiscard]] bool servo() const { return fitting.kind == AxisKind::servo; }
  /// A servo that is switched off: it moves nothing.
  [[nodiscard]] bool off() const { return servo() && !settings.holding; }
  [[nodiscard]] double counts_per_step() const {
    return servo() ? 1 : plant.place().counts_per_step.value_or(1);
  }
  /// Encoder count for a load position, without `zero`.
  [[nodiscard]] std::int64_t counted(Steps load) const;
  [[nodiscard]] std::int64_t encoder() const;
  void set_encoder(std::int64_t value) { zero += value - encoder(); }
  /// ER: expected encoder position for a motor position.
  [[nodiscard]] std::int64_t expected(std::int64_t at) const;
  [[nodiscard]] std::int64_t error() const { return expected(position) - encoder(); }
  /// The error in counts after `counts` more counts that way, as far as the load permits.
  [[nodiscard]] std::int64_t error_after(int way, std::int64_t counts) const;
  [[nodiscard]] bool watches_slip() const {
    return settings.slip_tolerance > 0 && fitting.encoder && !settings.tracking && !off();
  }
  [[nodiscard]] bool home_active() const { return plant.home_operated() != settings.home_active_high; }
  [[nodiscard]] bool index_active() const;
  /// Counts that way until home acts by HS or HE; none: it does not lie that way.
  [[nodiscard]] std::optional<std::int64_t> counts_until_home(Sign way) const;
  /// Sets the command register without making a count.
  void set_position(std::int64_t value) {
    position = value;
    reach();
  }
  void reach() {
    span.lowest = std::min(span.lowest, position);
    span.highest = std::max(span.highest, position);
  }
  /// Makes `count` counts: command register, shaft and load.
  void turn(int way, std::int64_t count);
  /// Turns only motor and load.
  void turn_load(int way, std::int64_t count);
  /// Counts to the first index mark at which the home input is also active.
  [[nodiscard]] std::optional<std::int64_t> counts_until_index(Sign way) const;
};

}  // namespace hw::vme58
