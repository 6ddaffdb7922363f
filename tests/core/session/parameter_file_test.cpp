#include "core/session/parameter_file.h"

#include <gmock/gmock.h>

#include "tests/core/session/folder.h"

namespace hw {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

Catalog catalog() {
  Catalog c;
  c.model = "toy";
  c.name = "Toy Controller";
  c.program.slots = 2;
  c.program.slot_word = "program";
  ParamInfo jog;
  jog.mnemonic = "j1M", jog.label = "Jog speed", jog.unit = "steps/s", jog.group = "Jog";
  jog.minimum = 1, jog.maximum = 6000;
  ParamInfo odd = jog;
  odd.mnemonic = "B!", odd.group = "Odd", odd.unit = "", odd.minimum = 10, odd.also_zero = true;
  ParamInfo choice = jog;
  choice.mnemonic = "M1", choice.group = "Motor", choice.choices = {{0, "none"}, {4, "big"}};
  c.params = {jog, odd, choice};
  return c;
}

TEST(ParameterFile, ComesBackAsWritten) {
  Backup b;
  b.model = "toy";
  b.name = "Stage \"A\"";
  b.saved_at = "2026-05-04 14:02:04";
  b.parameters = {{"j1M", 100, 0}, {"B!", -3, 0}};
  b.programs = {{0, "I1M400\nL0\n"}, {1, "; a \\ \"quoted\" \"\"\" remark\t\n"}};
  const std::string text = write_backup(b, catalog());
  EXPECT_THAT(text, HasSubstr("# Toy Controller, saved 2026-05-04 14:02:04"));
  EXPECT_THAT(text, HasSubstr("j1M = 100        # Jog speed, steps/s"));
  const auto again = parse_backup(text, "a.toml");
  ASSERT_TRUE(again) << again.error().sentence();
  EXPECT_EQ(again->name, b.name);
  EXPECT_EQ(again->programs, b.programs);
  ASSERT_EQ(again->parameters.size(), 2u);
  EXPECT_EQ(again->parameters[0].mnemonic, "j1M");
  EXPECT_EQ(again->parameters[1].mnemonic, "B!");
  EXPECT_EQ(again->parameters[1].value, -3);
}

TEST(ParameterFile, UnsuitableValuesAreNamedWithTheirLine) {
  const auto file = parse_backup(
      "model = \"toy\"\n[parameters]\nj1M = 9000\nXY = 1\nM1 = 3\n\"B!\" = 0\n"
      "[programs]\n7 = \"I1M1\"\n",
      "stage.toml");
  ASSERT_TRUE(file);
  const auto checked = check_backup(*file, catalog(), "stage.toml");
  ASSERT_TRUE(checked);
  EXPECT_THAT(
      checked->problems,
      ElementsAre("stage.toml, line 3: j1M = 9000 is out of range, j1M takes 1 to 6000. It was left out.",
                  "stage.toml, line 4: XY is not a parameter of this controller. It was left out.",
                  "stage.toml, line 5: M1 = 3 is out of range, M1 takes 0, 4. It was left out.",
                  "stage.toml: there is no program 7 in this controller. It was left out."));
  ASSERT_EQ(checked->parameters.size(), 1u);
  EXPECT_EQ(checked->parameters[0].mnemonic, "B!");
}

TEST(ParameterFile, FaultsNameTheLine) {
  const auto sentence = [](const char* text) {
    const auto file = parse_backup(text, "stage.toml");
    return file ? std::string("understood") : file.error().sentence();
  };
  EXPECT_THAT(sentence("model = \"toy\"\n[parameters]\nj1M = \n"), HasSubstr("stage.toml, line 3: "));
  EXPECT_THAT(sentence("model = \"toy\"\n[parameters]\nj1M = \"fast\"\n"),
              HasSubstr("stage.toml, line 3: j1M must be a whole number."));
  EXPECT_THAT(sentence("model = \"toy\"\nsped = 4\n"), HasSubstr("stage.toml, line 2: sped is not known."));
  EXPECT_THAT(sentence("[programs]\nfirst = \"I1M1\"\n"),
              HasSubstr("line 2: first must be the number of a program, with its text"));
  EXPECT_THAT(sentence("[parameters]\nj1M = 5\n"), HasSubstr("does not say for which controller"));
  EXPECT_THAT(sentence("\x89PNG"), HasSubstr("Nothing was loaded from the file."));
}

TEST(ParameterFile, OtherModelIsRefused) {
  Backup b;
  b.model = "other";
  const auto checked = check_backup(b, catalog(), "x.toml");
  ASSERT_FALSE(checked);
  EXPECT_THAT(checked.error().sentence(),
              HasSubstr("x.toml is for a controller \"other\", this one is \"toy\"."));
}

TEST(ParameterFile, AValueWithDecimalsIsReportedAsPartsOfItsUnit) {
  Catalog c = catalog();
  c.params[0].decimals = 3;
  Backup b;
  b.model = "toy";
  b.parameters.push_back({c.params[0].mnemonic, 800, 0});
  EXPECT_THAT(write_backup(b, c), HasSubstr(", in thousandths\n"));
  c.params[0].decimals = 2;
  EXPECT_THAT(write_backup(b, c), HasSubstr(", in hundredths\n"));
}

TEST(ParameterFile, AUnitThatFollowsALoopIsNamedBothWays) {
  Catalog c = catalog();
  c.loop_word = "counts";
  c.params[0].follows_loop = true;
  Backup b;
  b.model = "toy";
  b.parameters = {{"j1M", 100, 0}};
  EXPECT_THAT(write_backup(b, c), HasSubstr("# Jog speed, steps/s (closed loop: counts/s)\n"));
}

TEST(ParameterFile, DiskFullIsReported) {
  Backup b;
  b.model = "toy";
  const auto saved = save_backup("/dev/full", b, catalog());
  ASSERT_FALSE(saved);
  EXPECT_THAT(saved.error().sentence(), HasSubstr("the disk is full"));
}

TEST(ParameterFile, RangesInWords) {
  const Catalog c = catalog();
  EXPECT_EQ(range_of(c.params[0]), "1 to 6000");
  EXPECT_EQ(range_of(c.params[1]), "0 or 10 to 6000");
  EXPECT_EQ(range_of(c.params[2]), "0, 4");
}

}  // namespace
}  // namespace hw
