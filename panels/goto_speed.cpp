#include "panels/goto_speed.h"

#include <algorithm>
#include <cmath>

#include "gui/model/tab.h"

namespace hw::panels {

using namespace gui;

namespace {

/// A typed speed never becomes Pps(0), which would mean the controller's own speed.
Pps at_least_one(double steps) { return Pps(std::max(1.0, std::round(steps))); }

class TypedSpeed {
 public:
  TypedSpeed(const Frame& f, const std::vector<AxisTarget>& targets, bool by, double typed)
      : f_(f), targets_(targets), by_(by), typed_(typed) {
    for (const AxisTarget& target : targets) {
      const DisplayUnit& unit = unit_of(target);
      if (!unit.real) continue;
      const double steps = typed / unit.per_step;
      slowest_ = slowest_ > 0 ? std::min(slowest_, steps) : steps;
      if (!first_) first_ = &unit;
      one_unit_ = one_unit_ && unit.name == first_->name;
    }
  }

  [[nodiscard]] GoSpeed in_turn() const {
    GoSpeed speed{usual(), {}};
    for (const AxisTarget& target : targets_)
      speed.own_speeds[target.axis.index] = at_least_one(own_speed(target));
    return speed;
  }
  [[nodiscard]] GoSpeed together() const {
    if (!lengths_known()) return {slowest_of_all(), {}};
    double length = 0, lasts = 0, path = 0;
    for (const AxisTarget& target : targets_) {
      const double steps = distance(target);
      length = f_.catalog.can.speed_along_path ? std::hypot(length, steps) : std::max(length, steps);
      lasts = std::max(lasts, steps / own_speed(target));
      if (unit_of(target).real) path = std::hypot(path, steps * unit_of(target).per_step);
    }
    if (one_unit_) lasts = std::max(lasts, path / typed_);
    if (!first_ || lasts <= 0) return {usual(), {}};
    return {at_least_one(length / lasts), {}};
  }

 private:
  [[nodiscard]] const DisplayUnit& unit_of(const AxisTarget& target) const {
    return f_.tab.settings.units().length(target.axis);
  }
  [[nodiscard]] Pps usual() const { return at_least_one(first_ ? slowest_ : typed_); }
  [[nodiscard]] double own_speed(const AxisTarget& target) const {
    const DisplayUnit& unit = unit_of(target);
    if (unit.real) return typed_ / unit.per_step;
    return first_ ? slowest_ : typed_;
  }
  [[nodiscard]] bool lengths_known() const {
    return by_ || std::all_of(targets_.begin(), targets_.end(), [this](const AxisTarget& target) {
             const AxisState& axis = f_.now.axes[target.axis.index];
             return axis.position_known && !axis.moves();
           });
  }
  /// A speed with which no axis exceeds the typed speed, whatever the path.
  [[nodiscard]] Pps slowest_of_all() const {
    double slowest = typed_;
    for (std::size_t i = 0; i < targets_.size(); ++i)
      slowest = i == 0 ? own_speed(targets_[i]) : std::min(slowest, own_speed(targets_[i]));
    return at_least_one(slowest);
  }
  [[nodiscard]] double distance(const AxisTarget& target) const {
    const Steps from = by_ ? Steps(0) : f_.now.axes[target.axis.index].commanded();
    return std::abs(static_cast<double>((target.value - from).value));
  }

  const Frame& f_;
  const std::vector<AxisTarget>& targets_;
  const bool by_;
  const double typed_;
  const DisplayUnit* first_ = nullptr;  ///< unit of the first axis that has one
  double slowest_ = 0;                  ///< speed in steps/s of the slowest axis that has a unit
  bool one_unit_ = true;
};

}  // namespace

GoSpeed speed_of_go(const Frame& f, const std::vector<AxisTarget>& targets, bool by, double typed) {
  if (typed <= 0) return {};
  const TypedSpeed way(f, targets, by, typed);
  return f.catalog.can.interpolates ? way.together() : way.in_turn();
}

std::string_view speed_together_is(const Frame& f, std::uint32_t axes) {
  if (!f.catalog.can.interpolates || f.catalog.axes.size() < 2) return {};
  const DisplayUnit* first = nullptr;  // as in TypedSpeed
  bool one_unit = true;
  for (std::uint8_t axis = 0; axis < f.catalog.axes.size(); ++axis) {
    const DisplayUnit& unit = f.tab.settings.units().length(AxisId{axis});
    if (!((axes >> axis) & 1u) || !unit.real) continue;
    if (!first) first = &unit;
    one_unit = one_unit && unit.name == first->name;
  }
  if (!one_unit) return " For several axes: of the fastest one.";
  if (first || f.catalog.can.speed_along_path) return " For several axes: along their path.";
  return " For several axes: of the longest way.";
}

}  // namespace hw::panels
