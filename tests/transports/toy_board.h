#pragma once
// The smallest board in a memory window: 4 KiB of memory; 0xFE3 is a register that reading clears; writing it
// interrupts with the value as vector 5 ms later; each cycle is written down.
#include <array>
#include <string>
#include <vector>

#include <fmt/core.h>

#include "core/emulation/bus_target.h"
#include "core/emulation/emulator.h"
#include "core/link/window.h"

namespace hw::test {

class ToyBoard final : public Emulator, public BusTarget {
 public:
  static constexpr std::uint16_t clearing = 0xFE3;

  BusTarget* bus() override { return this; }
  std::uint8_t read8(std::uint16_t offset) override {
    cycles.push_back(fmt::format("r8 {:03X}", offset));
    const std::uint8_t value = memory[offset];
    if (offset == clearing) memory[offset] = 0;
    return value;
  }
  std::uint16_t read16(std::uint16_t offset) override {
    cycles.push_back(fmt::format("r16 {:03X}", offset));
    return static_cast<std::uint16_t>(memory[offset] << 8 | memory[offset + 1u]);
  }
  void write8(std::uint16_t offset, std::uint8_t value) override {
    cycles.push_back(fmt::format("w8 {:03X} {:02X}", offset, value));
    memory[offset] = value;
    if (offset == clearing) alarm_ = now_ + Millis(5);
  }
  void write16(std::uint16_t offset, std::uint16_t value) override {
    cycles.push_back(fmt::format("w16 {:03X} {:04X}", offset, value));
    memory[offset] = static_cast<std::uint8_t>(value >> 8);
    memory[offset + 1u] = static_cast<std::uint8_t>(value);
  }
  std::optional<std::uint8_t> interrupt() const override { return pending_; }
  void acknowledge() override { pending_.reset(); }

  void receive(std::string_view) override {}
  void take_output(std::string&) override {}
  std::optional<Instant> next_event() const override { return alarm_; }
  void advance_to(Instant now) override {
    now_ = now;
    if (!alarm_ || *alarm_ > now) return;
    alarm_.reset();
    pending_ = memory[clearing];
  }
  Result<> operate(const BenchCommand&) override {
    return fail(FaultKind::refused, "The board has no such thing.");
  }
  void look(BenchView&) const override {}
  const std::vector<TriggerPulse>& pulses() const override { return pulses_; }
  int rate() const override { return 0; }
  std::string save_memory() const override { return {}; }
  Result<> load_memory(std::string_view) override { return {}; }
  std::uint64_t memory_version() const override { return 0; }
  std::unique_ptr<Emulator> clone() const override { return std::make_unique<ToyBoard>(*this); }

  std::array<std::uint8_t, 4096> memory{};
  std::vector<std::string> cycles;

 private:
  Instant now_{};
  std::optional<Instant> alarm_;
  std::optional<std::uint8_t> pending_;
  std::vector<TriggerPulse> pulses_;
};

/// Hears what a window says by itself.
struct WindowEar final : Window::Listener {
  explicit WindowEar(Window& w) : window(w) { window.listen(this); }
  ~WindowEar() override { window.listen(nullptr); }
  void window_closed(const Fault& why) override { gone = why; }
  void interrupted(std::uint8_t vector) override { vectors.push_back(vector); }
  Window& window;
  std::optional<Fault> gone;
  std::vector<std::uint8_t> vectors;
};

}  // namespace hw::test
