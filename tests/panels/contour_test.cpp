// Contours and staircases: what is typed is drawn, checked, written by the controller's language and run.
#include "panels/contour/contour.h"

#include "core/sequence/sequence_file.h"
#include "core/session/user_files.h"
#include "tests/core/session/folder.h"
#include "tests/panels/panel_stage.h"
#include "tests/panels/window_catalog.h"

namespace hw::panels {
namespace {

using ::testing::HasSubstr;

struct ContourTest : ::testing::Test {
  ContourTest() {
    s.now.axis_count = 3;
    for (AxisState& a : s.now.axes) a.position_known = true, a.activity = Activity::idle;
    s.stage.frames(2);
  }
  void line(int row, const char* x, const char* y) {
    s.click("contour/add/line");
    s.type(("contour/" + std::to_string(row) + "/x").c_str(), x);
    s.type(("contour/" + std::to_string(row) + "/y").c_str(), y);
  }
  Contour panel;
  test::WindowLanguage language;
  test::PanelStage s{panel, 864, 620, 1, gui::Tier::wide, true, test::window_catalog(), &language};
};

TEST_F(ContourTest, PiecesBecomeTheControllersText) {
  EXPECT_THAT(s.value("contour/problem"), HasSubstr("no line and no arc"));
  EXPECT_THAT(s.reason("contour/run"), HasSubstr("no line and no arc"));
  line(1, "1000", "0");
  s.click("contour/add/output");
  s.click("contour/add/arc");
  s.type("contour/3/x", "1000");
  s.type("contour/3/y", "500");
  s.type("contour/3/angle", "180");
  EXPECT_EQ(s.value("contour/text"), "contour X Y at 1000\nline 1000 0\nAux X on\narc 1000 500 180\n");
  EXPECT_EQ(s.value("contour/view"), "2571 counts long, 2.6 s at this speed") << "1000 + 500 pi";
}

TEST_F(ContourTest, ItIsLoadedAndThenStarted) {
  line(1, "1000", "0");
  s.click("contour/run");
  ASSERT_TRUE(s.last<intent::LoadProgram>());
  EXPECT_EQ(s.last<intent::LoadProgram>()->text, "contour X Y at 1000\nline 1000 0\n");
  EXPECT_FALSE(s.last<intent::RunProgram>());
  s.settle(IntentState::done);
  EXPECT_TRUE(s.last<intent::RunProgram>());
}

TEST_F(ContourTest, ARefusedTextIsNotStarted) {
  line(1, "1000", "0");
  s.click("contour/run");
  s.settle(IntentState::refused, "Line 1: no.");
  EXPECT_FALSE(s.last<intent::RunProgram>());
  EXPECT_EQ(s.toast(), "Line 1: no.");
}

TEST_F(ContourTest, APieceThatCannotBeDrawnIsNamedByItsRowAndNotRun) {
  line(1, "1000", "0");
  s.click("contour/add/arc");
  s.type("contour/2/x", "1000");
  EXPECT_THAT(s.value("contour/problem"), HasSubstr("Piece 2 (arc): the centre of the arc is the point"));
  EXPECT_THAT(s.reason("contour/run"), HasSubstr("Piece 2"));
  s.type("contour/2/x", "2000");
  EXPECT_FALSE(s.stage.find("contour/problem"));
  s.click("contour/second");
  s.click("contour/second/X");
  EXPECT_THAT(s.value("contour/problem"), HasSubstr("two different axes"));
}

TEST_F(ContourTest, ARowCanGo) {
  line(1, "1000", "0");
  line(2, "1000", "700");
  s.click("contour/1/remove");
  EXPECT_EQ(s.value("contour/text"), "contour X Y at 1000\nline 1000 700\n");
}

TEST_F(ContourTest, AStaircaseHasToGoOneWay) {
  s.click("contour/kind/Staircase");
  s.click("stairs/add");
  s.type("stairs/1/until", "2000");
  s.type("stairs/1/speed", "500");
  s.click("stairs/add");
  EXPECT_EQ(s.value("contour/text"), "stairs of X 2000 at 500 3000 at 500 stop 10000\n");
  s.type("stairs/2/until", "1500");
  EXPECT_THAT(s.value("contour/problem"), HasSubstr("Stair 2: 1500 does not lie on the way from 2000"));
  s.type("stairs/2/until", "20000");
  EXPECT_THAT(s.value("contour/problem"),
              HasSubstr("The last stair ends at 20000, past the stop position 10000"));
}

TEST_F(ContourTest, ItGoesIntoTheEditorAndAsksBeforeItReplaces) {
  line(1, "1000", "0");
  s.click("contour/to_program");
  EXPECT_EQ(s.tab.desk().programs.texts.text(0), "contour X Y at 1000\nline 1000 0\n");
  s.type("contour/1/x", "2000");
  s.click("contour/to_program");
  s.click("contour/replace/no");
  EXPECT_EQ(s.tab.desk().programs.texts.text(0), "contour X Y at 1000\nline 1000 0\n");
  s.click("contour/to_program");
  s.click("contour/replace/yes");
  EXPECT_EQ(s.tab.desk().programs.texts.text(0), "contour X Y at 1000\nline 2000 0\n");
}

Catalog window_in_mm() {
  Catalog c = test::window_catalog();
  c.units = {{"screw", "mm", 0.0025, 4}, {"other screw", "mm", 0.005, 3}};
  return c;
}

struct ContourUnitsTest : ::testing::Test {
  ContourUnitsTest() {
    s.now.axis_count = 3;
    for (AxisState& a : s.now.axes) a.position_known = true, a.activity = Activity::idle;
    show("screw", "screw");
  }
  void show(const char* x, const char* others) {
    s.tab.settings.profile.unit = "real";
    for (AxisProfile& axis : s.tab.settings.profile.axes) axis.unit_choice = others;
    s.tab.settings.profile.axes[0].unit_choice = x;
    s.tab.settings.edited();
    s.stage.frames(4);
  }
  void open(const std::filesystem::path& path) {
    s.click("contour/open");
    s.type("file/path", path.c_str());
    s.click("file/open");
    s.stage.frames(4);
  }
  Contour panel;
  test::WindowLanguage language;
  test::PanelStage s{panel, 864, 620, 1, gui::Tier::wide, true, window_in_mm(), &language};
  test::Folder folder;
};

TEST_F(ContourUnitsTest, ValuesTypedInTheAxisUnitAreWrittenInSteps) {
  s.type("contour/speed", "5");
  s.click("contour/add/line");
  s.type("contour/1/x", "2.5");
  EXPECT_EQ(s.value("contour/text"), "contour X Y at 2000\nline 1000 0\n");
  EXPECT_EQ(s.value("contour/view"), "2.5000 mm long, 0.5 s at this speed");
  s.tab.settings.profile.unit.clear();
  s.tab.settings.edited();
  s.stage.frames(4);
  EXPECT_EQ(s.value("contour/1/x"), "1000");
  EXPECT_EQ(s.value("contour/text"), "contour X Y at 2000\nline 1000 0\n");
}

TEST_F(ContourUnitsTest, AxesThatShareNoUnitAreTypedInSteps) {
  s.click("contour/add/line");
  s.type("contour/1/x", "2.5");
  show("screw", "other screw");
  EXPECT_EQ(s.value("contour/1/x"), "1000");
}

TEST_F(ContourUnitsTest, AStaircaseIsTypedInTheUnitOfItsAxis) {
  s.click("contour/kind/Staircase");
  s.click("stairs/add");
  s.type("stairs/1/until", "5");
  s.type("stairs/1/speed", "1.25");
  EXPECT_EQ(s.value("contour/text"), "stairs of X 2000 at 500 stop 10000\n");
}

TEST_F(ContourUnitsTest, AStaircaseErrorIsReportedInTheUnitOfTheAxes) {
  s.click("contour/kind/Staircase");
  s.type("stairs/stop", "25");
  s.click("stairs/add");
  s.type("stairs/1/until", "5");
  s.click("stairs/add");
  s.type("stairs/2/until", "3.75");
  EXPECT_THAT(s.value("contour/problem"), HasSubstr("Stair 2: 3.75 does not lie on the way from 5 to 25"));
}

TEST_F(ContourUnitsTest, AFileIsASequenceInTheSameUnitAndComesBackAsItWas) {
  s.click("contour/add/line");
  s.type("contour/1/x", "2.5");
  s.click("contour/add/output");
  s.click("contour/add/arc");
  s.type("contour/3/x", "2.5");
  s.type("contour/3/y", "1.25");
  const std::string text(s.value("contour/text"));
  EXPECT_FALSE(panel.unkept().empty());
  s.click("contour/save");
  s.type("file/path", (folder.path() / "part.toml").c_str());
  s.click("file/save");
  s.stage.frames(3);
  EXPECT_TRUE(panel.unkept().empty());
  const auto kept = read_file(folder.path() / "part.toml", 1u << 20);
  ASSERT_TRUE(kept);
  const auto sequence = sequence::read_sequence(*kept, "part.toml");
  ASSERT_TRUE(sequence);
  EXPECT_EQ(sequence->unit, "mm");
  EXPECT_DOUBLE_EQ(sequence->axes[0].per_unit, 400);
  Contour fresh;
  test::PanelStage other{fresh, 864, 620, 1, gui::Tier::wide, true, window_in_mm(), &language};
  other.stage.frames(2);
  other.click("contour/open");
  other.type("file/path", (folder.path() / "part.toml").c_str());
  other.click("file/open");
  other.stage.frames(4);
  EXPECT_EQ(other.value("contour/text"), text) << "also where counts are shown";
}

TEST_F(ContourUnitsTest, OneThatLeadsPastALimitCanBeShiftedInside) {
  Travel& travel = s.now.axes[0].travel;
  travel.has_minus = travel.has_plus = true, travel.minus = Steps(-4000), travel.plus = Steps(4000);
  s.click("contour/add/line");
  s.type("contour/1/x", "12.5");
  s.click("contour/run");
  s.settle(IntentState::done);
  ASSERT_TRUE(s.last<intent::RunProgram>());
  s.settle(IntentState::refused, "5000 counts lies past it.",
           PastTravel{AxisId{0}, Sign::plus, Steps(5000), Steps(4000)});
  EXPECT_THAT(s.value("contour/refused"), HasSubstr("12.5000 mm lies 2.5000 mm past the + limit of axis"));
  s.click("contour/nearest");
  EXPECT_EQ(s.value("contour/text"), "contour X Y at 1000\nline 4000 0\n") << "and it begins at -1000";
  EXPECT_EQ(s.value("contour/x"), "-2.5000");
  EXPECT_FALSE(s.stage.find("contour/refused"));
}

TEST_F(ContourUnitsTest, TheRefusalOfAListThatWasEditedMeanwhileOffersNothing) {
  Travel& travel = s.now.axes[0].travel;
  travel.has_minus = travel.has_plus = true, travel.minus = Steps(-4000), travel.plus = Steps(4000);
  s.click("contour/add/line");
  s.type("contour/1/x", "12.5");
  s.click("contour/run");
  s.settle(IntentState::done);
  ASSERT_TRUE(s.last<intent::RunProgram>());
  s.type("contour/1/x", "11.5");
  s.settle(IntentState::refused, "5000 counts lies past it.",
           PastTravel{AxisId{0}, Sign::plus, Steps(5000), Steps(4000)});
  EXPECT_FALSE(s.stage.find("contour/refused"));
  EXPECT_THAT(s.toast(), HasSubstr("past the + limit of axis")) << "it is not lost";
}

TEST_F(ContourUnitsTest, TheShiftIsOfferedInTheUnitInWhichTheListIsTyped) {
  show("screw", "other screw");
  Travel& travel = s.now.axes[0].travel;
  travel.has_minus = travel.has_plus = true, travel.minus = Steps(-4000), travel.plus = Steps(4000);
  s.click("contour/add/line");
  s.type("contour/1/x", "5000");
  s.click("contour/run");
  s.settle(IntentState::done);
  s.settle(IntentState::refused, "5000 counts lies past it.",
           PastTravel{AxisId{0}, Sign::plus, Steps(5000), Steps(4000)});
  ASSERT_TRUE(s.stage.find("contour/nearest"));
  EXPECT_THAT(std::string(s.stage.find("contour/nearest")->label), HasSubstr("1000 "));
}

TEST_F(ContourUnitsTest, AFileOfAxesThatCountAgainstTheirStepsComesBackToo) {
  for (AxisProfile& axis : s.tab.settings.profile.axes) axis.reversed = true;
  s.tab.settings.edited();
  s.stage.frames(2);
  s.click("contour/add/line");
  s.type("contour/1/x", "2.5");
  const std::string text(s.value("contour/text"));
  EXPECT_THAT(text, HasSubstr("line -1000 0"));
  s.click("contour/save");
  s.type("file/path", (folder.path() / "part.toml").c_str());
  s.click("file/save");
  s.stage.frames(3);
  s.type("contour/1/x", "5");
  open(folder.path() / "part.toml");
  EXPECT_EQ(s.value("contour/text"), text);
}

TEST_F(ContourUnitsTest, AFileThatDoesMoreIsRefusedAndNothingIsLost) {
  s.click("contour/add/line");
  s.type("contour/1/x", "2.5");
  const std::string text(s.value("contour/text"));
  sequence::Sequence more;
  more.axes = {{"X"}, {"Y"}};
  more.steps = {{sequence::Delay{100}}};
  ASSERT_TRUE(write_file(folder.path() / "more.toml", sequence::write_sequence(more)));
  open(folder.path() / "more.toml");
  EXPECT_THAT(s.toast(), HasSubstr("more.toml has no contour and no staircase. The list here is unchanged."));
  EXPECT_EQ(s.value("contour/text"), text);
}

}  // namespace
}  // namespace hw::panels
