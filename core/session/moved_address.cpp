#include "core/session/moved_address.h"

#include <fmt/core.h>

#include "core/session/transport_list.h"

namespace hw {
namespace {

/// The value as an address option; empty: no such option.
std::string as_option(const ParamInfo& param, std::int64_t value) {
  if (param.address_option == "id") return fmt::format("{:02}", value);
  for (const ParamChoice& choice : param.choices)
    if (choice.value == value) return choice.label.substr(0, choice.label.find(' '));
  return {};
}

std::string usual_option(const Catalog& catalog, std::string_view option) {
  return option == "id" ? catalog.id() : std::to_string(catalog.can.usual_baud);
}

/// Whether the value is in force, or will be after a power cycle.
bool holds(const ParamInfo& param, const ParamState& state, bool answers) {
  if (!state.known) return false;
  return answers ? param.holds_at_once && state.stored : param.holds_at_once || state.stored;
}

/// Whether the option matters on this transport.
bool matters(const TransportInfo& way, std::string_view option) {
  return option == "baud" ? way.has_rate : !way.is_usb;
}

std::string option_of(const Address& address, const std::string& key) {
  const auto found = address.options.find(key);
  return found == address.options.end() ? std::string() : found->second;
}

}  // namespace

std::optional<Address> moved_address(const Catalog& catalog, const Snapshot& now, const Address& opened) {
  const TransportInfo* way = find_transport(opened.transport);
  if (!way || opened.emulated()) return {};
  std::optional<Address> moved;
  for (std::size_t i = 0; i < catalog.params.size(); ++i) {
    const ParamInfo& param = catalog.params[i];
    if (param.address_option.empty() || !matters(*way, param.address_option)) continue;
    if (!holds(param, now.params[i], now.link.connected())) continue;
    const std::string is = as_option(param, now.params[i].value);
    std::string was = option_of(opened, param.address_option);
    if (was.empty()) was = usual_option(catalog, param.address_option);
    if (is.empty() || is == was) continue;
    if (!moved) moved = opened;
    moved->options[param.address_option] = is;
  }
  return moved;
}

std::string words_of_move(const Address& from, const Address& to) {
  std::string words;
  if (const std::string id = option_of(to, "id"); id != option_of(from, "id"))
    words = (to.ids().size() > 1 ? "addresses " : "address ") + id;
  if (const std::string rate = option_of(to, "baud"); rate != option_of(from, "baud"))
    words += fmt::format("{}{} baud", words.empty() ? "" : " and ", rate);
  return words;
}

}  // namespace hw
