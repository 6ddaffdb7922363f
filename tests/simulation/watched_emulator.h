#pragma once
// An emulator whose every event a witness sees.
#include <memory>
#include <utility>

#include "core/devices/vme58/facts.h"
#include "tests/core/device/emulator_around.h"
#include "tests/simulation/witness.h"

namespace hw::simulation {

class WatchedEmulator final : public test::EmulatorAround, public BusTarget {
 public:
  WatchedEmulator(std::unique_ptr<Emulator> inner, int device, Witness& witness)
      : EmulatorAround(std::move(inner)), device_(device), witness_(witness) {}

  void receive(std::string_view bytes) override {
    witness_.controller_received(device_, bytes);
    inner_->receive(bytes);
    look_at_bench();
    look_at_machine();
  }
  void take_output(std::string& sink) override {
    const std::size_t before = sink.size();
    inner_->take_output(sink);
    if (sink.size() > before) witness_.controller_sent(device_, std::string_view(sink).substr(before));
  }
  BusTarget* bus() override { return inner_->bus() != nullptr ? this : nullptr; }
  /// From event to event, so that none passes unseen.
  void advance_to(Instant now) override {
    for (auto next = inner_->next_event(); next && *next<now&& * next> reached_;
         next = inner_->next_event()) {
      inner_->advance_to(reached_ = *next);
      look_at_bench();  // a program may switch an output for a moment
      look_at_machine();
    }
    inner_->advance_to(reached_ = now);
    look_at_bench();
    look_at_machine();
  }
  Result<> operate(const BenchCommand& command) override {
    auto done = inner_->operate(command);
    look_at_bench();
    look_at_machine();
    return done;
  }
  void report_truth(MachineTruth& truth) const override { inner_->report_truth(truth); }

  std::uint8_t read8(std::uint16_t offset) override { return inner_->bus()->read8(offset); }
  std::uint16_t read16(std::uint16_t offset) override { return inner_->bus()->read16(offset); }
  void write8(std::uint16_t offset, std::uint8_t value) override {
    witness_.register_written(device_, offset, value);
    inner_->bus()->write8(offset, value);
    look_at_machine();
  }
  void write16(std::uint16_t offset, std::uint16_t value) override {
    witness_.register_written(device_, offset, value);
    if (in_ring(offset)) {
      const char c = static_cast<char>(value);
      witness_.controller_received(device_, {&c, 1});
    }
    inner_->bus()->write16(offset, value);
    look_at_machine();
  }
  [[nodiscard]] std::optional<std::uint8_t> interrupt() const override { return inner_->bus()->interrupt(); }
  void acknowledge() override { inner_->bus()->acknowledge(); }

 private:
  /// Where the host of a board puts its characters.
  static constexpr bool in_ring(std::uint16_t offset) {
    return offset >= vme58::at::output_buffer && offset < vme58::at::output_buffer + 2 * vme58::ring_cells;
  }
  void look_at_bench() {
    inner_->look(view_);
    witness_.bench_is(device_, view_);
  }
  void look_at_machine() {
    inner_->report_truth(truth_);
    witness_.machine_is(device_, truth_);
  }

  int device_;
  Witness& witness_;
  Instant reached_{};
  MachineTruth truth_;
  BenchView view_;
};

}  // namespace hw::simulation
