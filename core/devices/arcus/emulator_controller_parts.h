#pragma once
// Parts of an emulated controller that have a state of their own and know nothing of the rest.
#include <array>
#include <chrono>
#include <cstdint>
#include <optional>

#include "core/devices/arcus/emulator_settings.h"
#include "core/devices/arcus/facts.h"
#include "core/time/clock.h"

namespace hw::arcus {

/// How it talks to its host, from power-up on: changed settings take effect at the next.
struct HostSettings {
  int address = 0, rate = 9600;
  bool prefixes_replies = false, announces_arrivals = false;
  void take(const Settings& settings) {
    address = static_cast<int>(settings.get(Setting::device_name));
    for (const Baud& b : bauds)
      if (b.code == settings.get(Setting::baud_code)) rate = b.rate;
    prefixes_replies = settings.on(Setting::response_type);
    announces_arrivals = settings.on(Setting::auto_response);
  }
};

/// The time-out of TOC: the host has been silent for too long.
class HostTimeout {
 public:
  /// A command of the host has arrived. `ms`: the silence allowed; 0: any.
  void command_came(std::int64_t ms, Instant now) {
    if (ms > 0) due_ = now + std::chrono::milliseconds(ms);
  }
  /// The bit is shown to the host once (decision AMB-044).
  void was_shown() { fired_ = false; }
  void forget() { *this = HostTimeout(); }
  /// True: it comes just now.
  bool comes(Instant now) {
    if (!due_ || *due_ > now) return false;
    due_.reset();
    return fired_ = true;
  }
  [[nodiscard]] const std::optional<Instant>& due() const { return due_; }
  [[nodiscard]] bool fired() const { return fired_; }

 private:
  std::optional<Instant> due_;
  bool fired_ = false;
};

struct JoystickTurns {
  std::array<double, most_axes> speed{};  ///< pulses/s, signed
  std::optional<Instant> due;             ///< the next change of a speed
};

/// The levels at the terminals, before polarity.
struct Terminals {
  std::int64_t outputs = 0, enables = 0;
  std::uint32_t inputs = 0;  ///< operated
  std::array<std::int32_t, 8> analog{};
};

}  // namespace hw::arcus
