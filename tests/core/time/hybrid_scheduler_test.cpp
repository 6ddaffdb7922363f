#include "core/time/hybrid_scheduler.h"

#include <gtest/gtest.h>

namespace hw {
namespace {

using Turn = HybridScheduler::Turn;
constexpr auto never = [] { return false; };

TEST(HybridScheduler, VirtualTimeGoesFromAlarmToAlarm) {
  IoContext io{1};
  HybridScheduler time(io, false);
  std::vector<double> fired;
  Timer late(time, [&] { fired.push_back(seconds(time.now())); });
  Timer early(time, [&] { fired.push_back(seconds(time.now())); });
  late.arm(Instant(Millis(3'600'000)));
  early.arm(Instant(Millis(500)));
  EXPECT_EQ(time.run_until(Instant(Millis(7'200'000)), never), Turn::time);
  EXPECT_EQ(fired, (std::vector<double>{0.5, 3600}));
  EXPECT_EQ(time.now(), Instant(Millis(7'200'000)));
}

TEST(HybridScheduler, StopsWhereItIsDone) {
  IoContext io{1};
  HybridScheduler time(io, false);
  bool rung = false;
  Timer timer(time, [&] { rung = true; });
  timer.arm(Instant(Millis(100)));
  EXPECT_EQ(time.run_until(Instant::max(), [&] { return rung; }), Turn::done);
  EXPECT_EQ(time.now(), Instant(Millis(100)));
}

TEST(HybridScheduler, ReportsWhenNothingCanComeAnyMore) {
  IoContext io{1};
  HybridScheduler time(io, false);
  EXPECT_EQ(time.run_until(Instant::max(), never), Turn::stuck);
}

TEST(HybridScheduler, BecomesRealWithoutAJump) {
  IoContext io{1};
  HybridScheduler time(io, false);
  Timer timer(time, [&] { time.go_real(); });
  timer.arm(Instant(Millis(5000)));
  EXPECT_EQ(time.run_until(Instant(Millis(5020)), never), Turn::time);
  EXPECT_TRUE(time.is_real());
  EXPECT_GE(time.now(), Instant(Millis(5020)));
  EXPECT_LT(time.now(), Instant(Millis(65'000)));
}

TEST(HybridScheduler, RealTimeFiresAlarms) {
  IoContext io{1};
  HybridScheduler time(io, true);
  bool rung = false;
  Timer timer(time, [&] { rung = true; });
  timer.arm(time.now() + Millis(5));
  EXPECT_EQ(time.run_until(time.now() + Millis(60'000), [&] { return rung; }), Turn::done);
}

// A port that babbles has bytes ready whenever it is asked.
TEST(HybridScheduler, WorkWithoutEndHoldsBackNoAlarm) {
  IoContext io{1};
  HybridScheduler time(io, true);
  std::function<void()> babble = [&] { asio::post(io, babble); };
  babble();
  bool rung = false;
  Timer timer(time, [&] { rung = true; });
  timer.arm(time.now() + Millis(5));
  EXPECT_EQ(time.run_until(Instant::max(), [&] { return rung; }), Turn::done);
  EXPECT_EQ(time.run_until(time.now() + Millis(1), never), Turn::time);
}

}  // namespace
}  // namespace hw
