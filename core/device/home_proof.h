#pragma once
// Judges by the readings alone whether a finished home search has set the count: for controllers that do not
// report it. A search that another host has stopped halfway ends in the same way. A search that has found
// home has set the count to zero there: either a reading jumps as no motion explains, or the former zero lies
// on the way and the axis rests shortly behind it.
#include "core/base/units.h"
#include "core/time/clock.h"

namespace hw {

class HomeProof {
 public:
  /// The search begins from an unknown position.
  void begin() { *this = HomeProof(); }
  /// The search begins at rest at `place`, as read at `when`, towards `direction` at no more than
  /// `top_speed`; 0: not known.
  void begin(Steps place, Instant when, int direction, Pps top_speed);
  void read(Steps place, Pps speed, Instant when);
  /// False: the axis rests at a place that it cannot have reached after finding home.
  [[nodiscard]] bool may_have_found(Steps rests_at) const;

 private:
  [[nodiscard]] double unseen_way() const;
  [[nodiscard]] double unseen_at_work() const;
  [[nodiscard]] bool may_have_met_zero(Steps rests_at) const;

  bool count_was_set_ = false;
  bool from_rest_ = false;  ///< no reading since the one at rest
  int direction_ = 0;       ///< 0: not known, and the search did not begin at `first_`
  Steps first_{}, last_{};
  Steps furthest_{};                ///< towards `direction_`
  Instant last_at_{};               ///< zero: nothing was read yet
  Steps at_full_speed_{};           ///< where the axis was last seen at its full speed
  double top_speed_ = 0;            ///< steps/s, asked for; 0: not known
  double fastest_ = 0;              ///< steps/s, seen
  double longest_gap_ = 0;          ///< seconds between two readings
  double longest_gap_at_work_ = 0;  ///< of these, without the first from rest
};

}  // namespace hw
