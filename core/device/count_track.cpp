#include "core/device/count_track.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "core/base/index.h"

namespace hw {
namespace {

/// Other causes of a new count (a restart, a program) show within this time.
constexpr Duration until_believed = std::chrono::seconds(1);
constexpr double least_reach = 50;
constexpr int most_missed = 2;  ///< in a row
constexpr int seen_moving = 2;  ///< readings of a motion that is faster than known for the axis

double way_between(const CountReading& from, const CountReading& to) {
  return static_cast<double>((to.place - from.place).value);
}

/// The distance is too long for a motion between two readings: the counter has wrapped around.
bool wraps_between(const CountReading& from, const CountReading& to) {
  return to.range > 0 && std::abs(way_between(from, to)) > to.range / 2;
}

double rate_between(const CountReading& from, const CountReading& to) {
  const double time = seconds(to.when - from.when);
  return time > 0 ? way_between(from, to) / time : 0;
}

/// The lowest rate between consecutive readings, as a garbled reading makes one of the rates too high. 0:
/// they differ in sign.
double lowest_rate(std::span<const CountReading> readings) {
  double lowest = 0;
  for (std::size_t i = 1; i < readings.size(); ++i) {
    const double rate = rate_between(readings[i - 1], readings[i]);
    if (i > 1 && rate * lowest <= 0) return 0;
    if (i == 1 || std::abs(rate) < std::abs(lowest)) lowest = rate;
  }
  return lowest;
}

bool reaches(const CountReading& from, const CountReading& to, double speed, double and_more) {
  return std::abs(way_between(from, to)) <= least_reach + and_more * speed * seconds(to.when - from.when);
}

/// A motion of any origin between two readings can explain the count.
bool reaches(const CountReading& from, const CountReading& to) {
  constexpr double and_more = 1.5;
  return reaches(from, to, std::max(from.fastest, to.fastest), and_more);
}

}  // namespace

void CountTrack::know(const CountReading& now) {
  std::rotate(known_.begin(), known_.begin() + 1, known_.end());
  known_.back() = now;
  known_count_ = std::min(known_count_ + 1, confirmed);
  other_count_ = went_on_ = missed_ = 0;
}

void CountTrack::set_known(const CountReading& now) {
  forget();
  know(now);
}

void CountTrack::begin_other(const CountReading& now) {
  const bool further = other_count_ == 1 && way_between(known_.back(), last_) * way_between(last_, now) > 0;
  went_on_ = further ? went_on_ + 1 : 0;
  other_[0] = last_ = now;
  other_count_ = 1;
  missed_ = 0;
}

double CountTrack::known_rate() const {
  const int count = std::min(known_count_, kept);
  return lowest_rate({known_.data() + (kept - count), known_.data() + kept});
}

/// An axis that moves to a target does not reverse.
bool CountTrack::leads(const CountReading& from, const CountReading& now) const {
  const bool turns = now.way * known_rate() > 0 && now.way * way_between(from, now) < -least_reach;
  return reaches(from, now) && !turns;
}

bool CountTrack::known_count_leads(const CountReading& now) const {
  return std::any_of(known_.end() - std::min(known_count_, kept), known_.end(),
                     [&](const CountReading& from) { return leads(from, now); });
}

bool CountTrack::add(const CountReading& now) {
  if (known_count_ == 0) return know(now), false;
  const CountReading& before = other_count_ > 0 ? last_ : known_.back();
  if (now.when <= before.when) return false;
  if (wraps_between(before, now) || wraps_between(known_.back(), now)) return set_known(now), false;
  if (known_count_ < confirmed && !known_count_leads(now)) {
    if (known_count_ > 1 && missed_ == 0) return ++missed_, false;
    return set_known(now), false;
  }
  if (known_count_ < confirmed) return know(now), false;
  if (other_count_ == 0) return leads(known_.back(), now) ? know(now) : begin_other(now), false;
  if (!reaches(last_, now)) {
    if (other_count_ > 1 && missed_ < most_missed) return ++missed_, false;
    return known_count_leads(now) ? know(now) : begin_other(now), false;
  }
  if (other_count_ < kept) other_[ix(other_count_)] = now;
  ++other_count_;
  last_ = now;
  missed_ = 0;
  if (other_count_ < confirmed || now.when - other_[0].when < until_believed) return false;
  const bool was_set = !motion_explains();
  set_known(now);
  return was_set;
}

/// The last reading of an axis at rest: the same place was read twice.
std::optional<CountReading> CountTrack::rested_last() const {
  for (int i = kept - 1; i >= 0; --i)
    for (int twin = i - 1; twin >= 0; --twin)
      if (known_[ix(i)].place == known_[ix(twin)].place) return known_[ix(i)];
  return {};
}

std::optional<CountReading> CountTrack::rests_first() const {
  const auto same = [this](const CountReading& reading) { return reading.place == last_.place; };
  const auto first = std::find_if(other_.begin(), other_.end(), same);
  if (first == other_.end()) return {};
  return *first;
}

/// A motion accelerates and then decelerates, so between its ends it is at least as fast as at the slower
/// end.
bool CountTrack::moved_on(const CountReading& from, const CountReading& to, double other_rate) const {
  constexpr double nearly = 1.25;
  const double speed = std::max({from.fastest, to.fastest, last_.fastest});
  if (!reaches(from, to, speed, nearly)) return false;
  const double rate = known_rate();
  if (rate * other_rate <= 0) return true;
  const double slower = std::min(std::abs(rate), std::abs(other_rate));
  const double gone = rate > 0 ? way_between(from, to) : -way_between(from, to);
  return gone >= slower * seconds(to.when - from.when) / nearly - least_reach;
}

bool CountTrack::motion_explains() const {
  const auto rested = rested_last(), rests = rests_first();
  if (went_on_ >= seen_moving && reaches(known_.back(), other_[0], other_[0].any_speed, 1)) return true;
  if (rested && rests) return reaches(*rested, *rests);
  const double other_rate = lowest_rate(std::array{other_[0], other_[1], other_[2], last_});
  for (const CountReading& from : known_)
    for (const CountReading& to : other_)
      if (moved_on(from, to, other_rate)) return true;
  return false;
}

}  // namespace hw
