// What the driver sends and shows, with an emulated PMX or DMX at the other end.
#include <set>

#include "tests/core/devices/arcus/driver_fixture.h"

namespace hw::arcus {
namespace {

using testing::HasSubstr;

constexpr std::string_view pmx = "pmx-4ex-sa", dmx = "dmx-k-sa";

// ---- connecting

TEST_F(DriverTest, FindsThePmxAndMovesNothing) {
  start(pmx);
  EXPECT_EQ(latest.link.state, LinkState::good) << latest.link.sentence.view();
  EXPECT_EQ(latest.identity.firmware.view(), "V161BL");
  EXPECT_EQ(latest.identity.serial.view(), "4EX00");
  for (int i = 0; i < 4; ++i) EXPECT_EQ(latest.axes[i].activity, Activity::idle);
  EXPECT_TRUE(latest.axes[0].limits_known);
  EXPECT_FALSE(latest.axes[0].in_counts);
}

TEST_F(DriverTest, FindsTheDmxWithItsClosedLoop) {
  start(dmx);
  EXPECT_EQ(latest.identity.firmware.view(), "V340BL");
  EXPECT_TRUE(latest.axes[0].in_counts) << "StepNLoop is on from the factory";
  run(2);
  EXPECT_EQ(readout("SLS"), 0);
  EXPECT_EQ(param("SLR"), 800);
}

TEST_F(DriverTest, AWrongAddressNamesTheLikelyCauses) {
  start(dmx, {{"id", "07"}});
  EXPECT_EQ(latest.link.state, LinkState::lost);
  const std::string why(latest.link.sentence.view());
  EXPECT_THAT(why, HasSubstr("No DMX-K-SA answers at address 01"));
  EXPECT_THAT(why, HasSubstr("12 to 35 V"));
  EXPECT_THAT(why, HasSubstr("crossed"));
  EXPECT_THAT(why, HasSubstr("device name"));
}

std::string named_as_a_pmx(std::string_view byte) {
  return byte == "\r" ? std::string("Performax-4EX-SA\r") : std::string();
}

TEST_F(DriverTest, TheOtherModelIsNamed) {
  type = find_device_type(dmx);
  loop = std::make_unique<test::Loopback>(time, type->make_emulator({}).value(), false);
  catalog = type->make_catalog({}).value();
  loop->replace_by(named_as_a_pmx);
  open();
  EXPECT_THAT(std::string(latest.link.sentence.view()), HasSubstr("is a Performax-4EX-SA, not a DMX-K-SA"));
}

std::string echo(std::string_view byte) { return std::string(byte); }

TEST_F(DriverTest, AnAdapterThatEchoesIsNamed) {
  type = find_device_type(dmx);
  loop = std::make_unique<test::Loopback>(time, type->make_emulator({}).value(), false);
  catalog = type->make_catalog({}).value();
  loop->replace_by(echo);
  open();
  EXPECT_THAT(std::string(latest.link.sentence.view()), HasSubstr("echo of the RS-485 adapter"));
}

std::string two_voices(std::string_view byte) {
  return byte == "\r" ? std::string("V340BL\0V340BL\0", 14) : std::string();
}

TEST_F(DriverTest, TwoDevicesWithOneAddressAreNoticed) {
  type = find_device_type(dmx);
  loop = std::make_unique<test::Loopback>(time, type->make_emulator({}).value(), false);
  catalog = type->make_catalog({}).value();
  loop->replace_by(two_voices);
  open();
  EXPECT_THAT(std::string(latest.link.sentence.view()),
              HasSubstr("More than one device answers at address 01"));
}

// The terminal explains every line, those of the console itself first of all.
TEST_F(DriverTest, TheHelpKnowsEveryCommandThatTheDriverSends) {
  for (const std::string_view model : {pmx, dmx}) {
    start(model);
    perform(intent::Watch(~0u));
    perform(intent::ReadParams());
    perform(intent::MoveTo(targets({200})));
    ASSERT_TRUE(wait_idle());
    perform(intent::LoadProgram(0, "DELAY=100\nEND\n"));
    perform(intent::RunProgram(0));
    run(20);
    perform(intent::Stop());
    TearDown();
    std::set<std::string> unknown;
    traffic.drain([&](const TrafficEntry& e) {
      if (e.way != Way::sent) return;
      const std::string words = type->explain(e.bytes, e.way, e.kind, {});
      if (words.find("not a command of the manual") != words.npos) unknown.insert(e.bytes);
    });
    EXPECT_THAT(unknown, testing::IsEmpty()) << model;
    latest = Snapshot();
  }
}

// What a person did stands in the terminal; what the console asks about it is folded, whenever it does.
TEST_F(DriverTest, OnlyCommandsStandBesideThePolls) {
  start(pmx);
  run(40);  // the joystick is known to be off
  EXPECT_EQ(sent(), "");
  perform(intent::MoveTo(targets({50000})));
  run(1);
  perform(intent::Stop());
  perform(intent::SetParam("SLTX", 25));
  EXPECT_EQ(sent(), "X50000 STOP SR0=0 SR1=0 SR2=0 SR3=0 STOP SLTX=25");
}

TEST_F(DriverTest, ASilentDeviceThatATextAddressedIsNamed) {
  start(dmx);
  EXPECT_EQ(query("@44PX=0"), "fault: Device 44 did not answer PX=0 in time.");
}

TEST_F(DriverTest, ARefusalOfATextThatLooksCutOffIsItsAnswer) {
  start(pmx);
  EXPECT_EQ(query("HS~"), "?HS~");
}

// ---- power cycles

class Restart : public DriverTest {
 protected:
  void power_cycle() {
    ASSERT_TRUE(loop->operate(bench::PowerCycle()));
    run(40);
  }
  bool reports_switched_off() { return reported("switched off and on"); }
};

TEST_F(Restart, PositionsThatReadZeroShowIt) {
  start(dmx);
  perform(intent::MoveTo(targets({500})));
  ASSERT_TRUE(wait_idle());
  power_cycle();
  EXPECT_TRUE(reports_switched_off()) << all_notices();
  EXPECT_TRUE(latest.axes[0].trust.doubtful());
  EXPECT_EQ(latest.restarts, 1u);
}

TEST_F(Restart, InTheMiddleOfAMoveItIsNoArrival) {
  start(pmx);
  perform(intent::MoveTo(targets({50000})));
  run(5);
  power_cycle();
  EXPECT_TRUE(reports_switched_off());
  EXPECT_EQ(latest.axes[0].ended_by, EndedBy::lost);
}

class OwnSpeed : public DriverTest {
 protected:
  double jogs_at(int axis) {
    post(intent::JogStart(AxisId{static_cast<std::uint8_t>(axis)}, Sign::plus, Pps{}, false));
    run(3);
    const double speed = latest.axes[static_cast<std::size_t>(axis)].speed.value;
    perform(intent::Stop());
    run(3);
    return speed;
  }
};

TEST_F(OwnSpeed, IsTheCommonOneUnlessAnAxisHasAllThree) {
  start(pmx);
  run(40);
  EXPECT_EQ(latest.axes[3].own_speed, Pps(1000)) << "after power-up";
  ASSERT_EQ(perform(intent::SetParam("HS", 3000)), "");
  ASSERT_EQ(perform(intent::SetParam("HSY", 700)), "");
  run(2);
  EXPECT_EQ(latest.axes[1].own_speed, Pps(3000)) << "low speed and acceleration of Y are 0";
  EXPECT_NEAR(jogs_at(1), 3000, 1);
  ASSERT_EQ(perform(intent::SetParam("LSY", 100)), "");
  ASSERT_EQ(perform(intent::SetParam("ACCY", 300)), "");
  run(2);
  EXPECT_EQ(latest.axes[0].own_speed, Pps(3000));
  EXPECT_EQ(latest.axes[1].own_speed, Pps(700));
  EXPECT_NEAR(jogs_at(1), 700, 1);
}

// Standing at zero it shows by what it has lost.
TEST_F(Restart, AtZeroAValueThatWasNotStoredShowsIt) {
  start(pmx);
  run(40);
  ASSERT_EQ(perform(intent::SetParam("SLTX", 30)), "");
  run(2);
  power_cycle();
  EXPECT_TRUE(reported("SLTX read 30 and now reads 20")) << all_notices();
  EXPECT_TRUE(reports_switched_off());
  EXPECT_EQ(param("SLTX"), 20);
  EXPECT_TRUE(latest.axes[0].trust.doubtful());
  EXPECT_FALSE(latest.unsaved_setup) << "what was not stored is gone";
}

TEST_F(Restart, AtZeroASpeedThatIsNeverStoredShowsIt) {
  start(dmx);
  run(15);
  ASSERT_EQ(perform(intent::SetParam("HSPD", 5000)), "");
  run(2);
  power_cycle();
  EXPECT_TRUE(reported("HSPD read 5000 and now reads 1000")) << all_notices();
}

TEST_F(Restart, AtZeroUnexplainedMotorPowerShowsIt) {
  start(pmx);
  ASSERT_EQ(perform(intent::SetPower(2, true)), "");
  run(5);
  power_cycle();
  EXPECT_TRUE(reported("Motor power went off, although no command switched it")) << all_notices();
  EXPECT_EQ(latest.restarts, 1u);
  EXPECT_TRUE(latest.axes[0].trust.doubtful());
}

// EOBOOT has it on.
TEST_F(Restart, AtZeroMotorPowerThatComesOnByItselfShowsItToo) {
  start(dmx);
  ASSERT_EQ(perform(intent::SetParam("EOBOOT", 1)), "");
  ASSERT_EQ(perform(intent::Store()), "");
  run(5);
  power_cycle();
  EXPECT_TRUE(reported("Motor power came on")) << all_notices();
}

TEST_F(Restart, MotorPowerThatIsSwitchedByTextShowsNone) {
  start(pmx);
  for (const char* text : {"EO=15", "EO=0", "EO2=1", "EO2=0"}) {
    EXPECT_EQ(query(text), "OK") << text;
    run(3);
  }
  EXPECT_FALSE(reports_switched_off()) << all_notices();
  EXPECT_FALSE(latest.axes[1].enabled);
}

TEST_F(Restart, MotorPowerThatAProgramSwitchesShowsNone) {
  start(pmx);
  ASSERT_EQ(perform(intent::SetPower(0, true)), "");
  ASSERT_EQ(perform(intent::LoadProgram(0, "DELAY=3000\nEO=0\nEND\n")), "");
  ASSERT_EQ(perform(intent::RunProgram(0)), "");
  run(60);
  EXPECT_FALSE(latest.axes[0].enabled);
  EXPECT_FALSE(reports_switched_off()) << all_notices();
}

TEST_F(Restart, MotorPowerThatASubroutineSwitchesShowsNone) {
  start(pmx);
  ASSERT_EQ(perform(intent::SetPower(0, true)), "");
  ASSERT_EQ(perform(intent::LoadProgram(0, "END\nSUB 3\nDELAY=3000\nEO=0\nENDSUB\n")), "");
  EXPECT_EQ(query("GS3"), "OK");
  run(60);
  EXPECT_FALSE(latest.axes[0].enabled);
  EXPECT_FALSE(reports_switched_off()) << all_notices();
}

// A stop reads positions too: what it has read is no news any more for the round behind it.
TEST_F(Restart, PositionsThatAStopReadFirstShowItToo) {
  start(dmx);
  perform(intent::MoveTo(targets({500})));
  ASSERT_TRUE(wait_idle());
  ASSERT_TRUE(loop->operate(bench::PowerCycle()));
  perform(intent::Stop());
  run(40);
  EXPECT_TRUE(reports_switched_off()) << all_notices();
}

// The loop corrects by a count or two, at any time.
TEST_F(Restart, AnAxisThatStepNLoopBringsToZeroShowsNone) {
  start(dmx);
  perform(intent::MoveTo(targets({2})));
  ASSERT_TRUE(wait_idle());
  run(5);
  ASSERT_TRUE(loop->operate(bench::Jam(AxisId{0}, true)));
  EXPECT_EQ(query("X0"), "OK");
  run(40);
  EXPECT_FALSE(reports_switched_off()) << all_notices();
}

// Nothing that the controller tells has changed, and nothing was lost either.
TEST_F(Restart, AtZeroWithEverythingStoredNothingShowsItAndNothingIsLost) {
  start(dmx);
  run(15);
  ASSERT_EQ(perform(intent::SetParam("SLT", 30)), "");
  ASSERT_EQ(perform(intent::Store()), "");
  power_cycle();
  EXPECT_FALSE(reports_switched_off());
  EXPECT_EQ(param("SLT"), 30);
}

// The code of the program is known, and sets none of what was lost.
TEST_F(Restart, AtZeroAfterAProgramHasRunItStillShows) {
  start(pmx);
  run(40);
  ASSERT_EQ(perform(intent::SetParam("SLTX", 30)), "");
  ASSERT_EQ(perform(intent::SetParam("HSY", 2345)), "");
  ASSERT_EQ(perform(intent::LoadProgram(0, "V60=7\nHSPDX=500\nEND\n")), "");
  ASSERT_EQ(perform(intent::RunProgram(0)), "");
  run(1);
  power_cycle();
  EXPECT_TRUE(reports_switched_off()) << all_notices();
  EXPECT_FALSE(latest.unsaved_setup);
}

// What it takes back may have been a program nobody knows the code of; that nothing is left to store is sure.
TEST_F(Restart, AtZeroAfterAnUnknownProgramNothingIsLeftToStore) {
  start(pmx);
  run(40);
  ASSERT_EQ(perform(intent::LoadProgram(0, "WHILE 1=1\nDELAY=100\nENDWHILE\nEND\n")), "");
  ASSERT_EQ(perform(intent::SetParam("SLTX", 30)), "");
  EXPECT_TRUE(latest.unsaved_setup);
  EXPECT_EQ(query("SA0=" + query("SA0")), "OK");
  ASSERT_EQ(perform(intent::RunProgram(0)), "");
  run(3);
  power_cycle();
  EXPECT_EQ(param("SLTX"), 20);
  EXPECT_FALSE(latest.unsaved_setup) << all_notices();
}

TEST_F(Restart, ParametersThatAProgramSetsShowNone) {
  start(pmx);
  run(40);
  ASSERT_EQ(perform(intent::SetParam("HSY", 2345)), "");
  ASSERT_EQ(perform(intent::SetParam("SCVX", 1)), "");
  ASSERT_EQ(perform(intent::LoadProgram(0, "HSPDY=0\nSCVX=0\nEND\n")), "");
  ASSERT_EQ(perform(intent::RunProgram(0)), "");
  run(60);
  EXPECT_FALSE(reports_switched_off()) << all_notices();
}

// By hand, too.
TEST_F(Restart, AParameterSetBackNeedsNoStore) {
  start(pmx);
  run(40);
  ASSERT_EQ(perform(intent::SetParam("SLTX", 30)), "");
  EXPECT_TRUE(latest.unsaved_setup);
  ASSERT_EQ(perform(intent::SetParam("SLTX", 20)), "");
  EXPECT_FALSE(latest.unsaved_setup);
  ASSERT_EQ(perform(intent::SetVariable(60, 1)), "");
  ASSERT_EQ(perform(intent::SetParam("SLTX", 30)), "");
  ASSERT_EQ(perform(intent::SetParam("SLTX", 20)), "");
  EXPECT_TRUE(latest.unsaved_setup) << "the variable is not stored";
}

TEST_F(Restart, OrdinaryUseShowsNone) {
  start(pmx);
  run(40);
  perform(intent::SetParam("HS", 5000));
  perform(intent::MoveTo(targets({3000})));
  ASSERT_TRUE(wait_idle());
  perform(intent::MoveTo(targets({0})));
  ASSERT_TRUE(wait_idle());
  perform(intent::MoveBy(targets({200}), Pps{2000}));  // with a speed of its own
  ASSERT_TRUE(wait_idle());
  perform(intent::SetPosition(-1, Steps(0)));
  run(3);
  (void)query("HS=1000");  // by hand
  run(40);
  (void)query("HS=5000");
  run(40);
  perform(intent::LoadProgram(0, "HSPD=1000\nEND\n"));
  perform(intent::RunProgram(0));
  run(40);
  perform(intent::MoveTo(targets({2000})));
  ASSERT_TRUE(wait_idle());
  perform(intent::Home(AxisId{0}, Sign::minus, 3));  // on the index: ends at zero
  ASSERT_TRUE(wait_idle());
  EXPECT_FALSE(reports_switched_off()) << all_notices();
}

// ---- moves

TEST_F(DriverTest, AnAbsoluteMoveGoesOutAsItIs) {
  start(pmx);
  sent();
  EXPECT_EQ(perform(intent::MoveTo(targets({1000}))), "");
  EXPECT_THAT(sent(), HasSubstr("X1000"));
  ASSERT_TRUE(wait_idle());
  EXPECT_EQ(position(), 1000);
  EXPECT_EQ(latest.axes[0].ended_by, EndedBy::target);
}

TEST_F(DriverTest, TheUsersMoveModeIsLeftAlone) {
  start(pmx);
  EXPECT_EQ(act("incremental", {}), "");
  sent();
  EXPECT_EQ(perform(intent::MoveTo(targets({500}))), "");
  ASSERT_TRUE(wait_idle());
  EXPECT_EQ(position(), 500);
  EXPECT_EQ(perform(intent::MoveTo(targets({300}))), "");
  ASSERT_TRUE(wait_idle());
  EXPECT_EQ(position(), 300);
  const std::string wire = sent();
  EXPECT_THAT(wire, HasSubstr("X-200"));
  EXPECT_EQ(wire.find("ABS"), wire.npos);
  EXPECT_EQ(readout("MM"), 1);
}

TEST_F(DriverTest, SeveralAxesMoveOnAStraightLine) {
  start(pmx);
  sent();
  EXPECT_EQ(perform(intent::MoveTo(targets({1000, 500, -200}))), "");
  EXPECT_THAT(sent(), HasSubstr("X1000Y500Z-200"));
  ASSERT_TRUE(wait_idle());
  EXPECT_EQ(position(0), 1000);
  EXPECT_EQ(position(1), 500);
  EXPECT_EQ(position(2), -200);
}

TEST_F(DriverTest, ASpeedForOneMoveIsGivenBack) {
  start(pmx);
  run(3);
  sent();
  EXPECT_EQ(perform(intent::MoveBy(targets({2000}), Pps{4000})), "");
  EXPECT_THAT(sent(), HasSubstr("HS=4000 X2000 HS=1000"));
  ASSERT_TRUE(wait_idle());
  EXPECT_EQ(query("HS"), "1000");
}

TEST_F(DriverTest, ASpeedThatAStopKeptFromBeingGivenBackIsBackBeforeTheNextMove) {
  start(pmx, {}, true);
  for (int ms = 0; ms < 140; ms += 3) {
    post(intent::JogStart(AxisId{0}, Sign::plus, Pps{4000}, false));
    run(ms / 1000.0);
    post(intent::Stop());
    EXPECT_EQ(perform(intent::MoveBy(targets({-300}))), "") << ms;
    const std::string all = sent();
    const auto move = all.rfind(" X"), speed = all.rfind("HS=", move);
    if (speed != std::string::npos) {
      EXPECT_EQ(all.substr(speed, 8), "HS=1000 ") << ms << ": " << all;
    }
    ASSERT_TRUE(wait_idle());
  }
}

TEST_F(DriverTest, ASpeedThatALostWireKeptFromBeingGivenBackIsBackAfterIt) {
  start(pmx, {}, true);
  for (int ms = 20; ms < 500; ms += 10) {
    post(intent::JogStart(AxisId{0}, Sign::plus, Pps{4000}, false));
    run(ms / 1000.0);
    loop->pull();
    run(0.01);
    ASSERT_TRUE(run_until([&] { return latest.link.state == LinkState::good; }));
    ASSERT_TRUE(wait_idle());
    EXPECT_EQ(query("HS"), "1000") << ms;
  }
  EXPECT_EQ(query("HS=2000"), "OK") << "what somebody sets is theirs";
  run(2);
  EXPECT_EQ(query("HS"), "2000");
}

TEST_F(DriverTest, ATargetBeyond28BitsIsRefusedHere) {
  start(dmx);
  sent();
  EXPECT_THAT(perform(intent::MoveTo(targets({134'217'728}))), HasSubstr("Position 134217728 of axis X"));
  EXPECT_EQ(sent().find('X'), std::string::npos);
}

TEST_F(DriverTest, ARefusalIsShownBesideItsMeaning) {
  start(pmx);
  EXPECT_EQ(perform(intent::MoveTo(targets({50000}))), "");
  run(1);
  const std::string why = perform(intent::MoveTo(targets({100})));
  EXPECT_THAT(why, HasSubstr("?PULSING"));
  EXPECT_THAT(why, HasSubstr("is moving"));
}

TEST_F(DriverTest, AJogThatIsLetGoStopsItsAxisAndLeavesProgramsAlone) {
  start(pmx);
  ASSERT_EQ(perform(intent::LoadProgram(0, "WHILE 1=1\nV1=V1+1\nDELAY=10\nENDWHILE\nEND\n")), "");
  ASSERT_EQ(perform(intent::RunProgram(0)), "");
  EXPECT_EQ(perform(intent::JogStart(AxisId{1}, Sign::minus)), "");
  hold(10);
  EXPECT_EQ(latest.axes[1].activity, Activity::jogging);
  EXPECT_EQ(latest.axes[1].direction, -1);
  sent();
  EXPECT_EQ(perform(intent::JogStop()), "");
  EXPECT_EQ(latest.axes[1].activity, Activity::idle);
  EXPECT_LT(position(1), 0);
  EXPECT_THAT(sent(), HasSubstr("STOPY"));
  EXPECT_EQ(latest.threads[0].run, RunState::running);
}

TEST_F(DriverTest, HomingUsesTheModelsWords) {
  start(dmx);
  sent();
  EXPECT_EQ(perform(intent::Home(AxisId{0}, Sign::plus, 3)), "");
  EXPECT_THAT(sent(), HasSubstr("Z+"));
  EXPECT_EQ(latest.axes[0].activity, Activity::homing);
  perform(intent::Stop());
}

// ---- stops

TEST_F(DriverTest, StopEndsMotionAndPrograms) {
  start(pmx);
  ASSERT_EQ(perform(intent::LoadProgram(0, "WHILE 1=1\nX100000\nWAITX\nX0\nWAITX\nENDWHILE\nEND\n")), "");
  ASSERT_EQ(perform(intent::RunProgram(0)), "");
  run(2);
  ASSERT_EQ(latest.axes[0].activity, Activity::moving);
  sent();
  EXPECT_EQ(perform(intent::Stop()), "");
  EXPECT_THAT(sent(), HasSubstr("STOP SR0=0 STOP SR1=0 SR2=0 SR3=0 STOP")) << "decision AMB-128";
  EXPECT_EQ(latest.axes[0].activity, Activity::idle);
  const auto there = position();
  run(5);
  EXPECT_EQ(position(), there);
  EXPECT_EQ(latest.threads[0].run, RunState::idle);
}

TEST_F(DriverTest, ASecondStopIsImmediate) {
  start(pmx);
  perform(intent::SetParam("ACC", 5000));
  perform(intent::SetParam("HS", 10000));
  perform(intent::MoveTo(targets({1'000'000})));
  run(6);
  sent();
  post(intent::Stop());
  run(0.2);
  EXPECT_EQ(latest.axes[0].activity, Activity::stopping);
  EXPECT_EQ(perform(intent::Stop()), "");
  EXPECT_THAT(sent(), HasSubstr("ABORT"));
  EXPECT_EQ(latest.axes[0].activity, Activity::idle);
  EXPECT_EQ(latest.axes[0].ended_by, EndedBy::abort);
}

TEST_F(DriverTest, AStopOfOneAxisLeavesTheOthers) {
  start(pmx);
  perform(intent::JogStart(AxisId{0}, Sign::plus, {}, false));
  perform(intent::JogStart(AxisId{1}, Sign::plus, {}, false));
  run(1);
  EXPECT_EQ(perform(intent::Stop(1)), "");
  EXPECT_EQ(latest.axes[1].activity, Activity::idle);
  EXPECT_EQ(latest.axes[0].activity, Activity::jogging);
  EXPECT_EQ(perform(intent::Stop()), "");
  EXPECT_EQ(latest.axes[0].activity, Activity::idle);
}

TEST_F(DriverTest, StopTakesTheAxesFromTheJoystick) {
  start(pmx);
  ASSERT_EQ(perform(intent::SetParam("JV1", 1000, true)), "");
  ASSERT_EQ(act("joystick", {0, 1}), "");
  EXPECT_EQ(param("JE"), 1);
  sent();
  EXPECT_EQ(perform(intent::Stop()), "");
  EXPECT_THAT(sent(), HasSubstr("JE=0"));
  EXPECT_EQ(query("JE"), "0");
}

// ---- set-up

TEST_F(DriverTest, ASetParameterIsReadBackAndMarkedUnstored) {
  start(pmx);
  EXPECT_EQ(perform(intent::SetParam("SLRX", 1250)), "");
  EXPECT_EQ(param("SLRX"), 1250);
  EXPECT_TRUE(latest.unsaved_setup);
  EXPECT_EQ(query("SLRX"), "1.250");
  EXPECT_EQ(perform(intent::Store()), "");
  EXPECT_FALSE(latest.unsaved_setup);
}

TEST_F(DriverTest, ATimeThatTheControllerAdjustsIsReportedNotHidden) {
  start(dmx);
  EXPECT_EQ(perform(intent::SetParam("ACC", 40000)), "");
  EXPECT_LT(param("ACC"), 40'000);
  EXPECT_TRUE(reported("table A.0"));
}

TEST_F(DriverTest, TheDeviceNameIsItsNumber) {
  start(dmx);
  EXPECT_EQ(perform(intent::SetParam("DN", 7)), "");
  EXPECT_EQ(query("DN"), "DMK07");
  EXPECT_THAT(perform(intent::SetParam("DN", 100)), HasSubstr("DMK100 is not possible"));
}

TEST_F(DriverTest, ReadoutsVariablesAndAnalogAreLiveWhenWatched) {
  start(pmx);
  perform(intent::Watch(1u << 4 | 1u << 6));
  EXPECT_EQ(perform(intent::SetVariable(7, -42)), "");
  (void)loop->operate(bench::Analog(3, 1234));
  run(4);
  EXPECT_TRUE(latest.variables_known.all() || latest.variables_known.count() == 100u);
  EXPECT_EQ(latest.variables[7], -42);
  EXPECT_EQ(latest.analog[2], 1234);
}

// A round reads one of the eight.
TEST_F(DriverTest, AnAnalogInputIsReadWhenItIsAskedFor) {
  start(pmx);
  run(5);
  for (int n = 1; n <= 8; ++n) (void)loop->operate(bench::Analog(n, 1000 + n));
  const Instant asked_at = time.now();
  EXPECT_EQ(perform(intent::ReadAnalog(8)), "");
  EXPECT_EQ(latest.analog[7], 1008);
  EXPECT_GE(latest.analog_seen_at[7], asked_at);
  EXPECT_NE(perform(intent::ReadAnalog(9)), "") << "there is none";
}

// Decisions AMB-087 and AMB-091: taken, remembered, not shown.
TEST_F(DriverTest, AnOutputThatTheControllerUsesItselfIsMarked) {
  start(dmx);
  run(15);
  ASSERT_EQ(param("EDO"), 1);
  EXPECT_EQ(perform(intent::SetOutput(1, false)),
            "DO1 stays on: it shows in-position while EDO=1 and StepNLoop is on. The controller has accepted "
            "DO1=0 and remembers it. It takes effect as soon as the output is free.");
  EXPECT_THAT(perform(intent::SetOutput(3, true)), HasSubstr("DO3 stays off: it shows the alarm"));
  EXPECT_EQ(perform(intent::SetOutput(2, false)), "");
  EXPECT_EQ(query("SYNO"), "OK");
  EXPECT_THAT(perform(intent::SetOutput(2, false)), HasSubstr("DO2 stays on: the controller itself uses it"))
      << "it stands at the sync position";
  ASSERT_EQ(perform(intent::SetParam("EDO", 0)), "");
  EXPECT_EQ(perform(intent::SetOutput(1, false)), "");
}

// ---- actions

TEST_F(DriverTest, ACircleIsDrawnAndEndsWhereItBegan) {
  start(pmx);
  sent();
  EXPECT_EQ(act("arc", {500, 0, -360'000}), "");
  EXPECT_THAT(sent(), HasSubstr("CIRP500:0"));
  run(1);
  EXPECT_NE(position(1), 0);
  ASSERT_TRUE(wait_idle());
  EXPECT_EQ(position(0), 0);
  EXPECT_EQ(position(1), 0);
}

TEST_F(DriverTest, AnArcIsGivenByItsSweepAndBeginsWhereTheAxesStand) {
  start(pmx);
  sent();
  EXPECT_EQ(act("arc", {1000, 0, -90'000}), "");
  EXPECT_THAT(sent(), HasSubstr("ARCP1000:0:90000:90000"));
  ASSERT_TRUE(wait_idle());
  EXPECT_NEAR(position(0), 1000, 1);
  EXPECT_NEAR(position(1), 1000, 1);
  EXPECT_EQ(act("arc", {1000, 0, 90'000}), "");
  EXPECT_THAT(sent(), HasSubstr("ARCN1000:0:0:90000"));
  ASSERT_TRUE(wait_idle());
  EXPECT_NEAR(position(0), 0, 1);
  EXPECT_NEAR(position(1), 0, 1);
  EXPECT_EQ(act("arc", {1000, 0, 0}), "An arc must sweep more than 0 degrees. Nothing was sent.");
}

TEST_F(DriverTest, ArcsAreRefusedInIncrementalModeWithAWord) {
  start(pmx);
  act("incremental", {});
  EXPECT_THAT(act("arc", {0, 0, 90'000}), HasSubstr("absolute mode"));
}

TEST_F(DriverTest, ALimitErrorIsShownAndCleared) {
  start(dmx);
  (void)loop->operate(bench::Limit(AxisId{0}, Sign::plus, true));
  EXPECT_EQ(perform(intent::MoveTo(targets({1000}))), "");
  ASSERT_TRUE(wait_idle());
  EXPECT_EQ(latest.axes[0].activity, Activity::error);
  EXPECT_EQ(latest.axes[0].ended_by, EndedBy::limit);
  EXPECT_THAT(std::string(latest.notice.view()), HasSubstr("+ limit"));
  EXPECT_THAT(perform(intent::MoveTo(targets({-100}))), HasSubstr("clear the errors"));
  (void)loop->operate(bench::Limit(AxisId{0}, Sign::plus, false));
  EXPECT_EQ(act("clear", {}), "");
  EXPECT_EQ(latest.axes[0].activity, Activity::idle);
  EXPECT_EQ(perform(intent::MoveTo(targets({-100}))), "");
}

TEST_F(DriverTest, TheTargetAndTheSpeedChangeUnderWay) {
  start(dmx);
  ASSERT_EQ(perform(intent::SetParam("SSPDM", 1, true)), "");
  perform(intent::MoveTo(targets({50000})));
  run(1);
  sent();
  EXPECT_EQ(act("change_speed", {2000, 0}), "");
  EXPECT_EQ(act("change_target", {3000}), "");
  EXPECT_EQ(sent(), "SSPD2000 T3000");
  ASSERT_TRUE(wait_idle());
  EXPECT_EQ(position(), 3000);
}

TEST_F(DriverTest, ALongListOfMovesIsFedAsPlacesBecomeFree) {
  start(pmx);
  perform(intent::SetParam("IACC", 0));
  std::vector<std::vector<std::int64_t>> rows;
  for (int i = 1; i <= 60; ++i) rows.push_back({i * 20, i * 10, 0, 500});
  EXPECT_EQ(perform(intent::FeedMoves(rows)), "");
  EXPECT_EQ(latest.feed.total, 60);
  ASSERT_TRUE(run_until([&] { return !latest.feed.running; }, 60));
  EXPECT_EQ(latest.feed.sent, 60);
  ASSERT_TRUE(wait_idle());
  EXPECT_EQ(position(0), 1200);
  EXPECT_EQ(position(1), 600);
  EXPECT_EQ(readout("BUF"), 1);
}

TEST_F(DriverTest, AStopEndsTheFeeding) {
  start(pmx);
  std::vector<std::vector<std::int64_t>> rows(100, {0, 0, 0, 500});
  for (std::size_t i = 0; i < rows.size(); ++i) rows[i][0] = static_cast<std::int64_t>(i + 1) * 500;
  perform(intent::FeedMoves(rows));
  run(1);
  EXPECT_EQ(perform(intent::Stop()), "");
  EXPECT_FALSE(latest.feed.running);
  const auto there = position();
  run(3);
  EXPECT_EQ(position(), there);
}

TEST_F(DriverTest, TheLatchCapturesBothPositions) {
  start(dmx);
  EXPECT_EQ(act("latch", {1}), "");
  perform(intent::Watch(1u << 2));
  run(1);
  EXPECT_EQ(readout("LTS"), 1);
  perform(intent::MoveTo(targets({2000})));
  run(1);
  (void)loop->operate(bench::Input(2, true));
  ASSERT_TRUE(wait_idle());
  EXPECT_EQ(readout("LTS"), 2);
  EXPECT_GT(readout("LTE"), 0);
}

// ---- programs

TEST_F(DriverTest, AProgramIsCompiledWrittenComparedAndRun) {
  start(dmx);
  EXPECT_EQ(perform(intent::LoadProgram(0, "X400\nWAITX\nX100\nWAITX\nEND\n")), "");
  EXPECT_EQ(latest.slot_bytes_used[0], 5);
  EXPECT_FALSE(latest.transfer.running);
  EXPECT_EQ(perform(intent::RunProgram(0)), "");
  EXPECT_EQ(latest.threads[0].run, RunState::running);
  EXPECT_GE(latest.threads[0].line, 0);
  ASSERT_TRUE(wait_idle());
  EXPECT_EQ(position(), 100);
  EXPECT_EQ(latest.threads[0].run, RunState::idle);
}

TEST_F(DriverTest, AShorterProgramLeavesNothingOfTheLongerOne) {
  start(dmx);
  ASSERT_EQ(perform(intent::LoadProgram(0, "V1=1\nV2=2\nV3=3\nV4=4\nV5=5\nV6=6\nV7=7\nEND\n")), "");
  ASSERT_EQ(perform(intent::LoadProgram(0, "V1=9\nEND\n")), "");
  EXPECT_EQ(query("SA2"), "");
  ASSERT_EQ(perform(intent::UploadProgram(0)), "");
  EXPECT_THAT(program_text(), HasSubstr("V1=9"));
  EXPECT_EQ(program_text().find("V3"), std::string::npos);
  ASSERT_EQ(perform(intent::ClearProgram(0)), "");
  EXPECT_EQ(query("SA0"), "");
}

TEST_F(DriverTest, AnErrorInTheProgramIsNamedWithItsLineAndNothingIsWritten) {
  start(dmx);
  sent();
  EXPECT_THAT(perform(intent::LoadProgram(0, "X400\nFOO\nEND\n")), HasSubstr("error in line 2"));
  EXPECT_EQ(sent(), "");
}

TEST_F(DriverTest, ARunningProgramIsNotOverwritten) {
  start(pmx);
  ASSERT_EQ(perform(intent::LoadProgram(0, "WHILE 1=1\nV1=V1+1\nDELAY=10\nENDWHILE\nEND\n")), "");
  ASSERT_EQ(perform(intent::RunProgram(0)), "");
  EXPECT_THAT(perform(intent::LoadProgram(0, "END\n")), HasSubstr("Program 0 is running"));
  EXPECT_EQ(perform(intent::Pause(0)), "");
  EXPECT_EQ(latest.threads[0].run, RunState::held);
  EXPECT_EQ(perform(intent::Resume(0)), "");
  EXPECT_EQ(latest.threads[0].run, RunState::running);
  EXPECT_EQ(perform(intent::HaltProgram(0)), "");
  EXPECT_EQ(latest.threads[0].run, RunState::idle);
}

// ---- one that answers elsewhere

TEST_F(DriverTest, ARenamedDeviceThatIsGoneIsFollowedWithItsNewAddress) {
  start(dmx);
  ASSERT_EQ(perform(intent::SetParam("DN", 7, true)), "");
  loop->operate(bench::PowerCycle());
  run(5);
  EXPECT_EQ(latest.link.state, LinkState::good) << "it was not stored";
  ASSERT_EQ(perform(intent::SetParam("DN", 7, true)), "");
  ASSERT_EQ(perform(intent::Store()), "");
  loop->operate(bench::PowerCycle());
  ASSERT_TRUE(run_until([&] { return latest.link.attempts > 0; }, 30));
  run(5);
  EXPECT_THAT(
      std::string(latest.link.sentence.view()),
      HasSubstr("Open it with id=07: it was given address 07, which takes effect at the next power-up."));
}

// ---- the wire

TEST_F(DriverTest, AtTheRateOfTheLineARoundOfStatusIsLive) {
  start(pmx, {}, true);
  EXPECT_EQ(latest.link.state, LinkState::good) << latest.link.sentence.view();
  perform(intent::MoveTo(targets({3000})));
  run(1);
  EXPECT_FALSE(is_stale(latest.axes[0].seen_at, time.now(), latest.poll_period));
  ASSERT_TRUE(wait_idle());
  EXPECT_EQ(position(), 3000);
  EXPECT_EQ(latest.link.timeouts, 0u);
}

TEST_F(DriverTest, AMotionWhoseAnswerIsLostIsNotRepeated) {
  start(dmx);
  run(3);
  sent();
  loop->drop(0);
  loop->to_controller.clear();
  const IntentId id = post(intent::JogStart(AxisId{0}, Sign::plus, {}, false));
  loop->garble(3);
  run_until([&] { return outcome(id) != IntentState::pending; }, 10);
  run(1);
  std::size_t jogs = 0;
  for (auto at = loop->to_controller.find("J+"); at != std::string::npos;
       at = loop->to_controller.find("J+", at + 1))
    ++jogs;
  EXPECT_EQ(jogs, 1u);
  perform(intent::Stop());
}

}  // namespace
}  // namespace hw::arcus
