#pragma once
// An emulator with something between it and the wire: whoever derives from it says what.
#include <memory>
#include <utility>

#include "core/emulation/emulator.h"

namespace hw::test {

class EmulatorAround : public Emulator {
 public:
  explicit EmulatorAround(std::unique_ptr<Emulator> inner) : inner_(std::move(inner)) {}

  void receive(std::string_view bytes) override { inner_->receive(bytes); }
  void take_output(std::string& sink) override { inner_->take_output(sink); }
  [[nodiscard]] std::optional<Instant> next_event() const override { return inner_->next_event(); }
  void advance_to(Instant now) override { inner_->advance_to(now); }
  Result<> operate(const BenchCommand& command) override { return inner_->operate(command); }
  void look(BenchView& view) const override { inner_->look(view); }
  [[nodiscard]] const std::vector<TriggerPulse>& pulses() const override { return inner_->pulses(); }
  [[nodiscard]] int rate() const override { return inner_->rate(); }
  [[nodiscard]] std::string save_memory() const override { return inner_->save_memory(); }
  Result<> load_memory(std::string_view text) override { return inner_->load_memory(text); }
  [[nodiscard]] std::uint64_t memory_version() const override { return inner_->memory_version(); }
  [[nodiscard]] std::unique_ptr<Emulator> clone() const override { return inner_->clone(); }

 protected:
  std::unique_ptr<Emulator> inner_;
};

}  // namespace hw::test
