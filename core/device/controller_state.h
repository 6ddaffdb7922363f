#pragma once
// What is known of one controller at one moment: where a rehearsal begins that is to tell what Run would do
// there. A value; made where the snapshot is read, handed to a worker.
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/device/bench.h"
#include "core/device/catalog.h"
#include "core/device/language.h"
#include "core/device/snapshot.h"

namespace hw {

struct ControllerState {
  Snapshot now;
  std::map<int, std::string> programs;  ///< text by slot; those that are missing are not known

  /// By its place in the catalog; none: not known.
  [[nodiscard]] std::optional<std::int64_t> param(std::size_t place) const {
    if (place >= max_params || !now.params[place].known) return std::nullopt;
    return now.params[place].value;
  }
};

/// How the controller at hand is rehearsed: from `state`, among the switches of `bench` as far as they are
/// known, with as many axes and as it was made.
[[nodiscard]] RehearseOptions rehearse_from(std::shared_ptr<const ControllerState> state,
                                            const BenchView& bench, const Catalog& catalog);

/// Names what of `state` is not known and what was taken instead, for axes that have moved (or all, where
/// `moved` is all ones). `matters`: whether a parameter can change what a program does.
[[nodiscard]] std::vector<RehearsedAssumption> unknown_params(
    const ControllerState& state, const Catalog& catalog, std::uint32_t moved,
    const std::function<bool(const ParamInfo&)>& matters);
/// Axes whose position nobody knows, and the switches of a machine that nobody has described.
[[nodiscard]] std::vector<RehearsedAssumption> unknown_surroundings(const ControllerState& state,
                                                                    const Catalog& catalog,
                                                                    std::uint32_t moved);

/// A program that the run comes to and nobody has read; and back: its slot, if that is what it says.
[[nodiscard]] RehearsedAssumption unread_program(int slot);
[[nodiscard]] std::optional<int> unread_slot(const RehearsedAssumption& assumption);

/// What programs of the controller go by beside its parameters: how numbers are meant, latches, sync outputs.
/// 0 of it: as after power-up.
[[nodiscard]] bool acts_on_programs(const ReadoutInfo& readout);

/// "1.50", as people write the parameter's value, with its unit where it has one.
[[nodiscard]] std::string param_words(const ParamInfo& info, std::int64_t value);

}  // namespace hw
