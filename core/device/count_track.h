#pragma once
// The readings of one axis' count. Decides whether motion explains a new count, or another host or a person
// has set it. A single reading may be garbled: a new count is accepted only after further readings have
// followed from it for a second, and if no motion leads to it from any of the readings before it.
#include <array>
#include <cstdint>
#include <optional>

#include "core/base/units.h"
#include "core/time/clock.h"

namespace hw {

struct CountReading {
  Steps place{};
  Instant when{};
  double fastest = 0;    ///< steps/s that the axis may go now
  std::int8_t way = 0;   ///< -1, +1: the direction to its target; 0: not known
  double any_speed = 0;  ///< steps/s that the controller can make at most
  double range = 0;      ///< of the counter, which wraps around; 0: not known
};

class CountTrack {
 public:
  void forget() { *this = CountTrack(); }
  /// Returns true once when the count was set.
  [[nodiscard]] bool add(const CountReading& now);

 private:
  static constexpr int kept = 3;
  static constexpr int confirmed = 4;  ///< readings needed before a count is believed
  using Readings = std::array<CountReading, kept>;

  void know(const CountReading& now);
  void set_known(const CountReading& now);
  void begin_other(const CountReading& now);
  [[nodiscard]] bool leads(const CountReading& from, const CountReading& now) const;
  [[nodiscard]] bool known_count_leads(const CountReading& now) const;
  [[nodiscard]] std::optional<CountReading> rested_last() const;
  [[nodiscard]] std::optional<CountReading> rests_first() const;
  [[nodiscard]] double known_rate() const;
  [[nodiscard]] bool moved_on(const CountReading& from, const CountReading& to, double other_rate) const;
  [[nodiscard]] bool motion_explains() const;

  Readings known_{};     ///< the latest, newest at the end
  Readings other_{};     ///< the first of another count ...
  CountReading last_{};  ///< ... and its last
  int known_count_ = 0, other_count_ = 0;
  int went_on_ = 0;  ///< readings before `other_`, each further in the same direction
  int missed_ = 0;   ///< readings after the latest that do not follow from it
};

}  // namespace hw
