#include "core/devices/dmx_k_sa/emulator.h"

#include "core/devices/arcus/emulator_arcus.h"
#include "core/devices/dmx_k_sa/emulator_commands.h"
#include "core/devices/dmx_k_sa/facts.h"

namespace hw::dmx_k_sa {

Result<std::unique_ptr<Emulator>> make_emulator(const std::map<std::string, std::string>& options) {
  constexpr bool has_usb = false, has_reply_cr = true;
  auto read = arcus::read_options(model, options, has_usb, has_reply_cr);
  if (!read) return fail(read.error());
  return std::make_unique<arcus::ArcusEmulator>(model, commands(), *read);
}

}  // namespace hw::dmx_k_sa
