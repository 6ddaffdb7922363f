// Raw text of a user's or a script's, against a VXM that a byte sent into its answer locks until power-off.
#include "tests/core/devices/vxm/driver_fixture.h"

namespace hw::vxm {
namespace {

using testing::HasSubstr;

class VxmDriverText : public DriverTest {
 protected:
  void SetUp() override { start({{"quirk", "overrun"}}, true); }
  /// Still answering: nothing has been sent into an answer.
  bool listens() { return query("V") == "R" && latest.link.state == LinkState::good; }
};

TEST_F(VxmDriverText, NothingIsSentIntoAnAnswer) {
  for (const char* text : {"X", "lst", "x", "?", "getD0", "PM", "D", "V", "rsm"}) {
    EXPECT_EQ(send(text), "") << text;
    run(0.5);
    EXPECT_TRUE(listens()) << text;
  }
}

TEST_F(VxmDriverText, ATextWithSeveralQuestionsGoesOutInPieces) {
  EXPECT_EQ(query("XY,M"), "+0000000\r+0000000\r256");
  EXPECT_EQ(query("PM-0,I1M400,M,lst"), "252\rPM0 M252\rI1M400");
  EXPECT_EQ(query("X,R", 5), "+0000000\r^");
  EXPECT_TRUE(listens());
}

TEST_F(VxmDriverText, AnAnswerToASentTextIsThereToBeRead) {
  EXPECT_EQ(send("X"), "");
  EXPECT_EQ(unsolicited(), "+0000000");
  EXPECT_EQ(send("PM-0,I1M40,R"), "");
  EXPECT_TRUE(wait_idle());
  EXPECT_EQ(unsolicited(), "^");
}

TEST_F(VxmDriverText, WhileAProgramRunsOnlyWhatIsTakenThenIsWaitedFor) {
  EXPECT_EQ(send("PM-0,I1M4000,R"), "");
  run(0.5);
  EXPECT_EQ(query("V"), "B");
  EXPECT_THAT(query("X"), HasSubstr("+00")) << "answered while it moves";
  EXPECT_EQ(send("lst"), "") << "dropped by the controller; nobody waits for an answer";
  EXPECT_TRUE(wait_idle());
  EXPECT_TRUE(listens());
}

TEST_F(VxmDriverText, TheReplyToAQuestionRightBehindAProgramIsAwaited) {
  EXPECT_EQ(send("PM-0,I1M400,R"), "");
  int length_ms = 0;
  for (; unsolicited() != "^" && length_ms < 2000; ++length_ms) run(0.001);
  for (int ms = length_ms - 20; ms < length_ms + 20; ++ms) {
    EXPECT_EQ(send("R"), "");
    run(ms * 0.001);
    (void)query("lst");
    run(0.3);
    EXPECT_TRUE(listens()) << "asked " << ms << " ms after R";
  }
}

TEST_F(VxmDriverText, ACommandTakenBeforeADroppedQuestionIsKnown) {
  EXPECT_EQ(send("PM-0,I1M2000,I1M-9000,R"), "");
  run(0.2);
  EXPECT_EQ(send("H"), "");
  ASSERT_TRUE(run_until([&] { return latest.program.run == RunState::held; }, 5));
  EXPECT_EQ(send("H,lst"), "");
  run(0.3);
  EXPECT_EQ(latest.program.run, RunState::running);
}

TEST_F(VxmDriverText, EchoStaysOff) {
  EXPECT_EQ(send("E"), "");
  EXPECT_TRUE(reported("Echo stays off"));
  EXPECT_EQ(query("X"), "+0000000");
  EXPECT_TRUE(listens());
}

TEST_F(VxmDriverText, AnErrorReportInsteadOfAnAnswerIsTheAnswer) {
  EXPECT_EQ(query("Z"), "EB") << "no Slave: the controller restarts";
  run(2);
  EXPECT_TRUE(listens()) << "and is put on-line again";
}

TEST_F(VxmDriverText, AReplyBeforeAnErrorReportIsPassedOn) {
  EXPECT_EQ(query("XZ"), "+0000000\rEB");
  run(2);
  EXPECT_TRUE(listens());
}

TEST_F(VxmDriverText, AReplyBeforeAMissingOneIsReported) {
  std::string answer;
  bool came = false;
  asio::co_spawn(io, ask(*pump, "XY", Millis(300), answer, came), asio::detached);
  ASSERT_TRUE(run_until([&] { return sent().ends_with("Y"); }, 5)) << "X is answered, Y is asked";
  loop->drop(1000);
  ASSERT_TRUE(run_until([&] { return came; }, 5));
  EXPECT_THAT(answer, HasSubstr("Before that it answered +0000000"));
}

TEST_F(VxmDriverText, ACommandThatTheStateDropsIsReported) {
  EXPECT_EQ(send("PM-0,L5,I1M4000,R"), "");
  run(0.5);
  EXPECT_EQ(send("I1M5,X"), "");
  EXPECT_TRUE(
      reported("While a program runs the controller takes only a few letters and ignores I1M5 silently"))
      << all_notices();
  EXPECT_TRUE(wait_idle());
  EXPECT_EQ(send("Q"), "");
  EXPECT_EQ(send("X,V"), "");
  EXPECT_TRUE(reported("In local mode the controller takes only a few letters and ignores X silently"))
      << all_notices();
  EXPECT_EQ(
      query("X"),
      "fault: In local mode the controller takes only a few letters and ignores X silently. It was sent as "
      "typed.");
}

TEST_F(VxmDriverText, ADroppedCommandIsNotTakenForDone) {
  EXPECT_EQ(send("PM-0,L5,I1M4000,R"), "");
  run(0.5);
  EXPECT_EQ(send("PM3,"), "");
  EXPECT_TRUE(wait_idle());
  EXPECT_EQ(latest.program.slot, 0);
  EXPECT_EQ(send("[PM2,I3M5,]"), "");
  EXPECT_EQ(latest.program.slot, 0) << "the Slave's programs are its own";
  EXPECT_EQ(send("Q"), "");
  EXPECT_EQ(send("R"), "");
  run(1);
  EXPECT_EQ(latest.program.run, RunState::idle) << "R is dropped in Local mode";
}

TEST_F(VxmDriverText, ChangesStoredByTextAreNotCalledUnsaved) {
  EXPECT_EQ(send("setM1M4,PM-0,I1M5,"), "");
  EXPECT_TRUE(latest.unsaved_setup && latest.unsaved_programs);
  EXPECT_EQ(query("rsm", 10), "^");
  run(1);
  EXPECT_FALSE(latest.unsaved_setup || latest.unsaved_programs);
  EXPECT_EQ(send("rsm,setM1M3,"), "");
  run(1);
  EXPECT_TRUE(latest.unsaved_setup) << "set after it was stored";
}

TEST_F(VxmDriverText, AnUnconfirmedStoreIsNotCalledStored) {
  EXPECT_EQ(send("setM1M4,"), "");
  loop->operate(bench::Power(false));
  EXPECT_THAT(query("rsm", 30), HasSubstr("did not answer"));
  EXPECT_TRUE(latest.unsaved_setup);
}

TEST_F(VxmDriverText, AStopEndsTheWaitForAnAnswer) {
  std::string answer;
  bool came = false;
  asio::co_spawn(io, ask(*pump, "I1M400000,R", std::chrono::seconds(60), answer, came), asio::detached);
  run(1);
  perform(intent::Abort());
  run(0.2);
  EXPECT_TRUE(came);
  EXPECT_THAT(answer, HasSubstr("A stop ended"));
}

// The first question waits for the end of its program.
TEST_F(VxmDriverText, AStopInAQuestionWaitsForNoOther) {
  for (const char* stop : {"D", "res", "K"}) {
    SCOPED_TRACE(stop);
    std::string first, second;
    bool first_came = false, second_came = false;
    const auto spawn = [&](std::string text, std::string& answer, bool& came) {
      asio::co_spawn(io, ask(*pump, std::move(text), std::chrono::seconds(60), answer, came), asio::detached);
    };
    spawn("PM-0,I1M400000,R", first, first_came);
    run(1);
    sent();
    spawn(stop, second, second_came);
    run(0.1);
    EXPECT_THAT(sent(), testing::StartsWith(stop));
    if (stop != std::string_view("D")) {  // which ends the index; the program's own end is told to both
      EXPECT_TRUE(first_came);
      EXPECT_THAT(first, HasSubstr("A stop ended"));
    }
    run(3);
    EXPECT_FALSE(latest.any_axis_moving());
    EXPECT_TRUE(first_came);
    EXPECT_TRUE(second_came);
    EXPECT_EQ(second, std::string_view("res") == stop ? "" : "^") << "nothing tells the end of res";
    perform(intent::Abort());
    run(1);
  }
}

TEST_F(VxmDriverText, AStopInAQuestionGetsTheEndOfTheMove) {
  move_to(0, 400000);
  run(2);
  EXPECT_EQ(query("D", 10), "^");
  EXPECT_TRUE(wait_idle());
  EXPECT_EQ(latest.axes[0].ended_by, EndedBy::stop);
}

TEST_F(VxmDriverText, AStopMayHaveMoreBehindIt) {
  move_to(0, 400000);
  run(2);
  EXPECT_THAT(send("PM1,"), HasSubstr("A move from the console"));
  EXPECT_THAT(send("K,V,PM1,I1M400,"), HasSubstr("PM1,I1M400, was not sent"))
      << "which would go into the move's own program";
  EXPECT_TRUE(wait_idle());
  EXPECT_EQ(latest.program.slot, 0);
  EXPECT_EQ(query("PM,lst"), "0\rPM0 M256");
  perform(intent::MoveBy({target_of(0, 400000)}));
  run(2);
  EXPECT_THAT(query("K,Q"), HasSubstr("Q was not sent"));
  EXPECT_TRUE(wait_idle());
  EXPECT_EQ(query("V"), "R");
  send("PM-0,I1M400000,R");
  run(1);
  EXPECT_EQ(send("K,PM1,"), "");
  EXPECT_TRUE(wait_idle());
  EXPECT_EQ(latest.program.slot, 1) << "of a stored program nothing is left to do";
}

TEST_F(VxmDriverText, AKThatDidNotGetThroughHasEndedNothing) {
  send("PM-0,I1M400000,R");
  run(2);
  loop->lose(1);
  EXPECT_THAT(query("K"), HasSubstr("did not answer"));
  EXPECT_EQ(latest.program.run, RunState::running);
  EXPECT_EQ(query("K"), "^");
  run(0.5);
  EXPECT_EQ(latest.program.run, RunState::idle);
}

TEST_F(VxmDriverText, ARunRightBehindAKHasItsPrompt) {
  EXPECT_EQ(query("K"), "^");
  EXPECT_EQ(query("PM-0,I1M1,R", 5), "^");
  EXPECT_EQ(send("K"), "");
  EXPECT_EQ(query("PM-0,I1M4,R", 5), "^");
}

TEST_F(VxmDriverText, APromptOfKIsNotTheEndOfAProgram) {
  std::string answer;
  bool came = false;
  asio::co_spawn(io, ask(*pump, "PM-0,I1M400000,R", std::chrono::seconds(60), answer, came), asio::detached);
  run(1);
  EXPECT_EQ(send("K"), "");
  run(0.1);
  EXPECT_TRUE(came);
  EXPECT_THAT(answer, HasSubstr("A stop ended"));
}

TEST_F(VxmDriverText, ANeedlessEndIsNotWaitedFor) {
  for (const char* question : {"V\r", "K\r", "X,"}) {
    const Instant asked = time.now();
    EXPECT_THAT(query(question, 5), testing::AnyOf("R", "^", "+0000000")) << question;
    EXPECT_LT(time.now() - asked, std::chrono::seconds(1)) << question;
  }
}

TEST_F(VxmDriverText, AResetThatFHidesIsFound) {
  for (const bool at_once : {true, false}) {
    move_by(0, 1000);
    wait_idle();
    EXPECT_FALSE(latest.axes[0].trust.doubtful() && latest.restarts == 0);
    const std::uint32_t before = latest.restarts;
    if (at_once) {
      EXPECT_EQ(send("res,F"), "");
    } else {
      post(intent::SendText("res"));
      post(intent::SendText("F"));
    }
    run(2);
    EXPECT_EQ(latest.restarts, before + 1) << at_once;
    EXPECT_TRUE(latest.axes[0].trust.doubtful());
    EXPECT_TRUE(reported("Home the axes before the next absolute move"));
    notices.clear();
  }
}

TEST_F(VxmDriverText, ClosingBehindATypedDLeavesNothingBehind) {
  for (const char* stop : {"D", "res"}) {
    move_to(0, 400000);
    run(2);
    EXPECT_EQ(send(stop), "");
    asio::co_spawn(io, pump->shut_down(), asio::detached);
    run(9);
    EXPECT_FALSE(reported("The move goes on without the console")) << stop;
    pump.reset();
    open();
    EXPECT_EQ(query("PM4,lst,PM0,"), "PM4 M256") << stop;
  }
}

TEST_F(VxmDriverText, ClosingWaitsForNoAnswer) {
  std::string answer;
  bool came = false, closed = false;
  asio::co_spawn(io, ask(*pump, "PM-0,I1M400000,R", std::chrono::seconds(60), answer, came), asio::detached);
  run(1);
  asio::co_spawn(io, pump->shut_down(), [&](std::exception_ptr) { closed = true; });
  run(0.5);
  EXPECT_TRUE(closed && came) << answer;
  EXPECT_THAT(answer, HasSubstr("lost"));
}

TEST_F(VxmDriverText, CommandsThatChangeAProgramAreCounted) {
  for (const char* text : {"PM-0", "PM-3,I1M5", "I1M400", "C", "del1", "res"}) {
    const std::uint32_t before = latest.program_changes;
    send(text);
    run(0.5);
    EXPECT_GT(latest.program_changes, before) << text;
  }
  for (const char* text : {"X", "PM1", "setM1M4", "V"}) {
    const std::uint32_t before = latest.program_changes;
    send(text);
    run(0.5);
    EXPECT_EQ(latest.program_changes, before) << text;
  }
}

TEST_F(VxmDriverText, InLocalModeOnlyVAndDAreAnswered) {
  EXPECT_EQ(send("Q"), "");
  EXPECT_EQ(query("V"), "J");
  EXPECT_EQ(query("D"), "X+0000000\rY+0000000");
  EXPECT_EQ(query("F,V"), "R");
}

// ---- how a run of the user's ended

TEST_F(VxmDriverText, ALimitHitInAProgramIsKept) {
  AxisPlace slide;
  slide.plus = Steps(300);
  loop->operate(bench::Place(AxisId{0}, slide));
  EXPECT_EQ(send("O3,PM-0,I1M4000,I1M-10,R"), "");
  EXPECT_TRUE(wait_idle());
  EXPECT_EQ(latest.program.ended_by, EndedBy::limit);
  EXPECT_EQ(send("PM-0,I1M-50,R"), "");
  EXPECT_TRUE(wait_idle());
  EXPECT_EQ(latest.program.ended_by, EndedBy::target) << "the next run tells of itself";
}

TEST_F(VxmDriverText, TheStopButtonEndsAProgramFromElsewhere) {
  EXPECT_EQ(send("PM-0,I1M4000,P50,R"), "");
  run(0.5);
  loop->operate(bench::Button("Stop", true));
  EXPECT_TRUE(wait_idle());
  EXPECT_EQ(latest.program.ended_by, EndedBy::elsewhere);
}

// ---- what came before a question is no answer to it

TEST_F(VxmDriverText, AnOlderPromptIsLeftToBeReadAndAnswersNothing) {
  EXPECT_EQ(send("PM-0,I1M4000,R"), "");
  EXPECT_TRUE(wait_idle());
  const Instant asked = time.now();
  EXPECT_EQ(query("R", 10), "^");
  EXPECT_NEAR(seconds(time.now() - asked), 3.0, 0.05) << "the prompt of this run: 4000 steps take 3 s";
  EXPECT_TRUE(wait_idle());
  EXPECT_THAT(query("bogus", 0.2), HasSubstr("No reply came within 0.2 s."));
  EXPECT_EQ(unsolicited(), "^") << "that of the first run";
}

TEST_F(VxmDriverText, AnOlderErrorReportIsLeftToBeReadAndAnswersNothing) {
  send("Z");  // no Slave
  run(2);
  loop->drop(1000);
  EXPECT_THAT(query("X", 0.3), HasSubstr("fault: "));
  EXPECT_EQ(unsolicited(), "EB");
}

}  // namespace
}  // namespace hw::vxm
