// Several programs in one stored code: which of them a text is, and whether what is to run, pause or go on is
// there at all.
#include "tests/core/devices/arcus/driver_fixture.h"

namespace hw::arcus {
namespace {

using testing::HasSubstr;

constexpr std::string_view both[] = {"pmx-4ex-sa", "dmx-k-sa"};

class Programs : public DriverTest {
 protected:
  std::string load(int slot, std::string text) { return perform(intent::LoadProgram(slot, std::move(text))); }
  std::string held(int slot) {
    notices.clear();
    EXPECT_EQ(perform(intent::UploadProgram(slot)), "");
    return program_text();
  }
  void next_model() {
    TearDown();
    latest = Snapshot();
    notices.clear();
  }
};

// Text without PRG is program 0 (decision AMB-116).
TEST_F(Programs, ATextThatIsAnotherProgramIsNotWrittenOverThatOne) {
  for (const std::string_view model : both) {
    start(model);
    ASSERT_EQ(load(0, "X400\nWAITX\nEND\n"), "");
    EXPECT_EQ(load(1, "X401\nWAITX\nEND\n"),
              "This text is program 0; begin it with PRG 1. Nothing was written.");
    EXPECT_EQ(
        load(1, "PRG 1\nX401\nWAITX\nEND\n"),
        "The controller holds program 0 too, and a text replaces all programs. Nothing was written. Put "
        "PRG 0 and PRG 1 into one text.");
    EXPECT_EQ(held(0), "X400\nWAITX\nEND\n");
    next_model();
  }
}

TEST_F(Programs, EachOfTwoIsListedAlone) {
  for (const std::string_view model : both) {
    start(model);
    ASSERT_EQ(load(1, "PRG 0\nX100\nWAITX\nEND\nPRG 1\nX200\nEND\nSUB 3\nV1=1\nENDSUB\n"), "");
    EXPECT_EQ(held(1), "PRG 1\nX200\nEND\n");
    EXPECT_EQ(held(0), "PRG 0\nX100\nWAITX\nEND\n\nPRG 1\nX200\nEND\n\nSUB 3\nV1=1\nENDSUB\n")
        << "number 0 is the whole text";
    ASSERT_EQ(load(0, "X100\nEND\n"), "");
    EXPECT_EQ(held(1), "");
    next_model();
  }
}

TEST_F(Programs, OneWhoseTransferWasBrokenOffDoesNotRun) {
  std::string text;
  for (int n = 0; n < 100; ++n) text += "V1=" + std::to_string(n) + "\n";
  for (const std::string_view model : both) {
    start(model, {}, true);
    ASSERT_EQ(load(0, "X100\nEND\n"), "");
    const IntentId loading = post(intent::LoadProgram(0, text + "END\n"));
    ASSERT_TRUE(run_until([&] { return latest.transfer.done > 10; }, 60));
    ASSERT_EQ(perform(intent::Stop()), "");
    ASSERT_TRUE(run_until([&] { return outcome(loading) != IntentState::pending; }, 10));
    EXPECT_THAT(std::string(pump->known().outcome_of(loading)->sentence.view()),
                testing::MatchesRegex(
                    "A stop came first. The stored code is now neither the old program nor "
                    "the new one: the first [0-9]+ of its 101 lines are written, and the other "
                    "lines are those of the old program. Download the program again before it is run."));
    EXPECT_EQ(latest.slot_bytes_used[0], -1) << "how much it is, is not known";
    EXPECT_THAT(perform(intent::RunProgram(0)),
                HasSubstr("its transfer was broken off, or it reads back differently. Nothing was started."));
    EXPECT_THAT(perform(intent::RunProgram(1)), HasSubstr("Nothing was started.")) << "of the same text";
    EXPECT_EQ(position(), 0);
    ASSERT_EQ(load(0, "X100\nEND\n"), "");
    EXPECT_EQ(perform(intent::RunProgram(0)), "");
    EXPECT_TRUE(wait_idle());
    next_model();
  }
}

// Wherever it is lost: that a line is there, what it is, that it was taken.
TEST_F(Programs, OneLostAnswerBreaksNoTransferOff) {
  const std::string text = "V1=1\nV2=2\nV3=3\nEND\n";
  for (const std::string_view model : both)
    for (int after_ms = 0; after_ms < 200; after_ms += 15) {
      start(model, {}, true);
      const IntentId loading = post(intent::LoadProgram(0, text));
      ASSERT_TRUE(run_until([&] { return latest.transfer.running; }, 10));
      run(after_ms / 1000.0);
      loop->drop(1);
      ASSERT_TRUE(run_until([&] { return outcome(loading) != IntentState::pending; }, 10));
      EXPECT_EQ(outcome(loading), IntentState::done)
          << model << " after " << after_ms << " ms: " << pump->known().outcome_of(loading)->sentence.view();
      EXPECT_EQ(held(0), text);
      next_model();
    }
}

TEST_F(Programs, OneThatIsHalfWrittenWhenTheConsoleIsClosedIsNamed) {
  std::string text;
  for (int n = 0; n < 100; ++n) text += "V1=" + std::to_string(n) + "\n";
  for (const std::string_view model : both)
    for (const bool stopped : {false, true}) {
      start(model, {}, true);
      EXPECT_EQ(pump->leaves_behind(), "");
      post(intent::LoadProgram(0, text + "END\n"));
      ASSERT_TRUE(run_until([&] { return latest.transfer.done > 10; }, 60));
      if (stopped) perform(intent::Stop());
      asio::co_spawn(io, pump->shut_down(), asio::detached);
      run(1);
      EXPECT_TRUE(reported("The stored code is now neither the old program nor the new one: the first"))
          << model << stopped;
      next_model();
    }
}

TEST_F(Programs, OneThatIsWholeIsNothingLeftBehind) {
  for (const std::string_view model : both) {
    start(model);
    ASSERT_EQ(load(0, "X100\nEND\n"), "");
    EXPECT_EQ(pump->leaves_behind(), "");
    next_model();
  }
}

TEST_F(Programs, OneThatATextHasStartedIsNotWrittenOver) {
  for (const std::string_view model : both) {
    start(model);
    ASSERT_EQ(load(0, "WHILE 1=1\nV1=V1+1\nENDWHILE\nEND\n"), "");
    EXPECT_EQ(query("SR0=1"), "OK");
    EXPECT_THAT(load(0, "X300\nEND\n"),
                HasSubstr("Program 0 is running, and all programs share the stored code."));
    EXPECT_THAT(perform(intent::ClearProgram(0)), HasSubstr("Program 0 is running"));
    perform(intent::Stop());
    run(1);
    next_model();
  }
}

TEST_F(Programs, AStopBeforeTheFirstLineIsWrittenLeavesTheOldOne) {
  const auto stored = [this] { return query("SA0") + query("SA1") + query("SA2"); };
  for (const std::string_view model : both) {
    start(model, {}, true);
    int untouched = 0;
    for (double delay = 0.001; delay < 0.06; delay += 0.002) {
      ASSERT_EQ(load(0, "X100\nEND\n"), "");
      const std::string before = stored();
      const IntentId loading = post(intent::LoadProgram(0, "X300\nEND\n"));
      run(delay);
      perform(intent::Stop());
      ASSERT_TRUE(run_until([&] { return outcome(loading) != IntentState::pending; }, 10));
      if (stored() != before) break;
      ++untouched;
      EXPECT_EQ(perform(intent::RunProgram(0)), "") << delay;
      ASSERT_TRUE(wait_idle());
    }
    EXPECT_GT(untouched, 1);
    next_model();
  }
}

TEST_F(Programs, OneThatIsNotThereDoesNotRun) {
  for (const std::string_view model : both) {
    start(model);
    EXPECT_THAT(perform(intent::RunProgram(0)), HasSubstr("There is no program 0 in the stored code."));
    ASSERT_EQ(load(0, "X100\nWAITX\nEND\n"), "");
    EXPECT_EQ(perform(intent::RunProgram(0)), "");
    ASSERT_TRUE(wait_idle());
    EXPECT_EQ(position(), 100);
    EXPECT_EQ(perform(intent::RunProgram(1)),
              "There is no program 1 in the stored code. Nothing was started. Its text begins with PRG 1.");
    next_model();
  }
}

// It has ended before its state can be asked.
TEST_F(Programs, AShortProgramStoredByAnotherRuns) {
  start("dmx-k-sa");
  ASSERT_EQ(query("SA0=PRG,1"), "OK");
  ASSERT_EQ(query("SA1=SET,V1,7"), "OK");
  ASSERT_EQ(query("SA2=END"), "OK");
  EXPECT_EQ(perform(intent::RunProgram(1)), "");
  run(1);
  EXPECT_EQ(query("V1"), "7");
  EXPECT_NE(perform(intent::RunProgram(0)), "");
  ASSERT_EQ(query("SA0=PRG,0"), "OK");
  EXPECT_EQ(perform(intent::RunProgram(0)), "") << "looked at afresh";
}

TEST_F(Programs, WhereNoneRunsNothingIsPausedOrGoesOn) {
  for (const std::string_view model : both) {
    start(model);
    EXPECT_EQ(perform(intent::Pause()), "No program is running. Nothing was sent.");
    EXPECT_EQ(perform(intent::Resume()), "No program is held. Nothing was sent.");
    ASSERT_EQ(load(0, "WHILE 1=1\nV1=V1+1\nDELAY=10\nENDWHILE\nEND\n"), "");
    ASSERT_EQ(perform(intent::RunProgram(0)), "");
    EXPECT_EQ(perform(intent::Pause(1)), "Program 1 is not running. Nothing was sent.");
    EXPECT_EQ(perform(intent::Resume(0)), "Program 0 is not held. Nothing was sent.");
    EXPECT_EQ(perform(intent::Pause()), "");
    EXPECT_EQ(latest.threads[0].run, RunState::held);
    EXPECT_EQ(perform(intent::Pause()), "No program is running. Nothing was sent.");
    EXPECT_EQ(perform(intent::Resume(0)), "");
    EXPECT_EQ(latest.threads[0].run, RunState::running);
    next_model();
  }
}

}  // namespace
}  // namespace hw::arcus
