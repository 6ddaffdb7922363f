// A drawing file is opened, placed, and becomes blocks or a program.
#include "panels/drawing/drawing_tab.h"

#include "tests/panels/console_stage.h"
#include "tests/panels/drawing_stage.h"
#include "tests/panels/must.h"

namespace hw::panels {
namespace {

using ::testing::HasSubstr;

TEST_F(DrawingTabTest, ADroppedFileIsMeasuredAndWhatIsLeftOutNamed) {
  EXPECT_THAT(s.reason("drawing/to_program"), HasSubstr("No drawing"));
  drop();
  EXPECT_EQ(s.value("drawing/unit"), "mm, by the file");
  EXPECT_EQ(s.value("drawing/size"), "20.000 x 10.000 mm");
  EXPECT_EQ(s.value("drawing/drawn"), "42.6 mm") << "30 and a circle of radius 2";
  EXPECT_THAT(s.value("drawing/left_out"), HasSubstr("TEXT 4 at 0, 0, line "));
  EXPECT_THAT(s.value("drawing/time"), HasSubstr(" s"));
  EXPECT_FALSE(s.stage.find("drawing/problem"));
}

TEST_F(DrawingTabTest, LayersScaleAndToolChangeTheProgram) {
  drop();
  s.click("drawing/layer/holes");
  s.stage.frames(6);
  EXPECT_EQ(s.value("drawing/drawn"), "30.0 mm");
  two_hundred_pulses_in_a_mm();
  s.click("drawing/tool");
  s.click("drawing/tool/DO2");
  s.click("drawing/origin/Corner");
  s.stage.frames(6);
  s.click("drawing/to_program");
  const std::string& text = s.tab.desk().programs.texts.text(0);
  EXPECT_THAT(text, HasSubstr("DO2=1"));
  EXPECT_THAT(text, HasSubstr("X4000Y0")) << "20 mm of 200 pulses, from the corner";
  EXPECT_THAT(text, HasSubstr("X4000Y2000"));
}

TEST_F(DrawingTabTest, AClickThatEndsAFieldWaitsForWhatItChanges) {
  drop();
  two_hundred_pulses_in_a_mm();
  s.stage.frames(6);
  const auto in_the_field = [this](const char* field, std::string_view digits) {
    s.click(field);
    for (const char c : digits) s.stage.push(gui::InputEvent::text(static_cast<unsigned>(c), s.stage.now_s));
    s.stage.frames(2);
  };
  in_the_field("drawing/per_unit/X", "100");
  s.click_at(s.stage.find("drawing/to_program")->rect.centre());
  s.stage.frames(6);
  EXPECT_THAT(s.tab.desk().programs.texts.text(0), HasSubstr("X3000Y2000")) << "30 mm of 100 pulses";
  in_the_field("drawing/per_unit/X", "50");
  s.click_at(s.stage.find("drawing/cut")->rect.centre());
  s.stage.frames(6);
  EXPECT_TRUE(s.stage.find("drawing/ask_cut/yes"));
}

TEST_F(DrawingTabTest, AnAxisLowersTheToolAndAnOutputSwitchesItThen) {
  drop();
  two_hundred_pulses_in_a_mm();
  s.click("drawing/tool_axis");
  EXPECT_FALSE(s.stage.find("drawing/tool_axis/X")) << "it draws";
  s.click("drawing/tool_axis/Z");
  s.type("drawing/tool_axis/per_unit", "100");
  s.type("drawing/tool_axis/down", "-2");
  s.type("drawing/tool_axis/up", "3.5");
  s.type("drawing/wait_on", "250");
  s.click("drawing/tool");
  s.click("drawing/tool/DO2");
  s.stage.frames(6);
  s.click("drawing/to_program");
  const std::string text = s.tab.desk().programs.texts.text(0);
  std::size_t at = 0;
  for (const char* part :
       {"SUB 1", "DO2=0", "Z350", "WAITZ", "SUB 2", "Z-200", "WAITZ", "DO2=1", "DELAY=250"}) {
    at = text.find(part, at);
    ASSERT_NE(at, std::string::npos) << part << " in its turn in " << text;
  }
  s.click("drawing/along_y");
  s.click("drawing/along_y/Z");
  s.stage.frames(6);
  EXPECT_FALSE(s.stage.find("drawing/tool_axis/down")) << "Z draws now";
}

TEST_F(DrawingTabTest, AChainIsLeftOutAndDrawnAgain) {
  drop();
  EXPECT_THAT(s.reason("drawing/leave_out"), HasSubstr("No chain is chosen"));
  EXPECT_THAT(s.reason("drawing/draw_all"), HasSubstr("Nothing was left out"));
  s.click("drawing/chain/2");
  s.click("drawing/leave_out");
  s.stage.frames(6);
  EXPECT_EQ(s.value("drawing/drawn"), "30.0 mm") << "without the circle";
  EXPECT_FALSE(s.stage.find("drawing/chain/2"));
  s.click("drawing/draw_all");
  s.stage.frames(6);
  EXPECT_EQ(s.value("drawing/drawn"), "42.6 mm");
}

TEST_F(DrawingTabTest, AMarginIsLeftOutWithOneClick) {
  std::string with_margin(square_and_text);
  const std::string end = "0\nENDSEC\n0\nEOF\n";
  with_margin.resize(with_margin.size() - end.size());
  for (const char* side : {"0\n20\n0\n11\n90\n21\n0", "90\n20\n0\n11\n90\n21\n60",
                           "90\n20\n60\n11\n0\n21\n60", "0\n20\n60\n11\n0\n21\n0"})
    with_margin += std::string("0\nLINE\n8\ncut\n10\n") + side + "\n";
  ASSERT_TRUE(write_file(file, with_margin + end));
  drop();
  EXPECT_EQ(s.value("drawing/size"), "90.000 x 60.000 mm");
  s.click("drawing/leave_out");
  s.stage.frames(6);
  EXPECT_EQ(s.value("drawing/size"), "20.000 x 10.000 mm");
  EXPECT_EQ(s.value("drawing/drawn"), "42.6 mm");
}

TEST_F(DrawingTabTest, TheChainsAreListedInTheirOrder) {
  drop();
  two_hundred_pulses_in_a_mm();
  s.stage.frames(6);
  EXPECT_THAT(s.value("drawing/chain/1"), HasSubstr("30.0 mm, 14.1 mm to it")) << "the corner, from 10, 10";
  EXPECT_THAT(s.value("drawing/chain/2"), HasSubstr("12.6 mm"));
  EXPECT_THAT(s.value("drawing/chain/2"), testing::Not(HasSubstr("?"))) << "it has been rehearsed";
  EXPECT_FALSE(s.stage.find("drawing/chain/3"));
}

TEST_F(DrawingTabTest, ABarShowsTheProgress) {
  s.tab.desk().dropped["drawing"].push_back(file);
  s.stage.frames(1);
  EXPECT_NE(s.value("drawing/progress"), "");
  s.stage.frames(6);
  EXPECT_EQ(s.value("drawing/progress"), "") << "it is done";
}

TEST_F(DrawingTabTest, AnInvalidNumberIsNoScale) {
  drop();
  two_hundred_pulses_in_a_mm();
  s.type("drawing/per_unit/X", "-3");
  s.click("drawing/origin/Corner");
  s.stage.frames(6);
  EXPECT_EQ(s.value("drawing/size"), "20.000 x 10.000 mm") << "the last that was one still counts";
  EXPECT_THAT(s.reason("drawing/to_program"), HasSubstr("pulses/mm, X: 0.000001 to"));
  s.type("drawing/per_unit/X", "200\n");
  s.stage.frames(6);
  s.click("drawing/to_program");
  EXPECT_THAT(s.tab.desk().programs.texts.text(0), HasSubstr("X4000Y0"));
}

TEST_F(DrawingTabTest, ItBecomesBlocks) {
  drop();
  s.click("drawing/to_blocks");
  const auto& steps = s.tab.desk().blocks.editor.sequence().steps;
  EXPECT_GT(steps.size(), 5u);
  EXPECT_TRUE(s.tab.desk().blocks.edited());
  s.click("drawing/to_blocks");
  ASSERT_TRUE(s.stage.find("drawing/replace_blocks/no")) << "they are in no file";
  s.click("drawing/replace_blocks/no");
}

TEST_F(DrawingTabTest, AnyTwoAxesDraw) {
  drop();
  s.click("drawing/along_x");
  s.click("drawing/along_x/Y");
  s.stage.frames(6);
  EXPECT_TRUE(s.stage.find("drawing/per_unit/X")) << "they have changed places";
  s.click("drawing/along_y");
  s.click("drawing/along_y/Z");
  s.type("drawing/per_unit/Y", "200");
  s.type("drawing/per_unit/Z", "200");
  s.click("drawing/origin/Corner");
  s.stage.frames(6);
  s.click("drawing/to_program");
  EXPECT_THAT(s.tab.desk().programs.texts.text(0), HasSubstr("Y4000Z2000"));
}

TEST_F(DrawingTabTest, AClickSetsTheOrigin) {
  drop();
  two_hundred_pulses_in_a_mm();
  s.click("drawing/origin/By click");
  s.stage.frames(6);
  s.click("drawing/fit");
  s.stage.frames(3);
  // From where the axes stand to the end of the second line, 30 and 20 mm: its beginning is at 30, 10.
  const gui::Rect view = s.stage.find("drawing/view")->rect;
  const double per_px = std::stod(s.value("drawing/view"));
  const ImVec2 at(view.centre().x + static_cast<float>(15 * 200 / per_px) + 2, view.centre().y + 2);
  s.click_at(at);
  s.stage.frames(8);
  s.click("drawing/to_program");
  const std::string& text = s.tab.desk().programs.texts.text(0);
  EXPECT_THAT(text, HasSubstr("X0Y0\n"));
  EXPECT_THAT(text, HasSubstr("X-4000Y0\n")) << "the beginning of the first line, 20 mm to the left";
  EXPECT_THAT(text, HasSubstr("X0Y2000\n"));
}

TEST_F(DrawingTabTest, ChainsThatLeaveTheTableAreCounted) {
  drop();
  EXPECT_FALSE(s.stage.find("drawing/off"));
  s.type("drawing/table/right", "25");
  s.type("drawing/table/top", "100");
  s.click("drawing/fit");
  s.stage.frames(6);
  EXPECT_EQ(s.value("drawing/off"), "1 of 2 chains leave the table.");
  s.click("drawing/cut");
  EXPECT_THAT(s.value("drawing/ask_cut/says"), HasSubstr("1 of 2 chains leave the table."));
  s.click("drawing/ask_cut/no");
  s.type("drawing/table/right", "");
  s.click("drawing/fit");
  s.stage.frames(6);
  EXPECT_FALSE(s.stage.find("drawing/off"));
}

TEST_F(DrawingTabTest, CuttingIsAskedAboutFirst) {
  EXPECT_THAT(s.reason("drawing/cut"), HasSubstr("No drawing"));
  drop();
  two_hundred_pulses_in_a_mm();
  s.click("drawing/tool");
  s.click("drawing/tool/DO2");
  s.stage.frames(6);
  s.click("drawing/cut");
  s.click("drawing/ask_cut/no");
  EXPECT_FALSE(s.last<intent::RunInPieces>());
  s.click("drawing/cut");
  s.click("drawing/ask_cut/yes");
  const auto* asked = s.last<intent::RunInPieces>();
  ASSERT_TRUE(asked);
  ASSERT_EQ(asked->pieces->all.size(), 1u);
  EXPECT_THAT(std::get<intent::LoadProgram>(*asked->pieces->all[0].does[0].what).text,
              HasSubstr("Tool off: output 2 off"));
}

TEST_F(DrawingTabTest, AStoppedDrawingGoesOnFromItsChain) {
  drop();
  s.click("drawing/cut");
  s.click("drawing/ask_cut/yes");
  s.settle(IntentState::done);
  s.now.pieces.running = true, s.now.pieces.drawing = s.last<intent::RunInPieces>()->pieces->drawing;
  s.now.pieces.done = 3, s.now.pieces.total = 7, s.now.pieces.step = 6;
  s.stage.frames(3);
  EXPECT_FALSE(s.stage.find("drawing/cut"));
  s.click("drawing/hold");
  EXPECT_TRUE(s.last<intent::Pause>());
  s.now.pieces.held = true;
  s.stage.frames(3);
  s.click("drawing/hold");
  EXPECT_TRUE(s.last<intent::Resume>());
  s.click("drawing/stop");
  EXPECT_TRUE(s.last<intent::Stop>());
  s.now.pieces.running = s.now.pieces.held = false;
  s.now.pieces.rest_of = s.now.pieces.drawing, s.now.pieces.rest_step = 6;
  s.stage.frames(3);
  s.click("drawing/frame");
  s.stage.frames(4);
  s.click("drawing/ask_cut/yes");
  s.settle(IntentState::done);
  EXPECT_EQ(s.last<intent::RunInPieces>()->pieces->drawing, 0u) << "it takes nothing away from the cut";
  s.now.pieces.drawing = 0, s.now.pieces.done = s.now.pieces.total = 1, s.now.pieces.step = 5;
  s.stage.frames(3);
  s.now.axes[0].position = Steps(4000);
  s.stage.frames(2);
  s.click("drawing/cut_on");
  s.stage.frames(6);
  EXPECT_THAT(s.value("drawing/ask_cut/says"), HasSubstr("First, with the tool off: from X at 4000 pulses"))
      << "the way there is shown";
  s.click("drawing/ask_cut/yes");
  const auto* asked = s.last<intent::RunInPieces>();
  ASSERT_TRUE(asked);
  EXPECT_GT(asked->pieces->all.front().first_step, 0);
  EXPECT_LE(asked->pieces->all.front().first_step, 6);
}

TEST_F(DrawingTabTest, ARefusedCutDoesNotForgetTheStoppedDrawing) {
  drop();
  s.click("drawing/cut");
  s.click("drawing/ask_cut/yes");
  s.settle(IntentState::done);
  const std::uint64_t first = s.last<intent::RunInPieces>()->pieces->drawing;
  s.now.pieces.drawing = s.now.pieces.rest_of = first, s.now.pieces.rest_step = 6;
  s.now.pieces.done = 3, s.now.pieces.total = 7, s.now.pieces.step = 6;
  s.stage.frames(3);
  ASSERT_TRUE(s.stage.find("drawing/cut_on"));
  s.click("drawing/swap");
  s.stage.frames(6);
  s.click("drawing/cut");
  s.click("drawing/ask_cut/yes");
  ASSERT_NE(s.last<intent::RunInPieces>()->pieces->drawing, first);
  s.settle(IntentState::refused);
  s.stage.frames(3);
  EXPECT_EQ(s.reason("drawing/cut_on"), "The drawing has changed since.");
}

TEST_F(DrawingTabTest, WithoutTheSpeedWithTheToolOffTheSavingIsMarkedSo) {
  std::string text = "0\nSECTION\n2\nHEADER\n9\n$INSUNITS\n70\n4\n0\nENDSEC\n0\nSECTION\n2\nENTITIES\n";
  for (const char* x : {"0", "50", "10", "40"})
    text += std::string("0\nLINE\n8\n0\n10\n") + x + "\n20\n0\n11\n" + x + "\n21\n5\n";
  ASSERT_TRUE(write_file(file, text + "0\nENDSEC\n0\nEOF\n"));
  drop();
  EXPECT_THAT(s.value("drawing/saved"), HasSubstr(" s"));
  EXPECT_FALSE(s.stage.find("drawing/saved/untimed"));
  s.type("drawing/cut_speed", "\n");
  s.stage.frames(6);
  EXPECT_THAT(s.value("drawing/outline"), HasSubstr("Give \"Speed, tool on\" too."));
  s.type("drawing/travel_speed", "\n");
  s.stage.frames(6);
  EXPECT_THAT(s.value("drawing/saved"), testing::Not(HasSubstr(" s")));
  EXPECT_THAT(s.value("drawing/saved/untimed"), HasSubstr("Give both speeds"));
  s.click("drawing/keep_order");
  s.stage.frames(6);
  EXPECT_FALSE(s.stage.find("drawing/saved/untimed")) << "nothing is saved";
}

TEST_F(DrawingTabTest, AnUnknownPositionKeepsTheDrawingFromBeingCut) {
  drop();
  two_hundred_pulses_in_a_mm();
  s.stage.frames(6);
  s.now.axes[1].position_known = false;
  s.stage.frames(3);
  EXPECT_THAT(s.reason("drawing/cut"), HasSubstr("The position of one of its axes is not known."));
}

TEST_F(DrawingTabTest, HowLongItStillTakesIsReported) {
  drop();
  two_hundred_pulses_in_a_mm();
  s.stage.frames(6);
  s.click("drawing/cut");
  s.click("drawing/ask_cut/yes");
  s.settle(IntentState::done);
  s.now.pieces.running = true, s.now.pieces.drawing = s.last<intent::RunInPieces>()->pieces->drawing;
  s.now.pieces.total = 1, s.now.pieces.step = 0;
  s.stage.frames(3);
  EXPECT_THAT(s.value("drawing/cut_progress"), HasSubstr(" s left"));

  DrawingJob::Made made;
  made.conversion.begins = {0, 4};
  made.conversion.sequence.steps.resize(8);
  EXPECT_FALSE(DrawingJob::seconds_left(made, 0, 100)) << "it was not rehearsed";
  made.chain_seconds = {10, 20};
  EXPECT_DOUBLE_EQ(*DrawingJob::seconds_left(made, -1, 100), 30);
  EXPECT_DOUBLE_EQ(*DrawingJob::seconds_left(made, 2, 100), 25);
  EXPECT_DOUBLE_EQ(*DrawingJob::seconds_left(made, 6, 100), 10);
  EXPECT_DOUBLE_EQ(*DrawingJob::seconds_left(made, 6, 50), 20);
}

TEST_F(DrawingTabTest, TheSpeedChangesWhereThatIsTaken) {
  drop();
  s.now.pieces.running = true;
  s.now.pieces.total = 3;
  s.stage.frames(3);
  EXPECT_FALSE(s.stage.find("drawing/override"));
  s.now.pieces.speed_can_change = true;
  s.now.pieces.percent = 150;
  s.stage.frames(3);
  ASSERT_TRUE(s.stage.find("drawing/override"));
  s.click("drawing/override");  // its middle
  const auto* asked = s.last<intent::OverrideSpeed>();
  ASSERT_TRUE(asked);
  EXPECT_NEAR(asked->percent, 105, 5);
  s.now.pieces.done = 2;
  s.stage.frames(3);
  EXPECT_THAT(s.reason("drawing/override"), HasSubstr("The last piece runs at the speeds written in it"));
  s.now.pieces.draws = true;
  s.stage.frames(3);
  EXPECT_EQ(s.reason("drawing/override"), "") << "each move has its speed when it is sent";
}

TEST_F(DrawingTabTest, AFileWithoutAUnitIsNotCutBeforeOneWasChosen) {
  std::string text(square_and_text);
  text.replace(text.find("70\n4\n"), 5, "70\n0\n");
  ASSERT_TRUE(write_file(file, text));
  drop();
  for (const char* id : {"drawing/cut", "drawing/frame", "drawing/to_program", "drawing/to_blocks"})
    EXPECT_THAT(s.reason(id), HasSubstr("does not name its unit")) << id;
  s.click("drawing/unit");
  s.click("drawing/unit/in");
  s.stage.frames(10);
  EXPECT_EQ(s.value("drawing/size"), "508.000 x 254.000 mm");
  s.click("drawing/cut");
  EXPECT_TRUE(s.stage.find("drawing/ask_cut/yes"));
  s.click("drawing/ask_cut/no");
  drop();
  EXPECT_THAT(s.reason("drawing/cut"), HasSubstr("does not name its unit")) << "it may be another file";
}

TEST_F(VxmDrawingTabTest, OnlyTheUserSetsHowFarStairsMayLieBesideTheLine) {
  drop();
  for (const char* id : {"drawing/cut", "drawing/frame", "drawing/to_program"})
    EXPECT_THAT(s.reason(id), HasSubstr("how far its corners may lie from the line")) << id;
  s.type("drawing/tolerance", "0.5\n");
  s.stage.frames(10);
  EXPECT_EQ(s.value("drawing/size"), "20.000 x 10.000 mm");
  s.type("drawing/tolerance", "\n");
  s.stage.frames(10);
  EXPECT_THAT(s.reason("drawing/cut"), HasSubstr("how far its corners may lie from the line"));
}

TEST_F(DrawingTabTest, TheUserMayCorrectTheUnitOfTheFile) {
  drop();
  s.click("drawing/unit");
  s.click("drawing/unit/in");
  s.stage.frames(10);
  EXPECT_EQ(s.value("drawing/size"), "508.000 x 254.000 mm");
  s.type("drawing/times", "0.5\n");
  s.stage.frames(10);
  EXPECT_EQ(s.value("drawing/size"), "254.000 x 127.000 mm");
  s.click("drawing/unit");
  s.click("drawing/unit/mm, by the file");
  s.stage.frames(10);
  EXPECT_EQ(s.value("drawing/size"), "10.000 x 5.000 mm");
  s.click("drawing/unit");
  s.click("drawing/unit/in");
  drop();
  EXPECT_EQ(s.value("drawing/size"), "20.000 x 10.000 mm") << "another file says its own";
}

TEST_F(VxmDrawingTabTest, BeforeTheToleranceIsGivenItsOutlineIsShownAndWhatIsMissing) {
  drop();
  s.type("drawing/per_unit/1", "1000\n");
  s.type("drawing/per_unit/2", "1000\n");
  s.stage.frames(6);
  s.click("drawing/fit");
  s.stage.frames(3);
  EXPECT_THAT(s.value("drawing/outline"), HasSubstr("one axis at a time"));
  EXPECT_GT(std::stod(s.value("drawing/view")), 40) << "all of its 30,000 steps are to be seen";
  s.type("drawing/travel_speed", "5\n");
  s.type("drawing/tolerance", "0.5\n");
  s.stage.frames(10);
  EXPECT_FALSE(s.stage.find("drawing/outline")) << s.value("drawing/outline");
  EXPECT_TRUE(s.stage.find("drawing/size"));
}

TEST_F(DrawingTabTest, AFileWithoutAUnitIsShownAsIfThatWereMm) {
  std::string text(square_and_text);
  text.replace(text.find("70\n4\n"), 5, "70\n0\n");
  ASSERT_TRUE(write_file(file, text));
  drop();
  EXPECT_THAT(s.value("drawing/outline"), HasSubstr("shown as if in mm"));
  s.click("drawing/unit");
  s.click("drawing/unit/mm");
  s.stage.frames(10);
  EXPECT_FALSE(s.stage.find("drawing/outline"));
  EXPECT_EQ(s.value("drawing/size"), "20.000 x 10.000 mm");
}

TEST_F(VxmDrawingTabTest, StairsWithinTheTolerance) {
  drop();
  s.type("drawing/per_unit/1", "10");
  s.type("drawing/per_unit/2", "10");
  s.type("drawing/tolerance", "0.5");
  s.click("drawing/flip_x");
  s.stage.frames(6);
  ASSERT_TRUE(s.stage.find("drawing/view"));
  EXPECT_EQ(s.value("drawing/size"), "20.000 x 10.000 mm");
}

TEST(DrawnTogether, BeforeACutItIsReportedThatALostLinkLeavesTheToolOn) {
  const auto file = std::filesystem::temp_directory_path() / "hw_drawing_together.dxf";
  ASSERT_TRUE(write_file(file, square_and_text));
  const DeviceType& dmx = *find_device_type("dmx-k-sa");
  ConsoleStage s(1440, 1400);
  std::vector<gui::Tab*> members;
  for (const char* id : {"01", "02"})
    members.push_back(s.add(*dmx.make_catalog({{"id", id}}), &dmx.language()).tab);
  s.console.join(members, "DMX 01-02");
  s.run(0.1);
  MUST(s.hand.click("tab/drawing"));
  s.console.active()->desk().dropped["drawing"].push_back(file);
  s.run(0.5);
  MUST(s.hand.click("drawing/tool"));
  MUST(s.hand.click("drawing/tool/DO1"));
  s.run(0.5);
  MUST(s.hand.click("drawing/cut"));
  s.run(0.1);
  EXPECT_THAT(s.value("drawing/ask_cut/says"),
              HasSubstr("(output 1) off. While the link is lost the console cannot switch it off"));
  std::filesystem::remove(file);
}

TEST_F(DrawingTabTest, AFileThatIsNoDrawingIsReportedAndLosesNothing) {
  drop();
  ASSERT_TRUE(write_file(file, "this is no DXF"));
  drop();
  EXPECT_NE(s.toast(), "");
  EXPECT_EQ(s.value("drawing/size"), "20.000 x 10.000 mm");
}

}  // namespace
}  // namespace hw::panels
