// What was typed into a block and cannot be taken stays with it, and keeps the blocks from being run.
#include "tests/panels/blocks_stage.h"

namespace hw::panels {
namespace {

using ::testing::HasSubstr;

struct DraftsOfBlocks : test_blocks::BlocksStage {
  /// Output 1, a delay, another one; and 99 typed where the number of the output stands.
  void type_wrong_number() {
    load({{sequence::Output{1, true}}, {sequence::Delay{500}}, {sequence::Delay{700}}});
    s.click("blocks/1");
    s.type("blocks/1/output", "99\n");
  }
};

TEST_F(DraftsOfBlocks, AWrongNumberStaysWhenItsBlockIsClosedAndIsReportedThere) {
  type_wrong_number();
  s.click("blocks/2");
  EXPECT_EQ(value("blocks/1/refusal"), "Output: 0 to 64 only. Correct it before the next run.");
  EXPECT_EQ(value("blocks/1/time"), "not taken");
  EXPECT_EQ(s.reason("blocks/run"), "Correct block 1 first. Output: 0 to 64 only.");
  EXPECT_EQ(s.reason("blocks/run_here"), "Correct block 1 first. Output: 0 to 64 only.");
  EXPECT_EQ(s.reason("blocks/to_program"), "Correct block 1 first. Output: 0 to 64 only.");
  s.click("blocks/1");
  EXPECT_FALSE(s.stage.find("blocks/1/refusal")) << "it stands beside its field";
  EXPECT_EQ(value("blocks/1/output"), "99");
  s.type("blocks/1/output", "5\n");
  EXPECT_EQ(s.reason("blocks/to_program"), "");
  s.click("blocks/2");
  EXPECT_FALSE(s.stage.find("blocks/1/refusal"));
  EXPECT_THAT(text(), HasSubstr("DO5=1"));
}

TEST_F(DraftsOfBlocks, ItGoesWithItsBlockWhereverThatIsMoved) {
  type_wrong_number();
  key("alt+down");
  EXPECT_EQ(value("blocks/2/output"), "99");
  s.click("blocks/3");
  EXPECT_THAT(value("blocks/2/refusal"), HasSubstr("0 to 64 only"));
  s.click("blocks/1");
  key("ctrl+d");
  s.click("blocks/end");
  EXPECT_THAT(value("blocks/3/refusal"), HasSubstr("0 to 64 only")) << "one more stands before it";
  EXPECT_THAT(s.reason("blocks/run"), HasSubstr("Correct block 3 first."));
}

TEST_F(DraftsOfBlocks, OneThatComesToThePlaceOfAnotherTakesNothingFromIt) {
  load({{sequence::Output{1, true}}, {sequence::Output{2, true}}, {sequence::Delay{700}}});
  s.click("blocks/2");
  s.type("blocks/2/output", "98\n");
  s.click("blocks/1");
  s.type("blocks/1/output", "99\n");
  key("alt+down");
  EXPECT_EQ(value("blocks/2/output"), "99");
  EXPECT_THAT(value("blocks/1/refusal"), HasSubstr("0 to 64 only"));
  s.click("blocks/1");
  EXPECT_EQ(value("blocks/1/output"), "98");
  EXPECT_THAT(value("blocks/2/refusal"), HasSubstr("0 to 64 only"));
}

TEST_F(DraftsOfBlocks, ItGoesWhenItsBlockGoesOrOtherBlocksAreOpened) {
  type_wrong_number();
  key("delete");
  EXPECT_EQ(s.reason("blocks/to_program"), "");
  type_wrong_number();
  s.click("blocks/2");
  ASSERT_TRUE(s.stage.find("blocks/1/refusal"));
  load({{sequence::Output{1, true}}});
  EXPECT_FALSE(s.stage.find("blocks/1/refusal"));
  EXPECT_EQ(s.reason("blocks/to_program"), "");
}

TEST_F(DraftsOfBlocks, OfSeveralRefusedBlocksEachHasItsPlace) {
  sequence::Move far;
  far.to[0] = 1e9;
  load({{sequence::Output{1, true}}, {far}, {sequence::Delay{700}}});
  const float plain = s.stage.find("blocks/3")->rect.min.y;
  s.click("blocks/1");
  s.type("blocks/1/output", "99\n");
  s.click("blocks/end");
  const gui::Rect last = s.stage.find("blocks/3")->rect, sentence = s.stage.find("blocks/1/refusal")->rect;
  EXPECT_GT(last.min.y, plain + 20) << "there is room for what is told";
  EXPECT_LT(sentence.max.y, s.stage.find("blocks/2")->rect.min.y + 1);
}

struct FieldsOfBlocks : test_blocks::BlocksStage {
  FieldsOfBlocks() : BlocksStage("pmx-4ex-sa") {}
};

TEST_F(FieldsOfBlocks, AMoveOnAnInputAsksOnlyForWhatItsMotionHas) {
  load({{sequence::MoveOnInput{}}});
  s.click("blocks/1");
  EXPECT_TRUE(s.stage.find("blocks/1/to"));
  EXPECT_FALSE(s.stage.find("blocks/1/direction/+"));
  s.click("blocks/1/kind/home");
  EXPECT_FALSE(s.stage.find("blocks/1/to"));
  EXPECT_TRUE(s.stage.find("blocks/1/direction/+"));
}

}  // namespace
}  // namespace hw::panels
