// The badge by the jog pad: who ends a held jog when the program dies.
#include <algorithm>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/device/registry.h"
#include "gui/model/jog_choice.h"
#include "tests/panels/console_stage.h"
#include "tests/panels/must.h"

namespace hw::panels {
namespace {

using namespace gui;

class GuaranteeTest : public testing::Test {
 protected:
  ConsoleStage s;
  Example& a = s.add(example_catalog());

  void SetUp() override {
    for (AxisState& axis : a.now.axes) axis.own_speed = Pps(1000);
    ends(JogEnds::by_watchdog);
  }
  void ends(JogEnds how) {
    a.now.link.jog_ends = how;
    s.run(0.1);
  }
  void bound(int axis) {
    Travel t;
    t.has_minus = t.has_plus = true;
    t.minus = Steps(-500), t.plus = Steps(2000);
    a.now.axes[static_cast<std::size_t>(axis)].travel = t;
    s.run(0.1);
  }
  std::string label() {
    const Widget* w = s.stage.find("jog/guarantee");
    return w ? std::string(w->label) : "(absent)";
  }
};

TEST_F(GuaranteeTest, ShowsHowFarItGoesUntilTheWatchdogActs) {
  EXPECT_EQ(label(), "watchdog");
  EXPECT_EQ(s.value("jog/guarantee"), "stops it: 1300 steps");
  gui::choose_jog(*a.tab, a.tab->settings.profile.jog_step, Pps(200));
  s.run(0.1);
  EXPECT_EQ(s.value("jog/guarantee"), "stops it: 260 steps");
}

TEST_F(GuaranteeTest, TheControllerDoesWhereEveryAxisHasItsLimits) {
  bound(0);
  EXPECT_EQ(label(), "watchdog") << "motor 2 has none";
  bound(1);
  EXPECT_EQ(label(), "controller");
  EXPECT_EQ(s.value("jog/guarantee"), "stops it: within 2000 steps");
}

TEST_F(GuaranteeTest, AJogThatNothingEndsIsReported) {
  ends(JogEnds::never);
  EXPECT_EQ(label(), "no guard");
  EXPECT_EQ(s.value("jog/guarantee"), "1000 steps per second");
  ends(JogEnds::with_program);
  EXPECT_EQ(label(), "this program");
  a.now.link.state = LinkState::lost;
  s.run(0.1);
  EXPECT_EQ(label(), "(absent)") << "nothing is jogged there";
}

/// Each controller that there is, by its own catalog, in the unit that its user has chosen.
class EveryBadge : public testing::TestWithParam<const DeviceType*> {};

TEST_P(EveryBadge, ShowsWhoEndsItAndHowFarAtTheChosenSpeed) {
  ConsoleStage s;
  Example& a = s.add(*GetParam()->make_catalog({}));
  a.now.link.jog_ends = JogEnds::by_watchdog;
  for (std::size_t i = 0; i < a.tab->catalog().axes.size(); ++i) {
    AxisProfile& axis = a.tab->settings.profile.axes[i];
    axis.unit_choice = own_unit_choice;
    axis.own_unit.name = "mm";
    axis.own_unit.per_step = 0.01;
  }
  a.tab->settings.profile.unit = "mm";
  a.tab->settings.edited();
  gui::choose_jog(*a.tab, Steps(100), Pps(1000));
  s.run(0.2);
  const Widget* badge = s.stage.find("jog/guarantee");
  ASSERT_TRUE(badge);
  EXPECT_EQ(badge->label, "watchdog");
  EXPECT_THAT(std::string(badge->value), testing::StartsWith("stops it: 13.0"));
  EXPECT_THAT(std::string(badge->value), testing::HasSubstr(" mm"));
  gui::choose_jog(*a.tab, Steps(100), Pps(500));
  s.run(0.2);
  EXPECT_THAT(s.value("jog/guarantee"), testing::StartsWith("stops it: 6.5"));
}

INSTANTIATE_TEST_SUITE_P(Controllers, EveryBadge, testing::ValuesIn([] {
                           std::vector<const DeviceType*> all;
                           for (const DeviceType& type : device_types()) all.push_back(&type);
                           return all;
                         }()),
                         [](const auto& info) {
                           std::string name(info.param->model);
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

/// Of a controller that can run a guard itself.
class GuardOfferTest : public testing::Test {
 protected:
  static Catalog offering() {
    Catalog c = example_catalog();
    c.jog_guard = {"It stops a held jog.", "It is kept as program 3.", "It is a guess."};
    return c;
  }
  ConsoleStage s;
  Example& a = s.add(offering());

  void SetUp() override {
    for (AxisState& axis : a.now.axes) axis.own_speed = Pps(1000);
    a.now.link.jog_ends = JogEnds::by_watchdog;
    is(JogGuard::State::absent);
  }
  void is(JogGuard::State state) {
    a.now.jog_guard = {state, std::chrono::milliseconds(600)};
    s.run(0.1);
  }
};

TEST_F(GuardOfferTest, IsInstalledOnlyWhenItsUserAgrees) {
  MUST(s.hand.click("jog/guarantee"));
  s.run(0.1);
  EXPECT_EQ(s.value("jog/guard/state"), "The guard is not installed. The program memory is empty.");
  EXPECT_EQ(a.count<intent::GuardJogs>(), 0);
  MUST(s.hand.click("jog/guard/close"));
  s.run(0.1);
  EXPECT_EQ(s.stage.find("jog/guard/state"), nullptr);
  EXPECT_EQ(a.count<intent::GuardJogs>(), 0);
  MUST(s.hand.click("jog/guarantee"));
  MUST(s.hand.click("jog/guard/install"));
  ASSERT_TRUE(a.last<intent::GuardJogs>());
  EXPECT_TRUE(a.last<intent::GuardJogs>()->on);
}

TEST_F(GuardOfferTest, TheBadgeNamesTheControllerAndTheSheetTakesItAway) {
  is(JogGuard::State::installed);
  ASSERT_TRUE(s.stage.find("jog/guarantee"));
  EXPECT_EQ(s.stage.find("jog/guarantee")->label, "controller");
  EXPECT_EQ(s.value("jog/guarantee"), "600 steps, a guess");
  MUST(s.hand.click("jog/guarantee"));
  MUST(s.hand.click("jog/guard/remove"));
  ASSERT_TRUE(a.last<intent::GuardJogs>());
  EXPECT_FALSE(a.last<intent::GuardJogs>()->on);
}

TEST_F(GuardOfferTest, NeedsAnEmptyProgramMemoryAndAxesThatStand) {
  is(JogGuard::State::no_room);
  MUST(s.hand.click("jog/guarantee"));
  s.run(0.1);
  ASSERT_TRUE(s.stage.find("jog/guard/install"));
  EXPECT_NE(s.stage.find("jog/guard/install")->reason, "");
  is(JogGuard::State::absent);
  EXPECT_EQ(s.stage.find("jog/guard/install")->reason, "");
  a.now.axes[0].activity = Activity::moving;
  s.run(0.1);
  EXPECT_EQ(s.stage.find("jog/guard/install")->reason, "Stop the axes first.");
}

TEST_F(GuaranteeTest, BacklashIsTypedAtTheNumberAndKept) {
  MUST(s.hand.click("dro/1/position"));
  MUST(s.hand.type("dro/1/backlash", "60\n"));
  ASSERT_TRUE(a.last<intent::SetBacklash>());
  EXPECT_EQ(a.last<intent::SetBacklash>()->backlash, (Backlash{Steps(60), Sign::plus}));
  MUST(s.hand.click("dro/1/backlash/way"));
  EXPECT_EQ(a.last<intent::SetBacklash>()->backlash, (Backlash{Steps(60), Sign::minus}));
  EXPECT_EQ(a.tab->settings.profile.axes[0].backlash, (Backlash{Steps(60), Sign::minus}));
}

}  // namespace
}  // namespace hw::panels
