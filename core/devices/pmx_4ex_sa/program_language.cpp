#include "core/devices/pmx_4ex_sa/program_language.h"

#include "core/devices/arcus/program_rehearsal.h"
#include "core/devices/pmx_4ex_sa/catalog.h"
#include "core/devices/pmx_4ex_sa/emulator.h"

namespace hw::pmx_4ex_sa {

const Language& program_language() {
  static const arcus::ProgramLanguage language(arcus::language::pmx_4ex_sa(), make_catalog, make_emulator);
  return language;
}

}  // namespace hw::pmx_4ex_sa
