#pragma once
// The fault of a lost wire: the cable, the other side or the device is gone, and it is unknown whether the
// last bytes arrived and were carried out. And that of an emulator whose cable is out before anything was
// opened.
#include <string>

#include "core/base/result.h"

namespace hw {

inline Fault gone(std::string what, std::string advice) {
  return Fault(FaultKind::lost, std::move(what), "Commands on the way may have been carried out.",
               std::move(advice));
}

inline Fault cable_pulled(const std::string& controller) {
  return gone("The cable of the " + controller + " was pulled.", "Plug it in again.");
}

/// On opening an emulator whose cable is out.
inline Fault cable_is_out(const std::string& controller) {
  return Fault(FaultKind::port, "The cable of the " + controller + " is pulled.", "Nothing was opened.",
               "Plug it in again on the bench.");
}

}  // namespace hw
