#include "core/devices/vme58/program_language.h"

#include "core/devices/vme58/contour_text.h"
#include "core/devices/vme58/program_check.h"
#include "core/devices/vme58/program_rehearsal.h"

namespace hw::vme58 {
namespace {

class CommandStrings final : public Language, public ContourWriter {
 public:
  [[nodiscard]] ProgramReport analyse(std::string_view text, int) const override {
    return check_program(text);
  }
  [[nodiscard]] Result<Rehearsal> rehearse(std::string_view text,
                                           const RehearseOptions& options) const override {
    return rehearse_program(text, options);
  }
  [[nodiscard]] Result<std::string> write_contour(const ContourPlan& plan,
                                                  const Catalog& catalog) const override {
    return contour_text(plan, catalog);
  }
  [[nodiscard]] Result<std::string> write_staircase(const StaircasePlan& plan,
                                                    const Catalog& catalog) const override {
    return staircase_text(plan, catalog);
  }
  [[nodiscard]] std::vector<int> contour_outputs(const Catalog& catalog) const override {
    return vme58::contour_outputs(catalog);
  }
};

}  // namespace

const Language& program_language() {
  static const CommandStrings language;
  return language;
}

}  // namespace hw::vme58
