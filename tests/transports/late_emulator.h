#pragma once
// A controller whose replies can come late, in their order.
#include <algorithm>
#include <deque>

#include "tests/core/device/emulator_around.h"

namespace hw::test {

class LateEmulator final : public EmulatorAround {
 public:
  using EmulatorAround::EmulatorAround;

  /// The next replies come so much later.
  void be_late(int replies, Duration delay) { late_replies_ = replies, delay_ = delay; }
  [[nodiscard]] bool was_late() const { return late_replies_ == 0 && held_.empty(); }

  /// The wire swallows what is said to it.
  void be_deaf(bool deaf) { deaf_ = deaf; }

  void receive(std::string_view bytes) override {
    if (!deaf_) inner_->receive(bytes);
  }
  void take_output(std::string& sink) override {
    std::string fresh;
    inner_->take_output(fresh);
    if (!fresh.empty()) {
      const bool late = late_replies_ > 0;
      if (late) --late_replies_;
      const Instant due = late ? now_ + delay_ : now_;
      held_.push_back({held_.empty() ? due : std::max(due, held_.back().due), std::move(fresh)});
    }
    for (; !held_.empty() && held_.front().due <= now_; held_.pop_front()) sink += held_.front().text;
  }
  [[nodiscard]] std::optional<Instant> next_event() const override {
    const auto next = inner_->next_event();
    if (held_.empty()) return next;
    return std::min(next.value_or(held_.front().due), held_.front().due);
  }
  void advance_to(Instant now) override {
    now_ = now;
    inner_->advance_to(now);
  }

 private:
  struct Held {
    Instant due;
    std::string text;
  };
  std::deque<Held> held_;
  Instant now_{};
  bool deaf_ = false;
  int late_replies_ = 0;
  Duration delay_{};
};

}  // namespace hw::test
