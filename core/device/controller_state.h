#pragma once
// The known state of one controller at one moment, from which a rehearsal begins. A value: made on the thread
// that reads the snapshot, handed to a worker.
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
  std::map<int, std::string> programs;  ///< text by slot; missing ones are not known

  /// By place in the catalog; none: not known.
  [[nodiscard]] std::optional<std::int64_t> param(std::size_t place) const {
    if (place >= max_params || !now.params[place].known) return std::nullopt;
    return now.params[place].value;
  }
};

/// Options that rehearse this controller: from `state`, with the switches of `bench` as far as known, and the
/// same axes and options.
[[nodiscard]] RehearseOptions rehearse_from(std::shared_ptr<const ControllerState> state,
                                            const BenchView& bench, const Catalog& catalog);

/// The values of `state` that had to be assumed, for axes that have moved (all, if `moved` is all ones).
/// `matters`: whether a parameter can change the effect of a program.
[[nodiscard]] std::vector<RehearsedAssumption> unknown_params(
    const ControllerState& state, const Catalog& catalog, std::uint32_t moved,
    const std::function<bool(const ParamInfo&)>& matters);
/// Assumptions for axes with unknown positions, and for switches of an undescribed machine.
[[nodiscard]] std::vector<RehearsedAssumption> unknown_surroundings(const ControllerState& state,
                                                                    const Catalog& catalog,
                                                                    std::uint32_t moved);

/// The assumption for a program that the run reaches and that was not read; and back: its slot.
[[nodiscard]] RehearsedAssumption unread_program(int slot);
[[nodiscard]] std::optional<int> unread_slot(const RehearsedAssumption& assumption);

/// Readouts that affect programs besides parameters: move mode, latches, sync outputs. 0: as after power-up.
[[nodiscard]] bool acts_on_programs(const ReadoutInfo& readout);

/// The parameter's value for a person, with its unit: "1.50".
[[nodiscard]] std::string param_words(const ParamInfo& info, std::int64_t value);

}  // namespace hw
