#pragma once
// An emulator whose answers may be on their way for a while: whoever derives from it says which.
#include <algorithm>
#include <deque>
#include <string>

#include "tests/core/device/emulator_around.h"

namespace hw::test {

class LateLine : public EmulatorAround {
 public:
  using EmulatorAround::EmulatorAround;

  void take_output(std::string& sink) override {
    for (; !on_its_way_.empty() && on_its_way_.front().at <= now_; on_its_way_.pop_front())
      sink += on_its_way_.front().bytes;
  }
  [[nodiscard]] std::optional<Instant> next_event() const override {
    auto next = inner_->next_event();
    if (!on_its_way_.empty()) next = next ? std::min(*next, on_its_way_.front().at) : on_its_way_.front().at;
    return next;
  }
  void advance_to(Instant now) override {
    now_ = now;
    inner_->advance_to(now);
  }

 protected:
  // Nothing overtakes on a line.
  void send(std::string bytes, Duration delay = {}) {
    const Instant at = std::max(now_ + delay, on_its_way_.empty() ? now_ : on_its_way_.back().at);
    if (!bytes.empty()) on_its_way_.push_back({at, std::move(bytes)});
  }

 private:
  struct Piece {
    Instant at;
    std::string bytes;
  };
  std::deque<Piece> on_its_way_;
  Instant now_{};
};

}  // namespace hw::test
