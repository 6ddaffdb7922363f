// A drawing that two emulated controllers of one axis each draw together: what is shown of it beforehand, and
// while it is drawn, in the panel of drawings and on the path of their bus.
#include <gmock/gmock.h>

#include "core/sequence/sequence.h"
#include "core/session/session.h"
#include "core/time/virtual_scheduler.h"
#include "gui/model/bus.h"
#include "gui/shell/console.h"
#include "gui/shell/outside.h"
#include "panels/panel_list.h"
#include "tests/gui/stage.h"
#include "tests/panels/drawing_stage.h"
#include "tests/panels/must.h"
#include "transports/open.h"

namespace hw::panels {
namespace {

using ::testing::HasSubstr;

class DrawnBusTest : public testing::Test {
 protected:
  IoContext io;
  VirtualScheduler time{io};
  gui::Console console{panel_list(), gui::Outside(time, make_wire_opener(), [] {})};
  gui::Stage stage{[this](gui::Ui& ui) {
                     time.run_until(Instant(from_seconds(stage.now_s)));
                     console.draw(ui);
                   },
                   1440, 1400};
  const std::filesystem::path file = std::filesystem::temp_directory_path() / "hw_drawn_bus.dxf";

  void SetUp() override {
    ASSERT_TRUE(write_file(file, square_and_text));
    console.attach(stage.surface.screen().keyboard());
    const auto tab = console.open("dmx-k-sa@emulator,id=01-02,wire=real");
    ASSERT_TRUE(tab) << tab.error().sentence();
    run(3);
    for (gui::Tab* member : (*tab)->bus->members) {
      member->session()->send_text("SL=0", false);  // else DO1 shows whether it is in position
      member->send(intent::SetPower(-1, true));
    }
    run(3);
    MUST(stage.hand.click("tab/drawing"));
    (*tab)->desk().dropped["drawing"].push_back(file);
    run(0.5);
    MUST(stage.hand.click("drawing/tool"));
    MUST(stage.hand.click("drawing/tool/DO1"));
    run(0.5);
  }
  ~DrawnBusTest() override {
    console.close_all();
    time.run_until(time.now() + std::chrono::seconds(10), [this] { return console.closing() == 0; });
    std::filesystem::remove(file);
  }
  void run(double seconds) { stage.frames(static_cast<int>(seconds * 60 + 0.5)); }
  std::string value(std::string_view id) { return stage.hand.value(id).value_or("(none)"); }
  void cut() {
    MUST(stage.hand.click("drawing/cut"));
    run(0.2);
    MUST(stage.hand.click("drawing/ask_cut/yes"));
    run(2);
  }
};

TEST_F(DrawnBusTest, BeforehandItIsRehearsedAndItsDistanceFromItsLinesIsReported) {
  EXPECT_EQ(value("drawing/time").find("at least"), std::string::npos) << value("drawing/time");
  EXPECT_THAT(value("drawing/beside"), testing::MatchesRegex("0\\.[0-9]+ mm at most"));
  EXPECT_NE(value("drawing/beside"), "0.000 mm at most");
}

TEST_F(DrawnBusTest, ItStaysWhicheverControllerIsChosen) {
  ASSERT_EQ(value("drawing/size"), "20.000 x 10.000 mm");
  MUST(stage.hand.click("bus/02"));
  run(0.2);
  if (!stage.find("drawing/size")) MUST(stage.hand.click("tab/drawing"));
  run(0.2);
  EXPECT_EQ(value("drawing/size"), "20.000 x 10.000 mm");
  console.active()->desk().dropped["drawing"].push_back(file);
  run(0.5);
  EXPECT_EQ(value("drawing/size"), "20.000 x 10.000 mm");
  EXPECT_TRUE(console.active()->desk().dropped["drawing"].empty());
}

TEST_F(DrawnBusTest, ThePathOfTheBusIsTheOneOfTheDrawing) {
  const std::string time = value("drawing/time");
  MUST(stage.hand.click("tab/path"));
  run(0.3);
  EXPECT_THAT(value("path/drawn"), HasSubstr("hw_drawn_bus.dxf"));
  EXPECT_EQ(value("path/time"), time);
  EXPECT_THAT(value("path/size"), HasSubstr("3000"));
  EXPECT_THAT(value("path/way_on"), HasSubstr("pulses"));
  EXPECT_FALSE(stage.find("path/left")) << "it is not at work";
}

TEST_F(DrawnBusTest, WhileItIsDrawnBothShowWhatIsLeft) {
  ASSERT_NO_FATAL_FAILURE(cut());
  EXPECT_THAT(value("drawing/cut_progress"), HasSubstr(" left"));
  MUST(stage.hand.click("tab/path"));
  run(0.3);
  const std::string before = value("path/left");
  ASSERT_NE(before, "(none)");
  run(3);
  EXPECT_NE(value("path/left"), before);
  run(60);
  EXPECT_FALSE(stage.find("path/left"));
}

TEST_F(DrawnBusTest, OfARunBegunElsewhereItDoesNotShowWhatIsLeft) {
  ASSERT_NO_FATAL_FAILURE(cut());
  ASSERT_THAT(value("drawing/cut_progress"), HasSubstr(" left"));
  console.active()->bus->begun = std::make_shared<const sequence::Sequence>();
  run(0.1);
  EXPECT_THAT(value("drawing/cut_progress"), testing::Not(HasSubstr(" left")));
}

TEST_F(DrawnBusTest, FromAPlaceOnItsPathTheRestIsDrawnBehindTheWayThere) {
  const std::vector<gui::Tab*> members = console.active()->bus->members;
  MUST(stage.hand.click("tab/path"));
  run(0.5);
  // The side that goes up at 30 mm; all of it lies between 0, 0 and 3000, 2000.
  const gui::Rect view = stage.find("path/view")->rect;
  const double per_px = std::stod(value("path/view"));
  const ImVec2 side(view.centre().x + static_cast<float>(1500 / per_px),
                    view.centre().y - static_cast<float>(600 / per_px));
  stage.push(gui::InputEvent::mouse_move(side.x, side.y, stage.now_s));
  run(0.1);
  stage.push(gui::InputEvent::mouse_button(0, true, side, stage.now_s));
  run(0.05);
  stage.push(gui::InputEvent::mouse_button(0, false, side, stage.now_s));
  run(0.2);
  ASSERT_THAT(value("path/hit"), HasSubstr("Step ")) << value("path/hit");
  MUST(stage.hand.click("path/run_here"));
  run(0.3);
  const std::string asked = value("path/run_from/says");
  EXPECT_THAT(asked, HasSubstr("The axes stand here: 01 at 0 pulses, 02 at 0 pulses."));
  EXPECT_THAT(asked, HasSubstr("and everything after it."));
  EXPECT_FALSE(console.active()->bus->pieces().running) << "nothing is done before it is agreed to";
  MUST(stage.hand.click("path/run_from/yes"));
  run(2);
  EXPECT_TRUE(console.active()->bus->pieces().running);
  EXPECT_TRUE(stage.find("path/left"));
  run(60);
  EXPECT_FALSE(console.active()->bus->pieces().running);
  EXPECT_GT(members[0]->now().axes[0].position.value, 1500) << "it has been there";
}

TEST_F(DrawnBusTest, OnItsPathTheMarkOfTheToolShowsWhetherItIsOn) {
  ASSERT_NO_FATAL_FAILURE(cut());
  MUST(stage.hand.click("tab/path"));
  bool on = false, off = false;
  for (int i = 0; i < 60; ++i) {
    run(0.5);
    const std::string here = value("path/view/here");
    on = on || here.find("tool on") != std::string::npos;
    off = off || here.find("tool off") != std::string::npos;
  }
  EXPECT_TRUE(on);
  EXPECT_TRUE(off);
}

TEST_F(DrawnBusTest, ADotIsDrawnWithWhatFollowsItAndTakesNoTimesAway) {
  std::string with_dot(square_and_text);
  with_dot.insert(with_dot.find("0\nTEXT"), "0\nPOINT\n8\ncut\n10\n25\n20\n18\n");
  ASSERT_TRUE(write_file(file, with_dot));
  console.active()->desk().dropped["drawing"].push_back(file);
  run(0.5);
  ASSERT_THAT(value("drawing/chains"), testing::StartsWith("3"));
  for (const char* chain : {"drawing/chain/1", "drawing/chain/2", "drawing/chain/3"})
    EXPECT_EQ(value(chain).find("?"), std::string::npos) << value(chain);
  ASSERT_NO_FATAL_FAILURE(cut());
  EXPECT_THAT(value("drawing/cut_progress"), HasSubstr(" left"));
}

TEST_F(DrawnBusTest, ProgramsThatAreSimulatedComeInItsPlace) {
  const std::vector<gui::Tab*> members = console.active()->bus->members;
  MUST(stage.hand.click("tab/path"));
  run(0.3);
  ASSERT_TRUE(stage.find("path/drawn"));
  for (gui::Tab* member : members)
    member->desk().programs.texts.set_text(0, "HSPD=5000\nLSPD=100\nACC=100\nINC\nX400\nWAITX\nEND\n");
  run(0.1);
  EXPECT_TRUE(stage.find("path/drawn")) << "as long as nobody asks for them";
  MUST(stage.hand.click("path/simulate"));
  run(0.5);
  EXPECT_FALSE(stage.find("path/drawn"));
  EXPECT_THAT(value("path/size"), HasSubstr("400"));
}

}  // namespace
}  // namespace hw::panels
