// What touches is drawn in one go, and the ways in between are short.
#include "core/drawing/chains.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include <gmock/gmock.h>

namespace hw::drawing {
namespace {

Path path_from(Point from, Point to, int layer = 0) {
  Path path;
  path.curves = {{Curve::Kind::line, from, to, {}, 0}};
  path.layer = layer;
  return path;
}
Drawing drawing_of(std::vector<Path> paths) {
  Drawing d;
  d.layers = {{"0", true}, {"frozen", false}};
  d.paths = std::move(paths);
  for (std::size_t i = 0; i < d.paths.size(); ++i) d.paths[i].entity = static_cast<int>(i) + 1;
  return d;
}
double length_of(const std::vector<Chain>& chains) {
  double length = 0;
  for (const Chain& chain : chains)
    for (const Curve& c : chain.curves) length += c.length();
  return length;
}
/// Each curve begins where the one before ends.
void expect_connected(const std::vector<Chain>& chains) {
  for (const Chain& chain : chains)
    for (std::size_t i = 1; i < chain.curves.size(); ++i)
      EXPECT_EQ(chain.curves[i].from, chain.curves[i - 1].to);
}

TEST(Chains, EndsThatTouchAreJoinedWhicheverWayTheyAreDrawn) {
  const auto chains =
      join(drawing_of({path_from({0, 0}, {1, 0}), path_from({5, 5}, {6, 6}), path_from({1, 1}, {1.0005, 0}),
                       path_from({1, 1}, {0, 1}), path_from({0, 0}, {0, 1})}),
           0.001);
  ASSERT_EQ(chains.size(), 2u);
  EXPECT_EQ(chains[0].curves.size(), 4u);
  EXPECT_TRUE(chains[0].closed());
  EXPECT_EQ(chains[1].curves.size(), 1u);
  expect_connected(chains);
}

std::vector<Path> box_from(Point low, Point high) {
  const Point right{high.x, low.y}, left{low.x, high.y};
  return {path_from(low, right), path_from(right, high), path_from(high, left), path_from(left, low)};
}

TEST(Chains, ABoxAroundAllElseIsFoundAndCanBeLeftOut) {
  std::vector<Path> paths = {path_from({10, 10}, {20, 15})};
  for (const Path& side : box_from({0, 0}, {100, 50})) paths.push_back(side);
  for (const Path& side : box_from({30, 10}, {40, 20})) paths.push_back(side);
  const Drawing drawing = drawing_of(paths);
  const auto chains = join(drawing, 0.001);
  ASSERT_EQ(chains.size(), 3u);
  ASSERT_EQ(box_around(chains), 1);
  EXPECT_THAT(chains[1].paths, testing::UnorderedElementsAre(1, 2, 3, 4));
  const auto rest = join(drawing, 0.001, chains[1].paths);
  ASSERT_EQ(rest.size(), 2u);
  EXPECT_EQ(box_around(rest), -1) << "the line lies beside the other one";
  EXPECT_EQ(box_around({chains[1]}), -1) << "around nothing";
}

TEST(Chains, NothingElseIsABoxAroundAll) {
  std::vector<Path> paths = box_from({0, 0}, {100, 50});
  paths.push_back(path_from({90, 10}, {110, 10}));
  EXPECT_EQ(box_around(join(drawing_of(paths), 0.001)), -1) << "a line leaves it";
  paths = box_from({0, 0}, {100, 50});
  paths[1].curves[0].to.x = paths[2].curves[0].from.x = 101;
  paths.push_back(path_from({10, 10}, {20, 10}));
  EXPECT_EQ(box_around(join(drawing_of(paths), 0.001)), -1) << "a side is slanted";
}

TEST(Chains, AnArcThatIsTurnedRoundGoesTheOtherWay) {
  Path arc;
  arc.curves = {{Curve::Kind::arc, {2, 0}, {0, 0}, {1, 0}, 180}};
  const auto chains = join(drawing_of({path_from({-1, 0}, {0, 0}), arc}), 0.001);
  ASSERT_EQ(chains.size(), 1u);
  EXPECT_EQ(chains[0].curves[1].from, (Point{0, 0}));
  EXPECT_EQ(chains[0].curves[1].degrees, -180);
}

TEST(Chains, PathsFurtherApartOrOnAHiddenLayerAreNotJoined) {
  const auto chains = join(
      drawing_of({path_from({0, 0}, {1, 0}), path_from({1.01, 0}, {2, 0}), path_from({1, 0}, {1, 5}, 1)}),
      0.001);
  EXPECT_EQ(chains.size(), 2u);
}

TEST(Chains, RingsAreBegunWhereTheToolComesBy) {
  Path square = path_from({10, 10}, {12, 10});
  square.curves.push_back({Curve::Kind::line, {12, 10}, {12, 12}, {}, 0});
  square.curves.push_back({Curve::Kind::line, {12, 12}, {10, 12}, {}, 0});
  square.curves.push_back({Curve::Kind::line, {10, 12}, {10, 10}, {}, 0});
  auto chains = join(drawing_of({square}), 0.001);
  order(chains, {13, 13});
  ASSERT_EQ(chains.size(), 1u);
  EXPECT_EQ(chains[0].begin(), (Point{12, 12}));
  EXPECT_NEAR(way_between(chains, {13, 13}), std::sqrt(2.0), 1e-12);
}

Path circle_from(Point begin, Point centre, double degrees = 360) {
  Path path;
  path.curves = {{Curve::Kind::arc, begin, begin, centre, degrees}};
  return path;
}

TEST(Chains, ACircleIsBegunAtItsPlaceThatIsNearest) {
  for (const double degrees : {360.0, -360.0}) {
    auto chains = join(drawing_of({circle_from({12, 10}, {10, 10}, degrees)}), 0.001);
    order(chains, {5, 10});
    ASSERT_EQ(chains.size(), 1u);
    const Curve& circle = chains[0].curves[0];
    EXPECT_NEAR(circle.from.x, 8, 1e-12);
    EXPECT_NEAR(circle.from.y, 10, 1e-12);
    EXPECT_EQ(circle.to, circle.from);
    EXPECT_EQ(circle.centre, (Point{10, 10})) << "it is the same circle";
    EXPECT_EQ(circle.degrees, degrees);
  }
  auto around = join(drawing_of({circle_from({12, 10}, {10, 10})}), 0.001);
  order(around, {10, 10});
  EXPECT_EQ(around[0].begin(), (Point{12, 10})) << "from its middle all are as near";
}

TEST(Chains, AlongARowOfCirclesTheToolPassesOnlyTheGaps) {
  std::vector<Path> paths;
  for (const int i : {3, 1, 2, 4}) paths.push_back(circle_from({i * 10.0, 3}, {i * 10.0, 0}));
  auto chains = join(drawing_of(paths), 0.001);
  order(chains, {0, 0});
  for (std::size_t i = 0; i < chains.size(); ++i)
    EXPECT_EQ(chains[i].curves[0].centre.x, 10.0 * static_cast<double>(i + 1));
  EXPECT_LE(way_between(chains, {0, 0}), 7 + 3 * 10) << "at the left of each, and on to the left of the next";
}

/// Dots in the order that is the shortest of all.
std::vector<Path> shortest_way(std::vector<Point> dots) {
  const auto less = [](Point a, Point b) { return a.x < b.x; };
  std::sort(dots.begin(), dots.end(), less);
  std::vector<Point> best = dots;
  double least = std::numeric_limits<double>::infinity();
  do {
    double way = 0;
    Point at;
    for (const Point dot : dots) way += std::hypot(dot.x - at.x, dot.y - at.y), at = dot;
    if (way < least) least = way, best = dots;
  } while (std::next_permutation(dots.begin(), dots.end(), less));
  std::vector<Path> paths;
  for (const Point dot : best) paths.push_back(path_from(dot, dot));
  return paths;
}

TEST(Chains, OrderingNeverLengthensTheWay) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> place(0, 30);
  for (int tried = 0; tried < 100; ++tried) {
    std::vector<Point> dots(7);
    for (Point& dot : dots) dot = {place(random), place(random)};
    auto chains = join(drawing_of(shortest_way(dots)), 0);
    const double as_drawn = way_between(chains, {0, 0});
    order(chains, {0, 0});
    ASSERT_EQ(chains.size(), dots.size());
    EXPECT_LE(way_between(chains, {0, 0}), as_drawn) << "of drawing " << tried;
  }
}

TEST(Chains, TheOrderOfARowIsTheRow) {
  std::vector<Path> paths;
  for (const int i : {7, 2, 9, 0, 4, 1, 8, 3, 6, 5})
    paths.push_back(path_from({i * 10.0, 0}, {i * 10.0, i % 2 ? 5.0 : -5.0}));
  auto chains = join(drawing_of(paths), 0.001);
  order(chains, {0, 0});
  for (std::size_t i = 0; i < chains.size(); ++i) EXPECT_EQ(chains[i].begin().x, static_cast<double>(i) * 10);
}

TEST(Chains, NothingIsLostAndTheWayIsShort) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> place(0, 1000), way(-5, 5);
  std::vector<Path> paths;
  for (int i = 0; i < 2000; ++i) {
    const Point from{place(random), place(random)};
    paths.push_back(path_from(from, {from.x + way(random), from.y + way(random)}));
  }
  auto chains = join(drawing_of(paths), 1e-6);
  ASSERT_EQ(chains.size(), 2000u);
  const double as_drawn = way_between(chains, {}), length = length_of(chains);
  double done = 0;
  order(chains, {}, [&](double now) {
    EXPECT_GE(now, done);
    done = now;
    return true;
  });
  EXPECT_EQ(chains.size(), 2000u);
  EXPECT_NEAR(length_of(chains), length, 1e-6);
  const double way_now = way_between(chains, {});
  EXPECT_LT(way_now, as_drawn / 15);
  // A random tour through n points of a square is at best some 0.7124 sqrt(n area); with a nearest neighbour
  // 25 % more.
  EXPECT_LT(way_now, 1.15 * 0.7124 * std::sqrt(2000.0 * 1e6));
}

TEST(Chains, OrderingEndsOnRequest) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> place(0, 1000);
  std::vector<Path> paths;
  for (int i = 0; i < 5000; ++i)
    paths.push_back(path_from({place(random), place(random)}, {place(random), place(random)}));
  auto chains = join(drawing_of(paths), 1e-9);
  int asked = 0;
  order(chains, {}, [&](double) { return ++asked < 2; });
  EXPECT_EQ(chains.size(), 5000u);
}

}  // namespace
}  // namespace hw::drawing
