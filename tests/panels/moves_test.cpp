#include "panels/moves.h"

#include <imgui_internal.h>

#include "tests/core/session/folder.h"
#include "tests/panels/console_stage.h"
#include "tests/panels/full_catalog.h"
#include "tests/panels/panel_stage.h"

namespace hw::panels {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

struct MovesTest : ::testing::Test {
  MovesTest() {
    s.now.axis_count = 4;
    s.stage.frames(2);
  }
  void add(const char* x, const char* y, const char* speed) {
    s.click("list/add");
    ++rows;
    s.type(cell("x").c_str(), x);
    s.type(cell("y").c_str(), y);
    s.type(cell("speed").c_str(), speed);
  }
  std::string cell(const char* column) { return "list/" + std::to_string(rows) + "/" + column; }
  int rows = 0;
  Moves panel;
  test::PanelStage s{panel, 864, 700, 1, gui::Tier::wide, true, test::full_catalog()};
};

TEST_F(MovesTest, TheListIsFedAsItStands) {
  EXPECT_THAT(s.reason("list/start"), HasSubstr("empty"));
  add("100", "-200", "1500");
  add("300", "0", "2000");
  s.click("list/start");
  const auto* feed = s.last<intent::FeedMoves>();
  ASSERT_TRUE(feed);
  EXPECT_THAT(feed->rows, ElementsAre(ElementsAre(100, -200, 1500), ElementsAre(300, 0, 2000)));
}

TEST_F(MovesTest, ARemovedMoveIsNotSent) {
  add("1", "1", "1000");
  add("2", "2", "1000");
  s.click("list/1/remove");
  s.click("list/start");
  ASSERT_TRUE(s.last<intent::FeedMoves>());
  EXPECT_THAT(s.last<intent::FeedMoves>()->rows, ElementsAre(ElementsAre(2, 2, 1000)));
}

TEST_F(MovesTest, AWrongNumberNamesItsMove) {
  add("1", "1", "0");
  const std::size_t sent = s.sent.size();
  s.click("list/start");
  EXPECT_EQ(s.sent.size(), sent);
  EXPECT_THAT(s.toast(), HasSubstr("Move 1, Speed: 1 to 6"));
}

TEST_F(MovesTest, ProgressIsReportedAndAbortStops) {
  add("1", "1", "1000");
  s.now.feed = {true, 12, 100};
  s.stage.frames(2);
  EXPECT_EQ(s.value("list/progress"), "12 of 100 moves sent");
  EXPECT_THAT(s.reason("list/start"), HasSubstr("is being sent"));
  const std::size_t before = s.sent.size();
  s.click("list/abort");
  ASSERT_EQ(s.sent.size(), before + 2);
  EXPECT_TRUE(std::holds_alternative<intent::Stop>(s.sent[before])) << "the stop goes first";
  ASSERT_TRUE(s.last<intent::Act>());
  EXPECT_EQ(s.catalog.actions[static_cast<std::size_t>(s.last<intent::Act>()->action)].id, "buffer_off");
}

TEST_F(MovesTest, AbortWorksUntilTheBufferIsEmpty) {
  add("1", "1", "1000");
  s.now.feed = {false, 100, 100};
  s.now.axes[0].activity = Activity::moving;
  s.stage.frames(60);
  EXPECT_EQ(s.reason("list/abort"), "No list is being sent.") << "it moves for another reason";
  s.now.feed = {true, 99, 100};
  s.stage.frames(2);
  s.now.feed = {false, 100, 100};
  s.stage.frames(2);
  EXPECT_EQ(s.reason("list/abort"), "") << "the last 36 moves wait in the buffer";
  s.click("list/abort");
  ASSERT_TRUE(s.last<intent::Act>());
  s.now.axes[0].activity = Activity::idle;
  s.stage.frames(2);
  EXPECT_EQ(s.reason("list/abort"), "No list is being sent.");
}

// A short list is sent within one round of questions: nobody sees it on its way.
TEST_F(MovesTest, AbortWorksForAListThatWasSentAtOnce) {
  const auto i = static_cast<std::size_t>(s.catalog.find_readout("BUFFREE"));
  const auto read = [&](int free) {
    s.now.readouts[i] = free;
    s.now.readouts_known[i] = true;
    s.now.readouts_seen_at[i] = Instant(from_seconds(s.stage.now_s));
  };
  add("1", "1", "1000");
  read(36);
  s.stage.frames(2);
  EXPECT_EQ(s.reason("list/abort"), "No list is being sent.");
  s.click("list/start");
  s.now.feed = {false, 5, 5};
  s.settle(IntentState::done);
  s.stage.frames(2);
  EXPECT_EQ(s.reason("list/abort"), "") << "nobody knows yet what waits";
  read(31);
  s.stage.frames(2);
  EXPECT_EQ(s.reason("list/abort"), "");
  read(36);
  s.stage.frames(2);
  EXPECT_EQ(s.reason("list/abort"), "No list is being sent.") << "it is empty, and nothing moves";
}

TEST_F(MovesTest, ARefusedStartHasSentNothing) {
  const auto i = static_cast<std::size_t>(s.catalog.find_readout("BUFFREE"));
  s.now.readouts[i] = 36, s.now.readouts_known[i] = true;
  s.now.readouts_seen_at[i] = Instant(from_seconds(s.stage.now_s));
  add("1", "1", "1000");
  s.stage.frames(2);
  s.click("list/start");
  s.stage.frames(2);
  EXPECT_EQ(s.reason("list/abort"), "") << "it may be on its way";
  s.settle(IntentState::refused, "An axis is in error.");
  s.stage.frames(2);
  EXPECT_EQ(s.reason("list/abort"), "No list is being sent.");
}

TEST_F(MovesTest, AbortStaysWhileTheLinkIsLost) {
  add("1", "1", "1000");
  s.now.feed = {true, 12, 100};
  s.stage.frames(2);
  s.now.feed = {false, 12, 100};
  s.now.link.state = LinkState::lost;
  s.stage.frames(2);
  EXPECT_EQ(s.reason("list/abort"), "") << "the controller may still work on it";
}

TEST_F(MovesTest, TheBufferStandsBesideTheList) {
  const auto i = static_cast<std::size_t>(s.catalog.find_readout("BUFFREE"));
  s.now.readouts[i] = 33;
  s.now.readouts_known[i] = true;
  s.now.readouts_seen_at[i] = Instant(from_seconds(s.stage.now_s));
  s.stage.frames(2);
  EXPECT_EQ(s.value("readout/BUFFREE"), "33");
  EXPECT_EQ(s.stage.find("action/buffer_on/go")->rect.max.x, s.stage.find("list/param/IACC")->rect.max.x);
  s.click("action/buffer_on/go");
  EXPECT_TRUE(s.last<intent::Act>());
  s.click("list/param/IACC");
  ASSERT_TRUE(s.last<intent::SetParam>());
  EXPECT_EQ(s.last<intent::SetParam>()->mnemonic, "IACC");
  EXPECT_EQ(s.last<intent::SetParam>()->value, 1);
}

TEST_F(MovesTest, SavedOpenedAndNew) {
  const test::Folder folder;
  const std::string path = (folder.path() / "square.moves").string();
  add("10", "20", "1000");
  s.click("list/save");
  s.type("file/path", path.c_str());
  s.click("file/save");
  EXPECT_EQ(s.value("list/file"), "square.moves");
  s.click("list/new");
  EXPECT_THAT(s.reason("list/start"), HasSubstr("empty"));
  s.click("list/open");
  s.type("file/path", path.c_str());
  s.click("file/open");
  EXPECT_EQ(s.value("list/1/y"), "20");
}

// What scrolls with the whole panel does not scroll within it too.
TEST(MovesScrolled, HasOneScrollBar) {
  ConsoleStage s(720, 450, 2);
  s.add(test::full_catalog());
  s.run(0.1);
  ASSERT_TRUE(s.hand.click("tab/list"));
  s.run(0.1);
  int side = 0;
  for (const ImGuiWindow* w : ImGui::GetCurrentContext()->Windows) {
    if (!w->Active || std::string_view(w->Name).find("/list/side_") == std::string_view::npos) continue;
    ++side;
    EXPECT_EQ(w->ScrollMax.y, 0);
  }
  EXPECT_EQ(side, 1);
}

TEST(MoveFile, FaultsNameTheLine) {
  const MoveListFacts facts = test::full_catalog().move_list;
  const auto rows = gui::read_moves("; X, Y, Speed\n1, 2, 1000\n\n-5,6,7\n", facts);
  ASSERT_TRUE(rows);
  EXPECT_THAT(*rows, ElementsAre(ElementsAre(1, 2, 1000), ElementsAre(-5, 6, 7)));
  const auto again = gui::read_moves(gui::write_moves(*rows, facts), facts);
  ASSERT_TRUE(again);
  EXPECT_EQ(*again, *rows);
  const auto wrong = gui::read_moves("1, 2, 1000\n1, two, 3\n", facts);
  ASSERT_FALSE(wrong);
  EXPECT_THAT(wrong.error().sentence(), HasSubstr("Line 2: Y \"two\""));
  EXPECT_FALSE(gui::read_moves("1, 2\n", facts));
  EXPECT_FALSE(gui::read_moves("1, 2, 3, 4\n", facts));
}

}  // namespace
}  // namespace hw::panels
