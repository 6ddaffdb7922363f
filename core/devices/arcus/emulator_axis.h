#pragma once
// One axis of an emulated Arcus controller: its counters, its load and encoder, and what is latched on it.
#include <cstdint>
#include <optional>

#include "core/devices/arcus/facts.h"
#include "core/motion/plant.h"
#include "core/time/clock.h"

namespace hw::arcus {

/// 28 bits, as the counters wrap (decision AMB-062).
constexpr std::int64_t wrap_position(std::int64_t v) {
  constexpr std::int64_t span = position_max - position_min + 1;
  const std::int64_t r = (v - position_min) % span;
  return (r < 0 ? r + span : r) + position_min;
}

/// The parts of the five homing routines.
enum class HomeStep : std::uint8_t {
  none,
  seek_switch,  ///< towards home or limit at high speed
  slow_down,    ///< behind the home switch
  seek_index,   ///< at low speed
  back_out,     ///< backwards over the home switch until it releases
  past,         ///< further by HCA
  approach,     ///< forwards to the switch at low speed
  back_off,     ///< from the limit (LCA)
  return_zero,  ///< RZ
};

struct Homing {
  HomeStep step = HomeStep::none;
  HomeMode mode = HomeMode::home;
  Sign way = Sign::plus;
  bool seen = false;  ///< backing out: the switch has acted
};

struct Latch {
  int state = 0;  ///< 0 off, 1 armed, 2 captured
  std::int64_t pulses = 0, encoder = 0;
};

struct SyncOutput {
  int state = 0;          ///< 0 off, 1 waiting, 2 has occurred
  bool holds = false;     ///< the condition, when last checked
  std::int64_t seen = 0;  ///< encoder when last checked
  Instant pulse_until{};
  bool open = false;  ///< the newest trigger pulse of this output has not ended
};

class Axis {
 public:
  motion::Plant plant;
  double counts_per_pulse = 1;
  std::int64_t index_every = 0, index_first = 0;

  /// Pulse counter, not wrapped.
  std::int64_t pulses = 0;
  std::int64_t turned = 0;  ///< pulses made since power-up, in both directions
  /// Value that the encoder counter was set to, minus the encoder's then.
  std::int64_t encoder_offset = 0;
  bool plus_error = false, minus_error = false, alarm_error = false;
  bool alarm_operated = false, jammed_by_hand = false;

  // StepNLoop.
  std::int64_t target = 0;                            ///< in counts, unless it follows
  bool follows = false;                               ///< the target runs with the pulses:
  std::int64_t anchor_target = 0, anchor_offset = 0;  ///< target at that offset of the path
  std::optional<LoopState> loop_error;
  std::int64_t attempts = 0;
  bool extra_done = false;  ///< the extra correction at idle current (SLM)
  Instant aborted_until{};

  int slot = -1;                            ///< index of its motion; -1: none
  unsigned moved_with = 0;                  ///< a bit for each axis of its last motion without a later one
  int arrived_by = 0;                       ///< direction of the last pulse of that motion
  bool announces = false;                   ///< its arrival is to be reported (AR)
  std::optional<std::int64_t> then_target;  ///< after coming to rest: T behind the stopping point
  Homing homing;
  Latch latch;
  SyncOutput sync;
  Instant rested_at{Duration(-std::chrono::hours(1))};  ///< at rest since

  [[nodiscard]] std::int64_t encoder() const { return encoder_at(plant.load()); }
  [[nodiscard]] std::int64_t encoder_at(Steps load) const;
  void set_encoder(std::int64_t value) {
    encoder_offset += value - encoder();
    sync.seen = value;  // no position in between was passed (decision AMB-086)
  }
  [[nodiscard]] bool index_operated() const;
  /// Makes `count` pulses; `physical` is the direction of the load.
  void turn(int way, Sign physical, std::int64_t count);

  /// The first of the next `most` turns after which `holds(turns)` is true; it must stay true from there on.
  template <class Predicate>
  [[nodiscard]] std::optional<std::int64_t> first_turn(std::int64_t most, Predicate holds) const {
    if (most < 1 || !holds(most)) return std::nullopt;
    std::int64_t low = 0, high = 1;
    while (high < most && !holds(high)) low = high, high *= 2;
    if (high > most) high = most;
    while (high - low > 1) {
      const std::int64_t middle = low + (high - low) / 2;
      (holds(middle) ? high : low) = middle;
    }
    return high;
  }
  [[nodiscard]] std::optional<std::int64_t> turns_until_index(Sign physical) const;
};

}  // namespace hw::arcus
