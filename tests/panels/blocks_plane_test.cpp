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
  s.click("blocks/3/axes/2");  // eight names are a list here: they need more room than there is
  s.click("blocks/3/axes/2/Z");
  EXPECT_EQ(value("blocks/3"), "about X 100, Z 0, 90deg");
  EXPECT_THAT(text(), HasSubstr("CD0,,0;\nCR100,0,1.570796327;"));
  s.click("blocks/3/axes/1");
  s.click("blocks/3/axes/1/Z");
  EXPECT_EQ(value("blocks/3"), "about Z 100, X 0, 90deg") << "both stay two different axes";
}

TEST_F(BlocksInAPlane, AContourStaysInItsPlaneWhenItsFieldsAreEdited) {
  sequence::Contour c;
  c.plane = {0, 2}, c.own = sequence::Speeds{1000};
  sequence::Move along;
  along.to[2] = 500;
  c.steps = {{along}};
  load({{c}});
  s.click("blocks/1");
  s.type("blocks/1/x", "40\n");
  const auto& now = std::get<sequence::Contour>(editor().sequence().steps[0].body);
  EXPECT_EQ(now.x, 40);
  EXPECT_EQ(now.plane, c.plane);
}

TEST_F(BlocksInAPlane, AnInvalidNumberChangesNothing) {
  load({{sequence::Repeat{3, {{sequence::Delay{5}}}}}});
  s.click("blocks/1");
  for (const char* bad : {"2.5", "-3", "nan", "1e300", "inf", "", "7000000", "two"}) {
    s.type("blocks/1/times", bad);
    EXPECT_EQ(std::get<sequence::Repeat>(editor().sequence().steps[0].body).times, 3) << bad;
    EXPECT_NE(s.reason("blocks/run"), "") << bad;
    EXPECT_NE(s.reason("blocks/run_here"), "") << bad;
  }
}

}  // namespace
}  // namespace hw::panels
