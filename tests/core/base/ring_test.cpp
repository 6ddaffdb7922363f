// The queue between two threads when its reader is behind.
#include "core/base/ring.h"

#include <gtest/gtest.h>

namespace hw {
namespace {

TEST(Ring, APushThatLeavesRoomForOthersIsRefusedFirst) {
  Ring<int> ring(8);
  const auto put = [&ring](int value, std::size_t left_for_others) {
    return ring.push_in_place([value](int& slot) { slot = value; }, left_for_others);
  };
  for (int i = 0; i < 6; ++i) EXPECT_TRUE(put(i, 2));
  EXPECT_FALSE(put(6, 2));
  EXPECT_TRUE(put(7, 0)) << "these have places of their own";
  EXPECT_TRUE(put(8, 0));
  EXPECT_FALSE(put(9, 0));
  EXPECT_EQ(ring.lost(), 2u);
  std::vector<int> taken;
  ring.drain([&taken](int value) { taken.push_back(value); });
  EXPECT_EQ(taken, (std::vector<int>{0, 1, 2, 3, 4, 5, 7, 8}));
}

}  // namespace
}  // namespace hw
