// Which blocks the command strings of a VME58 are.
#include <gmock/gmock.h>

#include "core/devices/vme58/catalog.h"
#include "core/devices/vme58/program_language.h"
#include "tests/core/device/read_back.h"

namespace hw::vme58 {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

struct Vme58Reading : testing::Test {
  Vme58Reading() { frame.unit = "mm", frame.axes = {{"X", 100}, {"Y", 100}}; }
  std::string blocks(std::string_view text) {
    return blocks_of(program_language(), text, frame, *make_catalog({}));
  }
  sequence::Sequence frame;
};

TEST_F(Vme58Reading, ListsAreMovesOfTheirAxes) {
  EXPECT_EQ(blocks("AA VL5000,5000; AC50000,50000; # fast\nMT100,200; GO WA\nMR,-5; GO\nHM0; JG,300;\n"),
            "Speed 50 mm/s, 100 ms\nMove to X 1, Y 2\nUntil still all\nMove by Y \u22120.05\nHome X, to +\n"
            "Jog Y +\n");
}

TEST_F(Vme58Reading, LoopsWaitsAndOutputsAreBlocks) {
  EXPECT_EQ(
      blocks("AA LS3 WH WT10 WG BL8 LE SW3\nWA WQ AY AN AA\n"),
      "Loop 3 times\n  Loop for ever\n    Delay 10 ms\n  Output 8 on\nWait for input until input 3 is off\n"
      "Output 15 on\n");
}

TEST_F(Vme58Reading, ARecordingIsAContour) {
  EXPECT_EQ(
      blocks("AA\nCV1000;\nCD0,0;\nAN0;\nCR0,5000,3.141592654;\nMT-1000,10000;\nCE\nMT-1000,0; GO\nCX\n"),
      "Contour from 0, 0\n  Output 14 on\n  Arc about 0, 50, 180\u00b0\n  Move to X \u221210, Y 100\n");
  EXPECT_EQ(blocks("AA\nMT1,1; GO\nCV10 CD0,0,0; MT1,2,3; CE CX\n"),
            "Move to X 0.01, Y 0.01\nown: CV10 CD0,0,0; MT1,2,3; CE CX\n");
}

TEST_F(Vme58Reading, CommandsOfOneAxisStayAsTheyAre) {
  EXPECT_EQ(blocks("AX KP2 HN # the loop\nAA MT100,200; GO\n"),
            "own: AX KP2 HN # the loop\nMove to X 1, Y 2\n");
  EXPECT_EQ(blocks("AX MR1000 GO AY MR5 GO\n"),
            "Line 1: a single axis (AX, AY ...) has a queue of its own, beside the one of all axes (AA) that "
            "blocks use. The rest is not a block either.");
  EXPECT_THAT(blocks("MR1000 GO AA MT1,2; GO\n"), StartsWith("Line 1: "))
      << "for X, or whoever was addressed";
}

TEST_F(Vme58Reading, OneAxisAloneIsTheSameInListsOfAll) {
  EXPECT_EQ(blocks("AY\nLS3 MR1000 GO WT10 LE BL8 MA-5 GO\n"),
            "Loop 3 times\n  Move by Y 10\n  Delay 10 ms\nOutput 8 on\n"
            "Move to Y \u22120.05\n");
  EXPECT_EQ(blocks("AX JG500\n"), "Jog X +\n");
  EXPECT_EQ(blocks("AX VL900 MR1 GO\n"), "own: VL900\nMove by X 0.01\n");
  EXPECT_THAT(blocks("AX MR1000 GO ID\n"), StartsWith("Line 1: a single axis")) << "its own done flag";
  EXPECT_THAT(blocks("AX KP2 MR1000 GO\n"), StartsWith("Line 1: a single axis"));
}

TEST_F(Vme58Reading, OneAxisAloneTakesAsLongInLists) {
  const Catalog catalog = *make_catalog({});
  constexpr std::string_view own = "AY VL4000 AC40000 LS3 MR1000 GO WT10 LE BL8 MR-2500 GO SW3 MA20 GO BH8\n";
  const auto read = program_language().read(own, frame, catalog);
  ASSERT_TRUE(read) << read.error().sentence();
  const auto lists = program_language().write(read->sequence, catalog);
  ASSERT_TRUE(lists) << lists.error().sentence();
  const auto ours = program_language().rehearse(own, {}),
             theirs = program_language().rehearse(lists->text, {});
  ASSERT_TRUE(ours && theirs);
  EXPECT_TRUE(ours->finished && theirs->finished);
  EXPECT_GT(ours->duration_s, 1);
  EXPECT_NEAR(ours->duration_s, theirs->duration_s, 0.001) << lists->text;
  for (std::size_t axis = 0; axis < ours->axes.size(); ++axis)
    EXPECT_EQ(ours->axes[axis].position, theirs->axes[axis].position);
}

TEST_F(Vme58Reading, MovesThatWaitStayAsTheyAre) {
  EXPECT_EQ(blocks("AA MA5; WT10 GO MA,7; GO\n"), "own: MA5\nDelay 10 ms\nown: GO\nMove to Y 0.07\n");
  EXPECT_THAT(blocks("AA XY\n"), HasSubstr("Line 1: There is no command XY"));
}

}  // namespace
}  // namespace hw::vme58
