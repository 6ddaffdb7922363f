#include "core/motion/plant.h"

#include <algorithm>

namespace hw::motion {
namespace {

constexpr std::int64_t far_away = std::int64_t{1} << 52;  // keeps sums of absurd distances defined

std::int64_t bounded(std::int64_t steps) { return std::clamp(steps, -far_away, far_away); }

std::optional<Steps> bounded(std::optional<Steps> steps) {
  if (steps) steps->value = bounded(steps->value);
  return steps;
}

}  // namespace

static bool names_nothing(const AxisPlace& p) {
  return !p.minus && !p.plus && !p.home_from && !p.home_to && !p.index_every && !p.counts_per_step &&
         !p.backlash && !p.motor && !p.scatter && !p.seed;
}

void Plant::set_place(const AxisPlace& place) {
  if (names_nothing(place)) place_ = AxisPlace(), scatter_ = SwitchScatter(), play_used_ = 0;
  const auto take = [](auto& mine, const auto& given) {
    if (given) mine = given;
  };
  take(place_.minus, place.minus), take(place_.plus, place.plus);
  take(place_.home_from, place.home_from), take(place_.home_to, place.home_to);
  take(place_.index_every, place.index_every), take(place_.counts_per_step, place.counts_per_step);
  take(place_.motor, place.motor), take(place_.scatter, place.scatter), take(place_.seed, place.seed);
  for (auto* mark : {&place_.minus, &place_.plus, &place_.home_from, &place_.home_to}) *mark = bounded(*mark);
  if (place_.home_from && place_.home_to && *place_.home_to < *place_.home_from)
    std::swap(place_.home_from, place_.home_to);
  if (place.scatter || place.seed) {
    place_.scatter = Steps(std::clamp<std::int64_t>(place_.scatter.value_or(Steps(0)).value, 0, far_away));
    scatter_.begin(place_.scatter->value, place_.seed.value_or(1));
  }
  if (!place.backlash) return;
  place_.backlash = Steps(std::clamp<std::int64_t>(place.backlash->value, 0, far_away));
  play_used_ = place_.backlash->value;  // as after a move to plus
}

std::int64_t Plant::play(Sign way) const {
  const std::int64_t all = place_.backlash.value_or(Steps(0)).value;
  return way == Sign::plus ? all - play_used_ : play_used_;
}

void Plant::turn(Sign sign, std::int64_t steps) {
  if (jammed_ || steps <= 0) return;
  if (sign != turned_) scatter_.end_approach(Of::index);
  turned_ = sign;
  const std::int64_t taken = std::min(steps, play(sign)), from = load_;
  play_used_ += factor(sign) * taken;
  load_ = bounded(load_ + factor(sign) * (bounded(steps) - taken));
  load_moved(from);
}

void Plant::slip(Steps by) {
  const std::int64_t from = load_;
  load_ = bounded(load_ + bounded(by.value));
  load_moved(from);
}

std::optional<Steps> Plant::at_this_approach(std::optional<Steps> place, Of which) const {
  return place ? std::optional(*place + Steps(scatter_.shift(which))) : std::nullopt;
}

std::optional<Steps> Plant::limit_at(Sign side) const {
  return side == Sign::plus ? at_this_approach(place_.plus, Of::plus)
                            : at_this_approach(place_.minus, Of::minus);
}

void Plant::load_moved(std::int64_t from) {
  const std::int64_t reach = scatter_.reach(), low = std::min(from, load_), high = std::max(from, load_);
  if (reach == 0) return;
  if (const auto at = limit_at(Sign::plus))
    scatter_.moved(Of::plus, high >= at->value, load_ < place_.plus->value - reach);
  if (const auto at = limit_at(Sign::minus))
    scatter_.moved(Of::minus, low <= at->value, load_ > place_.minus->value + reach);
  const auto zone_from = home_from(), zone_to = home_to();
  if (zone_from && zone_to)
    scatter_.moved(Of::home, low <= zone_to->value && high >= zone_from->value,
                   load_ < place_.home_from->value - reach || load_ > place_.home_to->value + reach);
}

bool Plant::home_operated() const {
  if (home_by_hand_) return true;
  const auto from = home_from(), to = home_to();
  return from && to && load_ >= from->value && load_ <= to->value;
}

bool Plant::limit_operated(Sign side) const {
  if (limit_by_hand(side)) return true;
  const auto at = limit_at(side);
  return at && factor(side) * (load_ - at->value) >= 0;
}

std::optional<std::int64_t> Plant::turns_until(Sign way, std::optional<Steps> mark) const {
  if (!mark || jammed_) return std::nullopt;
  const std::int64_t gap = factor(way) * (mark->value - load_);
  if (gap <= 0) return std::nullopt;  // behind
  return gap + play(way);
}

std::optional<std::int64_t> Plant::turns_until_limit(Sign way) const {
  if (limit_operated(way)) return 0;
  return turns_until(way, limit_at(way));
}

std::optional<std::int64_t> Plant::turns_until_home(Sign way) const {
  if (home_operated()) return 0;
  const auto from = home_from(), to = home_to();
  if (!from || !to) return std::nullopt;
  return turns_until(way, way == Sign::plus ? from : to);
}

std::optional<std::int64_t> Plant::turns_until_limit_released(Sign side, Sign way) const {
  if (!limit_operated(side)) return 0;
  if (limit_by_hand(side)) return std::nullopt;
  return turns_until(way, Steps(limit_at(side)->value - factor(side)));
}

std::optional<std::int64_t> Plant::turns_until_home_released(Sign way) const {
  if (!home_operated()) return 0;
  if (home_by_hand_) return std::nullopt;
  return turns_until(way, Steps((way == Sign::plus ? home_to() : home_from())->value + factor(way)));
}

Steps Plant::load_after(Sign way, std::int64_t turns) const {
  if (jammed_) return Steps(load_);
  return Steps(load_ + factor(way) * std::max<std::int64_t>(turns - play(way), 0));
}

}  // namespace hw::motion
