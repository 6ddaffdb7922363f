// The block that a controller is at is lit, also where it does not tell: then it is worked out.
#include "tests/panels/blocks_stage.h"

namespace hw::panels {
namespace {

struct LiveBlocks : test_blocks::BlocksStage {
  LiveBlocks() : BlocksStage("vme58") {}
  /// Frames until so long after the start.
  void at(double seconds) {
    while (s.stage.now_s < started_s + seconds) s.stage.frames(1);
    s.stage.frames(2);
  }
  double started_s = 0;
};

// A board has the whole text in its queues long before it has done it.
TEST_F(LiveBlocks, OfABoardTheOneAtWorkIsLit) {
  s.now.slot_bytes_used[0] = 0;
  sequence::Move by;
  by.relative = true, by.to[0] = 2000;
  load({{sequence::Speed{{1000, 0, 100}}}, {by}, {sequence::Delay{2000}}, {by}});
  s.click("blocks/run");
  ASSERT_TRUE(s.last<intent::LoadProgram>());
  s.settle(Fate::done);
  ASSERT_TRUE(s.last<intent::RunProgram>());
  s.settle(Fate::done);
  started_s = s.stage.now_s;
  s.now.program = {.run = RunState::running, .owned = true, .slot = 0, .command = -1};
  s.now.program.started_at = Instant(from_seconds(started_s));
  at(1);
  EXPECT_EQ(value("blocks/2/time"), "runs, worked out");
  at(3);
  EXPECT_EQ(value("blocks/3/time"), "runs, worked out") << "nothing happens while it waits";
  EXPECT_NE(value("blocks/2/time"), "runs, worked out");
  at(5);
  EXPECT_EQ(value("blocks/4/time"), "runs, worked out");
}

}  // namespace
}  // namespace hw::panels
