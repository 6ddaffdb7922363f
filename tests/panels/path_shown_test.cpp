// What a path shows beside the way itself: age, limits, tool, time; and what goes into its file.
#include "core/device/registry.h"
#include "core/session/user_files.h"
#include "panels/path/path_trace.h"
#include "panels/path/tool_path.h"
#include "tests/panels/panel_stage.h"

namespace hw::panels {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

struct PathShownTest : ::testing::Test {
  explicit PathShownTest(const char* model = "vxm") : type(*find_device_type(model)) {
    s.now.axis_count = static_cast<int>(s.tab.catalog().axes.size());
    s.now.poll_period = std::chrono::hours(1);
    for (AxisState& a : s.now.axes) a.position_known = true, a.activity = Activity::idle;
    s.stage.frames(2);
  }
  void rehearse(const std::string& text) {
    s.tab.desk().programs.texts.set_text(0, text);
    s.stage.frames(2);
    s.click("path/simulate");
    s.stage.frames(4);
  }
  /// The first axis goes there in steps of 10, the time by a tenth of a second with each.
  void walk_to(int x, double step_s = 0.1) {
    int at = static_cast<int>(s.now.axes[0].position.value);
    const int by = x > at ? 10 : -10;
    for (; at != x; s.now.at += from_seconds(step_s)) {
      at += by;
      s.now.axes[0].position = Steps(at);
      s.stage.frames(1);
    }
  }
  double per_px() { return std::stod(s.value("path/view")); }
  gui::Rect view() { return s.stage.find("path/view")->rect; }
  /// Pixels of that colour in a column of the view, some around its middle.
  int coloured(ImVec2 p, ImU32 colour) {
    s.stage.surface.render();
    int n = 0;
    for (int y = -4; y <= 4; ++y)
      n += s.stage.surface.pixel(static_cast<int>(p.x), static_cast<int>(p.y) + y) == colour;
    return n;
  }
  std::string saved(const char* name) {
    const auto file = std::filesystem::temp_directory_path() / name;
    std::filesystem::remove(file);
    s.click("path/save");
    s.type("file/path", file.c_str());
    s.click("file/save");
    s.stage.frames(3);
    const auto text = read_file(file, 10'000'000);
    std::filesystem::remove(file);
    return text ? *text : text.error().sentence();
  }
  const DeviceType& type;
  ToolPath panel;
  test::PanelStage s{panel, 900, 620, 1, gui::Tier::wide, true, *type.make_catalog({}), &type.language()};
};

// ---- rulers

TEST_F(PathShownTest, TheRulerIsAsWideAsItsNumbers) {
  s.stage.frames(2);
  const float usual = view().min.x;
  s.now.axes[1].position = Steps(123'456'789'012);
  s.click("path/fit");
  s.stage.frames(3);
  EXPECT_GT(view().min.x, usual + 20);
  s.stage.surface.render();
  const ImU32 ground = s.stage.surface.pixel(2, static_cast<int>(view().max.y) + 12);
  for (int y = static_cast<int>(view().min.y) + 24; y < static_cast<int>(view().max.y); ++y)
    ASSERT_EQ(s.stage.surface.pixel(2, y), ground) << "a number is cut off at " << y;
  s.now.axes[1].position = Steps(0);
  s.stage.frames(1);
  s.click("path/forget");
  s.click("path/fit");
  s.stage.frames(3);
  EXPECT_EQ(view().min.x, usual);
}

// ---- age

TEST_F(PathShownTest, WhereItHasBeenFadesWithItsAge) {
  for (AxisState& a : s.now.axes) a.position = Steps(-500);
  s.now.axes[1].position = Steps(100);
  s.stage.frames(1);
  s.tab.desk().records.trace.clear();
  walk_to(0, 4);      // 200 s
  walk_to(400, 0.1);  // and 4 s
  s.click("path/fit");
  s.stage.frames(4);
  const auto& ui = s.stage.surface.screen();
  const gui::Theme& theme = ui.theme();
  // From -500 to 400 at 100, all of it with the origin in the view.
  const double middle = -50;
  const auto at = [&](double x) {
    return ImVec2(view().centre().x + static_cast<float>((x - middle) / per_px()),
                  view().centre().y - static_cast<float>(50 / per_px()));
  };
  EXPECT_GE(coloured(at(200), theme[gui::Tone::motion]), 1) << "the newest is brightest";
  EXPECT_EQ(coloured(at(-400), theme[gui::Tone::motion]), 0) << "what is older is paler";
  EXPECT_TRUE(s.stage.find("path/legend/trace"));
}

TEST(PathTrace, AgesAreReportedFromItsNewestRun) {
  drawing::ToolPath trace;
  for (int t = 0; t < 1000; ++t) trace.go({t * 1.0, 0}, {t + 1.0, 0}, true, t);
  const TraceAges ages = ages_of(trace);
  EXPECT_EQ(ages.begin, (std::array<std::size_t, 4>{0, 399, 939, 989}));
  EXPECT_EQ(ages_of({}).begin, (std::array<std::size_t, 4>{}));
}

// ---- limits

TEST_F(PathShownTest, FitTableShowsTheLimitsThatAreKnown) {
  rehearse("I1M400,\nI2M400,\n");
  EXPECT_THAT(s.reason("path/fit_table"), HasSubstr("No limit"));
  s.bench.present = true;
  s.bench.switches[0] = {Steps(-1000), Steps(3000), {}, {}};
  s.bench.switches[1] = {Steps(-1000), Steps(2000), {}, {}};
  s.stage.frames(3);
  const double near = per_px();
  EXPECT_EQ(s.reason("path/fit_table"), "");
  s.click("path/fit_table");
  s.stage.frames(3);
  EXPECT_GT(per_px(), 3 * near);
  EXPECT_GT(per_px() * view().width(), 4000);
  // The frame ends at its corners: left of the lower limit of the first axis the second one's is not drawn.
  const ImU32 amber = s.stage.surface.screen().theme()[gui::Tone::warn];
  const auto at = [&](double x, double y) {
    return ImVec2(view().centre().x + static_cast<float>((x - 1000) / per_px()),
                  view().centre().y - static_cast<float>((y - 500) / per_px()));
  };
  EXPECT_GE(coloured(at(2000, 2000), amber), 1);
  EXPECT_EQ(coloured(at(-1080, 2000), amber), 0);
  s.click("path/fit");
  s.stage.frames(3);
  EXPECT_NEAR(per_px(), near, near * 0.01);
}

TEST_F(PathShownTest, TheTravelThatTheUserHasSetIsALimitToo) {
  s.now.axes[0].travel.has_plus = true;
  s.now.axes[0].travel.plus = Steps(5000);
  s.stage.frames(2);
  s.click("path/fit_table");
  s.stage.frames(3);
  EXPECT_GT(per_px() * view().width(), 5000);
  walk_to(100);
  EXPECT_THAT(saved("hw_path_travel.svg"), HasSubstr("5000,"));
}

TEST_F(PathShownTest, FitHasTheOriginInView) {
  for (AxisState& a : s.now.axes) a.position = Steps(4000);
  s.stage.frames(2);
  s.click("path/fit");
  s.stage.frames(3);
  EXPECT_GT(per_px() * view().height(), 4000);
}

// ---- the tool

struct PathToolTest : PathShownTest {
  PathToolTest() : PathShownTest("pmx-4ex-sa") {}
};

TEST_F(PathToolTest, IsThatOfTheBlocksWithoutBeingChosen) {
  sequence::Sequence drawn = s.tab.desk().blocks.editor.sequence();
  sequence::Move there, on;
  there.to[0] = 1000, on.to[0] = 3000;
  drawn.steps = {{sequence::Speed{{5000, 100, 100}}},
                 {sequence::Pen{false}},
                 {there},
                 {sequence::WaitMotion{}},
                 {sequence::Pen{true}},
                 {on},
                 {sequence::WaitMotion{}},
                 {sequence::Pen{false}}};
  drawn.pen_up = {{sequence::Output{5, false}}}, drawn.pen_down = {{sequence::Output{5, true}}};
  s.tab.desk().blocks.editor.load(drawn);
  const auto written = type.language().write(drawn, s.tab.catalog());
  ASSERT_TRUE(written) << written.error().sentence();
  rehearse(written->text);
  EXPECT_EQ(s.value("path/way_on"), "2000 pulses");
  EXPECT_EQ(s.value("path/way_off"), "1000 pulses");
  const std::string svg = saved("hw_path_tool.svg");
  for (const char* group : {"<g id=\"commanded\"", "<g id=\"commanded-tool-off\"", "<g id=\"rehearsed\"",
                            "<g id=\"rehearsed-tool-off\"", "X in pulses to the right, Y in pulses upwards"})
    EXPECT_THAT(svg, HasSubstr(group));
  EXPECT_THAT(svg, Not(HasSubstr("<g id=\"trace\""))) << "it has not moved";
  s.click("path/tool");
  s.click("path/tool/always on");
  s.stage.frames(4);
  EXPECT_EQ(s.value("path/way_on"), "3000 pulses");
  EXPECT_FALSE(s.stage.find("path/way_off"));
}

// ---- what is saved

TEST_F(PathShownTest, ASavedPathShowsItsDirectionAndScale) {
  rehearse("I1M4000,\nI2M3000,\n");
  const std::string svg = saved("hw_path_directed.svg");
  EXPECT_THAT(svg, HasSubstr("<g id=\"rehearsed-direction\""));
  EXPECT_THAT(svg, HasSubstr("<g id=\"scale\""));
  EXPECT_THAT(svg, HasSubstr(" steps</text>"));
  // 4000 steps and the air around them are 800 pixels, whatever draws them.
  EXPECT_THAT(svg, HasSubstr("<g id=\"rehearsed\" stroke=\"#000000\" stroke-width=\"10.4\">"));
}

TEST_F(PathShownTest, ATraceAloneIsSavedWithTheLimits) {
  s.bench.present = true;
  s.bench.switches[0] = {Steps(-1000), Steps(3000), {}, {}};
  walk_to(200);
  s.stage.frames(2);
  const std::string svg = saved("hw_path_trace.svg");
  EXPECT_THAT(svg, HasSubstr("<g id=\"trace\""));
  EXPECT_THAT(svg, HasSubstr("<g id=\"switches\""));
  EXPECT_THAT(svg, Not(HasSubstr("<g id=\"rehearsed\"")));
  EXPECT_THAT(saved("hw_path_trace.png").substr(0, 8), HasSubstr("PNG"));
}

// ---- time

TEST_F(PathShownTest, TimeMayGoToTheRight) {
  rehearse("I1M400,\nP20,\nI1M-400,\n");
  s.click("path/right");
  s.click("path/right/time");
  s.click("path/up");
  s.click("path/up/1");
  s.stage.frames(4);
  EXPECT_THAT(s.value("path/size"),
              testing::MatchesRegex("[2-9][.0-9]* s x 400 steps|[2-9][.0-9]* s . 400 steps"));
  EXPECT_FALSE(s.stage.find("path/way_on")) << "a way in seconds and steps is none";
  s.click_at(view().centre());  // halfway in time it waits at 400
  walk_to(100);
  EXPECT_THAT(s.value("path/view/here"), testing::MatchesRegex("[0-9.]+ s, 100 steps"));
}

struct PathOfOneAxisTest : PathShownTest {
  PathOfOneAxisTest() : PathShownTest("dmx-k-sa") {}
};

TEST_F(PathOfOneAxisTest, IsSeenOverTime) {
  EXPECT_FALSE(s.stage.find("path/right")) << "there is nothing to choose";
  rehearse("HSPD=5000\nLSPD=100\nACC=100\nINC\nX400\nWAITX\nDELAY=2000\nX-400\nWAITX\nEND\n");
  ASSERT_THAT(s.value("path/size"), HasSubstr(" 400 pulses")) << s.toast();
  // Halfway it waits at its highest place.
  const gui::Rect r = view();
  s.stage.now_s += 1;
  s.stage.frames(1);
  const float top = r.centre().y - static_cast<float>(r.height() / 2 / 1.12);
  s.click_at(ImVec2(r.centre().x, top));
  EXPECT_THAT(s.value("path/hit"), HasSubstr(" 400 pulses"));
  EXPECT_THAT(s.value("path/hit"), HasSubstr("time "));
}

}  // namespace
}  // namespace hw::panels
