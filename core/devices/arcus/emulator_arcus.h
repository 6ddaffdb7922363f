#pragma once
// An Arcus controller as its owner sees it: the line with its framing, the controller behind it, the bench.
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "core/devices/arcus/emulator_command.h"
#include "core/devices/arcus/emulator_controller.h"
#include "core/emulation/emulator.h"

namespace hw::arcus {

/// Of the address.
struct EmulatorOptions {
  std::optional<int> id;     ///< device number of a fresh memory
  bool unaddressed = false;  ///< obeys text without @NN too
  bool usb = false;          ///< 64-byte transfers
  bool reply_cr = false;     ///< quirk: replies end with CR
  bool motor_power = false;  ///< quirk: a load stands still while its motor has no power
};

class ArcusEmulator final : public Emulator {
 public:
  ArcusEmulator(const Model& model, std::span<const Command> commands, const EmulatorOptions& options);

  void receive(std::string_view bytes) override;
  void take_output(std::string& sink) override;
  [[nodiscard]] std::optional<Instant> next_event() const override { return controller_.next_event(); }
  void advance_to(Instant now) override;
  Result<> operate(const BenchCommand& command) override;
  void look(BenchView& view) const override;
  void report_truth(MachineTruth& truth) const override;
  [[nodiscard]] const std::vector<TriggerPulse>& pulses() const override {
    return controller_.trigger_pulses;
  }
  [[nodiscard]] int rate() const override { return controller_.rate(); }
  [[nodiscard]] std::string save_memory() const override { return controller_.saved_text(); }
  Result<> load_memory(std::string_view text) override;
  void begin_like(const ControllerState& state, const Catalog& catalog) override;
  [[nodiscard]] std::uint64_t memory_version() const override {
    return controller_.flash().stores + memory_loads_;
  }
  [[nodiscard]] std::unique_ptr<Emulator> clone() const override {
    return std::make_unique<ArcusEmulator>(*this);
  }

  /// The controller itself, for rehearsals.
  Controller& controller() { return controller_; }

 private:
  void receive_transfer(std::string_view bytes);
  void obey_line(std::string_view line);
  void obey(std::string_view command, bool answers);
  void after();
  void gather();
  [[nodiscard]] std::string address_text() const;
  Result<> check_axis(AxisId axis) const;

  /// One for each kind of bench command: emulator_bench.cpp.
  template <class Operation>
  Result<> act(const Operation& operation);

  EmulatorOptions options_;
  std::span<const Command> commands_;
  Controller controller_;
  std::string line_;       ///< received since the last CR
  bool overlong_ = false;  ///< that line is too long to be kept whole
  std::string out_;
  std::uint64_t memory_loads_ = 0;
};

/// Options that both models have: id, unaddressed, baud. A fault names the option.
Result<EmulatorOptions> read_options(const Model& model, const std::map<std::string, std::string>& given,
                                     bool has_usb, bool has_reply_cr);

}  // namespace hw::arcus
