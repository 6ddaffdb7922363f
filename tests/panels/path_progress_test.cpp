// What of a path is done, at work and still to do, and how it is seen; and no gaps while it is moved.
#include "panels/path/path_progress.h"

#include <algorithm>

#include "core/device/registry.h"
#include "core/session/user_files.h"
#include "panels/path/tool_path.h"
#include "tests/panels/panel_stage.h"

namespace hw::panels {
namespace {

// ---- which runs stand out

struct PathProgressTest : ::testing::Test {
  PathProgressTest() {
    drawing::ToolPath square;
    const drawing::Point3 corners[] = {{0, 0}, {100, 0}, {100, 100}, {0, 100}};
    for (int pass = 0; pass < 2; ++pass)
      for (int side = 0; side < 4; ++side)
        square.go(corners[side], corners[(side + 1) % 4], true, side, pass);
    set(std::move(square));
  }
  void set(drawing::ToolPath path) {
    subject.path = std::make_shared<const drawing::ToolPath>(std::move(path));
    view = drawing::PathView(subject.path->bounds, 400, 400, true);
  }
  PathSubject subject;
  drawing::PathView view;
  PathProgress progress;
};

TEST_F(PathProgressTest, OfALoopThePassAtWorkStandsOut) {
  subject.lit = 1, subject.lit_pass = 1, subject.at_work = true;
  progress.follow(subject);
  ASSERT_EQ(progress.lit().size(), 1u);
  EXPECT_EQ(progress.lit()[0], (PathProgress::RunRange{5, 6}));
  EXPECT_EQ(progress.done(), 5u);
}

TEST_F(PathProgressTest, WhereThePassIsNotKnownNothingIsTakenForDone) {
  subject.lit = 1, subject.at_work = true;
  progress.follow(subject);
  EXPECT_EQ(progress.lit().size(), 2u);
  EXPECT_EQ(progress.done(), std::nullopt);
}

TEST_F(PathProgressTest, AClickedLineIsNotAtWork) {
  subject.lit = 1, subject.lit_pass = 0;
  progress.follow(subject);
  EXPECT_EQ(progress.lit().size(), 1u);
  EXPECT_EQ(progress.done(), std::nullopt);
}

/// Across itself at 50, 50.
TEST_F(PathProgressTest, WhereItCrossesItselfItGoesOnInItsOrder) {
  drawing::ToolPath crossing;
  const drawing::Point3 places[] = {{0, 0}, {100, 100}, {100, 0}, {0, 100}};
  for (int i = 0; i < 3; ++i) crossing.go(places[i], places[i + 1], true, 0);
  set(std::move(crossing));
  subject.lit = 0, subject.at_work = true;
  progress.follow(subject);
  const auto point_reached = [&](drawing::Point3 here) {
    const auto reached = progress.reached(view, here, 20);
    return reached ? static_cast<int>(reached->next_point) : -1;
  };
  EXPECT_EQ(point_reached({10, 10}), 1);
  EXPECT_EQ(point_reached({50, 50}), 1);
  EXPECT_EQ(point_reached({100, 40}), 2);
  EXPECT_EQ(point_reached({50, 50}), 3);
  EXPECT_EQ(point_reached({10, 90}), 3);
  EXPECT_EQ(point_reached({50, 300}), -1) << "off it for one frame";
  EXPECT_EQ(point_reached({50, 50}), 3) << "no earlier line counts again";
  EXPECT_EQ(point_reached({10, 10}), -1);
  EXPECT_EQ(point_reached({10, 10}), 1) << "it has begun anew";
}

// ---- as it is seen

struct PathAtWorkTest : ::testing::Test {
  explicit PathAtWorkTest(const char* model = "vxm") : type(*find_device_type(model)) {
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
  void stands_at(int x, int y) {
    s.now.axes[0].position = Steps(x), s.now.axes[1].position = Steps(y);
    s.stage.frames(4);
    s.tab.desk().records.trace.clear();
    s.stage.frames(6);
  }
  /// The controller holds the text, and has told that it is at this command of it.
  void runs(std::int16_t command) {
    s.tab.desk().programs.texts.loaded(0, s.tab.desk().programs.texts.text(0), s.tab.clock());
    s.now.program = {
        .run = RunState::running, .owned = true, .slot = 0, .command = command, .command_reported = true};
    s.now.program.started_at = s.tab.clock();
    s.stage.frames(6);
  }
  double per_px() { return std::stod(s.value("path/view")); }
  gui::Rect view() { return s.stage.find("path/view")->rect; }
  /// Where so many steps lie, of a path whose middle is in the middle of the view.
  ImVec2 at(drawing::Point3 p, drawing::Point3 middle) {
    return ImVec2(view().centre().x + static_cast<float>((p.x - middle.x) / per_px()),
                  view().centre().y - static_cast<float>((p.y - middle.y) / per_px()));
  }
  int coloured(ImVec2 p, gui::Tone tone) {
    s.stage.surface.render();
    const ImU32 colour = s.stage.surface.screen().theme()[tone];
    int n = 0;
    for (int y = -4; y <= 4; ++y)
      for (int x = -4; x <= 4; ++x)
        n += s.stage.surface.pixel(static_cast<int>(p.x) + x, static_cast<int>(p.y) + y) == colour;
    return n;
  }
  const DeviceType& type;
  ToolPath panel;
  test::PanelStage s{panel, 900, 620, 1, gui::Tier::wide, true, *type.make_catalog({}), &type.language()};
};

TEST_F(PathAtWorkTest, DoneAtWorkAndStillToDoLookDifferent) {
  rehearse("I1M400,\nI2M400,\nI1M-400,\nI2M-400,\n");
  const auto place = [this](double x, double y) { return at({x, y}, {200, 200}); };
  EXPECT_GE(coloured(place(100, 400), gui::Tone::ink), 1) << "nothing is at work";
  stands_at(400, 200);
  runs(1);
  EXPECT_GE(coloured(place(100, 0), gui::Tone::ink), 1) << "done";
  EXPECT_GE(coloured(place(400, 100), gui::Tone::motion), 1) << "at work, as far as the tool has come";
  EXPECT_EQ(coloured(place(400, 300), gui::Tone::motion), 0) << "ahead of it";
  EXPECT_EQ(coloured(place(100, 400), gui::Tone::ink), 0) << "still to do";
  s.now.program = {};
  s.stage.frames(6);
  EXPECT_GE(coloured(place(100, 400), gui::Tone::ink), 1) << "it has ended";
}

TEST_F(PathAtWorkTest, OfALoopOnlyThePassAtWorkIsLit) {
  rehearse("I1M400,\nI2M100,\nI1M-400,\nI2M100,\nL2,\n");
  const double all_s = std::stod(s.value("path/time"));
  const std::string size = s.value("path/size");
  const double high = std::stod(size.substr(size.find('x') + 2));
  const auto place = [&](double x, double y) { return at({x, y}, {200, high / 2}); };
  stands_at(300, 200);
  runs(0);
  s.stage.now_s += all_s * 0.6;
  s.stage.frames(6);
  EXPECT_GE(coloured(place(100, 200), gui::Tone::motion), 1) << "the second pass";
  EXPECT_EQ(coloured(place(100, 0), gui::Tone::motion), 0) << "the first one is done";
}

struct PmxPathAtWorkTest : PathAtWorkTest {
  PmxPathAtWorkTest() : PathAtWorkTest("pmx-4ex-sa") {}
};

TEST_F(PmxPathAtWorkTest, TheMarkOfTheToolShowsThatItIsOn) {
  rehearse("ABS\nHSPD=5000\nLSPD=100\nACC=100\nDO5=1\nX400\nWAITX\nDO5=0\nY300\nWAITY\nEND\n");
  stands_at(200, 150);
  EXPECT_EQ(s.value("path/view/here"), "200 pulses, 150 pulses") << "no output was chosen";
  s.click("path/tool");
  s.click("path/tool/DO5");
  s.now.outputs_known = 0xff, s.now.outputs = 0x10;
  s.stage.frames(6);
  EXPECT_EQ(s.value("path/view/here"), "200 pulses, 150 pulses, tool on");
  const ImVec2 here = s.stage.find("path/view/here")->rect.centre();
  EXPECT_GE(coloured(ImVec2(here.x + 2, here.y + 2), gui::Tone::warn), 4);
  s.now.outputs = 0;
  s.stage.frames(6);
  EXPECT_EQ(s.value("path/view/here"), "200 pulses, 150 pulses, tool off");
  EXPECT_EQ(coloured(ImVec2(here.x + 2, here.y + 2), gui::Tone::warn), 0);
  s.now.outputs_known = 0;
  s.stage.frames(6);
  EXPECT_EQ(s.value("path/view/here"), "200 pulses, 150 pulses") << "not known";
}

// ---- moved about

TEST_F(PathAtWorkTest, AHandThatMovesItComesToNoGap) {
  rehearse("I1M400,\nI1M-200,\nI2M200,\nI2M-400,\n");
  for (int i = 0; i < 3; ++i) s.click("path/nearer");
  s.stage.frames(6);
  const ImVec2 from(view().centre().x + 60, view().centre().y + 60);
  s.stage.push(gui::InputEvent::mouse_move(from.x, from.y, s.stage.now_s));
  s.stage.frames(2);
  s.stage.push(gui::InputEvent::mouse_button(0, true, from, s.stage.now_s));
  s.stage.frames(2);
  s.stage.push(gui::InputEvent::mouse_move(from.x - 80, from.y, s.stage.now_s));
  s.stage.frames(1);
  // The picture is still that of before, moved: what has come in at the right was in its margin.
  EXPECT_GE(coloured(ImVec2(view().max.x - 20, view().centre().y), gui::Tone::ink), 4);
  s.stage.push(gui::InputEvent::mouse_button(0, false, from, s.stage.now_s));
  s.stage.frames(6);
  EXPECT_GT(s.stage.surface.screen().wake_in_s(), 1.0) << "at rest nothing is drawn anew";
}

// ---- what is saved

TEST_F(PmxPathAtWorkTest, InSpaceHomeIsSavedAsWholePlanes) {
  s.bench.present = true;
  s.bench.switches[0] = {Steps(-1000), Steps(3000), Steps(-100), Steps(0)};
  rehearse("ABS\nHSPD=5000\nLSPD=100\nACC=100\nX400\nWAITX\nY300\nWAITY\nZ200\nWAITZ\nEND\n");
  s.click("path/third");
  s.click("path/third/Z");
  s.stage.frames(4);
  const auto file = std::filesystem::temp_directory_path() / "hw_path_home_test.svg";
  std::filesystem::remove(file);
  s.click("path/save");
  s.type("file/path", file.c_str());
  s.click("file/save");
  s.stage.frames(4);
  const auto read = read_file(file, 10'000'000);
  std::filesystem::remove(file);
  ASSERT_TRUE(read) << read.error().sentence();
  const std::string home = read->substr(read->find("<g id=\"home\""));
  const std::size_t begin = home.find("points=\"") + 8, end = home.find('"', begin);
  const std::string points = home.substr(begin, end - begin);
  EXPECT_EQ(points.substr(0, points.find(' ')), points.substr(points.rfind(' ') + 1)) << points;
  EXPECT_EQ(std::count(points.begin(), points.end(), ' '), 4) << points;
}

}  // namespace
}  // namespace hw::panels
