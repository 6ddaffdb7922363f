#include "core/motion/path.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace hw::motion {
namespace {

TEST(Path, ALineFollowsItsLeadingAxis) {
  const Path p = Path::line({1000, -300, 0, 7});
  EXPECT_EQ(p.steps(), 1000);
  for (std::int64_t k = 1; k <= p.steps(); ++k) {
    EXPECT_EQ(p.offset(0, k), k);
    EXPECT_NEAR(static_cast<double>(p.offset(1, k)), -0.3 * static_cast<double>(k), 0.5);
    EXPECT_LE(p.offset(1, k - 1) - p.offset(1, k), 1) << "a pulse at a time";
  }
  EXPECT_EQ(p.offset(3, 1000), 7);
  EXPECT_FALSE(p.moves(2));
  EXPECT_EQ(p.direction(1, 0), -1);
  EXPECT_NEAR(p.pulses_per_step() * 1000, std::sqrt(1e6 + 9e4 + 49), 1e-6);
  EXPECT_NEAR(std::pow(p.share(0, 5), 2) + std::pow(p.share(1, 5), 2) + std::pow(p.share(3, 5), 2), 1, 1e-12);
}

TEST(Path, FindsTheStepAtWhichAnAxisArrives) {
  const Path p = Path::line({1000, -300, 0, 0});
  for (const std::int64_t wanted : {-1, -150, -299, -300}) {
    const auto k = p.first_at(1, 0, wanted);
    ASSERT_TRUE(k.has_value());
    EXPECT_EQ(p.offset(1, *k), wanted);
    EXPECT_GT(p.offset(1, *k - 1), wanted) << "the first";
  }
  EXPECT_FALSE(p.first_at(1, 0, -301).has_value());
  EXPECT_FALSE(p.first_at(1, 0, 5).has_value() && p.offset(1, *p.first_at(1, 0, 5)) > 0);
  EXPECT_EQ(Path::along(2, Sign::minus, std::int64_t{1} << 50).first_at(2, 10, -77), 77);
}

TEST(Path, AnArcKeepsItsRadiusAndTurnsAtTheQuarters) {
  const double radius = 500;
  const Path p = Path::arc(0, 1, -radius, 0, -2 * std::numbers::pi);  // clockwise from the left
  EXPECT_EQ(p.offset(0, p.steps()), 0);
  EXPECT_EQ(p.offset(1, p.steps()), 0);
  int turns = 0;
  for (std::int64_t k = 0; k < p.steps(); ++turns) {
    const std::int64_t next = p.next_turn(k);
    ASSERT_GT(next, k);
    for (const std::size_t axis : {0u, 1u}) {
      const int way = p.direction(axis, k);
      for (std::int64_t i = k + 1; i <= next; ++i) {
        const std::int64_t made = p.offset(axis, i) - p.offset(axis, i - 1);
        EXPECT_GE(made * way, 0) << "one direction between turns";
        EXPECT_LE(std::abs(made), 1);
      }
    }
    k = next;
  }
  EXPECT_EQ(turns, 4);
  EXPECT_GT(p.direction(1, 0), 0) << "upwards first";
  for (std::int64_t k = 0; k <= p.steps(); k += 13) {
    const double x = static_cast<double>(p.offset(0, k)) - radius, y = static_cast<double>(p.offset(1, k));
    EXPECT_NEAR(std::hypot(x, y), radius, 0.71);
  }
}

TEST(Path, AQuarterArcEndsOnItsPoint) {
  const Path p = Path::arc(0, 1, 0, 1000, -std::numbers::pi / 2);
  EXPECT_EQ(p.offset(0, p.steps()), 1000);
  EXPECT_EQ(p.offset(1, p.steps()), -1000);
  const auto k = p.first_at(0, 0, 500);
  ASSERT_TRUE(k.has_value());
  EXPECT_EQ(p.offset(0, *k), 500);
  EXPECT_EQ(p.offset(0, *k - 1), 499);
}

}  // namespace
}  // namespace hw::motion
