// Any bytes as an address: what is accepted reads the same again in its canonical form.
#include <cstddef>
#include <cstdint>
#include <cstdlib>

#include "core/device/registry.h"
#include "core/session/address.h"

// One model is enough, and keeps the drivers out of this target.
namespace hw {
std::span<const DeviceType> device_types() {
  static const DeviceType only = [] {
    DeviceType t{};
    t.model = "vxm";
    return t;
  }();
  return {&only, 1};
}
const DeviceType* find_device_type(std::string_view model) {
  return model == "vxm" ? device_types().data() : nullptr;
}
}  // namespace hw

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
