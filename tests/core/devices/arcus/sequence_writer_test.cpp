// What a sequence becomes as a standalone program of an Arcus controller.
#include "core/devices/arcus/sequence_writer.h"

#include <gmock/gmock.h>

#include "core/devices/dmx_k_sa/catalog.h"
#include "core/devices/pmx_4ex_sa/catalog.h"
#include "core/devices/pmx_4ex_sa/program_language.h"
#include "tests/core/device/read_back.h"

namespace hw::arcus {
namespace {

namespace seq = sequence;  // its names are those of commands too
using testing::ElementsAre;
using testing::HasSubstr;

struct ArcusSequence : testing::Test {
  ArcusSequence() { s.axes = {{"X"}, {"Y"}}; }
  std::string write(seq::StepList steps) {
    s.steps = std::move(steps);
    auto text = write_sequence(s, *pmx_4ex_sa::make_catalog({}), language::pmx_4ex_sa());
    if (!text) return text.error().what;
    remarks = text->remarks;
    expect_reads_back(pmx_4ex_sa::program_language(), text->text, s, *pmx_4ex_sa::make_catalog({}));
    return text->text;
  }
  static seq::Move to(double x, double y) {
    seq::Move m;
    m.to[0] = x, m.to[1] = y;
    return m;
  }
  std::string of_dmx(seq::StepList steps) {
    s.axes = {{"X"}};
    s.steps = std::move(steps);
    auto text = write_sequence(s, *dmx_k_sa::make_catalog({}), language::dmx_k_sa());
    return text ? text->text : text.error().what;
  }
  seq::Sequence s;
  std::vector<std::string> remarks;
};

TEST_F(ArcusSequence, ADrawingIsWhatTheMakersConverterMakesOfIt) {
  s.pen_up = {{seq::Output{1, false}}};
  s.pen_down = {{seq::Output{1, true}}};
  EXPECT_EQ(write({{seq::Speed{{10'000, 100, 100}}},
                   {seq::Pen{false}},
                   {to(0, 0)},
                   {to(26164, 34325)},
                   {seq::WaitMotion{}},
                   {seq::Pen{true}},
                   {to(27023, 41834)}}),
            "; Tool off: output 1 off\n"
            "HSPD=10000\nLSPD=100\nACC=100\nGOSUB 1\nABS\nX0Y0\nX26164Y34325\nWAITX\nWAITY\nGOSUB 2\n"
            "X27023Y41834\nEND\nSUB 1 ; Pen up\nDO1=0\nENDSUB\nSUB 2 ; Pen down\nDO1=1\nENDSUB\n");
}

// PMX manual ch. 10, ARC: from (0,1000) by (1000,0) is clockwise from 90 to 180 degrees.
TEST_F(ArcusSequence, ArcsNameTheAngleOfTheirEnd) {
  EXPECT_EQ(write({{to(0, 1000)}, {seq::Arc{0, 0, -90}}}), "ABS\nX0Y1000\nARCP0:0:180000:90000\nEND\n");
  EXPECT_EQ(write({{to(-1000, 0)}, {seq::Arc{0, 0, 270}}}), "ABS\nX-1000Y0\nARCN0:0:90000:270000\nEND\n");
  EXPECT_EQ(write({{to(0, 0)}, {seq::Arc{0, 2000, 360}}, {seq::Arc{0, 2000, -360}}}),
            "ABS\nX0Y0\nCIRN0:2000\nCIRP0:2000\nEND\n");
}

TEST_F(ArcusSequence, XAndYMayBeAnyTwoOfTheBlocksAxes) {
  s.axes = {{"Z"}, {"X"}, {"Y"}};
  seq::Move begin;
  begin.to[1] = 0, begin.to[2] = 1000;
  EXPECT_EQ(write({{begin}, {seq::Arc{0, 0, -90, {}, {1, 2}}}}), "ABS\nX0Y1000\nARCP0:0:180000:90000\nEND\n");
  EXPECT_EQ(write({{begin}, {seq::Arc{0, 0, 90, {}, {2, 1}}}}), "ABS\nX0Y1000\nARCP0:0:180000:90000\nEND\n")
      << "Y to the right and X up is the same, seen from behind";
}

TEST_F(ArcusSequence, ALargeArcEndsWhereItShould) {
  EXPECT_EQ(write({{to(1'000'000, 0)}, {seq::Arc{0, 0, 30.0005}}}),
            "ABS\nX1000000Y0\nARCN0:0:150000:30001\nX866021Y500008\nEND\n")
      << "a thousandth of a degree is 17 pulses there";
}

TEST_F(ArcusSequence, AnArcNeedsToKnowWhereItBegins) {
  seq::Move by = to(1, 1);
  by.relative = true;
  EXPECT_THAT(write({{by}, {seq::Arc{0, 0, 90}}}),
              HasSubstr("Step 2 (arc): put an absolute move of both axes before it: its start is not known"));
  EXPECT_EQ(write({{to(10, 0)}, {by}, {seq::Arc{0, 1, 360}}}), "ABS\nX10Y0\nINC\nX1Y1\nABS\nCIRN0:1\nEND\n");
  seq::Repeat loop;
  loop.steps = {{seq::Arc{0, 0, 90}}};
  EXPECT_THAT(write({{to(10, 0)}, {loop}}),
              HasSubstr("Step 2.1 (arc): put an absolute move of both axes before it"))
      << "the second time it begins elsewhere";
  s.axes[1].per_unit = 2;
  EXPECT_THAT(write({{to(10, 0)}, {seq::Arc{0, 0, 90}}}), HasSubstr("ellipse"));
  s.axes = {{"X"}, {"Y"}, {"Z"}};
  EXPECT_THAT(write({{to(10, 0)}, {seq::Arc{0, 0, 90, {}, {0, 2}}}}),
              HasSubstr("Step 2 (arc): a PMX draws arcs only with X and Y, and this arc lies in X and Z."));
  s.axes = {{"X", 1e5}, {"Y", 1e5}};
  EXPECT_THAT(write({{to(1342, 0)}, {seq::Arc{-1, 0, 90}}}),
              HasSubstr("its radius is 134300000 pulses; 134216773"));
}

TEST_F(ArcusSequence, SpeedsAreGivenBack) {
  seq::Move own = to(5, 5);
  own.own = seq::Speeds{200, 0, 50};
  EXPECT_EQ(
      write({{seq::Speed{{1000, 100, 300}}}, {own}, {to(0, 0)}, {to(1, 1)}}),
      "HSPD=1000\nLSPD=100\nACC=300\nHSPD=200\nACC=50\nABS\nX5Y5\nHSPD=1000\nACC=300\nX0Y0\nX1Y1\nEND\n");
}

TEST_F(ArcusSequence, EveryOtherStepIsAStatement) {
  seq::MoveOnInput on_input;
  on_input.input = 3, on_input.axis = 1, on_input.to = 77, on_input.stops_first = true;
  seq::MoveOnInput jog;
  jog.input = 4, jog.on = false, jog.kind = seq::MoveOnInput::Kind::jog, jog.direction = Sign::minus;
  seq::Repeat loop;
  loop.times = 4, loop.steps = {{seq::Delay{10}}};
  EXPECT_EQ(write({{seq::Comment{"a\nb"}},
                   {seq::Enable{1, true}},
                   {seq::Jog{0, Sign::minus, {}}},
                   {seq::Stop{0, false}},
                   {seq::Stop{-1, true}},
                   {seq::Home{1, Sign::plus, {}}},
                   {seq::WaitMotion{1}},
                   {seq::WaitInput{2, true}},
                   {on_input},
                   {jog},
                   {seq::Output{-1, true, 0xA5}},
                   {loop},
                   {seq::Custom{"", "V1=V2\nECLEARX"}}}),
            "; a\n; b\nEO2=1\nJOGX-\nSTOPX\nABORT\nHOMEY+\nWAITY\nWHILE DI2=0\nENDWHILE\n"
            "ABS\nIF DI3=1\n  STOPY\n  WAITY\n  Y77\nENDIF\nIF DI4=0\n  JOGX-\nENDIF\nDO=165\n"
            "V49=0\nWHILE V49<4\n  DELAY=10\n  V49=V49+1\nENDWHILE\nV1=V2\nECLEARX\nEND\n");
  EXPECT_THAT(write({{seq::Output{-1, true, 256}}}),
              HasSubstr("the controller has 8 outputs; the value 256 is too large"));
}

TEST_F(ArcusSequence, TheDmxHasOneAxisAndNoArcs) {
  seq::Move m;
  m.to[0] = 5;
  EXPECT_EQ(of_dmx({{seq::Enable{0, true}}, {m}, {seq::Stop{}}, {seq::WaitMotion{}}}),
            "EO=1\nABS\nX5\nSTOPX\nWAITX\nEND\n");
  EXPECT_THAT(of_dmx({{seq::Arc{0, 0, 90}}}), HasSubstr("a DMX draws no arcs"));
}

TEST_F(ArcusSequence, AContourStopsAtItsCornersAndReportsIt) {
  seq::Contour c;
  c.x = 1, c.y = 2;
  c.steps = {{to(5, 2)}, {seq::Output{1, true}}, {seq::Arc{5, 4, 90}}};
  EXPECT_EQ(write({{c}}), "ABS\nX1Y2\nX5Y2\nWAITX\nDO1=1\nARCN5:4:180000:90000\nEND\n");
  EXPECT_THAT(remarks, ElementsAre("Step 1 (contour): it stops at each corner."));
}

TEST_F(ArcusSequence, TheToolIsNoPartOfItsOwnRoutines) {
  s.pen_down = {{seq::Pen{true}}};
  EXPECT_THAT(write({{seq::Pen{true}}}),
              HasSubstr("Pen down, step 1 (pen): the tool cannot be part of its own"));
}

}  // namespace
}  // namespace hw::arcus
