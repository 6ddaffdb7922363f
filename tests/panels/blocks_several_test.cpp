// Several blocks that stand behind each other are chosen, and treated as one.
#include "panels/blocks/block_rows.h"
#include "tests/panels/blocks_stage.h"

namespace hw::panels {
namespace {

using ::testing::HasSubstr;

struct SeveralBlocks : test_blocks::BlocksStage {
  SeveralBlocks() {
    load({{sequence::Delay{1}}, {sequence::Delay{2}}, {sequence::Delay{3}}, {sequence::Delay{4}}});
    s.click("blocks/2");
    shift_click("blocks/3");
  }
  std::string delays() {
    std::string all;
    BlockRows rows;
    rows.follow(editor());
    for (std::size_t row = 0; row < rows.size(); ++row) {
      const sequence::Step& step = rows.step(row);
      const auto* delay = std::get_if<sequence::Delay>(&step.body);
      all += (all.empty() ? "" : " ") + std::string(step.skipped ? "-" : "") +
             (delay ? std::to_string(static_cast<int>(delay->ms)) : "(");
    }
    return all;
  }
};

TEST_F(SeveralBlocks, AreGroupedIntoOneLoop) {
  EXPECT_EQ(value("blocks/chosen"), "2 blocks are chosen");
  EXPECT_FALSE(s.stage.find("blocks/3/ms")) << "no fields of one of them";
  s.click("blocks/loop");
  EXPECT_EQ(text(),
            "DELAY=1\nV49=0\nWHILE V49<2\n  DELAY=2\n  DELAY=3\n  V49=V49+1\nENDWHILE\nDELAY=4\nEND\n");
  s.click("blocks/undo");
  EXPECT_EQ(delays(), "1 2 3 4") << "in one step";
}

TEST_F(SeveralBlocks, AreMovedDoubledLeftOutAndRemoved) {
  s.click("blocks/up");
  EXPECT_EQ(delays(), "2 3 1 4");
  key("alt+down");
  key("alt+down");
  EXPECT_EQ(delays(), "1 4 2 3") << "they stay chosen";
  s.click("blocks/duplicate");
  EXPECT_EQ(delays(), "1 4 2 3 2 3");
  key("space");
  EXPECT_EQ(delays(), "1 4 2 3 -2 -3");
  key("delete");
  EXPECT_EQ(delays(), "1 4 2 3");
  for (int n = 0; n < 6; ++n) s.click("blocks/undo");
  EXPECT_EQ(delays(), "1 2 3 4");
}

TEST_F(SeveralBlocks, AreChosenByTheKeyboardToo) {
  s.click("blocks/1");
  key("shift+down");
  key("shift+down");
  EXPECT_EQ(value("blocks/chosen"), "3 blocks are chosen");
  key("shift+up");
  EXPECT_EQ(value("blocks/chosen"), "2 blocks are chosen");
  EXPECT_TRUE(s.sent.empty()) << "an arrow with Shift does not jog";
  key("ctrl+g");
  EXPECT_EQ(delays(), "( 1 2 3 4");
  EXPECT_THAT(text(), HasSubstr("  DELAY=2\n  V49=V49+1\nENDWHILE\nDELAY=3\n"));
}

TEST_F(SeveralBlocks, OneFromWithinALoopReachesOutByThatLoop) {
  s.click("blocks/loop");
  s.click("blocks/1");
  shift_click("blocks/3");
  EXPECT_EQ(value("blocks/chosen"), "2 blocks are chosen")
      << "the first, and the loop that the third stands in";
  key("delete");
  EXPECT_EQ(delays(), "4");
}

}  // namespace
}  // namespace hw::panels
