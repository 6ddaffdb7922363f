#pragma once
// Units of a script's own: what it calls a length or an angle, and how many steps of an axis that is.
#include <array>
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
  double steps_per_unit = 1;
};

/// By controller and axis; they hold for this run.
class AxisUnits {
 public:
  void tell(const std::shared_ptr<Session>& session, int axis, AxisUnit unit);
  /// Null: none was told.
  [[nodiscard]] const AxisUnit* find(const std::shared_ptr<Session>& session, int axis) const;

 private:
  std::map<std::shared_ptr<Session>, std::array<std::optional<AxisUnit>, max_axes>> told_;
};

/// In what one call counts: {unit=true} among its options means the axis' own unit, else it counts steps.
class Counting {
 public:
  explicit Counting(bool in_units) : in_units_(in_units) {}
  [[nodiscard]] bool in_units() const { return in_units_; }
  /// 1 for steps; Misuse where the axis has no unit yet.
  [[nodiscard]] double steps_per_unit(const Call& call, const OneAxis& one) const;
  /// The same to be told with what is read; 0: in steps.
  [[nodiscard]] double per_unit(const Call& call, const OneAxis& one) const {
    return in_units_ ? steps_per_unit(call, one) : 0;
  }
  /// The number at `place` of the stack, in steps. `what`: "a target".
  [[nodiscard]] Steps steps(const Call& call, int place, const OneAxis& one, const char* what) const;

 private:
  bool in_units_;
};

/// A whole number of steps, or where `per_unit` is not 0 a number of units.
void push_steps(lua_State* L, Steps steps, double per_unit);

}  // namespace hw::script
