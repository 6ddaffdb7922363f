#include "transports/memory.h"

#include <gtest/gtest.h>

#include "tests/transports/ear.h"

namespace hw {
namespace {

using test::Ear;

class Memory : public ::testing::Test {
 protected:
  IoContext io{1};
  VirtualScheduler clock{io};
};

TEST_F(Memory, BytesArriveInOrderAndNeverInsideTheCall) {
  auto [a, b] = make_memory_pair(clock);
  Ear at_b(*b);
  a->send("one ");
  a->send("two");
  EXPECT_EQ(at_b.received, "");
  clock.run_for(Duration{});
  EXPECT_EQ(at_b.received, "one two");
}

TEST_F(Memory, TheRemainingEndGetsTheSentence) {
  MemoryWire wire;
  wire.gone = Fault(FaultKind::lost, "The cable was pulled.");
  auto [a, b] = make_memory_pair(clock, wire);
  Ear at_a(*a);
  b->send("last words");
  b.reset();
  EXPECT_FALSE(at_a.closed);
  clock.run_for(Duration{});
  ASSERT_TRUE(at_a.closed);
  EXPECT_EQ(at_a.received, "last words");
  EXPECT_EQ(at_a.closed->what, "The cable was pulled.");
  a->send("into the void");
  clock.run_for(Duration{});
}

TEST_F(Memory, AnEndMayBeDestroyedWhileItIsBeingNotified) {
  auto [a, b] = make_memory_pair(clock);
  Ear at_b(*b);
  at_b.on_bytes = [&end = b] { end.reset(); };
  a->send("x");
  clock.run_for(Duration{});
  EXPECT_FALSE(b);
  a->send("y");
  clock.run_for(Duration{});
  EXPECT_EQ(at_b.received, "x");
}

TEST_F(Memory, NothingIsNotifiedAfterDestruction) {
  auto [a, b] = make_memory_pair(clock);
  Ear at_b(*b);
  a->send("x");
  b.reset();
  a.reset();
  clock.run_for(Duration{});
  EXPECT_EQ(at_b.received, "");
  EXPECT_FALSE(at_b.closed);
}

TEST_F(Memory, BothEndsSeeOneRate) {
  MemoryWire wire;
  wire.baud = 9600;
  auto [a, b] = make_memory_pair(clock, wire);
  ASSERT_TRUE(a->set_rate(38400));
  EXPECT_EQ(b->rate(), 38400);
  EXPECT_EQ(a->describe(), "memory, 38400 baud");
}

TEST_F(Memory, AWireWithoutRateStaysWithoutOne) {
  auto [a, b] = make_memory_pair(clock);
  ASSERT_TRUE(a->set_rate(38400));
  EXPECT_EQ(a->rate(), 0);
}

}  // namespace
}  // namespace hw
