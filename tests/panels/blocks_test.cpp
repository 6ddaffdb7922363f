// Blocks that are clicked together become the controller's text; what it cannot do is said at its block.
#include "panels/blocks/blocks.h"

#include "core/device/registry.h"
#include "core/sequence/sequence_file.h"
#include "core/session/user_files.h"
#include "tests/panels/panel_stage.h"

namespace hw::panels {
namespace {

using ::testing::HasSubstr;

struct BlocksTest : ::testing::Test {
  explicit BlocksTest(const char* model = "pmx-4ex-sa")
      : type(*find_device_type(model)),
        s(panel, 864, 1200, 1, gui::Tier::wide, true, *type.make_catalog({}), &type.language()) {
    s.now.axis_count = 4;
    for (AxisState& a : s.now.axes) a.position_known = true, a.activity = Activity::idle;
    s.stage.frames(2);
  }
  std::string text() { return s.value("blocks/text"); }
  void key(const char* chord) {
    EXPECT_TRUE(s.stage.hand.key(chord));
    s.stage.frames(3);
  }
  /// From the middle of one block to the upper or lower part of another.
  void drag(const char* from, const char* to, float share) {
    const ImVec2 begin = s.stage.find(from)->rect.centre();
    const gui::Rect over = s.stage.find(to)->rect;
    const ImVec2 end(begin.x, over.min.y + share * over.height());
    s.stage.push(gui::InputEvent::mouse_move(begin.x, begin.y, s.stage.now_s));
    s.stage.push(gui::InputEvent::mouse_button(0, true, begin, s.stage.now_s));
    s.stage.frames(2);
    s.stage.push(gui::InputEvent::mouse_move(end.x, end.y, s.stage.now_s));
    s.stage.frames(2);
    s.stage.push(gui::InputEvent::mouse_button(0, false, end, s.stage.now_s));
    s.stage.frames(3);
  }
  const DeviceType& type;
  Blocks panel;
  test::PanelStage s;
};
struct VxmBlocksTest : BlocksTest {
  VxmBlocksTest() : BlocksTest("vxm") { s.now.axis_count = 2; }
};

TEST_F(BlocksTest, ClickedBlocksAreWrittenAsAProgram) {
  EXPECT_THAT(s.reason("blocks/to_program"), HasSubstr("There are no blocks yet"));
  s.click("blocks/add/move");
  s.type("blocks/1/to/X", "1200");
  s.type("blocks/1/to/Y", "-50");
  s.click("blocks/add/wait_motion");
  s.click("blocks/2/axis/X");
  s.click("blocks/add/output");
  s.type("blocks/3/output", "5");
  EXPECT_EQ(text(), "ABS\nX1200Y-50\nWAITX\nDO5=1\nEND\n");
  EXPECT_EQ(s.value("blocks/1"), "X 1200, Y -50");
  s.click("blocks/to_program");
  EXPECT_EQ(s.tab.desk().programs.texts.text(0), text());
}

TEST_F(BlocksTest, BlocksMoveInAndOutOfLoops) {
  s.click("blocks/add/delay");
  s.type("blocks/1/ms", "10");
  s.click("blocks/add/loop");
  s.click("blocks/add/delay");
  s.type("blocks/3/ms", "20");
  EXPECT_EQ(text(), "DELAY=10\nV49=0\nWHILE V49<2\n  DELAY=20\n  V49=V49+1\nENDWHILE\nEND\n");
  s.click("blocks/1");
  s.click("blocks/down");
  EXPECT_EQ(text(), "V49=0\nWHILE V49<2\n  DELAY=10\n  DELAY=20\n  V49=V49+1\nENDWHILE\nEND\n");
  s.click("blocks/down");
  s.click("blocks/down");
  EXPECT_EQ(text(), "V49=0\nWHILE V49<2\n  DELAY=20\n  V49=V49+1\nENDWHILE\nDELAY=10\nEND\n");
  s.click("blocks/up");
  EXPECT_EQ(text(), "V49=0\nWHILE V49<2\n  DELAY=20\n  DELAY=10\n  V49=V49+1\nENDWHILE\nEND\n");
  for (int n = 0; n < 3; ++n) s.click("blocks/undo");
  EXPECT_EQ(text(), "V49=0\nWHILE V49<2\n  DELAY=10\n  DELAY=20\n  V49=V49+1\nENDWHILE\nEND\n");
  s.click("blocks/redo");
  EXPECT_THAT(text(), HasSubstr("DELAY=20\n  DELAY=10"));
}

TEST_F(BlocksTest, ABlockIsLeftOutDuplicatedAndRemoved) {
  s.click("blocks/add/comment");
  s.click("blocks/duplicate");
  s.type("blocks/2/text", "second");
  EXPECT_EQ(text(), "; what comes next\n; second\nEND\n");
  s.click("blocks/skip");
  EXPECT_EQ(text(), "; what comes next\nEND\n");
  s.click("blocks/skip");
  s.click("blocks/remove");
  EXPECT_EQ(text(), "; what comes next\nEND\n");
  s.click("blocks/loop");
  EXPECT_THAT(text(), HasSubstr("WHILE V49<2\n  ; what comes next"));
}

TEST_F(BlocksTest, ATargetIsTaughtWhereTheAxesAre) {
  s.now.poll_period = std::chrono::hours(1);
  s.now.axes[0].position = Steps(4321);
  s.now.axes[1].position = Steps(567);
  s.click("blocks/add/move");
  s.click("blocks/here");
  EXPECT_THAT(text(), HasSubstr("X4321Y567Z0U0\n"));
  for (const char* axis : {"Y", "Z", "U"}) s.type((std::string("blocks/1/to/") + axis).c_str(), "");
  s.now.axes[0].position = Steps(99);
  s.click("blocks/here");
  EXPECT_THAT(text(), HasSubstr("X99\n")) << "what it names, and nothing else";
  s.now.link.state = LinkState::lost;
  s.stage.frames(2);
  EXPECT_THAT(s.reason("blocks/here"), HasSubstr("not known"))
      << "what was seen last is no place to be taught";
}

TEST_F(BlocksTest, AnInvalidFieldKeepsTheBlocksOutOfTheProgram) {
  s.click("blocks/add/output");
  s.type("blocks/1/output", "99");
  EXPECT_THAT(s.reason("blocks/to_program"), HasSubstr("64"));
  s.type("blocks/1/output", "5");
  EXPECT_EQ(s.reason("blocks/to_program"), "");
  EXPECT_THAT(text(), HasSubstr("DO5=1"));
}

TEST_F(BlocksTest, OwnTextHasSeveralLines) {
  s.click("blocks/add/custom");
  s.type("blocks/1/text", "V1=5\n");
  s.type("blocks/1/text/2", "V2=6");
  EXPECT_THAT(text(), HasSubstr("V1=5\nV2=6\n"));
}

TEST_F(BlocksTest, TheMemoryThatTheyTakeIsReported) {
  s.click("blocks/add/delay");
  EXPECT_THAT(s.value("blocks/memory"), HasSubstr(" of 1275 "));
}

TEST_F(BlocksTest, SpaceLeavesTheChosenOneOut) {
  s.click("blocks/add/comment");
  s.click("blocks/end");
  s.click("blocks/1");
  key("space");
  EXPECT_EQ(text(), "END\n");
  key("space");
  EXPECT_EQ(text(), "; what comes next\nEND\n");
}

TEST_F(VxmBlocksTest, ARefusalIsReportedAtItsBlock) {
  sequence::Sequence of_another = sequence::frame_of(s.tab.desk().blocks.editor.sequence());
  of_another.steps = {{sequence::Delay{500}}, {sequence::Arc{0, 0, 90, {}}}};
  s.tab.desk().blocks.editor.load(std::move(of_another));
  s.stage.frames(4);
  s.click("blocks/2");
  EXPECT_EQ(s.value("blocks/problem"), "1 block is refused.");
  EXPECT_THAT(s.value("blocks/2/refusal"), HasSubstr("A VXM moves one motor at a time"));
  EXPECT_THAT(s.reason("blocks/to_program"), HasSubstr("Step 2 (arc)"));
  s.click("blocks/remove");
  EXPECT_FALSE(s.stage.find("blocks/problem"));
  EXPECT_EQ(text(), "P5\n");
}

TEST_F(BlocksTest, ATextWithChangesIsNotReplacedWithoutBeingAsked) {
  s.tab.desk().programs.texts.set_text(0, "END\n");
  s.click("blocks/add/delay");
  s.click("blocks/to_program");
  s.click("blocks/replace/no");
  EXPECT_EQ(s.tab.desk().programs.texts.text(0), "END\n");
  s.click("blocks/to_program");
  s.click("blocks/replace/yes");
  EXPECT_EQ(s.tab.desk().programs.texts.text(0), "DELAY=500\nEND\n");
}

TEST_F(VxmBlocksTest, BlocksRunWhereTheyStand) {
  EXPECT_THAT(s.reason("blocks/run"), HasSubstr("There are no blocks yet"));
  s.now.slot_bytes_used[0] = 0;
  s.click("blocks/add/move_by");
  s.type("blocks/1/to/1", "400");
  s.click("blocks/add/delay");
  s.click("blocks/run");
  EXPECT_EQ(s.tab.desk().programs.texts.text(0), text());
  ASSERT_TRUE(s.last<intent::LoadProgram>());
  EXPECT_EQ(s.last<intent::LoadProgram>()->text, text());
  EXPECT_THAT(s.reason("blocks/run"), HasSubstr("transferred"));
  s.settle(IntentState::done);
  ASSERT_TRUE(s.last<intent::RunProgram>());
  s.settle(IntentState::done);

  s.now.program = {
      .run = RunState::running, .owned = true, .slot = 0, .command = 1, .command_reported = true};
  s.stage.frames(3);
  EXPECT_EQ(s.value("blocks/2/time"), "runs") << "the second line of the text is of the second block";
  EXPECT_NE(s.value("blocks/1/time"), "runs");
  EXPECT_THAT(s.reason("blocks/run"), HasSubstr("A program is running"));
  s.click("blocks/stop");
  EXPECT_TRUE(s.last<intent::HaltProgram>());

  s.now.program.run = RunState::held;
  s.stage.frames(2);
  EXPECT_EQ(s.value("blocks/2/time"), "held here");
  s.click("blocks/run");
  EXPECT_TRUE(s.last<intent::Resume>());
}

TEST_F(VxmBlocksTest, AStopWhileRunIsAskedAboutIsTheLastWord) {
  s.now.slot_bytes_used[0] = 0;
  s.tab.desk().programs.texts.set_text(0, "I2M1\n");
  s.click("blocks/add/delay");
  s.click("blocks/run");
  ASSERT_TRUE(s.stage.find("blocks/replace/yes"));
  s.tab.desk().stopped();
  s.click("blocks/replace/yes");
  EXPECT_FALSE(s.last<intent::LoadProgram>());
  EXPECT_EQ(s.tab.desk().programs.texts.text(0), text()) << "it is only there";
  EXPECT_THAT(s.value("blocks/run_refused"), HasSubstr("A stop came first"));
  s.click("blocks/run");
  EXPECT_TRUE(s.last<intent::LoadProgram>());
}

TEST_F(VxmBlocksTest, ABlockOfAnotherTextIsNotLit) {
  s.now.slot_bytes_used[0] = 0;
  s.click("blocks/add/delay");
  key("ctrl+enter");
  ASSERT_TRUE(s.last<intent::LoadProgram>());
  s.settle(IntentState::done);
  s.settle(IntentState::done);
  s.now.program = {
      .run = RunState::running, .owned = true, .slot = 0, .command = 0, .command_reported = true};
  s.stage.frames(3);
  EXPECT_EQ(s.value("blocks/1/time"), "runs");
  s.click("blocks/add/comment");
  EXPECT_NE(s.value("blocks/1/time"), "runs") << "what runs is not what these blocks are now";
}

TEST_F(BlocksTest, ABlockIsFoundByItsName) {
  s.type("blocks/add_by_name", "inp");
  EXPECT_FALSE(s.stage.find("blocks/add/delay"));
  EXPECT_TRUE(s.stage.find("blocks/add/wait_input"));
  s.stage.hand.key("Enter");
  s.stage.frames(3);
  EXPECT_EQ(s.value("blocks/1"), "until input 1 is on");
  EXPECT_TRUE(s.stage.find("blocks/add/delay")) << "all of them are there again";
}

TEST(NarrowBlocks, AreAddedByTheirNames) {
  const DeviceType& type = *find_device_type("vxm");
  Blocks panel;
  test::PanelStage s(panel, 480, 700, 1, gui::Tier::narrow, true, *type.make_catalog({}), &type.language());
  s.stage.frames(2);
  EXPECT_FALSE(s.stage.find("blocks/add/delay"));
  s.type("blocks/add_by_name", "del");
  s.click("blocks/add/delay");
  EXPECT_EQ(s.value("blocks/1"), "500 ms");
  EXPECT_FALSE(s.stage.find("blocks/add/delay")) << "the name has been used";
}

TEST(BlocksInASmallWindow, ShowTheirTextAndPathInThePlaceOfThePalette) {
  const DeviceType& type = *find_device_type("pmx-4ex-sa");
  Blocks panel;
  test::PanelStage s(panel, 704, 460, 1, gui::Tier::medium, true, *type.make_catalog({}), &type.language());
  s.stage.frames(2);
  s.click("blocks/add/delay");
  EXPECT_FALSE(s.stage.find("blocks/text"));
  s.click("blocks/aside");
  EXPECT_EQ(s.value("blocks/text"), "DELAY=500\nEND\n");
  EXPECT_TRUE(s.stage.find("blocks/path"));
  s.type("blocks/add_by_name", "comm\n");
  EXPECT_THAT(s.value("blocks/text"), HasSubstr("; what comes next"));
  s.click("blocks/aside");
  EXPECT_TRUE(s.stage.find("blocks/add/delay"));
}

TEST(BlocksInALowWindow, ShowTextOrPath) {
  const DeviceType& type = *find_device_type("pmx-4ex-sa");
  Blocks panel;
  test::PanelStage s(panel, 860, 300, 1, gui::Tier::medium, true, *type.make_catalog({}), &type.language());
  s.stage.frames(2);
  EXPECT_TRUE(s.stage.find("blocks/text"));
  EXPECT_FALSE(s.stage.find("blocks/path"));
  s.click("blocks/side/Path");
  EXPECT_TRUE(s.stage.find("blocks/path"));
  EXPECT_FALSE(s.stage.find("blocks/text"));
  s.click("blocks/side/Text");
  EXPECT_TRUE(s.stage.find("blocks/text"));
}

TEST(BlocksInANarrowWindow, GiveTheirPlaceToTextAndPath) {
  const DeviceType& type = *find_device_type("pmx-4ex-sa");
  Blocks panel;
  test::PanelStage s(panel, 480, 700, 1, gui::Tier::narrow, true, *type.make_catalog({}), &type.language());
  s.stage.frames(2);
  s.type("blocks/add_by_name", "delay\n");
  s.click("blocks/aside");
  EXPECT_EQ(s.value("blocks/text"), "DELAY=500\nEND\n");
  EXPECT_TRUE(s.stage.find("blocks/path"));
  EXPECT_FALSE(s.stage.find("blocks/1"));
  s.click("blocks/aside");
  EXPECT_TRUE(s.stage.find("blocks/1"));
}

TEST(BlocksInALowWindow, StandStillOnceATallOneIsClosed) {
  const DeviceType& type = *find_device_type("pmx-4ex-sa");
  Blocks panel;
  test::PanelStage s(panel, 864, 420, 1, gui::Tier::wide, true, *type.make_catalog({}), &type.language());
  s.stage.frames(2);
  for (int n = 0; n < 3; ++n) {
    s.click("blocks/add/delay");
    s.click("blocks/end");
  }
  s.click("blocks/add/move_on_input");
  s.stage.frames(4);
  ASSERT_TRUE(s.stage.hand.click("blocks/end"));
  const float closed = s.stage.find("blocks/1")->rect.min.y;
  s.stage.frames(10);
  EXPECT_EQ(closed, s.stage.find("blocks/1")->rect.min.y) << "where a hand would press at once";
  s.click("blocks/4");
  ASSERT_TRUE(s.stage.hand.click("blocks/end"));
  ASSERT_TRUE(s.stage.hand.click("blocks/1"));
  EXPECT_TRUE(s.stage.find("blocks/1/ms"));
}

TEST_F(BlocksTest, ABlockIsCarriedWithTheMouse) {
  for (const char* words : {"first", "second", "third"}) {
    s.click("blocks/end");
    s.click("blocks/add/comment");
    s.type((std::string("blocks/") +
            (*words == 'f'   ? "1"
             : *words == 's' ? "2"
                             : "3") +
            "/text")
               .c_str(),
           words);
  }
  s.click("blocks/end");
  drag("blocks/3", "blocks/1", 0.2f);
  EXPECT_EQ(text(), "; third\n; first\n; second\nEND\n");
  s.click("blocks/end");
  drag("blocks/1", "blocks/2", 0.8f);
  EXPECT_EQ(text(), "; first\n; third\n; second\nEND\n");
  s.click("blocks/end");
  s.click("blocks/add/loop");
  s.click("blocks/end");
  drag("blocks/1", "blocks/4", 0.9f);
  EXPECT_THAT(text(), HasSubstr("WHILE V49<2\n  ; first\n"));
  s.click("blocks/undo");
  EXPECT_EQ(text().substr(0, 8), "; first\n");
}

TEST_F(BlocksTest, KeysDoWhatTheButtonsDo) {
  s.click("blocks/add/delay");
  s.click("blocks/add/comment");
  key("ctrl+d");
  EXPECT_EQ(text(), "DELAY=500\n; what comes next\n; what comes next\nEND\n");
  s.click("blocks/1");
  key("alt+down");
  EXPECT_EQ(text(), "; what comes next\nDELAY=500\n; what comes next\nEND\n");
  EXPECT_TRUE(s.sent.empty()) << "an arrow with Alt does not jog";
  key("delete");
  EXPECT_EQ(text(), "; what comes next\n; what comes next\nEND\n");
  key("ctrl+z");
  EXPECT_THAT(text(), HasSubstr("DELAY=500"));
  s.click("blocks/end");
  s.click("blocks/2");
  key("ctrl+g");
  EXPECT_THAT(text(), HasSubstr("  DELAY=500\n"));
}

TEST_F(BlocksTest, KeysTypedInAFieldAreNoKeysOfTheList) {
  s.click("blocks/add/comment");
  s.type("blocks/1/text", "x");
  key("delete");
  EXPECT_EQ(text(), "; x\nEND\n");
}

TEST_F(VxmBlocksTest, BlocksShowHowLongTheyTakeAndWhereTheyGo) {
  s.click("blocks/add/move_by");
  s.type("blocks/1/to/1", "400");
  s.click("blocks/add/delay");
  s.type("blocks/2/ms", "2000");
  s.click("blocks/add/move_by");
  s.type("blocks/3/to/2", "400");
  s.stage.frames(6);
  EXPECT_EQ(s.value("blocks/2/time"), "2.0 s");
  EXPECT_THAT(s.value("blocks/1/time"), ::testing::EndsWith(" s"));
  EXPECT_THAT(s.value("blocks/total"), ::testing::EndsWith(" s"));
  ASSERT_TRUE(s.stage.find("blocks/path"));
  // A click on the upright leg, at the right of the picture, chooses the block that goes there.
  s.click("blocks/end");
  const gui::Rect view = s.stage.find("blocks/path")->rect;
  const double per_px = std::stod(s.value("blocks/path"));
  const ImVec2 leg(view.centre().x + static_cast<float>(200 / per_px), view.centre().y);
  s.click_at(leg);
  EXPECT_TRUE(s.stage.find("blocks/3/to/2")) << "its fields are open";
}

TEST_F(BlocksTest, AnEndlessLoopShowsNoTotal) {
  s.click("blocks/add/loop");
  s.type("blocks/1/times", "0");
  s.click("blocks/add/delay");
  s.stage.frames(6);
  EXPECT_FALSE(s.stage.find("blocks/total"));
}

TEST_F(BlocksTest, BlocksComeBackAfterACrash) {
  const auto folder = std::filesystem::temp_directory_path() / "hw_blocks_test";
  std::filesystem::remove_all(folder);
  UserFolders folders;
  folders.state = folder;
  folders.enabled = true;
  gui::Desk& desk = s.tab.desk();
  ASSERT_TRUE(desk.kept.begin(Autosave(folders), "here"));
  s.click("blocks/add/delay");
  desk.keep_now({});
  s.stage.frames(2);
  gui::Desk again(s.catalog, &type.language(), nullptr);
  ASSERT_TRUE(again.kept.begin(Autosave(folders), "here"));
  EXPECT_EQ(again.blocks.editor.sequence(), desk.blocks.editor.sequence());
  EXPECT_TRUE(again.blocks.edited());
  std::filesystem::remove_all(folder);
}

TEST_F(BlocksTest, OpeningAsksBeforeChangesGo) {
  const auto file = std::filesystem::temp_directory_path() / "hw_blocks_open.toml";
  sequence::Sequence other = s.tab.desk().blocks.editor.sequence();
  other.steps = {{sequence::Comment{"from the file"}}};
  ASSERT_TRUE(write_file(file, sequence::write_sequence(other)));
  s.click("blocks/add/delay");
  s.click("blocks/open");
  s.type("file/path", file.c_str());
  s.click("file/open");
  s.stage.frames(3);
  s.click("blocks/discard/no");
  EXPECT_EQ(text(), "DELAY=500\nEND\n");
  s.click("blocks/open");
  s.type("file/path", file.c_str());
  s.click("file/open");
  s.stage.frames(3);
  s.click("blocks/discard/yes");
  s.stage.frames(3);
  EXPECT_EQ(text(), "; from the file\nEND\n");
  EXPECT_FALSE(s.tab.desk().blocks.edited());
  std::filesystem::remove(file);
}

TEST_F(BlocksTest, TheTextBecomesBlocks) {
  EXPECT_THAT(s.reason("blocks/from_text"), HasSubstr("The program is empty"));
  const std::string program =
      "; to and fro\nABS\nV49=0\nWHILE V49<3\n  X100\n  V49=V49+1\nENDWHILE\nV1=MSTX\nEND\n";
  s.tab.desk().programs.texts.set_text(0, program);
  s.stage.frames(2);
  s.click("blocks/from_text");
  s.stage.frames(3);
  EXPECT_EQ(s.value("blocks/1"), "to and fro");
  EXPECT_EQ(s.value("blocks/2"), "3 times");
  EXPECT_EQ(s.value("blocks/3"), "X 100");
  EXPECT_EQ(s.value("blocks/4"), "blocks have no variables");
  EXPECT_THAT(text(), HasSubstr("V1=MSTX\nEND\n"));
  EXPECT_THAT(s.toast(), HasSubstr("The text has become 4 blocks"));
  s.click("blocks/undo");
  EXPECT_EQ(s.stage.find("blocks/1"), nullptr);
  EXPECT_EQ(s.tab.desk().programs.texts.text(0), program);
}

TEST_F(BlocksTest, BlocksWithChangesAreNotReplacedByATextWithoutBeingAsked) {
  s.click("blocks/add/delay");
  s.tab.desk().programs.texts.set_text(0, "X100\nEND\n");
  s.stage.frames(2);
  s.click("blocks/from_text");
  s.click("blocks/replace_all/no");
  EXPECT_EQ(text(), "DELAY=500\nEND\n");
  s.click("blocks/from_text");
  s.click("blocks/replace_all/yes");
  s.stage.frames(3);
  EXPECT_EQ(text(), "ABS\nX100\nEND\n");
  EXPECT_THAT(s.toast(),
              HasSubstr("Line 1 moves to a place or by a distance, depending on an earlier setting"));
  s.click("blocks/undo");
  EXPECT_EQ(text(), "DELAY=500\nEND\n");
}

TEST_F(BlocksTest, ATextThatIsNoBlocksReportsWhereAndLeavesThemAlone) {
  s.click("blocks/add/delay");
  s.tab.desk().programs.texts.set_text(0, "X100\nGOSUB 5\nEND\nSUB 5\nX0\nENDSUB\n");
  s.stage.frames(2);
  s.click("blocks/from_text");
  s.click("blocks/replace_all/yes");
  s.stage.frames(3);
  EXPECT_THAT(s.toast(), HasSubstr("Line 4: a subroutine. Blocks have none but those of the tool."));
  EXPECT_EQ(text(), "DELAY=500\nEND\n");
}

TEST_F(BlocksTest, OfThousandsThoseInSightAreDrawn) {
  sequence::Sequence many = s.tab.desk().blocks.editor.sequence();
  for (int i = 0; i < 5000; ++i) many.steps.push_back({sequence::Delay{10.0 + i}});
  s.tab.desk().blocks.editor.load(many);
  s.stage.frames(4);
  EXPECT_EQ(s.value("blocks/1"), "10 ms");
  EXPECT_EQ(s.stage.find("blocks/200"), nullptr);
  EXPECT_LT(s.stage.surface.screen().registry().widgets().size(), 400u);
  s.click("blocks/2");
  s.type("blocks/2/ms", "77");
  s.stage.frames(2);
  EXPECT_THAT(text(), HasSubstr("DELAY=10\nDELAY=77\nDELAY=12\n"));
  const ImVec2 in_list = s.stage.find("blocks/3")->rect.centre();
  s.stage.push(gui::InputEvent::mouse_move(in_list.x, in_list.y, s.stage.now_s));
  s.stage.push(gui::InputEvent::wheel(0, -10'000, s.stage.now_s));
  s.stage.frames(4);
  EXPECT_EQ(s.value("blocks/5000"), "5009 ms");
  EXPECT_TRUE(s.stage.find("blocks/end"));
}

}  // namespace
}  // namespace hw::panels
