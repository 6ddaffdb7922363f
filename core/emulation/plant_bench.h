#pragma once
// Bench commands on the mechanics of an axis, and their view: the same for every emulated controller whose
// loads are plants.
#include <cstdint>
#include <string>
#include <type_traits>

#include "core/device/bench.h"
#include "core/motion/plant.h"

namespace hw {

/// Refuses a place that an axis cannot have. `servo`: a motor can be described for it.
Result<> check_place(const AxisPlace& place, bool servo);

inline Result<> act_on(motion::Plant& plant, const bench::Limit& operation) {
  return plant.operate_limit(operation.sign, operation.operated), Result<>();
}
inline Result<> act_on(motion::Plant& plant, const bench::HomeSwitch& operation) {
  return plant.operate_home(operation.operated), Result<>();
}
inline Result<> act_on(motion::Plant& plant, const bench::Jam& operation) {
  return plant.jam(operation.on), Result<>();
}
inline Result<> act_on(motion::Plant& plant, const bench::Slip& operation) {
  return plant.slip(operation.by), Result<>();
}
/// Of a stepping motor.
Result<> act_on(motion::Plant& plant, const bench::Place& operation);

template <class Operation>
concept ActsOnPlant = requires(motion::Plant& plant, const Operation& operation) {
  act_on(plant, operation);
};

/// For a controller that has axes and a power switch, and nothing else on its bench. `plant_of` gives the
/// plant of an axis, null where there is none, and `changed` receives the one acted on; `power` switches
/// it.
template <class PlantOf, class Changed, class SwitchPower>
Result<> act_on_plants(const BenchCommand& command, const PlantOf& plant_of, const Changed& changed,
                       const SwitchPower& power) {
  const auto act = [&]<class Operation>(const Operation& operation) -> Result<> {
    if constexpr (ActsOnPlant<Operation>) {
      motion::Plant* plant = plant_of(operation.axis);
      if (!plant)
        return fail(FaultKind::refused,
                    "This controller has no axis number " + std::to_string(operation.axis.index + 1) + ".",
                    "Nothing was changed.");
      if (auto done = act_on(*plant, operation); !done) return done;
      changed(operation.axis);
    } else if constexpr (std::is_same_v<Operation, bench::Power>) {
      power(operation.on);
    } else if constexpr (std::is_same_v<Operation, bench::PowerCycle>) {
      power(false);
      power(true);
    } else {
      return fail(FaultKind::refused, "The bench of this controller cannot do that.", "Nothing was changed.");
    }
    return {};
  };
  return std::visit(act, command);
}

/// The load and the switches of one axis, for BenchView.
struct SeenPlant {
  const motion::Plant& plant;
  bool minus, plus;  ///< its limit switches are operated
  explicit SeenPlant(const motion::Plant& p)
      : SeenPlant(p, p.limit_operated(Sign::minus), p.limit_operated(Sign::plus)) {}
  SeenPlant(const motion::Plant& p, bool minus_operated, bool plus_operated)
      : plant(p), minus(minus_operated), plus(plus_operated) {}
};
void show_plant(BenchView& view, int axis, const SeenPlant& seen);

}  // namespace hw
