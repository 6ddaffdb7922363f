// A conversion of the user's own for one axis: told, by its drive, or measured.
#include <gtest/gtest.h>

#include "tests/panels/console_stage.h"
#include "tests/panels/must.h"

namespace hw::panels {
namespace {

using namespace gui;

class OwnUnitTest : public testing::Test {
 protected:
  ConsoleStage s;
  Example& a = s.add(example_catalog());

  void SetUp() override {
    a.tab->view.unset_read = true;
    a.now.axes[0].position = Steps(1000);
    s.run(0.2);
    MUST(s.hand.click("dro/unit"));
    MUST(s.hand.click("dro/unit/axis/1"));
    MUST(s.hand.click("dro/unit/axis/1/another conversion"));
    s.run(0.1);
  }
  const DisplayUnit& unit() { return a.tab->settings.unit(AxisId{0}); }
};

TEST_F(OwnUnitTest, IsReportedAsUnitsAStep) {
  EXPECT_FALSE(unit().real) << "nothing is told yet";
  MUST(s.hand.type("dro/unit/own/1/step", "0.0025\n"));
  EXPECT_TRUE(unit().real);
  EXPECT_EQ(unit().name, "mm");
  EXPECT_EQ(unit().decimals, 3);
  EXPECT_EQ(s.value("dro/1/position"), "2.500");
  MUST(s.hand.type("dro/unit/own/1/name", "inch\n"));
  EXPECT_EQ(unit().name, "inch");
}

TEST_F(OwnUnitTest, FollowsFromTheDrive) {
  EXPECT_FALSE(s.stage.find("dro/unit/own/1/drive")->enabled);
  MUST(s.hand.type("dro/unit/own/1/full", "400\n"));
  MUST(s.hand.type("dro/unit/own/1/micro", "10\n"));
  MUST(s.hand.type("dro/unit/own/1/gear", "2.5\n"));
  MUST(s.hand.type("dro/unit/own/1/travel", "5\n"));
  MUST(s.hand.click("dro/unit/own/1/drive"));
  EXPECT_DOUBLE_EQ(unit().per_step, 5 / 10000.0);
}

TEST_F(OwnUnitTest, FollowsFromTwoMeasuredPointsAndTheirDirection) {
  MUST(s.hand.type("dro/unit/own/1/first", "12.5\n"));
  MUST(s.hand.click("dro/unit/own/1/first/here"));
  a.now.axes[0].position = Steps(5000);
  s.run(0.1);
  MUST(s.hand.type("dro/unit/own/1/second", "10.5\n"));
  EXPECT_FALSE(s.stage.find("dro/unit/own/1/measured")->enabled) << "where it counts then is not taken yet";
  MUST(s.hand.click("dro/unit/own/1/second/here"));
  MUST(s.hand.click("dro/unit/own/1/measured"));
  EXPECT_DOUBLE_EQ(unit().per_step, -0.0005);
  EXPECT_EQ(a.tab->settings.profile.axes[0].unit_choice, own_unit_choice);
  EXPECT_EQ(s.value("dro/unit/reversed/1"), "on");
}

TEST_F(OwnUnitTest, TwoMeasuredPointsGiveTheDirectionWhateverItWas) {
  MUST(s.hand.click("dro/unit/reversed/1"));
  MUST(s.hand.type("dro/unit/own/1/first", "10\n"));
  MUST(s.hand.click("dro/unit/own/1/first/here"));
  a.now.axes[0].position = Steps(5000);
  s.run(0.1);
  MUST(s.hand.type("dro/unit/own/1/second", "12\n"));
  MUST(s.hand.click("dro/unit/own/1/second/here"));
  MUST(s.hand.click("dro/unit/own/1/measured"));
  EXPECT_DOUBLE_EQ(unit().per_step, 0.0005);
  EXPECT_EQ(s.value("dro/unit/reversed/1"), "off");
}

TEST_F(OwnUnitTest, AnEncoderHasCountsATurnAndNoMicroSteps) {
  a.now.axes[0].in_counts = true;
  s.run(0.1);
  EXPECT_FALSE(s.hand.exists("dro/unit/own/1/micro"));
  MUST(s.hand.type("dro/unit/own/1/travel", "5\n"));
  EXPECT_FALSE(s.stage.find("dro/unit/own/1/drive")->enabled) << "there is no usual encoder";
  MUST(s.hand.type("dro/unit/own/1/full", "4000\n"));
  MUST(s.hand.click("dro/unit/own/1/drive"));
  EXPECT_DOUBLE_EQ(unit().per_step, 5 / 4000.0);
  a.now.axes[0].in_counts = false;
  s.run(0.1);
  EXPECT_EQ(s.value("dro/unit/own/1/full"), "") << "4000 counts are not 4000 full steps";
  MUST(s.hand.click("dro/unit/own/1/drive"));
  EXPECT_DOUBLE_EQ(unit().per_step, 5 / 200.0);
}

}  // namespace
}  // namespace hw::panels
