// What a sequence becomes as command strings of a VME58.
#include "core/devices/vme58/sequence_writer.h"

#include <gmock/gmock.h>

#include "core/devices/vme58/catalog.h"
#include "core/devices/vme58/program_check.h"
#include "core/devices/vme58/program_language.h"
#include "tests/core/device/read_back.h"

namespace hw::vme58 {
namespace {

namespace seq = sequence;  // its names are those of commands too
using testing::ElementsAre;
using testing::HasSubstr;

struct Vme58Sequence : testing::Test {
  Vme58Sequence() { s.axes = {{"X"}, {"Z"}}; }
  std::string write(seq::StepList steps) {
    s.steps = std::move(steps);
    auto text = write_sequence(s, *make_catalog({}));
    if (!text) return text.error().what;
    for (const Problem& p : check_program(text->text).problems)
      EXPECT_FALSE(p.error) << "line " << p.line + 1 << ": " << p.sentence << "\n" << text->text;
    remarks = text->remarks;
    expect_reads_back(program_language(), text->text, s, *make_catalog({}));
    return text->text;
  }
  static seq::Move to(double x, double y) {
    seq::Move m;
    m.to[0] = x, m.to[1] = y;
    return m;
  }
  seq::Sequence s;
  std::vector<std::string> remarks;
};

TEST_F(Vme58Sequence, ListsGoByPlace) {
  seq::Move one;
  one.to[1] = -7;
  seq::Move by = to(5, 6);
  by.relative = true;
  EXPECT_EQ(write({{seq::Speed{{2000, 500, 100}}}, {to(10, 20)}, {by}, {one}}),
            "AA\nVL2000,,2000;\nVB500,,500;\nAC15000,,15000;\nMT10,,20; GO\nML5,,6; GO\nMA,,-7; GO\n");
}

TEST_F(Vme58Sequence, EveryOtherStepIsAQueuedCommand) {
  seq::Repeat ever, thrice;
  thrice.times = 3, thrice.steps = {{seq::Delay{10}}};
  ever.steps = {{thrice}};
  EXPECT_EQ(
      write({{seq::Comment{"a\nb"}},
             {seq::Home{1, Sign::minus, {}}},
             {seq::WaitMotion{}},
             {seq::WaitInput{3, false}},
             {seq::Output{8, true}},
             {seq::Output{-1, true, 2}},
             {seq::Jog{1, Sign::minus, seq::Speeds{300}}},
             {ever}}),
      "AA\n# a\n# b\nHR,,0;\nWA\nSW3\nBL8\nBH8\nBL9\nBH10\nBH11\nBH12\nBH13\nJG,,-300;\nWH\nLS3\nWT10\nLE\n"
      "WG\n");
}

TEST_F(Vme58Sequence, AnAuxiliaryOutputWaitsForTheMotion) {
  EXPECT_EQ(write({{to(1, 2)}, {seq::Output{first_auxiliary + 2, true}}, {to(3, 4)}}),
            "AA\nMT1,,2; GO\nWA\nWQ\nAZ AN AA\nMT3,,4; GO\n");
}

// Data sheet, Example 3.
TEST_F(Vme58Sequence, TheDataSheetsHole) {
  s.axes = {{"Z"}, {"T"}};
  seq::Contour c;
  c.lead_in = 1000, c.own = seq::Speeds{1000};
  c.steps = {{seq::Output{first_auxiliary, true}},
             {seq::Arc{0, 5000, 180}},
             {seq::Arc{0, 0, 360}},
             {seq::Output{first_auxiliary, false}},
             {to(-10, 10'000)}};
  EXPECT_EQ(write({{c}}),
            "AA\nCV1000;\nCD,,0,0;\nAN0;\nCR0,5000,3.141592654;\nCR0,0,6.283185307;\nAF0;\nMT-10,10000;\nCE\n"
            "MT,,-1000,0; GO\nCX\n");
}

TEST_F(Vme58Sequence, AxesTheOtherWayRoundAreMirrored) {
  s.axes = {{"Y"}, {"X"}};
  seq::Contour c;
  c.x = 10, c.y = 20, c.ends_ramped = false, c.own = seq::Speeds{500};
  c.steps = {{to(110, 20)}, {seq::Arc{110, 70, 90}}};
  EXPECT_EQ(write({{c}}), "AA\nCV500;\nCD20,10;\nMT20,110;\nCR70,110,-1.570796327;\nCK\nMT20,10; GO\nCX\n");
}

TEST_F(Vme58Sequence, AnArcLiesInAnyTwoAxes) {
  s.axes = {{"X"}, {"Y"}, {"Z"}};
  seq::Move begin;
  begin.to[0] = 0, begin.to[2] = 100;
  EXPECT_EQ(write({{seq::Speed{{1000}}}, {begin}, {seq::Arc{0, 0, -90, {}, {0, 2}}}, {begin}}),
            "AA\nVL1000,1000,1000;\nMT0,,100; GO\nCV1000;\nCD0,,100;\nCR0,0,-1.570796327;\nCK\n"
            "MT0,,100; GO\nCX\nMT0,,100; GO\n");
  seq::Contour c;
  c.plane = {2, 1}, c.own = seq::Speeds{500}, c.ends_ramped = false;
  c.steps = {{seq::Arc{0, 50, 90, {}, {2, 1}}}};
  EXPECT_EQ(write({{c}}), "AA\nCV500;\nCD,0,0;\nCR50,0,-1.570796327;\nCK\nMT,0,0; GO\nCX\n");
  c.steps = {{seq::Arc{0, 50, 90}}};
  EXPECT_THAT(write({{c}}),
              HasSubstr("Step 1.1 (arc): the contour lies in Z and Y, and its arcs must lie there too."));
  c.steps = {{begin}};
  EXPECT_THAT(write({{c}}), HasSubstr("Step 1.1 (move): the contour lies in Z and Y, and no other axis"));
}

TEST_F(Vme58Sequence, AnArcByItselfIsAContourAndTheNextOneWaitsForIt) {
  EXPECT_EQ(write({{seq::Speed{{1000}}}, {to(0, 0)}, {seq::Arc{100, 0, 360}}, {seq::Arc{0, 100, 90}}}),
            "AA\nVL1000,,1000;\nMT0,,0; GO\nCV1000;\nCD0,,0;\nCR100,0,6.283185307;\nCK\nMT0,,0; GO\nCX\n"
            "WA\nWQ\nCV1000;\nCD0,,0;\nCR0,100,1.570796327;\nCK\nMT0,,0; GO\nCX\n");
  EXPECT_THAT(remarks, ElementsAre("Step 3 (arc): it begins and ends at its full speed, without a ramp.",
                                   HasSubstr("Step 4 (arc): ")));
}

TEST_F(Vme58Sequence, SpeedStairsStandInTheQueueOfTheirAxis) {
  seq::SpeedStairs up{1, {{1000, 500}, {5000, 2000}}, 6000};
  EXPECT_EQ(write({{to(1, 2)}, {up}, {to(3, 4)}}),
            "AA\nMT1,,2; GO\nWA\nWQ\nAZ MP\nMV1000,500;\nMV5000,2000;\nSP6000;\nWQ AA WA\nMT3,,4; GO\n");
  const seq::SpeedStairs down{1, {{8000, 500}}, 6000};
  EXPECT_EQ(write({{down}}), "AA\nWA\nWQ\nAZ MM\nMV8000,500;\nSP6000;\nWQ AA WA\n");
  EXPECT_EQ(blocks_of(program_language(), write({{up}}), s, *make_catalog({})),
            "Speed stairs Z, to 1000 at 500, to 5000 at 2000, rest at 6000\n");
}

TEST_F(Vme58Sequence, SpeedStairsGoOneWay) {
  EXPECT_THAT(write({{seq::SpeedStairs{0, {{1000, 500}, {900, 500}}, 2000}}}),
              HasSubstr("Step 1 (speed_stairs): stair 2: 900 does not lie on the way from 1000 to 2000."));
  EXPECT_THAT(write({{to(5000, 0)}, {seq::SpeedStairs{0, {{6000, 500}}, 4000}}}),
              HasSubstr("stair 1: 6000 does not lie on the way from 5000 to 4000."));
  EXPECT_THAT(write({{seq::SpeedStairs{0, {{1000, 0}}, 2000}}}), HasSubstr("stair 1 needs a speed"));
  EXPECT_THAT(write({{seq::SpeedStairs{0, {{1000, 5e9}}, 2000}}}),
              HasSubstr("a speed of 5000000000 steps/s"));
  seq::Repeat loop;
  loop.steps = {{seq::SpeedStairs{0, {{1000, 500}}, 2000}}};
  EXPECT_THAT(write({{loop}}), HasSubstr("Step 1.1 (speed_stairs): a speed staircase is in the queue"));
}

TEST_F(Vme58Sequence, UnsupportedStepsAreRefused) {
  EXPECT_THAT(write({{seq::WaitInput{3, true}}}), HasSubstr("waits until an input is off"));
  EXPECT_THAT(write({{seq::MoveOnInput{}}}), HasSubstr("Step 1 (move_on_input): "));
  EXPECT_THAT(write({{seq::Stop{}}}), HasSubstr("Step 1 (stop): "));
  seq::Repeat with_output;
  with_output.steps = {{seq::Output{first_auxiliary, true}}};
  EXPECT_THAT(write({{with_output}}),
              HasSubstr("Step 1.1 (output): auxiliary outputs are switched in the queue"));
  EXPECT_THAT(write({{seq::Jog{}}}), HasSubstr("put a speed step before the jog"));
  seq::Contour c;
  c.own = seq::Speeds{100};
  EXPECT_THAT(write({{c}}), HasSubstr("no line and no arc"));
  c.steps = {{to(5, 0)}, {seq::Arc{5, 0, 90}}};
  EXPECT_THAT(write({{c}}), HasSubstr("Step 1.2 (arc): the centre of the arc is the point"));
  c.steps = {{seq::Output{8, true}}};
  EXPECT_THAT(write({{c}}), HasSubstr("Step 1.1 (output): Out 8 cannot be switched within a contour"));
  c.steps.clear();
  for (int n = 1; n <= 67; ++n) c.steps.push_back({to(n, 0)});
  EXPECT_THAT(write({{c}}), HasSubstr("it has 201 entries, and the board holds 200"));
  seq::Repeat loop;
  loop.steps = {{c}};
  EXPECT_THAT(write({{loop}}), HasSubstr("cannot be inside a loop"));
}

TEST_F(Vme58Sequence, TheToolIsNoPartOfItsOwnRoutines) {
  s.pen_down = {{seq::Pen{true}}};
  EXPECT_THAT(write({{seq::Pen{true}}}),
              HasSubstr("Pen down, step 1 (pen): the tool cannot be part of its own"));
}

}  // namespace
}  // namespace hw::vme58
