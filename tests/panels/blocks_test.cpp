// Blocks that are clicked together become the controller's text; what it cannot do is said at its block.
#include "panels/blocks.h"

#include "core/device/registry.h"
#include "tests/panels/panel_stage.h"

namespace hw::panels {
namespace {

using ::testing::HasSubstr;

struct BlocksTest : ::testing::Test {
  explicit BlocksTest(const char* model = "pmx-4ex-sa")
      : type(*find_device_type(model)),
        s(panel, 864, 1200, 1, gui::Tier::wide, true, *type.make_catalog({}), &type.language()) {
    s.now.axis_count = 4;
    for (AxisState& a : s.now.axes) a.position_known = true, a.activity = Activity::idle;
    s.stage.frames(2);
  }
  std::string text() { return s.value("blocks/text"); }
  const DeviceType& type;
  Blocks panel;
  test::PanelStage s;
};
struct VxmBlocksTest : BlocksTest {
  VxmBlocksTest() : BlocksTest("vxm") { s.now.axis_count = 2; }
};

TEST_F(BlocksTest, WhatIsClickedTogetherIsWritten) {
  EXPECT_THAT(s.reason("blocks/to_program"), HasSubstr("There are no blocks yet"));
  s.click("blocks/add/move");
  s.type("blocks/1/to/X", "1200");
  s.type("blocks/1/to/Y", "-50");
  s.click("blocks/add/wait_motion");
  s.click("blocks/2/axis/X");
  s.click("blocks/add/output");
  s.type("blocks/3/output", "5");
  EXPECT_EQ(text(), "ABS\nX1200Y-50\nWAITX\nDO5=1\nEND\n");
  EXPECT_EQ(s.value("blocks/1"), "X 1200, Y -50");
  s.click("blocks/to_program");
  EXPECT_EQ(s.tab.desk().texts.text(0), text());
  EXPECT_EQ(panel.unkept(), "");
  s.click("blocks/add/delay");
  EXPECT_NE(panel.unkept(), "");
}

TEST_F(BlocksTest, BlocksMoveInAndOutOfLoops) {
  s.click("blocks/add/delay");
  s.type("blocks/1/ms", "10");
  s.click("blocks/add/loop");
  s.click("blocks/add/delay");
  s.type("blocks/3/ms", "20");
  EXPECT_EQ(text(), "DELAY=10\nV49=0\nWHILE V49<2\n  DELAY=20\n  V49=V49+1\nENDWHILE\nEND\n");
  s.click("blocks/1");
  s.click("blocks/down");
  EXPECT_EQ(text(), "V49=0\nWHILE V49<2\n  DELAY=10\n  DELAY=20\n  V49=V49+1\nENDWHILE\nEND\n");
  s.click("blocks/down");
  s.click("blocks/down");
  EXPECT_EQ(text(), "V49=0\nWHILE V49<2\n  DELAY=20\n  V49=V49+1\nENDWHILE\nDELAY=10\nEND\n");
  s.click("blocks/up");
  EXPECT_EQ(text(), "V49=0\nWHILE V49<2\n  DELAY=20\n  DELAY=10\n  V49=V49+1\nENDWHILE\nEND\n");
  for (int n = 0; n < 3; ++n) s.click("blocks/undo");
  EXPECT_EQ(text(), "V49=0\nWHILE V49<2\n  DELAY=10\n  DELAY=20\n  V49=V49+1\nENDWHILE\nEND\n");
  s.click("blocks/redo");
  EXPECT_THAT(text(), HasSubstr("DELAY=20\n  DELAY=10"));
}

TEST_F(BlocksTest, ABlockIsLeftOutDuplicatedAndRemoved) {
  s.click("blocks/add/comment");
  s.click("blocks/duplicate");
  s.type("blocks/2/text", "second");
  EXPECT_EQ(text(), "; what comes now\n; second\nEND\n");
  s.click("blocks/skip");
  EXPECT_EQ(text(), "; what comes now\nEND\n");
  s.click("blocks/skip");
  s.click("blocks/remove");
  EXPECT_EQ(text(), "; what comes now\nEND\n");
  s.click("blocks/loop");
  EXPECT_THAT(text(), HasSubstr("WHILE V49<2\n  ; what comes now"));
}

TEST_F(BlocksTest, ATargetIsTaughtWhereTheAxesAre) {
  s.now.poll_period = std::chrono::hours(1);
  s.now.axes[0].position = Steps(4321);
  s.click("blocks/add/move");
  s.click("blocks/here");
  EXPECT_THAT(text(), HasSubstr("X4321\n"));
  s.now.axes[0].position = Steps(99);
  s.now.link.state = LinkState::lost;
  s.click("blocks/here");
  EXPECT_THAT(text(), HasSubstr("X4321\n")) << "what was seen last is no place to be taught";
}

TEST_F(VxmBlocksTest, WhatCannotBeDoneIsSaidAtItsBlock) {
  s.click("blocks/add/delay");
  s.click("blocks/add/arc");
  EXPECT_THAT(s.value("blocks/problem"), HasSubstr("Step 2 (arc): a VXM moves one motor at a time"));
  EXPECT_THAT(s.reason("blocks/to_program"), HasSubstr("Step 2 (arc)"));
  s.click("blocks/remove");
  EXPECT_FALSE(s.stage.find("blocks/problem"));
  EXPECT_EQ(text(), "P5\n");
}

TEST_F(BlocksTest, ATextWithChangesIsNotReplacedWithoutBeingAsked) {
  s.tab.desk().texts.set_text(0, "END\n");
  s.click("blocks/add/delay");
  s.click("blocks/to_program");
  s.click("blocks/replace/no");
  EXPECT_EQ(s.tab.desk().texts.text(0), "END\n");
  s.click("blocks/to_program");
  s.click("blocks/replace/yes");
  EXPECT_EQ(s.tab.desk().texts.text(0), "DELAY=500\nEND\n");
}

}  // namespace
}  // namespace hw::panels
