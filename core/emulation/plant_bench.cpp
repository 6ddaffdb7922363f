#include "core/emulation/plant_bench.h"

#include "core/base/index.h"

namespace hw {

Result<> check_place(const AxisPlace& place, bool servo) {
  if (place.home_from.has_value() != place.home_to.has_value())
    return fail(FaultKind::refused, "A home zone needs both ends.", "Nothing was changed.");
  if (place.motor && !servo)
    return fail(FaultKind::refused, "This controller has stepping motors; motor describes a servo motor.",
                "Nothing was changed.");
  return {};
}

Result<> act_on(motion::Plant& plant, const bench::Place& operation) {
  if (auto bad = check_place(operation.place, false); !bad) return bad;
  plant.set_place(operation.place);
  return {};
}

void show_plant(BenchView& view, int axis, const SeenPlant& seen) {
  const motion::Plant& plant = seen.plant;
  const std::uint32_t bit = 1u << axis;
  const auto show = [bit](std::uint32_t& mask, bool on) { mask = on ? mask | bit : mask & ~bit; };
  view.load_position[ix(axis)] = plant.load();
  view.switches[ix(axis)] = plant.place().switches();
  show(view.limits_minus, seen.minus);
  show(view.limits_plus, seen.plus);
  show(view.limits_minus_by_hand, plant.limit_by_hand(Sign::minus));
  show(view.limits_plus_by_hand, plant.limit_by_hand(Sign::plus));
  show(view.homes_by_hand, plant.home_by_hand());
  show(view.jammed, plant.jammed());
}

}  // namespace hw
