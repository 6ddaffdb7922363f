#pragma once
// The rest of a typed program, from one of its commands on. If the text is steps of a sequence, the state at
// that command is known from the steps before it and from its rehearsal. Pure.
#include <array>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/device/language.h"
#include "core/sequence/rest.h"

namespace hw::panels {

/// The command to begin at, and the rehearsal's facts about it.
struct PlaceToBegin {
  std::string text;
  int line = 0, byte = 0;        ///< from 0, where a command begins
  std::optional<int> pass = {};  ///< how often it was done before; none: unknown
  std::vector<RehearsedAxis> axes = {};
  /// It was begun between these; none: the rehearsal does not show it.
  std::optional<std::array<RehearsedPlace, 2>> begun = {};
};
/// When that pass of a source was begun. `source_of_command`: by RehearsedTurn::command.
std::optional<std::array<RehearsedPlace, 2>> begun_between(const Rehearsal& rehearsal,
                                                           std::span<const int> source_of_command, int source,
                                                           std::optional<int> pass);

/// Start of the rehearsal, from which the steps are counted: of the axes moved by it or by a step.
sequence::Places begin_of(std::span<const RehearsedAxis> axes, const sequence::Sequence& sequence);
/// None: the rehearsal agrees with the place where the rest would begin. `what`: "line 3" or "step 3";
/// `above`: what stands above it.
std::optional<Fault> otherwise_rehearsed(const sequence::Rest& rest,
                                         const std::array<RehearsedPlace, 2>& begun, std::string_view what,
                                         std::string_view above, const Catalog& catalog);

struct RestOfText {
  sequence::Rest rest;
  std::string begins;  ///< "line 7, I2M400"
};
/// In the unit and axes of `frame`. The fault: why the state at that place is unknown. Slow: run it on the
/// worker.
Result<RestOfText> rest_of_text(const Language& language, const PlaceToBegin& place,
                                const sequence::Sequence& frame, const Catalog& catalog);

}  // namespace hw::panels
