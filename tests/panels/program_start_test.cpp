// One text may hold several programs: Run starts the one that is chosen, and Simulate tries that one.
#include "core/device/registry.h"
#include "panels/program/program.h"
#include "tests/panels/panel_stage.h"

namespace hw::panels {
namespace {

using ::testing::HasSubstr;

struct ProgramStart : ::testing::Test {
  ProgramStart() {
    s.now.axis_count = 4;
    s.now.slot_bytes_used.fill(0);
    for (AxisState& a : s.now.axes) a.position_known = true, a.activity = Activity::idle;
    for (ThreadState& t : s.now.threads) t.known = true;
  }
  void put(const char* text) {
    s.tab.desk().programs.texts.set_text(0, text);
    s.stage.frames(2);
  }
  void rehearse() {
    ASSERT_TRUE(s.stage.hand.key("F5"));
    s.stage.frames(4);
  }
  const gui::Rehearsals::Outcome* outcome(int program) {
    return s.tab.desk().programs.rehearsals.of(program);
  }

  static constexpr const char* both = "PRG 0\nABS\nX100\nWAITX\nEND\nPRG 1\nABS\nY200\nWAITY\nEND\n";
  const DeviceType& pmx = *find_device_type("pmx-4ex-sa");
  Program panel;
  test::PanelStage s{panel, 1440, 900, 1, gui::Tier::wide, true, *pmx.make_catalog({}), &pmx.language()};
};

TEST_F(ProgramStart, TheChosenOneIsTriedAndRun) {
  put(both);
  rehearse();
  ASSERT_TRUE(outcome(0) && outcome(0)->result);
  EXPECT_EQ(outcome(0)->result->axes[0].position, 100);
  EXPECT_EQ(outcome(0)->result->axes[1].position, 0);
  s.click("program/start/1");
  EXPECT_THAT(s.value("program/rehearsed"), HasSubstr("Not rehearsed")) << "that was the other one";
  rehearse();
  ASSERT_TRUE(outcome(1) && outcome(1)->result);
  EXPECT_EQ(outcome(1)->result->axes[0].position, 0);
  EXPECT_EQ(outcome(1)->result->axes[1].position, 200);
  EXPECT_THAT(s.value("program/rehearsed"), HasSubstr("Rehearsed: this text"));
  s.click("program/run");
  ASSERT_TRUE(s.last<intent::LoadProgram>());
  EXPECT_EQ(s.last<intent::LoadProgram>()->slot, 0) << "all of the text";
  s.settle(IntentState::done);
  ASSERT_TRUE(s.last<intent::RunProgram>());
  EXPECT_EQ(s.last<intent::RunProgram>()->slot, 1);
}

TEST_F(ProgramStart, OfATextWithoutProgram0ItsFirstIsStarted) {
  put("PRG 2\nABS\nY200\nWAITY\nEND\n");
  rehearse();
  ASSERT_TRUE(outcome(2) && outcome(2)->result);
  EXPECT_EQ(outcome(2)->result->axes[1].position, 200);
  s.click("program/run");
  s.settle(IntentState::done);
  ASSERT_TRUE(s.last<intent::RunProgram>());
  EXPECT_EQ(s.last<intent::RunProgram>()->slot, 2);
}

TEST_F(ProgramStart, NothingIsAskedWhereThereIsOnlyTheFirst) {
  put("ABS\nX100\nEND\n");
  EXPECT_FALSE(s.stage.find("program/start/0"));
  put(both);
  EXPECT_TRUE(s.stage.find("program/start/0"));
}

TEST_F(ProgramStart, RunOfAThreadShowsWhetherTheHeldTextHasBeenRehearsed) {
  put(both);
  EXPECT_THAT(s.value("thread/1/rehearsed"), HasSubstr("Upload to read"));
  s.tab.desk().programs.texts.loaded(0, both, s.tab.clock());
  s.stage.frames(2);
  EXPECT_THAT(s.value("thread/1/rehearsed"), HasSubstr("Not rehearsed"));
  EXPECT_THAT(s.value("thread/3/rehearsed"), HasSubstr("holds no program with this number"));
  s.click("program/start/1");
  rehearse();
  EXPECT_THAT(s.value("thread/1/rehearsed"), HasSubstr("Rehearsed: this text"));
  EXPECT_THAT(s.value("thread/0/rehearsed"), HasSubstr("Not rehearsed"));
  s.now.axes[1].position = s.now.axes[1].command = Steps(7);
  s.stage.frames(2);
  EXPECT_THAT(s.value("thread/1/rehearsed"), HasSubstr("from elsewhere"));
  s.now.axes[1].position = s.now.axes[1].command = Steps(0);
  s.now.threads[0].run = RunState::held;
  s.stage.frames(2);
  EXPECT_THAT(s.value("thread/1/rehearsed"), HasSubstr("another program is running now"));
  s.now.threads[0].run = RunState::idle;
  put("PRG 1\nABS\nY300\nWAITY\nEND\n");
  rehearse();
  EXPECT_THAT(s.value("thread/1/rehearsed"), HasSubstr("another text than the rehearsed one"));
}

// What it starts is loaded with it, so its own loading is no change of another program.
TEST_F(ProgramStart, LoadingTheTextDoesNotMakeItsRehearsalOld) {
  s.tab.desk().programs.texts.loaded(0, "ABS\nX1\nEND\n", s.tab.clock());
  put(both);
  s.click("program/start/1");
  rehearse();
  s.tab.desk().programs.texts.loaded(0, both, s.tab.clock());
  s.stage.frames(2);
  EXPECT_THAT(s.value("program/rehearsed"), HasSubstr("Rehearsed: this text"));
}

TEST_F(ProgramStart, TheCardShowsTheMemory) {
  put(both);
  rehearse();
  EXPECT_THAT(s.value("rehearsal/memory"), HasSubstr(" of 1275 lines"));
}

}  // namespace
}  // namespace hw::panels
