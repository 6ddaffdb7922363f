// Where the axes stand when a step begins.
#include "core/sequence/places_before.h"

#include <gtest/gtest.h>

namespace hw::sequence {
namespace {

struct PlacesBefore : testing::Test {
  static Step to(std::optional<double> x, std::optional<double> y, bool relative = false) {
    Move m;
    m.to[0] = x, m.to[1] = y, m.relative = relative;
    return {m};
  }
  Places before(StepPath path) const { return places_before(s, path); }
  Sequence s;
};

TEST_F(PlacesBefore, MovesAndArcsAreFollowed) {
  s.steps = {to(10, 0), to(-4, 5, true), {Arc{6, 0, 90, {}}}, {Home{1, Sign::minus, {}}}, {Delay{1}}};
  EXPECT_FALSE(before({0})[0]) << "nothing has sent it anywhere";
  EXPECT_EQ(before({1})[0], 10);
  EXPECT_EQ(before({2})[0], 6);
  EXPECT_EQ(before({2})[1], 5);
  EXPECT_NEAR(*before({3})[0], 1, 1e-9) << "a quarter of a circle about 6, 0";
  EXPECT_NEAR(*before({3})[1], 0, 1e-9);
  EXPECT_FALSE(before({4})[1]) << "where its machine decides";
}

TEST_F(PlacesBefore, AnArcMovesTheAxesOfItsPlane) {
  Move begin;
  begin.to[0] = 10, begin.to[1] = 7, begin.to[2] = 0;
  s.steps = {{begin}, {Arc{0, 0, 90, {}, {0, 2}}}, {Delay{1}}};
  EXPECT_NEAR(*before({2})[0], 0, 1e-9);
  EXPECT_EQ(before({2})[1], 7);
  EXPECT_NEAR(*before({2})[2], 10, 1e-9);
}

TEST_F(PlacesBefore, TheReachOfAStretchHoldsTheBulgesOfItsArcs) {
  Move z;
  z.to[2] = 3;
  s.steps = {to(10, 0), {z}, {Arc{0, 0, 180}}, to(0, 0), {Arc{0, 20, -90, {}, {0, 1}}}};
  const auto reaches = reaches_between(s, {2, 3, 5});
  ASSERT_EQ(reaches.size(), 2u);
  EXPECT_NEAR(*reaches[0].least[0], -10, 1e-9);
  EXPECT_NEAR(*reaches[0].greatest[0], 10, 1e-9);
  EXPECT_NEAR(*reaches[0].greatest[1], 10, 1e-9) << "though it begins and ends at 0";
  EXPECT_EQ(reaches[0].least[2], 3) << "where it stands";
  EXPECT_NEAR(*reaches[1].least[0], -20, 1e-9);
  EXPECT_NEAR(*reaches[1].greatest[1], 20, 1e-9);
  s.steps = {{Contour{0, 0, 5, false, {}, {to(10, 0), {Arc{10, 4, 180}}}}}};
  const Reach contour = reaches_between(s, {0, 1}).front();
  EXPECT_EQ(contour.least[0], -5) << "its lead-in";
  EXPECT_NEAR(*contour.greatest[0], 14, 1e-9);
  EXPECT_NEAR(*contour.greatest[1], 8, 1e-9);
}

TEST_F(PlacesBefore, SpeedStairsEndWhereTheyRest) {
  s.steps = {to(10, 0), {SpeedStairs{1, {{20, 5}, {30, 9}}, 40}}, {Delay{1}}};
  EXPECT_EQ(before({2})[0], 10);
  EXPECT_EQ(before({2})[1], 40);
}

TEST_F(PlacesBefore, OfALoopThatMovesOnNothingIsKnownInIt) {
  Repeat loop;
  loop.times = 3;
  loop.steps = {to(1, {}, true), to({}, 7), {Delay{1}}};
  s.steps = {to(0, 0), {loop}, {Delay{1}}};
  EXPECT_FALSE(before({1, 0})[0]) << "elsewhere in each round";
  EXPECT_EQ(before({1, 2})[1], 7);
  EXPECT_FALSE(before({2})[0]);
  EXPECT_EQ(before({2})[1], 7);
  std::get<Repeat>(s.steps[1].body).times = 1;
  EXPECT_EQ(before({1, 1})[0], 1) << "there is one round only";
  s.steps[1].skipped = true;
  EXPECT_EQ(before({2})[0], 0);
}

}  // namespace
}  // namespace hw::sequence
