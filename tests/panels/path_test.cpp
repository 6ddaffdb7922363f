// The path of a rehearsed program, and what a hand does with it.
#include <algorithm>
#include <cmath>

#include "core/device/registry.h"
#include "core/session/user_files.h"
#include "panels/path/tool_path.h"
#include "tests/panels/panel_stage.h"

namespace hw::panels {
namespace {

using ::testing::HasSubstr;

struct PathTest : ::testing::Test {
  PathTest() {
    s.now.axis_count = 2;
    for (AxisState& a : s.now.axes) a.position_known = true, a.activity = Activity::idle;
    s.stage.frames(2);
  }
  void rehearse(const char* text) {
    s.tab.desk().programs.texts.set_text(0, text);
    s.stage.frames(2);
    s.click("path/simulate");
    s.stage.frames(4);
  }
  /// The middle of the view, moved by so many pixels.
  ImVec2 in_view(float right, float down) {
    const gui::Rect r = s.stage.find("path/view")->rect;
    return ImVec2(r.centre().x + right, r.centre().y + down);
  }
  double per_px() { return std::stod(s.value("path/view")); }
  const DeviceType& type = *find_device_type("vxm");
  ToolPath panel;
  test::PanelStage s{panel, 864, 620, 1, gui::Tier::wide, true, *type.make_catalog({}), &type.language()};
};

TEST_F(PathTest, ASquareIsDrawnAndMeasured) {
  EXPECT_THAT(s.reason("path/simulate"), HasSubstr("empty"));
  rehearse("I1M400,\nI2M400,\nI1M-400,\nI2M-400,\n");
  EXPECT_EQ(s.value("path/size"), "400 x 400 steps");
  EXPECT_EQ(s.value("path/way_on"), "1600 steps");
  s.stage.surface.render();
  // Its right side stands half a square right of the middle.
  const ImVec2 side = in_view(static_cast<float>(200 / per_px()), 0);
  const ImU32 ink = s.stage.surface.screen().theme()[gui::Tone::ink];
  int inked = 0;
  for (int x = -3; x <= 3; ++x)
    inked += s.stage.surface.pixel(static_cast<int>(side.x) + x, static_cast<int>(side.y) + 20) == ink;
  EXPECT_GE(inked, 1);
}

TEST_F(PathTest, F5ShowsWhyNothingIsRehearsed) {
  ASSERT_TRUE(s.stage.hand.key("F5"));
  s.stage.frames(2);
  EXPECT_THAT(s.toast(), HasSubstr("The program is empty."));
}

TEST_F(PathTest, AClickShowsTheLineAndTheEditorGoesThere) {
  rehearse("; first a remark\nI1M400,\nI2M400,\n");
  const auto half = static_cast<float>(200 / per_px());
  s.click_at(in_view(half, 0));  // the second leg goes up at the right
  EXPECT_THAT(s.value("path/hit"), HasSubstr("Line 3: I2M400,"));
  EXPECT_THAT(s.value("path/hit"), HasSubstr("1 400 steps, 2 "));
  s.click("path/show_line");
  EXPECT_EQ(s.tab.desk().programs.wanted_line, 2);
  s.tab.desk().programs.texts.set_text(0, "I1M400,\nI2M400,\n");
  s.stage.frames(2);
  EXPECT_THAT(s.reason("path/show_line"), HasSubstr("changed since"));
}

TEST_F(PathTest, AClickLeadsToItsBlockAndAChosenBlockIsLit) {
  gui::Desk& desk = s.tab.desk();
  sequence::Sequence blocks = desk.blocks.editor.sequence();
  for (const int axis : {0, 1}) {
    sequence::Move move;
    move.to[static_cast<std::size_t>(axis)] = 400;
    blocks.steps.push_back(sequence::Step{move});
  }
  desk.blocks.became(std::move(blocks));
  const auto written = desk.programs.language()->write(desk.blocks.editor.sequence(), s.tab.catalog());
  ASSERT_TRUE(written);
  rehearse(written->text.c_str());
  s.click_at(in_view(static_cast<float>(200 / per_px()), 0));
  s.click("path/show_block");
  EXPECT_EQ(desk.blocks.wanted_step, 1);
  desk.blocks.chosen_step = 0;
  s.stage.frames(2);
  EXPECT_THAT(s.value("path/hit"), HasSubstr("Line 1"));
}

TEST_F(PathTest, WheelKeysAndDragMoveTheView) {
  rehearse("I1M400,\nI2M400,\n");
  const double before = per_px();
  const ImVec2 middle = in_view(0, 0);
  s.stage.push(gui::InputEvent::mouse_move(middle.x, middle.y, s.stage.now_s));
  s.stage.frames(1);
  s.stage.push(gui::InputEvent::wheel(0, 2, s.stage.now_s));
  s.stage.frames(2);
  EXPECT_LT(per_px(), before * 0.8);
  s.click("path/further");
  s.click("path/fit");
  s.stage.frames(2);
  EXPECT_NEAR(per_px(), before, before * 0.01);
}

TEST_F(PathTest, PointerMotionWithThePressIsNoDrag) {
  rehearse("I1M400,\nI2M400,\n");
  const auto half = static_cast<float>(200 / per_px());
  const ImVec2 side = in_view(half, 0);
  s.stage.push(gui::InputEvent::mouse_move(20, 20, s.stage.now_s));
  s.stage.frames(1);
  s.stage.push(gui::InputEvent::mouse_move(side.x, side.y, s.stage.now_s));
  s.stage.push(gui::InputEvent::mouse_button(0, true, side, s.stage.now_s));
  s.stage.frames(1);
  s.stage.push(gui::InputEvent::mouse_button(0, false, side, s.stage.now_s));
  s.stage.frames(2);
  EXPECT_THAT(s.value("path/hit"), HasSubstr("Line 2")) << "the view stands where it stood";
  s.stage.push(gui::InputEvent::mouse_move(20, 20, s.stage.now_s));
  s.stage.frames(1);
  s.click_at(side);
  EXPECT_THAT(s.value("path/hit"), HasSubstr("Line 2"));
}

TEST_F(PathTest, ArrowsWithAltMoveTheViewAndJogNothing) {
  rehearse("I1M400,\nI2M400,\n");
  const auto half = static_cast<float>(200 / per_px());
  s.click_at(in_view(half, 0));
  ASSERT_THAT(s.value("path/hit"), HasSubstr("Line 2"));
  ASSERT_TRUE(s.stage.hand.key("alt+right"));
  s.stage.frames(2);
  const std::string before = s.value("path/hit");
  s.stage.now_s += 1;
  s.stage.frames(1);
  s.click_at(in_view(half - 40, -half / 2));
  EXPECT_THAT(s.value("path/hit"), HasSubstr("Line 2"));
  EXPECT_NE(s.value("path/hit"), before) << "a hit of its own, further up";
  EXPECT_TRUE(s.sent.empty());
}

TEST_F(PathTest, WhyNothingCouldBeRehearsedIsReportedHere) {
  rehearse("I1M400,\nnonsense\n");
  EXPECT_THAT(s.value("path/refusal"), HasSubstr("Line 2"));
  rehearse("I1M400,\nI2M300,\n");
  EXPECT_FALSE(s.stage.find("path/refusal"));
}

TEST_F(PathTest, TwoClicksMeasure) {
  rehearse("I1M400,\nI2M300,\n");
  const auto right = static_cast<float>(200 / per_px()), up = static_cast<float>(150 / per_px());
  s.click("path/measure");
  EXPECT_THAT(s.value("path/hit"), HasSubstr("of the distance."));
  s.click_at(in_view(-right, up));
  s.click_at(in_view(right, -up));
  EXPECT_EQ(s.value("path/hit"), "1 400 steps, 2 300 steps - 500 steps straight - 36.9deg");
  s.click("path/measure");
  EXPECT_EQ(s.value("path/hit"), "");
}

TEST_F(PathTest, AClickOnTheTraceShowsWhenTheAxesWereThere) {
  s.now.poll_period = std::chrono::hours(1);
  s.now.at = s.tab.clock();
  for (int x = 0; x <= 300; x += 10) {
    s.now.axes[0].position = Steps(x);
    s.stage.frames(1);
  }
  s.click("path/fit");
  s.stage.frames(2);
  s.stage.now_s += 20;
  s.stage.frames(2);
  s.click_at(in_view(0, 0));
  EXPECT_THAT(s.value("path/hit"),
              testing::MatchesRegex("1 1[0-9]+ steps, 2 0 steps . was there 2[0-9] s ago"));
}

TEST_F(PathTest, ItIsSavedAsLinesOrAsPixels) {
  EXPECT_THAT(s.reason("path/save"), HasSubstr("no path yet"));
  rehearse("I1M400,\nI2M400,\n");
  for (const char* name : {"hw_path_test.svg", "hw_path_test.png"}) {
    const auto file = std::filesystem::temp_directory_path() / name;
    std::filesystem::remove(file);
    s.click("path/save");
    s.type("file/path", file.c_str());
    s.click("file/save");
    s.stage.frames(3);
    const auto bytes = read_file(file, 10'000'000);
    ASSERT_TRUE(bytes) << bytes.error().sentence();
    EXPECT_THAT(bytes->substr(0, 8), testing::AnyOf(HasSubstr("<?xml"), HasSubstr("PNG")));
    std::filesystem::remove(file);
  }
}

TEST_F(PathTest, AFailedSavingIsForgottenWithTheNext) {
  rehearse("I1M400,\nI2M400,\n");
  const auto file = std::filesystem::temp_directory_path() / "hw_path_again.svg";
  const auto save = [&](const std::filesystem::path& as) {
    s.click("path/save");
    s.type("file/path", as.c_str());
    s.click("file/save");
    s.stage.frames(3);
  };
  save(std::filesystem::temp_directory_path() / (std::string(300, 'a') + ".svg"));  // too long a name
  const auto failed = [&] {
    const auto& list = s.console.toasts().list();
    return std::any_of(list.begin(), list.end(),
                       [](const auto& toast) { return toast.severity == gui::Severity::fault; });
  };
  EXPECT_TRUE(failed());
  save(file);
  EXPECT_FALSE(failed()) << s.toast();
  std::filesystem::remove(file);
}

TEST_F(PathTest, AtRestNothingIsDrawnAnew) {
  rehearse("I1M400,\nI2M400,\n");
  s.stage.frames(5);
  EXPECT_GT(s.stage.surface.screen().wake_in_s(), 1.0);
}

TEST_F(PathTest, WhereItHasBeenIsShownWithoutARehearsal) {
  s.now.poll_period = std::chrono::hours(1);
  for (int x = 0; x <= 300; x += 10) {
    s.now.axes[0].position = Steps(x);
    s.stage.frames(1);
  }
  EXPECT_EQ(s.tab.desk().records.trace.places().size(), 31u);
  s.click("path/fit");
  s.stage.frames(2);
  EXPECT_EQ(s.value("path/view/here"), "300 steps, 0 steps");
  s.now.poll_period = Duration{};
  s.stage.frames(2);
  EXPECT_EQ(s.value("path/view/here"), "300 steps, 0 steps?") << "it is old";
  s.click("path/forget");
  EXPECT_LE(s.tab.desk().records.trace.places().size(), 1u);
}

}  // namespace
}  // namespace hw::panels
