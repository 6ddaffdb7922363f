#pragma once
// The routine that lowers or lifts the tool of a drawing, as a line of text: "Z to -2, DO3 on, wait 250 ms".
// Outputs and axes have their controller's names.
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/device/catalog.h"
#include "core/sequence/sequence.h"

namespace hw {

/// A tool that an axis lowers, an output switches, or both.
struct PlainTool {
  std::string axis;     ///< empty: none
  double per_unit = 1;  ///< see PerUnit
  double down = 0, up = 0;
  std::optional<int> output;
  double down_delay_ms = 0, up_delay_ms = 0;  ///< until the output has acted
};
/// The tool is lowered before it is switched on, and switched off before it is lifted. Its axis is appended
/// to `axes`.
void put_tool(const PlainTool& tool, std::vector<sequence::Axis>& axes, sequence::StepList& pen_down,
              sequence::StepList& pen_up);

/// Steps per unit of an axis. Negative: the numbers count opposite to its steps. The moves then have the
/// opposite sign, and their axis has the positive scale.
using PerUnit = std::function<double(const std::string& axis)>;

/// Each move includes the wait for its end. An axis that does not draw is appended to `axes`, whose first two
/// draw. The fault names the text that is not understood.
[[nodiscard]] Result<sequence::StepList> read_routine(std::string_view text, const Catalog& catalog,
                                                      const PerUnit& per_unit,
                                                      std::vector<sequence::Axis>& axes);
/// The text of a routine; read_routine() returns the same steps.
[[nodiscard]] std::string write_routine(const sequence::StepList& steps, const Catalog& catalog,
                                        const std::vector<sequence::Axis>& axes);

/// Checks that lifting switches back every output that lowering leaves switched; otherwise a stop would leave
/// the tool on. A pulse, which lowering itself ends, does not count.
[[nodiscard]] Result<> switches_back(const sequence::StepList& down, const sequence::StepList& up,
                                     const Catalog& catalog);

}  // namespace hw
