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
  EXPECT_EQ(before({2})[0], 3) << "behind three rounds";
  EXPECT_EQ(before({2})[1], 7);
  std::get<Repeat>(s.steps[1].body).times = 1;
  EXPECT_EQ(before({1, 1})[0], 1) << "there is one round only";
  s.steps[1].skipped = true;
  EXPECT_EQ(before({2})[0], 0);
}

TEST_F(PlacesBefore, OfALoopThatComesBackAllIsKnownInIt) {
  s.steps = {to(0, 0), {Repeat{0, {to(5, {}), {Delay{1}}, to(0, {})}}}};
  EXPECT_EQ(before({1, 0})[0], 0) << "in each round";
  EXPECT_EQ(before({1, 2})[0], 5);
}

TEST_F(PlacesBefore, DistancesOfALoopAddUp) {
  // Five up and two back in each of a million rounds.
  s.steps = {to(10, 0), {Repeat{1'000'000, {to(5, {}, true), to(-2, {}, true)}}}, {Delay{1}}};
  const Reach up = reaches_between(s, {0, 3}).front();
  EXPECT_EQ(up.least[0], 10);
  EXPECT_EQ(up.greatest[0], 10 + 3.0 * 999'999 + 5) << "in the last round, before it goes back";
  EXPECT_EQ(before({2})[0], 3'000'010);
  s.steps = {to(10, 0), {Repeat{4, {to(2, {}, true), to(-5, {}, true)}}}};
  const Reach down = reaches_between(s, {0, 2}).front();
  EXPECT_EQ(down.least[0], -2);
  EXPECT_EQ(down.greatest[0], 12) << "in the first round";
}

TEST_F(PlacesBefore, SoDoThoseOfLoopsInLoopsAndBehindAPlaceThatEachRoundBeginsAt) {
  const Step inner{Repeat{3, {to({}, 1, true)}}};
  s.steps = {to(0, 0), {Repeat{4, {to(7, {}), inner, to(2, {}, true)}}}};
  const Reach all = reaches_between(s, {0, 2}).front();
  EXPECT_EQ(all.greatest[1], 12);
  EXPECT_EQ(all.least[0], 0);
  EXPECT_EQ(all.greatest[0], 9) << "each round is sent back to 7";
  s.steps = {to(0, 0), {Repeat{2, {to(1, {}, true)}}}};
  EXPECT_EQ(reaches_between(s, {0, 2}).front().greatest[0], 2);
}

TEST_F(PlacesBefore, ALoopWithoutEndLeavesAnyLimitWhereItMovesOn) {
  s.steps = {to(0, 0), {Repeat{0, {to(-1, 5, true), to({}, -5, true)}}}, to(99, 99)};
  const Reach all = reaches_between(s, {0, 3}).front();
  EXPECT_TRUE(all.endless_minus[0]);
  EXPECT_FALSE(all.endless_plus[0]);
  EXPECT_FALSE(all.endless_minus[1] || all.endless_plus[1]) << "it comes back";
  EXPECT_EQ(all.greatest[1], 5);
  EXPECT_EQ(all.greatest[0], 0) << "what stands behind it is never done";
}

TEST_F(PlacesBefore, DistancesCountFromWhereTheAxesStand) {
  s.steps = {{Repeat{3, {to(4, {}, true)}}}};
  EXPECT_FALSE(reaches_between(s, {0, 1}).front().greatest[0]);
  EXPECT_EQ(reaches_between(s, {0, 1}, {100.0}).front().greatest[0], 112);
}

TEST_F(PlacesBefore, ArcsThatBeginElsewhereInEachRoundAreFollowedRoundByRound) {
  // Half way round 0, 0 and three to the right: from 1 to 2, from 2 to 1, and so on.
  s.steps = {to(1, 0), {Repeat{7, {{Arc{0, 0, 180}}, to(3, {}, true)}}}, {Delay{1}}};
  const auto end = before({2})[0];
  ASSERT_TRUE(end);
  EXPECT_NEAR(*end, 2, 1e-9);
  s.steps = {to(1, 0), {Repeat{1'000'000, {{Arc{0, 0, 180}}, to(3, {}, true)}}}, {Delay{1}}};
  EXPECT_FALSE(before({2})[0]) << "too many to be followed";
}

TEST_F(PlacesBefore, AContourThatEndsRampedComesToRestWhereItsRampTakesIt) {
  // From 10 a second at 20 a second squared to 0: 2.5 on, upwards.
  s.steps = {{Speed{{10, 0, 500}}}, {Contour{0, 0, 0, true, {}, {to(10, 0), to(10, 5)}}}, {Delay{1}}};
  EXPECT_EQ(before({2})[0], 10);
  EXPECT_NEAR(before({2})[1].value_or(0), 7.5, 1e-9);
  EXPECT_NEAR(*reaches_between(s, {0, 2}).front().greatest[1], 7.5, 1e-9);
  // Where nobody has said how it ramps it is let run out as far as it was let run up.
  s.steps = {{Contour{0, 0, 3, true, Speeds{10}, {to(10, 0), {Arc{10, 4, 90}}}}}, {Delay{1}}};
  EXPECT_FALSE(before({1})[0]);
  EXPECT_NEAR(*reaches_between(s, {0, 1}).front().greatest[1], 7, 1e-9);
}

TEST_F(PlacesBefore, OfAnAxisUntilItIsHomedOnlyEarlierTargetsAreListed) {
  const auto reach = [this] { return reaches_between(s, {0, s.steps.size()}, {}, {true, true}).front(); };
  s.steps = {{Repeat{2, {{Jog{1}}, to({}, 2, true), {Home{1}}, to({}, 4)}}}, to(1, {}), {Home{0}}, to(9, {})};
  EXPECT_FALSE(reach().greatest[1]) << "its home is looked for before it is sent to a place";
  EXPECT_EQ(reach().greatest[0], 1);
  s.steps = {{MoveOnInput{1, true, MoveOnInput::Kind::home, 0}}, to(5, {})};
  EXPECT_EQ(reach().greatest[0], 5) << "the input may not let it look for its home";
  std::get<MoveOnInput>(s.steps[0].body) = {1, true, MoveOnInput::Kind::move, 0, 7};
  EXPECT_EQ(reach().greatest[0], 7);
  s.pen_up = {to(5, {})};
  s.steps = {{Pen{false}}, {Home{0}}, to(8, {})};
  EXPECT_EQ(reach().greatest[0], 5) << "lifting the tool sends it there";
  s.steps = {{Home{0}}, {Pen{false}}, {Repeat{0, {to(1, {}, true)}}}};
  EXPECT_FALSE(reach().greatest[0]);
  EXPECT_FALSE(reach().endless_plus[0]);
}

TEST_F(PlacesBefore, PenStepsMoveTheToolAxes) {
  s.pen_down = {to({}, -1)};
  s.steps = {{Repeat{2, {{Pen{false}}, {Jog{0}}}}}};
  EXPECT_TRUE(is_moved(s, 0));
  EXPECT_FALSE(is_moved(s, 1)) << "it is never lowered";
  EXPECT_TRUE(is_moved_by_tool(s, 1));
  EXPECT_FALSE(is_moved_by_tool(s, 0));
  s.steps.push_back({Pen{true}});
  EXPECT_TRUE(is_moved(s, 1));
  s.steps.back().skipped = true;
  EXPECT_FALSE(is_moved(s, 1));
}

}  // namespace
}  // namespace hw::sequence
