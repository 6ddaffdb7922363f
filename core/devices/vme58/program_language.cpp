#include "core/devices/vme58/program_language.h"

#include <algorithm>

#include "core/device/places_in_text.h"
#include "core/device/scaled_numbers.h"
#include "core/device/settings_in_text.h"
#include "core/devices/vme58/program_check.h"
#include "core/devices/vme58/program_rehearsal.h"
#include "core/devices/vme58/sequence_commands.h"
#include "core/devices/vme58/sequence_reader.h"
#include "core/devices/vme58/sequence_writer.h"

namespace hw::vme58 {
namespace {

class CommandStrings final : public Language,
                             public PartialWriter,
                             public PlacesInText,
                             public SettingsInText,
                             public ScaledNumbers {
 public:
  [[nodiscard]] ProgramReport analyse(std::string_view text, int) const override {
    return check_program(text);
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
  [[nodiscard]] std::vector<AxisTarget> places_in(std::string_view text, int) const override {
    return places_of_text(text);
  }
  [[nodiscard]] bool only_sets(std::string_view text) const override {
    Operations all = operations_of(std::string("AA ") += text);  // as blocks write it
    if (!all.empty()) all.erase(all.begin());
    return !all.empty() && std::all_of(all.begin(), all.end(), [](const Operation& o) { return o.speed; });
  }
};

}  // namespace

const Language& program_language() {
  static const CommandStrings language;
  return language;
}

}  // namespace hw::vme58
