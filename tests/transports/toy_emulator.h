#pragma once
// The smallest controller that has everything a host must serve: answers, something that takes time, a rate
// that can be changed, memory.
//   V -> R     X, Y -> +0000400<CR>     M -> ^ after 100 ms     4, 9 -> rate 38400, 9600     S -> stores
#include <algorithm>

#include "core/emulation/emulator.h"

namespace hw::test {

class ToyEmulator final : public Emulator {
 public:
  void receive(std::string_view bytes) override {
    for (const char c : bytes) take(c);
  }
  void take_output(std::string& sink) override {
    sink += output_;
    output_.clear();
  }
  std::optional<Instant> next_event() const override { return move_end_; }
  void advance_to(Instant now) override {
    now_ = now;
    if (!move_end_ || *move_end_ > now) return;
    move_end_.reset();
    output_ += '^';
  }
  Result<> operate(const BenchCommand& command) override {
    if (const auto* power = std::get_if<bench::Power>(&command)) {
      powered_ = power->on;
      return {};
    }
    if (std::holds_alternative<bench::PowerCycle>(command)) {
      output_ += 'J';
      return {};
    }
    return fail(FaultKind::refused, "The toy has no such thing.");
  }
  void look(BenchView& view) const override {
    view.powered = powered_;
    view.lamps = move_end_ ? 1 : 0;
  }
  const std::vector<TriggerPulse>& pulses() const override { return pulses_; }
  int rate() const override { return rate_; }
  std::string save_memory() const override { return "stored " + std::to_string(stores_) + "\n"; }
  Result<> load_memory(std::string_view text) override {
    if (!text.starts_with("stored ")) return fail(FaultKind::text, "It does not begin with \"stored\".");
    stores_ = std::stoi(std::string(text.substr(7)));
    return {};
  }
  std::uint64_t memory_version() const override { return static_cast<std::uint64_t>(stores_); }
  std::unique_ptr<Emulator> clone() const override { return std::make_unique<ToyEmulator>(*this); }

  const std::string& received() const { return received_; }

 private:
  void take(char c) {
    received_ += c;
    if (!powered_) return;
    if (c == 'V') output_ += 'R';
    if (c == 'X' || c == 'Y') output_ += "+0000400\r";
    if (c == 'M') move_end_ = now_ + Millis(100);
    if (c == '4') rate_ = 38400;
    if (c == '9') rate_ = 9600;
    if (c == 'S') ++stores_;
  }

  Instant now_{};
  std::optional<Instant> move_end_;
  std::string output_, received_;
  std::vector<TriggerPulse> pulses_;
  int rate_ = 9600, stores_ = 0;
  bool powered_ = true;
};

}  // namespace hw::test
