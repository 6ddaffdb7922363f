#include "core/motion/plant.h"

#include <algorithm>
#include <set>
#include <vector>

#include <gtest/gtest.h>

using namespace hw;
using namespace hw::motion;

namespace {

Plant slide(std::int64_t minus, std::int64_t plus, std::int64_t backlash = 0) {
  AxisPlace place;
  place.minus = Steps(minus), place.plus = Steps(plus), place.backlash = Steps(backlash);
  Plant p;
  p.set_place(place);
  return p;
}

TEST(Plant, SwitchActsAtItsPlaceAndBeyond) {
  Plant p = slide(-100, 200);
  EXPECT_EQ(p.turns_until_limit(Sign::plus), 200);
  p.turn(Sign::plus, 199);
  EXPECT_FALSE(p.limit_operated(Sign::plus));
  p.turn(Sign::plus, 1);
  EXPECT_TRUE(p.limit_operated(Sign::plus));
  EXPECT_EQ(p.turns_until_limit(Sign::plus), 0);
  EXPECT_EQ(p.turns_until_limit(Sign::minus), 300);
}

TEST(Plant, PlayIsLostAtEachReversal) {
  Plant p = slide(-1000, 1000, 5);
  p.turn(Sign::plus, 10);
  EXPECT_EQ(p.load(), Steps(10));
  p.turn(Sign::minus, 3);
  EXPECT_EQ(p.load(), Steps(10));
  EXPECT_EQ(p.turns_until_limit(Sign::minus), 1012);
  p.turn(Sign::minus, 4);
  EXPECT_EQ(p.load(), Steps(8));
  p.turn(Sign::plus, 5);
  EXPECT_EQ(p.load(), Steps(8));
}

TEST(Plant, JamHoldsAndSlipShiftsTheLoad) {
  Plant p = slide(-100, 100);
  p.jam(true);
  p.turn(Sign::plus, 500);
  EXPECT_EQ(p.load(), Steps(0));
  EXPECT_FALSE(p.turns_until_limit(Sign::plus));
  p.jam(false);
  p.slip(Steps(-30));
  EXPECT_EQ(p.turns_until_limit(Sign::minus), 70);
}

TEST(Plant, HomeZoneActsInsideOnly) {
  AxisPlace place;
  place.home_from = Steps(50), place.home_to = Steps(60);
  Plant p;
  p.set_place(place);
  EXPECT_EQ(p.turns_until_home(Sign::plus), 50);
  EXPECT_FALSE(p.turns_until_home(Sign::minus));
  p.turn(Sign::plus, 50);
  EXPECT_TRUE(p.home_operated());
  p.turn(Sign::plus, 11);
  EXPECT_FALSE(p.home_operated());
  EXPECT_EQ(p.turns_until_home(Sign::minus), 1);
  EXPECT_FALSE(p.turns_until_limit(Sign::plus)) << "absent switches never act";
}

TEST(Plant, AChangeOfPlaceKeepsWhatItDoesNotName) {
  Plant p;
  AxisPlace ends;
  ends.minus = Steps(-100), ends.plus = Steps(100);
  p.set_place(ends);
  AxisPlace play;
  play.backlash = Steps(3);
  p.set_place(play);
  EXPECT_EQ(p.turns_until_limit(Sign::plus), 100);
  EXPECT_EQ(p.turns_until_limit(Sign::minus), 103);
  p.set_place(AxisPlace());
  EXPECT_EQ(p.turns_until_limit(Sign::plus), std::nullopt) << "one that names nothing takes all away";
  EXPECT_EQ(p.place().backlash, std::nullopt);
}

// ---- scatter

Plant scattering_slide(std::int64_t scatter, std::int64_t seed = 1) {
  AxisPlace place;
  place.minus = Steps(-100), place.plus = Steps(200);
  place.home_from = Steps(50), place.home_to = Steps(60);
  place.scatter = Steps(scatter), place.seed = seed;
  Plant p;
  p.set_place(place);
  return p;
}

/// Where the load stands when the switch acts, each time from the far side.
std::vector<std::int64_t> approaches(Plant p, int times) {
  std::vector<std::int64_t> all;
  for (int i = 0; i < times; ++i) {
    const auto way = p.turns_until_limit(Sign::plus);
    if (!way) break;
    p.turn(Sign::plus, *way);
    EXPECT_TRUE(p.limit_operated(Sign::plus));
    all.push_back(p.load().value);
    p.turn(Sign::minus, 100);
    EXPECT_FALSE(p.limit_operated(Sign::plus));
  }
  return all;
}

TEST(Plant, AScatteringSwitchActsElsewhereEachTimeWithinItsReach) {
  const auto all = approaches(scattering_slide(4), 200);
  ASSERT_EQ(all.size(), 200u);
  EXPECT_EQ(*std::min_element(all.begin(), all.end()), 196);
  EXPECT_EQ(*std::max_element(all.begin(), all.end()), 204);
  EXPECT_EQ(approaches(scattering_slide(4), 200), all) << "the same seed, the same series";
  EXPECT_NE(approaches(scattering_slide(4, 2), 200), all);
  EXPECT_EQ(approaches(scattering_slide(0), 3), (std::vector<std::int64_t>{200, 200, 200}));
}

TEST(Plant, WhileItIsNearASwitchStaysWhereItActed) {
  Plant p = scattering_slide(10);
  for (int approach = 0; approach < 20; ++approach) {
    p.turn(Sign::plus, *p.turns_until_limit(Sign::plus));
    for (int i = 0; i < 5; ++i) {
      p.turn(Sign::minus, 1);
      ASSERT_FALSE(p.limit_operated(Sign::plus));
      if (p.load() < Steps(190)) break;  // out of all reach: this approach is over
      ASSERT_EQ(p.turns_until_limit(Sign::plus), 1);
      p.turn(Sign::plus, 1);
      ASSERT_TRUE(p.limit_operated(Sign::plus));
    }
    p.turn(Sign::minus, 100);
  }
}

TEST(Plant, ItIsTheSameHoweverOftenTheLoadIsLookedAt) {
  Plant at_once = scattering_slide(5), by_steps = scattering_slide(5);
  for (const Sign way : {Sign::plus, Sign::minus, Sign::plus, Sign::minus, Sign::plus}) {
    at_once.turn(way, 300);
    for (int i = 0; i < 300; ++i) by_steps.turn(way, 1);
    EXPECT_EQ(at_once.home_from(), by_steps.home_from());
    EXPECT_EQ(at_once.home_to(), by_steps.home_to());
    EXPECT_EQ(at_once.turns_until_limit(-way), by_steps.turns_until_limit(-way));
    EXPECT_EQ(at_once.turns_until_home(-way), by_steps.turns_until_home(-way));
    EXPECT_EQ(at_once.index_shift(), by_steps.index_shift());
  }
}

TEST(Plant, AHomeZoneMovesAsAWhole) {
  Plant p = scattering_slide(8);
  std::set<std::int64_t> seen;
  for (int i = 0; i < 50; ++i) {
    const auto way = p.turns_until_home(Sign::plus);
    ASSERT_TRUE(way);
    p.turn(Sign::plus, *way);
    EXPECT_TRUE(p.home_operated());
    EXPECT_EQ(p.turns_until_home_released(Sign::plus), 11);
    seen.insert(p.load().value);
    p.turn(Sign::minus, 60);
  }
  EXPECT_GT(seen.size(), 5u);
  EXPECT_GE(*seen.begin(), 42);
  EXPECT_LE(*seen.rbegin(), 58);
}

TEST(Plant, AnIndexMarkIsFoundElsewhereAfterEachReversal) {
  Plant p = scattering_slide(3);
  std::set<std::int64_t> seen;
  for (int i = 0; i < 60; ++i) {
    const Sign way = i % 2 == 0 ? Sign::minus : Sign::plus;
    const std::int64_t reported = p.index_shift(way);
    p.turn(way, 10);
    EXPECT_EQ(p.index_shift(), reported) << "as it was told before the move";
    EXPECT_EQ(p.index_shift(way), reported);
    seen.insert(reported);
  }
  EXPECT_EQ(seen.size(), 7u);
}

TEST(Plant, ScatterBeginsAnewWhenItIsGiven) {
  Plant p = scattering_slide(4);
  const auto first = p.turns_until_limit(Sign::plus);
  for (int i = 0; i < 7; ++i) p.turn(Sign::plus, 250), p.turn(Sign::minus, 250);
  AxisPlace again;
  again.scatter = Steps(4);
  p.set_place(again);
  EXPECT_EQ(p.turns_until_limit(Sign::plus), first);
  again.scatter = Steps(0);
  p.set_place(again);
  EXPECT_EQ(p.turns_until_limit(Sign::plus), 200);
}

}  // namespace
