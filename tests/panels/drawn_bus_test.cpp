// A drawing that two emulated controllers of one axis each draw together: what is shown of it beforehand, and
// while it is drawn, in the panel of drawings and on the path of their bus.
#include <gmock/gmock.h>

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

TEST_F(DrawnBusTest, BeforehandItIsRehearsedAndSaidHowFarItLiesBesideItsLines) {
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

TEST_F(DrawnBusTest, WhileItIsDrawnBothTellWhatIsLeft) {
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

TEST_F(DrawnBusTest, ProgramsThatAreSimulatedComeInItsPlace) {
  const std::vector<gui::Tab*> members = console.active()->bus->members;
  MUST(stage.hand.click("tab/path"));
  run(0.3);
  ASSERT_TRUE(stage.find("path/drawn"));
  for (gui::Tab* member : members)
    member->desk().texts.set_text(0, "HSPD=5000\nLSPD=100\nACC=100\nINC\nX400\nWAITX\nEND\n");
  run(0.1);
  EXPECT_TRUE(stage.find("path/drawn")) << "as long as nobody asks for them";
  MUST(stage.hand.click("path/simulate"));
  run(0.5);
  EXPECT_FALSE(stage.find("path/drawn"));
  EXPECT_THAT(value("path/size"), HasSubstr("400"));
}

}  // namespace
}  // namespace hw::panels
