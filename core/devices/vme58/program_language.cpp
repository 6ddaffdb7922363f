#include "core/devices/vme58/program_language.h"

#include "core/devices/vme58/program_check.h"
#include "core/devices/vme58/program_rehearsal.h"

namespace hw::vme58 {
namespace {

class CommandStrings final : public Language {
 public:
  [[nodiscard]] ProgramReport analyse(std::string_view text, int) const override {
    return check_program(text);
  }
  [[nodiscard]] Result<Rehearsal> rehearse(std::string_view text,
                                           const RehearseOptions& options) const override {
    return rehearse_program(text, options);
  }
};

}  // namespace

const Language& program_language() {
  static const CommandStrings language;
  return language;
}

}  // namespace hw::vme58
