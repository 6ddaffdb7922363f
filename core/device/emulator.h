#pragma once
// A controller's firmware in miniature: a passive value without clock, thread or I/O. Whoever owns it brings
// bytes in, carries output away and moves its time. The same object runs in real time behind a pty, ten
// thousand times faster in a test, and under a fuzzer.
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/device/bench.h"
#include "core/device/bus_target.h"
#include "core/device/machine_truth.h"
#include "core/time/clock.h"

namespace hw {

struct Catalog;
struct ControllerState;

class Emulator {
 public:
  virtual ~Emulator() = default;

  /// Bytes from the host, at the time of the last advance_to().
  virtual void receive(std::string_view bytes) = 0;
  /// Moves the output that has come up since the last call to the end of `sink`.
  virtual void take_output(std::string& sink) = 0;
  /// Of a board in a memory window: its side of the bus. Then receive() and take_output() do nothing.
  virtual BusTarget* bus() { return nullptr; }
  /// When something happens next by itself (a step that matters, a pause, a lamp). None: nothing will.
  [[nodiscard]] virtual std::optional<Instant> next_event() const = 0;
  /// Time goes on; everything due up to and including `now` happens in order. Never goes backwards.
  virtual void advance_to(Instant now) = 0;

  /// The hand on the bench. Refuses what this device does not have, with a sentence.
  virtual Result<> operate(const BenchCommand& command) = 0;
  virtual void look(BenchView& view) const = 0;
  /// What its axes really do at the time of the last advance_to(). axis_count 0: it does not tell.
  virtual void tell_truth(MachineTruth&) const {}
  /// Trigger pulses so far, oldest first (kept to the last 100,000).
  [[nodiscard]] virtual const std::vector<TriggerPulse>& pulses() const = 0;

  /// The line rate that it listens at now; 0: no rate.
  [[nodiscard]] virtual int rate() const = 0;
  /// Non-volatile memory as text, to be kept in a file; and back. `store_count` of it goes up at each store.
  [[nodiscard]] virtual std::string save_memory() const = 0;
  virtual Result<> load_memory(std::string_view text) = 0;
  /// Freshly switched on, it stands from here on as is known of a controller like it; what `state` does not
  /// tell stays. Only of devices that share a wire: the others are rehearsed by their language.
  virtual void begin_like(const ControllerState&, const Catalog&) {}
  /// Changes at each write to non-volatile memory.
  [[nodiscard]] virtual std::uint64_t memory_version() const = 0;

  [[nodiscard]] virtual std::unique_ptr<Emulator> clone() const = 0;
};

}  // namespace hw
