#include "core/devices/arcus/program_language.h"

#include <gtest/gtest.h>

namespace hw::arcus {
namespace {

TEST(ArcusProgramReport, ReportsCostsLinesAndColours) {
  const ProgramReport report =
      analyse_program("; go\nX10Y20 ; there\n\nIF DI1=1\nV1=2\nENDIF\nEND\n", language::pmx_4ex_sa());
  EXPECT_FALSE(report.has_errors());
  EXPECT_EQ(report.cost.at(0), 7);
  ASSERT_EQ(report.listing.at(0).size(), 7U);
  EXPECT_EQ(report.listing.at(0)[1], "+MOVE,Y,20");
  ASSERT_EQ(report.lines.size(), 8U);
  EXPECT_EQ(report.lines[0].cost, 0);
  EXPECT_EQ(report.lines[0].first_command, -1);
  EXPECT_EQ(report.lines[1].cost, 2);
  EXPECT_EQ(report.lines[1].first_command, 0);
  EXPECT_EQ(report.lines[3].first_command, 2);
  EXPECT_EQ(report.lines[3].command_count, 2);
  EXPECT_EQ(report.lines[3].slot, 0);
  ASSERT_EQ(report.lines[1].tokens.size(), 2U);
  EXPECT_EQ(report.lines[1].tokens[0].kind, TokenKind::moves);
  EXPECT_EQ(report.lines[1].tokens[0].end, 6);
  EXPECT_EQ(report.lines[1].tokens[1].kind, TokenKind::comment);
  EXPECT_EQ(report.lines[1].tokens[1].begin, 7);
  EXPECT_EQ(report.lines[3].tokens[0].kind, TokenKind::flow);
  EXPECT_EQ(report.lines[3].tokens[0].end, 2);
  EXPECT_EQ(report.lines[4].tokens[0].kind, TokenKind::plain);
}

TEST(ArcusProgramReport, CountsOnBeyondTheMemory) {
  std::string text;
  for (int i = 0; i < 1300; ++i) text += "ABS\n";
  const ProgramReport report = analyse_program(text + "END\n", language::dmx_k_sa());
  EXPECT_TRUE(report.has_errors());
  EXPECT_EQ(report.cost.at(0), 1301);
}

TEST(ArcusProgramReport, FixesMendTheLine) {
  const ProgramReport report = analyse_program("  HOME+\nX100\n", language::dmx_k_sa());
  ASSERT_EQ(report.problems.size(), 2U);
  const Problem& axis = report.problems[0];
  EXPECT_EQ(axis.fix_text, "HOMEX");
  EXPECT_EQ(std::string("  HOME+").replace(axis.column, axis.length, axis.fix_text), "  HOMEX+");
  const Problem& end = report.problems[1];
  EXPECT_EQ(end.line, 1);
  EXPECT_EQ(std::string("X100").replace(end.column, end.length, end.fix_text), "X100\nEND");
}

TEST(ArcusProgramReport, NothingTypedYetIsNoMistake) {
  const ProgramReport report = analyse_program("", language::pmx_4ex_sa());
  EXPECT_TRUE(report.problems.empty());
  EXPECT_EQ(report.cost.at(0), 0);
}

}  // namespace
}  // namespace hw::arcus
