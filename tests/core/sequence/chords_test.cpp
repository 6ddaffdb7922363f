// An arc as chords: each lies close to it, and the last ends where the arc does.
#include "core/sequence/chords.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace hw::sequence {
namespace {

/// Of the middles of all chords.
double furthest_beside(const Chords& chords, double dx, double dy) {
  const double radius = std::hypot(dx, dy);
  double x = dx, y = dy, furthest = 0;
  for (int n = 1; n <= chords.count(); ++n) {
    const auto [to_x, to_y] = chords.end(n);
    furthest = std::max(furthest, radius - std::hypot((x + to_x) / 2, (y + to_y) / 2));
    x = to_x, y = to_y;
  }
  return furthest;
}

TEST(Chords, LieWithinTheToleranceAndAreNotMoreThanThatTakes) {
  for (const double tolerance : {0.001, 0.1, 5.0})
    for (const double degrees : {360.0, -90.0, 12.0}) {
      const Chords chords(300, 400, degrees, tolerance);
      const double beside = furthest_beside(chords, 300, 400);
      EXPECT_LE(beside, tolerance * 1.000001) << tolerance << ", " << degrees;
      if (chords.count() > 10) {
        EXPECT_GT(beside, tolerance / 2) << tolerance << ", " << degrees;
      }
    }
}

TEST(Chords, EndWhereTheArcDoes) {
  const Chords quarter(10, 0, 90, 0.01);
  const auto [x, y] = quarter.end(quarter.count());
  EXPECT_NEAR(x, 0, 1e-9);
  EXPECT_NEAR(y, 10, 1e-9);
  const Chords back(10, 0, -360, 0.01);
  EXPECT_NEAR(back.end(back.count()).first, 10, 1e-9);
}

TEST(Chords, AreSoManyAsCanBeDrawn) {
  EXPECT_EQ(Chords(1, 0, 360, 100).count(), 2) << "none is of more than half a circle";
  EXPECT_EQ(Chords(0, 0, 360, 0.01).count(), 1) << "around itself";
  EXPECT_EQ(Chords(1e9, 0, 360, 0).count(), 1'000'000) << "no tolerance asks for no end of them";
}

}  // namespace
}  // namespace hw::sequence
