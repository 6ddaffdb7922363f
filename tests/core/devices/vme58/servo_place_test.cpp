#include "core/devices/vme58/servo_place.h"

#include <gtest/gtest.h>

namespace hw::vme58 {
namespace {

struct ServoPlaceTest : testing::Test {
  ServoPlace place;
  Instant now{std::chrono::seconds(100)};
  Loop look(int after_ms, bool turns, std::int64_t error) {
    now += Millis(after_ms);
    place.look(now, turns, error, usual_deadband);
    return place.place();
  }
};

TEST_F(ServoPlaceTest, AnAxisAtRestWhenFirstSeenHasLongStoodThere) {
  EXPECT_EQ(place.place(), Loop::unknown);
  EXPECT_EQ(look(0, false, 10), Loop::in_place);
  place = {};
  EXPECT_EQ(look(0, false, 11), Loop::off_place);
}

TEST_F(ServoPlaceTest, AHundredMillisecondsWithinTheBandAreAPlace) {
  EXPECT_EQ(look(0, true, 0), Loop::following) << "on its way it is nowhere";
  EXPECT_EQ(look(20, false, 4), Loop::following);
  EXPECT_EQ(look(80, false, 12), Loop::following) << "it swings";
  EXPECT_EQ(look(20, false, -9), Loop::following);
  EXPECT_EQ(look(99, false, 3), Loop::following);
  EXPECT_EQ(look(1, false, 3), Loop::in_place);
}

TEST_F(ServoPlaceTest, OneThatSwingsThroughItsPlaceForTwoSecondsIsNotThere) {
  look(0, true, 0);
  for (int swing = 0; swing < 39; ++swing) EXPECT_EQ(look(50, false, swing % 2 ? 40 : 0), Loop::following);
  EXPECT_EQ(look(50, false, 40), Loop::off_place);
  EXPECT_EQ(look(20, false, 0), Loop::off_place);
  EXPECT_EQ(look(100, false, 0), Loop::in_place) << "and once it is, it is";
}

TEST_F(ServoPlaceTest, OnePushedOutOfItsPlaceHasTwoSecondsToComeBack) {
  look(0, false, 0);
  EXPECT_EQ(look(5000, false, 300), Loop::following);
  EXPECT_EQ(look(1999, false, 300), Loop::following);
  EXPECT_EQ(look(1, false, 300), Loop::off_place);
}

}  // namespace
}  // namespace hw::vme58
