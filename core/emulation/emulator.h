#pragma once
// A controller's firmware in miniature: a passive object without clock, thread or I/O. Its owner feeds it
// bytes, takes its output and advances its time. The same object runs in real time behind a pty, ten thousand
// times faster in a test, and under a fuzzer.
#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/device/bench.h"
#include "core/emulation/bus_target.h"
#include "core/emulation/machine_truth.h"
#include "core/time/clock.h"

namespace hw {

struct Catalog;
struct ControllerState;

/// Trigger pulses that an emulator remembers.
inline constexpr std::size_t pulses_kept = 100'000;
/// Events at one instant before time has to go on.
inline constexpr int most_events_at_once = 100'000;

class Emulator {
 public:
  virtual ~Emulator() = default;

  /// Bytes from the host, at the time of the last advance_to().
  virtual void receive(std::string_view bytes) = 0;
  /// Appends the output since the last call to `sink`.
  virtual void take_output(std::string& sink) = 0;
  /// For a board in a memory window: its side of the bus; receive() and take_output() do nothing then.
  virtual BusTarget* bus() { return nullptr; }
  /// Time of the next event without input (a step, the end of a pause, a lamp). None: there is none.
  [[nodiscard]] virtual std::optional<Instant> next_event() const = 0;
  /// Advances time; everything due up to and including `now` happens in order. Never backwards.
  virtual void advance_to(Instant now) = 0;

  /// Performs a bench command. The fault says what this device lacks.
  virtual Result<> operate(const BenchCommand& command) = 0;
  virtual void look(BenchView& view) const = 0;
  /// The true state of its axes at the last advance_to(). axis_count 0: not available.
  virtual void report_truth(MachineTruth&) const {}
  /// The last `pulses_kept` trigger pulses, and perhaps some before them, oldest first.
  [[nodiscard]] virtual const std::vector<TriggerPulse>& pulses() const = 0;

  /// Its present line rate; 0: none.
  [[nodiscard]] virtual int rate() const = 0;
  /// Its non-volatile memory as text for a file, and back. `store_count` in it increases with each store.
  [[nodiscard]] virtual std::string save_memory() const = 0;
  virtual Result<> load_memory(std::string_view text) = 0;
  /// Puts a freshly started emulator into the known state of a controller; values unknown to `state` stay.
  /// Only for devices that share a wire: others are rehearsed by their language.
  virtual void begin_like(const ControllerState&, const Catalog&) {}
  /// Changes at each write to non-volatile memory.
  [[nodiscard]] virtual std::uint64_t memory_version() const = 0;

  /// An independent copy: tests and fuzzers continue from the same moment twice.
  [[nodiscard]] virtual std::unique_ptr<Emulator> clone() const = 0;
};

}  // namespace hw
