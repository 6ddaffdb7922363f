#pragma once
// The fault of a way to a controller that has gone: the cable, the other side, the device. Whether what was
// sent last has come there, and was carried out, nobody on this side can know.
#include <string>

#include "core/base/result.h"

namespace hw {

inline Fault gone(std::string what, std::string advice) {
  return Fault(FaultKind::lost, std::move(what), "What was on the way may have been carried out.",
               std::move(advice));
}

}  // namespace hw
