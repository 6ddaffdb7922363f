#pragma once
// The ways to a controller, by the name that an address gives them. transports/ opens them; everybody else
// who has to know which there are asks here. Any thread.
#include <span>
#include <string_view>
#include <vector>

#include "core/device/catalog.h"

namespace hw {

struct TransportInfo {
  enum class Reaches : std::uint8_t {
    lines,
    windows,
    both
  };  ///< devices spoken to in bytes, boards on a bus
  enum class Place : std::uint8_t { none, optional, needed };
  std::string_view name;     ///< in an address: "rfc2217"
  std::string_view title;    ///< in a list: "RFC 2217"
  std::string_view example;  ///< of WHERE
  Reaches reaches;
  Place place = Place::needed;
  bool is_port = false;   ///< of this computer, one of those that are searched
  bool has_rate = false;  ///< baud=
  bool has_base = false;  ///< base=, of a window in the short address space
  bool is_usb = false;    ///< only controllers with a USB plug
};

std::span<const TransportInfo> transports();
/// Null: there is no such way.
const TransportInfo* find_transport(std::string_view name);
/// To a real controller of this kind, in their order.
std::vector<const TransportInfo*> ways_to(const Catalog& catalog);

}  // namespace hw
