// An error state from before the connection: only K and res are heard.
#include "tests/core/devices/vxm/driver_fixture.h"

namespace hw::vxm {
namespace {

using testing::HasSubstr;

class VxmDriverRecovery : public DriverTest {
 protected:
  /// A controller in EM, of which this console has not heard.
  void open_one_in_error() {
    loop = std::make_unique<test::Loopback>(time, make_emulator({}).value(), false);
    loop->emulator().advance_to(time.now());
    std::string text = "F", report;
    for (int i = 0; i < 65; ++i) text += "I1M5,";
    loop->emulator().receive(text);
    loop->emulator().take_output(report);
    ASSERT_EQ(report, "EM");
    open();
  }
  bool connects() {
    return run_until([&] { return latest.link.state == LinkState::good; }, 2);
  }
};

TEST_F(VxmDriverRecovery, TheUsersKEndsItAndIsSentOnce) {
  open_one_in_error();
  EXPECT_EQ(latest.link.state, LinkState::lost);
  EXPECT_THAT(health(), HasSubstr("takes only K: send K."));
  EXPECT_THAT(query("X"), HasSubstr("fault: "));
  run(20);
  EXPECT_EQ(times_sent('K'), 0) << "never by itself";
  EXPECT_EQ(query("K"), "^");
  EXPECT_TRUE(connects());
  EXPECT_EQ(times_sent('K'), 1);
  EXPECT_EQ(query("M"), "0") << "the program stays (V34)";
  run(2);
  EXPECT_EQ(query("K"), "^") << "a later K is one of its own";
  EXPECT_EQ(times_sent('K'), 2);
}

TEST_F(VxmDriverRecovery, TheTerminalMaySendItToo) {
  open_one_in_error();
  EXPECT_EQ(send("K"), "");
  EXPECT_TRUE(connects());
  EXPECT_EQ(times_sent('K'), 1);
}

TEST_F(VxmDriverRecovery, InLocalModeItIsAnsweredToo) {
  loop = std::make_unique<test::Loopback>(time, make_emulator({}).value(), false);
  port_missing = true;
  open();
  port_missing = false;
  EXPECT_EQ(query("K"), "^");
  EXPECT_TRUE(connects());
  EXPECT_EQ(query("V"), "R");
}

TEST_F(VxmDriverRecovery, ResEndsItAndForgetsWhatWasNotStored) {
  open_one_in_error();
  EXPECT_EQ(query("res"), "");
  EXPECT_TRUE(connects());
  EXPECT_EQ(times_sent('K'), 0);
  EXPECT_EQ(query("M"), "256");
}

TEST_F(VxmDriverRecovery, WhereNothingIsKBringsNothingAndIsNotRepeated) {
  loop = std::make_unique<test::Loopback>(time, make_emulator({}).value(), false);
  ASSERT_TRUE(loop->operate(bench::Power(false)));
  open();
  EXPECT_THAT(query("K"), HasSubstr("K was sent, but nothing answered."));
  run(30);
  EXPECT_EQ(times_sent('K'), 2) << "once as it is, once behind the F that Local mode needs";
  port_missing = true;
  loop->pull();
  run(10);
  EXPECT_THAT(query("K"), HasSubstr("without a connection"));
  port_missing = false;
  run(30);
  EXPECT_EQ(times_sent('K'), 2) << "what was said to no wire is not said later";
}

}  // namespace
}  // namespace hw::vxm
