#pragma once
// The mechanics of an axis: a load with play, travel limit switches and a home zone. By hand, a switch can be
// operated, the load jammed or slipped. The controller counts steps; the plant knows the real position of the
// load.
#include <cstdint>
#include <optional>

#include "core/base/units.h"
#include "core/motion/axis_place.h"
#include "core/motion/switch_scatter.h"

namespace hw::motion {

class Plant {
 public:
  /// Values absent in `place` stay unchanged; an empty `place` removes all.
  void set_place(const AxisPlace& place);
  [[nodiscard]] const AxisPlace& place() const { return place_; }
  [[nodiscard]] Steps load() const { return Steps(load_); }

  /// The motor turns by `steps` (not negative) towards `sign`.
  void turn(Sign sign, std::int64_t steps);
  void slip(Steps by);
  void jam(bool on) { jammed_ = on; }
  [[nodiscard]] bool jammed() const { return jammed_; }

  void operate_limit(Sign side, bool on) { (side == Sign::plus ? plus_by_hand_ : minus_by_hand_) = on; }
  void operate_home(bool on) { home_by_hand_ = on; }
  [[nodiscard]] bool limit_by_hand(Sign side) const {
    return side == Sign::plus ? plus_by_hand_ : minus_by_hand_;
  }
  [[nodiscard]] bool home_by_hand() const { return home_by_hand_; }
  [[nodiscard]] bool limit_operated(Sign side) const;
  [[nodiscard]] bool home_operated() const;
  /// The zone in which the home switch acts at this approach.
  [[nodiscard]] std::optional<Steps> home_from() const {
    return at_this_approach(place_.home_from, Of::home);
  }
  [[nodiscard]] std::optional<Steps> home_to() const { return at_this_approach(place_.home_to, Of::home); }
  /// Offset of the index marks from their places in the present approach; `way`: when turning that way next.
  [[nodiscard]] std::int64_t index_shift() const { return scatter_.shift(Of::index); }
  [[nodiscard]] std::int64_t index_shift(Sign way) const { return scatter_.shift(Of::index, way != turned_); }

  /// Turns towards `way` until the travel limit switch on that side acts; 0: it acts already.
  [[nodiscard]] std::optional<std::int64_t> turns_until_limit(Sign way) const;
  /// Likewise for entering the home zone from outside.
  [[nodiscard]] std::optional<std::int64_t> turns_until_home(Sign way) const;
  /// Turns towards `way` until the switch on `side` releases; 0: released already, none: held by hand.
  [[nodiscard]] std::optional<std::int64_t> turns_until_limit_released(Sign side, Sign way) const;
  [[nodiscard]] std::optional<std::int64_t> turns_until_home_released(Sign way) const;
  /// Turns towards `way` until the load is at `mark`; none: `mark` lies behind it, or here.
  [[nodiscard]] std::optional<std::int64_t> turns_until_load(Sign way, Steps mark) const {
    return turns_until(way, mark);
  }
  /// Position of the load after `turns`.
  [[nodiscard]] Steps load_after(Sign way, std::int64_t turns) const;

 private:
  using Of = SwitchScatter::Of;
  [[nodiscard]] std::optional<Steps> at_this_approach(std::optional<Steps> place, Of which) const;
  [[nodiscard]] std::optional<Steps> limit_at(Sign side) const;
  void load_moved(std::int64_t from);
  [[nodiscard]] std::int64_t play(Sign way) const;
  [[nodiscard]] std::optional<std::int64_t> turns_until(Sign way, std::optional<Steps> mark) const;

  AxisPlace place_;
  SwitchScatter scatter_;
  Sign turned_ = Sign::plus;  ///< latest direction
  std::int64_t load_ = 0;
  std::int64_t play_used_ = 0;  ///< 0: next turn to minus moves the load; backlash: next turn to plus does
  bool jammed_ = false, minus_by_hand_ = false, plus_by_hand_ = false, home_by_hand_ = false;
};

}  // namespace hw::motion
