#pragma once
// For emulators: separates bench commands to the controller from faults of its wire.
#include <type_traits>

#include "core/device/bench.h"

namespace hw {

/// Passes commands to the controller on to `act`. Refuses faults of the wire, which the transport makes.
template <class Act>
Result<> on_controller(const BenchCommand& command, const Act& act) {
  const auto do_it = [&]<class Operation>(const Operation& operation) -> Result<> {
    constexpr bool of_the_wire = std::is_same_v<Operation, bench::Unplug> ||
                                 std::is_same_v<Operation, bench::Garble> ||
                                 std::is_same_v<Operation, bench::Drop>;
    if constexpr (of_the_wire)
      return fail(FaultKind::refused, "This is a fault of the wire: the controller cannot cause it.");
    else
      return act(operation);
  };
  return std::visit(do_it, command);
}

}  // namespace hw
