#pragma once
// The transports by their names in addresses. transports/ opens them; all other code finds them here. Any
// thread.
#include <span>
#include <string_view>
#include <vector>

#include "core/device/catalog.h"

namespace hw {

struct TransportInfo {
  enum class Reaches : std::uint8_t { lines, windows, both };  ///< byte-stream devices, boards on a bus
  enum class Place : std::uint8_t { none, optional, needed };
  std::string_view name;     ///< in an address: "rfc2217"
  std::string_view title;    ///< in a list: "RFC 2217"
  std::string_view example;  ///< of WHERE
  Reaches reaches;
  Place place = Place::needed;
  bool is_port = false;   ///< a port of this computer, included in searches
  bool has_rate = false;  ///< baud=
  bool has_base = false;  ///< base=, of the window in the short address space
  bool is_usb = false;    ///< only controllers with a USB plug
};

std::span<const TransportInfo> transports();
/// Null: no such transport.
const TransportInfo* find_transport(std::string_view name);
/// The transports to a real controller of this kind, in list order.
std::vector<const TransportInfo*> ways_to(const Catalog& catalog);

}  // namespace hw
