// Which blocks the standalone programs of the Arcus controllers are.
#include <gmock/gmock.h>

#include "core/devices/dmx_k_sa/catalog.h"
#include "core/devices/dmx_k_sa/program_language.h"
#include "core/devices/pmx_4ex_sa/catalog.h"
#include "core/devices/pmx_4ex_sa/program_language.h"
#include "tests/core/device/read_back.h"

namespace hw::arcus {
namespace {

namespace seq = sequence;  // its names are those of commands too
using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;

struct ArcusReading : testing::Test {
  ArcusReading() { frame.unit = "mm", frame.axes = {{"X", 100}, {"Y", 100}}; }
  std::string blocks(std::string_view text) {
    const auto read = pmx_4ex_sa::program_language().read(text, frame, *pmx_4ex_sa::make_catalog({}));
    if (!read) return read.error().what;
    remarks = read->remarks;
    return in_words(read->sequence.steps, read->sequence);
  }
  seq::Sequence frame;
  std::vector<std::string> remarks;
};

// PMX manual ch. 11, example 3.
TEST_F(ArcusReading, TheManualsLoopIsOne) {
  EXPECT_EQ(
      blocks("HSPD=20000 ;* the high speed\nLSPD=1000\nACC=300\nEO=1\nV1=0\nWHILE V1<10\n  X0\n  WAITX\n"
             "  X1000\n  WAITX\n  V1=V1+1\nENDWHILE\nEND\n"),
      "Speed 200 from 10 mm/s, 300 ms\nown: EO=1\nLoop 10 times\n  Move to X 0\n  Until still X\n"
      "  Move to X 10\n  Until still X\n");
  EXPECT_THAT(remarks, ElementsAre("The loop of line 6 now counts in V49, as blocks do, instead of V1.",
                                   HasSubstr("Line 7 moves to a place or by a distance"),
                                   "A remark after a command is not shown."));
}

TEST_F(ArcusReading, StatementsThatNoBlockHoldsStayTheirOwnText) {
  EXPECT_EQ(blocks("ABS\nX100\nIF DI1=1\n  X200 ; there\n  V1=V1+1\nENDIF\nV2=MSTX\nDO1=1\nEND\n"),
            "Move to X 1\nown: IF DI1=1\n  X200 ; there\n  V1=V1+1\nENDIF\nV2=MSTX\nOutput 1 on\n");
  EXPECT_EQ(blocks("ABS\nXV1\nX100\nEND\n"), "own: ABS\nXV1\nMove to X 1\n");
  EXPECT_EQ(blocks("ABS\nX100Z5\nX200\nEND\n"), "own: ABS\nX100Z5\nMove to X 2\n")
      << "Z is none of their axes";
}

TEST_F(ArcusReading, PowerOfAllAxesIsABlockForEach) {
  frame.axes = {{"X", 100}, {"Y", 100}, {"Z", 100}, {"U", 100}};
  EXPECT_EQ(blocks("EO=5 ; X and Z\nABS\nX100\nEND\n"),
            "Motor power X on\nMotor power Y off\nMotor power Z on\nMotor power U off\nMove to X 1\n");
  EXPECT_EQ(blocks("EO=V1\nABS\nX100\nEND\n"), "own: EO=V1\nMove to X 1\n");
}

TEST_F(ArcusReading, ADecisionOnAnInputIsABlock) {
  EXPECT_EQ(blocks("ABS\nIF DI3=1\n  STOPY\n  WAITY\n  Y700\nENDIF\nIF DI4=0\nJOGX-\nENDIF\nWHILE DI2=0\n"
                   "ENDWHILE\nEND\n"),
            "Move on input Y to 7 if input 3 is on\nMove on input X jog \u2212 if input 4 is off\n"
            "Wait for input until input 2 is on\n");
}

TEST_F(ArcusReading, ACounterThatIsUsedOtherwiseIsNoCounter) {
  EXPECT_EQ(blocks("ABS\nX5\nV1=0\nWHILE V1<3\n  XV1\n  V1=V1+1\nENDWHILE\nEND\n"),
            "Move to X 0.05\nown: V1=0\nWHILE V1<3\n  XV1\n  V1=V1+1\nENDWHILE\n");
}

TEST_F(ArcusReading, SpeedsThatBlocksWouldWriteElsewhereAreOwnText) {
  EXPECT_EQ(blocks("ABS\nHSPD=1000\nWHILE 1=1\n  X0\n  HSPD=2000\n  X100\nENDWHILE\nEND\n"),
            "own: HSPD=1000\nLoop for ever\n  Move to X 0\n  own: HSPD=2000\n  Move to X 1\n")
      << "the first time X0 is slow, then fast";
}

TEST_F(ArcusReading, ByADistanceIsReported) {
  EXPECT_EQ(blocks("INC\nX100\nABS\nX0Y0\nEND\n"), "Move by X 1\nMove to X 0, Y 0\n");
  EXPECT_EQ(blocks("ABS\nX0\nWHILE 1=1\n  X100\n  INC\n  Y100\nENDWHILE\nEND\n"),
            "Move to X 0\nLoop for ever\n  own: X100\n  Move by Y 1\n")
      << "to a place the first time, by a distance then";
}

TEST_F(ArcusReading, AxesOfDifferentUnitsAreReadInSteps) {
  frame.axes[1].per_unit = 25;
  EXPECT_EQ(blocks("ABS\nHSPD=500\nX100Y50\nEND\n"), "Speed 500 pulses/s\nMove to X 100, Y 50\n");
  EXPECT_THAT(remarks, ElementsAre(HasSubstr("speeds are in pulses")));
}

TEST_F(ArcusReading, StatementsWithoutAPlaceInBlocksAreRefusedByTheirLine) {
  EXPECT_EQ(blocks("X0\nGOSUB 3\nEND\nSUB 3\nX1\nENDSUB\n"),
            "Line 4: a subroutine. Blocks have none but those of the tool.");
  EXPECT_EQ(blocks("X0\nEND\nPRG 1\nX1\nEND\n"),
            "Line 3: a program beside the first. Blocks are one program.");
  EXPECT_THAT(blocks("X0\nXX\nEND\n"), StartsWith("Line 2: "));
  EXPECT_EQ(blocks("V1=2\nEND\n"), "Line 1: blocks have no variables. The rest is not a block either.");
  EXPECT_THAT(blocks("LISTING pmx-4ex-sa 1\n0 END\n"), StartsWith("Line 1: a listing"));
}

TEST(DmxReading, OneAxisAndItsPower) {
  seq::Sequence frame;
  frame.axes = {{"X"}};
  EXPECT_EQ(blocks_of(dmx_k_sa::program_language(), "PRG 0\nEO=1\nABS\nX5\nWAITX\nDO=3\nEND\n", frame,
                      *dmx_k_sa::make_catalog({})),
            "Motor power X on\nMove to X 5\nUntil still all\nOutput all: 3\n");
}

}  // namespace
}  // namespace hw::arcus
