#include "core/device/home_proof.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace hw {
namespace {

constexpr double jitter = 50;    // steps
constexpr double plainly = 1.5;  // of a way that is too long for its time
constexpr double full_speed = 0.98;

double between(Steps from, Steps to) { return static_cast<double>((to - from).value); }

}  // namespace

void HomeProof::read(Steps place, Pps speed, Instant when) {
  if (last_at_ == Instant{}) {
    first_ = last_ = at_full_speed_ = place;
    last_at_ = when;
    fastest_ = speed.value;
    return;
  }
  if (when <= last_at_) return;
  const double gap = seconds(when - last_at_), way = between(last_, place);
  const double fastest = std::max(fastest_, speed.value);
  const bool turns = way * between(first_, last_) < 0 && std::abs(way) > jitter;
  if (turns || std::abs(way) > jitter + plainly * fastest * gap) count_was_set_ = true;
  fastest_ = fastest;
  longest_gap_ = std::max(longest_gap_, gap);
  if (speed.value >= full_speed * fastest_) at_full_speed_ = place;
  last_ = place;
  last_at_ = when;
}

/// Where nothing has shown the count being set, it was near zero already; from there it only slows down.
bool HomeProof::may_have_found(Steps rests_at) const {
  if (count_was_set_ || last_at_ == Instant{}) return true;
  const double slowed_down_over = std::abs(between(at_full_speed_, rests_at));
  const double unseen = jitter + plainly * fastest_ * longest_gap_;
  return std::abs(static_cast<double>(rests_at.value)) <= 2 * (slowed_down_over + unseen);
}

}  // namespace hw
