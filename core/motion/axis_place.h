#pragma once
#include <optional>

#include "core/base/units.h"
#include "core/motion/motor.h"

namespace hw {

/// Load positions at which the switches of an axis act; absent: no such switch.
struct SwitchPlaces {
  std::optional<Steps> minus, plus;  ///< travel limits
  std::optional<Steps> home_from, home_to;
  Steps scatter = Steps(0);  ///< how far before or behind its place each may act
  bool operator==(const SwitchPlaces&) const = default;
};

/// The mechanics of one axis, in steps of the controller. Positions are those of the load, counted from where
/// it was when the bench was built. In a change, absent values stay unchanged; a switch that was never set
/// never acts.
struct AxisPlace {
  std::optional<Steps> minus, plus;         ///< where the travel limit switches act
  std::optional<Steps> home_from, home_to;  ///< zone in which the home switch acts
  std::optional<Steps> index_every;         ///< encoder index marks
  std::optional<double> counts_per_step;    ///< encoder
  std::optional<Steps> backlash;
  std::optional<Motor> motor;        ///< of a servo axis
  std::optional<Steps> scatter;      ///< each switch and index acts up to so far before or behind its place,
                                     ///< elsewhere at each approach
  std::optional<std::int64_t> seed;  ///< seed of `scatter`: the same seed gives the same series

  [[nodiscard]] SwitchPlaces switches() const {
    return {minus, plus, home_from, home_to, scatter.value_or(Steps(0))};
  }
};

}  // namespace hw
