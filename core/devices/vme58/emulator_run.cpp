#include "core/devices/vme58/emulator_run.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "core/base/rounded_steps.h"
namespace hw::vme58 {
namespace {

std::int64_t whole(double counts) { return rounded_steps(counts).value; }

std::int64_t floor_to(std::int64_t value, std::int64_t grid) {
  const std::int64_t rest = value % grid;
  return value - (rest < 0 ? rest + grid : rest);
}

}  // namespace

std::int64_t MotionAxis::counted(Steps load) const {
  return whole(static_cast<double>(load.value) * counts_per_step());
}

std::int64_t MotionAxis::encoder() const {
  if (!fitting.encoder) return position;
  if (has_motor) return loop.plant.counts() + zero;
  return (servo() ? shaft : counted(plant.load())) + zero;
}

std::int64_t MotionAxis::expected(std::int64_t at) const {
  if (servo() || settings.motor_counts_per_ratio == 0) return at;
  return whole(static_cast<double>(at) * settings.encoder_counts_per_ratio / settings.motor_counts_per_ratio);
}

std::int64_t MotionAxis::error_after(int way, std::int64_t counts) const {
  const std::int64_t wanted = expected(position + way * counts);
  if (servo()) return wanted - encoder() - (plant.jammed() ? 0 : way * counts);
  const Sign side = way < 0 ? Sign::minus : Sign::plus;
  return wanted - counted(plant.load_after(side, counts)) - zero;
}

void MotionAxis::turn(int way, std::int64_t count) {
  position += way * count;
  span.travel += count;
  reach();
  direction = way < 0 ? Sign::minus : Sign::plus;
  arrived_by = way;
  if (!has_motor) turn_load(way, count);
}

void MotionAxis::turn_load(int way, std::int64_t count) {
  const std::int64_t before = encoder();
  if (!plant.jammed() && !has_motor) shaft += way * count;
  plant.turn(way < 0 ? Sign::minus : Sign::plus, count);
  if (settings.tracking) zero += before - encoder();  // the encoder belongs to something else
}

bool MotionAxis::index_active() const {
  const auto every = plant.place().index_every;
  if (!every || every->value <= 0) return false;
  return (has_motor && index_passed) || (plant.load().value - plant.index_shift()) % every->value == 0;
}

std::optional<std::int64_t> MotionAxis::counts_until_home(Sign way) const {
  if (settings.home_needs_index) return counts_until_index(way);
  return settings.home_active_high ? plant.turns_until_home_released(way) : plant.turns_until_home(way);
}

std::optional<std::int64_t> MotionAxis::counts_until_index(Sign way) const {
  const AxisPlace& place = plant.place();
  if (!place.index_every || place.index_every->value <= 0) return std::nullopt;
  const std::int64_t every = place.index_every->value, load = plant.load().value;
  const std::int64_t shift = plant.index_shift(way);
  const auto mark_from = [&](std::int64_t at) {  // the first mark at or behind `at` on the way
    return shift +
           (way == Sign::plus ? floor_to(at - shift + every - 1, every) : floor_to(at - shift, every));
  };
  std::int64_t mark = mark_from(load + factor(way));
  const bool by_hand = plant.home_by_hand();
  if (const auto zone_from = plant.home_from(), zone_to = plant.home_to(); !by_hand && zone_from && zone_to) {
    const std::int64_t from = zone_from->value, to = zone_to->value;
    const std::int64_t entry = way == Sign::plus ? from : to, exit = way == Sign::plus ? to : from;
    const auto behind = [&](std::int64_t at, std::int64_t edge) { return factor(way) * (at - edge) > 0; };
    if (!settings.home_active_high) {
      if (behind(entry, mark)) mark = mark_from(entry);
      if (behind(mark, exit)) return std::nullopt;
    } else if (!behind(entry, mark) && !behind(mark, exit)) {
      mark = mark_from(exit + factor(way));
    }
  } else if (by_hand == settings.home_active_high) {
    return std::nullopt;
  }
  return plant.turns_until_load(way, Steps(mark));
}

}  // namespace hw::vme58
