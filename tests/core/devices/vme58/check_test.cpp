// Command strings before they are sent: what is wrong with them, and where.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/devices/vme58/command_text.h"
#include "core/devices/vme58/program_check.h"

namespace hw::vme58 {
namespace {

using testing::HasSubstr;

std::vector<Problem> errors(std::string_view text) {
  std::vector<Problem> all;
  for (Problem& p : check_program(text).problems)
    if (p.error) all.push_back(std::move(p));
  return all;
}

TEST(Vme58Check, TheDataSheetsExamplesAreRight) {
  EXPECT_TRUE(errors("AX\nVL1000 AC10000\nKP2 KD6 HN\nHM0\nVL5000 AC50000\nMA-10000 GO ID\n").empty());
  EXPECT_TRUE(
      errors("AX KP2 KD6 HN\nAY KP2 KD6 HN\nAZ KP2 KD6 HN\nAM\nVL5000,5000,5000;\nAC50000,50000,50000;\n"
             "MA1000,2000,3000; GO ID\n")
          .empty());
  EXPECT_TRUE(
      errors("AA\nCV1000\nCD,,0,0;\nAN0;\nCR0,5000,3.1415926\nCR0,0,6.2831853\nAF0;\nMT-10,10000\nCE\n"
             "MT,,-1000,0; GO\nCX\n")
          .empty());
}

TEST(Vme58Check, FieldHabitsAreRight) {
  EXPECT_TRUE(errors("AX LNAX HLAX VL1000AX VB100AX AC500AX RP").empty());
  EXPECT_TRUE(errors("AX MR500.9 GO # fractions are cut").empty());
  EXPECT_TRUE(errors("AY  VB100 AC5000 CA JG1000;").empty());
}

struct Wrong {
  const char* text;
  int line, column;
  const char* sentence;
};
TEST(Vme58Check, MistakesAreNamedWhereTheyStand) {
  const Wrong all[] = {
      {"AX\nMA100 XQ GO", 1, 6, "no command XQ"},
      {"AX ma100", 0, 3, "capital"},
      {"AX VL", 0, 3, "needs a number"},
      {"AX VL9999999", 0, 3, "out of range"},
      {"AX MA40000000 GO", 0, 3, "out of range"},
      {"AX MT100,200; GO", 0, 3, "only after AA or AM"},
      {"AA KP2", 0, 3, "while one axis is addressed"},
      {"AX WA", 0, 3, "only after AA"},
      {"AX LE", 0, 3, "no LS before it"},
      {"AX LS2 LS2 LS2 LS2 LS2 LE LE LE LE LE", 0, 19, "4 deep"},
      {"AA CD0,0,0; CR0,0,3.14 CE", 0, 12, "this contour has 3"},
      {"AA CD0,0; MT1,2,3 CE", 0, 10, "3 numbers are given here"},
      {"AX BL14", 0, 3, "out of range"},
      {"AX MR1-2 GO", 0, 6, "not a command"},
      {"AA CD0,0; CD0,0; CE", 0, 10, "while a contour is recorded: CE or CK ends it"},
      {"AX RM0", 0, 3, "divide by 0"},
      {"AX UU0", 0, 3, "multiply by 0"},
      {"AA UU2,0;", 0, 3, "multiply by 0"},
  };
  for (const Wrong& w : all) {
    const auto found = errors(w.text);
    ASSERT_FALSE(found.empty()) << w.text;
    EXPECT_EQ(found[0].line, w.line) << w.text;
    EXPECT_EQ(found[0].column, w.column) << w.text << ": " << found[0].sentence;
    EXPECT_THAT(found[0].sentence, HasSubstr(w.sentence)) << w.text;
  }
}

TEST(Vme58Check, AMissingModeIsReportedOnce) {
  const auto verbatim = errors(
      "CV1000\nCD,,0,0;\nAN0;\nCR0,5000,3.1415926\nCR0,0,6.2831853\nAF0;\nMT-10,10000\nCE\n"
      "MT,,-1000,0; GO\nCX\n");
  ASSERT_EQ(verbatim.size(), 1u) << "the rest follows from it";
  EXPECT_EQ(verbatim[0].line, 1);
  EXPECT_THAT(verbatim[0].sentence,
              HasSubstr("CD is accepted only after AA or AM. The text after it is read as if AA"));
  EXPECT_EQ(errors("AX MT1,2; GO KP2 HN").size(), 1u) << "right for one axis";
  const auto others = errors("AX MT1,2; GO XQ AY MT3,4; GO AA KP2");
  ASSERT_EQ(others.size(), 4u) << "what does not follow from it is said, and a new one after a new selection";
  EXPECT_THAT(others[1].sentence, HasSubstr("XQ"));
  EXPECT_THAT(others[2].sentence, HasSubstr("MT is accepted"));
  EXPECT_THAT(others[3].sentence, HasSubstr("while one axis"));
}

TEST(Vme58Check, EachAxisHasLoopsOfItsOwn) {
  EXPECT_TRUE(errors("AX LS2 AY LS2 AZ LS2 AT LS2 AU LS2 AX MR5 GO LE AY MR5 GO LE AZ MR5 GO LE "
                     "AT MR5 GO LE AU MR5 GO LE")
                  .empty());
  EXPECT_TRUE(errors("AX LS2 AY WS0 AX MR5 GO LE AY MR5 GO WD AA LS2 AM LS2 AA LE AM LE").empty());
  EXPECT_THAT(errors("AX LS2 AY MR5 GO LE").at(1).sentence, HasSubstr("LE has no LS"));
  EXPECT_EQ(errors("AX LS2 AY LS2 LE").at(0).column, 3) << "the loop of X has no end";
  EXPECT_TRUE(errors("AX LS2 MR5 GO ST AY WS0 KL").empty()) << "what was flushed needs no end";
  EXPECT_EQ(check_program("AX MR5 AY GO").problems.size(), 1u) << "nothing was prepared for Y";
}

TEST(Vme58Check, ATabIsASpace) {
  EXPECT_TRUE(errors("AX\tMR\t100\tGO\t# a\tremark").empty());
  EXPECT_EQ(errors("AX\tXQ").at(0).column, 3);
}

TEST(Vme58Check, AGoWithoutAPreparedMoveIsAWarning) {
  const auto report = check_program("AX GO");
  EXPECT_FALSE(report.has_errors());
  ASSERT_EQ(report.problems.size(), 1u);
  EXPECT_THAT(report.problems[0].sentence, HasSubstr("No move has been prepared"));
}

std::string warning(std::string_view text) {
  const auto report = check_program(text);
  EXPECT_FALSE(report.has_errors()) << text;
  return report.problems.empty() ? "" : report.problems.back().sentence;
}
TEST(Vme58Check, ACommandThatTheBoardAltersOrRejectsIsAWarning) {
  EXPECT_EQ(warning("AX MR1.5 GO"), "1.5 is taken as 1: MR takes whole numbers unless UU is on.");
  EXPECT_EQ(warning("AX UU100 MR1.5 GO"), "");
  EXPECT_EQ(warning("AX WT2.5"), "2.5 is taken as 2: WT takes whole numbers.");
  EXPECT_EQ(warning("AX KP2.5"), "");
  EXPECT_EQ(warning("BH3"),
            "Line 3 is an input unless a jumper on the board makes it an output. The board rejects this "
            "command for an input.");
  EXPECT_EQ(warning("BH8 BL13"), "");
}

TEST(Vme58Text, TheContextFollowsTheText) {
  Context context;
  (void)read_commands("AZ MR5 GO", context);
  EXPECT_EQ(context.selector(), "AZ");
  (void)read_commands("AA CD0,,5;", context);
  EXPECT_TRUE(context.recording);
  EXPECT_EQ(context.contour_axes, 0b101u);
  (void)read_commands("CE", context);
  EXPECT_FALSE(context.recording);
  EXPECT_EQ(context.selector(), "AA");
  (void)read_commands("RS", context);
  EXPECT_EQ(context.selector(), "AX");
}

TEST(Vme58Text, UserUnitsTakeFractionsAndNoCountsRange) {
  EXPECT_TRUE(errors("AX UU1000 MA12.5 GO").empty());
  EXPECT_TRUE(errors("AX UU0.001 MA99999999 GO").empty());
}

}  // namespace
}  // namespace hw::vme58
