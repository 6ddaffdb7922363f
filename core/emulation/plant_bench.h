#pragma once
// Hands on the mechanics of an axis, and what is seen of them: the same for every emulated controller whose
// loads are plants.
#include <cstdint>
#include <string>
#include <type_traits>

#include "core/device/bench.h"
#include "core/motion/plant.h"

namespace hw {

/// Refuses a place that an axis cannot have. `servo`: a motor can be described for it.
Result<> check_place(const AxisPlace& place, bool servo);

inline Result<> act_on(motion::Plant& plant, const bench::Limit& hand) {
  return plant.operate_limit(hand.sign, hand.operated), Result<>();
}
inline Result<> act_on(motion::Plant& plant, const bench::HomeSwitch& hand) {
  return plant.operate_home(hand.operated), Result<>();
}
inline Result<> act_on(motion::Plant& plant, const bench::Jam& hand) {
  return plant.jam(hand.on), Result<>();
}
inline Result<> act_on(motion::Plant& plant, const bench::Slip& hand) {
  return plant.slip(hand.by), Result<>();
}
/// Of a stepping motor.
Result<> act_on(motion::Plant& plant, const bench::Place& hand);

template <class Hand>
concept ActsOnPlant = requires(motion::Plant& plant, const Hand& hand) {
  act_on(plant, hand);
};

/// For a controller that has axes and a power switch, and nothing else on its bench. `plant_of` gives the
/// plant of an axis, null where there is none, and `changed` receives the one acted on; `power` switches
/// it.
template <class PlantOf, class Changed, class SwitchPower>
Result<> act_on_plants(const BenchCommand& command, const PlantOf& plant_of, const Changed& changed,
                       const SwitchPower& power) {
  const auto act = [&]<class Hand>(const Hand& hand) -> Result<> {
    if constexpr (ActsOnPlant<Hand>) {
      motion::Plant* plant = plant_of(hand.axis);
      if (!plant)
        return fail(FaultKind::refused,
                    "This controller has no axis number " + std::to_string(hand.axis.index + 1) + ".",
                    "Nothing was changed.");
      if (auto done = act_on(*plant, hand); !done) return done;
      changed(hand.axis);
    } else if constexpr (std::is_same_v<Hand, bench::Power>) {
      power(hand.on);
    } else if constexpr (std::is_same_v<Hand, bench::PowerCycle>) {
      power(false);
      power(true);
    } else {
      return fail(FaultKind::refused, "This controller has nothing of that kind on its bench.",
                  "Nothing was changed.");
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
