#include "tests/contract/nobody.h"

#include <array>

#include "transports/memory.h"

namespace hw {
namespace {

class Rubbish {
 public:
  explicit Rubbish(Habit habit) : habit_(habit) {}
  std::uint8_t answer_to(std::uint8_t byte) {
    if (habit_ == Habit::echo) return byte;
    if (habit_ == Habit::ones) return 0xFF;
    seed_ = seed_ * 1664525u + 1013904223u;
    return static_cast<std::uint8_t>(seed_ >> 24);
  }

 private:
  Habit habit_;
  std::uint32_t seed_ = 1;
};

/// Both ends: what the console sends is answered byte by byte.
class RubbishStream final : public Stream, private Stream::Listener {
 public:
  RubbishStream(Scheduler& scheduler, Habit habit) : rubbish_(habit) {
    auto ends = make_memory_pair(scheduler);
    near_ = std::move(ends.first);
    far_ = std::move(ends.second);
    far_->listen(this);
  }
  void listen(Stream::Listener* listener) override { near_->listen(listener); }
  void send(std::string_view bytes) override { near_->send(bytes); }
  void discard_unsent() override { near_->discard_unsent(); }
  Result<> set_rate(int baud) override { return near_->set_rate(baud); }
  int rate() const override { return near_->rate(); }
  std::string describe() const override { return "rubbish"; }

 private:
  void bytes_arrived(std::string_view bytes) override {
    std::string answer(bytes);
    for (char& c : answer) c = static_cast<char>(rubbish_.answer_to(static_cast<std::uint8_t>(c)));
    far_->send(answer);
  }
  void stream_closed(const Fault&) override {}

  Rubbish rubbish_;
  std::unique_ptr<Stream> near_, far_;
};

class RubbishWindow final : public Window {
 public:
  explicit RubbishWindow(Habit habit) : rubbish_(habit) {}
  void listen(Listener*) override {}
  Task<Result<>> run(std::span<BusCycle> cycles) override {
    for (BusCycle& c : cycles) {
      if (!c.write) c.value = 0;
      for (std::size_t i = 0; i < c.width; ++i) {
        std::uint8_t& cell = memory_[(c.offset + i) % memory_.size()];
        const unsigned shift = 8 * static_cast<unsigned>(c.width - 1 - i);
        if (c.write) cell = static_cast<std::uint8_t>(c.value >> shift);
        if (!c.write) c.value |= std::uint32_t{rubbish_.answer_to(cell)} << shift;
      }
    }
    co_return Result<>();
  }
  std::string describe() const override { return "rubbish"; }

 private:
  Rubbish rubbish_;
  std::array<std::uint8_t, 4096> memory_{};
};

}  // namespace

Wire wire_to_nobody(Scheduler& scheduler, Habit habit, bool window) {
  Wire wire;
  if (window)
    wire.window = std::make_unique<RubbishWindow>(habit);
  else
    wire.stream = std::make_unique<RubbishStream>(scheduler, habit);
  return wire;
}

}  // namespace hw
