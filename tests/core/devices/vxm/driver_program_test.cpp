#include "tests/core/devices/vxm/driver_fixture.h"

namespace hw::vxm {
namespace {

using testing::HasSubstr;

class VxmDriverProgram : public DriverTest {};

TEST_F(VxmDriverProgram, LoadsReadsBackAndCompares) {
  start();
  EXPECT_EQ(perform(intent::LoadProgram(1, "; a remark\nS1M2000, A1M2 ; at speed\nI1M400\nP1,L5\n")), "");
  EXPECT_EQ(latest.slot_bytes_used[1], 15);
  EXPECT_TRUE(latest.unsaved_programs);
  EXPECT_EQ(latest.program.slot, 0) << "the user's selection is put back";
  EXPECT_EQ(perform(intent::UploadProgram(1)), "");
  ASSERT_FALSE(notices.empty());
  EXPECT_EQ(notices.back().kind, Notice::Kind::program);
  EXPECT_EQ(notices.back().slot, 1);
  EXPECT_EQ(notices.back().text, "S1M2000\nA1M2\nI1M400\nP1\nL5\n");
  EXPECT_EQ(query("PM"), "0");
}

TEST_F(VxmDriverProgram, ALimitBehindWhichItGoesOnIsReportedAtOnce) {
  start();
  EXPECT_EQ(perform(intent::SetParam("O", 1)), "");
  perform(intent::LoadProgram(0, "S1M2000\nI1M8000\nI2M8000\n"));
  EXPECT_EQ(perform(intent::RunProgram(0)), "");
  run(1.0);
  ASSERT_TRUE(loop->operate(bench::Limit(AxisId{0}, Sign::plus, true)));
  run(0.5);
  EXPECT_TRUE(reported("its program continues")) << all_notices();
}

TEST_F(VxmDriverProgram, OneThatALimitCutsEndsOnIt) {
  start();
  perform(intent::LoadProgram(0, "S1M2000\nI1M8000\n"));
  EXPECT_EQ(perform(intent::RunProgram(0)), "");
  run(1.0);
  ASSERT_TRUE(loop->operate(bench::Limit(AxisId{0}, Sign::plus, true)));
  EXPECT_TRUE(wait_idle());
  run(0.5);
  EXPECT_EQ(latest.axes[0].ended_by, EndedBy::limit);
  EXPECT_EQ(latest.program.ended_by, EndedBy::limit);
  EXPECT_FALSE(reported("limit")) << "its end tells: " << all_notices();
}

TEST_F(VxmDriverProgram, OneThatReachesItsEndEndsThere) {
  start();
  perform(intent::LoadProgram(0, "S1M2000\nI1M400\n"));
  EXPECT_EQ(perform(intent::RunProgram(0)), "");
  EXPECT_TRUE(wait_idle());
  run(0.5);
  EXPECT_EQ(latest.program.ended_by, EndedBy::target);
}

TEST_F(VxmDriverProgram, ATextWithHeadingsFillsItsPrograms) {
  start();
  EXPECT_EQ(
      perform(intent::LoadProgram(
          -1, "E\nPM-1 ;Select and clear Program 1\nS1M4000\nIA1M0\n\nPM-0\nU12\nJ1\nS1M2000\nI1M8000\nR\n")),
      "");
  EXPECT_EQ(latest.slot_bytes_used[0], 2 + 2 + 3 + 4);
  EXPECT_EQ(latest.slot_bytes_used[1], 7);
  EXPECT_EQ(position(), 0) << "R in a text runs nothing";
  EXPECT_TRUE(reported("Not part of a program and so not sent: R in line 11."));
}

TEST_F(VxmDriverProgram, OnlyAMotorThatTheProgramTurnsIsWarnedOf) {
  start();
  perform(intent::LoadProgram(0, "S2M1000\nI1M7\n"));
  EXPECT_EQ(perform(intent::RunProgram(0)), "");
  EXPECT_TRUE(reported("Choose the type of motor 1 in Setup"));
  EXPECT_FALSE(reported("the type of motor 2"));
}

TEST_F(VxmDriverProgram, RefusesAWrongLineBeforeAnythingIsSent) {
  start();
  perform(intent::LoadProgram(0, "I1M7\n"));
  sent();
  EXPECT_EQ(perform(intent::LoadProgram(0, "I1M400\nS2M8000\n")),
            "Line 2: S2M8000 is not possible: it takes 1 to 6000 steps/s. Nothing was sent; the controller "
            "keeps its programs. Correct the line and load it again.");
  EXPECT_EQ(perform(intent::LoadProgram(0, "I1M400\nMOVE 3\n")).substr(0, 8), "Line 2: ");
  EXPECT_THAT(perform(intent::LoadProgram(-1, "I1M400\n")),
              HasSubstr("Line 1: it comes before the first program heading"));
  EXPECT_EQ(sent(), "");
  EXPECT_EQ(query("M"), "252");
}

TEST_F(VxmDriverProgram, RefusesATooLongProgramWithNumbers) {
  start();
  std::string text;
  for (int i = 0; i < 65; ++i) text += "I1M400\n";
  EXPECT_EQ(perform(intent::LoadProgram(3, text)),
            "Program 3 needs 260 bytes, 4 more than the 256 that it has. Nothing was sent; the controller "
            "keeps its programs. "
            "Shorten the program, or move a part into another program (JM).");
  EXPECT_EQ(latest.slot_bytes_used[3], 0);
}

TEST_F(VxmDriverProgram, FillsAProgramToItsLastByte) {
  start({}, true);
  std::string text;
  for (int i = 0; i < 64; ++i) text += "I1M400\n";
  EXPECT_EQ(perform(intent::LoadProgram(3, text)), "");
  EXPECT_EQ(latest.slot_bytes_used[3], 256);
}

TEST_F(VxmDriverProgram, APairForTwoControllersIsWrittenAsOne) {
  start({{"motors", "4"}});
  EXPECT_EQ(perform(intent::LoadProgram(0, "(I3M800,I1M400,)\nSA1M-12\n")), "");
  EXPECT_EQ(latest.slot_bytes_used[0], 13);
}

TEST_F(VxmDriverProgram, RunsAndReportsTheEnd) {
  start();
  ASSERT_EQ(perform(intent::LoadProgram(2, "I1M400\nI2M200\n")), "");
  EXPECT_EQ(perform(intent::RunProgram(2)), "");
  EXPECT_EQ(latest.program.run, RunState::running);
  EXPECT_TRUE(latest.program.owned);
  EXPECT_EQ(latest.program.slot, 2);
  EXPECT_TRUE(wait_idle());
  EXPECT_EQ(position(0), 400);
  EXPECT_EQ(position(1), 200);
  EXPECT_EQ(unsolicited(), "^");
  EXPECT_EQ(perform(intent::RunProgram(1)),
            "Program 1 of the controller is empty. Nothing was run. Load it first.");
}

TEST_F(VxmDriverProgram, StepsThroughAndKnowsTheLiveCommand) {
  start();
  ASSERT_EQ(perform(intent::LoadProgram(0, "I1M100\nI2M50\nI1M100\n")), "");
  EXPECT_EQ(perform(intent::SingleStep()), "");
  run(0.2);
  EXPECT_EQ(latest.program.run, RunState::held);
  EXPECT_EQ(latest.program.command, 0);
  EXPECT_FALSE(latest.program.command_reported) << "I1M100 stands there twice";
  EXPECT_EQ(position(), 0) << "nothing moves before the next step";
  EXPECT_EQ(perform(intent::SingleStep()), "");
  run(2);
  EXPECT_EQ(position(), 100);
  EXPECT_EQ(latest.program.command, 1);
  EXPECT_TRUE(latest.program.command_reported);
  EXPECT_EQ(perform(intent::SingleStep()), "");
  run(2);
  EXPECT_EQ(latest.program.command, 2);
  EXPECT_EQ(perform(intent::Resume()), "");
  EXPECT_TRUE(wait_idle());
  EXPECT_EQ(position(), 200);
  EXPECT_FALSE(latest.program.stepping);
}

// A second H would let the program go on: the stop must not say it when the first may have got through.
TEST_F(VxmDriverProgram, AStopEndsAProgramWhoseHoldWentWithTheWire) {
  start({}, true);
  ASSERT_EQ(perform(intent::LoadProgram(0, "S1M1000\nI1M4000\nI1M-4000\nL0\n")), "");
  for (int i = 0; i < 80; ++i) {
    ASSERT_EQ(perform(intent::RunProgram(0)), "");
    run(0.5 + i % 7 * 0.001);
    i % 2 != 0 ? post(intent::Pause()) : post(intent::Stop());
    run(i / 2 * 0.0005);
    loop->pull();
    run(0.01);
    ASSERT_TRUE(run_until([&] { return latest.link.state == LinkState::good; })) << i;
    const Instant asked = time.now();
    EXPECT_EQ(perform(intent::Stop()), "") << i;
    EXPECT_LT(time.now() - asked, std::chrono::seconds(2)) << i;
    run(0.3);
    const auto there = position();
    run(6);
    EXPECT_EQ(position(), there) << i;
    EXPECT_EQ(latest.program.run, RunState::idle);
  }
}

TEST_F(VxmDriverProgram, PausesBetweenTwoCommandsAndGoesOn) {
  start();
  ASSERT_EQ(perform(intent::LoadProgram(0, "I1M1000\nI1M1000\nI1M1000\n")), "");
  ASSERT_EQ(perform(intent::RunProgram(0)), "");
  run(0.3);
  EXPECT_EQ(perform(intent::Pause()), "");
  run(5);
  EXPECT_EQ(latest.program.run, RunState::held);
  EXPECT_EQ(position(), 1000);
  EXPECT_EQ(perform(intent::Resume()), "");
  EXPECT_TRUE(wait_idle());
  EXPECT_EQ(position(), 3000);
}

TEST_F(VxmDriverProgram, AWaitForTheHostGoesOnWithResume) {
  start();
  ASSERT_EQ(perform(intent::LoadProgram(0, "U6\nI1M100\n")), "");
  ASSERT_EQ(perform(intent::RunProgram(0)), "");
  run(0.3);
  EXPECT_EQ(latest.program.run, RunState::waiting);
  EXPECT_EQ(unsolicited(), "W");
  EXPECT_EQ(perform(intent::Resume()), "");
  EXPECT_TRUE(wait_idle());
  EXPECT_EQ(position(), 100);
}

TEST_F(VxmDriverProgram, AHoldLeftOnDoesNotHoldAMoveOfTheConsole) {
  start();
  EXPECT_EQ(send("H"), "");
  EXPECT_EQ(move_by(0, 100), "");
  EXPECT_TRUE(wait_idle());
  EXPECT_EQ(position(), 100);
}

TEST_F(VxmDriverProgram, AnErrorOfTheControllerIsExplainedAndWaitsForTheUser) {
  start();
  ASSERT_EQ(perform(intent::LoadProgram(0, "U7\nI1M100\n")), "");
  ASSERT_EQ(perform(intent::RunProgram(0)), "");
  run(2);
  EXPECT_EQ(latest.program.run, RunState::error);
  EXPECT_EQ(latest.axes[0].activity, Activity::error);
  EXPECT_THAT(std::string(latest.notice.view()),
              HasSubstr("The controller reports EC: nonstop indexing has no U9"));
  EXPECT_THAT(move_by(0, 10),
              HasSubstr("The controller accepts nothing until it receives K. Nothing was sent. Press Stop"));
  EXPECT_EQ(latest.link.state, LinkState::good) << "it was not asked in vain";
  sent();
  EXPECT_EQ(perform(intent::Stop()), "");
  EXPECT_EQ(sent(), "K");
  EXPECT_EQ(latest.program.run, RunState::idle);
  EXPECT_EQ(move_by(0, 10), "");
  EXPECT_TRUE(wait_idle());
}

TEST_F(VxmDriverProgram, AFullMemoryWaitsForKWhichTheTerminalMaySend) {
  start({{"quirk", "e-bar"}});
  std::string text;
  for (int i = 0; i < 65; ++i) text += "I1M400,";
  EXPECT_EQ(send(text), "");
  run(0.5);
  EXPECT_THAT(std::string(latest.notice.view()),
              HasSubstr("The controller reports EM: the program memory is full"));
  EXPECT_EQ(latest.program.run, RunState::error);
  run(5);
  EXPECT_NE(latest.link.state, LinkState::lost) << "it is not asked in vain again and again";
  EXPECT_EQ(send("K"), "");
  run(1);
  EXPECT_EQ(latest.link.state, LinkState::good);
  EXPECT_EQ(latest.program.run, RunState::idle);
  EXPECT_EQ(latest.slot_bytes_used[0], 256);
  EXPECT_EQ(query("V"), "R");
}

TEST_F(VxmDriverProgram, ABusErrorIsExplainedAndTheRestartNoticed) {
  start();
  EXPECT_EQ(send("I3M400,R"), "");
  run(2);
  EXPECT_TRUE(reported(
      "The controller reports EB: it met a command for motor 3 or 4, but no second controller answers"));
  EXPECT_TRUE(reported("the controller was switched off and on, or reset"));
  EXPECT_EQ(latest.link.state, LinkState::good);
  EXPECT_EQ(latest.program.run, RunState::idle);
  EXPECT_EQ(move_by(0, 10), "");
  EXPECT_TRUE(wait_idle());
}

TEST_F(VxmDriverProgram, FactoryDefaultsAreNoticed) {
  start();
  perform(intent::LoadProgram(0, "I1M10\n"));
  perform(intent::SetParam("j1M", 77));
  EXPECT_EQ(send("setD0,"), "");
  run(4);
  EXPECT_TRUE(reported("The controller reports EN: its memory was erased."));
  EXPECT_EQ(latest.slot_bytes_used[0], 0);
  EXPECT_EQ(latest.params[catalog.find_param("j1M")].value, 2000);
}

TEST_F(VxmDriverProgram, TheStopButtonEndsAProgramAndIsNamed) {
  start();
  ASSERT_EQ(perform(intent::LoadProgram(0, "I1M9000\nI1M9000\n")), "");
  ASSERT_EQ(perform(intent::RunProgram(0)), "");
  run(1);
  ASSERT_TRUE(loop->operate(bench::Button("Stop", true)));
  run(0.1);
  ASSERT_TRUE(loop->operate(bench::Button("Stop", false)));
  EXPECT_TRUE(wait_idle());
  EXPECT_TRUE(reported("The controller reports ES: the Stop button or input 4 ended the program."));
  EXPECT_LT(position(), 9000);
}

TEST_F(VxmDriverProgram, LinesThatTheControllerDidNotGetAreFound) {
  start();
  // What reads back garbled is asked for once more; what then differs is told.
  loop->garble(0);
  ASSERT_EQ(perform(intent::LoadProgram(0, "I1M400\n")), "");
  const IntentId load = ++last_id;
  pump->post(Intent(load, intent::LoadProgram(0, "I1M400\nI1M500\n")));
  run_until([&] { return loop->to_controller.ends_with("lst"); }, 2);
  loop->garble(400);
  run(3);
  EXPECT_EQ(outcome(load), IntentState::failed);
  EXPECT_THAT(std::string(pump->known().outcome_of(load)->sentence.view()),
              HasSubstr("Load it again before it is run."));
}

// Of a program that is not what was sent nobody knows what it does, until it is sent again or read.
TEST_F(VxmDriverProgram, OneThatIsNotWhatWasSentIsNotRun) {
  start({}, true);
  ASSERT_EQ(perform(intent::LoadProgram(0, "I2M40\n")), "");
  const auto tear = [&] {
    const IntentId load = post(intent::LoadProgram(2, "I1M400\nI1M500\n"));
    ASSERT_TRUE(run_until([&] { return loop->to_controller.ends_with("I1M400\r"); }, 2));
    EXPECT_EQ(perform(intent::Stop()), "");
    run(3);
    ASSERT_EQ(outcome(load), IntentState::failed);
    loop->to_controller.clear();
  };
  tear();
  EXPECT_EQ(
      perform(intent::RunProgram(2)),
      "Program 2 in the controller differs from the text sent last: its transfer was broken off, or it reads "
      "back differently. Nothing was started. Load it again, read it, or run it once as it is.");
  EXPECT_EQ(perform(intent::RunProgram(0)), "") << "another one";
  EXPECT_TRUE(wait_idle());
  ASSERT_EQ(perform(intent::SelectProgram(2)), "");
  EXPECT_THAT(perform(intent::SingleStep()), HasSubstr("Nothing was started."));
  EXPECT_EQ(position(), 0);

  EXPECT_EQ(perform(intent::UploadProgram(2)), "");
  EXPECT_EQ(perform(intent::RunProgram(2)), "") << "it was read";
  EXPECT_TRUE(wait_idle());

  tear();
  ASSERT_EQ(perform(intent::LoadProgram(2, "I1M40\n")), "");
  EXPECT_EQ(perform(intent::RunProgram(2)), "") << "it was sent again";
  EXPECT_TRUE(wait_idle());

  tear();
  intent::RunProgram request(2);
  request.as_it_is = true;
  EXPECT_EQ(perform(request), "") << "on the user's word";
  EXPECT_TRUE(wait_idle());
  EXPECT_THAT(perform(intent::RunProgram(2)), HasSubstr("Nothing was started.")) << "once";
}

TEST_F(VxmDriverProgram, ResumeIsRefusedWhileAProgramWaitsForAnInput) {
  start();
  ASSERT_EQ(perform(intent::LoadProgram(0, "U0\nI1M400\n")), "");
  ASSERT_EQ(perform(intent::RunProgram(0)), "");
  run(1);
  sent();
  EXPECT_THAT(perform(intent::Resume()),
              HasSubstr("it is not held and does not wait for G. Nothing was sent."));
  EXPECT_EQ(sent(), "");
  loop->operate(bench::Input(1, true));
  EXPECT_TRUE(wait_idle());
  EXPECT_EQ(position(), 400);
}

TEST_F(VxmDriverProgram, ATextThatStoresNothingIsRefused) {
  start();
  ASSERT_EQ(perform(intent::LoadProgram(0, "I1M7\n")), "");
  sent();
  EXPECT_EQ(perform(intent::LoadProgram(0, "Q Z\n!\n")),
            "Nothing in this text is part of a program: Q in line 1, Z in line 1, ! in line 2. Nothing was "
            "sent; the controller keeps its programs. Commands that act at once are sent, not loaded.");
  EXPECT_EQ(sent(), "");
  EXPECT_EQ(query("M"), "252");
  EXPECT_EQ(perform(intent::LoadProgram(-1, "PM-0\nR\n")), "") << "emptied on purpose";
  EXPECT_EQ(query("M"), "256");
}

}  // namespace
}  // namespace hw::vxm
