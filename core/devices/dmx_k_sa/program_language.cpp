#include "core/devices/dmx_k_sa/program_language.h"

#include "core/devices/arcus/program_rehearsal.h"
#include "core/devices/dmx_k_sa/catalog.h"
#include "core/devices/dmx_k_sa/emulator.h"

namespace hw::dmx_k_sa {

const Language& program_language() {
  static const arcus::ProgramLanguage language(arcus::language::dmx_k_sa(), make_catalog, make_emulator);
  return language;
}

}  // namespace hw::dmx_k_sa
