#pragma once
// Makes the rest of a typed program, from a command on. If the text can be read as steps of a sequence, the
// state at that command is known from the steps before it and from the rehearsal. Pure.
#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/device/language.h"
#include "core/sequence/rest.h"

namespace hw::panels {

/// Advice where a place lies in a loop and its pass is not known.
inline constexpr std::string_view choose_pass =
    "Click the pass in the picture. Where several passes lie on one line, begin before the loop or after it.";

/// The command to begin at, and the rehearsal's facts about it.
struct PlaceToBegin {
  std::string text;
  int line = 0, byte = 0;        ///< from 0, where a command begins
  std::optional<int> pass = {};  ///< how often the command was done before; nullopt: unknown
  std::vector<RehearsedAxis> axes = {};
  /// The command was begun between these places; nullopt: the rehearsal does not show it.
  std::optional<std::array<RehearsedPlace, 2>> begun = {};
};
/// The places between which that pass of a source was begun. `source_of_command`: by RehearsedTurn::command.
std::optional<std::array<RehearsedPlace, 2>> begun_between(const Rehearsal& rehearsal,
                                                           std::span<const int> source_of_command, int source,
                                                           std::optional<int> pass);

/// The start of the rehearsal, from which the steps are counted, for the axes that the rehearsal or a step
/// moves.
sequence::Places begin_of(std::span<const RehearsedAxis> axes, const sequence::Sequence& sequence);
/// The fault if the rehearsal does not agree with the place where the rest would begin; nullopt: it agrees.
/// `what` is "line 3" or "step 3"; `above` names the part above it.
std::optional<Fault> otherwise_rehearsed(const sequence::Rest& rest,
                                         const std::array<RehearsedPlace, 2>& begun, std::string_view what,
                                         std::string_view above, const Catalog& catalog);

struct RestOfText {
  sequence::Rest rest;
  std::string begins;  ///< "line 7, I2M400"
};
/// The rest in the unit and axes of `frame`. The fault says why the state at that place is unknown. Slow:
/// call it on the worker.
Result<RestOfText> rest_of_text(const Language& language, const PlaceToBegin& place,
                                const sequence::Sequence& frame, const Catalog& catalog);

}  // namespace hw::panels
