#pragma once
// An emulator with a stop-watch: it knows the moment at which a program began, when all was over, and where
// the axes were so long after the begin. Hands on the bench act by the same watch.
#include <memory>
#include <optional>
#include <utility>

#include "core/device/planned_hands.h"
#include "tests/core/device/emulator_around.h"

namespace hw::test {

class WatchedRun final : public EmulatorAround, public BusTarget {
 public:
  using EmulatorAround::EmulatorAround;

  /// From now on the next program is the one. `look_after`: when the axes are looked at. `tick`: programs
  /// begin on whole ones of these; 0: at once.
  void arm(const BenchFile& hands, Duration look_after, Duration tick, bool answers_waits) {
    file_ = hands, look_after_ = look_after, tick_ = tick, answers_waits_ = answers_waits;
    began_.reset(), ended_.reset(), seen_.reset();
    armed_ = true;
  }
  [[nodiscard]] std::optional<Instant> began() const { return began_; }
  /// Since the begin, to the latest moment at which something was at work; none: it still is.
  [[nodiscard]] std::optional<Duration> took() const {
    if (!began_ || !ended_) return std::nullopt;
    return *ended_ - *began_;
  }
  /// At the moment that arm() asked for.
  [[nodiscard]] const std::optional<MachineTruth>& seen() const { return seen_; }
  [[nodiscard]] std::uint32_t outputs_seen() const { return outputs_seen_; }

  void receive(std::string_view bytes) override {
    inner_->receive(bytes);
    look_at_it();
  }
  void take_output(std::string& sink) override {
    const std::size_t before = sink.size();
    inner_->take_output(sink);
    if (answers_waits_ && began_ && sink.find('W', before) != std::string::npos) inner_->receive("G");
  }
  [[nodiscard]] std::optional<Instant> next_event() const override {
    std::optional<Instant> next = inner_->next_event();
    for (const auto& other : {hands_.next(), look_at_})
      if (other && (!next || *other < *next)) next = other;
    return next;
  }
  void advance_to(Instant now) override {
    for (auto next = next_event(); next && *next<now&& * next> reached_; next = next_event()) step(*next);
    step(now);
  }
  void tell_truth(MachineTruth& truth) const override { inner_->tell_truth(truth); }

  BusTarget* bus() override { return inner_->bus() != nullptr ? this : nullptr; }
  std::uint8_t read8(std::uint16_t offset) override { return inner_->bus()->read8(offset); }
  std::uint16_t read16(std::uint16_t offset) override { return inner_->bus()->read16(offset); }
  void write8(std::uint16_t offset, std::uint8_t value) override {
    inner_->bus()->write8(offset, value);
    look_at_it();
  }
  void write16(std::uint16_t offset, std::uint16_t value) override {
    inner_->bus()->write16(offset, value);
    look_at_it();
  }
  [[nodiscard]] std::optional<std::uint8_t> interrupt() const override { return inner_->bus()->interrupt(); }
  void acknowledge() override { inner_->bus()->acknowledge(); }

 private:
  void step(Instant to) {
    inner_->advance_to(reached_ = to);
    hands_.act_until(reached_, *inner_);
    look_at_it();
    if (!look_at_ || *look_at_ > reached_) return;
    look_at_.reset();
    seen_ = truth_;
    BenchView view;
    inner_->look(view);
    outputs_seen_ = view.outputs;
  }
  void look_at_it() {
    inner_->tell_truth(truth_);
    const bool at_work = truth_.program || truth_.moving() != 0;
    if (armed_ && at_work) begin();
    if (!began_) return;
    if (at_work)
      ended_.reset();
    else if (!ended_)
      ended_ = reached_;
  }
  void begin() {
    armed_ = false;
    const auto late = tick_ > Duration{} ? reached_.time_since_epoch() % tick_ : Duration{};
    began_ = late > Duration{} ? reached_ + (tick_ - late) : reached_;
    look_at_ = *began_ + look_after_;
    hands_.count_from(*began_);
    (void)hands_.begin(file_, *inner_);
  }

  BenchFile file_;
  Duration look_after_{}, tick_{};
  bool armed_ = false, answers_waits_ = false;
  Instant reached_{};
  PlannedHands hands_;
  std::optional<Instant> began_, ended_, look_at_;
  MachineTruth truth_;
  std::optional<MachineTruth> seen_;
  std::uint32_t outputs_seen_ = 0;
};

}  // namespace hw::test
