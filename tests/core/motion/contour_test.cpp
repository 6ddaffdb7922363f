#include "core/motion/contour.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "core/motion/profile.h"

namespace hw::motion {
namespace {

constexpr std::int64_t fine = Contour::steps_per_count;

/// The third example of the data sheet: from the centre half a circle out, then the hole.
Contour hole() {
  Contour c(Offsets{0, 0, -1000, 0});
  c.line_to({0, 0, 0, 0});
  c.arc(2, 3, 0, 5000, 3.1415926);
  c.arc(2, 3, 0, 0, 6.2831853);
  c.line_to({0, 0, -10, 10000});
  return c;
}

TEST(Contour, PiecesFollowOneAnother) {
  const Contour c = hole();
  ASSERT_EQ(c.pieces(), 4u);
  EXPECT_EQ(c.end_of(0), 1000 * fine);
  EXPECT_NEAR(static_cast<double>(c.end_of(1)), (1000 + 5000 * std::numbers::pi) * fine, 0.1 * fine);
  EXPECT_EQ(c.offset(2, 0), 0);
  EXPECT_EQ(c.offset(2, c.end_of(0)), 1000);
  EXPECT_EQ(c.offset(2, c.end_of(1)), 1000);
  EXPECT_EQ(c.offset(3, c.end_of(1)), 10'000);
  EXPECT_EQ(c.offset(2, c.steps()), 990);
  EXPECT_EQ(c.offset(3, c.steps()), 10'000);
  EXPECT_TRUE(c.moves(2) && c.moves(3));
  EXPECT_FALSE(c.moves(0));
}

TEST(Contour, StaysWithinACountOfItsCircle) {
  const Contour c = hole();
  for (std::int64_t step = c.end_of(1); step <= c.end_of(2); step += 997) {
    const auto z = static_cast<double>(c.offset(2, step) - 1000), t = static_cast<double>(c.offset(3, step));
    EXPECT_NEAR(std::hypot(z, t), 10'000, 1.0);
  }
}

TEST(Contour, JoinsSmoothly) {
  // Out of the centre to the right, over the half circle counter-clockwise, on around the hole.
  const Contour c = hole();
  for (const std::size_t piece : {0u, 1u, 2u}) {
    const double before = static_cast<double>(c.end_of(piece)) - 2, after = before + 4;
    EXPECT_NEAR(c.share(2, before), c.share(2, after), 1e-3);
    EXPECT_NEAR(c.share(3, before), c.share(3, after), 1e-3);
  }
}

TEST(Contour, ARoundedCornerDoesNotBendWhatFollows) {
  Contour c(Offsets{});
  c.arc(0, 1, 3, 0, 1.0);  // ends between counts
  const Contour::Point corner = c.end();
  EXPECT_NE(corner[0], std::round(corner[0]));
  c.arc(0, 1, 0, 0, 2 * std::numbers::pi);
  EXPECT_NEAR(c.end()[0], corner[0], 1e-9);
  EXPECT_NEAR(c.end()[1], corner[1], 1e-9);
}

TEST(Contour, CrossingsAreFoundAtTheFirstStepBeyond) {
  const Contour c = hole();
  std::int64_t at = c.end_of(1) + fine;  // past the top of the circle
  for (int quarters = 0; quarters < 4; ++quarters) {
    const std::int64_t turn = c.next_turn(at);
    for (const std::size_t axis : {2u, 3u}) {
      const int way = c.direction(axis, at);
      const std::int64_t wanted = c.offset(axis, at) + way * 4321;
      const auto step = c.first_at(axis, at, wanted);
      ASSERT_TRUE(step) << "a quarter is longer than that";
      EXPECT_EQ(c.offset(axis, *step), wanted);
      EXPECT_EQ(c.offset(axis, *step - 1), wanted - way);
      EXPECT_LE(*step, turn);
    }
    EXPECT_GT(turn, at);
    at = turn;
  }
  EXPECT_NEAR(static_cast<double>(at), static_cast<double>(c.end_of(2)), 2.0 * fine);
}

TEST(Contour, ARayGoesOnAsTheLastPieceDid) {
  Contour c = hole();
  const std::int64_t end = c.end_of(3);
  c.ray();
  EXPECT_EQ(c.offset(2, end + 400 * fine), 590);
  EXPECT_EQ(c.offset(3, end + 400 * fine), 10'000);
  EXPECT_EQ(c.steps(), Profile::endless);
  Contour round(Offsets{});
  round.arc(0, 1, 0, 100, std::numbers::pi / 2);
  const std::int64_t quarter = round.end_of(0);
  round.ray();
  EXPECT_EQ(round.offset(0, quarter + 50 * fine), 100);
  EXPECT_EQ(round.offset(1, quarter + 50 * fine), 150);
}

TEST(Contour, PiecesWithoutLengthAreNoObstacle) {
  Contour c(Offsets{5, 5});
  c.line_to({5, 5});
  c.line_to({25, 5});
  c.line_to({25, 5});
  EXPECT_EQ(c.pieces(), 3u);
  EXPECT_EQ(c.steps(), 20 * fine);
  EXPECT_EQ(c.offset(0, 10 * fine), 10);
  EXPECT_EQ(c.direction(0, 0), 1);
  c.ray();
  EXPECT_EQ(c.offset(0, 30 * fine), 30);
  Contour nowhere(Offsets{});
  nowhere.line_to({});
  EXPECT_EQ(nowhere.steps(), 0);
  EXPECT_EQ(nowhere.offset(0, 0), 0);
  nowhere.ray();
  EXPECT_EQ(nowhere.offset(0, 1000), 0);
}

TEST(Contour, EveryStepHasItsTimeAtOneSpeed) {
  const Contour c = hole();
  const Instant start{};
  const Profile p = Profile::constant(start, 0, Pps(1000.0 * fine), c.steps());
  EXPECT_NEAR(seconds(p.time_at(c.end_of(1)) - start), 1 + 5 * std::numbers::pi, 1e-4);
  const auto edge = c.first_at(3, c.end_of(0), 5000);
  ASSERT_TRUE(edge);
  // A quarter of a turn: 5000 counts to the side, at 4999.5 it is nearest to 5000.
  EXPECT_NEAR(seconds(p.time_at(*edge) - start), 1 + 2.5 * std::numbers::pi, 1e-3);
}

}  // namespace
}  // namespace hw::motion
