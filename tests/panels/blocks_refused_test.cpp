// Blocks that a controller cannot do are marked, each, and all others stay what they are.
#include <algorithm>

#include "tests/panels/blocks_stage.h"

namespace hw::panels {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

struct RefusedBlocks : test_blocks::BlocksStage {
  using BlocksStage::BlocksStage;
};
struct VxmRefusedBlocks : test_blocks::BlocksStage {
  VxmRefusedBlocks() : BlocksStage("vxm") {}
};
struct BoardBlocks : test_blocks::BlocksStage {
  BoardBlocks() : BlocksStage("vme58") {}
};

TEST_F(VxmRefusedBlocks, EachIsMarkedAndTheOthersKeepTheirTextPathAndTimes) {
  sequence::Move by;
  by.relative = true, by.to[0] = 400;
  load({{by}, {sequence::Arc{0, 0, 90, {}}}, {sequence::Delay{500}}, {sequence::Stop{}}});
  EXPECT_EQ(text(), "I1M400\n; block 2 is not written\nP5\n; block 4 is not written\n");
  EXPECT_EQ(value("blocks/2/time"), "not written");
  EXPECT_EQ(value("blocks/4/time"), "not written");
  EXPECT_THAT(value("blocks/2/refusal"), HasSubstr("draws no arcs"));
  EXPECT_THAT(value("blocks/4/refusal"), HasSubstr("there is nothing to stop"));
  EXPECT_EQ(value("blocks/3/time"), "0.5 s");
  EXPECT_EQ(s.stage.find("blocks/total")->label, "Rehearsed without 2, 4");
  EXPECT_TRUE(s.stage.find("blocks/path"));
  EXPECT_THAT(s.reason("blocks/run"), HasSubstr("Step 2 (arc): a VXM moves one motor at a time"));
  EXPECT_THAT(s.reason("blocks/run"), HasSubstr("1 more block is not written"));
  s.click("blocks/2");
  s.click("blocks/remove");
  EXPECT_THAT(s.reason("blocks/run"), HasSubstr("Step 3 (stop)"));
  s.click("blocks/3");
  s.click("blocks/remove");
  EXPECT_EQ(s.reason("blocks/to_program"), "");
  EXPECT_EQ(text(), "I1M400\nP5\n");
}

TEST_F(RefusedBlocks, TheNearestThatCanBeIsOneClickAway) {
  s.click("blocks/add/move");
  s.type("blocks/1/to/Y", "5");
  s.type("blocks/1/to/X", "900000000");
  s.stage.frames(3);
  EXPECT_EQ(text(), "; block 1 is not written\nEND\n");
  EXPECT_THAT(value("blocks/1/refusal"), HasSubstr("the range of "));
  s.click("blocks/1/nearest");
  s.stage.frames(3);
  EXPECT_THAT(text(), HasSubstr("X134217727Y5\n"));
  EXPECT_EQ(s.reason("blocks/to_program"), "");
}

/// In each controller's language.
struct OwnTexts : test_blocks::BlocksStage, ::testing::WithParamInterface<const char*> {
  OwnTexts() : BlocksStage(GetParam()) {}
};
TEST_P(OwnTexts, OneThatIsWrongIsLeftOutAndTheOthersKeepTextAndTimes) {
  load({{sequence::Delay{500}}, {sequence::Custom{"", "NONSENSE 5"}}, {sequence::Delay{1500}}});
  s.stage.frames(10);
  EXPECT_EQ(value("blocks/1/time"), "0.5 s");
  EXPECT_EQ(value("blocks/2/time"), "not written");
  EXPECT_EQ(value("blocks/3/time"), "1.5 s");
  EXPECT_THAT(text(), HasSubstr("block 2 is not written"));
  EXPECT_THAT(text(), Not(HasSubstr("NONSENSE")));
  EXPECT_NE(value("blocks/2/refusal"), "");
  EXPECT_EQ(s.stage.find("blocks/total")->label, "Rehearsed without 2");
  EXPECT_THAT(s.reason("blocks/run"), StartsWith("Step 2 (custom): "));
  s.click("blocks/2");
  s.click("blocks/remove");
  s.stage.frames(6);
  EXPECT_EQ(s.reason("blocks/to_program"), "");
  EXPECT_EQ(s.stage.find("blocks/total")->label, "Rehearsed");
}
INSTANTIATE_TEST_SUITE_P(Each, OwnTexts, ::testing::Values("vxm", "pmx-4ex-sa", "dmx-k-sa", "vme58"),
                         [](const auto& info) {
                           std::string name = info.param;
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

TEST_F(RefusedBlocks, OfAnOwnTextThatSpoilsAnotherBlockThatOneIsNamed) {
  sequence::Repeat loop;
  loop.times = 3;
  loop.steps = {{sequence::Custom{"", "ENDWHILE"}}, {sequence::Delay{1000}}};
  load({{loop}, {sequence::Delay{500}}});
  s.stage.frames(10);
  EXPECT_EQ(value("blocks/2/time"), "not written");
  EXPECT_EQ(value("blocks/2/refusal"), "Block 1 cannot be written with it: ENDWHILE has no WHILE above it.");
  EXPECT_EQ(value("blocks/4/time"), "0.5 s");
  EXPECT_EQ(s.stage.find("blocks/total")->label, "Rehearsed without 1.1");
}

TEST_F(RefusedBlocks, OfAnOwnTextOfSeveralLinesTheOneThatIsWrongIsNamed) {
  load({{sequence::Custom{"", "DELAY=100\nNONSENSE"}}});
  EXPECT_THAT(value("blocks/1/refusal"), StartsWith("Line 2: NONSENSE is not a statement"));
}

TEST_F(VxmRefusedBlocks, TheReasonStandsAtItsBlockAndTheTopLeadsThere) {
  sequence::StepList steps(40, {sequence::Delay{10}});
  steps[30].body = sequence::Arc{0, 0, 90, {}};
  steps[35].body = sequence::Enable{0, true};
  load(std::move(steps));
  EXPECT_EQ(value("blocks/problem"), "2 blocks are refused.");
  EXPECT_EQ(value("blocks/36/refusal"), "The motor power of a VXM cannot be switched by a program.");
  EXPECT_FALSE(s.stage.find("blocks/31")->in_view());
  s.click("blocks/show_refused");
  s.stage.frames(3);
  ASSERT_TRUE(s.stage.find("blocks/31/refusal")) << "it is open";
  EXPECT_TRUE(s.stage.find("blocks/31/x"));
  EXPECT_TRUE(s.stage.find("blocks/31/refusal")->in_view());
  EXPECT_TRUE(s.stage.find("blocks/31")->in_view());
}

TEST_F(RefusedBlocks, EachShowsHowManyLinesItTakes) {
  sequence::Repeat loop;
  loop.times = 3;
  loop.steps = {{sequence::Delay{10}}};
  load({{loop}, {sequence::WaitInput{1, true}}});
  EXPECT_EQ(value("blocks/1/lines"), "4") << "counter, WHILE, one more, ENDWHILE";
  EXPECT_EQ(value("blocks/2/lines"), "1");
  EXPECT_EQ(value("blocks/3/lines"), "2");
}

TEST_F(VxmRefusedBlocks, NewBlocksAreSuchAsTheControllerDoes) {
  for (const char* id : {"blocks/add/speed", "blocks/add/wait_input", "blocks/add/output", "blocks/add/delay",
                         "blocks/add/move_on_input", "blocks/add/home", "blocks/add/move_by"})
    s.click(id);
  s.stage.frames(3);
  EXPECT_EQ(s.stage.find("blocks/problem"), nullptr) << value("blocks/problem");
}

TEST_F(BoardBlocks, NewBlocksAreSuchAsTheControllerDoes) {
  for (const char* id : {"blocks/add/jog", "blocks/add/speed", "blocks/add/wait_input", "blocks/add/output",
                         "blocks/add/delay", "blocks/add/home", "blocks/add/move"})
    s.click(id);
  s.stage.frames(3);
  EXPECT_EQ(s.stage.find("blocks/problem"), nullptr) << value("blocks/problem");
  EXPECT_THAT(text(), HasSubstr("JG1000;"));
}

TEST_F(RefusedBlocks, AnArcThatIsAddedBehindAMoveCanBeDrawn) {
  s.click("blocks/add/move");
  s.type("blocks/1/to/Y", "0");
  s.click("blocks/add/arc");
  EXPECT_EQ(s.stage.find("blocks/problem"), nullptr) << value("blocks/problem");
}

TEST_F(RefusedBlocks, OfALongLoopThePassesAreReported) {
  sequence::Repeat loop;
  loop.times = 3000;
  loop.steps = {{sequence::Delay{2000}}};
  load({{loop}, {sequence::Delay{1000}}});
  s.stage.frames(20);
  EXPECT_THAT(value("blocks/1/time"), StartsWith("3000 x 2.0 s"));
  EXPECT_THAT(value("blocks/at_least"), StartsWith("at least 1 h 40 min"));
  EXPECT_FALSE(s.stage.find("blocks/total"));
  loop.times = 3;
  load({{loop}, {sequence::Delay{1000}}});
  s.stage.frames(6);
  EXPECT_THAT(value("blocks/1/time"), StartsWith("3 x 2.0 s"));
  EXPECT_THAT(value("blocks/total"), StartsWith("7"));
}

}  // namespace
}  // namespace hw::panels
