#include "gui/model/program_texts.h"

#include <gmock/gmock.h>

#include "tests/gui/model/toy_language.h"

namespace hw::gui {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

struct ProgramTextsTest : ::testing::Test {
  std::string note() { return program_note(texts, 0, now, catalog.program, "14:02:04").sentence; }
  Catalog catalog = test::toy_catalog();
  test::ToyLanguage language;
  ProgramTexts texts{catalog.program, &language};
  Snapshot now;
};

TEST_F(ProgramTextsTest, AnalysesOnlyWhenTheTextHasChanged) {
  texts.set_text(0, "I1M400,L0");
  for (int i = 0; i < 100; ++i) EXPECT_EQ(texts.cost(0), 4);
  EXPECT_EQ(language.analysed, 1);
  texts.set_text(0, "I1M400,L0");
  texts.report(0);
  EXPECT_EQ(language.analysed, 1) << "the same text again is no change";
  texts.set_text(0, "I1M400");
  EXPECT_EQ(texts.cost(0), 2);
  EXPECT_EQ(language.analysed, 2);
}

TEST_F(ProgramTextsTest, EditedMeansDifferentFromTheFile) {
  EXPECT_FALSE(texts.edited(0));
  texts.set_text(0, "I1M400");
  EXPECT_TRUE(texts.edited(0)) << "in no file at all";
  TextFile file;
  file.text = "L0", file.dos_lines = true;
  texts.opened(0, "/tmp/scan.toy", file);
  EXPECT_FALSE(texts.edited(0));
  EXPECT_EQ(texts.file_name(0), "scan.toy");
  texts.set_text(0, "L1");
  EXPECT_TRUE(texts.edited(0));
  EXPECT_TRUE(texts.to_save(0).dos_lines);
  texts.set_text(0, "L0");
  EXPECT_FALSE(texts.edited(0)) << "typed back";
}

TEST_F(ProgramTextsTest, TextTypedWhileSavingStaysEdited) {
  texts.set_text(0, "L0");
  texts.saved(0, "/tmp/a.toy", "L0");
  EXPECT_FALSE(texts.edited(0));
  texts.set_text(0, "L1");
  texts.saved(0, "/tmp/a.toy", "L0");
  EXPECT_TRUE(texts.edited(0));
}

TEST_F(ProgramTextsTest, UnsavedTextsComeBackAsEdited) {
  texts.set_text(1, "L1");
  TextFile file;
  file.text = "L2";
  texts.opened(2, "/tmp/b.toy", file);
  ASSERT_THAT(texts.unsaved(), ElementsAre(UnsavedText{1, "L1", ""}));
  texts.set_text(2, "L3");
  ProgramTexts again(catalog.program, &language);
  again.restore(texts.unsaved());
  EXPECT_EQ(again.text(1), "L1");
  EXPECT_EQ(again.text(2), "L3");
  EXPECT_EQ(again.file_name(2), "b.toy");
  EXPECT_TRUE(again.edited(2));
  again.restore({{17, "x", ""}});
}

TEST_F(ProgramTextsTest, KnowsWhatTheControllerHolds) {
  texts.set_text(0, "; remark\nI1M400 , L0");
  EXPECT_FALSE(texts.controller_has(0));
  texts.loaded(0, texts.text(0), Instant());
  EXPECT_TRUE(texts.controller_has(0));
  texts.set_text(0, "I1M400,L0 ; other remark");
  EXPECT_TRUE(texts.controller_has(0)) << "remarks are not in the controller";
  texts.set_text(0, "I1M401,L0");
  EXPECT_FALSE(texts.controller_has(0));
  texts.set_text(0, "I1M400,L0");
  texts.doubt();
  EXPECT_FALSE(texts.controller_has(0)) << "it may have changed";
  texts.listed(0, "I1M400\nL0\n", Instant());
  EXPECT_TRUE(texts.controller_has(0));
}

TEST_F(ProgramTextsTest, LiveLineFollowsEditsAboveAndBelow) {
  texts.set_text(0, "S1\nI1,I2\nL0");
  texts.loaded(0, texts.text(0), Instant());
  EXPECT_EQ(texts.live_line(0, 0), 0);
  EXPECT_EQ(texts.live_line(0, 1), 1);
  EXPECT_EQ(texts.live_line(0, 2), 1);
  EXPECT_EQ(texts.live_line(0, 3), 2);
  texts.set_text(0, "; new\nS1\nI1,I2\nL0");
  EXPECT_EQ(texts.live_line(0, 3), 3);
  texts.set_text(0, "S1\nI1,I9\nL0");
  EXPECT_EQ(texts.live_line(0, 1), -1) << "that line is another one now";
  EXPECT_EQ(texts.live_line(0, 3), 2);
  EXPECT_EQ(texts.live_line(0, 9), -1);
  EXPECT_EQ(texts.live_line(0, -1), -1);
}

TEST_F(ProgramTextsTest, NoLineIsNamedOfAProgramChangedElsewhere) {
  texts.set_text(0, "S1\nL0");
  texts.loaded(0, texts.text(0), Instant());
  ASSERT_EQ(texts.live_line(0, 1), 1);
  texts.forget();
  EXPECT_EQ(texts.live_line(0, 1), -1);
  EXPECT_FALSE(texts.lines_known(0));
  texts.listed(0, "S1\nL0\n", Instant());
  EXPECT_EQ(texts.live_line(0, 1), 1) << "it was looked at";
}

TEST_F(ProgramTextsTest, AProgramRunningWhenTheLinkWasLostIsFollowedToItsEnd) {
  texts.set_text(0, "S1\nL0");
  texts.loaded(0, texts.text(0), Instant());
  texts.doubt();
  texts.doubt();
  EXPECT_EQ(texts.live_line(0, 1), 1);
  EXPECT_FALSE(texts.controller_has(0));
  texts.nothing_runs();
  EXPECT_EQ(texts.live_line(0, 1), -1) << "the next run may be of another program";
}

TEST_F(ProgramTextsTest, HeadingsFillOtherSlotsToo) {
  texts.set_text(0, "I1\nPM-1\nL0,L1");
  texts.loaded(0, texts.text(0), Instant());
  EXPECT_THAT(texts.held(1).listing, ElementsAre("L0", "L1"));
  EXPECT_TRUE(texts.controller_has(0));
  texts.listed(1, "L9\n", Instant());
  EXPECT_FALSE(texts.controller_has(0)) << "slot 1 belongs to this text";
}

TEST_F(ProgramTextsTest, NoteShowsWhichProgramIsHeldWhere) {
  EXPECT_EQ(note(), "");
  now.slot_bytes_used[0] = 12;
  EXPECT_THAT(
      note(),
      HasSubstr("Program 0 in the controller holds 12 bytes. Load from controller brings them here."));
  texts.set_text(0, "I1");
  EXPECT_THAT(note(), HasSubstr("Run compares them with this text first."));
  texts.listed(0, "L5\n", Instant());
  EXPECT_THAT(note(), HasSubstr("holds another program of 12 bytes"));
  texts.loaded(0, "I1", Instant());
  EXPECT_EQ(note(), "The controller holds this text, loaded at 14:02:04.");
  now.program.run = RunState::running, now.program.owned = true, now.program.slot = 0;
  texts.set_text(0, "I1\nBAD");
  EXPECT_EQ(
      note(),
      "The controller runs the text loaded at 14:02:04. It has changed since. Correct line 2 before the "
      "next run.");
}

TEST(TextDiff, FindsTheFirstChange) {
  EXPECT_EQ(TextDiff("a\nb\nc", "a\nb\nc").first_changed(), -1);
  EXPECT_EQ(TextDiff("a\nb\nc", "a\nx\nc").first_changed(), 1);
  EXPECT_EQ(TextDiff("a\nb", "a\nb\nc").first_changed(), 2);
  EXPECT_EQ(TextDiff("", "a").first_changed(), 0);
  EXPECT_EQ(TextDiff("a\nb\nc", "x\na\nb\nc").line_now(2), 3);
  EXPECT_EQ(TextDiff("a\nb\nc", "a\nc").line_now(1), -1);
  EXPECT_EQ(TextDiff("a\na\na", "a\na").line_now(0), 0);
}

TEST_F(ProgramTextsTest, CodeThatMeansNothingHereIsNeverTheSameProgram) {
  now.slot_bytes_used[0] = 4;
  texts.set_text(0, "I1M400,L0");
  texts.listed(0, "I1M400,L0", Instant(), false);
  EXPECT_FALSE(texts.controller_has(0)) << "the text leaves something out";
  EXPECT_EQ(texts.live_line(0, 0), -1) << "its lines are not those of the text";
  EXPECT_THAT(note(), HasSubstr("cannot be read here and is not in this text"));
  texts.listed(0, "I1M400,L0", Instant());
  EXPECT_TRUE(texts.controller_has(0));
}

TEST_F(ProgramTextsTest, OneByteIsNoPlural) {
  now.slot_bytes_used[0] = 1;
  EXPECT_EQ(note(), "Program 0 in the controller holds 1 byte. Load from controller brings it here.");
}

TEST(LineOf, IsOneLineWithoutItsIndent) {
  EXPECT_EQ(line_of("ABS\n  X400\n", 1), "X400");
  EXPECT_EQ(line_of("ABS", 1), "");
  EXPECT_EQ(line_of("   ", 0), "");
}

TEST_F(ProgramTextsTest, ABrokenTransferIsReportedUntilTheProgramIsLoadedAgain) {
  texts.set_text(0, "I1M400");
  now.slots_torn = 1;
  EXPECT_EQ(note(), "The controller does not hold this program. Run loads it again.");
  now.transfer.slot = 0;
  now.transfer.phase = TransferState::Phase::writing;
  now.transfer.done = 41, now.transfer.total = 302;
  EXPECT_EQ(note(),
            "The controller does not hold this program: the first 41 of its 302 lines are written. Run loads "
            "it again.");
  now.transfer.slot = 1;
  EXPECT_EQ(note(), "The controller does not hold this program. Run loads it again.") << "of another one";
  now.slots_torn = 2;
  EXPECT_EQ(note(), "");
}

}  // namespace
}  // namespace hw::gui
