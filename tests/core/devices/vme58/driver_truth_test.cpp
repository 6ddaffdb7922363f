// What the console says of the board is so: when it works, how a motion has ended, on which switch an axis
// stands, and that flags belong to whoever asks for them.
#include "core/devices/vme58/facts.h"
#include "tests/core/devices/vme58/driver_rig.h"

namespace hw {
namespace {

using test::Seconds;
using testing::HasSubstr;

class Vme58Truth : public test::Vme58Rig {
 protected:
  static Task<> wait_and_keep(std::shared_ptr<Session> s, Duration patience, Result<>& how, bool& came) {
    how = co_await s->wait_until_idle(patience);
    came = true;
  }
  /// As c:wait of a script; the time that it takes, and why it was no success.
  struct Waited {
    Duration took{};
    std::string reason;
  };
  Waited wait(Duration patience = Seconds(20)) {
    const Instant began = time.now();
    Result<> how;
    bool came = false;
    asio::co_spawn(io, wait_and_keep(session, patience, how, came), asio::detached);
    EXPECT_TRUE(run_until([&] { return came; }, patience + Seconds(1)));
    return {time.now() - began, how ? std::string() : how.error().sentence()};
  }
  void place(std::int64_t minus, std::int64_t plus) {
    AxisPlace p;
    p.minus = Steps(minus);
    p.plus = Steps(plus);
    operate(bench::Place(AxisId{0}, p));
    run(Millis(300));
  }
  void operate_limit(Sign side, bool on) {
    operate(bench::Limit(AxisId{0}, side, on));
    run(Millis(300));
  }
  IntentOutcome move_by(std::int64_t counts, Pps speed = Pps{2000}) {
    return perform(intent::MoveBy({{AxisId{0}, Steps(counts)}}, speed));
  }
};

// ---- working (what c:wait waits for)

TEST_F(Vme58Truth, TextThatMovesAnAxisIsWaitedFor) {
  ASSERT_TRUE(query("AX VL1000 AC10000 MR1000 GO"));
  EXPECT_EQ(wait().reason, "");
  EXPECT_EQ(axis().position, Steps(1000));
  EXPECT_EQ(axis().speed.value, 0);
}

TEST_F(Vme58Truth, AWaitInTheQueueIsWaitedFor) {
  ASSERT_TRUE(query("AX WT1000 MR10 GO"));
  EXPECT_TRUE(now().working) << "without a round between";
  const Waited waited = wait();
  EXPECT_EQ(waited.reason, "");
  EXPECT_GT(waited.took, Millis(990));
  EXPECT_LT(waited.took, Millis(1300));
  EXPECT_EQ(axis().position, Steps(10));
}

TEST_F(Vme58Truth, APauseBetweenTwoMovesIsNoEnd) {
  ASSERT_TRUE(query("AX VL1000 AC10000 MR500 GO WT2000 MR500 GO"));
  const Waited waited = wait();
  EXPECT_EQ(waited.reason, "");
  EXPECT_GT(waited.took, Seconds(3));
  EXPECT_LT(waited.took, Millis(3800));
  EXPECT_EQ(axis().position, Steps(1000));
}

TEST_F(Vme58Truth, TheQueueOfAllAxesIsWaitedForToo) {
  ASSERT_TRUE(query("AA VL1000,1000; WT700 MR100,200; GO"));
  EXPECT_EQ(wait().reason, "");
  EXPECT_EQ(axis(1).position, Steps(200));
}

TEST_F(Vme58Truth, ACommandDoneAtOnceIsNotWaitedFor) {
  ASSERT_TRUE(query("AX RP"));
  EXPECT_FALSE(now().working);
  ASSERT_TRUE(query("AX VL5000"));
  EXPECT_LT(wait().took, Millis(100));
  run(Seconds(1));
  EXPECT_FALSE(now().working);
}

TEST_F(Vme58Truth, AJogSlowerThanOneCountASecondTurnsUntilItIsStopped) {
  ASSERT_TRUE(query("AX JF0.25"));
  EXPECT_THAT(wait(Seconds(30)).reason, HasSubstr("still not idle"));
  EXPECT_GT(axis().position, Steps(3));
  int rests = 0;
  for (int i = 0; i < 100; ++i) {
    run(Millis(100));
    rests += axis().activity == Activity::idle;
  }
  EXPECT_EQ(rests, 0);
  ASSERT_TRUE(query("AX ST"));
  EXPECT_EQ(wait().reason, "");
  EXPECT_EQ(axis().activity, Activity::idle);
}

TEST_F(Vme58Truth, AProgramThatLeavesASlowJogRunsOn) {
  ASSERT_EQ(perform(intent::LoadProgram(0, "AX JF0.25")).state, IntentState::done);
  ASSERT_EQ(perform(intent::RunProgram(0)).state, IntentState::done);
  EXPECT_THAT(wait(Seconds(5)).reason, HasSubstr("still not idle"));
  session->send(intent::Stop());
  run(Seconds(1));
  EXPECT_LT(wait().took, Millis(300));
}

TEST_F(Vme58Truth, CommandsThatAStopRemovedAreNotWaitedFor) {
  ASSERT_TRUE(query("AX WT60000 MR10 GO"));
  run(Millis(500));
  session->send(intent::Stop());
  run(Millis(300));
  EXPECT_LT(wait().took, Millis(300));
  EXPECT_EQ(axis().position, Steps(0));
}

TEST_F(Vme58Truth, AMoveThatAResetByTextEndsIsLost) {
  ASSERT_TRUE(query("AX VL10000 AC100000"));
  ASSERT_EQ(move_by(100000, Pps{}).state, IntentState::done);
  run(Millis(500));
  const IntentOutcome outcome = perform(intent::SendText("RS"));
  EXPECT_EQ(outcome.state, IntentState::done) << outcome.sentence.view();
  EXPECT_NE(wait().reason, "");
  run(Seconds(3));
  EXPECT_THAT(wait().reason, HasSubstr("Axis X was moving when the console lost track of it"));
  EXPECT_EQ(axis().ended_by, EndedBy::lost);
  EXPECT_EQ(now().restarts, 1u);
  ASSERT_EQ(move_by(100).state, IntentState::done);
  EXPECT_EQ(wait().reason, "");
}

TEST_F(Vme58Truth, AProgramThatAResetEndsIsLost) {
  for (const bool moves : {true, false})
    for (const bool by_text : {false, true}) {
      const std::string text = moves ? "AX VL10000 WT2000 MR100000 GO" : "AX WT2000 BL8";
      ASSERT_EQ(perform(intent::LoadProgram(0, text)).state, IntentState::done);
      ASSERT_EQ(perform(intent::RunProgram(0)).state, IntentState::done);
      run(Millis(500));
      if (by_text)
        perform(intent::SendText("RS"));
      else
        operate(bench::PowerCycle());
      EXPECT_NE(wait().reason, "");
      run(Seconds(3));
      EXPECT_EQ(now().program.ended_by, EndedBy::lost);
      EXPECT_NE(wait().reason, "");
      ASSERT_EQ(move_by(100).state, IntentState::done);
      EXPECT_EQ(wait().reason, "") << "that was the program, not this";
    }
}

// ---- gentle ramps

TEST_F(Vme58Truth, AMoveSoGentleThatNothingShowsAtFirstIsNotReportedAsStopped) {
  ASSERT_EQ(perform(intent::SetParam("ACX", 1)).state, IntentState::done);
  ASSERT_EQ(perform(intent::SetParam("VLX", 1)).state, IntentState::done);
  ASSERT_EQ(move_by(5, Pps{}).state, IntentState::done);
  const Waited waited = wait(Seconds(30));
  EXPECT_EQ(waited.reason, "");
  EXPECT_GT(waited.took, Seconds(5));
  EXPECT_EQ(axis().position, Steps(5));
  EXPECT_EQ(axis().ended_by, EndedBy::target);
}

TEST_F(Vme58Truth, TheShortWayOfAStraightLineEndsWithTheLongOne) {
  ASSERT_EQ(perform(intent::MoveBy({{AxisId{0}, Steps(20000)}, {AxisId{1}, Steps(2)}}, Pps{4000})).state,
            IntentState::done);
  EXPECT_EQ(wait().reason, "");
  EXPECT_EQ(axis(0).ended_by, EndedBy::target);
  EXPECT_EQ(axis(1).ended_by, EndedBy::target);
}

TEST_F(Vme58Truth, AMoveThatAnotherProgramStopsIsReportedAsStopped) {
  ASSERT_EQ(move_by(100000).state, IntentState::done);
  run(Seconds(1));
  ASSERT_TRUE(query("SA"));
  EXPECT_THAT(wait().reason, HasSubstr("was stopped by the controller's Stop button"));
}

TEST_F(Vme58Truth, AMoveThatIsRejectedLeavesATypedJogAsItIs) {
  ASSERT_TRUE(query("AX JG5000"));
  run(Seconds(1));
  ASSERT_EQ(axis().activity, Activity::moving);
  EXPECT_EQ(move_by(1000).state, IntentState::failed);
  run(Millis(500));
  EXPECT_EQ(axis().activity, Activity::moving) << "it goes on";
  EXPECT_EQ(perform(intent::Stop()).state, IntentState::done);
  EXPECT_EQ(wait().reason, "");
  EXPECT_EQ(axis().speed.value, 0);
}

TEST_F(Vme58Truth, AMoveBehindAWaitIsUnderWayAndEndsAtItsTarget) {
  ASSERT_TRUE(query("AX ID WT1500"));
  ASSERT_EQ(move_by(100).state, IntentState::done);
  run(Seconds(1));
  EXPECT_EQ(axis().activity, Activity::moving) << "the done flag before it says nothing of it";
  EXPECT_EQ(wait().reason, "");
  EXPECT_EQ(axis().position, Steps(100));
  EXPECT_EQ(axis().ended_by, EndedBy::target);
}

// ---- limits

TEST_F(Vme58Truth, AMoveIntoASwitchThatIsOnAlreadyDoesNotReachItsTarget) {
  place(-500, 500);
  ASSERT_EQ(perform(intent::MoveTo({{AxisId{0}, Steps(900)}}, Pps{2000})).state, IntentState::done);
  EXPECT_THAT(wait().reason, HasSubstr("limit switch"));
  ASSERT_EQ(axis().position, Steps(500));
  ASSERT_EQ(move_by(100).state, IntentState::done);
  EXPECT_THAT(wait().reason, HasSubstr("limit switch"));
  EXPECT_EQ(axis().ended_by, EndedBy::limit);
  EXPECT_EQ(axis().position, Steps(500));
  EXPECT_TRUE(axis().limit_plus);
}

TEST_F(Vme58Truth, AJogIntoASwitchThatIsOnAlreadyIsEndedByIt) {
  operate_limit(Sign::plus, true);
  session->send(intent::JogStart(AxisId{0}, Sign::plus, Pps{500}, false));
  run(Seconds(2));
  EXPECT_EQ(axis().activity, Activity::idle);
  EXPECT_EQ(axis().ended_by, EndedBy::limit);
}

TEST_F(Vme58Truth, AJogAwayFromASwitchThatIsStoppedBeforeItTurnsIsEndedByTheStop) {
  operate_limit(Sign::minus, true);
  session->send(intent::JogStart(AxisId{0}, Sign::plus, Pps{0.5}, false));
  run(Millis(100));
  session->send(intent::Stop());
  ASSERT_TRUE(becomes_idle());
  ASSERT_EQ(axis().position, Steps(0));
  EXPECT_NE(axis().ended_by, EndedBy::limit);
}

TEST_F(Vme58Truth, HomingIntoASwitchThatIsOnAlreadyIsNoHome) {
  operate_limit(Sign::plus, true);
  ASSERT_EQ(perform(intent::Home(AxisId{0}, Sign::plus, 0)).state, IntentState::done);
  EXPECT_THAT(wait().reason, HasSubstr("limit switch"));
}

TEST_F(Vme58Truth, AMoveAwayFromASwitchReachesItsTarget) {
  place(-500, 500);
  ASSERT_EQ(move_by(900).state, IntentState::done);
  EXPECT_THAT(wait().reason, HasSubstr("limit switch"));
  ASSERT_EQ(move_by(-300).state, IntentState::done);
  EXPECT_EQ(wait().reason, "");
  EXPECT_EQ(axis().position, Steps(200));
  EXPECT_EQ(axis().ended_by, EndedBy::target);
}

TEST_F(Vme58Truth, TheSideOfASwitchIsThatOfTheMoveThatItEnds) {
  operate_limit(Sign::minus, true);
  ASSERT_EQ(move_by(-500).state, IntentState::done);
  EXPECT_THAT(wait().reason, HasSubstr("limit switch"));
  run(Millis(300));
  EXPECT_TRUE(axis().limits_known);
  EXPECT_TRUE(axis().limit_minus);
  EXPECT_FALSE(axis().limit_plus);
  EXPECT_EQ(axis().position, Steps(0));
}

TEST_F(Vme58Truth, TheSideOfASwitchIsThatOfTheUsersTextToo) {
  operate_limit(Sign::minus, true);
  ASSERT_TRUE(query("AX MR-500 GO"));
  wait();
  run(Millis(300));
  EXPECT_TRUE(axis().limit_minus);
  EXPECT_FALSE(axis().limit_plus);
}

TEST_F(Vme58Truth, TheSideStaysWhileTheAxisComesAwayFromTheSwitch) {
  operate_limit(Sign::plus, true);
  EXPECT_TRUE(axis().limit_plus);
  session->send(intent::JogStart(AxisId{0}, Sign::minus, Pps{100}, false));
  int wrong = 0;
  for (int i = 0; i < 100; ++i) {
    run(Millis(10));
    wrong += axis().limit_minus;
  }
  session->send(intent::Stop());
  ASSERT_TRUE(becomes_idle());
  run(Seconds(1));
  EXPECT_LT(axis().position, Steps(-50));
  EXPECT_EQ(wrong, 0);
  EXPECT_TRUE(axis().limit_plus) << "it has not come off it";
  ASSERT_TRUE(query("AX VL1000"));
  run(Seconds(1));
  EXPECT_TRUE(axis().limit_plus);
  EXPECT_FALSE(axis().limit_minus);
}

TEST_F(Vme58Truth, AnAxisThatLeavesTowardsPlusStoodOnTheMinusSwitch) {
  operate_limit(Sign::minus, true);
  ASSERT_EQ(move_by(200, Pps{500}).state, IntentState::done);
  EXPECT_EQ(wait().reason, "");
  run(Millis(300));
  EXPECT_EQ(axis().position, Steps(200));
  EXPECT_TRUE(axis().limit_minus);
  EXPECT_FALSE(axis().limit_plus);
}

TEST_F(Vme58Truth, TheEndOfTheUsersTextIsItsOwn) {
  place(-500, 500);
  ASSERT_EQ(move_by(900).state, IntentState::done);
  EXPECT_THAT(wait().reason, HasSubstr("limit switch"));
  ASSERT_TRUE(query("AX VL2000 MR-300 GO"));
  EXPECT_EQ(wait().reason, "") << "it came away from the switch that ended the move before";
  EXPECT_EQ(axis().position, Steps(200));
  ASSERT_TRUE(query("AX MR800 GO"));
  EXPECT_THAT(wait().reason, HasSubstr("limit switch"));
  EXPECT_EQ(axis().position, Steps(500));
}

TEST_F(Vme58Truth, AProgramThatComesAwayFromASwitchHasNotMetIt) {
  place(-500, 500);
  ASSERT_EQ(move_by(900).state, IntentState::done);
  wait();
  ASSERT_EQ(perform(intent::LoadProgram(0, "AX VL2000 MR-300 GO ID")).state, IntentState::done);
  ASSERT_EQ(perform(intent::RunProgram(0)).state, IntentState::done);
  EXPECT_EQ(wait().reason, "");
  EXPECT_EQ(now().program.ended_by, EndedBy::target);
  EXPECT_EQ(axis().position, Steps(200));
}

// ---- flags that reading clears

TEST_F(Vme58Truth, TheDoneFlagIsTheUsersToRead) {
  ASSERT_TRUE(query("AX ID"));
  run(Seconds(1));
  EXPECT_EQ(*query("AX QA"), "PDNN");
  EXPECT_EQ(*query("AX RA"), "PDNN");
  EXPECT_EQ(*query("AX RA"), "PNNN");
}

TEST_F(Vme58Truth, AMoveOfTheConsoleLeavesTheDoneFlagsOfOtherAxes) {
  ASSERT_TRUE(query("AY ID"));
  ASSERT_EQ(move_by(100).state, IntentState::done);
  EXPECT_EQ(wait().reason, "");
  EXPECT_EQ(*query("AY QA"), "PDNN");
  EXPECT_EQ(*query("AX QA"), "PDNN") << "its own says that it is there";
}

class Vme58TruthOfSteps : public Vme58Truth {
 protected:
  Vme58TruthOfSteps() { options = {{"variant", "4e"}}; }
};
TEST_F(Vme58TruthOfSteps, ASlipIsReportedOnceAndStillAnswersQuestions) {
  ASSERT_TRUE(query("AX ES20 VL2000"));
  operate(bench::Jam(AxisId{0}, true));
  ASSERT_EQ(move_by(2000).state, IntentState::done);
  wait();
  run(Seconds(1));
  const std::string reported_now = reported();
  EXPECT_THAT(reported_now, HasSubstr("Axis X has slipped"));
  EXPECT_EQ(reported_now.find("has slipped"), reported_now.rfind("has slipped")) << reported_now;
  EXPECT_EQ(*query("RL"), "SNNN");
  EXPECT_EQ(now().readouts[static_cast<std::size_t>(session->catalog().find_readout("SLIPX"))], 1);
  EXPECT_TRUE(now().axes[0].slipped);
  EXPECT_EQ(now().axes[0].trust.cause, Doubt::slipped) << "the motor is not where it was counted to";
  EXPECT_FALSE(now().axes[1].slipped);
  operate(bench::Jam(AxisId{0}, false));
  ASSERT_TRUE(query("IC AX RP"));
  run(Seconds(1));
  EXPECT_FALSE(now().axes[0].slipped) << "the flag is cleared";
}

TEST_F(Vme58TruthOfSteps, AnAxisThatASlipHasStoppedIsReportedAsSlipped) {
  ASSERT_TRUE(query("AX ES20 TN VL2000"));
  operate(bench::Jam(AxisId{0}, true));
  ASSERT_EQ(move_by(2000).state, IntentState::done);
  EXPECT_THAT(wait().reason, HasSubstr("Axis X was stopped, because it has slipped"));
}

// ---- echo

TEST_F(Vme58Truth, WithEchoOnRepliesAreWhatTheyAre) {
  ASSERT_TRUE(query("EN"));
  EXPECT_EQ(*query("AX RP"), "0");
  EXPECT_EQ(*query("WY"), "VME58 ver 2.24-8S");
  run(Seconds(2));
  EXPECT_EQ(*query("AA RP AX QA"), "0,0,0,0,0,0,0,0\nPNNN");
  ASSERT_EQ(move_by(300).state, IntentState::done);
  EXPECT_EQ(wait().reason, "");
  EXPECT_EQ(axis().position, Steps(300));
  ASSERT_TRUE(query("EF"));
  EXPECT_EQ(*query("AX RP"), "300");
  run(Seconds(1));
  EXPECT_EQ(now().link.state, LinkState::good);
  EXPECT_EQ(now().link.timeouts, 0u);
  std::string left;
  EXPECT_FALSE(session->pump().take_unsolicited(left)) << left;
}

// Another program has left the board so.
class Vme58LeftEchoing : public Vme58Truth {
 protected:
  std::unique_ptr<Window> dressed(std::unique_ptr<Window> window) override {
    int cell = 0;
    for (const char c : {'E', 'N', ' ', 'W', 'Y', ' '})
      poke(2, static_cast<std::uint16_t>(vme58::at::output_buffer + 2 * cell++),
           static_cast<unsigned char>(c));
    poke(2, vme58::at::output_put_index, static_cast<std::uint32_t>(cell));
    return window;
  }
};
TEST_F(Vme58LeftEchoing, IsFoundAllTheSame) {
  EXPECT_EQ(now().identity.model.view(), "VME58-8S");
  EXPECT_EQ(now().link.attempts, 0);
  EXPECT_EQ(*query("AX RP"), "0");
}

// ---- the end of a program, and words

TEST_F(Vme58Truth, AProgramThatTheBoardRejectsDoesNotEndWell) {
  ASSERT_EQ(perform(intent::LoadProgram(0, "AX VL1000 MA99999999 GO ID")).state, IntentState::done);
  perform(intent::RunProgram(0));
  EXPECT_THAT(wait().reason, HasSubstr("Line 1: the board rejected \"MA99999999\""));
  run(Seconds(1));
  EXPECT_EQ(now().program.run, RunState::error);
  EXPECT_THAT(std::string(now().notice.view()), HasSubstr("rejected \"MA99999999\""));
  ASSERT_EQ(move_by(100).state, IntentState::done);
  EXPECT_EQ(wait().reason, "") << "said of the program, not of what comes after it";
  EXPECT_TRUE(now().notice.empty());
}

TEST_F(Vme58Truth, ANoticeHasNoLineEndWithin) {
  ASSERT_TRUE(query("AX WT300 MR400 GO"));
  ASSERT_TRUE(query("HF")) << "the move is refused when its turn comes";
  run(Seconds(2));
  const std::string sentence = reported();
  ASSERT_THAT(sentence, HasSubstr("in a queued command or in \"HF;\""));
  EXPECT_EQ(sentence.find('\n'), sentence.size() - 1) << sentence;
}

}  // namespace
}  // namespace hw
