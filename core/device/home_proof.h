#pragma once
// Whether a home search that is over has set the count, judged by its readings alone: for controllers that do
// not tell. Another host may have stopped it halfway, and then its end looks the same. A search that has
// found its home has set the count to zero there: a reading shows that no motion explains, or it rests near
// zero.
#include "core/base/units.h"
#include "core/time/clock.h"

namespace hw {

class HomeProof {
 public:
  /// The search begins.
  void begin() { *this = HomeProof(); }
  void read(Steps place, Pps speed, Instant when);
  /// False: it rests at a place that it cannot have come to behind its home.
  [[nodiscard]] bool may_have_found(Steps rests_at) const;

 private:
  bool count_was_set_ = false;
  Steps first_{}, last_{};
  Instant last_at_{};       ///< none: nothing was read yet
  Steps at_full_speed_{};   ///< where it was last seen at its full speed
  double fastest_ = 0;      ///< steps/s
  double longest_gap_ = 0;  ///< seconds between two readings
};

}  // namespace hw
