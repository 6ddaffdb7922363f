// The nearest of many points, against looking at each of them.
#include "core/drawing/near_points.h"

#include <algorithm>
#include <array>
#include <random>

#include <gmock/gmock.h>

namespace hw::drawing {
namespace {

/// Spread out, on a grid (many alike in one direction), all on one line, all at one place, and one far away.
std::vector<NearPoints::Entry> points(int kind, int count) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> place(0, 100);
  std::vector<NearPoints::Entry> all;
  for (int i = 0; i < count; ++i) {
    Point p{place(random), place(random)};
    if (kind == 1) p = {std::floor(p.x / 10), std::floor(p.y / 10)};
    if (kind == 2) p.y = 5;
    if (kind == 3) p = {1, 2};
    if (kind == 4 && i == 7) p = {1e12, -1e12};
    all.push_back({p, i / 2, i % 2});
  }
  return all;
}

class NearPointsTest : public testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(Each, NearPointsTest, testing::Range(0, 5));

TEST_P(NearPointsTest, FindsTheNearestUntilNoneIsLeft) {
  std::vector<NearPoints::Entry> all = points(GetParam(), 300);
  NearPoints near(all);
  Point from{50, 50};
  while (!all.empty()) {
    const NearPoints::Entry* found = near.nearest(from);
    ASSERT_TRUE(found);
    const auto closer = [&](const NearPoints::Entry& a, const NearPoints::Entry& b) {
      return distance(a.at, from) < distance(b.at, from);
    };
    EXPECT_EQ(distance(found->at, from),
              distance(std::min_element(all.begin(), all.end(), closer)->at, from));
    const int owner = found->owner;
    from = found->at;
    near.remove(owner);
    std::erase_if(all, [&](const NearPoints::Entry& e) { return e.owner == owner; });
  }
  EXPECT_FALSE(near.nearest(from));
}

TEST_P(NearPointsTest, FindsSomeOfOtherOwnersTheClosestFirst) {
  const std::vector<NearPoints::Entry> all = points(GetParam(), 300);
  const NearPoints near(all);
  std::array<const NearPoints::Entry*, 10> found{};
  for (int i = 0; i < 300; i += 17) {
    const Point from = all[static_cast<std::size_t>(i)].at;
    const int owner = i / 2;
    ASSERT_EQ(near.nearest(from, owner, found), found.size());
    std::vector<double> distances, expected;
    for (const NearPoints::Entry* e : found) {
      EXPECT_NE(e->owner, owner);
      distances.push_back(distance(e->at, from));
    }
    for (const NearPoints::Entry& e : all)
      if (e.owner != owner) expected.push_back(distance(e.at, from));
    std::sort(expected.begin(), expected.end());
    expected.resize(found.size());
    EXPECT_EQ(distances, expected);
  }
}

}  // namespace
}  // namespace hw::drawing
