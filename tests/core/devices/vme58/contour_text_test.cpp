// What the contour editor's plans become, checked by the language that the board's own rules are written in.
#include "core/devices/vme58/contour_text.h"

#include <gmock/gmock.h>

#include "core/device/servo_tuning.h"
#include "core/devices/vme58/catalog.h"
#include "core/devices/vme58/program_check.h"

namespace hw::vme58 {
namespace {

using ::testing::HasSubstr;

Catalog board() { return *make_catalog({}); }

ContourPiece line_to(std::int64_t x, std::int64_t y) {
  ContourPiece p;
  p.x = Steps(x), p.y = Steps(y);
  return p;
}
ContourPiece arc_about(std::int64_t x, std::int64_t y, double degrees) {
  ContourPiece p = line_to(x, y);
  p.kind = ContourPiece::Kind::arc, p.degrees = degrees;
  return p;
}
ContourPiece output_piece(const Catalog& c, int number, bool on) {
  ContourPiece p;
  p.kind = ContourPiece::Kind::output, p.output = c.find_output(number), p.on = on;
  return p;
}

void expect_taken(const std::string& text) {
  for (const Problem& p : check_program(text).problems)
    EXPECT_FALSE(p.error) << "line " << p.line + 1 << ": " << p.sentence << "\n" << text;
}

TEST(ContourText, TheDataSheetsHole) {
  const Catalog c = board();
  ContourPlan plan;
  plan.first = AxisId{2}, plan.second = AxisId{3};
  plan.speed = Pps(1000), plan.lead_in = Steps(1000);
  plan.pieces = {output_piece(c, first_auxiliary, true), arc_about(0, 5000, 180), arc_about(0, 0, 360),
                 output_piece(c, first_auxiliary, false), line_to(-10, 10'000)};
  const auto text = contour_text(plan, c);
  ASSERT_TRUE(text) << text.error().sentence();
  EXPECT_EQ(*text,
            "AA\nCV1000;\nCD,,0,0;\nAN0;\nCR0,5000,3.141592654;\nCR0,0,6.283185307;\nAF0;\nMT-10,10000;\nCE\n"
            "MT,,-1000,0; GO\nCX\n");
  expect_taken(*text);
}

TEST(ContourText, AxesTheOtherWayRoundAreMirrored) {
  ContourPlan plan;
  plan.first = AxisId{1}, plan.second = AxisId{0};
  plan.x = Steps(10), plan.y = Steps(20), plan.ramp = false;
  plan.pieces = {line_to(110, 20), arc_about(110, 70, 90)};
  const auto text = contour_text(plan, board());
  ASSERT_TRUE(text) << text.error().sentence();
  EXPECT_THAT(*text, HasSubstr("CD20,10;\nMT20,110;\nCR70,110,-1.570796327;\nCK\nMT20,10; GO\n"));
  expect_taken(*text);
}

TEST(ContourShape, LegsFollowEachOtherAndEndWithTheLastPoint) {
  ContourPlan plan;
  plan.pieces = {line_to(100, 0), arc_about(100, 50, 180), line_to(0, 100)};
  const auto shape = draw_contour(plan, board());
  ASSERT_TRUE(shape) << shape.error().sentence();
  ASSERT_EQ(shape->legs.size(), 3u);
  std::size_t end = 0;
  for (const ContourShape::Leg& leg : shape->legs) {
    EXPECT_EQ(leg.first, end);
    EXPECT_GE(leg.size, 2u);
    end = leg.first + leg.size - 1;
  }
  EXPECT_EQ(end, shape->points.size() - 1);
  EXPECT_NEAR(shape->points.back().x, 0, 1e-9);
  EXPECT_NEAR(shape->points.back().y, 100, 1e-9);
}

TEST(ContourText, WhatTheBoardCannotDoIsRefused) {
  const Catalog c = board();
  ContourPlan plan;
  plan.pieces = {output_piece(c, 8, true), line_to(100, 0)};
  auto text = contour_text(plan, c);
  ASSERT_FALSE(text);
  EXPECT_THAT(text.error().what, HasSubstr("Out 8 cannot be switched within a contour"));
  plan.pieces.clear();
  for (int i = 1; i <= 200; ++i) plan.pieces.push_back(line_to(i, 0));
  text = contour_text(plan, c);
  ASSERT_FALSE(text);
  EXPECT_THAT(text.error().what, HasSubstr("201 entries, and the board keeps 200"));
  plan.pieces = {line_to(40'000'000, 0)};
  EXPECT_FALSE(contour_text(plan, c));
}

TEST(StaircaseText, BothWays) {
  StaircasePlan plan;
  plan.axis = AxisId{1};
  plan.steps = {{Steps(1000), Pps(500)}, {Steps(5000), Pps(2000)}};
  plan.stop_at = Steps(6000);
  const Catalog c = board();
  auto text = staircase_text(plan, c);
  ASSERT_TRUE(text) << text.error().sentence();
  EXPECT_EQ(*text, "AY\nMP\nMV1000,500;\nMV5000,2000;\nSP6000;\n");
  expect_taken(*text);
  plan.from = Steps(9000);
  EXPECT_FALSE(staircase_text(plan, c)) << "5000 does not lie behind 1000 on the way down";
  plan.steps = {{Steps(8000), Pps(500)}};
  text = staircase_text(plan, c);
  ASSERT_TRUE(text);
  EXPECT_EQ(*text, "AY\nMM\nMV8000,500;\nSP6000;\n");
}

TEST(Gains, StandUnderTheHeadingThatTheTuningPanelLooksFor) {
  const Catalog c = board();
  const int kp = c.find_param("KPX");
  ASSERT_GE(kp, 0);
  EXPECT_EQ(c.params[static_cast<std::size_t>(kp)].group, servo_loop_group);
}

}  // namespace
}  // namespace hw::vme58
