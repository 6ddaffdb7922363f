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
  /// None given: all are absent. A key that is not `known` is Misuse that names the one meant.
  Options(const Call& call, int argument, const char* function, std::vector<std::string> known);

  /// Above 0; absent: 0, which is the controller's own.
  [[nodiscard]] Pps speed(double steps_per_unit = 1) const;
  /// A whole number; what it counts is the controller's.
  [[nodiscard]] Acceleration acceleration() const;
  /// A number above 0; absent: none.
  [[nodiscard]] std::optional<double> above_zero(const char* key, const char* unit) const;
  /// {unit=true}: what this call counts.
  [[nodiscard]] Counting counting() const;
  [[nodiscard]] std::optional<std::string> text(const char* key) const;

 private:
  /// Pushes it, without the script's __index: no code of its may run in here.
  int push(const char* key) const;

  lua_State* const L_;
  const char* const function_;
  const int table_;  ///< 0: none given
};

}  // namespace hw::script
