// The path in three axes, and what a hand does with it.
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include "core/device/registry.h"
#include "core/drawing/path_view.h"
#include "core/session/user_files.h"
#include "panels/path/tool_path.h"
#include "tests/panels/panel_stage.h"

namespace hw::panels {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

struct PathInSpaceTest : ::testing::Test {
  PathInSpaceTest() {
    s.now.axis_count = 4;
    s.now.poll_period = std::chrono::hours(1);
    for (AxisState& a : s.now.axes) a.position_known = true, a.activity = Activity::idle;
    s.stage.frames(2);
    s.tab.desk().programs.texts.set_text(
        0, "ABS\nHSPD=5000\nLSPD=100\nACC=100\nX400\nWAITX\nY300\nWAITY\nZ200\nWAITZ\nX0Y0\nWAITX\nEND\n");
    s.stage.frames(2);
    s.click("path/simulate");
    s.stage.frames(4);
    s.click("path/third");
    s.click("path/third/Z");
    s.stage.frames(4);
  }
  std::string looked() { return s.value("path/view"); }
  /// Where a place is drawn while all of the path is shown from there.
  ImVec2 at(drawing::Point3 p, const drawing::ViewDirection& from = drawing::views::iso) {
    drawing::Box3 box;
    box.add(drawing::Point3()), box.add(drawing::Point3{400, 300, 200});
    const gui::Rect r = s.stage.find("path/view")->rect;
    const drawing::PathView view(box, drawing::Projection(box, from, true), r.width(), r.height(), true);
    const drawing::Point px = view.to_px(p);
    return ImVec2(r.min.x + static_cast<float>(px.x), r.min.y + static_cast<float>(px.y));
  }
  /// Not so soon behind another that the two are a double click.
  void click_on(ImVec2 p) {
    s.stage.now_s += 1;
    s.stage.frames(1);
    s.click_at(p);
  }
  void drag(ImVec2 from, ImVec2 by, int button = 0) {
    s.stage.now_s += 1;
    s.stage.frames(1);
    s.stage.push(gui::InputEvent::mouse_move(from.x, from.y, s.stage.now_s));
    s.stage.frames(1);
    s.stage.push(gui::InputEvent::mouse_button(button, true, from, s.stage.now_s));
    s.stage.frames(2);
    const ImVec2 to(from.x + by.x, from.y + by.y);
    s.stage.push(gui::InputEvent::mouse_move(to.x, to.y, s.stage.now_s));
    s.stage.frames(2);
    s.stage.push(gui::InputEvent::mouse_button(button, false, to, s.stage.now_s));
    s.stage.frames(3);
  }
  void key(const char* chord) {
    ASSERT_TRUE(s.stage.hand.key(chord));
    s.stage.frames(2);
  }
  int inked_around(ImVec2 p) {
    s.stage.surface.render();
    const ImU32 ink = s.stage.surface.screen().theme()[gui::Tone::ink];
    int inked = 0;
    for (int y = -3; y <= 3; ++y)
      for (int x = -3; x <= 3; ++x)
        inked += s.stage.surface.pixel(static_cast<int>(p.x) + x, static_cast<int>(p.y) + y) == ink;
    return inked;
  }
  const DeviceType& type = *find_device_type("pmx-4ex-sa");
  ToolPath panel;
  test::PanelStage s{panel, 864, 620, 1, gui::Tier::wide, true, *type.make_catalog({}), &type.language()};
};

TEST_F(PathInSpaceTest, IsDrawnInPerspectiveAndMeasured) {
  EXPECT_EQ(s.value("path/size"), "400 x 300 x 200 pulses");
  EXPECT_EQ(s.value("path/way_on"), "1400 pulses");
  EXPECT_THAT(looked(), StartsWith("turned 45, tilted 35"));
  EXPECT_GE(inked_around(at({400, 150, 0})), 2);
  EXPECT_GE(inked_around(at({400, 300, 100})), 2);
  EXPECT_EQ(inked_around(at({200, 300, 0})), 0);
  EXPECT_EQ(s.value("path/view/here"), "0 pulses, 0 pulses, 0 pulses");
}

TEST_F(PathInSpaceTest, StandardViewsHaveButtonsAndKeys) {
  s.click("path/view/top");
  EXPECT_THAT(looked(), StartsWith("turned 0, tilted 90"));
  EXPECT_GE(inked_around(at({400, 150, 0}, drawing::views::top)), 2);
  s.click("path/view/side");
  EXPECT_THAT(looked(), StartsWith("turned 90, tilted 0"));
  click_on(at({400, 300, 100}, drawing::views::side));
  key("f");
  EXPECT_THAT(looked(), StartsWith("turned 0, tilted 0"));
  key("i");
  EXPECT_THAT(looked(), StartsWith("turned 45, tilted 35"));
  key("alt+shift+right");
  EXPECT_THAT(looked(), StartsWith("turned 60, tilted 35"));
  key("alt+shift+up");
  EXPECT_THAT(looked(), StartsWith("turned 60, tilted 50"));
  key("t");
  EXPECT_THAT(looked(), StartsWith("turned 0, tilted 90"));
  EXPECT_TRUE(s.sent.empty()) << "nothing has jogged";
}

TEST_F(PathInSpaceTest, ADragTurnsItAboutWhatIsUnderTheHand) {
  const ImVec2 corner = at({400, 300, 200});
  drag(corner, ImVec2(50, 25));
  EXPECT_THAT(looked(), StartsWith("turned 25, tilted 45"));
  // What it was turned about still lies there; a click tells.
  click_on(corner);
  EXPECT_THAT(s.value("path/hit"),
              testing::ContainsRegex("X (399|400) pulses, Y (299|300) pulses, Z (199|200) pulses"));
  EXPECT_GE(inked_around(corner), 2);
}

TEST_F(PathInSpaceTest, WithShiftOrAnotherButtonADragMovesIt) {
  const std::string before = looked();
  const ImVec2 middle = at({400, 150, 0});
  drag(middle, ImVec2(40, -30), 1);
  EXPECT_EQ(looked(), before);
  click_on(ImVec2(middle.x + 40, middle.y - 30));
  EXPECT_THAT(s.value("path/hit"), HasSubstr("Line 7: Y300"));
  s.stage.push(gui::InputEvent::key(GLFW_KEY_LEFT_SHIFT, true, s.stage.now_s));
  drag(ImVec2(middle.x + 40, middle.y - 30), ImVec2(-40, 30));
  s.stage.push(gui::InputEvent::key(GLFW_KEY_LEFT_SHIFT, false, s.stage.now_s));
  EXPECT_EQ(looked(), before);
  click_on(middle);
  EXPECT_THAT(s.value("path/hit"), HasSubstr("Line 7: Y300"));
}

TEST_F(PathInSpaceTest, AClickShowsTheLine) {
  click_on(at({400, 300, 120}));
  EXPECT_THAT(s.value("path/hit"), HasSubstr("Line 9: Z200"));
  EXPECT_THAT(s.value("path/hit"), HasSubstr("X 400 pulses, Y 300 pulses, Z 1"));
}

TEST_F(PathInSpaceTest, MeasuresBetweenWhatIsOnThePathOnly) {
  s.click("path/measure");
  click_on(at({400, 0, 0}));
  EXPECT_EQ(s.value("path/hit"), "Click the end of the distance.");
  click_on(ImVec2(at({}).x - 30, at({}).y + 20));
  EXPECT_EQ(s.value("path/hit"), "Click the end of the distance.") << "there is nothing, and so no depth";
  click_on(at({400, 300, 200}));
  EXPECT_EQ(s.value("path/hit"), "X 0 pulses, Y 300 pulses, Z 200 pulses - 361 pulses straight");
}

TEST_F(PathInSpaceTest, WhileItIsTurnedAFewLinesShowTheWay) {
  const ImVec2 middle = at({400, 150, 0});
  s.stage.push(gui::InputEvent::mouse_move(middle.x, middle.y, s.stage.now_s));
  s.stage.frames(1);
  s.stage.push(gui::InputEvent::mouse_button(0, true, middle, s.stage.now_s));
  s.stage.frames(2);
  s.stage.push(gui::InputEvent::mouse_move(middle.x + 50, middle.y + 20, s.stage.now_s));
  s.stage.frames(1);
  EXPECT_GE(inked_around(middle), 2) << "in the very frame that turns it";
  s.stage.push(gui::InputEvent::mouse_button(0, false, middle, s.stage.now_s));
  s.stage.frames(6);
  EXPECT_GT(s.stage.surface.screen().wake_in_s(), 1.0) << "at rest nothing is drawn anew";
}

TEST_F(PathInSpaceTest, TwoAxesComeBackAsTheyWere) {
  s.click("path/third");
  s.click("path/third/2 axes");
  s.stage.frames(4);
  EXPECT_EQ(s.value("path/size"), "400 x 300 pulses");
  EXPECT_THAT(looked(), HasSubstr("pulses a pixel"));
  EXPECT_THAT(looked(), testing::Not(HasSubstr("turned")));
  EXPECT_FALSE(s.stage.find("path/view/top"));
}

TEST_F(PathInSpaceTest, IsSavedAsItIsSeen) {
  s.click("path/view/front");
  const auto file = std::filesystem::temp_directory_path() / "hw_path_space_test.svg";
  std::filesystem::remove(file);
  s.click("path/save");
  s.type("file/path", file.c_str());
  s.click("file/save");
  s.stage.frames(3);
  const auto text = read_file(file, 1'000'000);
  ASSERT_TRUE(text) << text.error().sentence();
  EXPECT_THAT(*text, HasSubstr("<g id=\"rehearsed\""));
  EXPECT_THAT(*text, HasSubstr("width=\"800\"")) << "a length on it is none of an axis";
  std::filesystem::remove(file);
}

TEST_F(PathInSpaceTest, ATraceThatLeavesWhatWasShownIsSeenToo) {
  for (int z = 0; z <= 20'000; z += 500) {
    s.now.axes[2].position = Steps(z);
    s.stage.frames(1);
  }
  s.stage.frames(3);
  EXPECT_EQ(s.value("path/view/here"), "0 pulses, 0 pulses, 20000 pulses");
  s.click("path/fit");
  s.stage.frames(3);
  const gui::Rect view = s.stage.find("path/view")->rect, here = s.stage.find("path/view/here")->rect;
  EXPECT_TRUE(view.contains(here.centre()));
}

}  // namespace
}  // namespace hw::panels
