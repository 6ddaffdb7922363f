#pragma once
// The programs that the console has loaded into the controller. A program with absolute targets must not be
// started while a count is doubtful, whoever starts it. A program that a restart may have erased is kept here
// as long as it may be there. Not known are: programs that the console has not loaded; long programs; and the
// rest of a program after a command that no block describes, as that command may set the count (except the
// places that the language names there).
#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/device/catalog.h"
#include "core/device/intent.h"
#include "core/device/language.h"
#include "core/device/program_ways.h"
#include "core/device/snapshot.h"

namespace hw {

class LoadedTexts {
 public:
  /// `language`: null if the controller has none.
  LoadedTexts(const Catalog& catalog, const Language* language) : catalog_(catalog), language_(language) {}

  /// A later restart of the controller may erase it: its places are kept as long as it may be there.
  void loaded(const intent::LoadProgram& load);
  /// Something may have changed the stored programs.
  void forget() { loads_ = {}; }
  /// This command may change the stored programs.
  void forget(const IntentBody& body);
  /// The least and the greatest place to which the program takes each axis; none if they are not known.
  [[nodiscard]] std::vector<AxisTarget> places_of(int slot, const Snapshot& now);
  /// The places where its motions can come to rest by themselves; none if not known.
  [[nodiscard]] std::optional<ProgramWays> ways_of(int slot) const;
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
