// Steps and speed of jogging where axes are shown in real units.
#include <cmath>
#include <tuple>

#include <gtest/gtest.h>

#include "panels/jog/jog_button.h"
#include "tests/panels/console_stage.h"
#include "tests/panels/must.h"

namespace hw::panels {
namespace {

using namespace gui;

class JogUnitsTest : public testing::Test {
 protected:
  ConsoleStage s;
  Example& a = s.add(with_screws());
  void SetUp() override { s.run(0.1); }

  static Catalog with_screws() {
    Catalog c = example_catalog();
    c.units.push_back({"screw of 2 mm", "mm", 0.005, 3});
    return c;
  }
  void show_in(const char* first, const char* second) {
    a.tab->settings.profile.unit = "real";
    a.tab->settings.profile.axes[0].unit_choice = first;
    a.tab->settings.profile.axes[1].unit_choice = second;
    a.tab->settings.edited();
    s.run(0.1);
  }
  Steps tap(const char* id) {
    EXPECT_TRUE(s.hand.click(id).has_value());
    s.run(0.1);
    const auto* by = a.last<intent::MoveBy>();
    return by ? by->distances[0].value : Steps(0);
  }
};

TEST_F(JogUnitsTest, OneUnitOfAllAxesIsThatOfTheSteps) {
  show_in("screw of 1 mm", "screw of 1 mm");
  a.tab->settings.profile.axes[1].reversed = true;  // how long a step is stays the same
  a.tab->settings.edited();
  s.run(0.1);
  MUST(s.hand.click("jog/step/1"));
  EXPECT_EQ(tap("jog/2/+"), Steps(400));
  EXPECT_EQ(s.value("jog/speed"), "5.000 mm/s");
}

TEST_F(JogUnitsTest, WhereUnitsDifferATapIsShownInEachOnesOwn) {
  show_in("screw of 1 mm", "screw of 1 mm");
  EXPECT_FALSE(s.hand.exists("jog/own_units")) << "the buttons say it";
  show_in("screw of 1 mm", "screw of 2 mm");
  MUST(s.hand.click("jog/step/1"));
  s.run(0.1);
  EXPECT_EQ(s.value("jog/own_units"), "A tap: all 1.000 mm. Held: 1 5.000 mm/s, 2 10.000 mm/s.");
}

TEST_F(JogUnitsTest, AStepIsANumberInTheUnitOfEachAxis) {
  for (const char* second : {"screw of 2 mm", "table"}) {
    show_in("screw of 1 mm", second);
    MUST(s.hand.click("jog/step/1"));
    s.run(0.1);
    EXPECT_EQ(s.value("jog/step/1"), "on") << second;
    EXPECT_EQ(tap("jog/1/+"), Steps(400)) << second;
    const double per_step = a.tab->settings.unit(AxisId{1}).per_step;
    EXPECT_EQ(tap("jog/2/+"), Steps(std::llround(1 / per_step))) << second;
    MUST(s.hand.key("Up"));
    s.run(0.1);
    EXPECT_EQ(a.last<intent::MoveBy>()->distances[0].value, Steps(std::llround(1 / per_step))) << "by key";
    MUST(s.hand.click("jog/step/step"));
    EXPECT_EQ(tap("jog/2/+"), Steps(1)) << second;
    EXPECT_EQ(s.value("jog/speed"), "each its own") << second;
  }
}

TEST_F(JogUnitsTest, AnAxisWithoutAUnitCountsSteps) {
  for (const bool first : {true, false}) {
    show_in(first ? "" : "screw of 1 mm", first ? "screw of 1 mm" : "");
    const char *real = first ? "jog/2/+" : "jog/1/+", *counted = first ? "jog/1/+" : "jog/2/+";
    MUST(s.hand.click("jog/step/10"));
    s.run(0.1);
    EXPECT_EQ(tap(real), Steps(4000)) << first;
    EXPECT_EQ(tap(counted), Steps(10)) << first;
    MUST(s.hand.click("jog/step/0.1"));
    EXPECT_EQ(tap(real), Steps(40)) << first;
    EXPECT_EQ(tap(counted), Steps(1)) << "never nothing";
  }
  EXPECT_EQ(s.value("jog/own_units"), "A tap: 1 0.100 mm, 2 1 step. Held: 1 5.000 mm/s, 2 2000 steps/s.");
}

TEST_F(JogUnitsTest, AValueSharedByMostAxesIsShownOnce) {
  Example& b = s.add(example_catalog(4));
  b.tab->settings.profile.unit = "real";
  b.tab->settings.profile.axes[0].unit_choice = "screw of 1 mm";
  b.tab->settings.edited();
  s.run(0.1);
  EXPECT_EQ(s.value("jog/own_units"),
            "A tap: 1 0.003 mm, others 1 step. Held: 1 5.000 mm/s, others 2000 steps/s.");
}

TEST_F(JogUnitsTest, TheSpeedOfEachAxisIsTypedInItsOwnUnit) {
  show_in("screw of 1 mm", "table");
  MUST(s.hand.click("jog/speed/number"));
  s.run(0.1);
  EXPECT_EQ(s.value("jog/speed/1"), "5.000");
  EXPECT_EQ(s.value("jog/speed/2"), "25.00");
  MUST(s.hand.type("jog/speed/2", "10\n"));
  s.run(0.1);
  MUST(s.hand.type("jog/speed/1", "99999\n"));  // more than the controller can
  MUST(s.hand.key("Escape"));
  s.run(0.1);
  for (const auto& [id, axis, speed] :
       {std::tuple("jog/1/+", AxisId{0}, Pps(0)), {"jog/2/+", AxisId{1}, Pps(800)}}) {
    MUST(s.hand.press(id));
    s.run(0.6);
    ASSERT_TRUE(a.last<intent::JogStart>());
    EXPECT_EQ(a.last<intent::JogStart>()->axis, axis);
    EXPECT_EQ(a.last<intent::JogStart>()->speed, speed) << id;
    MUST(s.hand.release(id));
    s.run(0.1);
  }
  MUST(s.hand.click("jog/speed/number"));
  s.run(0.1);
  MUST(s.hand.click("jog/speed/2/reset"));
  EXPECT_EQ(a.tab->settings.jog_speed(AxisId{1}), Pps(0));
}

TEST_F(JogUnitsTest, TheSliderChoosesForAllAxesAgain) {
  a.tab->settings.choose_jog_speed(AxisId{1}, Pps(800));
  s.run(0.1);
  EXPECT_EQ(s.value("jog/speed"), "each its own");
  MUST(s.hand.press("jog/speed"));
  MUST(s.hand.release("jog/speed"));
  s.run(0.1);
  const Pps chosen = a.tab->settings.profile.jog_speed;
  EXPECT_GT(chosen.value, 0);
  EXPECT_EQ(a.tab->settings.jog_speed(AxisId{1}), chosen);
  EXPECT_NE(s.value("jog/speed"), "each its own");
}

TEST_F(JogUnitsTest, EachButtonNamesItsStepInTheUnitOfItsAxis) {
  show_in("screw of 1 mm", "screw of 2 mm");
  a.tab->settings.profile.axes[1].reversed = true;
  a.tab->settings.profile.jog_speed = Pps(1000);
  a.tab->settings.edited();
  s.run(0.1);
  MUST(s.hand.click("jog/step/1"));
  s.run(0.1);
  EXPECT_EQ(tap_and_hold(*a.tab, AxisId{0}).view(), "A tap moves it 1.000 mm; held, it runs at 2.500 mm/s.");
  EXPECT_EQ(tap_and_hold(*a.tab, AxisId{1}).view(), "A tap moves it 1.000 mm; held, it runs at 5.000 mm/s.");
}

TEST_F(JogUnitsTest, ASpeedIsNotNegativeOnAReversedAxis) {
  a.tab->settings.profile.axes[0].reversed = a.tab->settings.profile.axes[1].reversed = true;
  show_in("screw of 1 mm", "screw of 1 mm");
  EXPECT_EQ(s.value("jog/speed"), "5.000 mm/s");
}

TEST_F(JogUnitsTest, TheStepOfATapIsAlwaysLit) {
  show_in("screw of 1 mm", "screw of 1 mm");
  MUST(s.hand.click("jog/step/1"));
  MUST(s.hand.click("dro/unit"));
  s.run(0.1);
  MUST(s.hand.click("dro/unit/steps"));
  MUST(s.hand.key("Escape"));
  s.run(0.1);
  EXPECT_EQ(s.value("jog/step/1"), "on") << "400 steps are none of the choices: the least is taken";
  EXPECT_EQ(tap("jog/1/+"), Steps(1));
}

TEST_F(JogUnitsTest, AStepThatIsStillAChoiceStays) {
  MUST(s.hand.click("jog/step/1"));
  show_in("screw of 1 mm", "screw of 1 mm");
  EXPECT_EQ(s.value("jog/step/step"), "on");
  EXPECT_EQ(tap("jog/1/+"), Steps(1));
}

TEST_F(JogUnitsTest, TheSpeedCanBeTypedInTheUnitThatIsShown) {
  MUST(s.hand.click("jog/speed/number"));
  s.run(0.1);
  MUST(s.hand.type("jog/speed/field", "1234\n"));
  s.run(0.1);
  EXPECT_EQ(a.tab->settings.profile.jog_speed, Pps(1234));
  EXPECT_EQ(s.value("jog/speed/number"), "1234 steps/s") << "the field is gone again";
  show_in("screw of 1 mm", "screw of 1 mm");
  MUST(s.hand.click("jog/speed/number"));
  s.run(0.1);
  MUST(s.hand.type("jog/speed/field", "2.5\n"));
  s.run(0.1);
  EXPECT_EQ(a.tab->settings.profile.jog_speed, Pps(1000));
}

TEST_F(JogUnitsTest, ASpeedThatDoesNotGoChangesNothing) {
  a.tab->settings.profile.jog_speed = Pps(500);
  MUST(s.hand.click("jog/speed/number"));
  s.run(0.1);
  MUST(s.hand.type("jog/speed/field", "0\n"));
  s.run(0.1);
  EXPECT_EQ(a.tab->settings.profile.jog_speed, Pps(500));
  EXPECT_TRUE(s.stage.find("jog/speed/field")) << "to be mended";
  MUST(s.hand.click("goto/1"));
  s.run(0.2);
  EXPECT_FALSE(s.stage.find("jog/speed/field"));
  EXPECT_EQ(s.value("jog/speed/number"), "500 steps/s");
}

}  // namespace
}  // namespace hw::panels
