// Any bytes as an address: what is accepted reads the same again in its canonical form.
#include <cstddef>
#include <cstdint>
#include <cstdlib>

#include "core/session/address.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  (void)hw::split_host_port(text);
  const auto address = hw::Address::parse(text);
  if (!address) return 0;
  (void)address->number("baud", 0);
  const auto again = hw::Address::parse(address->text());
  if (!again || again->text() != address->text()) std::abort();
  for (const hw::Address& device : address->devices()) {
    const auto alone = hw::Address::parse(device.text());
    if (!alone || alone->devices().size() != 1 || alone->ids() != device.ids()) std::abort();
  }
  return 0;
}
