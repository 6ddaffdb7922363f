// An arc in any two axes of a controller that has more of them.
#include <gmock/gmock.h>

#include "tests/panels/blocks_stage.h"

namespace hw::panels {
namespace {

using ::testing::HasSubstr;

struct BlocksInAPlane : test_blocks::BlocksStage {
  BlocksInAPlane() : BlocksStage("vme58") {}
};

TEST_F(BlocksInAPlane, AnArcIsPutIntoTwoOtherAxes) {
  sequence::Move begin;
  begin.to[0] = 0, begin.to[1] = 0, begin.to[2] = 0;
  load({{sequence::Speed{{1000}}}, {begin}, {sequence::Arc{100, 0, 90}}});
  s.click("blocks/3");
  EXPECT_EQ(value("blocks/3"), "about 100, 0, 90deg");
  s.click("blocks/3/axes/2/Z");
  EXPECT_EQ(value("blocks/3"), "about X 100, Z 0, 90deg");
  EXPECT_THAT(text(), HasSubstr("CD0,,0;\nCR100,0,1.570796327;"));
  s.click("blocks/3/axes/1/Z");
  EXPECT_EQ(value("blocks/3"), "about Z 100, X 0, 90deg") << "both stay two different axes";
}

}  // namespace
}  // namespace hw::panels
