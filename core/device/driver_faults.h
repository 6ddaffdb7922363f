#pragma once
// Faults that drivers of all families word alike.
#include <string>
#include <string_view>
#include <utility>

#include "core/base/result.h"

namespace hw {

/// `device`: "controller" or "board".
inline tl::unexpected<Fault> not_connected(std::string_view device) {
  return fail(FaultKind::lost, "There is no connection to the " + std::string(device) + ".",
              "Nothing was sent.");
}

/// `advice`: how to stop the machine without the console.
inline tl::unexpected<Fault> stop_cannot_reach(std::string_view device, std::string advice) {
  return fail(FaultKind::lost, "Stop cannot reach the " + std::string(device) + ": there is no connection.",
              "Nothing was sent.", std::move(advice));
}

}  // namespace hw
