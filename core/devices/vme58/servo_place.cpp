#include "core/devices/vme58/servo_place.h"

#include <cstdlib>

namespace hw::vme58 {

void ServoPlace::begin(Instant at) {
  place_ = Loop::following;
  due_since_ = at;
  within_since_.reset();  // an axis that only passes the place does not count as arrived
}

void ServoPlace::look(Instant at, bool turns, std::int64_t error, std::int64_t band) {
  const bool within = std::abs(error) <= band;
  turns_ = turns;
  if (turns) return begin(at);
  if (place_ == Loop::unknown) {
    place_ = within ? Loop::in_place : Loop::off_place;
    due_since_ = at - patience;
  }
  if (!within) {
    if (place_ == Loop::in_place) place_ = Loop::following, due_since_ = at;
    within_since_.reset();
  } else if (!within_since_) {
    within_since_ = at;
  }
  if (within_since_ && at - *within_since_ >= to_be_sure)
    place_ = Loop::in_place;
  else if (place_ == Loop::following && at - due_since_ >= patience)
    place_ = Loop::off_place;
}

}  // namespace hw::vme58
