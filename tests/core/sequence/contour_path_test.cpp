#include "core/sequence/contour_path.h"

#include <gtest/gtest.h>

namespace hw::sequence {
namespace {

Step line_to(double x, double y) {
  Move m;
  m.to[0] = x, m.to[1] = y;
  return {m};
}

TEST(ContourPath, LegsFollowEachOtherAndEndWithTheLastPoint) {
  Contour c;
  c.lead_in = 7;
  c.steps = {
      line_to(100, 0), {Output{3, true}}, {Arc{100, 50, 180, {}}}, {Output{3, false}}, line_to(0, 100)};
  const ContourPath path = contour_path(c);
  ASSERT_EQ(path.legs.size(), 3u);
  std::size_t end = 0;
  for (const ContourPath::Leg& leg : path.legs) {
    EXPECT_EQ(leg.first, end);
    EXPECT_GE(leg.size, 2u);
    end = leg.first + leg.size - 1;
  }
  EXPECT_EQ(end, path.points.size() - 1);
  EXPECT_NEAR(path.points.back().x, 0, 1e-9);
  EXPECT_NEAR(path.points.back().y, 100, 1e-9);
  EXPECT_NEAR(path.length, 200 + 157.0796327, 1e-6);
  EXPECT_EQ(path.park.x, -7);
  EXPECT_EQ(path.legs[1].step, 2u);
  EXPECT_EQ(path.legs[1].outputs_on, 1);
  EXPECT_EQ(path.legs[2].outputs_on, 0);
}

TEST(ContourPath, WhatMakesNoWayIsPassedOver) {
  Contour c;
  c.steps = {line_to(0, 0), {Arc{0, 0, 90, {}}}, {Arc{5, 0, 0, {}}}, line_to(3, 4)};
  const ContourPath path = contour_path(c);
  ASSERT_EQ(path.legs.size(), 1u);
  EXPECT_EQ(path.legs[0].step, 3u);
  EXPECT_EQ(path.length, 5);
}

}  // namespace
}  // namespace hw::sequence
