// Blocks are shown in what the axes are shown in, and are taught where these are.
#include "tests/panels/blocks_stage.h"

namespace hw::panels {
namespace {

using ::testing::HasSubstr;

void with_units(Catalog& c) {
  c.units = {
      {"screw of 2 mm", "mm", 0.005, 3}, {"screw of 4 mm", "mm", 0.01, 2}, {"table", "\u00b0", 0.1, 1}};
}
struct BlocksInUnits : test_blocks::BlocksStage {
  BlocksInUnits() : BlocksStage("pmx-4ex-sa", with_units) {}
  void choose(const char* x, const char* others) {
    s.tab.settings.profile.unit = "real";
    for (AxisProfile& axis : s.tab.settings.profile.axes) axis.unit_choice = others;
    s.tab.settings.profile.axes[0].unit_choice = x;
    show_real(true);
  }
  void show_real(bool real) {
    s.tab.settings.profile.unit = real ? "real" : "pulses";
    s.tab.settings.edited();
    s.stage.frames(4);
  }
  /// Where the axes stand now, in pulses.
  void stand(std::int64_t x, std::int64_t y) {
    s.now.poll_period = std::chrono::hours(1);
    s.now.axes[0].position = Steps(x);
    s.now.axes[1].position = Steps(y);
    s.stage.frames(2);
  }
};

TEST_F(BlocksInUnits, NewOnesAreKeptInTheUnitOfAllAxes) {
  choose("screw of 2 mm", "screw of 4 mm");
  EXPECT_EQ(editor().sequence().unit, "mm");
  s.click("blocks/add/speed");
  s.type("blocks/1/high", "20");
  s.type("blocks/1/low", "0");
  s.click("blocks/add/move");
  s.type("blocks/2/to/X", "12.5");
  s.type("blocks/2/to/Y", "4");
  EXPECT_EQ(value("blocks/1"), "20 mm/s, 300 ms");
  EXPECT_EQ(value("blocks/2"), "X 12.5, Y 4");
  EXPECT_THAT(text(), HasSubstr("X2500Y400\n"));
  EXPECT_THAT(text(), HasSubstr("HSPD=4000\n"));
  stand(5000, 100);
  s.click("blocks/here");
  EXPECT_EQ(value("blocks/2"), "X 25, Y 1");
  EXPECT_EQ(value("blocks/2/to/X"), "25");
  EXPECT_THAT(text(), HasSubstr("X5000Y100\n"));
}

TEST_F(BlocksInUnits, ThoseThatAreThereAreShownInAnother) {
  s.click("blocks/add/move");
  s.type("blocks/1/to/X", "2500");
  s.type("blocks/1/to/Y", "400");
  choose("screw of 2 mm", "table");
  EXPECT_EQ(editor().sequence().unit, "pulses") << "the blocks themselves are as they were";
  EXPECT_EQ(value("blocks/1"), "X 12.5 mm, Y 40deg");
  EXPECT_EQ(value("blocks/1/to/X"), "12.5") << "and the form that is open";
  s.type("blocks/1/to/X", "0.035");
  EXPECT_THAT(text(), HasSubstr("X7Y400\n"));
  show_real(false);
  EXPECT_EQ(value("blocks/1"), "X 7, Y 400");
  s.type("blocks/1/to/Y", "41");
  EXPECT_THAT(text(), HasSubstr("X7Y41\n"));
}

TEST_F(BlocksInUnits, AMotionOfOneAxisHasItsSpeedInItsUnit) {
  s.click("blocks/add/home");
  choose("screw of 2 mm", "table");
  s.click("blocks/1/own/its own");
  s.type("blocks/1/high", "10");
  EXPECT_THAT(text(), HasSubstr("HSPD=2000\n"));
}

TEST_F(BlocksInUnits, AWayIsTaughtFromWhereItBegins) {
  stand(300, 40);
  s.click("blocks/add/move_by");
  EXPECT_THAT(s.reason("blocks/here"), HasSubstr("its start is unknown"));
  load({{sequence::Move{{100, 100}, false, {}}}, {sequence::Move{{0, 0}, true, {}}}});
  s.click("blocks/2");
  s.click("blocks/here");
  EXPECT_EQ(value("blocks/2"), "X 200, Y -60");
  EXPECT_THAT(text(), HasSubstr("X200Y-60\n"));
}

TEST_F(BlocksInUnits, AnArcIsTaughtItsCentreAndItsEnd) {
  load({{sequence::Move{{0, 0}, false, {}}}, {sequence::Arc{0, 0, 90, {}}}});
  s.click("blocks/2");
  stand(100, 0);
  s.click("blocks/here");
  EXPECT_EQ(value("blocks/2"), "about 100, 0, 90deg");
  stand(200, 0);
  s.click("blocks/here_end");
  EXPECT_EQ(value("blocks/2"), "about 100, 0, 180deg");
  s.click("blocks/2/way/clockwise");
  EXPECT_EQ(value("blocks/2"), "about 100, 0, 180deg clockwise");
  EXPECT_EQ(value("blocks/2/degrees"), "180") << "the way round has a control of its own";
  EXPECT_THAT(text(), HasSubstr("ARCP100:0:"));
  stand(100, 100);
  s.click("blocks/here_end");
  EXPECT_EQ(value("blocks/2"), "about 100, 0, 90deg clockwise");
}

TEST_F(BlocksInUnits, AMoveOnAnInputIsTaughtToo) {
  stand(300, 40);
  s.click("blocks/add/move_on_input");
  s.click("blocks/1/axis/Y");
  s.click("blocks/here");
  EXPECT_THAT(text(), HasSubstr("Y40\n"));
}

}  // namespace
}  // namespace hw::panels
