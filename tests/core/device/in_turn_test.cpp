#include "core/device/in_turn.h"

#include <gtest/gtest.h>

namespace hw {
namespace {

TEST(InTurn, EachComesOnceBeforeTheFirstComesAgain) {
  InTurn turn;
  for (const int expected : {0, 1, 2, 0}) EXPECT_EQ(turn.next(3), expected);
}

TEST(InTurn, UnwantedIndicesAreSkipped) {
  InTurn turn;
  const auto odd = [](int i) { return i % 2 == 1; };
  for (const int expected : {1, 3, 1}) EXPECT_EQ(turn.next(5, odd), expected);
  EXPECT_EQ(turn.next(5, [](int) { return false; }), -1);
  EXPECT_EQ(turn.next(0), -1);
}

TEST(InTurn, OneThatIsUrgentComesAtOnce) {
  InTurn turn;
  turn.next(4);
  turn.jump_to(3);
  EXPECT_EQ(turn.peek(4), 3);
  EXPECT_EQ(turn.next(4), 3);
  EXPECT_EQ(turn.next(4), 0);
}

}  // namespace
}  // namespace hw
