#include "tests/core/devices/vxm/driver_fixture.h"

namespace hw::vxm {
namespace {

using testing::HasSubstr;

class VxmDriverConnect : public DriverTest {};

TEST_F(VxmDriverConnect, GoesOnLineAndFindsOutWhatItIs) {
  start();
  EXPECT_EQ(latest.link.state, LinkState::good);
  EXPECT_EQ(latest.identity.firmware.view(), "1.30 (12-29-04)");
  EXPECT_EQ(latest.program.slot, 0);
  for (int slot = 0; slot < 5; ++slot) EXPECT_EQ(latest.slot_bytes_used[slot], 0);
  EXPECT_TRUE(latest.axes[0].position_known && latest.axes[1].position_known);
  EXPECT_TRUE(latest.axes[0].limits_known);
  EXPECT_EQ(latest.inputs, 255u);
  EXPECT_EQ(latest.analog[0], 512);
  EXPECT_TRUE(reported("It is on-line now: its jog buttons are off."));
  EXPECT_EQ(loop->to_controller.substr(0, 2), "VF");
  run(3);
  for (std::size_t i = 0; i < catalog.params.size(); ++i)
    EXPECT_EQ(latest.params[i].known, catalog.params[i].readable) << catalog.params[i].mnemonic;
}

TEST_F(VxmDriverConnect, EchoIsSwitchedOff) {
  loop = std::make_unique<test::Loopback>(time, make_emulator({}).value(), false);
  loop->emulator().advance_to(time.now());
  loop->emulator().receive("E");
  open();
  EXPECT_EQ(latest.link.state, LinkState::good);
  EXPECT_TRUE(reported("Echo was switched off."));
  EXPECT_EQ(query("X"), "+0000000");
}

TEST_F(VxmDriverConnect, ACommandLeftHalfSentDoesNotHideTheController) {
  loop = std::make_unique<test::Loopback>(time, make_emulator({}).value(), false);
  loop->emulator().advance_to(time.now());
  loop->emulator().receive("FI1M40");
  open();
  EXPECT_EQ(latest.link.state, LinkState::good);
  EXPECT_EQ(query("M"), "256") << "and it is not stored";
}

TEST_F(VxmDriverConnect, ARunningProgramIsShownAndLeftAlone) {
  loop = std::make_unique<test::Loopback>(time, make_emulator({}).value(), false);
  loop->emulator().advance_to(time.now());
  loop->emulator().receive("FI1M3000,I1M-3000,R");
  open();
  EXPECT_EQ(latest.link.state, LinkState::good);
  EXPECT_EQ(latest.program.run, RunState::running);
  EXPECT_TRUE(latest.program.owned);
  EXPECT_EQ(move_by(0, 10), "A program is running. Nothing was sent. Wait until it ends, or stop it.");
  EXPECT_TRUE(wait_idle());
  EXPECT_EQ(position(), 0);
  EXPECT_EQ(latest.identity.firmware.view(), "1.30 (12-29-04)") << "read once it could be";
  EXPECT_EQ(latest.slot_bytes_used[0], 8);
}

// getD0 is dropped while a program runs, so whether it knows $ shows by asking.
TEST_F(VxmDriverConnect, OutputsAreReadWhileAProgramHidesTheVersion) {
  loop = std::make_unique<test::Loopback>(time, make_emulator({}).value(), false);
  loop->emulator().advance_to(time.now());
  loop->emulator().receive("FI1M9000,R");
  open();
  run(2);
  EXPECT_EQ(latest.program.run, RunState::running);
  EXPECT_EQ(latest.outputs_known, 0x0Fu);
}

TEST_F(VxmDriverConnect, AnOldFirmwareWhoseProgramRunsIsNotLost) {
  loop = std::make_unique<test::Loopback>(time, make_emulator({{"quirk", "old-firmware"}}).value(), false);
  loop->emulator().advance_to(time.now());
  loop->emulator().receive("FI1M9000,R");
  open();
  run(2);
  EXPECT_EQ(latest.link.state, LinkState::good);
  EXPECT_EQ(latest.program.run, RunState::running);
  EXPECT_EQ(latest.outputs_known, 0u) << "nobody can tell";
  EXPECT_TRUE(wait_idle());
  EXPECT_EQ(latest.identity.firmware.view(), "1.19 (12-29-04)");
}

TEST_F(VxmDriverConnect, AHoldThatAnotherProgramLeftOnIsReleased) {
  loop = std::make_unique<test::Loopback>(time, make_emulator({}).value(), false);
  loop->emulator().advance_to(time.now());
  loop->emulator().receive("FH");
  open();
  EXPECT_EQ(move_by(0, 100), "");
  EXPECT_TRUE(wait_idle());
  EXPECT_EQ(position(), 100);
}

TEST_F(VxmDriverConnect, GModeDoesNotConfuseIt) {
  start();
  EXPECT_EQ(send("G"), "");
  EXPECT_EQ(move_by(0, 100), "");
  EXPECT_TRUE(wait_idle());
  EXPECT_EQ(position(), 100);
  EXPECT_EQ(latest.link.unparsed_bytes, 0u);
}

TEST_F(VxmDriverConnect, NothingThereIsReportedWithWhatToLookAt) {
  loop = std::make_unique<test::Loopback>(time, make_emulator({}).value(), false);
  ASSERT_TRUE(loop->operate(bench::Power(false)));
  open();
  EXPECT_EQ(latest.link.state, LinkState::lost);
  EXPECT_THAT(health(), HasSubstr("Nothing answers V, the VXM's status query"));
  EXPECT_THAT(health(), HasSubstr("Only V and a carriage return were sent."));
  EXPECT_THAT(health(), HasSubstr("9600, 19200 or 38400"));
}

TEST_F(VxmDriverConnect, AWrongBaudRateNamesTheOthers) {
  loop = std::make_unique<test::Loopback>(time, make_emulator({}).value(), true);
  loop->replace_by([](std::string_view) { return std::string("\x9C\xE6"); });
  open();
  EXPECT_EQ(health(),
            "The device that answers V is not a VXM: 9C E6 came back instead of R, B, J or b. Nothing more "
            "was sent. This looks like a wrong baud rate. Try 19200, 38400.");
}

TEST_F(VxmDriverConnect, AnotherDeviceIsNoVxm) {
  loop = std::make_unique<test::Loopback>(time, make_emulator({}).value(), false);
  loop->replace_by([](std::string_view) { return std::string("?V\r"); });
  open();
  EXPECT_EQ(health(),
            "The device that answers V is not a VXM: 3F 56 0D came back instead of R, B, J or b. Nothing "
            "more was sent. Another device is on this port. Choose its model, or another port.");
}

TEST_F(VxmDriverConnect, AMissingPortIsNamed) {
  loop = std::make_unique<test::Loopback>(time, make_emulator({}).value(), false);
  port_missing = true;
  open();
  EXPECT_EQ(health(), "There is no port /dev/ttyUSB0.");
}

TEST_F(VxmDriverConnect, APulledCableIsReportedAndNothingIsSentAgain) {
  start();
  ASSERT_EQ(perform(intent::LoadProgram(0, "I1M5\n")), "");
  ASSERT_EQ(move_to(0, 4000), "");
  run(1);
  port_missing = true;
  loop->pull();
  run(0.1);
  EXPECT_EQ(latest.link.state, LinkState::lost);
  EXPECT_FALSE(latest.axes[0].position_known);
  EXPECT_EQ(latest.axes[0].ended_by, EndedBy::lost);
  run(5);
  port_missing = false;
  loop->to_controller.clear();
  EXPECT_TRUE(run_until([&] { return latest.link.state == LinkState::good; }, 10));
  run(1);
  EXPECT_EQ(position(), 4000) << "it went on by itself";
  EXPECT_EQ(loop->to_controller.find('R'), std::string::npos) << "nothing was run again";
  EXPECT_TRUE(
      reported("while the controller was busy. It has finished meanwhile; motor 1 stands at 4000 steps"))
      << all_notices();
  EXPECT_EQ(query("M"), "252") << "the user's program is there and selected";
  EXPECT_EQ(query("PM4,M"), "256") << "and nothing is left for the Run button";
}

TEST_F(VxmDriverConnect, ACableThatComesBackDuringTheMoveFollowsIt) {
  start();
  ASSERT_EQ(move_to(0, 8000), "");
  run(0.5);
  loop->pull();
  run(1);
  EXPECT_EQ(latest.link.state, LinkState::good);
  EXPECT_TRUE(reported("It is still busy; motor 1 moves, and is at "));
  EXPECT_TRUE(wait_idle());
  EXPECT_EQ(position(), 8000);
}

TEST_F(VxmDriverConnect, APowerCycleIsNoticedAndReported) {
  start();
  move_to(0, 1500);
  wait_idle();
  ASSERT_EQ(perform(intent::LoadProgram(2, "I1M400\n")), "");
  EXPECT_TRUE(latest.unsaved_programs);
  ASSERT_TRUE(loop->operate(bench::PowerCycle()));
  run(1);
  EXPECT_EQ(latest.link.state, LinkState::good);
  EXPECT_EQ(position(), 0);
  EXPECT_TRUE(latest.axes[0].trust.doubtful());
  EXPECT_EQ(latest.restarts, 1u);
  EXPECT_TRUE(reported(
      "The controller has gone to Local mode: the controller was switched off and on, or reset. Its "
      "positions read zero where the motors are now, and unstored settings and programs are lost. Home "
      "the axes "
      "before the next absolute move."))
      << all_notices();
  EXPECT_FALSE(latest.unsaved_programs);
  EXPECT_EQ(latest.slot_bytes_used[2], 0);
  EXPECT_EQ(query("V"), "R");
}

TEST_F(VxmDriverConnect, APowerCycleInMotionDoesNotTakeTheMotionUpAgain) {
  start();
  ASSERT_EQ(move_to(0, 30000), "");
  run(2);
  loop->to_controller.clear();
  ASSERT_TRUE(loop->operate(bench::PowerCycle()));
  run(2);
  EXPECT_TRUE(reported("The motion that was under way was not resumed."));
  EXPECT_FALSE(latest.any_axis_moving());
  EXPECT_EQ(loop->to_controller.find("RX"), std::string::npos);
  EXPECT_EQ(position(), 0);
  EXPECT_EQ(move_by(0, 10), "");
  EXPECT_TRUE(wait_idle());
  EXPECT_EQ(position(), 10);
}

// The wire carries nothing any more, and nobody has noticed.
TEST_F(VxmDriverConnect, AStopInItsWordsThatTheWireHasSwallowedIsMadeGood) {
  for (const char* stop : {"D", "K"}) {
    for (const double later : {0.01, 0.1, 0.4, 0.6, 0.8, 1.0, 1.3, 2.0}) {
      start();
      ASSERT_EQ(move_to(0, 40000), "");
      run(2);
      loop->silence(true);
      run(later);
      post(intent::SendText(stop));
      run(3);
      loop->silence(false);
      ASSERT_TRUE(run_until([&] { return latest.link.state == LinkState::good; }, 10));
      run(5);
      const auto here = position();
      run(1);
      EXPECT_EQ(position(), here) << stop << later;
      EXPECT_LT(here, 40000) << stop << later;
      EXPECT_EQ(query("PM4,lst,PM0,"), "PM4 M256") << stop << later;
      TearDown();
    }
  }
}

TEST_F(VxmDriverConnect, ASlaveThatLosesItsPowerRestartsItsMasterOnce) {
  start({{"motors", "4"}});
  EXPECT_TRUE(latest.axes[2].position_known);
  constexpr int slave = 1;
  ASSERT_TRUE(loop->operate(bench::Power(false, slave)));
  run(10);
  const std::string reported_all = all_notices();
  int restarts = 0;
  for (auto at = reported_all.find("reports EB"); at != std::string::npos;
       at = reported_all.find("reports EB", at + 1))
    ++restarts;
  EXPECT_EQ(restarts, 1) << reported_all;
  EXPECT_TRUE(reported("motors 3 and 4 cannot be used"));
  EXPECT_FALSE(latest.axes[2].position_known);
  EXPECT_EQ(move_by(0, 10), "");
  EXPECT_TRUE(wait_idle());
  EXPECT_EQ(position(), 10) << "motors 1 and 2 go on";
}

// H would switch a hold off as well as on, and K costs steps.
TEST_F(VxmDriverConnect, APendingStopIsDUntilTheStateIsKnown) {
  start();
  ASSERT_EQ(perform(intent::LoadProgram(0, "I1M90000\nI1M-90000\nL0\n")), "");
  ASSERT_EQ(perform(intent::RunProgram(0)), "");
  run(3);
  loop->silence(true);
  ASSERT_TRUE(run_until([&] { return latest.link.state == LinkState::lost; }, 5));
  loop->to_controller.clear();
  post(intent::Stop());
  run(2);
  EXPECT_THAT(loop->to_controller, testing::MatchesRegex("D[DV\r]+"));
  EXPECT_GE(times_sent('D'), 4) << "as long as nothing comes back";
  loop->silence(false);
  EXPECT_TRUE(wait_idle(5));
  EXPECT_EQ(times_sent('K'), 1);
  EXPECT_EQ(latest.program.run, RunState::idle);
  EXPECT_FALSE(latest.axes[0].trust.doubtful());
  const auto here = position();
  run(3);
  EXPECT_EQ(position(), here);
}

TEST_F(VxmDriverConnect, PowerOffIsALostLinkUntilItIsBack) {
  start();
  ASSERT_TRUE(loop->operate(bench::Power(false)));
  EXPECT_TRUE(run_until([&] { return latest.link.state == LinkState::lost; }, 5));
  run(4);
  EXPECT_THAT(health(), testing::AnyOf(HasSubstr("did not answer"), HasSubstr("Nothing answers")));
  ASSERT_TRUE(loop->operate(bench::Power(true)));
  EXPECT_TRUE(run_until([&] { return latest.link.state == LinkState::good; }, 15));
  EXPECT_TRUE(reported("It answers from Local mode: the controller was switched off and on, or reset."))
      << all_notices();
}

TEST_F(VxmDriverConnect, APowerCycleAfterAnErrorIsNoticed) {
  start();
  query("PM1,JM2,PM2,JM3,PM3,JM4,PM4,JM0,PM0,JM1,R", 1);
  run(1);
  ASSERT_EQ(latest.program.run, RunState::error);
  EXPECT_EQ(latest.inputs_known, 0u) << "nobody tells them now";
  run(30);
  EXPECT_EQ(latest.link.state, LinkState::good) << "it hears K only: silence is no fault of the link";
  ASSERT_TRUE(loop->operate(bench::PowerCycle()));
  run(5);
  EXPECT_TRUE(reported("the controller was switched off and on, or reset.")) << all_notices();
  EXPECT_NE(latest.program.run, RunState::error);
  EXPECT_EQ(latest.axes[0].trust.cause, Doubt::restarted);
  EXPECT_EQ(perform(intent::TrustPosition(AxisId{0})), "");
  EXPECT_EQ(move_to(0, 100), "");
}

TEST_F(VxmDriverConnect, GarbledAndDroppedBytesCostOneQuestionNotAMotion) {
  start({}, true);
  ASSERT_EQ(move_to(0, 16000), "");
  for (int i = 0; i < 10; ++i) {
    run(0.7);
    i % 2 ? loop->garble(1) : loop->drop(1);
  }
  EXPECT_TRUE(wait_idle());
  EXPECT_EQ(latest.link.state, LinkState::good);
  EXPECT_EQ(position(), 16000);
  const auto& bytes = loop->to_controller;
  EXPECT_EQ(bytes.find("IA1M16000\r"), bytes.rfind("IA1M16000\r")) << "the move was sent once";
}

TEST_F(VxmDriverConnect, ALostPromptDoesNotLeaveAMoveOpen) {
  start();
  ASSERT_EQ(move_to(0, 400), "");
  run(0.2);
  while (latest.any_axis_moving() && position() < 398) run(0.001);
  loop->drop(1);
  EXPECT_TRUE(wait_idle());
  EXPECT_EQ(position(), 400);
  EXPECT_EQ(latest.link.state, LinkState::good);
}

TEST_F(VxmDriverConnect, ASlaveThatIsMissingIsReportedAndNothingIsSentToIt) {
  loop = std::make_unique<test::Loopback>(time, make_emulator({}).value(), false);
  catalog_options = {{"motors", "4"}};
  open();
  EXPECT_EQ(latest.link.state, LinkState::good);
  EXPECT_TRUE(reported("motors 3 and 4 cannot be used"));
  EXPECT_EQ(move_by(2, 100),
            "Motor 3 belongs to a second controller, and none answers on the VXM bus. Nothing was sent. "
            "Check the Slave's "
            "power and cable, then reconnect.");
  EXPECT_EQ(perform(intent::SetParam("j3M", 100)),
            "j3M needs a second controller, and none answers on the VXM bus. Nothing was sent. Check the "
            "Slave's power and "
            "cable, then reconnect.");
  EXPECT_EQ(query("V"), "R");
}

TEST_F(VxmDriverConnect, PollsFiveTimesASecondAtRestAndAsTheWireBearsInMotion) {
  start({}, true);
  run(5);
  loop->to_controller.clear();
  run(2);
  const auto count = [&](char c) {
    return std::count(loop->to_controller.begin(), loop->to_controller.end(), c);
  };
  EXPECT_GE(count('V'), 8);
  EXPECT_LE(count('V'), 11);
  ASSERT_EQ(move_to(0, 20000), "");
  run(1);
  loop->to_controller.clear();
  run(2);
  EXPECT_GE(count('X'), 83) << "43 rounds a second is all that 9600 baud can carry";
}

TEST_F(VxmDriverConnect, ASlaveThatTheAddressLeavesOutIsReported) {
  loop = std::make_unique<test::Loopback>(time, make_emulator({{"motors", "4"}}).value(), false);
  open();
  ASSERT_EQ(latest.axis_count, 2);
  EXPECT_TRUE(reported("Open it with motors=4 in its address"));
  for (const char* motor : {"M1M", "M2M"}) EXPECT_EQ(perform(intent::SetParam(motor, 4, true)), "");
  run(1);
  EXPECT_THAT(std::string(latest.notice.view()), HasSubstr("its motors 3 and 4 are not shown"));
}

}  // namespace
}  // namespace hw::vxm
