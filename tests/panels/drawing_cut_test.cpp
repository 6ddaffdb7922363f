// What keeps a drawing from being cut, and what is said before it is.
#include <fmt/format.h>

#include "tests/panels/console_stage.h"
#include "tests/panels/drawing_stage.h"
#include "tests/panels/must.h"

namespace hw::panels {
namespace {

using ::testing::HasSubstr;

/// More lines than a program of any controller holds.
std::string saw(int teeth) {
  std::string text =
      "0\nSECTION\n2\nHEADER\n9\n$INSUNITS\n70\n4\n0\nENDSEC\n0\nSECTION\n2\nENTITIES\n"
      "0\nLWPOLYLINE\n8\ncut\n90\n" +
      std::to_string(teeth) + "\n70\n0\n";
  for (int i = 0; i < teeth; ++i) text += fmt::format("10\n{}\n20\n{}\n", i * 0.1, i % 2);
  return text + "0\nENDSEC\n0\nEOF\n";
}

TEST_F(DrawingTabTest, ABufferedDrawingIsNotCutWhileALoopIsClosed) {
  ASSERT_TRUE(write_file(file, saw(2000)));
  drop();
  ASSERT_EQ(s.reason("drawing/cut"), "");
  s.now.axes[0].in_counts = s.now.axes[2].in_counts = true;
  s.stage.frames(3);
  EXPECT_THAT(s.value("drawing/loops"), HasSubstr("StepNLoop of X, StepNLoop of Z are on"));
  EXPECT_EQ(s.reason("drawing/cut"), s.value("drawing/loops"));
  s.sent.clear();
  s.click("drawing/open_loops");
  ASSERT_EQ(s.sent.size(), 2u);
  const auto* first = std::get_if<intent::SetParam>(&s.sent.front());
  ASSERT_TRUE(first);
  EXPECT_EQ(first->mnemonic, "SLX");
  EXPECT_EQ(first->value, 0);
  s.now.axes[0].in_counts = s.now.axes[2].in_counts = false;
  s.stage.frames(3);
  EXPECT_EQ(s.reason("drawing/cut"), "");
  EXPECT_FALSE(s.stage.find("drawing/open_loops"));
}

TEST_F(DrawingTabTest, AProgramIsRunWithLoopsClosed) {
  drop();
  s.now.axes[0].in_counts = true;
  s.stage.frames(3);
  EXPECT_EQ(s.reason("drawing/cut"), "");
}

TEST_F(DrawingTabTest, RoutinesOfOnesOwnLowerAndLiftTheTool) {
  drop();
  two_hundred_pulses_in_a_mm();
  s.click("drawing/tool");
  s.click("drawing/tool/DO2");
  s.type("drawing/wait_on", "250\n");
  s.click("drawing/own_routines");
  EXPECT_EQ(s.value("drawing/routine/on"), "DO2 on, wait 250 ms") << "what was chosen is gone on with";
  EXPECT_EQ(s.value("drawing/routine/off"), "DO2 off");
  s.type("drawing/routine/on", "DO3 on, Z to -2, wait 40 ms, DO2 on\n");
  s.type("drawing/routine/off", "DO2 off, Z to 1.5, DO3 off\n");
  s.stage.frames(6);
  EXPECT_FALSE(s.stage.find("drawing/routine/wrong"));
  s.click("drawing/to_program");
  const std::string text = s.tab.desk().programs.texts.text(0);
  std::size_t at = 0;
  for (const char* part : {"SUB 1", "DO2=0", "Z150", "WAITZ", "DO3=0", "SUB 2", "DO3=1", "Z-200", "WAITZ",
                           "DELAY=40", "DO2=1"}) {
    at = text.find(part, at);
    ASSERT_NE(at, std::string::npos) << part << " in its turn in " << text;
  }
}

TEST_F(DrawingTabTest, ARoutineThatIsNotUnderstoodOrLeavesTheToolOnCutsNothing) {
  drop();
  s.click("drawing/own_routines");
  s.type("drawing/routine/on", "laser\n");
  s.stage.frames(6);
  EXPECT_THAT(s.value("drawing/routine/wrong"), HasSubstr("\"laser\" is not understood. Write: U to -2"));
  for (const char* id : {"drawing/cut", "drawing/to_program", "drawing/frame"})
    EXPECT_EQ(s.reason(id), s.value("drawing/routine/wrong")) << id;
  s.type("drawing/routine/on", "DO2 on\n");
  s.stage.frames(6);
  EXPECT_THAT(s.reason("drawing/cut"), HasSubstr("nothing switches it back"));
  s.type("drawing/routine/off", "DO2 off\n");
  s.stage.frames(6);
  EXPECT_EQ(s.reason("drawing/cut"), "");
}

TEST_F(DrawingTabTest, EndsAreJoinedWithinWhatIsAskedFor) {
  std::string text(square_and_text);
  text.replace(text.find("10\n30\n20\n10\n11\n30\n21\n20"), 5, "10\n30.05");
  ASSERT_TRUE(write_file(file, text));
  drop();
  EXPECT_THAT(s.value("drawing/chains"), testing::StartsWith("3"));
  s.type("drawing/join", "0.1\n");
  s.stage.frames(6);
  EXPECT_THAT(s.value("drawing/chains"), testing::StartsWith("2"));
}

TEST_F(VxmDrawingTabTest, BeforeItIsCutItsMovesAreCounted) {
  drop();
  s.type("drawing/per_unit/1", "10");
  s.type("drawing/per_unit/2", "10");
  s.type("drawing/tolerance", "0.5\n");
  s.stage.frames(10);
  const std::string moves = s.value("drawing/moves");
  EXPECT_THAT(moves, testing::EndsWith(", an axis each"));
  EXPECT_GT(std::stoi(moves), 12) << "a corner, and a circle of radius 2 as stairs of half a mm";
  EXPECT_LT(std::stoi(moves), 60);
  s.click("drawing/cut");
  EXPECT_THAT(s.value("drawing/ask_cut/says"), HasSubstr(std::to_string(std::stoi(moves)) + " moves in all"));
}

TEST_F(SlaveDrawingTabTest, MotorsOfMasterAndSlaveDrawOneAfterTheOtherAndThatIsReported) {
  drop();
  s.type("drawing/tolerance", "0.5\n");
  s.stage.frames(6);
  EXPECT_FALSE(s.stage.find("drawing/remarks")) << "both on the Master";
  s.click("drawing/along_x");
  s.click("drawing/along_x/3");
  s.stage.frames(6);
  EXPECT_THAT(s.value("drawing/remarks"),
              HasSubstr("Master and Slave could start together, but not on a straight"));
  s.click("drawing/along_y");
  s.click("drawing/along_y/4");
  s.type("drawing/per_unit/3", "10\n");
  s.type("drawing/per_unit/4", "10\n");
  s.stage.frames(6);
  EXPECT_FALSE(s.stage.find("drawing/remarks")) << "both on the Slave";
  s.click("drawing/to_program");
  EXPECT_THAT(s.tab.desk().programs.texts.text(0),
              testing::AllOf(HasSubstr("IA3M300"), HasSubstr("IA4M100")));
}

TEST_F(DrawingTabTest, TheFrameGoesOnceAroundWithTheToolOff) {
  drop();
  two_hundred_pulses_in_a_mm();
  s.click("drawing/tool");
  s.click("drawing/tool/DO2");
  s.click("drawing/origin/Corner");
  s.stage.frames(6);
  const std::string before = s.tab.desk().programs.texts.text(0);
  s.sent.clear();
  s.click("drawing/frame");
  s.stage.frames(4);
  EXPECT_TRUE(s.sent.empty()) << "it is asked about";
  EXPECT_THAT(s.value("drawing/ask_cut/says"), HasSubstr("once around the drawing with the tool off"));
  s.click("drawing/ask_cut/yes");
  ASSERT_EQ(s.sent.size(), 1u);
  EXPECT_EQ(s.tab.desk().programs.texts.text(0), before) << "the user's text stays";
  const auto* asked = std::get_if<intent::RunInPieces>(&s.sent.front());
  ASSERT_TRUE(asked);
  ASSERT_EQ(asked->pieces->all.size(), 1u);
  std::string text;
  for (const PieceAct& act : asked->pieces->all.front().does)
    if (const auto* load = act.what ? std::get_if<intent::LoadProgram>(&*act.what) : nullptr)
      text += load->text;
  EXPECT_THAT(text, testing::Not(HasSubstr("DO2=1")));
  std::size_t at = 0;
  for (const char* corner : {"X0Y0", "X4000Y0", "X4000Y2000", "X0Y2000", "X0Y0"}) {
    at = text.find(corner, at);
    ASSERT_NE(at, std::string::npos) << corner << " in " << text;
    ++at;
  }
}

TEST(FrameOfSeveral, IsTracedTogetherWithTheToolOff) {
  const auto file = std::filesystem::temp_directory_path() / "hw_frame_together.dxf";
  ASSERT_TRUE(write_file(file, square_and_text));
  const DeviceType& dmx = *find_device_type("dmx-k-sa");
  ConsoleStage s(1440, 1400);
  std::vector<gui::Tab*> members;
  std::vector<Example*> sides;
  for (const char* id : {"01", "02"}) {
    sides.push_back(&s.add(*dmx.make_catalog({{"id", id}}), &dmx.language()));
    members.push_back(sides.back()->tab);
  }
  s.console.join(members, "DMX 01-02");
  s.run(0.1);
  MUST(s.hand.click("tab/drawing"));
  s.console.active()->desk().dropped["drawing"].push_back(file);
  s.run(0.5);
  MUST(s.hand.click("drawing/tool"));
  MUST(s.hand.click("drawing/tool/DO1"));
  s.run(0.5);
  MUST(s.hand.click("drawing/frame"));
  s.run(0.5);
  EXPECT_EQ(sides[0]->count<intent::RunInPieces>(), 0) << "it is asked about";
  EXPECT_THAT(s.value("drawing/ask_cut/says"), HasSubstr("once around the drawing with the tool off"));
  MUST(s.hand.click("drawing/ask_cut/yes"));
  s.run(0.1);
  for (const Example* side : sides) {
    const auto* asked = side->last<intent::RunInPieces>();
    ASSERT_TRUE(asked);
    EXPECT_TRUE(asked->seat) << "they go together";
    int moves = 0;
    for (const Piece& piece : asked->pieces->all)
      for (const PieceAct& act : piece.does) {
        const auto* output = act.what ? std::get_if<intent::SetOutput>(&*act.what) : nullptr;
        EXPECT_FALSE(output && output->on);
        moves += act.what && std::holds_alternative<intent::MoveTo>(*act.what);
      }
    EXPECT_GE(moves, 2) << "across and back";
  }
  std::filesystem::remove(file);
}

}  // namespace
}  // namespace hw::panels
