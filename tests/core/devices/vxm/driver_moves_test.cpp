#include "tests/core/devices/vxm/driver_fixture.h"

namespace hw::vxm {
namespace {

using testing::ContainsRegex;
using testing::HasSubstr;

class VxmDriverMoves : public DriverTest {};

TEST_F(VxmDriverMoves, MovesToAPositionAndReportsIt) {
  start();
  sent();
  EXPECT_EQ(move_to(0, 400), "");
  EXPECT_EQ(latest.axes[0].activity, Activity::moving);
  EXPECT_EQ(latest.axes[0].target, Steps{400});
  EXPECT_EQ(latest.axes[0].direction, 1);
  EXPECT_TRUE(wait_idle());
  EXPECT_EQ(position(), 400);
  EXPECT_EQ(latest.axes[0].ended_by, EndedBy::target);
  EXPECT_THAT(sent(), HasSubstr("IA1M400\rlstR"));
}

TEST_F(VxmDriverMoves, UsesAnEmptyProgramAndLeavesNothingForTheRunButton) {
  start();
  EXPECT_EQ(perform(intent::LoadProgram(0, "I1M100\n")), "");
  EXPECT_EQ(move_by(0, 400), "");
  EXPECT_TRUE(wait_idle());
  EXPECT_EQ(position(), 400);
  EXPECT_EQ(query("PM"), "0");
  EXPECT_EQ(query("M"), "252");
  EXPECT_EQ(query("PM4,lst"), "PM4 M256");
  EXPECT_EQ(perform(intent::SelectProgram(0)), "");
  ASSERT_TRUE(loop->operate(bench::Button("Run", true)));
  run(0.2);
  ASSERT_TRUE(loop->operate(bench::Button("Run", false)));
  run(0.3);
  EXPECT_TRUE(wait_idle());
  EXPECT_EQ(position(), 500) << "Run ran program 0, not the move of the console";
}

TEST_F(VxmDriverMoves, RunButtonDoesNotRepeatAJogInAnEmptyController) {
  start();
  EXPECT_EQ(move_by(1, 50), "");
  EXPECT_TRUE(wait_idle());
  EXPECT_EQ(position(1), 50);
  ASSERT_TRUE(loop->operate(bench::Button("Run", true)));
  run(0.5);
  ASSERT_TRUE(loop->operate(bench::Button("Run", false)));
  run(1);
  EXPECT_EQ(position(1), 50);
}

TEST_F(VxmDriverMoves, SeveralAxesRunOneAfterTheOther) {
  start();
  std::vector<AxisTarget> both = target(0, 300);
  both.push_back(target(1, -200)[0]);
  EXPECT_EQ(perform(intent::MoveTo(both)), "");
  EXPECT_TRUE(wait_idle());
  EXPECT_EQ(position(0), 300);
  EXPECT_EQ(position(1), -200);
}

TEST_F(VxmDriverMoves, AxesOfTwoControllersRunTogether) {
  start({{"motors", "4"}});
  std::vector<AxisTarget> both = target(0, 400);
  both.push_back(target(2, 800)[0]);
  sent();
  EXPECT_EQ(perform(intent::MoveTo(both)), "");
  EXPECT_TRUE(wait_idle());
  EXPECT_EQ(position(0), 400);
  EXPECT_EQ(position(2), 800);
  EXPECT_THAT(sent(), HasSubstr("(I3M800,I1M400,)lstR"));
}

TEST_F(VxmDriverMoves, EachOfSeveralAxesMayHaveASpeedOfItsOwn) {
  start({{"motors", "4"}});
  const auto move = [this](int first, int second) {
    std::vector<AxisTarget> both = target(first, 400);
    both.push_back(target(second, 800)[0]);
    intent::MoveTo to(both, Pps{300});
    to.own_speeds[static_cast<std::size_t>(first)] = Pps{500};
    sent();
    EXPECT_EQ(perform(std::move(to)), "");
    EXPECT_TRUE(wait_idle());
    return sent();
  };
  const std::string in_turn = move(0, 1);
  EXPECT_THAT(in_turn, HasSubstr("S1M500\rIA1M400"));
  EXPECT_THAT(in_turn, HasSubstr("S2M300\rIA2M800"));
  const std::string of_two = move(2, 0);
  EXPECT_THAT(of_two, testing::Not(HasSubstr("("))) << "a pair has one speed";
  EXPECT_THAT(of_two, HasSubstr("S3M500\rIA3M400"));
}

TEST_F(VxmDriverMoves, ASpeedOfItsOwnIsPutBack) {
  start();
  EXPECT_EQ(send("S1M700,"), "");
  EXPECT_EQ(send("R"), "");
  wait_idle();
  EXPECT_EQ(send("C"), "");
  sent();
  EXPECT_EQ(move_by(0, 100, 500), "");
  EXPECT_TRUE(wait_idle());
  EXPECT_THAT(sent(), HasSubstr("S1M500\rI1M100\rS1M700\rlstR"));
}

TEST_F(VxmDriverMoves, AJogEndsWithItsStop) {
  start({}, true);
  EXPECT_EQ(perform(intent::JogStart(AxisId{0}, Sign::plus, Pps{1000})), "");
  EXPECT_EQ(latest.axes[0].activity, Activity::jogging);
  hold(20);
  EXPECT_GT(position(), 800);
  EXPECT_EQ(perform(intent::JogStop()), "");
  EXPECT_TRUE(wait_idle(3));
  EXPECT_EQ(latest.axes[0].ended_by, EndedBy::stop);
  EXPECT_EQ(perform(intent::JogStop()), "") << "released twice: that is no second stop";
  const auto stopped_at = position();
  EXPECT_LT(stopped_at, 2400);
  run(2);
  EXPECT_EQ(position(), stopped_at);
  EXPECT_FALSE(latest.axes[0].trust.doubtful());
  EXPECT_EQ(query("PM"), "0");
}

// Its end may come inside a round that has already asked where the motor is.
TEST_F(VxmDriverMoves, AMoveBehindAProgramGoesFromWhereItEnded) {
  start({}, true);
  std::int64_t wanted = 0;
  for (int i = 0; i < 40; ++i) {
    EXPECT_EQ(query(fmt::format("PM-0,I1M{},R", 40 + i)), "^");
    EXPECT_EQ(perform(intent::MoveBy({{AxisId{0}, Steps(1)}})), "");
    EXPECT_TRUE(wait_idle());
    EXPECT_EQ(position(), wanted += 41 + i);
  }
}

TEST_F(VxmDriverMoves, ALongJogGoesOnBeyondItsBoundedIndex) {
  start();
  EXPECT_EQ(perform(intent::JogStart(AxisId{0}, Sign::minus, Pps{500})), "");
  hold(450);
  EXPECT_LT(position(), -20000) << "30 s are one index";
  EXPECT_EQ(latest.axes[0].activity, Activity::jogging);
  EXPECT_EQ(perform(intent::JogStop()), "");
  EXPECT_TRUE(wait_idle(3));
}

TEST_F(VxmDriverMoves, AJogThatLostItsCableIsStoppedAtTheNextConnection) {
  start();
  EXPECT_EQ(perform(intent::JogStart(AxisId{0}, Sign::plus, Pps{500}, false)), "");
  run(2);
  loop->pull();
  run(60);
  EXPECT_EQ(latest.link.state, LinkState::good);
  EXPECT_LT(position(), 2500) << "nobody can hold what the console has lost";
  EXPECT_EQ(latest.axes[0].activity, Activity::idle);
}

TEST_F(VxmDriverMoves, ClosingDuringAJogLeavesNothingForTheRunButton) {
  start();
  EXPECT_EQ(perform(intent::JogStart(AxisId{0}, Sign::plus, Pps{500}, false)), "");
  run(2);
  conversation();
  asio::co_spawn(io, pump->shut_down(), asio::detached);
  run(5);
  EXPECT_EQ(latest.link.state, LinkState::closed);
  const std::string sentence = conversation();
  EXPECT_THAT(sentence,
              ContainsRegex("PM4<0D>PM<0D>\n[^>]*4<0D>\n[^>]*> CM\n[^>]*256<0D>\n[^>]*> PM0<0D>PM<0D>\n"))
      << "the scratch program is emptied, the selection is the user's";
  EXPECT_LT(sentence.find('D'), sentence.find("PM4"));
}

TEST_F(VxmDriverMoves, ClosingDuringAMoveReportsThatItsProgramStays) {
  start();
  EXPECT_EQ(move_by(0, 60000, 1000), "");
  run(1);
  EXPECT_FALSE(reported("the Run button would repeat it"));
  asio::co_spawn(io, pump->shut_down(), asio::detached);
  run(1);
  EXPECT_EQ(latest.link.state, LinkState::closed)
      << "a move may take as long as it likes: nobody waits for it";
  EXPECT_TRUE(reported("program 4 of the controller still holds it")) << all_notices();
}

TEST_F(VxmDriverMoves, AStatusByteThatLooksLikeAMessageIsAByte) {
  start();
  ASSERT_EQ(perform(intent::SetParam("I", 5)), "");  // input 4 does not stop
  for (const int in : {1, 2, 4}) ASSERT_TRUE(loop->operate(bench::Input(in, true)));
  run(0.5);
  EXPECT_EQ(latest.inputs, 0xFFu & ~0b1011u) << "the byte on the wire is an O";
  ASSERT_EQ(move_by(0, 6000), "");
  run(2);
  EXPECT_EQ(latest.inputs, 0xFFu & ~0b1011u);
  EXPECT_FALSE(reported("limit switch"));
  EXPECT_TRUE(wait_idle());
  EXPECT_EQ(position(), 6000);
}

TEST_F(VxmDriverMoves, AJogAtTheSwitchStopsThereQuietly) {
  start();
  ASSERT_TRUE(loop->operate(bench::Limit(AxisId{0}, Sign::plus, true)));
  EXPECT_EQ(perform(intent::JogStart(AxisId{0}, Sign::plus, Pps{0}, false)), "");
  EXPECT_TRUE(wait_idle(3));
  EXPECT_EQ(position(), 0);
  EXPECT_EQ(latest.axes[0].ended_by, EndedBy::limit);
  EXPECT_TRUE(latest.axes[0].limit_plus);
}

TEST_F(VxmDriverMoves, ALimitThatEndsAMoveIsReportedByItsEndAlone) {
  start();
  EXPECT_EQ(move_to(0, 3000), "");
  run(1.0);
  ASSERT_TRUE(loop->operate(bench::Limit(AxisId{0}, Sign::plus, true)));
  EXPECT_TRUE(wait_idle());
  EXPECT_EQ(latest.axes[0].ended_by, EndedBy::limit);
  EXPECT_FALSE(reported("limit")) << all_notices();
}

TEST_F(VxmDriverMoves, HomesToTheSwitchAndCallsItZero) {
  start();
  EXPECT_EQ(perform(intent::Home(AxisId{0}, Sign::minus, 1)), "");
  EXPECT_EQ(latest.axes[0].activity, Activity::homing);
  EXPECT_TRUE(wait_idle(300));
  EXPECT_EQ(position(), 0);
  EXPECT_TRUE(latest.axes[0].limit_minus);
  EXPECT_EQ(latest.axes[0].ended_by, EndedBy::target);
}

TEST_F(VxmDriverMoves, SetsZeroOnlyHere) {
  start();
  move_to(0, 123);
  wait_idle();
  EXPECT_EQ(
      perform(intent::SetPosition(0, Steps{5})),
      "A VXM can set the present position only to zero, not to 5. Nothing was sent. Set zero here, or first "
      "move to the place of the new zero.");
  EXPECT_EQ(perform(intent::SetPosition(0)), "");
  EXPECT_EQ(position(), 0);
  move_to(1, 77);
  wait_idle();
  EXPECT_EQ(perform(intent::SetPosition(-1)), "");
  EXPECT_EQ(position(1), 0);
}

TEST_F(VxmDriverMoves, SwitchesOutputs) {
  start();
  EXPECT_EQ(perform(intent::SetOutput(2, true)), "");
  EXPECT_EQ(latest.outputs, 2u);
  EXPECT_EQ(perform(intent::SetOutput(2, false)), "");
  EXPECT_EQ(latest.outputs, 0u);
  EXPECT_THAT(perform(intent::SetOutput(5, true)), HasSubstr("There is no output 5"));
}

TEST_F(VxmDriverMoves, RefusesWhatCannotBe) {
  start();
  EXPECT_EQ(move_to(0, 9'000'000),
            "Position 9000000 of motor 1 lies outside its range, -8388608 to 8388607. Nothing was sent.");
  EXPECT_EQ(move_by(0, 100, 7000),
            "A speed of 7000 is not possible. The range is 1 to 6000 steps/s. Nothing was sent.");
  EXPECT_EQ(move_by(2, 100), "There is no motor 3. Nothing was sent.");
  move_by(0, 8000);
  EXPECT_EQ(move_by(1, 100),
            "Motor 1 is still moving, and a VXM does one thing at a time. Nothing was sent. Wait until it "
            "ends, or stop it.");
  EXPECT_TRUE(wait_idle());
  ASSERT_TRUE(loop->operate(bench::Input(4, true)));
  run(0.5);
  EXPECT_EQ(move_by(1, 100),
            "The Stop button is pressed or input 4 is low, so the controller starts nothing. Nothing was "
            "sent. Release "
            "it, then try again.");
}

TEST_F(VxmDriverMoves, AsksWhichProgramMayBeEmptiedWhenAllAreUsed) {
  start();
  for (int slot = 0; slot < 5; ++slot) EXPECT_EQ(perform(intent::LoadProgram(slot, "I1M10\n")), "");
  EXPECT_THAT(move_by(0, 100), HasSubstr("All five programs of the controller contain commands"));
  ASSERT_FALSE(notices.empty());
  EXPECT_EQ(notices.back().kind, Notice::Kind::question);
  EXPECT_THAT(notices.back().slots, testing::ElementsAre(0, 1, 2, 3, 4));
  EXPECT_EQ(perform(intent::ClearProgram(3)), "");
  EXPECT_EQ(move_by(0, 100), "");
  EXPECT_TRUE(wait_idle());
  EXPECT_EQ(position(), 100);
  EXPECT_EQ(query("PM4,M"), "252") << "the others are as they were";
}

TEST_F(VxmDriverMoves, NeverUsesAProgramThatStartsByItself) {
  start();
  EXPECT_EQ(perform(intent::SetParam("DM", 129, true)), "");
  sent();
  EXPECT_EQ(move_by(0, 10), "");
  EXPECT_THAT(sent(), HasSubstr("PM3\rPM\rCI1M10\rlstR"));
}

TEST_F(VxmDriverMoves, WarnsBeforeTheFirstMoveThatTheMotorTypeIsTheFactorys) {
  start();
  EXPECT_EQ(latest.notice.view(), "") << "the screen says it by the parameter, see ParamInfo::before_moving";
  move_by(0, 10);
  wait_idle();
  move_by(0, 10);
  wait_idle();
  EXPECT_EQ(std::count_if(notices.begin(), notices.end(),
                          [](const Notice& n) { return n.text.find("type 0") != std::string::npos; }),
            1);
}

}  // namespace
}  // namespace hw::vxm
