#include "core/session/transport_list.h"

#include <algorithm>

namespace hw {
namespace {

using Reaches = TransportInfo::Reaches;
using Place = TransportInfo::Place;

constexpr TransportInfo list[] = {
    {.name = "emulator", .title = "emulator", .example = "", .reaches = Reaches::both, .place = Place::none},
    {.name = "serial",
     .title = "serial",
     .example = "/dev/ttyUSB0",
     .reaches = Reaches::lines,
     .is_port = true,
     .has_rate = true},
    {.name = "tcp", .title = "tcp", .example = "127.0.0.1:4001", .reaches = Reaches::lines},
    {.name = "rfc2217",
     .title = "RFC 2217",
     .example = "127.0.0.1:4001",
     .reaches = Reaches::lines,
     .has_rate = true},
    {.name = "usb",
     .title = "USB",
     .example = "",
     .reaches = Reaches::lines,
     .place = Place::optional,
     .is_usb = true},
    {.name = "vme",
     .title = "VME",
     .example = "/dev/bus/vme/m0",
     .reaches = Reaches::windows,
     .has_base = true},
    {.name = "bus", .title = "bus port", .example = "127.0.0.1:5000", .reaches = Reaches::windows},
};

}  // namespace

std::span<const TransportInfo> transports() { return list; }

const TransportInfo* find_transport(std::string_view name) {
  const auto found = std::find_if(std::begin(list), std::end(list),
                                  [&](const TransportInfo& transport) { return transport.name == name; });
  return found == std::end(list) ? nullptr : found;
}

std::vector<const TransportInfo*> ways_to(const Catalog& catalog) {
  const Reaches reaches = catalog.can.window ? Reaches::windows : Reaches::lines;
  std::vector<const TransportInfo*> ways;
  for (const TransportInfo& transport : list)
    if (transport.reaches == reaches && (!transport.is_usb || catalog.can.usb)) ways.push_back(&transport);
  return ways;
}

}  // namespace hw
