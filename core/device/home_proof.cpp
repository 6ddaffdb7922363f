#include "core/device/home_proof.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <utility>

namespace hw {
namespace {

constexpr double jitter = 50;    // steps
constexpr double plainly = 1.5;  // factor: the distance is too long for its time
constexpr double full_speed = 0.98;

double between(Steps from, Steps to) { return static_cast<double>((to - from).value); }

}  // namespace

void HomeProof::begin(Steps place, Instant when, int direction, Pps top_speed) {
  begin();
  read(place, Pps(0), when);
  from_rest_ = true;
  direction_ = direction;
  top_speed_ = top_speed.value;
}

void HomeProof::read(Steps place, Pps speed, Instant when) {
  if (last_at_ == Instant{}) {
    first_ = last_ = furthest_ = at_full_speed_ = place;
    last_at_ = when;
    fastest_ = speed.value;
    return;
  }
  if (when <= last_at_) return;
  const double gap = seconds(when - last_at_), way = between(last_, place);
  const double fastest = std::max({fastest_, speed.value, top_speed_});
  const double onward = direction_ != 0 ? direction_ : between(first_, last_);
  const bool goes_on = between(furthest_, place) * onward >= 0;
  if (goes_on) furthest_ = place;  // a slow return shows in several readings
  const bool turns = !goes_on && std::abs(between(furthest_, place)) > jitter;
  if (turns || std::abs(way) > jitter + plainly * fastest * gap) count_was_set_ = true;
  fastest_ = std::max(fastest_, speed.value);
  longest_gap_ = std::max(longest_gap_, gap);
  if (!std::exchange(from_rest_, false)) {  // else the axis may have been faster before that reading
    longest_gap_at_work_ = std::max(longest_gap_at_work_, gap);
    if (speed.value > 0 && speed.value >= full_speed * fastest_) at_full_speed_ = place;
  }
  last_ = place;
  last_at_ = when;
}

/// The largest jump of the count between two readings that cannot be seen.
double HomeProof::unseen_way() const {
  return jitter + plainly * std::max(fastest_, top_speed_) * longest_gap_;
}

/// The distance that the axis may have travelled at the speed seen.
double HomeProof::unseen_at_work() const {
  return fastest_ > 0 ? jitter + plainly * fastest_ * longest_gap_at_work_ : unseen_way();
}

/// The search began before the former zero, and rests behind it.
bool HomeProof::may_have_met_zero(Steps rests_at) const {
  if (direction_ == 0) return true;
  const auto began = static_cast<double>(first_.value) * direction_;
  const auto rests = static_cast<double>(rests_at.value) * direction_;
  return began <= unseen_way() && rests >= -unseen_way();
}

/// If no reading shows that the count was set, it was near zero already, and the axis only decelerated from
/// there.
bool HomeProof::may_have_found(Steps rests_at) const {
  if (count_was_set_ || last_at_ == Instant{}) return true;
  if (!may_have_met_zero(rests_at)) return false;
  const double slowed_down_over = std::abs(between(at_full_speed_, rests_at));
  return std::abs(static_cast<double>(rests_at.value)) <= 2 * (slowed_down_over + unseen_at_work());
}

}  // namespace hw
