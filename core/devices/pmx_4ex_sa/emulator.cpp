#include "core/devices/pmx_4ex_sa/emulator.h"

#include "core/devices/arcus/emulator_arcus.h"
#include "core/devices/pmx_4ex_sa/emulator_commands.h"
#include "core/devices/pmx_4ex_sa/facts.h"

namespace hw::pmx_4ex_sa {

Result<std::unique_ptr<Emulator>> make_emulator(const std::map<std::string, std::string>& options) {
  constexpr bool has_usb = true, has_reply_cr = false;
  auto read = arcus::read_options(model, options, has_usb, has_reply_cr);
  if (!read) return fail(read.error());
  return std::make_unique<arcus::ArcusEmulator>(model, commands(), *read);
}

}  // namespace hw::pmx_4ex_sa
