#pragma once
// Log of the decisions of a pump and its driver: why something was refused, dropped, sent again or given up.
// --log pump=debug, --log driver.vxm=debug. Io thread.
#include <fmt/core.h>

#include "core/base/log.h"
#include "core/device/catalog.h"
#include "core/device/stop.h"

namespace hw {

/// Formats the controller's name: "vxm", "dmx-k-sa 03".
struct LogName {
  const Catalog& catalog;
};

log::Subject& pump_log();
/// Looked up by name: only for rare events.
log::Subject& driver_log(const Catalog& catalog);

}  // namespace hw

template <>
struct fmt::formatter<hw::LogName> {
  constexpr auto parse(fmt::format_parse_context& context) { return context.begin(); }
  auto format(hw::LogName name, fmt::format_context& context) const {
    const hw::Catalog& c = name.catalog;
    return c.address < 0 ? fmt::format_to(context.out(), "{}", c.model)
                         : fmt::format_to(context.out(), "{} {:02}", c.model, c.address);
  }
};

/// "stop 7 (axis 2, at once)".
template <>
struct fmt::formatter<hw::StopOrder> {
  constexpr auto parse(fmt::format_parse_context& context) { return context.begin(); }
  auto format(const hw::StopOrder& order, fmt::format_context& context) const {
    using What = hw::StopOrder::What;
    constexpr const char* names[] = {"everything",      "a jog",    "a program",
                                     "all on the wire", "as typed", "the tool"};
    static_assert(std::size(names) == static_cast<std::size_t>(What::tool) + 1);
    std::string what = names[static_cast<std::size_t>(order.what)];
    if (order.axis >= 0) what += fmt::format(", axis {}", order.axis + 1);
    if (order.at_once) what += ", at once";
    return fmt::format_to(context.out(), "stop {} ({})", order.number, what);
  }
};
