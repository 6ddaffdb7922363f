#pragma once
// The programs that the console has loaded into the controller, so that one that goes to absolute places is
// not started while a count is doubtful, whoever starts it. Of a program that it has not loaded, nothing is
// known.
#include <array>
#include <string>
#include <vector>

#include "core/device/catalog.h"
#include "core/device/intent.h"
#include "core/device/language.h"
#include "core/device/snapshot.h"

namespace hw {

class LoadedTexts {
 public:
  /// `language`: null if the controller has none.
  LoadedTexts(const Catalog& catalog, const Language* language) : catalog_(catalog), language_(language) {}

  void loaded(const intent::LoadProgram& load);
  /// Something may have changed the stored programs.
  void forget() { texts_ = {}; }
  /// This command changes them.
  void forget(const IntentBody& body);
  /// The places to which the program takes axes by a count that is doubtful; none, if that is not known.
  [[nodiscard]] std::vector<AxisTarget> places_in_doubt(int slot, const Snapshot& now) const;

 private:
  /// Where programs run in threads, one text holds them all.
  [[nodiscard]] int place_of(int slot) const { return catalog_.program.threads > 0 ? 0 : slot; }
  [[nodiscard]] bool keeps(int slot) const { return slot >= 0 && slot < max_slots; }

  const Catalog& catalog_;
  const Language* language_;
  std::array<std::string, max_slots> texts_;
};

}  // namespace hw
