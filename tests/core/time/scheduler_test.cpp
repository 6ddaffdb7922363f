#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/time/real_scheduler.h"
#include "core/time/virtual_scheduler.h"

namespace hw {
namespace {

using testing::ElementsAre;

struct SchedulerTest : testing::Test {
  IoContext io;
  VirtualScheduler time{io};
};

TEST_F(SchedulerTest, AlarmsFireInOrderOfTimeAndThenOfArming) {
  std::vector<int> fired;
  Timer late(time, [&] { fired.push_back(3); }), first(time, [&] { fired.push_back(1); }),
      second(time, [&] { fired.push_back(2); }), never(time, [&] { fired.push_back(9); });
  late.arm(Instant(Millis(20)));
  first.arm(Instant(Millis(10)));
  second.arm(Instant(Millis(10)));
  never.arm(Instant(Millis(5)));
  never.disarm();
  time.run_for(Millis(15));
  EXPECT_THAT(fired, ElementsAre(1, 2));
  time.run_for(Millis(15));
  EXPECT_THAT(fired, ElementsAre(1, 2, 3));
}

TEST_F(SchedulerTest, AThousandAlarmsStayInOrderThoughManyAreMoved) {
  std::vector<std::unique_ptr<Timer>> timers;
  std::vector<Instant> fired;
  for (int i = 0; i < 1000; ++i) {
    timers.push_back(std::make_unique<Timer>(time, [&] { fired.push_back(time.now()); }));
    timers.back()->arm(Instant(Millis((i * 7919) % 1000)));
  }
  for (int i = 0; i < 1000; i += 3) timers[i]->arm(Instant(Millis((i * 104729) % 1000)));
  for (int i = 1; i < 1000; i += 3) timers[i].reset();
  time.run_for(std::chrono::seconds(2));
  EXPECT_EQ(fired.size(), 667u);
  EXPECT_TRUE(std::is_sorted(fired.begin(), fired.end()));
}

TEST_F(SchedulerTest, ASleepTakesExactlyItsTime) {
  Instant woke{};
  const auto sleeper = [](Scheduler& s, Instant& at) -> Task<> {
    co_await s.sleep_for(Millis(1234));
    at = s.now();
  };
  asio::co_spawn(io, sleeper(time, woke), asio::detached);
  time.run_for(std::chrono::seconds(10));
  EXPECT_EQ(woke, Instant(Millis(1234)));
}

TEST_F(SchedulerTest, AnEventWakesAllWhoWaitAndReportsWhoWasTooLate) {
  Event event(time);
  std::vector<bool> came;
  const auto waiter = [](Event& e, Instant until, std::vector<bool>& out) -> Task<> {
    const bool notified = co_await e.wait_until(until);
    out.push_back(notified);
  };
  asio::co_spawn(io, waiter(event, Instant(Millis(10)), came), asio::detached);
  asio::co_spawn(io, waiter(event, Instant(Millis(100)), came), asio::detached);
  time.run_for(Millis(50));
  event.notify();
  event.notify();
  time.run_for(Millis(1));
  EXPECT_THAT(came, ElementsAre(false, true));
}

TEST_F(SchedulerTest, AnEventThatEndsWakesItsWaitersWhoDoNotTouchIt) {
  bool over = false;
  const auto waiter = [](Event& e, bool& done) -> Task<> {
    co_await e.wait();
    done = true;
  };
  {
    Event event(time);
    asio::co_spawn(io, waiter(event, over), asio::detached);
    time.run_for(Millis(1));
  }
  time.run_for(Millis(1));
  EXPECT_TRUE(over);
}

TEST(RealScheduler, FiresDueAlarmsAndForgetsDisarmedOnes) {
  IoContext io;
  RealScheduler time(io);
  std::vector<int> fired;
  Timer one(time, [&] { fired.push_back(1); }), two(time, [&] { fired.push_back(2); }),
      not_this(time, [&] { fired.push_back(9); });
  two.arm(time.now() + Millis(4));
  not_this.arm(time.now() + Millis(1));
  one.arm(time.now() + Millis(2));
  not_this.disarm();
  const Instant begin = time.now();
  while (fired.size() < 2 && time.now() - begin < std::chrono::seconds(5)) io.run_one_for(Millis(100));
  EXPECT_THAT(fired, ElementsAre(1, 2));
  EXPECT_GE(time.now() - begin, Millis(3));
}

}  // namespace
}  // namespace hw
