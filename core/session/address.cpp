#include "core/session/address.h"

#include <algorithm>
#include <optional>

#include <fmt/core.h>

#include "core/base/near_name.h"
#include "core/base/number_text.h"
#include "core/device/registry.h"
#include "core/session/transport_list.h"

namespace hw {
namespace {

tl::unexpected<Fault> bad(std::string what) {
  return fail(
      FaultKind::text, std::move(what), "Nothing was opened.",
      "An address reads MODEL@TRANSPORT:WHERE,key=value, for example vxm@serial:/dev/ttyUSB0,baud=9600 "
      "or vxm@emulator.");
}

// "07" or "01-04": first and last, equal for one device.
std::optional<std::pair<int, int>> read_ids(std::string_view text) {
  const auto digit = [&](std::size_t i) { return text[i] >= '0' && text[i] <= '9'; };
  const auto number = [&](std::size_t i) { return (text[i] - '0') * 10 + (text[i + 1] - '0'); };
  const bool one = text.size() == 2, range = text.size() == 5 && text[2] == '-';
  if (!(one || range) || !digit(0) || !digit(1)) return std::nullopt;
  if (one) return std::pair(number(0), number(0));
  if (!digit(3) || !digit(4) || number(3) <= number(0)) return std::nullopt;
  return std::pair(number(0), number(3));
}

Result<> read_options(std::string_view rest, Address& address) {
  while (!rest.empty()) {
    const auto comma = rest.find(',');
    const std::string_view pair = rest.substr(0, comma);
    rest = comma == rest.npos ? std::string_view{} : rest.substr(comma + 1);
    const auto equals = pair.find('=');
    if (equals == pair.npos || equals == 0)
      return bad(fmt::format("\"{}\" in the address is not a key=value pair.", pair));
    auto& value = address.options[std::string(pair.substr(0, equals))];
    if (!value.empty()) return bad(fmt::format("The address gives {} twice.", pair.substr(0, equals)));
    value = pair.substr(equals + 1);
    if (value.empty()) return bad(fmt::format("The address gives no value for {}.", pair.substr(0, equals)));
    if (pair.substr(0, equals) == "id" && !read_ids(value))
      return bad(fmt::format(
          "id={} is not a device number: it takes two digits, as id=07, or a range, as id=01-04.", value));
  }
  return {};
}

}  // namespace

std::string known_models() {
  std::string all;
  for (const DeviceType& type : device_types()) all += (all.empty() ? "" : ", ") + std::string(type.model);
  return all;
}

Fault unknown_model(std::string_view model) {
  std::vector<std::string> models;
  std::string meant;
  for (const DeviceType& type : device_types()) {
    models.emplace_back(type.model);
    if (model.size() >= 3 && type.model.starts_with(model))
      meant = fmt::format(" Did you mean \"{}\"?", type.model);
  }
  if (meant.empty()) meant = did_you_mean(model, models);
  return {FaultKind::text,
          fmt::format("There is no controller model \"{}\".", model),
          {},
          fmt::format("Known: {}.{}", known_models(), meant)};
}

static std::string transport_near(std::string_view wanted) {
  std::vector<std::string> names;
  for (const TransportInfo& one : transports()) names.emplace_back(one.name);
  return did_you_mean(wanted, names);
}

Result<Address> Address::parse(std::string_view text) {
  constexpr std::size_t longest = 1000;
  if (text.size() > longest) return bad(fmt::format("An address of {} bytes is too long.", text.size()));
  Address address;
  const auto at = text.find('@');
  if (at == text.npos) return bad(fmt::format("\"{}\" is not an address: it has no @.", text));
  address.model = text.substr(0, at);
  std::transform(address.model.begin(), address.model.end(), address.model.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  if (!find_device_type(address.model)) {
    Fault unknown = unknown_model(text.substr(0, at));
    unknown.done = "Nothing was opened.";
    return fail(std::move(unknown));
  }
  const std::string_view rest = text.substr(at + 1);
  const auto comma = rest.find(',');
  const std::string_view way = rest.substr(0, comma);
  const auto colon = way.find(':');
  address.transport = way.substr(0, colon);
  if (colon != way.npos) address.where = way.substr(colon + 1);
  const TransportInfo* transport = find_transport(address.transport);
  if (!transport)
    return bad(
        fmt::format("\"{}\" is not a transport.{}", address.transport, transport_near(address.transport)));
  using Place = TransportInfo::Place;
  if (transport->place == Place::needed && address.where.empty())
    return bad(fmt::format("The address does not say where: {}@{}:WHERE.", address.model, address.transport));
  if (transport->place == Place::none && !address.where.empty())
    return bad(fmt::format("Leave \"{}\" out: an emulator has no place.", address.where));
  if (comma != rest.npos) {
    if (auto read = read_options(rest.substr(comma + 1), address); !read) return fail(read.error());
  }
  return address;
}

std::string Address::text() const {
  std::string out = model + "@" + transport;
  if (!where.empty()) out += ":" + where;
  for (const auto& [key, value] : options) out += "," + key + "=" + value;
  return out;
}

std::vector<std::string> Address::ids() const {
  const auto given = options.find("id");
  const auto range = given == options.end() ? std::nullopt : read_ids(given->second);
  std::vector<std::string> all;
  for (int id = range ? range->first : 1; id <= (range ? range->second : 0); ++id)
    all.push_back(fmt::format("{:02}", id));
  return all;
}

std::vector<Address> Address::devices() const {
  std::vector<Address> all;
  for (const std::string& id : ids()) {
    all.push_back(*this);
    all.back().options["id"] = id;
  }
  if (all.empty()) all.push_back(*this);
  return all;
}

Result<int> Address::number(std::string_view key, int fallback) const {
  const auto found = options.find(std::string(key));
  if (found == options.end()) return fallback;
  if (const auto value = whole_number<int>(found->second)) return *value;
  return bad(fmt::format("{}={} in the address is not a whole number.", key, found->second));
}

Result<std::pair<std::string, int>> split_host_port(std::string_view where) {
  const auto colon = where.rfind(':');
  if (colon == where.npos || colon == 0)
    return fail(FaultKind::text, fmt::format("\"{}\" is not HOST:PORT.", where), {},
                "For example 192.168.1.40:4001.");
  std::string_view host = where.substr(0, colon);
  const std::string_view digits = where.substr(colon + 1);
  if (host.size() > 2 && host.front() == '[' && host.back() == ']') host = host.substr(1, host.size() - 2);
  const int port = whole_number<int>(digits).value_or(-1);
  if (port < 0 || port > 65535)
    return fail(FaultKind::text, fmt::format("\"{}\" is not a port number (1 to 65535).", digits));
  return std::pair(std::string(host), port);
}

}  // namespace hw
