// Servo axes of a VME58: where they stand is where their encoder stands, a motion has ended when that has
// come to where the command has, and what would close a large error is asked about first.
#include "tests/core/devices/vme58/driver_rig.h"

namespace hw {
namespace {

using intent::Closing;
using test::Seconds;
using testing::HasSubstr;
using testing::IsEmpty;

constexpr int Y = 1;

class Vme58ServoPlace : public test::Vme58Rig {
 protected:
  using Vme58Rig::Vme58Rig;
  void give_motor() {
    AxisPlace place;
    place.motor = Motor();
    operate(bench::Place(AxisId{Y}, place));
    (void)reported();
  }
  /// Its motor has no gains: the command goes, the encoder stays.
  void leave_behind() {
    give_motor();
    ASSERT_EQ(perform(intent::MoveTo({{AxisId{Y}, Steps(5000)}}, Pps{20000})).state, IntentState::done);
    ASSERT_TRUE(becomes_idle());
  }
  static Task<> wait_and_keep(std::shared_ptr<Session> s, Result<>& result, bool& came) {
    result = co_await s->wait_until_idle(Seconds(30));
    came = true;
  }
  Result<> wait() {
    Result<> result;
    bool came = false;
    asio::co_spawn(io, wait_and_keep(session, result, came), asio::detached);
    EXPECT_TRUE(run_until([&] { return came; }, Seconds(40)));
    return result;
  }
  IntentOutcome set(const char* name, std::int64_t hundredths, Closing closing = Closing::ask) {
    intent::SetParam request(name, hundredths);
    request.closing = closing;
    return perform(request);
  }
};

class Vme58FourStepAxes : public Vme58ServoPlace {
 protected:
  Vme58FourStepAxes() : Vme58ServoPlace({{"variant", "4E"}}) {}
};

TEST_F(Vme58ServoPlace, AServoThatDoesNotComeIsNotInPlaceTwoSecondsAfterItsCommandHasEnded) {
  give_motor();
  ASSERT_EQ(perform(intent::MoveTo({{AxisId{Y}, Steps(5000)}}, Pps{20000})).state, IntentState::done);
  ASSERT_TRUE(
      run_until([this] { return axis(Y).command == Steps(5000) && axis(Y).speed.value == 0; }, Seconds(5)));
  const Instant command_ended = time.now();
  run(Millis(1800));
  EXPECT_EQ(axis(Y).activity, Activity::moving) << "it has not come";
  EXPECT_EQ(axis(Y).loop, Loop::following);
  ASSERT_TRUE(run_until([this] { return axis(Y).activity == Activity::idle; }, Seconds(1)));
  EXPECT_NEAR(seconds(time.now() - command_ended), 2, 0.1);
  EXPECT_EQ(axis(Y).position, Steps(0)) << "the encoder is the position";
  EXPECT_EQ(axis(Y).command, Steps(5000));
  EXPECT_EQ(axis(Y).following_error(), Steps(5000));
  EXPECT_EQ(axis(Y).loop, Loop::off_place);
  EXPECT_EQ(axis(Y).ended_by, EndedBy::not_in_place);
  EXPECT_THAT(reported(), HasSubstr("Y did not reach its target: 2 s after its command ended, its encoder "
                                    "is at 0, 5000 counts from there. Nothing drives it"));
}

TEST_F(Vme58ServoPlace, WaitLastsUntilThenAndReportsWhy) {
  give_motor();
  session->send(intent::MoveTo({{AxisId{Y}, Steps(5000)}}, Pps{20000}));
  const Instant began = time.now();
  const auto waited = wait();
  ASSERT_FALSE(waited);
  EXPECT_GT(time.now() - began, Seconds(2));
  EXPECT_THAT(waited.error().sentence(),
              HasSubstr("Axis Y did not reach its target: its encoder stands at 0, 5000 counts from there."));
}

TEST_F(Vme58ServoPlace, AMoveByTextIsWaitedForTheSameWay) {
  give_motor();
  ASSERT_TRUE(query("AY VL20000 MR5000 GO"));
  const auto waited = wait();
  ASSERT_FALSE(waited);
  EXPECT_THAT(waited.error().sentence(), HasSubstr("5000 counts from there."));
  EXPECT_EQ(axis(Y).ended_by, EndedBy::not_in_place);
}

TEST_F(Vme58ServoPlace, ALoopThatWorksEndsItsMoveInPlace) {
  give_motor();
  ASSERT_TRUE(query("AY HN KP2 KD8"));
  ASSERT_EQ(perform(intent::MoveTo({{AxisId{Y}, Steps(20000)}}, Pps{20000})).state, IntentState::done);
  run(Millis(500));
  EXPECT_EQ(axis(Y).loop, Loop::following);
  EXPECT_NE(axis(Y).following_error(), Steps(0));
  ASSERT_TRUE(run_until([this] { return axis(Y).speed.value == 0; }, Seconds(5)));
  const Instant command_ended = time.now();
  EXPECT_EQ(axis(Y).activity, Activity::moving) << "for 100 ms nobody can be sure";
  ASSERT_TRUE(becomes_idle());
  EXPECT_LT(time.now() - command_ended, Seconds(1));
  EXPECT_EQ(axis(Y).loop, Loop::in_place);
  EXPECT_EQ(axis(Y).ended_by, EndedBy::target);
  EXPECT_NEAR(static_cast<double>(axis(Y).position.value), 20000, 10);
  EXPECT_TRUE(wait());
}

TEST_F(Vme58ServoPlace, TheDeadbandIsTheBoardsOwnWhereItIsSet) {
  give_motor();
  ASSERT_EQ(set("HDY", 6000).state, IntentState::done);
  ASSERT_EQ(perform(intent::MoveTo({{AxisId{Y}, Steps(5000)}}, Pps{20000})).state, IntentState::done);
  EXPECT_TRUE(wait()) << "5000 counts are near enough for whoever says 6000";
  EXPECT_EQ(axis(Y).loop, Loop::in_place);
}

TEST_F(Vme58ServoPlace, OneThatComesLateHasCome) {
  operate(bench::Jam(AxisId{Y}, true));
  ASSERT_EQ(perform(intent::MoveTo({{AxisId{Y}, Steps(5000)}}, Pps{20000})).state, IntentState::done);
  EXPECT_FALSE(wait());
  operate(bench::Jam(AxisId{Y}, false));
  run(Seconds(1));
  EXPECT_EQ(axis(Y).position, Steps(5000));
  EXPECT_EQ(axis(Y).loop, Loop::in_place);
  EXPECT_TRUE(wait());
}

TEST_F(Vme58ServoPlace, OneThatOnlySettlesMayBeSentOn) {
  give_motor();
  for (int tap = 1; tap <= 3; ++tap) {
    EXPECT_EQ(perform(intent::MoveBy({{AxisId{Y}, Steps(20)}})).state, IntentState::done) << tap;
    run(Millis(100));
    EXPECT_EQ(axis(Y).activity, Activity::moving);
    EXPECT_EQ(axis(Y).command, Steps(20 * tap));
  }
  EXPECT_EQ(perform(intent::MoveBy({{AxisId{Y}, Steps(50000)}}, Pps{1000})).state, IntentState::done);
  run(Millis(500));
  EXPECT_EQ(perform(intent::MoveBy({{AxisId{Y}, Steps(20)}})).state, IntentState::refused)
      << "its command moves";
}

TEST_F(Vme58ServoPlace, AnAxisThatTracksGoesNowhereInParticular) {
  ASSERT_TRUE(query("AY ET"));
  (void)reported();
  operate(bench::Slip(AxisId{Y}, Steps(3000)));
  run(Seconds(4));
  EXPECT_EQ(axis(Y).activity, Activity::idle);
  EXPECT_NE(axis(Y).ended_by, EndedBy::not_in_place);
  EXPECT_THAT(reported(), IsEmpty());
}

TEST_F(Vme58ServoPlace, AStoppedAxisRestsByItsCommandAndShowsItsError) {
  give_motor();
  ASSERT_EQ(perform(intent::MoveTo({{AxisId{Y}, Steps(50000)}}, Pps{5000})).state, IntentState::done);
  run(Seconds(1));
  const Instant asked = time.now();
  session->send(intent::Stop());
  ASSERT_TRUE(run_until([this] { return axis(Y).activity == Activity::idle; }, Seconds(5)));
  EXPECT_LT(time.now() - asked, Millis(500));
  EXPECT_EQ(axis(Y).ended_by, EndedBy::stop);
  EXPECT_GT(axis(Y).following_error(), Steps(3000));
  EXPECT_TRUE(wait()) << "it was asked for";
  run(Seconds(3));
  EXPECT_EQ(axis(Y).loop, Loop::off_place);
  EXPECT_EQ(axis(Y).ended_by, EndedBy::stop);
}

TEST_F(Vme58ServoPlace, AJogThatIsLetGoRestsByItsCommand) {
  give_motor();
  session->send(intent::JogStart(AxisId{Y}, Sign::plus, Pps{3000}, false));
  run(Seconds(1));
  session->send(intent::Stop(Y));
  ASSERT_TRUE(run_until([this] { return axis(Y).activity == Activity::idle; }, Millis(500)));
  ASSERT_TRUE(query("AY JG3000"));
  run(Seconds(1));
  ASSERT_TRUE(query("AY ST"));
  ASSERT_TRUE(run_until([this] { return axis(Y).activity == Activity::idle; }, Millis(500)));
}

TEST_F(Vme58ServoPlace, APushIsNoMotionAndIsSeen) {
  give_motor();
  ASSERT_TRUE(query("AY HN KP2 KD8"));
  run(Seconds(1));
  EXPECT_EQ(axis(Y).loop, Loop::in_place);
  operate(bench::Jam(AxisId{Y}, true));
  operate(bench::Slip(AxisId{Y}, Steps(500)));
  run(Millis(500));
  EXPECT_EQ(axis(Y).activity, Activity::idle);
  EXPECT_EQ(axis(Y).loop, Loop::following);
  EXPECT_EQ(axis(Y).following_error(), Steps(-500));
  run(Seconds(2));
  EXPECT_EQ(axis(Y).loop, Loop::off_place);
}

TEST_F(Vme58ServoPlace, AGainThatWouldDriveItThereIsAskedAbout) {
  leave_behind();
  const IntentOutcome asked = set("KPY", 200);
  EXPECT_EQ(asked.state, IntentState::refused);
  EXPECT_TRUE(asked.asks);
  EXPECT_THAT(std::string(asked.sentence.view()),
              HasSubstr("The gains KP and KI of Y are 0, and its encoder is 5000 counts from its command. "
                        "KPY = 2 drives the motor there at once. Nothing was sent."));
  EXPECT_EQ(set("KDY", 800).state, IntentState::done) << "it damps, and drives nothing";
  run(Seconds(1));
  EXPECT_EQ(axis(Y).position, Steps(0));
  EXPECT_EQ(set("KPY", 200, Closing::drive).state, IntentState::done);
  run(Seconds(3));
  EXPECT_NEAR(static_cast<double>(axis(Y).position.value), 5000, 10);
  EXPECT_FALSE(set("KPY", 300).asks) << "it is in place";
}

TEST_F(Vme58ServoPlace, ThePresentPlaceBecomesItsCommandAndTheCountStaysTrue) {
  give_motor();
  ASSERT_TRUE(query("AY LP700"));
  ASSERT_EQ(perform(intent::MoveBy({{AxisId{Y}, Steps(5000)}}, Pps{20000})).state, IntentState::done);
  ASSERT_TRUE(becomes_idle());
  ASSERT_EQ(set("KDY", 800).state, IntentState::done);
  EXPECT_EQ(set("KPY", 200, Closing::stay).state, IntentState::done);
  EXPECT_EQ(axis(Y).command, Steps(700));
  run(Seconds(3));
  EXPECT_EQ(axis(Y).position, Steps(700)) << "it stays, and is counted as before";
  EXPECT_EQ(axis(Y).command, Steps(700));
  EXPECT_EQ(axis(Y).loop, Loop::in_place);
  ASSERT_EQ(perform(intent::MoveTo({{AxisId{Y}, Steps(2700)}}, Pps{20000})).state, IntentState::done);
  ASSERT_TRUE(becomes_idle());
  EXPECT_NEAR(static_cast<double>(axis(Y).position.value), 2700, 10) << "its loop is closed";
}

TEST_F(Vme58ServoPlace, MoreGainForAnAxisThatIsHeldIsAskedAbout) {
  give_motor();
  ASSERT_TRUE(query("AY HN KP2 KD8"));
  operate(bench::Jam(AxisId{Y}, true));
  ASSERT_EQ(perform(intent::MoveTo({{AxisId{Y}, Steps(5000)}}, Pps{20000})).state, IntentState::done);
  run(Millis(500));
  EXPECT_FALSE(set("KPY", 210).asks) << "while it follows it may be tuned";
  ASSERT_TRUE(becomes_idle());
  EXPECT_TRUE(set("KPY", 400).asks);
  EXPECT_TRUE(set("KIY", 100).asks);
  EXPECT_FALSE(set("KPY", 100).asks) << "less drives it less";
}

TEST_F(Vme58ServoPlace, PowerOnFarFromItsCommandIsAskedAbout) {
  give_motor();
  ASSERT_EQ(perform(intent::SetPower(Y, false)).state, IntentState::done);
  EXPECT_EQ(axis(Y).loop, Loop::open);
  operate(bench::Slip(AxisId{Y}, Steps(-3000)));
  run(Seconds(1));
  EXPECT_EQ(axis(Y).position, Steps(-3000));
  EXPECT_EQ(axis(Y).loop, Loop::open);
  const IntentOutcome asked = perform(intent::SetPower(Y, true));
  EXPECT_TRUE(asked.asks);
  EXPECT_THAT(std::string(asked.sentence.view()),
              HasSubstr("The loop of Y is open, and its encoder is 3000 counts from its command."));
  EXPECT_EQ(axis(Y).loop, Loop::open);
  const int hold = session->catalog().find_action("hold");
  EXPECT_TRUE(perform(intent::Act(hold, {Y, 1})).asks) << "the same by another name";
  (void)lines();
  EXPECT_EQ(perform(intent::SetPower(Y, true, Closing::stay)).state, IntentState::done);
  EXPECT_THAT(lines(), testing::Contains(HasSubstr("LP-3000"))) << "whatever a board does with the error";
  run(Seconds(1));
  EXPECT_EQ(axis(Y).position, Steps(-3000));
  EXPECT_EQ(axis(Y).command, Steps(-3000));
  EXPECT_TRUE(axis(Y).enabled);
}

TEST_F(Vme58ServoPlace, TypedTextGoesAsItIsTypedAndIsReported) {
  leave_behind();
  (void)reported();
  ASSERT_TRUE(query("AY KD8 KP2"));
  EXPECT_THAT(reported(), HasSubstr("KP2 was sent while the encoder of Y was 5000 counts from its command"));
  run(Seconds(3));
  EXPECT_NEAR(static_cast<double>(axis(Y).position.value), 5000, 10);
  ASSERT_TRUE(query("AY KP3"));
  EXPECT_THAT(reported(), IsEmpty());
}

TEST_F(Vme58ServoPlace, HereIsZeroMakesTheEncoderReadZero) {
  leave_behind();
  ASSERT_EQ(perform(intent::SetPosition(Y, Steps(100))).state, IntentState::done);
  EXPECT_EQ(axis(Y).position, Steps(100));
  EXPECT_EQ(axis(Y).command, Steps(5100)) << "the error is none of the counter's business";
  ASSERT_EQ(perform(intent::SetPower(Y, false)).state, IntentState::done);
  ASSERT_EQ(perform(intent::SetPosition(-1)).state, IntentState::done);
  EXPECT_EQ(axis(Y).position, Steps(0));
  EXPECT_EQ(axis(Y).command, Steps(0));
}

TEST_F(Vme58ServoPlace, WhetherALoopIsClosedIsReadFromTheBoard) {
  EXPECT_EQ(axis(Y).loop, Loop::in_place) << "the ideal plant of the bench, and EA";
  // Slips beyond ES with TN: the board opens the loop by itself.
  give_motor();
  ASSERT_TRUE(query("AY ES100 TN"));
  session->send(intent::MoveTo({{AxisId{Y}, Steps(5000)}}, Pps{20000}));
  run(Seconds(4));
  EXPECT_EQ(axis(Y).loop, Loop::open);
  EXPECT_FALSE(axis(Y).enabled);
}

TEST_F(Vme58FourStepAxes, StepAxesStayAsTheyAre) {
  EXPECT_EQ(axis(Y).loop, Loop::none);
  operate(bench::Jam(AxisId{Y}, true));
  ASSERT_EQ(perform(intent::MoveTo({{AxisId{Y}, Steps(5000)}}, Pps{20000})).state, IntentState::done);
  ASSERT_TRUE(becomes_idle());
  EXPECT_EQ(axis(Y).position, Steps(5000));
  EXPECT_EQ(axis(Y).encoder, Steps(0));
  EXPECT_EQ(axis(Y).ended_by, EndedBy::target);
}

}  // namespace
}  // namespace hw
