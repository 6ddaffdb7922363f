// What is chosen for a drawing: layers, the table, speeds; fields that hold no number; what is kept of it.
#include "tests/core/session/folder.h"
#include "tests/panels/console_stage.h"
#include "tests/panels/drawing_stage.h"
#include "tests/panels/must.h"

namespace hw::panels {
namespace {

using ::testing::HasSubstr;

/// A line on each of three layers, two of which the file hides.
constexpr std::string_view hidden_layers_text =
    "0\nSECTION\n2\nHEADER\n9\n$"
    "INSUNITS\n70\n4\n0\nENDSEC\n0\nSECTION\n2\nTABLES\n0\nTABLE\n2\nLAYER\n70\n4\n"
    "0\nLAYER\n2\ncut\n70\n0\n62\n7\n6\nCONTINUOUS\n0\nLAYER\n2\nice\n70\n1\n62\n7\n6\nCONTINUOUS\n"
    "0\nLAYER\n2\ndark\n70\n0\n62\n-7\n6\nCONTINUOUS\n0\nLAYER\n2\nnothing\n70\n0\n62\n7\n6\nCONTINUOUS\n"
    "0\nENDTAB\n0\nENDSEC\n0\nSECTION\n2\nENTITIES\n"
    "0\nLINE\n8\ncut\n10\n0\n20\n0\n11\n10\n21\n0\n"
    "0\nLINE\n8\nice\n10\n0\n20\n5\n11\n20\n21\n5\n"
    "0\nLINE\n8\ndark\n10\n0\n20\n9\n11\n40\n21\n9\n"
    "0\nENDSEC\n0\nEOF\n";

TEST_F(DrawingTabTest, ALayerThatTheFileHidesIsNamedSoAndDrawnWhenItIsChosen) {
  ASSERT_TRUE(write_file(file, hidden_layers_text));
  drop();
  EXPECT_EQ(s.value("drawing/drawn"), "10.0 mm");
  EXPECT_EQ(s.value("drawing/layer/cut"), "1, drawn");
  EXPECT_EQ(s.value("drawing/layer/ice"), "1, frozen");
  EXPECT_EQ(s.value("drawing/layer/dark"), "1, off");
  EXPECT_FALSE(s.stage.find("drawing/layer/nothing")) << "there is nothing on it";
  s.click("drawing/layer/ice");
  s.stage.frames(6);
  EXPECT_EQ(s.value("drawing/layer/ice"), "1, drawn");
  EXPECT_EQ(s.value("drawing/drawn"), "30.0 mm");
  s.click("drawing/layer/dark");
  s.click("drawing/layer/ice");
  s.stage.frames(6);
  EXPECT_EQ(s.value("drawing/drawn"), "50.0 mm");
  EXPECT_EQ(s.value("drawing/layer/ice"), "1, frozen");
}

TEST_F(DrawingTabTest, WithoutAnyLayerNothingIsDrawn) {
  drop();
  s.click("drawing/layer/cut");
  s.click("drawing/layer/holes");
  s.stage.frames(6);
  EXPECT_THAT(s.reason("drawing/cut"), HasSubstr("Choose a layer with lines on it"));
  s.click("drawing/layer/holes");
  s.stage.frames(6);
  EXPECT_EQ(s.value("drawing/drawn"), "12.6 mm");
}

TEST_F(DrawingTabTest, NothingIsCutWhileAFieldHoldsNoNumber) {
  drop();
  for (const char* field : {"drawing/per_unit/X", "drawing/tolerance", "drawing/cut_speed"}) {
    s.type(field, "abc\n");
    s.stage.frames(6);
    for (const char* id : {"drawing/cut", "drawing/to_program", "drawing/to_blocks", "drawing/frame"})
      EXPECT_THAT(s.reason(id), HasSubstr(": this is not a number.")) << field << ", " << id;
    s.type(field, "10\n");
    s.stage.frames(6);
    EXPECT_EQ(s.reason("drawing/cut"), "") << field;
  }
  s.type("drawing/tolerance", "-1\n");
  s.stage.frames(6);
  EXPECT_THAT(s.reason("drawing/cut"), HasSubstr("Tolerance: 0 to"));
}

TEST_F(DrawingTabTest, ATableThatIsNotFullyDescribedIsNotCheckedAndThisIsShown) {
  drop();
  EXPECT_FALSE(s.stage.find("drawing/table/unchecked"));
  s.type("drawing/table/left", "25\n");
  EXPECT_THAT(s.value("drawing/table/unchecked"), HasSubstr("Enter a \"to X\" above \"from X\""));
  s.type("drawing/table/right", "100\n");
  EXPECT_THAT(s.value("drawing/table/unchecked"), HasSubstr("Enter a \"to Y\" above \"from Y\""));
  s.type("drawing/table/top", "100\n");
  s.stage.frames(6);
  EXPECT_FALSE(s.stage.find("drawing/table/unchecked"));
  EXPECT_EQ(s.value("drawing/off"), "2 of 2 chains leave the table.");
}

TEST_F(DrawingTabTest, RampsAreChosenLikeSpeeds) {
  drop();
  two_hundred_pulses_in_a_mm();
  s.type("drawing/cut_speed", "10\n");
  s.type("drawing/low_speed", "2\n");
  s.type("drawing/ramp", "150\n");
  s.stage.frames(6);
  s.click("drawing/to_program");
  const std::string& text = s.tab.desk().programs.texts.text(0);
  for (const char* part : {"HSPD=2000", "LSPD=400", "ACC=150"}) EXPECT_THAT(text, HasSubstr(part));
}

TEST_F(DrawingTabTest, ThePointerIsShownInMillimetresOfTheTable) {
  drop();
  two_hundred_pulses_in_a_mm();
  s.stage.frames(6);
  const gui::Rect view = s.stage.find("drawing/view")->rect;
  EXPECT_FALSE(s.stage.find("drawing/pointer"));
  s.stage.push(gui::InputEvent::mouse_move(view.centre().x, view.centre().y, s.stage.now_s));
  s.stage.frames(2);
  EXPECT_THAT(s.value("drawing/pointer"), HasSubstr(" mm"));
}

TEST_F(DrawingTabTest, ChosenOptionsStayWhenTheNextFileIsUnreadable) {
  drop();
  s.click("drawing/layer/holes");
  s.stage.frames(6);
  ASSERT_TRUE(write_file(file, "0\nSECTION\n2\nENTITIES\n"));
  drop();
  EXPECT_THAT(s.toast(), HasSubstr("is cut off"));
  EXPECT_EQ(s.value("drawing/layer/holes"), "1, left out");
  EXPECT_EQ(s.value("drawing/drawn"), "30.0 mm");
}

TEST_F(DrawingTabTest, AFileThatFallsTwiceIsReadOnceAndNothingIsReportedOfIt) {
  s.tab.desk().dropped["drawing"].push_back(file);
  drop();
  EXPECT_EQ(s.toast(), "");
  EXPECT_EQ(s.value("drawing/size"), "20.000 x 10.000 mm");
}

/// Something that has a drawing read, between two of its frames.
struct ReadingPanel : gui::Panel {
  DrawingJob job;
  std::function<void(gui::Frame&)> next;
  void draw(gui::Frame& f) override {
    if (auto now = std::exchange(next, nullptr)) now(f);
  }
};

TEST(DrawingJobTest, AnOpenWhileTheFileOfBeforeIsReadAgainIsTaken) {
  const DeviceType& pmx = *find_device_type("pmx-4ex-sa");
  test::Folder folder;
  const auto first = folder.path() / "first.dxf", second = folder.path() / "second.dxf";
  ASSERT_TRUE(write_file(first, square_and_text));
  ASSERT_TRUE(write_file(second, hidden_layers_text));
  ReadingPanel panel;
  test::PanelStage s(panel, 864, 700, 1, gui::Tier::wide, true, *pmx.make_catalog({}), &pmx.language());
  ConversionOptions wanted;
  wanted.axes = {{"X", 100}, {"Y", 100}};
  const auto do_it = [&](std::function<void(gui::Frame&)> what) {
    panel.next = std::move(what);
    s.stage.frames(3);
  };
  const auto read_again_and_open = [&](const std::filesystem::path& file, double tolerance) {
    do_it([&, tolerance](gui::Frame& f) {
      wanted.tolerance = tolerance;
      panel.job.follow(f, wanted, panel.job.version() + 1, {1, 1});
      panel.job.open(f, file, wanted);
    });
  };
  do_it([&](gui::Frame& f) { panel.job.open(f, first, wanted); });
  ASSERT_EQ(panel.job.opened(), 1);
  read_again_and_open(first, 0.3);
  EXPECT_EQ(panel.job.opened(), 2) << "the same file";
  read_again_and_open(second, 0.2);
  EXPECT_EQ(panel.job.opened(), 3) << "another one";
  EXPECT_EQ(panel.job.file(), second);
  EXPECT_EQ(s.toast(), "");
  EXPECT_FALSE(panel.job.busy());
  read_again_and_open(folder.path() / "none.dxf", 0.1);
  EXPECT_NE(s.toast(), "");
  EXPECT_EQ(panel.job.file(), second);
  do_it([&](gui::Frame& f) {
    panel.job.follow(f, wanted, panel.job.version() + 1, {1, 1});
    EXPECT_EQ(panel.job.busy_with(), "reading the file") << "it was not read as it is wanted now";
  });
}

struct KeptOptionsTest : testing::Test {
  test::Folder folder;
  UserFolders folders = UserFolders::below(folder.path());
  bool millimetres = false;  ///< Z counts in them

