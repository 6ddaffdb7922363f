#include "panels/program/io_lanes.h"

#include <gtest/gtest.h>

namespace hw::panels {
namespace {

using Line = RehearsedEvent::Line;

Rehearsal ten_seconds(std::vector<RehearsedEvent> events) {
  Rehearsal r;
  r.duration_s = 10, r.finished = true;
  r.events = std::move(events);
  return r;
}

TEST(IoLanes, AnOutputIsOnFromItsSwitchingToTheNext) {
  const auto lanes = io_lanes(ten_seconds({{1, "output 1 on", 0, 2, Line::switched, "output 1", 1},
                                           {2, "I1M400", 0, 3},
                                           {3, "output 1 off", 0, 4, Line::switched, "output 1", 0},
                                           {4, "output 2 off", 0, 5, Line::switched, "output 2", 0},
                                           {8, "output 1 on", 0, 6, Line::switched, "output 1", 1}}));
  ASSERT_EQ(lanes.size(), 2u);
  EXPECT_EQ(lanes[0].name, "output 1");
  EXPECT_EQ(lanes[0].words, "on from 1.0 s to 3.0 s, from 8.0 s to the end");
  EXPECT_EQ(lanes[1].words, "on from 0.0 s to 4.0 s") << "it was on when the program began";
}

TEST(IoLanes, AnInputIsLookedAtOrWaitedFor) {
  const auto lanes = io_lanes(ten_seconds({{0.5, "reads DI1: 1", 0, 1, Line::looked_at, "DI1", 1},
                                           {2, "reads DI1: 0", 0, 1, Line::looked_at, "DI1", 0},
                                           {3, "waits for input 1", -1, -1, Line::waits, "input 1"},
                                           {7, "goes on", -1, -1, Line::comes, "input 1"}}));
  ASSERT_EQ(lanes.size(), 2u);
  EXPECT_EQ(lanes[0].words, "on from 0.0 s to 2.0 s, looked at after 0.5 s, 2.0 s");
  EXPECT_EQ(lanes[1].words, "waited for from 3.0 s to 7.0 s");
}

TEST(IoLanes, IndistinguishableOnesAreOne) {
  std::vector<RehearsedEvent> many;
  for (int i = 0; i < 100'000; ++i)
    many.push_back({i * 1e-4, "", 0, 0, Line::switched, "output 1", i % 2 == 0 ? 1 : 0});
  const auto lanes = io_lanes(ten_seconds(std::move(many)));
  ASSERT_EQ(lanes.size(), 1u);
  EXPECT_EQ(lanes[0].on.size(), 1u);
}

}  // namespace
}  // namespace hw::panels
