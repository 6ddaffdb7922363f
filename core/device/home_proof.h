#pragma once
// Whether a home search that is over has set the count, judged by its readings alone: for controllers that do
// not report it. Another host may have stopped it halfway, and then its end looks the same. A search that has
// found its home has set the count to zero there: a reading shows that no motion explains, or the place that
// was zero before lies on its way, and it rests shortly behind it.
#include "core/base/units.h"
#include "core/time/clock.h"

namespace hw {

class HomeProof {
 public:
  /// The search begins; nothing is known of where it stands.
  void begin() { *this = HomeProof(); }
  /// It begins at rest at `place`, as read at `when`, towards `direction` at no more than `top_speed`; 0: not
  /// known.
  void begin(Steps place, Instant when, int direction, Pps top_speed);
  void read(Steps place, Pps speed, Instant when);
  /// False: it rests at a place that it cannot have come to behind its home.
  [[nodiscard]] bool may_have_found(Steps rests_at) const;

 private:
  [[nodiscard]] double unseen_way() const;
  [[nodiscard]] double unseen_at_work() const;
  [[nodiscard]] bool may_have_met_zero(Steps rests_at) const;

  bool count_was_set_ = false;
  bool from_rest_ = false;  ///< no reading since the one at rest
  int direction_ = 0;       ///< 0: not known, and `first_` is not where it began
  Steps first_{}, last_{};
  Steps furthest_{};                ///< towards `direction_`
  Instant last_at_{};               ///< none: nothing was read yet
  Steps at_full_speed_{};           ///< where it was last seen at its full speed
  double top_speed_ = 0;            ///< steps/s, asked for; 0: not known
  double fastest_ = 0;              ///< steps/s, seen
  double longest_gap_ = 0;          ///< seconds between two readings
  double longest_gap_at_work_ = 0;  ///< of them, without the first one from rest
};

}  // namespace hw
