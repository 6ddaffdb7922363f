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
  s.settle(IntentState::done);
  ASSERT_TRUE(s.last<intent::RunProgram>());
  s.settle(IntentState::done);
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

/// Blocks on a controller whose axis X may go as far as 1000.
struct BoundBlocks : test_blocks::BlocksStage {
  BoundBlocks() {
    s.now.slot_bytes_used[0] = 0;
    s.now.axes[0].travel = {true, true, Steps(-1000), Steps(1000)};
  }
  static sequence::Step by(double x) {
    sequence::Move m;
    m.relative = true, m.to[0] = x;
    return {m};
  }
  static sequence::Step to(std::optional<double> x, std::optional<double> y = {}) {
    sequence::Move m;
    m.to[0] = x, m.to[1] = y;
    return {m};
  }
};

TEST_F(BoundBlocks, BlocksPastALimitAreRefusedWithTheDistance) {
  load({{sequence::Repeat{12, {by(100)}}}});
  s.click("blocks/run");
  EXPECT_THAT(value("blocks/run_refused"),
              ::testing::HasSubstr("1200 pulses lies 200 pulses past the + limit of axis X"));
  load({{sequence::Repeat{0, {by(1)}}}});
  s.click("blocks/run");
  EXPECT_THAT(value("blocks/run_refused"), ::testing::HasSubstr("An endless loop moves axis X further"));
  EXPECT_TRUE(s.sent.empty());
}

TEST_F(BoundBlocks, TheBlockThatRunsIsNamedWhateverComesMeanwhile) {
  load({{sequence::Repeat{9, {by(100)}}}});
  s.click("blocks/run");
  ASSERT_TRUE(s.last<intent::LoadProgram>()) << s.toast();
  s.settle(IntentState::done);
  const auto* run = s.last<intent::RunProgram>();
  ASSERT_TRUE(run);
  ASSERT_EQ(run->places.size(), 2u);
  EXPECT_EQ(run->places[1].value, Steps(900));
}

TEST_F(BoundBlocks, TheRestFromTheChosenBlockOnIsAskedForWithTheWayThere) {
  s.now.axes[0].position = Steps(50);
  load({by(100), to({}, 300), by(7)});
  s.click("blocks/2");
  s.click("blocks/run_here");
  const std::string asked = value("blocks/run_from/says");
  EXPECT_THAT(asked, ::testing::HasSubstr("Move to X 150, Y 0 pulses.")) << s.toast();
  EXPECT_THAT(asked, ::testing::HasSubstr("Then step 2, Move to Y 300, and everything after it.\nDistances "
                                          "above it are counted from the present positions of the axes."));
  EXPECT_TRUE(s.sent.empty());
  s.click("blocks/run_from/yes");
  EXPECT_TRUE(s.last<intent::LoadProgram>()) << s.toast();
}

TEST_F(BoundBlocks, WhereNoDistanceCountsFromWhereTheAxesStandThatIsNotReported) {
  s.now.axes[0].position = Steps(50);
  load({to(100), by(100), to({}, 300)});
  s.click("blocks/3");
  s.click("blocks/run_here");
  const std::string asked = value("blocks/run_from/says");
  EXPECT_THAT(asked, ::testing::HasSubstr("Move to X 200, Y 0 pulses.")) << s.toast();
  EXPECT_THAT(asked, ::testing::Not(::testing::HasSubstr("Distances")));
}

TEST_F(LiveBlocks, BehindAContourThatRampsOutNoRehearsalHasShownWhereTheAxesStand) {
  sequence::Move right, on;
  right.to[0] = 2000, on.to[1] = 500;
  sequence::Contour c;
  c.lead_in = 1000, c.own = sequence::Speeds{1000};
  c.steps = {{right}};
  load({{sequence::Speed{{1000, 0, 500}}}, {c}, {on}});
  s.click("blocks/4");
  s.click("blocks/run_here");
  EXPECT_THAT(value("blocks/run_refused"),
              ::testing::HasSubstr("The position of X before step 3 is unknown"));
  EXPECT_EQ(s.toast(), "") << "it stands beside Run";
  EXPECT_FALSE(s.stage.find("blocks/run_from/yes"));
  s.click("blocks/2");
  s.click("blocks/run_refused/show");
  EXPECT_TRUE(s.stage.find("blocks/4/to/Y")) << "the block that it was asked of";
  s.type("blocks/4/to/Y", "501");
  s.stage.frames(6);
  EXPECT_FALSE(s.stage.find("blocks/run_refused"));
}

struct RestOfBlocks : test_blocks::BlocksStage {
  RestOfBlocks() : BlocksStage("vxm") { s.now.slot_bytes_used[0] = 0; }
  void runs(std::int16_t command) {
    s.now.program = {
        .run = RunState::running, .owned = true, .slot = 0, .command = command, .command_reported = true};
    s.stage.frames(3);
  }
};

TEST_F(RestOfBlocks, OfARestThatRunsTheBlockAtWorkIsLit) {
  sequence::Move there, back;
  there.to[0] = 400, back.to[0] = 0;
  load({{there}, {sequence::Delay{500}}, {sequence::Repeat{2, {{back}, {sequence::Delay{300}}}}}});
  s.click("blocks/2");
  s.click("blocks/run_here");
  s.click("blocks/run_from/yes");
  ASSERT_TRUE(s.last<intent::LoadProgram>()) << s.toast();
  s.settle(IntentState::done);
  s.settle(IntentState::done);
  // IA1M400 leads there; P5; LM0 IA1M0 P3 LA2.
  runs(0);
  EXPECT_EQ(value("blocks/2/time"), "on its way");
  runs(1);
  EXPECT_EQ(value("blocks/2/time"), "runs");
  runs(3);
  EXPECT_EQ(value("blocks/4/time"), "runs");
  EXPECT_NE(value("blocks/2/time"), "runs");
  s.now.program.run = RunState::held;
  s.stage.frames(3);
  EXPECT_EQ(value("blocks/4/time"), "held here");
  s.click("blocks/4");
  s.type("blocks/4/to/1", "7\n");
  EXPECT_NE(value("blocks/4/time"), "held here") << "what runs is not what these blocks are now";
}

TEST_F(BoundBlocks, RunFromHereIsRefusedInsideALoop) {
  load({to(0), {sequence::Repeat{3, {by(10), to({}, 5)}}}});
  s.click("blocks/3");
  s.click("blocks/run_here");
  EXPECT_THAT(value("blocks/run_refused"), ::testing::HasSubstr("the number of passes made is unknown"));
  EXPECT_FALSE(s.stage.find("blocks/run_from/yes"));
}

}  // namespace
}  // namespace hw::panels
