#pragma once
// Hands on the mechanics of an axis, and what is seen of them: the same for every emulated controller whose
// loads are plants.
#include <cstdint>
#include <string>
#include <type_traits>

#include "core/base/index.h"
#include "core/device/bench.h"
#include "core/motion/plant.h"

namespace hw {

inline void act_on(motion::Plant& plant, const bench::Limit& hand) {
  plant.operate_limit(hand.sign, hand.operated);
}
inline void act_on(motion::Plant& plant, const bench::HomeSwitch& hand) { plant.operate_home(hand.operated); }
inline void act_on(motion::Plant& plant, const bench::Jam& hand) { plant.jam(hand.on); }
inline void act_on(motion::Plant& plant, const bench::Slip& hand) { plant.slip(hand.by); }
inline void act_on(motion::Plant& plant, const bench::Place& hand) { plant.set_place(hand.place); }

template <class Hand>
concept ActsOnPlant = requires(motion::Plant& plant, const Hand& hand) {
  act_on(plant, hand);
};

/// For a controller that has axes and a power switch, and nothing else on its bench. `axis_of` gives the
/// plant of an axis, null where there is none, and `changed` is told which one was acted on; `power` switches
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
      act_on(*plant, hand);
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

/// The load and the switches of one axis.
inline void show_plant(BenchView& view, int axis, const motion::Plant& plant) {
  const std::uint32_t bit = 1u << axis;
  view.load_position[ix(axis)] = plant.load();
  view.switches[ix(axis)] = plant.place().switches();
  if (plant.limit_operated(Sign::minus)) view.limits_minus |= bit;
  if (plant.limit_operated(Sign::plus)) view.limits_plus |= bit;
  if (plant.limit_by_hand(Sign::minus)) view.limits_minus_by_hand |= bit;
  if (plant.limit_by_hand(Sign::plus)) view.limits_plus_by_hand |= bit;
  if (plant.home_by_hand()) view.homes_by_hand |= bit;
}

}  // namespace hw
