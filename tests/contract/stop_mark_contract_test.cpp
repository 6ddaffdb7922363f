// The mark in the travel bar, "where it would stop now", on every controller: an axis that is stopped there
// and then comes to rest at it.
#include <cmath>

#include "tests/contract/rig.h"

namespace hw {
namespace {

using std::chrono::seconds;

class StopMarkContract : public ContractTest {
 protected:
  void SetUp() override {
    ContractTest::SetUp();
    if (session->catalog().axes[0].switchable) perform(intent::SetPower(0, true));
    run(seconds(1));
  }
  [[nodiscard]] std::optional<double> way() const {
    return session->catalog().stopping_way(session->catalog(), now(), AxisId{0});
  }
  /// Stops it, and compares where it comes to rest with where it was to.
  void stop_and_compare(double speed) {
    const auto left = way();
    ASSERT_TRUE(left) << "its ramp is known";
    const double since = seconds_of(time.now() - axis().seen_at) * speed;
    const double expected = axis().commanded().value + axis().direction * (*left + since);
    perform(intent::Stop());
    ASSERT_TRUE(becomes_idle(seconds(20)));
    run(seconds(1));
    // What passes between the press and the first byte's effect.
    EXPECT_NEAR(axis().commanded().value, expected, speed * 0.12 + 5);
    EXPECT_FALSE(way()) << "nothing moves any more";
  }
  static double seconds_of(Duration d) { return std::chrono::duration<double>(d).count(); }
};

INSTANTIATE_TEST_SUITE_P(Every, StopMarkContract, testing::ValuesIn(types_under_test()), name_of_type);

TEST_P(StopMarkContract, AMoveThatIsStoppedComesToRestThere) {
  constexpr double speed = 1000;
  EXPECT_FALSE(way());
  ASSERT_EQ(perform(intent::MoveTo({{AxisId{0}, Steps(20'000)}}, Pps(speed))).state, IntentState::done);
  run(seconds(2));
  ASSERT_TRUE(now().any_axis_moving());
  stop_and_compare(speed);
}

TEST_P(StopMarkContract, AHeldJogToo) {
  constexpr double speed = 800;
  const AxisId axis{0};
  ASSERT_EQ(perform(intent::JogStart(axis, Sign::minus, Pps(speed))).state, IntentState::done);
  for (int i = 0; i < 20; ++i) session->send(intent::JogKeepAlive()), run(Millis(100));
  ASSERT_TRUE(now().any_axis_moving());
  stop_and_compare(speed);
}

TEST_P(StopMarkContract, NearItsEndItIsTheTarget) {
  ASSERT_EQ(perform(intent::MoveTo({{AxisId{0}, Steps(4000)}}, Pps(2000))).state, IntentState::done);
  std::int64_t furthest = 0;
  ASSERT_TRUE(run_until(
      [&] {
        if (const auto left = way())
          furthest = std::max<std::int64_t>(furthest, axis().commanded().value + std::llround(*left));
        return axis().commanded().value == 4000;
      },
      seconds(20)));
  EXPECT_LE(furthest, 4000 + 40) << "the mark does not run past the target";
}

}  // namespace
}  // namespace hw
