// A position that is not to be trusted, and a motor without power: what a hand is told, and the ways out
// beside it.
#include <gtest/gtest.h>

#include "tests/panels/console_stage.h"
#include "tests/panels/full_catalog.h"
#include "tests/panels/must.h"

namespace hw::panels {
namespace {

using namespace gui;

class DoubtTest : public testing::Test {
 protected:
  ConsoleStage s;
  Example& a = s.add(doubted_catalog());

  static Catalog doubted_catalog() {
    Catalog c = example_catalog();
    c.can.interpolates = true;
    c.homing_modes[0].sets_position = false;
    for (AxisInfo& axis : c.axes) axis.switchable = true;
    return c;
  }
  void SetUp() override {
    s.run(0.1);
    a.tab->view.unset_read = true;
  }
  void doubt(int axis) { a.now.axes[axis].trust.doubt(Doubt::power_cut, s.scheduler.now()); }
  /// As the pump does it.
  void refuse(std::uint32_t doubtful) {
    a.outcome(IntentState::refused, "in the controller's own words", doubtful);
    s.run(0.1);
  }
  /// Go of axis 1, refused.
  void go_and_be_refused() {
    a.now.axes[0].position = Steps(40);
    doubt(0);
    s.run(0.1);
    MUST(s.hand.type("goto/1", "2400\n"));
    s.run(0.1);
    ASSERT_TRUE(a.last<intent::MoveTo>());
    refuse(1);
    ASSERT_TRUE(s.hand.exists("goto/1/refused"));
  }
  bool usable(std::string_view id) { return s.stage.find(id)->enabled; }
};

TEST_F(DoubtTest, TheRefusalSpeaksTheConsolesUnitsAndClock) {
  a.tab->settings.profile.unit = "mm";
  a.tab->settings.profile.axes[0].unit_choice = "screw of 1 mm";
  a.tab->settings.edited();
  doubt(0);
  s.run(0.1);
  MUST(s.hand.type("goto/1", "240\n"));
  s.run(0.1);
  refuse(1);
  const std::string words = s.value("goto/1/refused");
  EXPECT_TRUE(words.starts_with("The position of motor 1 cannot be trusted: its power was cut (")) << words;
  EXPECT_TRUE(
      words.ends_with("). 240.000 mm may differ from before. Nothing was sent. Home it, set its position, or "
                      "go on just this once."))
      << words;
  EXPECT_EQ(s.value("goto/1/stands_at"), "0.000") << "as it counts";
}

TEST_F(DoubtTest, OnceGoesOnce) {
  go_and_be_refused();
  EXPECT_FALSE(a.last<intent::MoveTo>()->despite_doubt);
  MUST(s.hand.click("goto/1/once"));
  s.run(0.1);
  ASSERT_EQ(a.count<intent::MoveTo>(), 2);
  EXPECT_TRUE(a.last<intent::MoveTo>()->despite_doubt);
  EXPECT_EQ(a.last<intent::MoveTo>()->targets[0].value, Steps(2400));
  EXPECT_FALSE(s.hand.exists("goto/1/refused"));
  MUST(s.hand.click("goto/1/go"));
  EXPECT_EQ(a.count<intent::MoveTo>(), 3);
  EXPECT_FALSE(a.last<intent::MoveTo>()->despite_doubt);
}

TEST_F(DoubtTest, ItStandsWhereItCountsOrWhereTheUserSetsIt) {
  go_and_be_refused();
  EXPECT_EQ(s.value("goto/1/stands_at"), "40");
  MUST(s.hand.click("goto/1/set"));
  ASSERT_TRUE(a.last<intent::TrustPosition>());
  EXPECT_EQ(a.last<intent::TrustPosition>()->axis, AxisId{0});
  EXPECT_TRUE(s.hand.exists("goto/1/refused")) << "until the controller has it so";
  MUST(s.hand.type("goto/1/stands_at", "-500\n"));
  s.run(0.1);
  ASSERT_TRUE(a.last<intent::SetPosition>());
  EXPECT_EQ(a.last<intent::SetPosition>()->value, Steps(-500));
  a.outcome(IntentState::refused, "It can only be called zero, not -500.");
  s.run(0.1);
  EXPECT_EQ(s.value("goto/1/refused"), "It can only be called zero, not -500.");
  MUST(s.hand.type("goto/1/stands_at", "no number"));
  s.run(0.1);
  EXPECT_FALSE(usable("goto/1/set"));
  a.now.axes[0].trust.settle(Trust::set, s.scheduler.now());
  s.run(0.1);
  EXPECT_FALSE(s.hand.exists("goto/1/refused")) << "whoever has said it";
}

TEST_F(DoubtTest, TheShownCountFollowsTheAxisUntilTheUserTypes) {
  go_and_be_refused();
  a.now.axes[0].position = Steps(77);
  s.run(0.1);
  EXPECT_EQ(s.value("goto/1/stands_at"), "77");
}

TEST_F(DoubtTest, HomeTakesAWayThatSetsTheCount) {
  go_and_be_refused();
  MUST(s.hand.click("goto/1/home/-"));
  ASSERT_TRUE(a.last<intent::Home>());
  EXPECT_EQ(a.last<intent::Home>()->axis, AxisId{0});
  EXPECT_EQ(a.last<intent::Home>()->sign, Sign::minus);
  EXPECT_EQ(a.last<intent::Home>()->mode, 1) << "the first leaves the count as it is";
}

TEST_F(DoubtTest, ReturnToZeroAndGoTogetherNameTheDoubtfulAxis) {
  doubt(1);
  MUST(s.hand.click("goto/1/with"));
  MUST(s.hand.click("goto/2/with"));
  MUST(s.hand.click("goto/zero"));
  ASSERT_TRUE(a.last<intent::MoveTo>());
  EXPECT_EQ(a.last<intent::MoveTo>()->targets.size(), 2u);
  refuse(2);
  EXPECT_TRUE(s.value("goto/2/refused").starts_with("The position of motor 2 cannot be trusted"));
  MUST(s.hand.click("goto/2/once"));
  EXPECT_EQ(a.last<intent::MoveTo>()->targets.size(), 2u) << "all of it";
  EXPECT_TRUE(a.last<intent::MoveTo>()->despite_doubt);
}

TEST_F(DoubtTest, OfSeveralOneIsDealtWithAfterTheOther) {
  doubt(0);
  doubt(1);
  MUST(s.hand.click("goto/1/with"));
  MUST(s.hand.click("goto/2/with"));
  MUST(s.hand.click("goto/zero"));
  refuse(3);
  EXPECT_TRUE(s.value("goto/1/refused").starts_with("The positions of motor 1 and motor 2 cannot"));
  a.now.axes[0].trust.settle(Trust::homed, s.scheduler.now());
  s.run(0.1);
  EXPECT_TRUE(s.value("goto/2/refused").starts_with("The position of motor 2 cannot"));
  EXPECT_TRUE(s.hand.exists("goto/2/home/+"));
}

TEST_F(DoubtTest, AnActionThatGoesToAPlaceHasThemToo) {
  Catalog c = test::full_catalog();
  c.actions[4].fields[0].is_place = c.actions[4].fields[1].is_place = true;
  Example& b = s.add(std::move(c));
  s.run(0.1);
  b.now.axes[1].trust.doubt(Doubt::killed, s.scheduler.now());
  MUST(s.hand.click("tab/control"));
  s.run(0.1);
  MUST(s.hand.click("action/arc/go"));
  ASSERT_TRUE(b.last<intent::Act>());
  b.outcome(IntentState::refused, "in the controller's own words", 2);
  s.run(0.1);
  EXPECT_TRUE(s.value("action/arc/Y/refused")
                  .starts_with("The position of axis Y cannot be trusted: it was stopped without a ramp"));
  MUST(s.hand.click("action/arc/Y/once"));
  EXPECT_EQ(b.count<intent::Act>(), 2);
  EXPECT_TRUE(b.last<intent::Act>()->despite_doubt);
}

// ---- power

TEST_F(DoubtTest, WithoutMotorPowerOnlyThatAxisIsOff) {
  const Rect pad = s.stage.find("jog/1/+")->rect, go = s.stage.find("goto/2/go")->rect;
  MUST(s.hand.type("goto/1", "400"));
  MUST(s.hand.type("goto/2", "400"));
  a.now.axes[0].enabled = false;
  s.run(0.1);
  for (const char* id : {"jog/1/+", "jog/1/-", "goto/1/go", "home/1/-", "home/1/+"}) {
    EXPECT_FALSE(usable(id)) << id;
    EXPECT_EQ(s.stage.find(id)->reason, "Motor power of 1 is off. Switch it on first.") << id;
  }
  for (const char* id : {"jog/2/+", "goto/2/go", "home/2/-"}) EXPECT_TRUE(usable(id)) << id;
  MUST(s.hand.click("goto/2/with"));
  s.run(0.1);
  EXPECT_TRUE(usable("goto/zero")) << "1 takes no part";
  MUST(s.hand.click("goto/1/with"));
  s.run(0.1);
  EXPECT_FALSE(usable("goto/zero"));
  EXPECT_FALSE(usable("goto/go"));
  const auto same = [](const Rect& x, const Rect& y) {
    return x.min.x == y.min.x && x.min.y == y.min.y && x.max.x == y.max.x && x.max.y == y.max.y;
  };
  EXPECT_TRUE(same(pad, s.stage.find("jog/1/+")->rect)) << "nothing moves under the hand";
  EXPECT_TRUE(same(go, s.stage.find("goto/2/go")->rect));
}

TEST_F(DoubtTest, TheSwitchStandsBesideTheReason) {
  a.now.axes[1].enabled = false;
  s.run(0.1);
  EXPECT_FALSE(s.hand.exists("jog/1/power"));
  MUST(s.hand.click("jog/2/power"));
  ASSERT_TRUE(a.last<intent::SetPower>());
  EXPECT_EQ(a.last<intent::SetPower>()->axis, 1);
  EXPECT_TRUE(a.last<intent::SetPower>()->on);
  a.now.axes[1].enabled = true;
  s.run(0.1);
  EXPECT_FALSE(s.hand.exists("jog/2/power"));
}

TEST_F(DoubtTest, AKeyOfAnAxisWithoutPowerShowsWhy) {
  a.now.axes[0].enabled = false;
  s.run(0.1);
  MUST(s.hand.key_down("Right"));
  s.run(0.5);
  EXPECT_TRUE(a.sent.empty());
  MUST(s.hand.key_up("Right"));
  MUST(s.hand.key_down("Up"));
  s.run(0.5);
  EXPECT_EQ(a.count<intent::JogStart>(), 1) << "the other one goes";
  MUST(s.hand.key_up("Up"));
}

TEST_F(DoubtTest, AnAxisThatIsNotSwitchedByTheControllerIsLeftToIt) {
  Catalog c = example_catalog();
  Example& b = s.add(std::move(c));
  b.now.axes[0].enabled = false;
  s.run(0.1);
  EXPECT_TRUE(usable("jog/1/+"));
  EXPECT_FALSE(s.hand.exists("jog/1/power"));
}

}  // namespace
}  // namespace hw::panels
