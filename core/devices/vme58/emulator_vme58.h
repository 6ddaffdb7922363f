#pragma once
// The emulated VME58 as the program sees it: bus, time, bench.
#include <memory>
#include <string>
#include <vector>

#include "core/devices/vme58/emulator_board.h"
#include "core/emulation/emulator.h"

namespace hw::vme58 {

class Vme58Emulator final : public Emulator, public BusTarget {
 public:
  explicit Vme58Emulator(const BoardOptions& make) : board_(make) {}

  // No byte stream.
  void receive(std::string_view) override {}
  void take_output(std::string&) override {}
  BusTarget* bus() override { return this; }

  std::uint8_t read8(std::uint16_t offset) override;
  std::uint16_t read16(std::uint16_t offset) override;
  void write8(std::uint16_t offset, std::uint8_t value) override;
  void write16(std::uint16_t offset, std::uint16_t value) override;
  [[nodiscard]] std::optional<std::uint8_t> interrupt() const override { return board_.interrupt(); }
  void acknowledge() override { board_.acknowledge(); }

  [[nodiscard]] std::optional<Instant> next_event() const override { return board_.next_event(); }
  void advance_to(Instant now) override;
  Result<> operate(const BenchCommand& command) override;
  void look(BenchView& view) const override;
  void report_truth(MachineTruth& truth) const override;
  [[nodiscard]] const std::vector<TriggerPulse>& pulses() const override { return pulses_; }

  [[nodiscard]] int rate() const override { return 0; }
  /// Returns a text saying that a VME58 keeps nothing without power.
  [[nodiscard]] std::string save_memory() const override;
  Result<> load_memory(std::string_view text) override;
  [[nodiscard]] std::uint64_t memory_version() const override { return 0; }
  [[nodiscard]] std::unique_ptr<Emulator> clone() const override {
    return std::make_unique<Vme58Emulator>(*this);
  }

  /// The board itself, for rehearsals and tests.
  Board& board() { return board_; }

 private:
  Result<> check_axis(AxisId axis) const;

  /// One for each kind of bench action: emulator_bench.cpp.
  template <class Operation>
  Result<> act(const Operation& operation);

  Board board_;
  std::vector<TriggerPulse> pulses_;  ///< none: no output of this board is tied to a position
};

}  // namespace hw::vme58
