// Blocks are run as a program is: rehearsed or not, held back by a doubt, with the time that is left.
#include <algorithm>

#include "tests/panels/blocks_stage.h"

namespace hw::panels {
namespace {

using ::testing::HasSubstr;

struct RunBlocks : test_blocks::BlocksStage {
  explicit RunBlocks(const char* model = "vxm") : BlocksStage(model) {
    s.now.slot_bytes_used.fill(0);
    sequence::Move move;
    move.to[0] = 4000;
    load({{move}, {sequence::Delay{500}}});
  }
  template <class T>
  int count() const {
    return static_cast<int>(std::count_if(s.sent.begin(), s.sent.end(), [](const IntentBody& body) {
      return std::holds_alternative<T>(body);
    }));
  }
};
struct RunBoardBlocks : RunBlocks {
  RunBoardBlocks() : RunBlocks("vme58") {}
};
struct RunPmxBlocks : RunBlocks {
  RunPmxBlocks() : RunBlocks("pmx-4ex-sa") {}
};

TEST_F(RunBlocks, RunShowsWhetherTheyHaveBeenRehearsedFromHere) {
  EXPECT_THAT(value("blocks/rehearsed"), HasSubstr("Rehearsed: this text"));
  EXPECT_FALSE(s.stage.find("blocks/again"));
  s.now.axes[0].position = s.now.axes[0].command = Steps(70);
  s.stage.frames(4);
  EXPECT_THAT(value("blocks/rehearsed"), HasSubstr("from elsewhere"));
  s.click("blocks/again");
  s.stage.frames(4);
  EXPECT_THAT(value("blocks/rehearsed"), HasSubstr("Rehearsed: this text"));
  s.now.axes[0].position = s.now.axes[0].command = Steps(90);
  s.stage.frames(4);
  key("F5");
  EXPECT_THAT(value("blocks/rehearsed"), HasSubstr("Rehearsed: this text"));
  EXPECT_FALSE(s.stage.find("blocks/again"));
}

TEST_F(RunBlocks, F5ReadsTheProgramsThatTheyReach) {
  s.now.slot_bytes_used.fill(-1);
  load({{sequence::Custom{"", "JM2"}}, {sequence::Delay{500}}});
  EXPECT_THAT(value("blocks/assumed"), HasSubstr("program 2"));
  EXPECT_EQ(count<intent::UploadProgram>(), 0) << "an edit reads nothing";
  key("F5");
  ASSERT_TRUE(s.last<intent::UploadProgram>());
  EXPECT_EQ(s.last<intent::UploadProgram>()->slot, 2);
  EXPECT_THAT(value("blocks/rehearsed"), HasSubstr("Rehearsing."));
  s.tab.desk().programs.texts.listed(2, "P30", s.tab.clock());
  s.settle(IntentState::done);
  s.stage.frames(6);
  EXPECT_THAT(value("blocks/assumed"), ::testing::Not(HasSubstr("program 2")));
  EXPECT_EQ(value("blocks/total"), "3.5 s");
  EXPECT_EQ(count<intent::UploadProgram>(), 1);
}

TEST_F(RunPmxBlocks, F5ReadsTheVariablesThatTheirOwnTextReads) {
  load({{sequence::Custom{"", "WHILE V7=0\nENDWHILE"}}, {sequence::Delay{3000}}});
  EXPECT_THAT(value("blocks/assumed"), HasSubstr("V7"));
  key("F5");
  for (int n = 0; n < 4 && !(s.last<intent::ReadParams>() && s.last<intent::ReadParams>()->only == "V7"); ++n)
    s.settle(IntentState::done);
  ASSERT_TRUE(s.last<intent::ReadParams>());
  EXPECT_EQ(s.last<intent::ReadParams>()->only, "V7");
  s.now.variables[7] = 3000, s.now.variables_known.set(7);
  s.settle(IntentState::done);
  s.stage.frames(6);
  EXPECT_THAT(value("blocks/total"), HasSubstr("3.0 s"));
}

TEST_F(RunBoardBlocks, F5IsRefusedWhileCommandsWait) {
  s.now.axes[0].position = s.now.axes[0].command = Steps(70);
  s.now.queue_known = 1, s.now.queue_free[0] = s.catalog.queue_depth - 1;
  s.stage.frames(4);
  key("F5");
  EXPECT_THAT(s.toast(), HasSubstr("Let the commands in the controller's queues run"));
}

TEST_F(RunPmxBlocks, ARefusalOfTheControllerStaysBesideRunUntilMended) {
  load({{sequence::Delay{500}}, {sequence::Custom{"", "DO2=1"}}});
  s.stage.frames(4);
  s.click("blocks/run");
  ASSERT_TRUE(s.last<intent::LoadProgram>()) << s.toast();
  s.settle(IntentState::failed, "Line 2: the controller answered ?DO2=1.");
  s.stage.frames(300);
  EXPECT_EQ(value("blocks/run_refused"), "Line 2: the controller answered ?DO2=1.");
  EXPECT_EQ(s.toast(), "") << "told once";
  s.click("blocks/run_refused/show");
  EXPECT_TRUE(s.stage.find("blocks/2/text"));
  s.type("blocks/2/text", "DO3=1");
  s.stage.frames(6);
  EXPECT_FALSE(s.stage.find("blocks/run_refused"));
}

TEST_F(RunBlocks, TheyAreRehearsedAsTheProgramThatTheyAreRunAs) {
  load({{sequence::Custom{"", "JM2"}}});
  s.tab.desk().programs.texts.listed(2, "I1M400", s.tab.clock());
  s.tab.desk().programs.texts.listed(0, "I2M400", s.tab.clock());
  s.tab.desk().programs.texts.choose(3);
  s.stage.frames(6);
  s.tab.desk().programs.texts.listed(3, "I1M77", s.tab.clock());
  s.stage.frames(4);
  EXPECT_THAT(value("blocks/rehearsed"), HasSubstr("Rehearsed: this text")) << "it replaces program 3";
  s.tab.desk().programs.texts.listed(2, "I1M500", s.tab.clock());
  s.stage.frames(4);
  EXPECT_THAT(value("blocks/rehearsed"), HasSubstr("another program was changed"));
}

TEST_F(RunBlocks, ADoubtIsAskedAboutBesideRun) {
  s.now.axes[0].trust.doubt(Doubt::power_cut, Instant());
  s.stage.frames(2);
  s.click("blocks/run");
  EXPECT_EQ(count<intent::LoadProgram>(), 0);
  EXPECT_THAT(value("blocks/doubt/refused"), HasSubstr("The position of motor 1 cannot be trusted"));
  EXPECT_TRUE(s.stage.find("blocks/doubt/home/-"));
  s.click("blocks/doubt/stands");
  EXPECT_TRUE(s.last<intent::TrustPosition>());
  s.click("blocks/doubt/once");
  ASSERT_TRUE(s.last<intent::LoadProgram>()) << s.toast();
  s.settle(IntentState::done);
  ASSERT_TRUE(s.last<intent::RunProgram>());
  EXPECT_TRUE(s.last<intent::RunProgram>()->despite_doubt);
}

TEST_F(RunBlocks, ConsentOutlastsTheQuestionAboutTheTextAndCoversNoNewDoubt) {
  s.tab.desk().programs.texts.set_text(0, "I2M1\n");
  s.now.axes[0].trust.doubt(Doubt::power_cut, Instant());
  s.stage.frames(2);
  s.click("blocks/run");
  s.click("blocks/doubt/once");
  ASSERT_TRUE(s.stage.find("blocks/replace/yes"));
  s.click("blocks/replace/yes");
  ASSERT_TRUE(s.last<intent::LoadProgram>()) << s.toast();
  s.now.axes[0].trust.doubt(Doubt::killed, Instant());
  s.settle(IntentState::done);
  EXPECT_EQ(count<intent::RunProgram>(), 0);
  EXPECT_THAT(value("blocks/run_refused"), HasSubstr("was not started"));
}

TEST_F(RunBlocks, TheTimeLeftStandsOverThemWhileTheyRun) {
  EXPECT_FALSE(s.stage.find("blocks/left"));
  s.tab.desk().programs.texts.set_text(0, text());
  s.tab.desk().programs.texts.loaded(0, text(), s.tab.clock());
  s.now.program = {.run = RunState::running, .owned = true, .slot = 0};
  s.now.program.started_at = s.tab.clock();
  s.stage.frames(6);
  EXPECT_THAT(value("blocks/left"), HasSubstr(" s left"));
}

TEST_F(RunBlocks, BlocksThatTheControllerNeverDoesAreGreyWithAReason) {
  EXPECT_THAT(s.reason("blocks/add/arc"), HasSubstr("draws no arcs"));
  EXPECT_THAT(s.reason("blocks/add/enable"), HasSubstr("motor power of a VXM"));
  EXPECT_EQ(s.reason("blocks/add/move"), "");
  s.type("blocks/add_by_name", "arc");
  const std::size_t before = editor().sequence().steps.size();
  EXPECT_TRUE(s.stage.hand.key("enter"));
  s.stage.frames(2);
  EXPECT_EQ(editor().sequence().steps.size(), before) << "nothing of that name can be added";
}

TEST_F(RunBoardBlocks, BlocksThatNeedOthersBeforeThemAreOffered) {
  for (const char* id : {"arc", "circle", "jog", "speed_stairs"})
    EXPECT_EQ(s.reason((std::string("blocks/add/") + id).c_str()), "") << id;
}

TEST_F(RunPmxBlocks, OfAPmxAllObjectsOfTheManualAreOffered) {
  for (const char* id :
       {"speed", "move", "jog", "home", "stop", "wait_motion", "delay", "wait_input", "move_on_input",
        "output", "enable", "custom", "circle", "arc", "loop", "comment", "pen"})
    EXPECT_EQ(s.reason((std::string("blocks/add/") + id).c_str()), "") << id;
}

}  // namespace
}  // namespace hw::panels
