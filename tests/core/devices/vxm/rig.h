#pragma once
// An emulated VXM on the test bench: the emulator, its virtual time, and hands. What tests say to it reads
// like a session at a terminal: rig.send("F"), rig.run_until_output("^"), rig.press("1+").
#include <chrono>
#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

#include "core/emulation/emulator.h"

namespace hw::vxm::proof {

using namespace std::chrono_literals;

using DeviceOptions = std::map<std::string, std::string>;

class Rig {
 public:
  /// Powers it up and lets the lamp sequence pass, as an operator would wait for it. The slides are endless
  /// until place() says where their switches are.
  explicit Rig(const DeviceOptions& options = {});
  static Rig with_slave();
  /// In mode F with an empty program.
  static Rig online();
  static Rig online_with_slave();

  // The wire.
  void send(std::string_view bytes) { emulator_->receive(bytes); }
  /// What came out since the last call.
  std::string output();
  /// Sends and gives back what comes out at this very instant.
  std::string ask(std::string_view bytes);
  /// `M`, the bytes free in the selected program.
  int free_bytes();
  /// Bytes used in the selected program.
  int used_bytes() { return 256 - free_bytes(); }

  // Time.
  [[nodiscard]] Duration elapsed() const { return now_.time_since_epoch(); }
  void run_for(Duration d);
  /// Goes on, event by event, until `text` has come out (it stays readable by output()). False when it has
  /// not come within `patience`.
  bool run_until_output(std::string_view text, Duration patience = 24h);
  /// Runs what is selected with R and gives back the time until the prompt; the output until then is dropped.
  Duration run_program(Duration patience = 24h);
  /// C, the text, R; time until the prompt.
  Duration run(std::string_view program, Duration patience = 24h);

  // Hands.
  void input(int number, bool low) { operate(bench::Input(number, low)); }
  void analog(int number, int value) { operate(bench::Analog(number, value)); }
  void limit(int motor, char sign, bool operated);
  void home_switch(int motor, bool operated) { operate(bench::HomeSwitch(axis(motor), operated)); }
  void place(int motor, const AxisPlace& where) { operate(bench::Place(axis(motor), where)); }
  void press(std::string button) { operate(bench::Button(std::move(button), true)); }
  void release(std::string button) { operate(bench::Button(std::move(button), false)); }
  /// Down for `held`, then up, and as long again to let any debouncing pass.
  void click(const std::string& button, Duration held = 50ms);
  /// The same with an input of the I/O connector.
  void pulse_input(int number, Duration held = 50ms);
  void power_cycle();
  void operate(const BenchCommand& command);

  // What can be seen.
  [[nodiscard]] BenchView view() const;
  [[nodiscard]] bool out(int number) const { return (view().outputs >> (number - 1)) & 1u; }
  [[nodiscard]] std::int64_t load(int motor) const {
    return view().load_position[static_cast<std::size_t>(motor - 1)].value;
  }
  [[nodiscard]] bool power_lamp() const { return view().lamps & 1u; }
  [[nodiscard]] bool online_lamp() const { return view().lamps & 2u; }
  /// The controller's own counters, asked with X, Y, Z, T.
  std::int64_t position(int motor);
  [[nodiscard]] const std::vector<TriggerPulse>& pulses() const { return emulator_->pulses(); }
  /// Positions of motor `m` at the pulses of output `number` since the last call of forget_pulses().
  [[nodiscard]] std::vector<std::int64_t> pulse_positions(int motor, int number = 2) const;
  void forget_pulses() { first_pulse_ = pulses().size(); }

  Emulator& emulator() { return *emulator_; }

 private:
  static AxisId axis(int motor) { return AxisId{static_cast<std::uint8_t>(motor - 1)}; }
  void collect() { emulator_->take_output(pending_); }
  void advance_to(Instant t);

  std::unique_ptr<Emulator> emulator_;
  Instant now_{};
  std::string pending_;
  std::size_t first_pulse_ = 0;
};

/// Time of an index of `steps` at `speed` steps/s and the VXM's acceleration value `a` (decisions V54 to
/// V56).
Duration index_time(std::int64_t steps, double speed = 2000, double a = 2);
/// Steps that a ramp between standstill and `speed` covers.
double ramp_steps(double speed, double a = 2);

/// Equal to the microsecond.
::testing::AssertionResult same_time(Duration got, Duration expected, Duration tolerance = 2us);

/// V is answered with B: a program runs.
inline bool is_busy(Rig& rig) { return rig.ask("V") == "B"; }

/// Control characters made visible.
std::string visible(std::string_view bytes);

/// "+0001200\r"
std::string position_text(std::int64_t position);

}  // namespace hw::vxm::proof
