// A stop in the middle of whatever the console does, against a VXM that a byte sent into its answer locks
// until power-off: nothing hangs, nothing is left behind, and the next command is carried out.
#include "tests/core/devices/vxm/driver_fixture.h"

namespace hw::vxm {
namespace {

class VxmStopAnywhere : public DriverTest {
 protected:
  void SetUp() override {
    start({{"quirk", "overrun"}}, true);
    ASSERT_EQ(perform(intent::LoadProgram(1, "I1M400\nI1M-400\nL5\n")), "");
    ASSERT_EQ(perform(intent::SelectProgram(1)), "");
    ASSERT_EQ(perform(intent::SetParam("M1M", 4, true)), "");
  }
  /// Of the intent, at each of so many moments.
  void stop_at_each(const IntentBody& body, int moments = 40, double apart = 0.004) {
    for (int i = 0; i < moments && !HasFailure(); ++i) {
      SCOPED_TRACE(i);
      const IntentId id = post(body);
      run(i * apart);
      EXPECT_EQ(perform(intent::Stop(), 10), "");
      EXPECT_NE(outcome(id), IntentState::pending);
      EXPECT_TRUE(wait_idle(10));
      EXPECT_EQ(latest.link.state, LinkState::good);
      EXPECT_EQ(query("V"), "R");
      EXPECT_EQ(query("PM"), "1") << "the user's choice";
      EXPECT_EQ(query("PM4,lst,PM1,"), "PM4 M256") << "where the console's own moves are";
      const auto here = position();
      EXPECT_EQ(move_by(0, 20, 800), "");
      EXPECT_TRUE(wait_idle(10));
      EXPECT_EQ(position(), here + 20);
    }
    EXPECT_FALSE(latest.axes[0].trust.doubtful());
  }
};

TEST_F(VxmStopAnywhere, OfAMove) { stop_at_each(intent::MoveBy(target(0, 300), Pps{3000})); }
TEST_F(VxmStopAnywhere, OfMovesOneAfterTheOther) {
  std::vector<AxisTarget> both = target(0, 100);
  both.push_back(target_of(1, 100));
  stop_at_each(intent::MoveBy(both), 60, 0.017);
}
TEST_F(VxmStopAnywhere, OfHoming) {
  AxisPlace slide;
  slide.minus = Steps(-300);
  loop->operate(bench::Place(AxisId{0}, slide));
  stop_at_each(intent::Home(AxisId{0}, Sign::minus, 2), 40, 0.03);
}
TEST_F(VxmStopAnywhere, OfAJog) { stop_at_each(intent::JogStart(AxisId{0}, Sign::plus, Pps{}, false)); }
TEST_F(VxmStopAnywhere, OfARun) { stop_at_each(intent::RunProgram(1), 60, 0.013); }
TEST_F(VxmStopAnywhere, OfASingleStep) { stop_at_each(intent::SingleStep()); }
TEST_F(VxmStopAnywhere, OfWhatIsOverAtOnce) {
  stop_at_each(intent::SetOutput(1, true), 30);
  stop_at_each(intent::SetPosition(0), 30);
  stop_at_each(intent::SetPosition(-1), 20);
}
TEST_F(VxmStopAnywhere, OfProgramsOnTheirWay) {
  std::string text;
  for (int i = 0; i < 20; ++i) text += "I1M400\n";
  stop_at_each(intent::LoadProgram(3, text), 50, 0.006);
  stop_at_each(intent::UploadProgram(3), 30, 0.01);
  stop_at_each(intent::ClearProgram(3), 30);
}
TEST_F(VxmStopAnywhere, OfSetUp) {
  stop_at_each(intent::SetParam("M2M", 3, true), 30);
  stop_at_each(intent::ReadParams(), 30, 0.02);
  stop_at_each(intent::ReadAgain(), 40, 0.02);
  stop_at_each(intent::SetParam("B", 9, true), 40, 0.003);
}
TEST_F(VxmStopAnywhere, OfTexts) {
  stop_at_each(intent::SendText("X,lst,M,getM1M"), 30, 0.006);
  stop_at_each(intent::SendText("R"), 40, 0.02);
}

}  // namespace
}  // namespace hw::vxm
