#pragma once
// A script's units of length or angle, and their size in steps of an axis.
#include <array>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/device/intent.h"

struct lua_State;

namespace hw {
class Session;
}

namespace hw::script {

class Call;
struct OneAxis;

struct AxisUnit {
  std::string name;
  double steps_per_unit = 1;  ///< below 0: units count opposite to steps
};

/// Units by controller and axis: those set by the script, for this run, else those the console keeps.
class AxisUnits {
 public:
  using Kept = std::function<std::optional<AxisUnit>(const Session&, int axis)>;
  Kept kept;  ///< null: the console keeps none

  void set(const std::shared_ptr<Session>& session, int axis, AxisUnit unit);
  [[nodiscard]] std::optional<AxisUnit> find(const std::shared_ptr<Session>& session, int axis) const;

 private:
  std::map<std::shared_ptr<Session>, std::array<std::optional<AxisUnit>, max_axes>> set_by_script_;
};

/// The unit of one call: the axis' own with the option {unit=true}, else steps.
class Counting {
 public:
  explicit Counting(bool in_units) : in_units_(in_units) {}
  [[nodiscard]] bool in_units() const { return in_units_; }
  /// 1 for steps. Misuse if the axis has no unit yet.
  [[nodiscard]] double steps_per_unit(const Call& call, const OneAxis& one) const;
  /// For the common speed of several axes, without sign. Misuse if their units differ.
  [[nodiscard]] double common_to(const Call& call, const std::vector<OneAxis>& axes) const;
  /// The same for values returned to the script; 0: in steps.
  [[nodiscard]] double per_unit(const Call& call, const OneAxis& one) const {
    return in_units_ ? steps_per_unit(call, one) : 0;
  }
  /// The number at stack index `place`, in steps. `what`: for messages, "a target".
  [[nodiscard]] Steps steps(const Call& call, int place, const OneAxis& one, const char* what) const;

 private:
  bool in_units_;
};

/// Pushes a whole number of steps or, if `per_unit` is not 0, a number of units.
void push_steps(lua_State* L, Steps steps, double per_unit);

}  // namespace hw::script
