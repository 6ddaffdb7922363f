#pragma once
// An emulator with a stop-watch: it knows the moment at which a program began, when all was over, and how it
// stood at moments after the begin. Hands on the bench act by the same watch.
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "core/emulation/bench_schedule.h"
#include "tests/core/device/emulator_around.h"

namespace hw::test {

class WatchedRun final : public EmulatorAround, public BusTarget {
 public:
  using EmulatorAround::EmulatorAround;

  struct Look {
    MachineTruth truth;
    std::uint32_t outputs = 0;
  };
  /// From now on the next program is the one. `look_after`: when it is looked at, each later than the one
  /// before. `tick`: programs begin on whole ones of these; 0: at once.
  void arm(const BenchFile& hands, std::vector<Duration> look_after, Duration tick, bool answers_waits) {
    file_ = hands, look_after_ = std::move(look_after), tick_ = tick, answers_waits_ = answers_waits;
    began_.reset(), ended_.reset(), looks_.clear();
    armed_ = true;
  }
  [[nodiscard]] std::optional<Instant> began() const { return began_; }
  /// Since the begin, to the latest moment at which something was at work; none: it still is.
  [[nodiscard]] std::optional<Duration> took() const {
    if (!began_ || !ended_) return std::nullopt;
    return *ended_ - *began_;
  }
  /// At the moments that arm() asked for, as far as they have come.
  [[nodiscard]] const std::vector<Look>& looks() const { return looks_; }
  [[nodiscard]] bool has_seen_all() const { return began_ && looks_.size() == look_after_.size(); }

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
    for (const auto& other : {bench_schedule_.next(), next_look()})
      if (other && (!next || *other < *next)) next = other;
    return next;
  }
  void advance_to(Instant now) override {
    for (auto next = next_event(); next && *next<now&& * next> reached_; next = next_event()) step(*next);
    step(now);
  }
  void report_truth(MachineTruth& truth) const override { inner_->report_truth(truth); }

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
    bench_schedule_.act_until(reached_, *inner_);
    look_at_it();
    for (auto due = next_look(); due && *due <= reached_; due = next_look()) {
      BenchView view;
      inner_->look(view);
      looks_.push_back({truth_, view.outputs});
    }
  }
  [[nodiscard]] std::optional<Instant> next_look() const {
    if (!began_ || looks_.size() == look_after_.size()) return std::nullopt;
    return *began_ + look_after_[looks_.size()];
  }
  void look_at_it() {
    inner_->report_truth(truth_);
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
    bench_schedule_.count_from(*began_);
    (void)bench_schedule_.begin(file_, *inner_);
  }

  BenchFile file_;
  std::vector<Duration> look_after_;
  Duration tick_{};
  bool armed_ = false, answers_waits_ = false;
  Instant reached_{};
  BenchSchedule bench_schedule_;
  std::optional<Instant> began_, ended_;
  MachineTruth truth_;
  std::vector<Look> looks_;
};

}  // namespace hw::test
