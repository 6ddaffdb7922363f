#pragma once
// The emulator as its owner sees it: a controller, its Slave, the bench around both, and the bytes sent.
#include <array>
#include <deque>
#include <memory>
#include <string>
#include <vector>

#include "core/devices/vxm/emulator_box.h"
#include "core/emulation/emulator.h"

namespace hw::vxm {

/// Options of the address.
struct EmulatorOptions {
  int motors = 2;
  bool overrun = false, barred = false;
  bool mode_while_running = false;  ///< E and F are taken while a program runs (V103)
  bool old_firmware = false;        ///< 1.19: no $, no PA, and no command listed while it holds
};

class VxmEmulator final : public Emulator {
 public:
  explicit VxmEmulator(const EmulatorOptions& options);

  void receive(std::string_view bytes) override;
  void take_output(std::string& sink) override;
  [[nodiscard]] std::optional<Instant> next_event() const override;
  void advance_to(Instant now) override;
  Result<> operate(const BenchCommand& command) override;
  void look(BenchView& view) const override;
  void report_truth(MachineTruth& truth) const override;
  [[nodiscard]] const std::vector<TriggerPulse>& pulses() const override;
  [[nodiscard]] int rate() const override { return box_.rate(); }
  [[nodiscard]] std::string save_memory() const override;
  Result<> load_memory(std::string_view text) override;
  [[nodiscard]] std::uint64_t memory_version() const override { return box_.stores + memory_loads_; }
  [[nodiscard]] std::unique_ptr<Emulator> clone() const override {
    return std::make_unique<VxmEmulator>(*this);
  }

  /// The controller itself, for rehearsals.
  [[nodiscard]] Box& box() { return box_; }

 private:
  void after();
  void gather_pulses(Box& box, int first_axis, int first_output);
  void pace_replies();
  Box& box_of(int axis) { return axis < motors_per_controller ? box_ : *box_.slave(); }
  [[nodiscard]] const Box& box_of(int axis) const {
    return axis < motors_per_controller ? box_ : *box_.slave();
  }
  [[nodiscard]] int boxes() const { return options_.motors > motors_per_controller ? 2 : 1; }
  Result<> check_axis(AxisId axis) const;

  /// One for each kind of bench command: emulator_hands.cpp.
  template <class Operation>
  Result<> act(const Operation& operation);
  void press(int button, bool on);
  void drive_line(int box, int line);
  Result<> check_supply(int supply) const;
  void supply_power(int box);

  EmulatorOptions options_;
  Box box_;
  Instant now_{};
  std::uint32_t buttons_ = 0, inputs_ = 0;
  struct Supply {
    bool switched_on = true, breaker_out = false;
    [[nodiscard]] bool gives_power() const { return switched_on && !breaker_out; }
  };
  std::array<Supply, 2> supplies_{};  ///< of the controller, of its Slave
  struct Held {
    Instant leaves;
    char byte;
  };
  std::deque<Held> held_back_;  ///< quirk overrun: the reply being sent and the bytes behind it
  Instant answering_until_{};
  std::uint64_t memory_loads_ = 0;
  mutable std::vector<TriggerPulse> pulses_;
};

}  // namespace hw::vxm
