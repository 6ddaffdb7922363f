// What hands can do to a controller through the side panels, and that nothing outlives the hand.
#include <gtest/gtest.h>

#include "gui/input/input_queue.h"
#include "tests/panels/console_stage.h"
#include "tests/panels/must.h"

namespace hw::panels {
namespace {

using namespace gui;

class HandsTest : public testing::Test {
 protected:
  ConsoleStage s;
  Example& a = s.add();
  void SetUp() override { s.run(0.1); }
};

// ---- jog

TEST_F(HandsTest, TapIsOneChosenStep) {
  MUST(s.hand.click("jog/step/100"));
  MUST(s.hand.press("jog/1/+"));
  s.run(0.1);
  MUST(s.hand.release("jog/1/+"));
  s.run(0.5);
  ASSERT_EQ(a.sent.size(), 1u);
  const auto* by = a.last<intent::MoveBy>();
  ASSERT_TRUE(by);
  EXPECT_EQ(by->distances[0].axis.index, 0);
  EXPECT_EQ(by->distances[0].value, Steps(100));
}

TEST_F(HandsTest, HoldJogsAndLettingGoStops) {
  MUST(s.hand.press("jog/2/-"));
  s.run(1.0);
  const auto* start = a.last<intent::JogStart>();
  ASSERT_TRUE(start);
  EXPECT_EQ(start->axis.index, 1);
  EXPECT_EQ(start->sign, Sign::minus);
  EXPECT_EQ(start->speed, Pps(0)) << "the controller's own speed until one is chosen";
  EXPECT_GT(a.count<intent::JogKeepAlive>(), 6);
  EXPECT_EQ(a.count<intent::JogStop>(), 0);
  MUST(s.hand.release("jog/2/-"));
  s.run(0.1);
  EXPECT_EQ(a.count<intent::JogStop>(), 1);
  EXPECT_EQ(a.count<intent::MoveBy>(), 0);
  const int alive = a.count<intent::JogKeepAlive>();
  s.run(0.5);
  EXPECT_EQ(a.count<intent::JogKeepAlive>(), alive);
}

TEST_F(HandsTest, LeavingTheButtonWithTheMouseDoesNotStop) {
  MUST(s.hand.press("jog/1/+"));
  s.run(0.5);
  s.stage.push(InputEvent::mouse_move(700, 500, s.stage.now_s));
  s.run(0.2);
  EXPECT_EQ(a.count<intent::JogStop>(), 0);
  s.stage.push(InputEvent::mouse_button(0, false, ImVec2(700, 500), s.stage.now_s));
  s.run(0.1);
  EXPECT_EQ(a.count<intent::JogStop>(), 1);
}

TEST_F(HandsTest, FocusLossStopsAHeldJogAndForgetsATap) {
  MUST(s.hand.press("jog/1/+"));
  s.run(0.5);
  s.hand.lose_focus();
  s.run(0.1);
  EXPECT_EQ(a.count<intent::JogStop>(), 1);
  MUST(s.hand.press("jog/1/+"));
  s.run(0.1);
  s.hand.lose_focus();
  s.run(0.5);
  EXPECT_EQ(a.count<intent::MoveBy>(), 0);
  EXPECT_EQ(a.count<intent::JogStart>(), 1);
}

TEST_F(HandsTest, KeysJogWhileHeld) {
  MUST(s.hand.key_down("Right"));
  s.run(0.6);
  EXPECT_EQ(a.count<intent::JogStart>(), 1);
  MUST(s.hand.key_up("Right"));
  s.run(0.1);
  EXPECT_EQ(a.count<intent::JogStop>(), 1);
  MUST(s.hand.key("Up"));
  s.run(0.1);
  const auto* by = a.last<intent::MoveBy>();
  ASSERT_TRUE(by);
  EXPECT_EQ(by->distances[0].axis.index, 1);
}

TEST_F(HandsTest, TwoKeysReleasedInAnyOrderLeaveNothingMoving) {
  MUST(s.hand.key_down("Right"));
  s.run(0.5);
  MUST(s.hand.key_down("Up"));
  s.run(0.5);
  MUST(s.hand.key_up("Right"));
  MUST(s.hand.key_up("Up"));
  s.run(0.1);
  EXPECT_EQ(a.count<intent::JogStart>(), 2);
  EXPECT_EQ(a.count<intent::JogStop>(), 2);
}

TEST_F(HandsTest, ArrowsInAFieldJogNothing) {
  MUST(s.hand.click("goto/1"));
  s.run(0.1);
  MUST(s.hand.key("Right"));
  s.run(0.4);
  EXPECT_TRUE(a.sent.empty());
}

TEST_F(HandsTest, ChangingTheControllerStopsAHeldJog) {
  Example& b = s.add();
  s.run(0.1);
  MUST(s.hand.key_down("Right"));
  s.run(0.5);
  ASSERT_EQ(b.count<intent::JogStart>(), 1);
  MUST(s.hand.key("Ctrl+Tab"));
  s.run(0.5);
  EXPECT_EQ(b.count<intent::JogStop>(), 1);
  EXPECT_TRUE(a.sent.empty()) << "the key that is still down jogs nobody else";
}

TEST_F(HandsTest, ALimitDisablesItsDirectionOnly) {
  a.now.axes[0].limit_plus = true;
  s.run(0.1);
  EXPECT_FALSE(s.stage.find("jog/1/+")->enabled);
  EXPECT_TRUE(s.stage.find("jog/1/-")->enabled);
  EXPECT_EQ(s.stage.find("jog/1/+")->reason, "The axis is on its + limit. It can only move −.");
}

TEST_F(HandsTest, StopButtonOfThePadStopsThisController) {
  MUST(s.hand.click("jog/stop"));
  ASSERT_EQ(a.sent.size(), 1u);
  EXPECT_TRUE(a.last<intent::Stop>());
}

TEST_F(HandsTest, TheShownSpeedIsTheControllersOwnUntilOneIsChosen) {
  const auto shown = [&] {
    s.run(0.1);
    return s.stage.find("jog/speed")->value;
  };
  a.now.axes[0].own_speed = a.now.axes[1].own_speed = Pps(200000);
  EXPECT_EQ(shown(), "200000 steps/s");
  a.now.axes[1].own_speed = Pps(300);
  EXPECT_EQ(shown(), "each its own");
  a.now.axes[1].own_speed = Pps(0);
  EXPECT_EQ(shown(), "not known yet");
  a.now.axes[1].enabled = false;
  EXPECT_EQ(shown(), "200000 steps/s");
  a.now.axes[0].enabled = false;
  a.now.axes[1].own_speed = Pps(200000);
  EXPECT_EQ(shown(), "200000 steps/s");  // all of them off: what they will do
  a.tab->settings.profile.jog_speed = Pps(500);
  EXPECT_EQ(shown(), "500 steps/s");
}

TEST_F(HandsTest, TheChosenSpeedGoesWithTheJog) {
  a.tab->settings.profile.jog_speed = Pps(500);
  MUST(s.hand.press("jog/1/+"));
  s.run(0.4);
  EXPECT_EQ(a.last<intent::JogStart>()->speed, Pps(500));
}

// ---- stop

TEST_F(HandsTest, StopReachesAllControllers) {
  Example& b = s.add();
  s.run(0.1);
  MUST(s.hand.click("stop_all"));
  EXPECT_EQ(a.count<intent::Stop>(), 1);
  EXPECT_EQ(b.count<intent::Stop>(), 1);
  MUST(s.hand.key("Escape"));
  EXPECT_EQ(a.count<intent::Stop>(), 2);
  EXPECT_EQ(b.count<intent::Stop>(), 2);
}

TEST_F(HandsTest, ShiftEscStopsAtOnce) {
  MUST(s.hand.key("Shift+Escape"));
  EXPECT_EQ(a.count<intent::Stop>(), 2) << "the second one in a row is without a ramp";
}

TEST_F(HandsTest, EscStopsWhileTypingAndWithAListOpen) {
  MUST(s.hand.click("goto/1"));
  MUST(s.hand.key("Escape"));
  EXPECT_EQ(a.count<intent::Stop>(), 1);
  MUST(s.hand.click("dro/unit"));
  s.run(0.1);
  MUST(s.hand.key("Escape"));
  EXPECT_EQ(a.count<intent::Stop>(), 2);
  s.run(0.1);
  EXPECT_FALSE(s.hand.exists("dro/unit/steps")) << "and closes the list";
}

TEST_F(HandsTest, EscDuringAJogSendsOneStop) {  // a second one would mean: without ramp
  MUST(s.hand.press("jog/1/+"));
  s.run(0.5);
  MUST(s.hand.key("Escape"));
  MUST(s.hand.release("jog/1/+"));
  s.run(0.3);
  EXPECT_EQ(a.count<intent::Stop>(), 1);
  EXPECT_EQ(a.count<intent::JogStop>(), 0);
}

TEST_F(HandsTest, StopIsTheFirstWidgetAndInTheCorner) {
  const Widget& first = s.stage.surface.screen().registry().widgets()[0];
  EXPECT_EQ(first.id, "stop_all");
  EXPECT_EQ(first.rect.max.x, 1440);
  EXPECT_EQ(first.rect.min.y, 0);
}

// ---- go to, home

TEST_F(HandsTest, GoToInSteps) {
  MUST(s.hand.type("goto/1", "-400\n"));
  const auto* to = a.last<intent::MoveTo>();
  ASSERT_TRUE(to);
  EXPECT_EQ(to->targets[0].value, Steps(-400));
  MUST(s.hand.type("goto/2", "57 000"));
  MUST(s.hand.click("goto/2/go"));
  EXPECT_EQ(a.last<intent::MoveTo>()->targets[0].value, Steps(57000));
  EXPECT_EQ(a.last<intent::MoveTo>()->targets[0].axis.index, 1);
}

TEST_F(HandsTest, GoToInRealUnitsReadsCommaAndPoint) {
  a.tab->settings.profile.unit = "real";
  a.tab->settings.profile.axes[0].unit_choice = "screw of 1 mm";
  a.tab->settings.edited();
  s.run(0.1);
  MUST(s.hand.type("goto/1", "12,5\n"));
  EXPECT_EQ(a.last<intent::MoveTo>()->targets[0].value, Steps(5000));
}

TEST_F(HandsTest, OutOfRangeIsRefusedWithTheNearestThatGoes) {
  MUST(s.hand.type("goto/1", "9000000\n"));
  s.run(0.1);
  EXPECT_TRUE(a.sent.empty());
  MUST(s.hand.click("goto/1/nearest"));
  EXPECT_EQ(a.last<intent::MoveTo>()->targets[0].value, Steps(8388607));
}

TEST_F(HandsTest, TypingAloneMovesNothing) {
  MUST(s.hand.type("goto/1", "400"));
  MUST(s.hand.click("goto/2"));
  s.run(0.2);
  EXPECT_TRUE(a.sent.empty());
}

TEST_F(HandsTest, ATypedTargetStaysWhenItIsRefused) {
  MUST(s.hand.type("goto/1", "400\n"));
  a.outcome(IntentState::refused, "The axis stands on its limit. Nothing was sent.");
  s.run(0.1);
  EXPECT_EQ(s.value("goto/1"), "400");
}

TEST_F(HandsTest, Home) {
  MUST(s.hand.click("home/1/-"));
  ASSERT_TRUE(a.last<intent::Home>());
  EXPECT_EQ(a.last<intent::Home>()->sign, Sign::minus);
  EXPECT_EQ(a.last<intent::Home>()->mode, 0);
  MUST(s.hand.click("home/2/+"));
  EXPECT_EQ(a.last<intent::Home>()->axis.index, 1);
}

TEST_F(HandsTest, WhileAProgramRunsNothingElseMovesAndThisIsShown) {
  a.now.program.owned = true;
  a.now.program.slot = 0;
  a.now.program.run = RunState::running;
  s.run(0.1);
  for (const char* id : {"jog/1/+", "goto/1/go", "home/1/-"}) {
    EXPECT_FALSE(s.stage.find(id)->enabled) << id;
    EXPECT_NE(s.stage.find(id)->reason.find("Program 0 is running"), std::string_view::npos) << id;
  }
  EXPECT_TRUE(s.stage.find("jog/stop")->enabled);
  EXPECT_TRUE(s.stage.find("stop_all")->enabled);
}

// ---- outputs

TEST_F(HandsTest, AnOutputChangesWhenTheControllerHasReportedIt) {
  MUST(s.hand.click("io/out/1"));
  ASSERT_TRUE(a.last<intent::SetOutput>());
  EXPECT_TRUE(a.last<intent::SetOutput>()->on);
  s.run(0.05);
  EXPECT_EQ(s.value("io/out/1"), "sending");
  a.now.outputs = 1;
  a.outcome(IntentState::done);
  s.run(0.05);
  EXPECT_EQ(s.value("io/out/1"), "on");
  MUST(s.hand.click("io/out/1"));
  EXPECT_FALSE(a.last<intent::SetOutput>()->on);
  a.outcome(IntentState::refused, "Not now.");
  s.run(0.05);
  EXPECT_EQ(s.value("io/out/1"), "refused");
}

// ---- bench

TEST_F(HandsTest, BenchButtonsArePressedAsLongAsTheyAreHeld) {
  MUST(s.hand.press("bench/button/Run"));
  s.run(0.2);
  ASSERT_TRUE(a.last_operated<bench::Button>());
  EXPECT_TRUE(a.last_operated<bench::Button>()->pressed);
  MUST(s.hand.release("bench/button/Run"));
  s.run(0.1);
  EXPECT_FALSE(a.last_operated<bench::Button>()->pressed);
  EXPECT_EQ(a.operated.size(), 2u);
}

TEST_F(HandsTest, EachBoxOnTheBenchHasItsSwitchAndItsBreaker) {
  MUST(s.hand.click("bench/power"));
  EXPECT_EQ(a.last_operated<bench::Power>()->supply, 0);
  MUST(s.hand.click("bench/power/Second"));
  EXPECT_EQ(a.last_operated<bench::Power>()->supply, 1);
  MUST(s.hand.click("bench/button/Second Run"));
  EXPECT_EQ(a.last_operated<bench::Button>()->name, "Second Run");
  EXPECT_EQ(s.value("bench/breaker/Second"), "in");
  MUST(s.hand.click("bench/trip/Second"));
  EXPECT_TRUE(a.last_operated<bench::Breaker>()->out);
  a.bench.breakers_out = 2;
  s.run(0.05);
  EXPECT_EQ(s.value("bench/breaker"), "in");
  EXPECT_EQ(s.value("bench/breaker/Second"), "out");
  MUST(s.hand.click("bench/breaker/Second"));
  EXPECT_FALSE(a.last_operated<bench::Breaker>()->out);
  EXPECT_EQ(a.last_operated<bench::Breaker>()->supply, 1);
}

TEST_F(HandsTest, BenchCanDoEverythingThatASwitchCan) {
  MUST(s.hand.click("bench/power"));
  EXPECT_FALSE(a.last_operated<bench::Power>()->on);
  MUST(s.hand.click("bench/unplug"));
  EXPECT_TRUE(a.last_operated<bench::Unplug>()->on);
  MUST(s.hand.click("bench/garble"));
  EXPECT_TRUE(a.last_operated<bench::Garble>());
  MUST(s.hand.click("bench/drop"));
  EXPECT_TRUE(a.last_operated<bench::Drop>());
  MUST(s.hand.click("bench/power_cycle"));
  EXPECT_TRUE(a.last_operated<bench::PowerCycle>());
  MUST(s.hand.click("bench/jam/2"));
  EXPECT_EQ(a.last_operated<bench::Jam>()->axis.index, 1);
  MUST(s.hand.click("bench/limit/1/+"));
  EXPECT_EQ(a.last_operated<bench::Limit>()->sign, Sign::plus);
  MUST(s.hand.click("bench/in/3"));
  EXPECT_EQ(a.last_operated<bench::Input>()->number, 3);
  MUST(s.hand.click("bench/analog/1"));
  EXPECT_TRUE(a.last_operated<bench::Analog>());
}

// ---- position

TEST_F(HandsTest, HereIsZero) {
  MUST(s.hand.click("dro/1/position"));
  s.run(0.1);
  MUST(s.hand.click("dro/1/zero"));
  ASSERT_TRUE(a.last<intent::SetPosition>());
  EXPECT_EQ(a.last<intent::SetPosition>()->axis, 0);
}

TEST_F(HandsTest, UnitsAreChosenPerAxis) {
  a.now.axes[0].position = Steps(3120);
  MUST(s.hand.click("dro/unit"));
  s.run(0.1);
  MUST(s.hand.click("dro/unit/axis/1"));
  s.run(0.1);
  MUST(s.hand.click("dro/unit/axis/1/screw of 1 mm"));
  s.run(0.2);
  EXPECT_EQ(s.value("dro/1/position"), "7.800");
  EXPECT_EQ(s.value("dro/2/position"), "0");
}

// The same button at the same place moves another controller's axis now: it has only just come.
TEST_F(HandsTest, AnotherControllersButtonUnderTheHandTakesNoPressAtOnce) {
  Example& b = s.add();
  s.console.activate(*a.tab);
  s.run(1);
  const ImVec2 at = s.stage.find("jog/1/+")->rect.centre();
  const auto click = [&] {
    s.stage.push(InputEvent::mouse_move(at.x, at.y, s.stage.now_s));
    s.stage.push(InputEvent::mouse_button(0, true, at, s.stage.now_s));
    s.stage.frames(2);
    s.stage.push(InputEvent::mouse_button(0, false, at, s.stage.now_s));
    s.stage.frames(2);
  };
  s.console.activate(*b.tab);
  s.stage.frame();
  click();
  EXPECT_EQ(b.count<intent::MoveBy>() + a.count<intent::MoveBy>(), 0);
  s.run(0.4);
  click();
  EXPECT_EQ(b.count<intent::MoveBy>(), 1);
}

}  // namespace
}  // namespace hw::panels
