// Low-level lines as they come from a controller: whole, damaged, or somebody else's.
#include <gtest/gtest.h>

#include "core/devices/arcus/language/compiler.h"
#include "core/devices/arcus/language/decompiler.h"

namespace hw::arcus::language {
namespace {

std::string why(const std::vector<std::string>& lines, const Dialect& dialect = pmx_4ex_sa()) {
  std::string all;
  for (const BadLine& bad : decode(lines, dialect).bad_lines)
    all += std::to_string(bad.line) + " " + bad.why + "; ";
  return all;
}

TEST(LowLevel, UnusedLinesAtTheEndDoNotCount) {
  std::vector<std::string> lines{"SET,V1,1", "END"};
  lines.resize(program_lines);
  const Program program = decode(lines, pmx_4ex_sa());
  EXPECT_EQ(program.code.size(), 2U);
  EXPECT_EQ(decompile(lines, pmx_4ex_sa()).text, "V1=1\nEND\n");
}

TEST(LowLevel, OperandsThatDoNotExist) {
  for (const char* line : {"SET,V100,1",
                           "SET,V-1,1",
                           "SET,V01,5",
                           "SET,V1,007",
                           "SET,V1,+5",
                           "SET,V1,-0",
                           "GOSUB,01",
                           "SET,DI1,1",
                           "SET,DO9,1",
                           "SET,HSPD,PX",
                           "SET,HSPD",
                           "SET,HSPD,1,2",
                           "SET,5,1",
                           "READ",
                           "WAIT,Q",
                           "WAIT,XY",
                           "JOG,X",
                           "JOG,X,*",
                           "GOSUB,32",
                           "GOSUB,-1",
                           "PRG,4",
                           "SR,4,1",
                           "SR,0,4",
                           "DELAY,0",
                           "ABS,1",
                           "MOVE,X,PX",
                           "set,V1,1",
                           "SET,V1,1 ",
                           " SET,V1,1",
                           "SET, V1,1",
                           "SET,V1,99999999999",
                           "=",
                           "+PUT,V1",
                           ",",
                           "SET,V1,000000000000000000000000000000000000000000000000000000000000000000001"})
    EXPECT_EQ(why({line, "END"}), "0 means nothing; ") << line;
}

TEST(LowLevel, StatementsThatAreCutOff) {
  EXPECT_EQ(why({"READ,V1"}), "0 means nothing; ");
  EXPECT_EQ(why({"READ,V1", "END"}), "0 means nothing; ");
  EXPECT_EQ(why({"ARCP", "+X,0", "+Y,0"}), "0 means nothing; 1 means nothing; 2 means nothing; ");
  EXPECT_EQ(why({"MOVE,Y,1", "+MOVE,X,1"}), "0 means nothing; 1 means nothing; ");
  EXPECT_EQ(why({"MOVE,X,1", "+MOVE,Y,1", "+MOVE,Z,1", "+MOVE,U,1", "END"}), "");
}

TEST(LowLevel, BlocksHaveToNameTheirOwnLines) {
  EXPECT_EQ(why({"WHILE,3", "+TEST,1,EQ,1,4", "ABS", "ENDWHILE,0", "END"}), "");
  EXPECT_EQ(why({"WHILE,3", "+TEST,1,EQ,1,2", "ABS", "ENDWHILE,0", "END"}),
            "0 names other lines than its block has; ");
  EXPECT_EQ(why({"IF,3", "+TEST,1,EQ,1,3", "ABS", "END"}), "0 belongs to no complete block; ");
  EXPECT_EQ(why({"ENDIF", "END"}), "0 belongs to no complete block; ");
  EXPECT_EQ(why({"WHILE,3", "+TEST,1,EQ,1,4", "END", "ENDWHILE,0"}),
            "0 belongs to no complete block; 3 belongs to no complete block; ");
}

TEST(LowLevel, ASecondProgramOfTheSameNumberIsNone) {
  EXPECT_EQ(why({"PRG,0", "END", "PRG,0", "END"}), "2 repeats a number that is taken; ");
  EXPECT_EQ(why({"ABS", "END", "SUB,1", "ENDSUB", "SUB,1", "ENDSUB"}), "4 repeats a number that is taken; ");
}

TEST(LowLevel, EachModelHasItsOwnWords) {
  EXPECT_EQ(why({"MOVE,Y,1", "END"}, dmx_k_sa()), "0 means nothing; ");
  EXPECT_EQ(why({"STOP", "END"}, dmx_k_sa()), "0 means nothing; ");
  EXPECT_EQ(why({"STOP", "END"}, pmx_4ex_sa()), "");
  EXPECT_EQ(why({"SET,LTX,1", "END"}, pmx_4ex_sa()), "0 means nothing; ");
  EXPECT_EQ(why({"SET,LTX,1", "END"}, dmx_k_sa()), "");
  EXPECT_EQ(why({"CIRP", "+X,1", "+Y,1", "END"}, dmx_k_sa()),
            "0 means nothing; 1 means nothing; 2 means nothing; ");
}

TEST(LowLevel, AForeignProgramIsShownAsItCame) {
  const Decompiled shown = decompile({"A1 03 FF", "SET,V1,1", "", "\x01\x02"}, pmx_4ex_sa());
  EXPECT_EQ(shown.text, ";? A1 03 FF\nV1=1\n;? (unused)\n;? ??\n");
  EXPECT_EQ(shown.bad_lines.size(), 2U);
}

TEST(LowLevel, IsReadableAsAPersonWouldWriteIt) {
  const Compilation compiled = compile(
      "PRG 0\nwhile v1<10\nif di1=1\nx1000 yv1\nelse\nhomex-\nendif\nv1=v1+1\nendwhile\nend\nsub "
      "3\nsr0=0\nendsub",
      pmx_4ex_sa());
  EXPECT_EQ(decompile(compiled.lines, pmx_4ex_sa()).text,
            "PRG 0\nWHILE V1<10\n  IF DI1=1\n    X1000YV1\n  ELSE\n    HOMEX-\n  ENDIF\n  "
            "V1=V1+1\nENDWHILE\nEND\n\nSUB 3\n"
            "SR0=0\nENDSUB\n");
}

}  // namespace
}  // namespace hw::arcus::language
