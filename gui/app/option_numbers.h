#pragma once
// Reads numbers from the text of an option: "200,100", "0,0,300,200".
#include <cstddef>
#include <vector>

#include "core/base/result.h"
#include "gui/app/cli.h"

namespace hw::app {

/// The fault of an option that is not understood; `form` is the form to write instead.
[[nodiscard]] tl::unexpected<Fault> wrong(const char* option, const Given& given, const char* form);
/// Reads at least `least` and at most `most` numbers, with `at` between them.
[[nodiscard]] Result<std::vector<double>> numbers(const Given& given, const char* option, char at,
                                                  std::size_t least, std::size_t most, const char* form);

}  // namespace hw::app
