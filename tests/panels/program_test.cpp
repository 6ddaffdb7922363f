#include "panels/program/program.h"

#include "core/device/registry.h"
#include "tests/core/session/folder.h"
#include "tests/panels/panel_stage.h"

namespace hw::panels {
namespace {

using ::testing::HasSubstr;

struct ProgramTest : ::testing::Test {
  ProgramTest() {
    s.now.slot_bytes_used[0] = 0;
    s.stage.frames(2);
  }
  void write(const char* text) {
    s.tab.desk().programs.texts.set_text(s.tab.desk().programs.texts.chosen(), text);
    s.stage.frames(2);
  }
  gui::ProgramTexts& texts() { return s.tab.desk().programs.texts; }
  Program panel;
  test::PanelStage s{panel, 864, 480};
};

TEST_F(ProgramTest, TypingReachesTheTextAndTheMeter) {
  s.type("program/text", "I1M400, L0");
  EXPECT_EQ(texts().text(0), "I1M400, L0");
  EXPECT_EQ(s.value("program/memory"), "4 of 20 bytes");
  EXPECT_EQ(s.value("program/file"), "not in a file");
}

TEST_F(ProgramTest, RunLoadsThenRuns) {
  write("I1M400");
  s.click("program/run");
  ASSERT_TRUE(s.last<intent::LoadProgram>());
  EXPECT_EQ(s.last<intent::LoadProgram>()->slot, 0);
  EXPECT_EQ(s.last<intent::LoadProgram>()->text, "I1M400");
  EXPECT_THAT(s.reason("program/run"), HasSubstr("transferred"));
  EXPECT_THAT(s.value("program/note"), HasSubstr("Loading Program 0"));
  s.settle(IntentState::done);
  ASSERT_TRUE(s.last<intent::RunProgram>());
  s.settle(IntentState::done);
  EXPECT_THAT(s.value("program/note"), HasSubstr("The controller holds this text, loaded at"));
}

TEST_F(ProgramTest, ATransferShowsItsLinesAndTheTimeThatIsLeftAndCanBeAborted) {
  write("I1M400");
  s.click("program/run");
  EXPECT_FALSE(s.stage.find("program/abort"));
  TransferState& transfer = s.now.transfer;
  transfer.running = true, transfer.slot = 0;
  transfer.phase = TransferState::Phase::writing;
  transfer.done = 41, transfer.total = 302, transfer.left = from_seconds(14);
  s.stage.frames(2);
  EXPECT_EQ(s.value("program/note"), "Loading Program 0: 41 of 302 lines, 14 s left");
  EXPECT_THAT(s.value("program/transfer"), HasSubstr("41 of 302 lines"));
  s.click("program/abort");
  EXPECT_TRUE(s.last<intent::HaltProgram>());
  IntentOutcome outcome;
  outcome.id = 1, outcome.state = IntentState::failed;
  outcome.sentence = "A stop came first. The stored code is now neither the old program nor the new one.";
  s.now.outcomes[0] = outcome;
  transfer.running = false, s.now.slots_torn = 1;
  s.stage.frames(2);
  EXPECT_THAT(s.toast(), HasSubstr("neither the old program nor the new one"));
  EXPECT_FALSE(s.stage.find("program/transfer"));
  EXPECT_THAT(s.value("program/note"), HasSubstr("the first 41 of its 302 lines are written."));
}

TEST_F(ProgramTest, KeysDoTheSame) {
  write("I1M400");
  ASSERT_TRUE(s.stage.hand.key("Ctrl+Enter"));
  s.stage.frames(2);
  EXPECT_TRUE(s.last<intent::LoadProgram>());
  ASSERT_TRUE(s.stage.hand.key("F5"));
  s.stage.frames(3);
  EXPECT_THAT(s.value("rehearsal/result"), HasSubstr("1 min"));
}

TEST_F(ProgramTest, RunShowsWhetherItHasBeenRehearsed) {
  s.now.poll_period = std::chrono::hours(1);
  for (AxisState& a : s.now.axes) a.position_known = true, a.activity = Activity::idle;
  write("I1M400");
  EXPECT_THAT(s.value("program/rehearsed"), HasSubstr("Not rehearsed"));
  s.click("program/simulate");
  s.stage.frames(4);
  EXPECT_THAT(s.value("program/rehearsed"), HasSubstr("this text, from where the axes stand"));
  s.now.axes[0].position = Steps(77);
  s.stage.frames(2);
  EXPECT_THAT(s.value("program/rehearsed"), HasSubstr("from elsewhere"));
  write("I1M400\nI1M400");
  EXPECT_THAT(s.value("program/rehearsed"), HasSubstr("before the text was changed"));
}

TEST_F(ProgramTest, ReadableValuesAreReadBeforeARehearsal) {
  write("I1M400");
  s.now.params[1].known = false;
  s.click("program/simulate");
  EXPECT_TRUE(s.last<intent::ReadParams>());
  EXPECT_EQ(s.reason("program/simulate"), "Calculating.");
  EXPECT_EQ(s.value("program/rehearsed"), "Rehearsing.");
  const auto asked = s.sent.size();
  s.settle(IntentState::pending);
  EXPECT_EQ(s.language.rehearsed, 0);
  s.now.params[1].known = true, s.now.params[1].value = 77;
  s.settle(IntentState::done);
  EXPECT_EQ(s.language.rehearsed, 1);
  EXPECT_EQ(s.sent.size(), asked) << "once is enough";
  EXPECT_EQ(s.tab.desk().programs.rehearsals.of(0)->scene.state->param(1), 77);
  EXPECT_THAT(s.value("rehearsal/result"), HasSubstr("1 min"));
}

TEST_F(ProgramTest, UnreadableParametersDoNotHoldUpARehearsal) {
  write("I1M400");
  s.now.params[1].known = false;
  s.click("program/simulate");
  s.settle(IntentState::refused, "A program runs.");
  EXPECT_EQ(s.language.rehearsed, 1);
  s.click("program/simulate");
  EXPECT_TRUE(s.last<intent::ReadParams>());
  s.now.link.state = LinkState::lost;
  s.stage.frames(2);
  EXPECT_EQ(s.language.rehearsed, 2);
}

TEST_F(ProgramTest, RunWaitsForNoReading) {
  write("I1M400");
  s.now.params[1].known = false;
  s.click("program/run");
  EXPECT_TRUE(s.last<intent::LoadProgram>());
  EXPECT_EQ(s.language.rehearsed, 1) << "from where the run begins";
}

TEST_F(ProgramTest, SlotInUseByAnotherProgramIsAskedAbout) {
  s.now.slot_bytes_used[0] = 12;
  write("I1M400");
  s.click("program/run");
  ASSERT_TRUE(s.last<intent::UploadProgram>());
  texts().listed(0, "L9\n", s.tab.clock());
  s.settle(IntentState::done);
  ASSERT_TRUE(s.stage.find("program/ask/overwrite"));
  EXPECT_EQ(s.sent.size(), 1u);
  s.click("program/ask/leave");
  EXPECT_FALSE(s.stage.find("program/ask/overwrite"));
  EXPECT_THAT(s.toast(), HasSubstr("Nothing was sent."));
  EXPECT_EQ(texts().text(0), "I1M400");
}

TEST_F(ProgramTest, ErrorHasASentenceAndAMend) {
  write("I1\nBAD");
  ASSERT_TRUE(s.stage.find("program/problem/1"));
  EXPECT_THAT(s.value("program/note"), HasSubstr("Correct line 2"));
  EXPECT_THAT(s.reason("program/run"), HasSubstr("Line 2: BAD is no command."));
  EXPECT_THAT(s.reason("program/step"), HasSubstr("Run is available again when it is corrected."));
  ASSERT_TRUE(s.stage.hand.key("Ctrl+Enter"));
  s.stage.frames(3);
  EXPECT_TRUE(s.sent.empty());
  EXPECT_THAT(s.toast(), HasSubstr("Line 2: BAD is no command."));
  s.click("program/problem/1/fix");
  EXPECT_EQ(texts().text(0), "I1\nGOOD");
  EXPECT_FALSE(s.stage.find("program/problem/1"));
  EXPECT_EQ(s.reason("program/run"), "");
}

TEST_F(ProgramTest, AHeldProgramGoesOnWhateverIsTypedMeanwhile) {
  s.now.program.run = RunState::held, s.now.program.owned = true, s.now.program.slot = 0;
  write("I1\nBAD");
  EXPECT_EQ(s.reason("program/run"), "");
  s.click("program/run");
  EXPECT_TRUE(s.last<intent::Resume>());
}

TEST_F(ProgramTest, TooLongIsReportedByMeterAndRefusedByRun) {
  write("A,B,C,D,E,F,G,H,J,K,M");
  EXPECT_EQ(s.value("program/memory"), "22 of 20: 2 too many");
  EXPECT_THAT(s.reason("program/run"), HasSubstr("2 too many. Run is available again when it is shorter."));
  s.click("program/store");
  EXPECT_TRUE(s.sent.empty());
  EXPECT_THAT(s.toast(), HasSubstr("2 too many. Shorten it."));
  EXPECT_EQ(texts().text(0), "A,B,C,D,E,F,G,H,J,K,M");
}

struct PmxProgramTest : ::testing::Test {
  const DeviceType& type = *find_device_type("pmx-4ex-sa");
  Program panel;
  test::PanelStage s{panel, 864, 480, 1, gui::Tier::wide, true, *type.make_catalog({}), &type.language()};
};

TEST_F(PmxProgramTest, EachVerbStandsOnce) {
  s.stage.frames(2);
  for (const char* id : {"program/compile", "program/download", "program/upload", "program/empty"})
    EXPECT_TRUE(s.stage.find(id)) << id;
  for (const char* id : {"program/check", "program/store"}) EXPECT_FALSE(s.stage.find(id)) << id;
  s.click("program/more");
  EXPECT_FALSE(s.stage.find("program/more/Load from controller"));
  EXPECT_FALSE(s.stage.find("program/more/Empty in controller"));
}

TEST_F(PmxProgramTest, AProgramShownAsBlocksBecomesBlocks) {
  const gui::BlockList& blocks = s.tab.desk().blocks;
  s.tab.desk().programs.texts.set_text(0, "ABS\nX100\nWAITX\nEND\n");
  s.click("program/more");
  s.click("program/more/Show as blocks");
  s.stage.frames(4);
  ASSERT_EQ(blocks.editor.shared()->steps.size(), 2u) << s.toast();
  EXPECT_THAT(s.toast(), HasSubstr("The text has become 2 blocks"));
  s.tab.desk().programs.texts.set_text(0, "X200\nEND\n");
  s.click("program/more");
  s.click("program/more/Show as blocks");
  s.stage.frames(4);
  EXPECT_THAT(s.toast(), HasSubstr("have unsaved changes")) << "they ask first";
  EXPECT_EQ(blocks.editor.shared()->steps.size(), 2u);
}

TEST_F(ProgramTest, SlotsKeepTheirOwnTexts) {
  write("I1");
  s.click("program/slot/1");
  EXPECT_EQ(s.value("program/text"), "");
  write("L0");
  s.click("program/slot/0");
  EXPECT_EQ(s.value("program/text"), "I1");
}

TEST_F(ProgramTest, ButtonsFollowTheRun) {
  write("I1,L0");
  texts().loaded(0, "I1,L0", s.tab.clock());
  EXPECT_EQ(s.reason("program/hold"), "No program runs.");
  s.now.program.run = RunState::running, s.now.program.owned = true, s.now.program.slot = 0;
  s.stage.frames(2);
  EXPECT_THAT(s.reason("program/run"), HasSubstr("A program is running."));
  s.click("program/hold");
  EXPECT_TRUE(s.last<intent::Pause>());
  s.now.program.run = RunState::held;
  s.stage.frames(2);
  EXPECT_EQ(s.reason("program/hold"), "The program is held. Resume continues it.");
  s.click("program/step");
  EXPECT_TRUE(s.last<intent::SingleStep>());
  s.click("program/run");
  EXPECT_TRUE(s.last<intent::Resume>());
  s.click("program/stop");
  EXPECT_TRUE(s.last<intent::HaltProgram>());
}

TEST_F(ProgramTest, RehearsalShowsThatItIsOlderThanTheText) {
  write("I1\nI2\nL0");
  s.click("program/simulate");
  EXPECT_THAT(s.value("rehearsal/result"), HasSubstr("1 min 08.6 s"));
  EXPECT_EQ(s.value("rehearsal/moves"), "40");
  write("I1\nI3\nL0");
  EXPECT_EQ(s.tab.desk().programs.rehearsals.older_than_line(0, texts().text(0)), 1);
}

TEST_F(ProgramTest, SavesOpensAndReportsErrors) {
  test::Folder folder;
  write("I1M400");
  s.click("program/save");
  ASSERT_TRUE(s.stage.find("file/path"));
  s.type("file/path", (folder.path() / "scan.toy").c_str());
  s.click("file/save");
  s.stage.frames(3);
  EXPECT_EQ(folder.get("scan.toy"), "I1M400");
  EXPECT_EQ(s.value("program/file"), "scan.toy");
  write("I1M500");
  EXPECT_TRUE(texts().edited(0));
  texts().saved(0, "/dev/full", "");
  s.click("program/save");
  s.stage.frames(3);
  EXPECT_THAT(s.toast(), HasSubstr("the disk is full"));
  EXPECT_THAT(s.toast(), HasSubstr("The text is kept here"));
  EXPECT_EQ(texts().text(0), "I1M500");
  EXPECT_TRUE(texts().edited(0));
}

TEST_F(ProgramTest, AsksBeforeItOverwritesWhatAnotherProgramHasSaved) {
  test::Folder folder;
  texts().saved(0, folder.put("scan.toy", "I1M400"), "I1M400");
  write("I1M500");
  folder.put("scan.toy", "I1M999");
  s.click("program/save");
  s.stage.frames(3);
  EXPECT_EQ(folder.get("scan.toy"), "I1M999") << "not before it was asked";
  s.click("program/overwrite/no");
  s.stage.frames(3);
  EXPECT_EQ(folder.get("scan.toy"), "I1M999");
  EXPECT_TRUE(texts().edited(0));
  s.click("program/save");
  s.stage.frames(3);
  s.click("program/overwrite/yes");
  s.stage.frames(3);
  EXPECT_EQ(folder.get("scan.toy"), "I1M500");
  write("I1M600");
  s.click("program/save");
  s.stage.frames(3);
  EXPECT_EQ(folder.get("scan.toy"), "I1M600") << "its own change is no other's";
}

TEST_F(ProgramTest, ARecoveredTextAsksBeforeItTakesItsFilesPlace) {
  test::Folder folder;
  texts().restore({{0, "I1M500", folder.put("scan.toy", "I1M999")}});
  s.stage.frames(2);
  s.click("program/save");
  s.stage.frames(3);
  EXPECT_EQ(folder.get("scan.toy"), "I1M999");
  s.click("program/overwrite/yes");
  s.stage.frames(3);
  EXPECT_EQ(folder.get("scan.toy"), "I1M500");
}

TEST_F(ProgramTest, DroppedFileThatIsNoTextLeavesTheProgram) {
  test::Folder folder;
  write("I1M400");
  texts().saved(0, folder.path() / "a.toy", "I1M400");
  s.tab.desk().dropped["program"].push_back(folder.put("photo.png", std::string("\x89PNG\0\0", 6)));
  s.stage.frames(3);
  EXPECT_THAT(s.toast(), HasSubstr("photo.png is not a text"));
  EXPECT_EQ(texts().text(0), "I1M400");
  s.tab.desk().dropped["program"].push_back(folder.put("b.toy", "L0\n"));
  s.stage.frames(3);
  EXPECT_EQ(texts().text(0), "L0\n");
  EXPECT_EQ(s.value("program/file"), "b.toy");
}

TEST_F(ProgramTest, OpeningOverUnsavedTextAsks) {
  test::Folder folder;
  write("I1M400");
  s.tab.desk().dropped["program"].push_back(folder.put("b.toy", "L0\n"));
  s.stage.frames(3);
  ASSERT_TRUE(s.stage.find("program/replace/no"));
  s.click("program/replace/no");
  EXPECT_EQ(texts().text(0), "I1M400");
}

TEST(ProgramOfABoard, NothingIsOfferedThatItCannotDo) {
  Catalog c = test::toy_catalog();
  c.program.capacity = 0;
  c.can.store = false;
  Program panel;
  test::PanelStage s(panel, 864, 480, 1, gui::Tier::wide, true, c);
  s.now.slot_bytes_used[0] = 0;
  s.tab.desk().programs.texts.set_text(0, "I1M400");
  s.stage.frames(2);
  for (const char* id : {"program/store", "program/memory"}) EXPECT_EQ(s.stage.find(id), nullptr) << id;
  EXPECT_THAT(s.value("program/note"), HasSubstr("keeps no programs: Run sends this text"));
  s.click("program/more");
  EXPECT_TRUE(s.stage.find("program/more/Save as"));
  EXPECT_EQ(s.stage.find("program/more/Load from controller"), nullptr);
  EXPECT_EQ(s.stage.find("program/more/Empty in controller"), nullptr);
}

TEST_F(ProgramTest, FitsEachTier) {
  write("I1\nI2");
  for (const auto& [width, height, tier] :
       {std::tuple{704, 420, gui::Tier::medium}, std::tuple{720, 260, gui::Tier::narrow},
        std::tuple{640, 220, gui::Tier::narrow}}) {
    Program fresh;
    test::PanelStage other(fresh, width, height, 1, tier);
    other.tab.desk().programs.texts.set_text(0, "I1M400");
    other.stage.frames(3);
    for (const char* id : {"program/run", "program/hold", "program/step", "program/stop", "program/simulate",
                           "program/check", "program/open", "program/save", "program/store", "program/more",
                           "program/text", "program/memory", "rehearsal/result"}) {
      const gui::Widget* w = other.stage.find(id);
      ASSERT_TRUE(w) << id << " at " << width;
      EXPECT_GE(w->rect.min.x, 0) << id;
      EXPECT_LE(w->rect.max.x, width) << id;
      EXPECT_LE(w->rect.max.y, height) << id;
    }
  }
}

TEST(ProgramNarrow, AFileNameWithoutRoomIsReportedAtTheSlots) {
  Program panel;
  test::PanelStage s{panel, 380, 300, 1, gui::Tier::narrow};
  TextFile file;
  file.text = "I1M400";
  s.tab.desk().programs.texts.opened(0, "/tmp/a-long-name-of-a-program.toy", file);
  s.stage.frames(2);
  ASSERT_TRUE(s.stage.find("program/file"));
  EXPECT_EQ(s.value("program/file"), "a-long-name-of-a-program.toy");
  const gui::Widget* slot = s.stage.find("program/slot/0");
  ASSERT_TRUE(slot);
  EXPECT_TRUE(s.stage.find("program/file")->rect.contains(slot->rect.centre())) << "no room beside them";
}

TEST(ProgramHold, IsNotOfferedWhereTheControllerHasNoCommandForIt) {
  Catalog catalog = test::toy_catalog();
  catalog.can.single_step = false;
  catalog.program.threads = 0;
  Program panel;
  test::PanelStage s{panel, 864, 480, 1, gui::Tier::wide, true, std::move(catalog)};
  s.now.program.run = RunState::running;
  s.now.program.owned = true;
  s.stage.frames(2);
  EXPECT_THAT(s.reason("program/hold"), HasSubstr("cannot hold a program"));
}

}  // namespace
}  // namespace hw::panels
