// Paths as pictures, and pictures among what ImGui draws.
#include "gui/surface/path_picture.h"

#include <array>

#include <gtest/gtest.h>

#include "tests/gui/lib/gl_canvas.h"
#include "tests/gui/stage.h"

namespace hw::gui {
namespace {

constexpr ImU32 crimson = IM_COL32(255, 0, 0, 255), grey = IM_COL32(90, 90, 90, 255);

drawing::Box box(double width, double height) {
  drawing::Box b;
  b.add({0, 0}), b.add({width, height});
  return b;
}
struct Drawn {
  drawing::PathView view;
  Picture picture;
  explicit Drawn(const drawing::ToolPath& path, PathLook look = {crimson, grey, 2, 1, 0, 0})
      : view(box(100, 100), 200, 200, true),
        picture(path_picture(std::array{PathLayer{&path, look}}, view)) {}
  [[nodiscard]] ImU32 at(drawing::Point p) const {
    const drawing::Point px = view.to_px(p);
    return picture
        .pixels[static_cast<std::size_t>(static_cast<int>(px.y) * picture.width + static_cast<int>(px.x))];
  }
  [[nodiscard]] unsigned alpha(drawing::Point p) const { return at(p) >> IM_COL32_A_SHIFT & 255; }
};

TEST(PathPicture, LinesStandWhereTheViewPutsThem) {
  drawing::ToolPath path;
  path.go({10, 10}, {90, 10}, true, 0);
  path.go({90, 10}, {90, 70}, false, 0);
  const Drawn d(path);
  EXPECT_EQ(d.alpha({50, 10}), 255u);
  EXPECT_EQ(d.at({50, 10}), crimson);
  EXPECT_GT(d.alpha({90, 50}), 100u);
  EXPECT_EQ(d.at({90, 50}) & 255, 90u) << "the tool is off";
  EXPECT_EQ(d.alpha({50, 50}), 0u);
  EXPECT_EQ(d.alpha({5, 10}), 0u) << "before it begins";
}

TEST(PathPicture, DashesHaveGaps) {
  drawing::ToolPath path;
  path.go({10, 50}, {90, 50}, false, 0);
  const Drawn d(path, {crimson, grey, 2, 2, 5, 4});
  int on = 0, off = 0;
  for (double x = 12; x < 88; x += 0.25) (d.alpha({x, 50}) > 0 ? on : off) += 1;
  EXPECT_NEAR(static_cast<double>(on) / (on + off), 5.0 / 9, 0.08);
}

TEST(PathPicture, ArrowsShowTheDirection) {
  drawing::ToolPath path;
  path.go({10, 50}, {90, 50}, true, 0);
  PathLook look{crimson, grey, 2, 1, 0, 0};
  look.arrow_every = 60, look.arrow = 12;
  const Drawn d(path, look);
  // 200 pixels for 100 units and some air: its arms lie behind the tip, which points on to the right.
  int behind = 0, before = 0;
  for (double x = 40; x < 60; x += 0.25)
    for (const double y : {48.5, 51.5}) (x < 53.5 ? behind : before) += d.alpha({x, y}) > 128;
  EXPECT_GT(behind, 4);
  EXPECT_EQ(before, 0);
}

TEST(PathPicture, ArrowsOfTheWayWithTheToolOffAreWholeToo) {
  drawing::ToolPath path;
  path.go({10, 50}, {90, 50}, false, 0);
  const auto arms = [&](float dash, float gap) {
    PathLook look{crimson, grey, 2, 1, dash, gap};
    look.arrow_every = 60, look.arrow = 12;
    const Drawn d(path, look);
    int covered = 0;
    for (double x = 40; x < 60; x += 0.25)
      for (const double y : {48.0, 48.5, 51.5, 52.0}) covered += d.alpha({x, y}) > 60;
    return covered;
  };
  EXPECT_GT(arms(0, 0), 4);
  EXPECT_EQ(arms(2, 8), arms(0, 0));
}

TEST(PathPicture, InPerspectiveLinesStandWhereTheViewPutsThem) {
  drawing::ToolPath path;
  path.go({0, 0, 0}, {100, 0, 0}, true, 0);
  path.go({100, 0, 0}, {100, 80, 60}, false, 0);
  const drawing::PathView view(path.bounds, drawing::Projection(path.bounds, drawing::views::iso, true), 200,
                               200, true);
  const Picture picture = path_picture(std::array{PathLayer{&path, {crimson, grey, 2, 2, 0, 0}}}, view);
  const auto alpha = [&](drawing::Point3 p) {
    const drawing::Point px = view.to_px(p);
    return picture.pixels[static_cast<std::size_t>(static_cast<int>(px.y) * 200 + static_cast<int>(px.x))] >>
               IM_COL32_A_SHIFT &
           255;
  };
  EXPECT_GT(alpha({30, 0, 0}), 150u);
  EXPECT_GT(alpha({100, 40, 30}), 150u);
  EXPECT_EQ(alpha({50, 60, 0}), 0u);
}

TEST(PathPicture, LinesThatReachFarOutsideAreCutAtTheEdge) {
  drawing::ToolPath path;
  path.go({-1e12, 50}, {1e12, 50}, true, 0);
  path.go({-4e9, -4e9}, {4e9, 4e9}, true, 0);
  const Drawn d(path);
  EXPECT_EQ(d.alpha({3, 50}), 255u);
  EXPECT_GT(d.alpha({75, 75}), 200u);
  EXPECT_EQ(d.alpha({75, 20}), 0u);
}

TEST(PathPicture, ManyLinesWithinAPixelAreOneStroke) {
  drawing::ToolPath path;
  double x = 10;
  for (int i = 0; i < 100'000; ++i) {
    const double next = x + 0.0008;
    path.go({x, 50 + (i % 2) * 0.001}, {next, 50 + ((i + 1) % 2) * 0.001}, true, 0);
    x = next;
  }
  const Drawn d(path);
  EXPECT_EQ(d.alpha({50, 50}), 255u);
  EXPECT_EQ(d.alpha({89, 50}), 255u);
  EXPECT_EQ(d.alpha({93, 50}), 0u);
}

// ---- pictures in a frame

struct Shown {
  Shown() : stage([this](Ui& ui) { draw(ui); }, 100, 80) {
    Picture p;
    p.width = 2, p.height = 1;
    p.pixels = {crimson, IM_COL32(0, 0, 255, 0)};
    picture = std::make_shared<const Picture>(std::move(p));
    stage.frames(2);
    stage.surface.render();
  }
  void draw(Ui& ui) {
    ImDrawList& list = *ImGui::GetBackgroundDrawList();
    list.AddRectFilled(ImVec2(0, 0), ImVec2(10, 10), crimson);
    list.AddImage(ui.pictures.show(picture), ImVec2(20, 20), ImVec2(60, 40));
    list.AddRectFilled(ImVec2(90, 70), ImVec2(100, 80), crimson);
  }
  std::shared_ptr<const Picture> picture;
  Stage stage;
};

TEST(Pictures, AreScaledIntoTheirPlaceAmongTheRest) {
  Shown s;
  const ImU32 ground = s.stage.surface.screen().theme()[Tone::ground];
  EXPECT_EQ(s.stage.surface.pixel(25, 30), crimson);
  EXPECT_EQ(s.stage.surface.pixel(58, 30), ground) << "its right half lets the ground through";
  EXPECT_EQ(s.stage.surface.pixel(15, 30), ground);
  EXPECT_EQ(s.stage.surface.pixel(5, 5), crimson);
  EXPECT_EQ(s.stage.surface.pixel(95, 75), crimson);
}

TEST(Pictures, AreTheSameInGlAndTwice) {
  Shown soft;
  const std::unique_ptr<GlCanvas> gl = GlCanvas::open();
  if (!gl) GTEST_SKIP() << "no GL without a display here";
  for (int again = 0; again < 2; ++again) {
    std::vector<std::uint32_t> hard;
    ASSERT_TRUE(gl->draw(soft.stage.surface.screen()) && gl->read(hard));
    for (int y = 0; y < 80; y += 3)
      for (int x = 0; x < 100; ++x)
        for (const int shift : {0, 8, 16})
          ASSERT_NEAR(static_cast<int>(soft.stage.surface.pixel(x, y) >> shift & 255),
                      static_cast<int>(hard[static_cast<std::size_t>(y * 100 + x)] >> shift & 255), 6)
              << x << "," << y;
  }
}

TEST(Pictures, LiveAsLongAsTheFrameThatShowsThem) {
  Pictures pictures;
  auto picture = std::make_shared<const Picture>();
  const std::weak_ptr<const Picture> watched = picture;
  const ImTextureID id = pictures.show(std::move(picture));
  EXPECT_TRUE(pictures.find(id));
  EXPECT_FALSE(watched.expired());
  pictures.begin_frame();
  EXPECT_FALSE(pictures.find(id));
  EXPECT_TRUE(watched.expired());
}

}  // namespace
}  // namespace hw::gui
