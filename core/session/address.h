#pragma once
// MODEL@TRANSPORT[:WHERE][,key=value...]: a controller and the way to it.
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/base/result.h"

namespace hw {

struct Address {
  std::string model;      ///< "vxm", lower case
  std::string transport;  ///< "emulator", "serial", "tcp", "rfc2217" ...
  std::string where;      ///< "/dev/ttyUSB0", "HOST:PORT"; empty for an emulator
  std::map<std::string, std::string> options;

  /// Checks form, model (of device_types()) and transport name, not whether the place exists.
  static Result<Address> parse(std::string_view text);
  /// The same address in canonical form.
  [[nodiscard]] std::string text() const;
  /// The ids that id= names ("07" or "01-04"), in order; empty without id=.
  [[nodiscard]] std::vector<std::string> ids() const;
  /// One address for each id; without id= just this address.
  [[nodiscard]] std::vector<Address> devices() const;
  [[nodiscard]] bool emulated() const { return transport == "emulator"; }
  /// `fallback` when absent; a fault when not a whole number.
  [[nodiscard]] Result<int> number(std::string_view key, int fallback) const;
  bool operator==(const Address&) const = default;
};

/// The models for an address: "vxm, pmx-4ex-sa, dmx-k-sa".
std::string known_models();
/// The fault for an unknown model name. It advises the known models and, if there is one, a similar name.
Fault unknown_model(std::string_view model);
/// "HOST:PORT" or "[IPV6]:PORT".
Result<std::pair<std::string, int>> split_host_port(std::string_view where);

}  // namespace hw
