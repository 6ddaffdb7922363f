#include "core/devices/arcus/emulator_axis.h"

#include <algorithm>
#include <cmath>

namespace hw::arcus {

std::int64_t Axis::encoder_at(Steps load) const {
  constexpr double furthest = 1e18;  // keeps sums of absurd distances defined
  const double counts = static_cast<double>(load.value) * counts_per_pulse;
  return std::llround(std::clamp(counts, -furthest, furthest)) + encoder_offset;
}

bool Axis::index_operated() const {
  return index_every > 0 && (plant.load().value - index_first - plant.index_shift()) % index_every == 0;
}

void Axis::turn(int way, Sign physical, std::int64_t count) {
  pulses += way * count;
  turned += count;
  arrived_by = way;
  plant.turn(physical, count);
}

std::optional<std::int64_t> Axis::turns_until_index(Sign physical) const {
  if (index_every <= 0) return std::nullopt;
  const std::int64_t here = plant.load().value - index_first - plant.index_shift(physical);
  const std::int64_t behind = ((here % index_every) + index_every) % index_every;  // from the mark below
  const std::int64_t gap =
      physical == Sign::plus ? index_every - behind : (behind == 0 ? index_every : behind);
  return plant.turns_until_load(physical, Steps(plant.load().value + factor(physical) * gap));
}

}  // namespace hw::arcus
