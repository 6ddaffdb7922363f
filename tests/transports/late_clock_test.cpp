// A served line on a machine whose timers fire late: what it costs must not be charged to the line.
#include <gtest/gtest.h>

#include "tests/transports/ear.h"
#include "tests/transports/toy_emulator.h"
#include "transports/serve.h"

namespace hw {
namespace {

using test::Ear;
using test::ToyEmulator;

// Virtual time in which each alarm fires a fixed time after it was due.
class LateScheduler final : public Scheduler {
 public:
  LateScheduler(IoContext& io, Duration late) : Scheduler(io), late_(late) {}
  [[nodiscard]] Instant now() const override { return now_; }

  bool run_until(Instant until, const std::function<bool()>& done) {
    for (;;) {
      settle();
      if (done()) return true;
      if (!has_alarms() || first_alarm() + late_ > until) break;
      now_ = std::max(now_, first_alarm() + late_);
      fire_due(now_);
    }
    now_ = std::max(now_, until);
    return false;
  }
  void run_for(Duration d) {
    run_until(now_ + d, [] { return false; });
  }

 private:
  void first_alarm_moved() override {}
  void settle() {
    io().restart();
    while (io().poll() > 0) {
    }
  }
  Duration late_;
  Instant now_{};
};

class LateClock : public ::testing::Test {
 protected:
  static constexpr Duration late = std::chrono::microseconds(300);

  void SetUp() override {
    HostOptions options;
    options.byte_times = true;
    auto made = EmulatorHost::make(clock, std::make_unique<ToyEmulator>(), std::move(options), {});
    ASSERT_TRUE(made);
    host = *made;
    stream = *host->plug_in();
  }
  // From the question to the last byte of the reply.
  Duration ask(Ear& ear, std::string_view question, std::size_t reply_size) {
    const std::size_t enough = ear.received.size() + reply_size;
    const Instant began = clock.now();
    stream->send(question);
    EXPECT_TRUE(clock.run_until(began + Millis(500), [&] { return ear.received.size() >= enough; }))
        << question;
    return clock.now() - began;
  }

  IoContext io{1};
  LateScheduler clock{io, late};
  std::shared_ptr<EmulatorHost> host;
  std::unique_ptr<Stream> stream;
};

TEST_F(LateClock, QuestionsInTurnTakeTheTimeOfTheirBytes) {
  Ear ear(*stream);
  ask(ear, "X", 9);
  Duration took{};
  for (int round = 0; round < 10; ++round) took += ask(ear, "X", 9) + ask(ear, "Y", 9) + ask(ear, "V", 1);
  EXPECT_NEAR(seconds(took) / 10, 22.9e-3, 22.9e-3 * 0.02);
  stream->listen(nullptr);
}

TEST_F(LateClock, DelaysOfTheKernelAreNotCounted) {
  Ear ear(*stream);
  ask(ear, "X", 9);
  const Instant began = clock.now();
  for (int round = 0; round < 10; ++round) {
    clock.run_for(std::chrono::microseconds(200));
    ask(ear, "X", 9);
  }
  EXPECT_NEAR(seconds(clock.now() - began), 10 * 10 * seconds(byte_time(9600)), 2e-3);
  stream->listen(nullptr);
}

TEST_F(LateClock, AHostThatTookItsTimeIsNotAnsweredTooSoon) {
  Ear ear(*stream);
  for (int round = 0; round < 10; ++round) {
    clock.run_for(Millis(10));
    EXPECT_GE(ask(ear, "V", 1), 2 * byte_time(9600)) << round;
  }
  stream->listen(nullptr);
}

}  // namespace
}  // namespace hw
