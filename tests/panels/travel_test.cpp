// Limits and places of the user's own: set at the number of an axis, drawn under it, kept in the profile.
#include <functional>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/device/travel_check.h"
#include "tests/panels/console_stage.h"
#include "tests/panels/must.h"

namespace hw::panels {
namespace {

using namespace gui;

class TravelTest : public testing::Test {
 protected:
  ConsoleStage s;
  Example& a = s.add(example_catalog());

  void SetUp() override {
    a.tab->view.unset_read = true;
    a.tab->settings.profile.unit = "real";
    a.tab->settings.profile.axes[0].unit_choice = "screw of 1 mm";
    a.tab->settings.edited();
    a.now.axes[0].position = Steps(4000);  // 10 mm
    s.run(0.2);
  }
  /// As the pump does it.
  void hold_to(Travel travel) {
    a.now.axes[0].travel = travel;
    s.run(0.1);
  }
  static Travel from_to(std::int64_t minus, std::int64_t plus) {
    Travel t;
    t.has_minus = t.has_plus = true;
    t.minus = Steps(minus), t.plus = Steps(plus);
    return t;
  }
};

TEST_F(TravelTest, AreTypedInTheUnitOfTheAxisAndKept) {
  MUST(s.hand.click("dro/1/position"));
  MUST(s.hand.type("dro/1/limit/+", "300\n"));
  ASSERT_TRUE(a.last<intent::SetTravel>());
  EXPECT_EQ(a.last<intent::SetTravel>()->axis, AxisId{0});
  EXPECT_FALSE(a.last<intent::SetTravel>()->travel.has_minus);
  EXPECT_EQ(a.last<intent::SetTravel>()->travel.plus, Steps(120'000));
  MUST(s.hand.click("dro/1/limit/-/here"));
  EXPECT_EQ(a.last<intent::SetTravel>()->travel, from_to(4000, 120'000));
  EXPECT_EQ(a.tab->settings.profile.axes[0].travel, from_to(4000, 120'000));
  MUST(s.hand.type("dro/1/limit/-", "400\n"));
  EXPECT_EQ(a.tab->settings.profile.axes[0].travel, from_to(4000, 120'000))
      << "it would lie past the other one";
  MUST(s.hand.click("dro/1/limit/+/none"));
  EXPECT_FALSE(a.last<intent::SetTravel>()->travel.has_plus);
}

TEST_F(TravelTest, InAUnitThatCountsAgainstTheStepsTheSmallerNumberIsTheLowerEnd) {
  a.tab->settings.profile.axes[0].reversed = true;
  a.tab->settings.edited();
  hold_to(from_to(-1200, 3200));
  EXPECT_EQ(s.value("dro/1/travel"), "-8.000 to 3.000 mm");
  Travel open = from_to(-1200, 0);
  open.has_plus = false;
  hold_to(open);
  EXPECT_EQ(s.value("dro/1/travel"), "up to 3.000 mm");
  const PastTravel past{AxisId{0}, Sign::minus, Steps(-2000), Steps(-1200)};
  EXPECT_EQ(describe_past(a.tab->catalog(), past, a.tab->settings.place_words()),
            "5.000 mm lies 2.000 mm past the \u2212 limit of motor 1, 3.000 mm. Nothing was sent.");
}

TEST_F(TravelTest, WhereItWouldStopNowIsMarkedWhileItMoves) {
  Catalog catalog = example_catalog();
  catalog.stopping_way = [](const Catalog&, const Snapshot& now, AxisId axis) {
    return std::optional(now.axes[axis.index].speed.value / 2);
  };
  Example& b = s.add(std::move(catalog));
  AxisState& axis = b.now.axes[0];
  axis.position = Steps(4000), axis.travel = from_to(-8000, 120'000);
  s.run(0.2);
  EXPECT_FALSE(s.hand.exists("dro/1/stop")) << "it stands";
  axis.activity = Activity::moving, axis.direction = -1, axis.speed = Pps{4000};
  s.run(0.1);
  EXPECT_THAT(std::string(s.value("dro/1/stop")), testing::HasSubstr("2000"));
}

TEST_F(TravelTest, AreSeenUnderTheNumber) {
  EXPECT_FALSE(s.hand.exists("dro/1/travel"));
  hold_to(from_to(-8000, 120'000));
  EXPECT_EQ(s.value("dro/1/travel"), "-20.000 to 300.000 mm");
  Travel up;
  up.has_plus = true;
  up.plus = Steps(120'000);
  hold_to(up);
  EXPECT_EQ(s.value("dro/1/travel"), "up to 300.000 mm");
}

TEST_F(TravelTest, OfGoTheNearestPlaceInsideIsOffered) {
  hold_to(from_to(-8000, 120'000));
  MUST(s.hand.type("goto/1", "318\n"));
  s.run(0.1);
  EXPECT_EQ(a.count<intent::MoveTo>(), 0);
  EXPECT_EQ(s.value("goto/1/refused"),
            "318.000 mm lies 18.000 mm past the + limit of motor 1, 300.000 mm. Nothing was sent.");
  MUST(s.hand.click("goto/1/nearest"));
  ASSERT_TRUE(a.last<intent::MoveTo>());
  EXPECT_EQ(a.last<intent::MoveTo>()->targets.at(0).value, Steps(120'000));
}

TEST_F(TravelTest, OfATapTheWayToTheLimitIsOfferedBesideThePad) {
  hold_to(from_to(-8000, 120'000));
  a.now.axes[0].position = Steps(119'999);
  MUST(s.hand.press("jog/1/+"));
  MUST(s.hand.release("jog/1/+"));
  s.run(0.1);
  ASSERT_TRUE(a.last<intent::MoveBy>());
  IntentOutcome& outcome = a.now.outcomes[0];
  outcome.past = PastTravel{AxisId{0}, Sign::plus, Steps(120'400), Steps(120'000)};
  a.outcome(IntentState::refused, "in the controller's own words");
  s.run(0.1);
  EXPECT_EQ(s.value("jog/1/refused"),
            "301.000 mm lies 1.000 mm past the + limit of motor 1, 300.000 mm. Nothing was sent.");
  s.run(0.5);
  MUST(s.hand.click("jog/1/nearest"));
  ASSERT_TRUE(a.last<intent::MoveTo>());
  EXPECT_EQ(a.last<intent::MoveTo>()->targets.at(0).value, Steps(120'000));
  s.run(0.1);
  EXPECT_FALSE(s.hand.exists("jog/1/refused"));
}

TEST_F(TravelTest, AJogAtTheLimitIsRefusedInTheUnitOfTheAxis) {
  IntentOutcome outcome;
  outcome.state = IntentState::refused;
  outcome.past = PastTravel{AxisId{0}, Sign::plus, Steps(120'000), Steps(120'000), -1, PastTravel::Of::jog};
  EXPECT_EQ(a.tab->messages.words_of(outcome),
            "Motor 1 is at the + limit set for it, 300.000 mm, or beyond. Nothing was sent. Jog it the "
            "other way, or change the limit.");
}

TEST_F(TravelTest, ASavedPlaceOutsideOffersTheNearestInside) {
  a.tab->settings.profile.places.push_back({"far", {{AxisId{0}, Steps(130'000)}, {AxisId{1}, Steps(50)}}});
  hold_to(from_to(-8000, 120'000));
  MUST(s.hand.click("places"));
  MUST(s.hand.click("places/far/go"));
  ASSERT_TRUE(a.last<intent::MoveTo>());
  a.now.outcomes[0].past = PastTravel{AxisId{0}, Sign::plus, Steps(130'000), Steps(120'000)};
  a.outcome(IntentState::refused, "in the controller's own words");
  s.run(0.5);
  EXPECT_EQ(s.value("goto/1/refused"),
            "325.000 mm lies 25.000 mm past the + limit of motor 1, 300.000 mm. Nothing was sent.");
  a.now.outcomes[0].past.reset();
  MUST(s.hand.click("goto/1/nearest"));
  const auto* to = a.last<intent::MoveTo>();
  EXPECT_EQ(a.count<intent::MoveTo>(), 2);
  ASSERT_EQ(to->targets.size(), 2u);
  EXPECT_EQ(to->targets[0].value, Steps(120'000));
  EXPECT_EQ(to->targets[1].value, Steps(50));
}

TEST_F(TravelTest, AMoveWhoseBacklashHasNoRoomIsOfferedWhereItHas) {
  hold_to(from_to(-8000, 120'000));
  a.now.axes[0].backlash = {Steps(400), Sign::minus};
  MUST(s.hand.type("goto/1", "299.5\n"));
  ASSERT_TRUE(a.last<intent::MoveTo>());
  a.now.outcomes[0].past =
      PastTravel{AxisId{0}, Sign::plus, Steps(120'200), Steps(120'000), -1, PastTravel::Of::backlash};
  a.outcome(IntentState::refused, "in the controller's own words");
  s.run(0.5);
  EXPECT_EQ(
      s.value("goto/1/refused"),
      "To take up backlash, the move would go further than its target: 300.500 mm lies 0.500 mm past the + "
      "limit of motor 1, 300.000 mm. Nothing was sent.");
  MUST(s.hand.click("goto/1/nearest"));
  EXPECT_EQ(a.last<intent::MoveTo>()->targets.at(0).value, Steps(119'600));
}

TEST_F(TravelTest, LimitsThatCrossAreReportedInTheUnitUntilTheyAreMended) {
  MUST(s.hand.click("dro/1/position"));
  MUST(s.hand.type("dro/1/limit/+", "300\n"));
  MUST(s.hand.type("dro/1/limit/-", "400\n"));
  s.run(0.1);
  const auto is_shown = [&] {
    for (const auto& w : s.stage.surface.screen().registry().widgets())
      if (w.value.find("limit of motor 1, 400.000 mm, must lie on the ") != std::string::npos) return true;
    return false;
  };
  EXPECT_TRUE(is_shown());
  MUST(s.hand.type("dro/1/limit/-", "200\n"));
  s.run(0.1);
  EXPECT_FALSE(is_shown());
}

TEST_F(TravelTest, ALimitPassedIsReportedInTheUnitOfTheAxis) {
  PastTravel passed{AxisId{0}, Sign::plus, Steps(120'400), Steps(120'000)};
  EXPECT_EQ(describe_warned(a.tab->catalog(), passed, a.tab->settings.place_words()),
            "Motor 1 has passed its + limit, 300.000 mm: nothing ends this motion there.");
}

TEST_F(TravelTest, EachOfManyAxesHasItsTravelInItsRow) {
  Example& b = s.add(example_catalog(8));
  b.now.axes[5].travel = from_to(-10, 20);
  s.run(0.1);
  EXPECT_EQ(s.value("dro/6/travel"), "-10 to 20 steps");
  EXPECT_FALSE(s.hand.exists("dro/5/travel"));
}

TEST_F(TravelTest, AtTheEndOnlyTheWayBackIsOffered) {
  a.now.axes[0].position = Steps(120'000);
  hold_to(from_to(-8000, 120'000));
  EXPECT_FALSE(s.stage.find("jog/1/+")->enabled);
  EXPECT_TRUE(s.stage.find("jog/1/-")->enabled);
}

TEST_F(TravelTest, GoHasASpeedInTheUnitOfTheAxis) {
  MUST(s.hand.type("goto/speed", "5\n"));
  MUST(s.hand.type("goto/1", "20\n"));
  ASSERT_TRUE(a.last<intent::MoveTo>());
  EXPECT_EQ(a.last<intent::MoveTo>()->speed, Pps(2000));
  MUST(s.hand.type("goto/speed", ""));
  MUST(s.hand.type("goto/1", "30\n"));
  EXPECT_EQ(a.last<intent::MoveTo>()->speed, Pps(0)) << "as the controller is set";
}

TEST_F(TravelTest, TheLowestTypedSpeedIsNotTheControllersOwn) {
  MUST(s.hand.type("goto/speed", "0.001\n"));
  MUST(s.hand.type("goto/1", "20\n"));
  ASSERT_TRUE(a.last<intent::MoveTo>());
  EXPECT_EQ(a.last<intent::MoveTo>()->speed, Pps(1)) << "0 would be as the controller is set";
  EXPECT_EQ(a.last<intent::MoveTo>()->own_speeds[0], Pps(1));
}

TEST_F(TravelTest, SavedPlacesAndZeroGoAtTheSpeedOfGo) {
  a.tab->settings.profile.axes[1].unit_choice = "table";
  a.tab->settings.profile.places.push_back({"load", {{AxisId{0}, Steps(4000)}, {AxisId{1}, Steps(50)}}});
  a.tab->settings.edited();
  MUST(s.hand.type("goto/speed", "5\n"));
  s.run(0.1);
  MUST(s.hand.click("places"));
  MUST(s.hand.click("places/load/go"));
  ASSERT_TRUE(a.last<intent::MoveTo>());
  EXPECT_EQ(a.last<intent::MoveTo>()->speed, Pps(400)) << "5 degrees a second, the slower of both";
  EXPECT_EQ(a.last<intent::MoveTo>()->own_speeds[0], Pps(2000)) << "one after another: 5 mm a second";
  EXPECT_EQ(a.last<intent::MoveTo>()->own_speeds[1], Pps(400));
}

class GoTogetherTest : public TravelTest {
 protected:
  /// Both axes from 0 by these steps, at 5 units a second.
  Pps speed_of(std::int64_t first, std::int64_t second, const char* unit, const char* other,
               bool along_path = false) {
    Catalog catalog = example_catalog();
    catalog.can.interpolates = true;
    catalog.can.speed_along_path = along_path;
    Example& b = s.add(std::move(catalog));
    b.tab->view.unset_read = true;
    b.tab->settings.profile.unit = "real";
    b.tab->settings.profile.axes[0].unit_choice = unit;
    b.tab->settings.profile.axes[1].unit_choice = other;
    b.tab->settings.profile.places.push_back(
        {"load", {{AxisId{0}, Steps(first)}, {AxisId{1}, Steps(second)}}});
    b.tab->settings.edited();
    as_it_is(b.now);
    s.run(0.2);
    EXPECT_TRUE(s.hand.type("goto/speed", "5\n").has_value());
    s.run(0.1);
    EXPECT_TRUE(s.hand.click("places").has_value());
    EXPECT_TRUE(s.hand.click("places/load/go").has_value());
    const auto* move = b.last<intent::MoveTo>();
    EXPECT_TRUE(move);
    EXPECT_EQ(move->own_speeds, intent::AxisSpeeds{}) << "the line has one speed";
    return move->speed;
  }
  std::function<void(Snapshot&)> as_it_is = [](Snapshot&) {};
};
constexpr const char* screw = "screw of 1 mm";  // 400 steps/mm
constexpr const char* table = "table";          // 80 steps/degree

TEST_F(GoTogetherTest, TheFastestAxisInItsOwnUnitHasTheTypedSpeed) {
  EXPECT_EQ(speed_of(4000, 80, screw, table), Pps(2000)) << "10 mm at 5 mm/s; 1 degree in 2 s is slower";
  EXPECT_EQ(speed_of(400, 8000, screw, table), Pps(400)) << "100 degrees take 20 s";
  EXPECT_EQ(speed_of(4000, 800, screw, table), Pps(2000)) << "both at 5";
  EXPECT_EQ(speed_of(4000, 3000, screw, table, true), Pps(std::round(5000 / 7.5))) << "37.5 degrees in 7.5 s";
}

TEST_F(GoTogetherTest, DuringAMotionItIsAsSlowAsTheSlowestAxis) {
  as_it_is = [](Snapshot& now) {
    now.axes[0].activity = Activity::moving;
    now.axes[0].has_target = true, now.axes[0].target = Steps(4000);
  };
  EXPECT_EQ(speed_of(8000, 80, screw, table), Pps(400)) << "where the way begins is not certain";
}

TEST_F(GoTogetherTest, AWayOfUnknownLengthIsAsSlowAsTheSlowestAxis) {
  as_it_is = [](Snapshot& now) { now.axes[0].position_known = false; };
  EXPECT_EQ(speed_of(4000, 80, screw, table), Pps(400));
}

TEST_F(GoTogetherTest, InOneUnitItIsTheSpeedAlongThePath) {
  EXPECT_EQ(speed_of(1200, 1600, screw, screw), Pps(1600)) << "5 mm in 1 s: the longer axis 4 mm/s";
  EXPECT_EQ(speed_of(1200, 1600, screw, screw, true), Pps(2000));
}

TEST_F(GoTogetherTest, AnAxisWithoutAUnitIsNotFasterThanOneThatHas) {
  EXPECT_EQ(speed_of(400, 8000, screw, ""), Pps(2000)) << "in steps";
}

TEST_F(TravelTest, GoOfAnAxisThatCountsAgainstItsStepsHasASpeedToo) {
  a.tab->settings.profile.axes[0].reversed = true;
  a.tab->settings.edited();
  s.run(0.1);
  MUST(s.hand.type("goto/speed", "5\n"));
  MUST(s.hand.type("goto/1", "20\n"));
  ASSERT_TRUE(a.last<intent::MoveTo>());
  EXPECT_EQ(a.last<intent::MoveTo>()->speed, Pps(2000));
}

TEST_F(TravelTest, NoMoveGoesByASpeedThatIsOutOfSight) {
  Example& b = s.add(example_catalog(4));
  s.run(0.1);
  MUST(s.hand.type("goto/speed", "500\n"));
  MUST(s.hand.click("goto/axis"));
  MUST(s.hand.click("goto/axis/All axes"));
  s.run(0.1);
  MUST(s.hand.type("goto/2", "20\n"));
  ASSERT_TRUE(b.last<intent::MoveTo>());
  EXPECT_EQ(b.last<intent::MoveTo>()->speed, s.hand.exists("goto/speed") ? Pps(500) : Pps(0));
}

TEST_F(TravelTest, ARowOfManyAxesGoesByTheSpeedThatStandsBelowIt) {
  Catalog catalog = example_catalog(4);
  catalog.can.interpolates = true;
  Example& b = s.add(std::move(catalog));
  s.run(0.1);
  MUST(s.hand.type("goto/speed", "500\n"));
  MUST(s.hand.click("goto/axis"));
  MUST(s.hand.click("goto/axis/All axes"));
  s.run(0.1);
  ASSERT_TRUE(s.hand.exists("goto/speed"));
  MUST(s.hand.type("goto/2", "20\n"));
  ASSERT_TRUE(b.last<intent::MoveTo>());
  EXPECT_EQ(b.last<intent::MoveTo>()->speed, Pps(500));
}

TEST_F(TravelTest, ValuesTypedForGoAreConvertedToAnotherUnit) {
  MUST(s.hand.type("goto/speed", "5"));
  MUST(s.hand.type("goto/1", "20"));
  a.tab->settings.profile.unit.clear();
  a.tab->settings.edited();
  s.run(0.1);
  EXPECT_EQ(s.value("goto/1"), "8000");
  EXPECT_EQ(s.value("goto/speed"), "2000");
  MUST(s.hand.click("goto/1/go"));
  ASSERT_TRUE(a.last<intent::MoveTo>());
  EXPECT_EQ(a.last<intent::MoveTo>()->targets.at(0).value, Steps(8000));
  EXPECT_EQ(a.last<intent::MoveTo>()->speed, Pps(2000));
}

TEST_F(TravelTest, APlaceIsSavedGoneToChangedAndForgotten) {
  a.now.axes[1].position = Steps(-50);
  s.run(0.1);
  MUST(s.hand.click("places"));
  MUST(s.hand.type("places/name", "load\n"));
  ASSERT_EQ(a.tab->settings.profile.places.size(), 1u);
  a.now.axes[0].position = a.now.axes[1].position = Steps(0);
  s.run(0.1);
  MUST(s.hand.click("places/load/go"));
  ASSERT_TRUE(a.last<intent::MoveTo>());
  ASSERT_EQ(a.last<intent::MoveTo>()->targets.size(), 2u);
  EXPECT_EQ(a.last<intent::MoveTo>()->targets[0].value, Steps(4000));
  EXPECT_EQ(a.last<intent::MoveTo>()->targets[1].value, Steps(-50));
  MUST(s.hand.click("places"));
  MUST(s.hand.click("places/load/edit"));
  MUST(s.hand.type("places/load/1", "7\n"));
  EXPECT_EQ(a.tab->settings.profile.places[0].at[0].value, Steps(2800));
  MUST(s.hand.click("places/load/2/here"));
  EXPECT_EQ(a.tab->settings.profile.places[0].at[1].value, Steps(0));
  MUST(s.hand.click("places/load/forget"));
  EXPECT_TRUE(a.tab->settings.profile.places.empty());
}

TEST_F(TravelTest, NoPlaceIsSavedByACountThatIsNotToBeTrusted) {
  a.now.axes[1].trust.doubt(Doubt::power_cut, s.scheduler.now());
  s.run(0.1);
  MUST(s.hand.click("places"));
  MUST(s.hand.type("places/name", "load"));
  MUST(s.hand.click("places/save"));
  EXPECT_TRUE(a.tab->settings.profile.places.empty());
}

}  // namespace
}  // namespace hw::panels
