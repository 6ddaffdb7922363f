// A Tool block says what lowers and lifts the tool; a contour is a block that others stand in.
#include "tests/panels/blocks_stage.h"

namespace hw::panels {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

struct ToolBlocks : test_blocks::BlocksStage {
  using BlocksStage::BlocksStage;
};
struct BoardToolBlocks : test_blocks::BlocksStage {
  BoardToolBlocks() : BlocksStage("vme58") {}
};

TEST_F(ToolBlocks, ToolRoutinesAreTypedInABlockAndUndoneAsOneChange) {
  s.click("blocks/add/pen");
  EXPECT_EQ(text(), "END\n");
  s.type("blocks/1/pen_down", "DO3 on, wait 200 ms\n");
  EXPECT_THAT(value("blocks/1/routine"), HasSubstr("DO3 is switched on with the tool"));
  EXPECT_THAT(s.reason("blocks/run"), HasSubstr("nothing switches it back"));
  EXPECT_EQ(text(), "END\n") << "a tool that would stay on is not taken";
  s.type("blocks/1/pen_up", "DO3 off\n");
  s.stage.frames(6);
  EXPECT_THAT(text(), HasSubstr("DO3=1\nDELAY=200\n"));
  EXPECT_FALSE(s.stage.find("blocks/1/routine"));
  EXPECT_EQ(s.reason("blocks/to_program"), "");
  s.click("blocks/add/pen");
  s.click("blocks/2/down/up");
  s.stage.frames(6);
  EXPECT_THAT(text(), HasSubstr("DO3=0\n")) << "the same tool";
  s.click("blocks/undo"), s.click("blocks/undo"), s.click("blocks/undo");
  s.stage.frames(6);
  EXPECT_EQ(text(), "END\n");
  s.click("blocks/1");
  EXPECT_EQ(value("blocks/1/pen_down"), "");
}

TEST_F(ToolBlocks, ARoutineThatIsNotUnderstoodStaysAndHoldsTheRunBack) {
  s.click("blocks/add/pen");
  s.click("blocks/add/delay");
  s.click("blocks/1");
  s.type("blocks/1/pen_up", "DO99 off\n");
  EXPECT_THAT(s.reason("blocks/run"), HasSubstr("has no output \"DO99\""));
  s.click("blocks/2");
  EXPECT_THAT(s.reason("blocks/run"), HasSubstr("has no output \"DO99\""));
  s.click("blocks/1");
  EXPECT_EQ(value("blocks/1/pen_up"), "DO99 off");
  s.type("blocks/1/pen_up", "DO2 off\n");
  s.stage.frames(6);
  EXPECT_EQ(s.reason("blocks/to_program"), "");
}

TEST_F(ToolBlocks, RoutinesThatWordsCannotDescribeStayAsTheyAre) {
  sequence::Sequence all = sequence::frame_of(editor().sequence());
  all.pen_down = {{sequence::Custom{"", "V1=1"}}};
  all.steps = {{sequence::Pen{true}}};
  editor().load(all);
  s.stage.frames(6);
  s.click("blocks/1");
  EXPECT_THAT(s.reason("blocks/1/pen_down"), HasSubstr("come from a file"));
  EXPECT_THAT(text(), HasSubstr("V1=1"));
}

TEST_F(BoardToolBlocks, AContourIsAddedWithItsFirstLineAndOthersGoIntoIt) {
  s.click("blocks/add/contour");
  EXPECT_EQ(text(), "AA\nCV1000;\nCD0,0;\nMT1000,0;\nCE\nMT0,0; GO\nCX\n");
  s.click("blocks/add/arc");
  ASSERT_EQ(editor().sequence().steps.size(), 1u);
  s.type("blocks/3/x", "1000");
  s.type("blocks/3/y", "500");
  s.stage.frames(6);
  EXPECT_THAT(text(), HasSubstr("MT1000,0;\nCR1000,500,1.570796327;\nCE\n"));
  s.click("blocks/down");
  EXPECT_EQ(editor().sequence().steps.size(), 2u) << "behind the contour";
  s.click("blocks/up");
  EXPECT_EQ(editor().sequence().steps.size(), 1u) << "and into it again";
}

}  // namespace
}  // namespace hw::panels
