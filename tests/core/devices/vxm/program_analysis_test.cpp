// What the console says of a program text while it is typed.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/devices/vxm/program_language.h"

using namespace hw;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

namespace {

ProgramReport analyse(std::string_view text, int slot = 0) {
  return vxm::program_language().analyse(text, slot);
}

std::vector<std::string> sentences(const ProgramReport& report) {
  std::vector<std::string> all;
  for (const Problem& p : report.problems) all.push_back(p.sentence);
  return all;
}

const Problem& only(const ProgramReport& report) {
  static const Problem none{};
  EXPECT_EQ(report.problems.size(), 1u) << testing::PrintToString(sentences(report));
  return report.problems.empty() ? none : report.problems.front();
}

TEST(VxmAnalysis, TooFastIsReportedWithTheRangeAndAFix) {
  const auto report = analyse("I1M400\nS2M8000,I2M400\n");
  const Problem& p = only(report);
  EXPECT_TRUE(p.error);
  EXPECT_EQ(p.sentence, "8000 is too fast for motor 2. S2M takes 1 to 6000 steps/s.");
  EXPECT_EQ(p.fix_text, "6000");
  EXPECT_EQ(p.line, 1);
  EXPECT_EQ(p.column, 3);
  EXPECT_EQ(p.length, 4);
}

TEST(VxmAnalysis, CostsAndPlacesFollowTheLines) {
  const auto report = analyse("P10,I1M400,L10,I1M-3600\n; only a remark\nU5 ; on\nR\n");
  EXPECT_THAT(sentences(report), IsEmpty());
  ASSERT_EQ(report.lines.size(), 4u);
  EXPECT_EQ(report.lines[0].cost, 14);
  EXPECT_EQ(report.lines[0].first_command, 0);
  EXPECT_EQ(report.lines[0].command_count, 4);
  EXPECT_EQ(report.lines[1].cost, 0);
  EXPECT_EQ(report.lines[1].first_command, -1);
  EXPECT_EQ(report.lines[2].first_command, 4);
  EXPECT_EQ(report.cost.at(0), 16);
  EXPECT_THAT(report.listing.at(0), ElementsAre("P10", "I1M400", "L10", "I1M-3600", "U5"));
}

TEST(VxmAnalysis, ColoursDistinguishMovesFlowAndRemarks) {
  const auto report = analyse("I1M400,L2 ;twice");
  ASSERT_EQ(report.lines[0].tokens.size(), 3u);
  const auto& t = report.lines[0].tokens;
  EXPECT_EQ(t[0].kind, TokenKind::moves);
  EXPECT_EQ(t[0].begin, 0);
  EXPECT_EQ(t[0].end, 6);
  EXPECT_EQ(t[1].kind, TokenKind::flow);
  EXPECT_EQ(t[2].kind, TokenKind::comment);
  EXPECT_EQ(t[2].begin, 10);
  EXPECT_EQ(t[2].end, 16);
}

TEST(VxmAnalysis, ShortFormsMeanTheMotorNamedLast) {
  const auto report = analyse("I2M200,I-200,S2000,IA0,A3");
  EXPECT_THAT(report.listing.at(0), ElementsAre("I2M200", "I2M-200", "S2M2000", "IA2M0", "A2M3"));
}

TEST(VxmAnalysis, HeadingsSortCommandsToPrograms) {
  const auto report = analyse("E\nPM-1 ;the part\nIA1M0\nU5\nPM-0\nJM1,I1M800\n", 3);
  EXPECT_THAT(report.listing.at(1), ElementsAre("IA1M0", "U5"));
  EXPECT_THAT(report.listing.at(0), ElementsAre("JM1", "I1M800"));
  EXPECT_EQ(report.lines[2].slot, 1);
  EXPECT_EQ(report.lines[5].slot, 0);
  EXPECT_EQ(report.lines[5].first_command, 0);
  EXPECT_THAT(sentences(report), IsEmpty());
}

TEST(VxmAnalysis, TooLongReportsByHowMuch) {
  std::string text;
  for (int i = 0; i < 66; ++i) text += "I1M400\n";
  const auto report = analyse(text, 2);
  const Problem& p = only(report);
  EXPECT_EQ(p.sentence, "Program 2 needs 264 bytes and has 256: 8 too many.");
  EXPECT_EQ(p.line, 64);
}

TEST(VxmAnalysis, SmallLettersAreMendedByAFix) {
  const Problem p = only(analyse("i1m400"));
  EXPECT_THAT(p.sentence, HasSubstr("capital and small letters differ"));
  EXPECT_EQ(p.fix_text, "I1M400");
  EXPECT_EQ(p.length, 6);
}

TEST(VxmAnalysis, NonsenseIsOneProblemForEachStretch) {
  const auto report = analyse("hello world, I1M400, S1M, U10, U106, I7M5, L1, L-0, IA1M9000000, S1M-7");
  EXPECT_THAT(
      sentences(report),
      ElementsAre("\"hello world\" is not a command of a VXM.", "S1M needs a number.",
                  "U10 belongs to the VP9000. A VXM does not know it.",
                  "U106 is not among the commands that a Slave carries out for its Master.",
                  "There is no motor 7. Motors are 1 to 4.", "1 passes are not a loop. L takes 2 to 65535.",
                  "L-0 sets a loop marker in NF90 emulation only. LM0 does the same.",
                  "9000000 lies beyond the position register of motor 1. IA1M takes -8388608 to 8388607.",
                  HasSubstr("There is no speed range 7")));
  EXPECT_EQ(report.lines[0].command_count, 1);
}

TEST(VxmAnalysis, AReturnInTheMiddleOfALineEndsItsRemark) {
  const auto report = analyse(";first\rI1M400;then\rI2M-5 ;last");
  EXPECT_THAT(sentences(report), IsEmpty());
  ASSERT_EQ(report.lines.size(), 1u);
  EXPECT_EQ(report.lines[0].command_count, 2);
  int at = 0;
  for (const Token& t : report.lines[0].tokens) {
    EXPECT_GE(t.begin, at);
    at = t.end;
  }
  const auto remarks = [](const Token& t) { return t.kind == TokenKind::comment; };
  EXPECT_EQ(std::count_if(report.lines[0].tokens.begin(), report.lines[0].tokens.end(), remarks), 3);
}

TEST(VxmAnalysis, AnUnreadableCharacterIsShownAsItsByte) {
  EXPECT_THAT(sentences(analyse("\x06,")), ElementsAre("\"\\x06\" is not a command of a VXM."));
}

TEST(VxmAnalysis, PairsWarnAboutTheirOrder) {
  EXPECT_THAT(sentences(analyse("(I3M800,I1M400,)R")), IsEmpty());
  EXPECT_EQ(analyse("(I3M800,I1M400,)").cost.at(0), 10);
  EXPECT_THAT(only(analyse("(I1M400,I3M800,)")).sentence, HasSubstr("must come first"));
  EXPECT_THAT(only(analyse("(I1M400,I2M800,)")).sentence, HasSubstr("never turn together"));
  EXPECT_EQ(only(analyse("(I3M800,I1M400)")).fix_text, "I1M400,)");
  EXPECT_THAT(sentences(analyse("(I3M800,")), ElementsAre("This ( is never closed by )."));
}

TEST(VxmAnalysis, NonstopBlocksAreChecked) {
  EXPECT_THAT(sentences(analyse("S1M1500,U7,I1M1000,I1M100,U9,IA1M0")), IsEmpty());
  EXPECT_THAT(only(analyse("U7,I1M100,P10,U9")).sentence, HasSubstr("P10 is not allowed between U7 and U9"));
  EXPECT_THAT(only(analyse("U7,I1M100")).sentence, HasSubstr("no U9"));
  EXPECT_THAT(only(analyse("U7,I1M100,I2M100,U9")).sentence, HasSubstr("of one motor"));
  EXPECT_THAT(only(analyse("U77,I1M100,U92")).sentence, HasSubstr("right after it"));
}

TEST(VxmAnalysis, WarnsWhereTheControllerWouldBeSilent) {
  EXPECT_THAT(only(analyse("I1M400,R ;go")).sentence, HasSubstr("remark after R"));
  EXPECT_THAT(only(analyse("I1M400,L0,U5")).sentence, HasSubstr("Nothing after L0"));
  EXPECT_THAT(only(analyse("S1M1500,I1M0")).sentence, HasSubstr("Above 1000 steps/s"));
  EXPECT_THAT(only(analyse("PM-0,J2")).sentence, HasSubstr("Program 2 is empty"));
  EXPECT_FALSE(analyse("PM-0,J2").has_errors());
}

TEST(VxmAnalysis, AnythingAtAllCanBeAnalysed) {
  unsigned seed = 1;
  for (int round = 0; round < 300; ++round) {
    std::string text;
    for (int i = 0; i < 200; ++i) {
      seed = seed * 1664525u + 1013904223u;
      static constexpr std::string_view common = "IASLPUJMRCEG0123456789-,.\r\n;()[] setgljPB\0\xff";
      text += common[(seed >> 16) % common.size()];
    }
    const auto report = analyse(text, 4);
    for (const Problem& p : report.problems) {
      EXPECT_FALSE(p.sentence.empty());
      EXPECT_GE(p.column, 0);
      EXPECT_LT(p.line, static_cast<int>(report.lines.size()));
    }
  }
}

TEST(VxmAnalysis, AFractionIsAWarning) {
  const auto report = analyse("I1M400.05,P10\n");
  const Problem& p = only(report);
  EXPECT_FALSE(p.error);
  EXPECT_EQ(p.sentence, "The period ends the number: the fraction .05 is dropped.");
  EXPECT_EQ(p.column, 6);
  EXPECT_EQ(p.length, 3);
  EXPECT_THAT(report.listing.at(0), ElementsAre("I1M400", "P10"));
}

TEST(VxmAnalysis, SettingsThatTheControllerWouldDropAreErrors) {
  for (const auto& [text, sentence] : std::vector<std::pair<const char*, const char*>>{
           {"setM1M9", "setM1M9 is not possible: setM takes 0 to 6."},
           {"setM5M1", "There is no such motor. Motors are 1 to 4."},
           {"setDM256", "setDM256 is not possible: setDM takes 0 to 255."},
           {"setB10", "setB10 is not possible: setB takes 9, 19 or 38."},
           {"setL1M-3", "setL1M-3 is not possible: setL takes -2 to 2."},
           {"setJ1M39", "setJ1M39 is not possible: setJ takes 40 to 6000."},
           {"setP1M-5", "setP1M-5 is not possible: setP takes 1 to 32767, or 0."},
           {"B256", "B256 is not possible: B takes 0 to 255."},
           {"O4", "O4 is not possible: O takes 0 to 3."},
           {"PMA5", "PMA5 is not possible: PMA takes 0 to 4, -0 to -4, or 255."}}) {
    const auto report = analyse(text);
    EXPECT_TRUE(only(report).error) << text;
    EXPECT_EQ(only(report).sentence, sentence);
  }
  for (const char* text :
       {"setM1M6", "setDM255", "setB38", "setL1M-2", "setj1M0", "B255", "O3", "PMA-0", "PMA255"}) {
    const auto report = analyse(text);
    EXPECT_FALSE(only(report).error) << text << ": it acts at once, and that is told";
  }
}

TEST(VxmAnalysis, MotorZeroIsNone) {
  EXPECT_EQ(only(analyse("I0M5")).sentence, "There is no such motor. Motors are 1 to 4.");
}

TEST(VxmAnalysis, TheSecondRIsWarnedOf) {
  const auto report = analyse("I1M5,R\nC\nI1M7,R\n");
  const Problem& p = only(report);
  EXPECT_FALSE(p.error);
  EXPECT_EQ(p.line, 2);
}

}  // namespace
