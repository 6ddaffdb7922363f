#pragma once
// An emulated Arcus controller on the test bench: its line, its virtual time, and hands.
#include <chrono>
#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

#include "core/emulation/emulator.h"

namespace hw::arcus::proof {

using namespace std::chrono_literals;
using Options = std::map<std::string, std::string>;

enum class Which { pmx, dmx };

class Rig {
 public:
  explicit Rig(Which which, const Options& options = {});

  /// Sends a command with address and CR, gives back the reply without its end. The reply must be whole. What
  /// came unasked before stays for output().
  std::string ask(std::string_view command);
  std::int64_t number(std::string_view command);
  /// Asks, and expects OK.
  void ok(std::string_view command);
  void send(std::string_view bytes) { emulator_->receive(bytes); }
  /// The bytes as they are, and what came back at this instant.
  std::string raw(std::string_view bytes);
  std::string output();
  [[nodiscard]] std::string address() const { return address_; }
  void set_address(std::string address) { address_ = std::move(address); }

  void run_for(Duration d);
  /// Until the axis rests: the time that took.
  Duration run_to_rest(int axis = 0, Duration patience = 24h);
  [[nodiscard]] Duration elapsed() const { return now_.time_since_epoch(); }

  Result<> operate(const BenchCommand& command) { return emulator_->operate(command); }
  void input(int n, bool on) { must(bench::Input(n, on)); }
  void limit(int axis, char side, bool on) {
    must(bench::Limit(id(axis), side == '+' ? Sign::plus : Sign::minus, on));
  }
  void home_switch(int axis, bool on) { must(bench::HomeSwitch(id(axis), on)); }
  void alarm(int axis, bool on) { must(bench::Alarm(id(axis), on)); }
  void analog(int n, int mv) { must(bench::Analog(n, mv)); }
  void jam(int axis, bool on) { must(bench::Jam(id(axis), on)); }
  void slip(int axis, std::int64_t counts) { must(bench::Slip(id(axis), Steps(counts))); }
  void place(int axis, const AxisPlace& where) { must(bench::Place(id(axis), where)); }
  void power_cycle();

  [[nodiscard]] BenchView view() const;
  [[nodiscard]] std::int64_t load(int axis) const {
    return view().load_position[static_cast<std::size_t>(axis)].value;
  }
  [[nodiscard]] bool out(int n) const { return (view().outputs >> (n - 1) & 1u) != 0; }
  Emulator& emulator() { return *emulator_; }
  [[nodiscard]] Which which() const { return which_; }

 private:
  static AxisId id(int axis) { return AxisId{static_cast<std::uint8_t>(axis)}; }
  void must(const BenchCommand& command);

  Which which_;
  std::unique_ptr<Emulator> emulator_;
  Instant now_{};
  std::string address_, unsolicited_;
};

/// Time of a trapezoid over `length` with the controllers' rules (speeds in the same unit, ms).
Duration trapezoid_time(double length, double high, double low, double accel_ms, double decel_ms);
::testing::AssertionResult same_time(Duration got, Duration expected, Duration tolerance = 2us);

}  // namespace hw::arcus::proof
