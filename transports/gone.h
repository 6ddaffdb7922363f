#pragma once
// The fault of a lost wire: cable, other side or device gone. Whether the last bytes sent arrived and were
// carried out is unknown.
#include <string>

#include "core/base/result.h"

namespace hw {

inline Fault gone(std::string what, std::string advice) {
  return Fault(FaultKind::lost, std::move(what), "Commands on the way may have been carried out.",
               std::move(advice));
}

}  // namespace hw
