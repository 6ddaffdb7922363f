#pragma once
// An emulator whose every event a witness sees.
#include <memory>
#include <utility>

#include "core/device/emulator.h"
#include "tests/simulation/witness.h"

namespace hw::simulation {

class WatchedEmulator final : public Emulator, public BusTarget {
 public:
  WatchedEmulator(std::unique_ptr<Emulator> inner, int device, Witness& witness)
      : inner_(std::move(inner)), device_(device), witness_(witness) {}

  void receive(std::string_view bytes) override {
    witness_.controller_received(device_, bytes);
    inner_->receive(bytes);
    inner_->look(view_);
    witness_.bench_is(device_, view_);
    look_at_machine();
  }
  void take_output(std::string& sink) override {
    const std::size_t before = sink.size();
    inner_->take_output(sink);
    if (sink.size() > before) witness_.controller_sent(device_, std::string_view(sink).substr(before));
  }
  BusTarget* bus() override { return inner_->bus() != nullptr ? this : nullptr; }
  [[nodiscard]] std::optional<Instant> next_event() const override { return inner_->next_event(); }
  /// From event to event, so that none passes unseen.
  void advance_to(Instant now) override {
    for (auto next = inner_->next_event(); next && *next<now&& * next> reached_;
         next = inner_->next_event()) {
      inner_->advance_to(reached_ = *next);
      look_at_machine();
    }
    inner_->advance_to(reached_ = now);
    look_at_machine();
  }
  Result<> operate(const BenchCommand& command) override {
    auto done = inner_->operate(command);
    look_at_machine();
    return done;
  }
  void look(BenchView& view) const override { inner_->look(view); }
  void tell_truth(MachineTruth& truth) const override { inner_->tell_truth(truth); }
  [[nodiscard]] const std::vector<TriggerPulse>& pulses() const override { return inner_->pulses(); }
  [[nodiscard]] int rate() const override { return inner_->rate(); }
  [[nodiscard]] std::string save_memory() const override { return inner_->save_memory(); }
  Result<> load_memory(std::string_view text) override { return inner_->load_memory(text); }
  [[nodiscard]] std::uint64_t memory_version() const override { return inner_->memory_version(); }
  [[nodiscard]] std::unique_ptr<Emulator> clone() const override { return inner_->clone(); }

  std::uint8_t read8(std::uint16_t offset) override { return inner_->bus()->read8(offset); }
  std::uint16_t read16(std::uint16_t offset) override { return inner_->bus()->read16(offset); }
  void write8(std::uint16_t offset, std::uint8_t value) override {
    witness_.register_written(device_, offset, value);
    inner_->bus()->write8(offset, value);
    look_at_machine();
  }
  void write16(std::uint16_t offset, std::uint16_t value) override {
    witness_.register_written(device_, offset, value);
    inner_->bus()->write16(offset, value);
    look_at_machine();
  }
  [[nodiscard]] std::optional<std::uint8_t> interrupt() const override { return inner_->bus()->interrupt(); }
  void acknowledge() override { inner_->bus()->acknowledge(); }

 private:
  void look_at_machine() {
    inner_->tell_truth(truth_);
    witness_.machine_is(device_, truth_);
  }

  std::unique_ptr<Emulator> inner_;
  int device_;
  Witness& witness_;
  Instant reached_{};
  MachineTruth truth_;
  BenchView view_;
};

}  // namespace hw::simulation
