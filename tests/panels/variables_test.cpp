#include "panels/variables.h"

#include "tests/panels/full_catalog.h"
#include "tests/panels/panel_stage.h"

namespace hw::panels {
namespace {

using ::testing::HasSubstr;

struct VariablesTest : ::testing::Test {
  VariablesTest() {
    s.now.axis_count = 4;
    s.now.variables_known.set();
    s.now.variables[53] = -3200;
    s.stage.frames(2);
  }
  Variables panel;
  test::PanelStage s{panel, 864, 1200, 1, gui::Tier::wide, true, test::full_catalog()};
};

TEST_F(VariablesTest, ValuesAreLiveAndWatched) {
  EXPECT_EQ(s.value("var/53"), "-3200");
  s.now.variables[53] = 7;
  s.stage.frames(2);
  EXPECT_EQ(s.value("var/53"), "7");
  ASSERT_TRUE(s.last<intent::Watch>());
  EXPECT_EQ(s.last<intent::Watch>()->groups, 1u << 3);
}

TEST_F(VariablesTest, ATypedValueIsSent) {
  s.type("var/12", "440\n");
  ASSERT_TRUE(s.last<intent::SetVariable>());
  EXPECT_EQ(s.last<intent::SetVariable>()->number, 12);
  EXPECT_EQ(s.last<intent::SetVariable>()->value, 440);
}

TEST_F(VariablesTest, ARefusalIsAWholeSentenceAndGoesWithTheNextValue) {
  s.type("var/12", "1.5\n");
  EXPECT_FALSE(s.last<intent::SetVariable>());
  EXPECT_EQ(s.toast(), "V12: Whole numbers only. Nothing was sent.");
  s.type("var/12", "7\n");
  EXPECT_EQ(s.toast(), "");
  s.type("var/12", "1.5\n");
  EXPECT_NE(s.toast(), "");
  s.type("var/command", "V12=8\n");
  EXPECT_EQ(s.toast(), "");
}

TEST_F(VariablesTest, TheLineTakesThemAsTheMakerWritesThem) {
  s.type("var/command", "V53=-25\n");
  ASSERT_TRUE(s.last<intent::SetVariable>());
  EXPECT_EQ(s.last<intent::SetVariable>()->number, 53);
  EXPECT_EQ(s.last<intent::SetVariable>()->value, -25);
  s.type("var/command", "v[7] = 9");
  s.click("var/set");
  EXPECT_EQ(s.last<intent::SetVariable>()->number, 7);
}

TEST_F(VariablesTest, AnInvalidCommandSendsNothing) {
  const std::size_t sent = s.sent.size();
  s.type("var/command", "V100=1\n");
  EXPECT_EQ(s.sent.size(), sent);
  EXPECT_THAT(s.toast(), HasSubstr("The variables are V0 to V99."));
  EXPECT_EQ(s.value("var/command"), "V100=1") << "what was typed stays";
}

TEST(Assignment, RangesAndForms) {
  const VariableFacts facts = test::full_catalog().variables;
  EXPECT_TRUE(parse_assignment("99=0", facts));
  EXPECT_FALSE(parse_assignment("V5", facts));
  EXPECT_FALSE(parse_assignment("V5=1.5", facts));
  EXPECT_FALSE(parse_assignment("V-1=1", facts));
  EXPECT_FALSE(parse_assignment("V5=3000000000", facts));
}

}  // namespace
}  // namespace hw::panels
