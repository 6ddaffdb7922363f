#pragma once
// The table of options that a call may end with: c:move_to({X=5000}, {speed=2000}).
#include <optional>
#include <string>
#include <vector>

#include "core/base/units.h"
#include "core/device/intent.h"
#include "core/script/axis_units.h"
#include "core/script/call.h"

namespace hw::script {

using intent::Acceleration;

class Options {
 public:
  /// No table: all options are absent. A key not in `known` is Misuse that names the probable one.
  Options(const Call& call, int argument, const char* function, std::vector<std::string> known);

  /// Above 0, whatever the unit's direction; absent: 0, the controller's own speed.
  [[nodiscard]] Pps speed(double steps_per_unit = 1) const;
  /// A whole number in the controller's own unit.
  [[nodiscard]] Acceleration acceleration() const;
  /// A number above 0; absent: none.
  [[nodiscard]] std::optional<double> above_zero(const char* key, const char* unit) const;
  /// The unit of this call: {unit=true}.
  [[nodiscard]] Counting counting() const;
  [[nodiscard]] std::optional<std::string> text(const char* key) const;

 private:
  /// Pushes the value by raw access: no __index of the script may run here.
  int push(const char* key) const;

  lua_State* const L_;
  const char* const function_;
  const int table_;  ///< 0: none given
};

}  // namespace hw::script
