#pragma once
// Log of the decisions of a wire and its stations: dropped, cut short, outstanding, given up. --log
// link=debug.
#include <fmt/core.h>

#include "core/base/log.h"

namespace hw {

inline log::Subject& link_log() {
  static log::Subject& one = log::subject("link");
  return one;
}

/// Formats the station's device on a wire of several: "03: "; alone: nothing.
struct OfDevice {
  int address;
};

}  // namespace hw

template <>
struct fmt::formatter<hw::OfDevice> {
  constexpr auto parse(fmt::format_parse_context& context) { return context.begin(); }
  auto format(hw::OfDevice of, fmt::format_context& context) const {
    return of.address < 0 ? context.out() : fmt::format_to(context.out(), "{:02}: ", of.address);
  }
};
