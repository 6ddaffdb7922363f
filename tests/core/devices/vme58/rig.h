#pragma once
// An emulated VME58 in its slot: a host that talks through the window, virtual time, and hands on the bench.
// What tests say to it reads like a program of a host: rig.send("AX MR400 GO ID"), rig.run_until_done("X"),
// rig.ask("RP").
#include <chrono>
#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <string_view>

#include <gtest/gtest.h>

#include "core/devices/vme58/facts.h"
#include "core/emulation/emulator.h"

namespace hw::vme58::proof {

using namespace std::chrono_literals;

using DeviceOptions = std::map<std::string, std::string>;

/// Bit of an axis by its letter.
constexpr unsigned bit_of(char letter) { return 1u << axis_letters.find(letter); }

class Rig {
 public:
  explicit Rig(const DeviceOptions& options = {});
  static Rig model(const std::string& variant) { return Rig(DeviceOptions{{"variant", variant}}); }

  // The rings.
  /// Puts all characters into the ring and publishes them; in parts where they are more than it holds. Fails
  /// when the board does not take what stands in front of the last 255.
  void send(std::string_view text);
  /// What the board has said since the last call, as it came.
  std::string output();
  /// Sends, and gives back what comes at this very instant.
  std::string ask(std::string_view text);
  /// The same without the frame of control characters.
  std::string value(std::string_view text);
  /// Characters that the board has not taken yet.
  int waiting();
  /// A command of two letters through the mailbox.
  void mail(std::string_view letters);

  // The bus.
  std::uint8_t read8(std::uint16_t offset) { return static_cast<std::uint8_t>(cycle(false, 1, offset)); }
  std::uint16_t read16(std::uint16_t offset) { return static_cast<std::uint16_t>(cycle(false, 2, offset)); }
  std::uint32_t read32(std::uint16_t offset) { return cycle(false, 4, offset); }
  void write8(std::uint16_t offset, std::uint8_t v) { cycle(true, 1, offset, v); }
  void write16(std::uint16_t offset, std::uint16_t v) { cycle(true, 2, offset, v); }
  void write32(std::uint16_t offset, std::uint32_t v) { cycle(true, 4, offset, v); }
  std::uint8_t status() { return read8(reg::status); }
  std::uint8_t done() { return read8(reg::done); }
  /// The command error bit, which reading clears.
  bool command_error() { return (status() & status::command_error) != 0; }
  /// Asks for a copy of the axis data, waits for it, and gives one value back.
  std::int32_t axis_value(char letter, AxisValue value);
  BusTarget& bus() { return *emulator_->bus(); }

  // Time.
  [[nodiscard]] Instant now() const { return now_; }
  [[nodiscard]] Duration elapsed() const { return now_.time_since_epoch(); }
  void run_for(Duration d) { advance_to(now_ + d); }
  /// Goes on, event by event, until all these axes have their done flag (which it does not clear). Fails when
  /// that takes longer than `patience`. Returns the time it took.
  Duration run_until_done(std::string_view letters, Duration patience = 1h);
  /// Until nothing happens any more by itself.
  void run_until_quiet(Duration patience = 1h);

  // Hands.
  /// Line by the maker's number, 0 to 13.
  void line(int number, bool low) { operate(bench::Input(number + 1, low)); }
  void limit(char letter, char side, bool operated);
  void home_switch(char letter, bool operated) { operate(bench::HomeSwitch(axis(letter), operated)); }
  void place(char letter, const AxisPlace& where) { operate(bench::Place(axis(letter), where)); }
  void operate(const BenchCommand& command);
  [[nodiscard]] BenchView view() const;
  /// Level of an auxiliary output: true is high, the driver's transistor off.
  [[nodiscard]] bool aux_high(char letter) const;
  /// Level of a general output line, 8 to 13 with the factory's jumpers.
  [[nodiscard]] bool line_low(int number) const { return (view().outputs >> (number - 8) & 1u) != 0; }

  // What the board says of an axis; leaves that axis addressed.
  std::int64_t position(char letter);
  std::int64_t velocity(char letter);
  bool moving(char letter) { return velocity(letter) != 0; }
  int room(char letter);

  Emulator& emulator() { return *emulator_; }

 private:
  static AxisId axis(char letter) { return AxisId{static_cast<std::uint8_t>(axis_letters.find(letter))}; }
  std::uint32_t cycle(bool write, std::uint8_t width, std::uint16_t offset, std::uint32_t v = 0) {
    return bus_cycle(bus(), write, width, offset, v);
  }
  void advance_to(Instant t);
  std::int64_t number(char letter, std::string_view query);

  std::unique_ptr<Emulator> emulator_;
  Instant now_{};
};

/// Control characters made visible: <lf><cr>.
std::string visible(std::string_view bytes);

/// Frames of replies (decision M01).
inline std::string framed(std::string_view text) { return "\n\r" + std::string(text) + "\n\r"; }
inline std::string status_framed(std::string_view text) { return "\n\r\r" + std::string(text) + "\n\r\r"; }

}  // namespace hw::vme58::proof
