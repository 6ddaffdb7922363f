#include "core/devices/dmx_k_sa/program_language.h"

#include "core/devices/arcus/program_language.h"
#include "core/devices/arcus/program_rehearsal.h"
#include "core/devices/dmx_k_sa/catalog.h"
#include "core/devices/dmx_k_sa/emulator.h"

namespace hw::dmx_k_sa {
namespace {

class ProgramLanguage final : public Language {
 public:
  [[nodiscard]] ProgramReport analyse(std::string_view text, int /*slot*/) const override {
    return arcus::analyse_program(text, arcus::language::dmx_k_sa());
  }
  [[nodiscard]] Result<Rehearsal> rehearse(std::string_view text,
                                           const RehearseOptions& options) const override {
    const auto catalog = make_catalog({});
    auto emulator = make_emulator({{"unaddressed", "yes"}});
    if (!emulator) return fail(emulator.error());
    return arcus::rehearse_program(text, options, **emulator, *catalog, arcus::language::dmx_k_sa());
  }
};

}  // namespace

const Language& program_language() {
  static const ProgramLanguage language;
  return language;
}

}  // namespace hw::dmx_k_sa
