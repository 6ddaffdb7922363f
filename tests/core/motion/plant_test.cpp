#include "core/motion/plant.h"

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

}  // namespace
