#include "core/motion/step_axis.h"

#include <algorithm>

namespace hw::motion {

void StepAxis::begin(Instant now, Sign sign, const Profile& profile, Seeks seeks) {
  profile_ = profile;
  sign_ = sign;
  seeks_ = seeks;
  made_ = 0;
  state_ = State::moves;
  plan();
  advance(now);
}

void StepAxis::slow(Instant now, double decel) {
  if (state_ != State::moves) return;
  profile_ = Profile::stop(now, profile_.distance(now), profile_.speed(now), decel);
  state_ = State::slows;
  plan();
  advance(now);
}

void StepAxis::kill() {
  if (state_ != State::rests) finish(Ended::kill);
}

/// Finds the step at which the motion ends, by the switches as they are now.
void StepAxis::plan() {
  if (state_ == State::rests) return;
  last_ = profile_.length();
  by_ = state_ == State::slows ? Ended::stop : Ended::target;
  const auto ends_earlier = [this](std::optional<std::int64_t> left, Ended how) {
    if (left && made_ + *left < last_) last_ = made_ + *left, by_ = how;
  };
  const bool homes = state_ == State::moves;
  ends_earlier(plant.turns_until_limit(sign_),
               homes && seeks_ == Seeks::limit_switch ? Ended::home : Ended::limit);
  if (homes && seeks_ == Seeks::home_switch) ends_earlier(plant.turns_until_home(sign_), Ended::home);
}

void StepAxis::advance(Instant now) {
  if (state_ == State::rests) return;
  const std::int64_t reached = std::min(profile_.steps(now), last_);
  if (reached > made_) {
    plant.turn(sign_, reached - made_);
    position += Steps(factor(sign_) * (reached - made_));
    made_ = reached;
  }
  if (made_ >= last_ && (last_ < profile_.length() || now >= profile_.end())) finish(by_);
}

std::optional<Instant> StepAxis::next_event() const {
  if (state_ == State::rests) return std::nullopt;
  return last_ < profile_.length() ? profile_.time_at(last_) : profile_.end();
}

void StepAxis::finish(Ended how) {
  state_ = State::rests;
  ended_ = how;
  if (how == Ended::home) position = Steps(0);
}

}  // namespace hw::motion
