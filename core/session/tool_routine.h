#pragma once
// What the tool of a drawing does when it is lowered or lifted, as a line of text: "Z to -2, DO3 on, wait 250
// ms". Outputs and axes are called as their controller calls them.
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/device/catalog.h"
#include "core/sequence/sequence.h"

namespace hw {

/// Steps of its unit that an axis has which is not among them yet.
using PerUnit = std::function<double(const std::string& axis)>;

/// An axis waits for the end of its motion. One that does not draw joins `axes` behind those that do, the
/// first two. The fault says what is not understood.
[[nodiscard]] Result<sequence::StepList> read_routine(std::string_view text, const Catalog& catalog,
                                                      const PerUnit& per_unit,
                                                      std::vector<sequence::Axis>& axes);
/// Reads back as the same steps.
[[nodiscard]] std::string write_routine(const sequence::StepList& steps, const Catalog& catalog,
                                        const std::vector<sequence::Axis>& axes);

/// Every output that lowering leaves switched is switched back by lifting: else a stop would leave the tool
/// on. A pulse, which lowering takes back itself, is none of them.
[[nodiscard]] Result<> switches_back(const sequence::StepList& down, const sequence::StepList& up,
                                     const Catalog& catalog);

}  // namespace hw
