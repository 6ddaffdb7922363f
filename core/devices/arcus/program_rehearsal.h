#pragma once
// A dry run of a program on an emulator, in virtual time. Pure and slow: call it on a worker thread.
#include "core/device/catalog.h"
#include "core/device/language.h"
#include "core/device/places_in_text.h"
#include "core/device/refused_steps.h"
#include "core/device/registry.h"
#include "core/devices/arcus/emulator_arcus.h"
#include "core/devices/arcus/language/dialect.h"

namespace hw::arcus {

/// `emulator`: just powered up. Runs program 0 and the programs that it starts.
Result<Rehearsal> rehearse_program(std::string_view text, const RehearseOptions& options, Emulator& emulator,
                                   const Catalog& catalog, const language::Dialect& dialect);

/// The language of one model: texts by its dialect, dry runs on its emulator.
class ProgramLanguage final : public Language, public PartialWriter, public PlacesInText {
 public:
  using MakeCatalog = Result<Catalog> (*)(const DeviceOptions&);
  using MakeEmulator = Result<std::unique_ptr<Emulator>> (*)(const DeviceOptions&);
  ProgramLanguage(const language::Dialect& dialect, MakeCatalog make_catalog, MakeEmulator make_emulator)
      : dialect_(dialect), make_catalog_(make_catalog), make_emulator_(make_emulator) {}

  [[nodiscard]] ProgramReport analyse(std::string_view text, int slot) const override;
  [[nodiscard]] Result<Rehearsal> rehearse(std::string_view text,
                                           const RehearseOptions& options) const override;
  [[nodiscard]] Result<SequenceText> write(const sequence::Sequence& sequence,
                                           const Catalog& catalog) const override;
  [[nodiscard]] Result<SequenceText> write_with_gaps(const sequence::Sequence& sequence,
                                                     const Catalog& catalog,
                                                     std::vector<RefusedStep>& refused) const override;
  /// A sequence that fits into program memory becomes a program; straight lines of a longer one go through
  /// the buffer.
  [[nodiscard]] Result<Pieces> in_pieces(const sequence::Sequence& sequence, const Catalog& catalog,
                                         int from_step) const override;
  [[nodiscard]] Result<SequenceRead> read(std::string_view text, const sequence::Sequence& frame,
                                          const Catalog& catalog) const override;
  [[nodiscard]] std::string write_listing(const std::vector<std::string>& lines) const override;
  [[nodiscard]] std::vector<AxisTarget> places_in(std::string_view text, int start) const override;

 private:
  const language::Dialect& dialect_;
  const MakeCatalog make_catalog_;
  const MakeEmulator make_emulator_;
};

}  // namespace hw::arcus
