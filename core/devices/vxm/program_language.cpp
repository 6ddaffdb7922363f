#include "core/devices/vxm/program_language.h"

#include <algorithm>

#include "core/device/settings_in_text.h"
#include "core/devices/vxm/program_analysis.h"
#include "core/devices/vxm/program_rehearsal.h"
#include "core/devices/vxm/sequence_commands.h"
#include "core/devices/vxm/sequence_reader.h"
#include "core/devices/vxm/sequence_writer.h"

namespace hw::vxm {
namespace {

class VxmLanguage final : public Language, public PartialWriter, public SettingsInText {
 public:
  [[nodiscard]] ProgramReport analyse(std::string_view text, int slot) const override {
    Analysis analysis = analyse_text(text, slot);
    check_programs(analysis);
    return std::move(analysis.report);
  }
  [[nodiscard]] Result<Rehearsal> rehearse(std::string_view text,
                                           const RehearseOptions& options) const override {
    return rehearse_program(text, options);
  }
  [[nodiscard]] Result<SequenceText> write(const sequence::Sequence& sequence,
                                           const Catalog& catalog) const override {
    return write_sequence(sequence, catalog);
  }
  [[nodiscard]] Result<SequenceText> write_with_gaps(const sequence::Sequence& sequence,
                                                     const Catalog& catalog,
                                                     std::vector<RefusedStep>& refused) const override {
    return write_sequence(sequence, catalog, &refused);
  }
  [[nodiscard]] Result<SequenceRead> read(std::string_view text, const sequence::Sequence& frame,
                                          const Catalog& catalog) const override {
    return read_sequence(text, frame, catalog);
  }
  [[nodiscard]] bool only_sets(std::string_view text) const override {
    const Operations all = behind("I1M1\n", text), others = behind("I2M1\n", text);
    return !all.empty() && std::all_of(all.begin(), all.end(), [](const Operation& o) { return o.speed; }) &&
           std::equal(
               all.begin(), all.end(), others.begin(), others.end(),
               [](const Operation& a, const Operation& b) { return a.text == b.text && a.sets == b.sets; });
  }

 private:
  /// A command without a motor addresses the motor of the command before it.
  [[nodiscard]] static Operations behind(std::string_view command, std::string_view text) {
    Operations all = operations_of(std::string(command) += text);
    if (!all.empty()) all.erase(all.begin());
    return all;
  }
};

}  // namespace

const Language& program_language() {
  static const VxmLanguage language;
  return language;
}

}  // namespace hw::vxm
