// Which blocks the stored programs of a VXM are.
#include <gmock/gmock.h>

#include "core/device/settings_in_text.h"
#include "core/devices/vxm/catalog.h"
#include "core/devices/vxm/program_language.h"
#include "tests/core/device/read_back.h"

namespace hw::vxm {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

struct VxmReading : testing::Test {
  VxmReading() { frame.unit = "mm", frame.axes = {{"1", 400}, {"2", 200}}; }
  std::string blocks(std::string_view text) {
    return blocks_of(program_language(), text, frame, *make_catalog({{"motors", "2"}}));
  }
  sequence::Sequence frame;
};

TEST_F(VxmReading, CommandsOfALineAreBlocksOfTheirOwn) {
  EXPECT_EQ(blocks("E\nPM-0 ; the only one\nI1M400,U5,P2 ; a pulse\nIA2M0,U0\nI1M-0,IA1M-0\n"),
            "Move by 1: 1\nOutput 1 on\nDelay 200 ms\nMove to 2: 0\nWait for input until input 1 is on\n"
            "Home 1, to \u2212\n");
}

TEST_F(VxmReading, SpeedsOfAllMotorsAlikeAreASpeed) {
  EXPECT_EQ(blocks("S1M2000,A1M4,S2M1000,A2M2,I1M4\n"), "Speed 5 mm/s, 500 ms\nMove by 1: 0.01\n");
  EXPECT_EQ(blocks("S1M2000,S2M2000,A1M4,I1M4\n"), "own: S1M2000,S2M2000,A1M4\nMove by 1: 0.01\n");
}

TEST_F(VxmReading, LoopsAreThoseThatLeaveNothingOut) {
  EXPECT_EQ(blocks("LM0,I1M400,P1,LA3,LM0,I2M2,L0\n"),
            "Loop 3 times\n  Move by 1: 1\n  Delay 100 ms\nLoop for ever\n  Move by 2: 0.01\n");
  EXPECT_EQ(blocks("IA1M0\nLM0,I1M400 ; on\nL3\nIA1M0\n"),
            "Move to 1: 0\nown: LM0,I1M400 ; on\nL3\nMove to 1: 0\n")
      << "L leaves the last index out";
  EXPECT_EQ(blocks("I1M5,I2M5,L2,IA1M0\n"), "own: I1M5,I2M5,L2\nMove to 1: 0\n") << "back to the begin";
}

TEST_F(VxmReading, AConditionTakesItsCommandAlong) {
  EXPECT_EQ(blocks("U12,IA1M400,U11,S1M2000,I1M4\n"),
            "Move on input 1 to 1 if input 2 is on\nown: U11,S1M2000\nMove by 1: 0.01\n");
  EXPECT_EQ(blocks("PM-0\nU12,JM1\nPM-1\nI2M0\nIA2M-0\n"), "Move on input 2 home + if input 2 is on\n");
  EXPECT_EQ(blocks("I1M4\nU11,I1M-0\nU11,IA1M-0\n"), "Move by 1: 0.01\nown: U11,I1M-0\nU11,IA1M-0\n")
      << "it asks twice, so it may home without zero, or set zero without homing";
}

TEST_F(VxmReading, OtherProgramsAreLoopsWaitsAndTheTool) {
  EXPECT_EQ(blocks("PM-0\nJM1\nLM0,JM2,I1M4,L0\nPM-1\nP-10,U22,L0\nPM-2\nI2M2\nLA3\n"),
            "Wait for input until input 2 is on\nLoop for ever\n  Loop 3 times\n    Move by 2: 0.01\n"
            "  Move by 1: 0.01\n");
  EXPECT_THAT(blocks("PM-0\nI1M4\nJM1\nPM-1\nI2M2\nLA3\n"), StartsWith("Line 5: "))
      << "of blocks it would be no program of its own";
  EXPECT_EQ(blocks("PM-1\nI1M0\nI2M0\nPM-0\nJM1\n"),
            "Line 5: program 1 is more than a loop or a wait. Blocks have no other programs.");
  EXPECT_EQ(blocks("PM-1\nI1M4\nPM-0\nI1M5\n"), "Line 1: no block runs program 1.");
  EXPECT_EQ(blocks("PM-0\nI1M4\nJ1\nPM-1\nI1M5\n"), "Line 3: no block goes to another program in this way.");
}

TEST_F(VxmReading, CommandsThatActAtOnceAreNoProgram) {
  EXPECT_EQ(blocks("I1M400\nR\n"), "Line 2: R acts at once. Blocks are programs.");
  EXPECT_THAT(blocks("I1M400\nI9M4\n"), StartsWith("Line 2: "));
  EXPECT_THAT(blocks("IA1M-0\n"), HasSubstr("Line 1: no block sets zero here"));
}

/// A speed without a motor is that of the motor before it, which may be another one elsewhere.
TEST(VxmSettings, NameTheirMotor) {
  const auto* language = dynamic_cast<const SettingsInText*>(&program_language());
  ASSERT_TRUE(language);
  EXPECT_TRUE(language->only_sets("S1M4000"));
  EXPECT_TRUE(language->only_sets("S1M4000,A2M5"));
  EXPECT_FALSE(language->only_sets("S4000"));
  EXPECT_FALSE(language->only_sets("I1M400"));
}

}  // namespace
}  // namespace hw::vxm