  std::unique_ptr<ConsoleStage> console() const {
    const DeviceType& pmx = *find_device_type("pmx-4ex-sa");
    auto s = std::make_unique<ConsoleStage>(1440, 1400, 1.0f, true, folders);
    Catalog catalog = *pmx.make_catalog({});
    catalog.units = {{"screw", "mm", 0.0025, 4}};
    gui::Tab& tab = *s->add(std::move(catalog), &pmx.language()).tab;
    tab.settings.key = "pmx@usb";
    if (millimetres) {
      tab.settings.profile.unit = "real";
      tab.settings.profile.axes[2].unit_choice = "screw";
      tab.settings.edited();
    }
    s->run(0.1);
    EXPECT_TRUE(s->hand.click("tab/drawing").has_value());
    s->run(0.1);
    return s;
  }
};

TEST_F(DrawingTabTest, TheScaleIsTypedInTheFormThatTheMakerGives) {
  drop();
  two_hundred_pulses_in_a_mm();
  s.click("drawing/scale_as");
  s.click("drawing/scale_as/mm/pulse");
  s.stage.frames(6);
  EXPECT_EQ(s.value("drawing/per_unit/X"), "0.005");
  s.type("drawing/per_unit/X", "0.002");
  s.stage.frames(6);
  s.click("drawing/scale_as");
  s.click("drawing/scale_as/pulses/mm");
  s.stage.frames(6);
  EXPECT_EQ(s.value("drawing/per_unit/X"), "500.000");
  s.click("drawing/scale_as");
  s.click("drawing/scale_as/pulses/in");
  s.stage.frames(6);
  EXPECT_EQ(s.value("drawing/per_unit/X"), "12700.000");
  EXPECT_EQ(s.value("drawing/per_unit/Y"), "5080.000");
}

TEST_F(DrawingTabTest, AUnitThatIsChosenAtTheNumbersLaterGivesTheScale) {
  drop();
  s.tab.settings.profile.axes[0].unit_choice = own_unit_choice;
  s.tab.settings.profile.axes[0].own_unit = {"in", 0.0001};  // shown in steps now
  s.stage.frames(6);
  EXPECT_EQ(s.value("drawing/per_unit/X"), "393.701");
}

struct ToolAxisTest : DrawingTabTest {
  void choose_z() {
    drop();
    s.click("drawing/tool_axis");
    s.click("drawing/tool_axis/Z");
    s.type("drawing/tool_axis/per_unit", "200\n");
    s.type("drawing/tool_axis/down", "-2\n");
    s.type("drawing/tool_axis/up", "3\n");
    s.stage.frames(6);
  }
  void count_z_in_mm(bool reversed) {
    s.tab.settings.profile.axes[2].unit_choice = own_unit_choice;
    s.tab.settings.profile.axes[2].own_unit = {"mm", 0.0025};  // shown in steps now
    s.tab.settings.profile.axes[2].reversed = reversed;
    s.stage.frames(6);
  }
  std::string program() {
    s.click("drawing/to_program");
    if (s.stage.find("drawing/replace_text/yes")) s.click("drawing/replace_text/yes");
    return s.tab.desk().programs.texts.text(0);
  }
};

TEST_F(ToolAxisTest, AUnitThatIsChosenLaterGivesItsScale) {
  choose_z();
  EXPECT_THAT(program(), testing::AllOf(HasSubstr("Z-400"), HasSubstr("Z600")));
  count_z_in_mm(false);
  EXPECT_EQ(s.value("drawing/tool_axis/per_unit"), "400.000");
  EXPECT_FALSE(s.stage.find("drawing/tool/turned"));
  EXPECT_THAT(program(), testing::AllOf(HasSubstr("Z-800"), HasSubstr("Z1200")));
}

TEST_F(ToolAxisTest, ThatCountsOppositeToItsPulsesGoesTheWayOfItsNumbers) {
  choose_z();
  count_z_in_mm(true);
  EXPECT_EQ(s.value("drawing/tool_axis/per_unit"), "400.000");
  EXPECT_EQ(s.value("drawing/tool/turned"), "Z counts opposite to its pulses: 1 mm here is at -400 pulses.");
  EXPECT_THAT(program(), testing::AllOf(HasSubstr("Z800"), HasSubstr("Z-1200")));
  s.click("drawing/own_routines");
  EXPECT_THAT(s.value("drawing/routine/on"), testing::StartsWith("Z to -2")) << "as it was typed";
  s.stage.frames(6);
  EXPECT_THAT(s.value("drawing/tool/turned"), HasSubstr("-400 pulses"));
  EXPECT_THAT(program(), testing::AllOf(HasSubstr("Z800"), HasSubstr("Z-1200")));
  s.type("drawing/routine/on", "Z to -1\n");
  s.stage.frames(6);
  EXPECT_THAT(program(), testing::AllOf(HasSubstr("Z400"), HasSubstr("Z-1200")));
  count_z_in_mm(false);
  EXPECT_FALSE(s.stage.find("drawing/tool/turned"));
  EXPECT_THAT(program(), testing::AllOf(HasSubstr("Z-400"), HasSubstr("Z1200")));
}

TEST_F(DrawingTabTest, ADrawingAxisThatCountsOppositeIsWarnedOfInStepsToo) {
  drop();
  s.tab.settings.profile.axes[0].unit_choice = own_unit_choice;
  s.tab.settings.profile.axes[0].own_unit = {"mm", 0.01};
  s.stage.frames(6);
  EXPECT_FALSE(s.stage.find("drawing/mirrored/X"));
  s.tab.settings.profile.axes[0].reversed = true;
  s.stage.frames(6);
  EXPECT_TRUE(s.stage.find("drawing/mirrored/X"));
}

TEST_F(KeptOptionsTest, ScaleTableAndToolAreThereAgainNextTime) {
  {
    auto s = console();
    MUST(s->hand.type("drawing/per_unit/X", "250\n"));
    s->run(0.1);
    MUST(s->hand.type("drawing/table/right", "300\n"));
    s->run(0.1);
    MUST(s->hand.click("drawing/tool"));
    s->run(0.1);
    MUST(s->hand.click("drawing/tool/DO3"));
    s->run(0.1);
    MUST(s->hand.type("drawing/tolerance", "0.25\n"));
    s->run(0.3);
  }
  auto s = console();
  EXPECT_EQ(s->value("drawing/per_unit/X"), "250.000");
  EXPECT_EQ(s->value("drawing/table/right"), "300.000");
  EXPECT_EQ(s->value("drawing/tool"), "DO3");
  EXPECT_EQ(s->value("drawing/tolerance"), "") << "it is of one drawing";
}

TEST_F(KeptOptionsTest, ThePassingOfAFieldLeavesWhatIsMoreExactThanItsText) {
  const KeptOptionsOfDrawings store(folders);
  ASSERT_TRUE(store.save("pmx@usb", {{{"drawing/per_unit/X", 123.456789}}, {}}));
  auto s = console();
  EXPECT_EQ(s->value("drawing/per_unit/X"), "123.457");
  for (const char* id : {"drawing/per_unit/X", "drawing/per_unit/Y", "drawing/swap"}) {
    MUST(s->hand.click(id));
    s->run(0.1);
  }
  const auto kept = store.load("pmx@usb");
  ASSERT_TRUE(kept);
  ASSERT_TRUE(kept->number("drawing/swap"));
  EXPECT_EQ(*kept->number("drawing/swap"), 1);
  EXPECT_EQ(*kept->number("drawing/per_unit/X"), 123.456789);
  MUST(s->hand.type("drawing/per_unit/X", "123\n"));
  s->run(0.1);
  EXPECT_EQ(*store.load("pmx@usb")->number("drawing/per_unit/X"), 123);
}

TEST_F(KeptOptionsTest, TheScaleOfAnAxisThatDoesNotDrawNowIsKept) {
  const KeptOptionsOfDrawings store(folders);
  ASSERT_TRUE(store.save("pmx@usb", {{{"drawing/per_unit/X", 250}, {"drawing/per_unit/Z", 77}}, {}}));
  auto s = console();
  MUST(s->hand.click("drawing/swap"));
  s->run(0.1);
  const auto kept = store.load("pmx@usb");
  ASSERT_TRUE(kept && kept->number("drawing/per_unit/Z"));
  EXPECT_EQ(*kept->number("drawing/per_unit/Z"), 77);
  for (const char* id : {"drawing/along_y", "drawing/along_y/Z"}) {
    MUST(s->hand.click(id));
    s->run(0.1);
  }
  EXPECT_EQ(s->value("drawing/per_unit/Z"), "77.000") << "and used when it draws";
}

TEST_F(KeptOptionsTest, AToolAxisThatCountsInMillimetresKnowsItsScaleBetter) {
  ASSERT_TRUE(KeptOptionsOfDrawings(folders).save(
      "pmx@usb", {{{"drawing/tool_axis/per_unit", 77}}, {{"drawing/tool_axis", "Z"}}}));
  EXPECT_EQ(console()->value("drawing/tool_axis/per_unit"), "77.000") << "it counts in pulses";
  millimetres = true;
  EXPECT_EQ(console()->value("drawing/tool_axis/per_unit"), "400.000");
}

}  // namespace
}  // namespace hw::panels
