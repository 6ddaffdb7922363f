#pragma once
// The programs that the console has loaded into the controller. A program with absolute targets must not be
// started while a count is doubtful, whoever starts it. One that a restart may have erased counts as long as
// it may be there. Unknown are programs that the console has not loaded, long ones, and what stands behind a
// command that no block describes, as that may set the count, except the places that the language names
// there.
#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/device/catalog.h"
#include "core/device/intent.h"
#include "core/device/language.h"
#include "core/device/snapshot.h"
#include "core/device/travel.h"

namespace hw {

class LoadedTexts {
 public:
  /// `language`: null if the controller has none.
  LoadedTexts(const Catalog& catalog, const Language* language) : catalog_(catalog), language_(language) {}

  /// The first place past a limit to which a raw text sends an axis, as far as the language reads it;
  /// absolute places only if the language always knows them to be absolute.
  [[nodiscard]] std::optional<PastTravel> past_travel_of(const std::string& text, const Snapshot& now) const;
  /// A restart of the controller may have taken it: its places count as long as it may be there.
  void loaded(const intent::LoadProgram& load);
  /// Something may have changed the stored programs.
  void forget() { loads_ = {}; }
  /// This command changes them.
  void forget(const IntentBody& body);
  /// The targets of the program on axes whose count is doubtful; none if they are not known.
  [[nodiscard]] std::vector<AxisTarget> places_in_doubt(int slot, const Snapshot& now);

 private:
  struct Load {
    std::string text;
    /// Its first steps, as far as blocks describe them, by the program that is started; each is read once.
    std::map<int, std::optional<sequence::Sequence>> known;
  };
  /// Where programs run in threads, one text holds them all.
  [[nodiscard]] int place_of(int slot) const { return catalog_.program.threads > 0 ? 0 : slot; }
  [[nodiscard]] bool keeps(int slot) const { return slot >= 0 && slot < max_slots; }
  [[nodiscard]] std::optional<sequence::Sequence> read(const std::string& text, int start) const;

  const Catalog& catalog_;
  const Language* language_;
  std::array<Load, max_slots> loads_;
};

}  // namespace hw
