// A stored program of the user's that moves an axis fast and long, and how it is stopped.
#include <map>

#include "tests/contract/truth.h"

namespace hw {
namespace {

using std::chrono::seconds;

/// Ways of the first axis at 4,800 steps/s, from which a motor overshoots when it is stopped dead. In the
/// language of the model; the programs of each have nothing else in common.
struct LongWay {
  int slot;
  const char *begin, *there, *back, *end;
};
const std::map<std::string_view, LongWay> long_ways = {
    {"vxm", {1, "PM-1\nS1M4800\nA1M2\n", "I1M100000\n", "I1M-100000\n", ""}},
    {"pmx-4ex-sa",
     {0, "HSPD=4800\nLSPD=400\nACC=300\nEO=15\nABS\n", "X100000\nWAITX\n", "X0\nWAITX\n", "END\n"}},
    {"dmx-k-sa",
     {0, "HSPD=4800\nLSPD=400\nACC=300\nEO=1\nABS\n", "X100000\nWAITX\n", "X0\nWAITX\n", "END\n"}},
    {"vme58", {0, "AX VL4800; AC10000;\n", "MR100000; GO ID\n", "MR-100000; GO ID\n", ""}},
};

class ProgramStopTest : public TruthTest {
 protected:
  void SetUp() override {
    TruthTest::SetUp();
    const auto way = long_ways.find(GetParam()->model);
    if (way == long_ways.end()) GTEST_SKIP() << "write a long way in its language, if it has programs";
    way_ = way->second;
  }
  void start(bool comes_back) {
    must(intent::LoadProgram(
        way_.slot, fmt::format("{}{}{}{}", way_.begin, way_.there, comes_back ? way_.back : "", way_.end)));
    must(intent::RunProgram(way_.slot));
    run(seconds(3));
    const Steps from = load();
    run(seconds(1));
    const double speed = static_cast<double>((load() - from).value);
    ASSERT_NEAR(speed, 4800, 1000);
    began_at_ = load();
  }
  /// It has ramped down, has come to rest there, and counts where it stands.
  void expect_ramped() {
    ASSERT_TRUE(becomes_idle(seconds(30)));
    const Steps there = load();
    EXPECT_GT(there, began_at_ + Steps(100)) << "a ramp takes its way";
    run(seconds(5));
    EXPECT_EQ(load(), there);
    EXPECT_EQ(ended_by(), EndedBy::stop);
    EXPECT_EQ(axis().trust.kind, Trust::counted) << static_cast<int>(axis().trust.cause);
    EXPECT_EQ(now().program.run, RunState::idle);
  }
  /// Some tell it of the motion, some of the program.
  [[nodiscard]] EndedBy ended_by() const {
    return axis().ended_by == EndedBy::nothing ? now().program.ended_by : axis().ended_by;
  }

 private:
  LongWay way_{};
  Steps began_at_;
};
INSTANTIATE_TEST_SUITE_P(Every, ProgramStopTest, testing::ValuesIn(types_under_test()), name_of_type);

TEST_P(ProgramStopTest, AStopOfAllEndsItWithItsRamp) {
  start(true);
  session->send(intent::Stop());
  expect_ramped();
}

TEST_P(ProgramStopTest, AStopOnItsLastWayIsNoEndOfItsOwn) {
  start(false);
  session->send(intent::Stop());
  expect_ramped();
}

TEST_P(ProgramStopTest, TheFirstStopOfAllBehindOneOfAnAxisIsNoSecondOne) {
  start(true);
  session->send(intent::Stop(0));
  run(Millis(100));
  session->send(intent::Stop());
  expect_ramped();
}

TEST_P(ProgramStopTest, TheSameStopAskedAgainIsAtOnce) {
  start(true);
  session->send(intent::Stop());
  run(Millis(100));
  session->send(intent::Stop());
  const Steps asked_at = load();
  ASSERT_TRUE(becomes_idle(seconds(30)));
  EXPECT_LT(load(), asked_at + Steps(400)) << "it does not ramp on";
  EXPECT_EQ(ended_by(), EndedBy::abort);
}

TEST_P(ProgramStopTest, AHaltedProgramDoesNotGoOn) {
  start(true);
  must(intent::HaltProgram());
  EXPECT_TRUE(run_until([&] { return now().program.run == RunState::idle; }, seconds(5)));
  ASSERT_TRUE(becomes_idle(seconds(120))) << "some let the motion under way come to its end";
  const Steps there = load();
  run(seconds(5));
  EXPECT_EQ(load(), there) << "the way back is not begun";
}

TEST_P(ProgramStopTest, APausedProgramBeginsNoMotionUntilItIsResumed) {
  start(true);
  if (perform(intent::Pause()).state == IntentState::refused) GTEST_SKIP() << "it cannot be held";
  ASSERT_TRUE(run_until([&] { return !now().any_axis_moving(); }, seconds(120)));
  const Steps there = load();
  run(seconds(5));
  EXPECT_EQ(load(), there) << "the way back is not begun";
  EXPECT_EQ(now().program.run, RunState::held);
  must(intent::Resume());
  EXPECT_TRUE(run_until([&] { return load() < there; }, seconds(5)));
  session->send(intent::Stop());
  ASSERT_TRUE(becomes_idle(seconds(30)));
}

}  // namespace
}  // namespace hw
