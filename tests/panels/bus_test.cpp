// Controllers of one wire behind one tab.
#include <gtest/gtest.h>

#include "tests/panels/console_stage.h"
#include "tests/panels/must.h"

namespace hw::panels {
namespace {

using namespace gui;

Catalog one_of_bus(int id) {
  Catalog c = example_catalog(1);
  c.address = id;
  c.axes[0].name = c.id();
  c.can.broadcast = true;
  return c;
}

class BusTest : public testing::Test {
 protected:
  ConsoleStage s;
  Example& a = s.add(one_of_bus(1));
  Example& b = s.add(one_of_bus(2));
  Example& c = s.add(one_of_bus(3));
  void SetUp() override {
    s.console.join({a.tab, b.tab, c.tab}, "Example 01-03");
    s.run(0.1);
  }
};

TEST_F(BusTest, OneTabAndARowForEach) {
  EXPECT_TRUE(s.stage.find("controller/1"));
  EXPECT_FALSE(s.stage.find("controller/2"));
  for (const char* id :
       {"bus/01", "bus/02", "bus/03", "dro/02/position", "dro/03/state", "jog/01/+", "jog/03/-"})
    EXPECT_TRUE(s.stage.find(id)) << id;
}

TEST_F(BusTest, ChoosingARowPutsTheOtherPanelsOnIt) {
  MUST(s.hand.click("bus/03"));
  s.run(0.1);
  EXPECT_EQ(s.console.active(), c.tab);
  MUST(s.hand.type("goto/03", "500\n"));
  s.run(0.1);
  EXPECT_EQ(c.count<intent::MoveTo>(), 1);
  EXPECT_EQ(a.count<intent::MoveTo>(), 0);
}

TEST_F(BusTest, TheStatusLineNamesAllThatMove) {
  const auto sentence = [&] {
    s.run(0.1);
    return s.value("status/text");
  };
  b.now.axes[0].activity = Activity::moving;
  EXPECT_EQ(sentence(), "02 moves. Esc stops everything.");
  c.now.axes[0].activity = Activity::moving;
  EXPECT_EQ(sentence(), "02 and 03 move. Esc stops everything.");
  a.now.axes[0].activity = Activity::moving;
  EXPECT_EQ(sentence(), "01, 02 and 03 move. Esc stops everything.");
  b.now.axes[0].activity = Activity::error;
  b.now.notice = "Axis X hit its + limit.";
  EXPECT_EQ(sentence(), "02: Axis X hit its + limit. 01 and 03 move.");
}

TEST_F(BusTest, TheStatusLineShowsTheWorstOfAllDevices) {
  c.now.axes[0].trust.doubt(Doubt::power_cut, {});
  s.run(0.1);
  EXPECT_NE(s.value("status/text").find("03 cannot be trusted"), std::string::npos) << s.value("status/text");
  a.now.axes[0].activity = Activity::moving;
  s.run(0.1);
  EXPECT_NE(s.value("status/text").find("03 cannot be trusted"), std::string::npos) << s.value("status/text");
  EXPECT_NE(s.value("status/text").find("01 moves."), std::string::npos);
}

TEST_F(BusTest, AMessageOfADeviceNamesTheDevice) {
  s.console.toast(*b.tab, Severity::fault, "The controller did not answer in time.");
  s.run(0.1);
  EXPECT_EQ(s.value("toast/1"), "02: The controller did not answer in time.");
}

TEST_F(BusTest, ATapOnANumberOnlyChooses) {
  for (int tap = 0; tap < 2; ++tap) {
    MUST(s.hand.click("dro/02/position"));
    s.run(0.1);
    EXPECT_EQ(s.console.active(), b.tab);
    EXPECT_FALSE(s.stage.find("dro/02/zero")) << "the menu has a button of its own";
  }
  MUST(s.hand.click("dro/02/menu"));
  s.run(0.1);
  EXPECT_TRUE(s.stage.find("dro/02/zero"));
}

TEST_F(BusTest, ARowJogsItsOwnController) {
  MUST(s.hand.press("jog/02/+"));
  s.run(0.5);
  EXPECT_EQ(b.count<intent::JogStart>(), 1);
  EXPECT_EQ(a.count<intent::JogStart>(), 0);
  MUST(s.hand.release("jog/02/+"));
  s.run(0.1);
  EXPECT_EQ(b.count<intent::JogStop>(), 1);
}

TEST_F(BusTest, StopReachesAll) {
  MUST(s.hand.click("stop_all"));
  for (const Example* e : {&a, &b, &c}) EXPECT_EQ(e->count<intent::Stop>(), 1);
}

TEST_F(BusTest, ThePadStopsTheChosenOne) {
  MUST(s.hand.click("jog/stop"));
  EXPECT_EQ(a.count<intent::Stop>(), 1);
  EXPECT_EQ(b.count<intent::Stop>(), 0);
}

TEST_F(BusTest, ADeviceInTroubleIsNamedAndShownAndKeepsItsPlace) {
  s.run(0.2);
  const float was = s.stage.find("bus/03")->rect.min.y;
  c.now.link.state = LinkState::lost;
  s.run(0.2);
  EXPECT_EQ(s.stage.find("bus/03")->rect.min.y, was) << "each row has jog buttons";
  ASSERT_TRUE(s.stage.find("bus/trouble"));
  EXPECT_EQ(s.stage.find("bus/trouble")->label, "Show 03");
  MUST(s.hand.click("bus/trouble"));
  EXPECT_TRUE(s.stage.find("bus/03")->in_view());
  EXPECT_EQ(s.value("bus/summary"), "2 of 3 answer, trouble: 1");
  EXPECT_EQ(s.value("status/text").substr(0, 4), "03: ");
}

TEST_F(BusTest, TheStatusLineCallsADeviceByItsIdAndNotItsOnlyAxis) {
  b.now.axes[0].activity = Activity::moving;
  b.now.axes[0].direction = -1;
  s.run(0.2);
  EXPECT_EQ(s.value("status/text"), "02 moves -. Esc stops everything.");
  b.now.axes[0].activity = Activity::idle;
  a.now.axes[0].position_known = false;
  s.run(0.2);
  EXPECT_EQ(s.value("status/text"), "The position of 01 is not known. Home it, or set its position.");
}

TEST_F(BusTest, TheTerminalSpeaksToOneOrToAll) {
  MUST(s.hand.click("terminal/to"));
  MUST(s.hand.click("terminal/to/all"));
  MUST(s.hand.type("terminal/command", "CLR\n"));
  s.run(0.1);
  ASSERT_TRUE(a.last<intent::SendText>());
  EXPECT_TRUE(a.last<intent::SendText>()->broadcast);
  EXPECT_EQ(s.value("terminal/to"), "01") << "all is meant for one line";
  MUST(s.hand.type("terminal/command", "CLR\n"));
  s.run(0.1);
  EXPECT_FALSE(a.last<intent::SendText>()->broadcast);
  MUST(s.hand.click("terminal/to"));
  MUST(s.hand.click("terminal/to/02"));
  s.run(0.1);
  EXPECT_EQ(s.console.active(), b.tab);
}

TEST_F(BusTest, OneChoiceOfStepAndSpeedIsForAllRows) {
  a.tab->settings.profile.jog_speed = Pps(300);
  MUST(s.hand.click("bus/02"));
  s.run(0.1);
  MUST(s.hand.click("jog/step/100"));
  MUST(s.hand.press("jog/speed"));
  MUST(s.hand.release("jog/speed"));
  MUST(s.hand.click("bus/01"));
  s.run(0.1);
  EXPECT_EQ(s.value("jog/step/100"), "on");
  MUST(s.hand.click("jog/03/+"));
  s.run(0.1);
  ASSERT_TRUE(c.last<intent::MoveBy>());
  EXPECT_EQ(c.last<intent::MoveBy>()->distances[0].value, Steps(100));
  const Pps speed = a.tab->settings.profile.jog_speed;
  EXPECT_NE(speed, Pps(300));
  EXPECT_EQ(b.tab->settings.profile.jog_speed, speed);
  EXPECT_EQ(c.tab->settings.profile.jog_speed, speed);
}

TEST(Bus, AJoiningDeviceTakesTheChosenStep) {
  ConsoleStage s;
  Example& a = s.add(one_of_bus(1));
  Example& b = s.add(one_of_bus(2));
  a.tab->settings.profile.jog_step = Steps(10);
  a.tab->settings.profile.jog_speed = Pps(300);
  b.tab->settings.profile.jog_step = Steps(1000);
  s.console.join({a.tab, b.tab}, "Example 01-02");
  s.run(0.1);
  EXPECT_EQ(s.value("jog/step/10"), "on");
  MUST(s.hand.click("jog/02/+"));
  s.run(0.1);
  ASSERT_TRUE(b.last<intent::MoveBy>());
  EXPECT_EQ(b.last<intent::MoveBy>()->distances[0].value, Steps(10));
  EXPECT_EQ(b.tab->settings.profile.jog_speed, Pps(300));
}

TEST_F(BusTest, TheSpeedShownIsThatOfAllRows) {
  EXPECT_EQ(s.value("jog/speed"), "2000 steps/s");
  c.now.axes[0].own_speed = Pps(500);
  s.run(0.1);
  EXPECT_EQ(s.value("jog/speed"), "each its own");
}

TEST_F(BusTest, RowsInDifferentUnitsCountInTheirOwn) {
  b.tab->settings.profile.unit = "real";
  b.tab->settings.profile.axes[0].unit_choice = "screw of 1 mm";
  b.tab->settings.edited();
  MUST(s.hand.click("bus/02"));
  s.run(0.1);
  MUST(s.hand.click("jog/step/10"));
  s.run(0.1);
  EXPECT_EQ(s.value("jog/step/10"), "on");
  MUST(s.hand.click("jog/02/+"));
  s.run(0.1);
  ASSERT_TRUE(b.last<intent::MoveBy>());
  EXPECT_EQ(b.last<intent::MoveBy>()->distances[0].value, Steps(4000)) << "10 mm";
  MUST(s.hand.click("jog/03/+"));
  s.run(0.1);
  ASSERT_TRUE(c.last<intent::MoveBy>());
  EXPECT_EQ(c.last<intent::MoveBy>()->distances[0].value, Steps(10));
}

TEST_F(BusTest, TheNameIsThatOfTheBus) {
  MUST(s.hand.click("bus/02"));
  s.run(0.1);
  for (const char* requested : {"Lift bus", ""}) {
    MUST(s.hand.click("menu"));
    s.run(0.1);
    MUST(s.hand.click("menu/names"));
    s.run(0.1);
    MUST(s.hand.type("names/controller", requested));
    MUST(s.hand.click("names/ok"));
    s.run(0.1);
    for (const Example* e : {&a, &b, &c})
      EXPECT_EQ(e->tab->name(), *requested ? std::string_view(requested) : "Example 01-03");
  }
}

TEST_F(BusTest, ClosingAsksForEachThatMovesAndStopsAll) {
  c.now.axes[0].activity = Activity::moving;
  s.run(0.1);
  MUST(s.hand.click("menu"));
  s.run(0.1);
  MUST(s.hand.click("menu/close"));
  s.run(0.1);
  ASSERT_EQ(s.console.tabs().size(), 3u) << "03 moves";
  MUST(s.hand.click("close/stop"));
  for (const Example* e : {&a, &b, &c}) EXPECT_EQ(e->count<intent::Stop>(), 1);
  EXPECT_TRUE(s.console.tabs().empty());
}

TEST_F(BusTest, ClosingAsksNothingAboutAnUnreachedDevice) {
  b.now.axes[0].activity = Activity::moving;
  b.now.link.state = LinkState::lost;
  s.run(0.1);
  MUST(s.hand.click("menu"));
  s.run(0.1);
  MUST(s.hand.click("menu/close"));
  s.run(0.1);
  EXPECT_TRUE(s.console.tabs().empty());
}

TEST_F(BusTest, ClosingTheTabClosesAll) {
  s.console.close(*b.tab);
  a.tab = b.tab = c.tab = nullptr;
  EXPECT_TRUE(s.console.tabs().empty());
}

}  // namespace
}  // namespace hw::panels
