#pragma once
// Steps as shown and typed: in steps, or in the real unit of the mechanics. Decimal point, thin space between
// groups of three from five figures on, a real minus sign, as many decimals as one step needs.
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/base/units.h"
#include "core/device/catalog.h"
#include "core/device/snapshot.h"

namespace hw::gui {

/// How one axis is shown.
struct DisplayUnit {
  std::string name = "steps";  ///< "mm", "°", or the controller's own word
  double per_step = 1;         ///< units per step
  int decimals = 0;
  bool real = false;  ///< false: the controller's own steps
  bool operator==(const DisplayUnit&) const = default;
};

/// A number on the stack: no allocation in frames at rest.
class NumberText {
 public:
  [[nodiscard]] std::string_view view() const { return {bytes_, size_}; }
  operator std::string_view() const { return view(); }  // NOLINT: converts on purpose
  void append(std::string_view s);

 private:
  char bytes_[64];
  std::size_t size_ = 0;
};

NumberText format_number(double value, int decimals);
/// "−150.000", without unit.
NumberText format_position(Steps position, const DisplayUnit& unit);
/// "−150.000 mm"; degrees stand close: "−150.00°".
NumberText format_with_unit(Steps position, const DisplayUnit& unit);
/// "5.000 mm/s", "2000 steps/s".
NumberText format_speed(Pps speed, const DisplayUnit& unit);
/// A unit given in Catalog::step_word ("pulses/s"), in what is counted now: Catalog::loop_word when the loop
/// of that axis, or of all axes if none is given, is closed. With mixed loops no word fits: "/s".
std::string counted_unit(const Catalog& catalog, const Snapshot& now, std::string_view unit, int axis = -1);
/// "1 line", "24 lines": the catalog's units of programs are plurals.
std::string count_of(int n, std::string_view unit);
/// "18 s", "1 min 08.6 s": for sentences.
NumberText format_duration(double seconds);

/// Reads typed text, with comma or point, any minus sign, spaces between groups and perhaps the unit, rounded
/// to whole steps. Two points, or a comma and a point, are refused, never guessed.
Result<Steps> parse_position(std::string_view text, const DisplayUnit& unit);
Result<double> parse_number(std::string_view text);

Steps to_steps(double value, const DisplayUnit& unit);
double from_steps(Steps steps, const DisplayUnit& unit);

/// As many decimals as one step needs: 3 for 0.0025.
int decimals_of(double per_step);

/// One entry of the list of jog steps.
struct JogStep {
  Steps steps;
  std::string id;       ///< last part of `jog/step/...`: "0.1", "step"
  std::string label;    ///< "0.1 mm", "1 step"
  std::string caption;  ///< not empty: the rounded value of the label
  std::string number;   ///< the label without its unit
};
/// `many` entries (4 or 5) from one step up, in powers of ten of the unit.
std::vector<JogStep> jog_steps(const DisplayUnit& unit, int many = 5);

}  // namespace hw::gui
