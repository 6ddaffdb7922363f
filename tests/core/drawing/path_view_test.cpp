// How a path is looked at, in two axes and in three.
#include "core/drawing/path_view.h"

#include <cmath>

#include <gtest/gtest.h>

namespace hw::drawing {
namespace {

Box box_of(Point a, Point b) {
  Box box;
  box.add(a), box.add(b);
  return box;
}

TEST(PathView, ShowsAllOfABoxWithEqualScales) {
  const PathView view(box_of({-10, 0}, {30, 20}), 400, 400, true);
  EXPECT_DOUBLE_EQ(view.per_px().x, view.per_px().y);
  const Point low = view.to_px({-10, 0}), high = view.to_px({30, 20});
  EXPECT_GT(low.x, 0);
  EXPECT_LT(high.x, 400);
  EXPECT_GT(high.y, 0);
  EXPECT_LT(low.y, 400) << "y goes upwards";
  EXPECT_NEAR((low.x + high.x) / 2, 200, 1e-9);
}

TEST(PathView, ZoomKeepsThePointUnderThePointer) {
  PathView view(box_of({0, 0}, {100, 100}), 500, 300, true);
  const Point3 kept = view.from_px({37, 211});
  for (int i = 0; i < 30; ++i) view.zoom({37, 211}, 1.25);
  EXPECT_NEAR(view.from_px({37, 211}).x, kept.x, 1e-9);
  EXPECT_NEAR(view.from_px({37, 211}).y, kept.y, 1e-9);
  const Point before = view.to_px(kept);
  view.pan(5, -3);
  EXPECT_NEAR(view.to_px(kept).x, before.x + 5, 1e-6);
  EXPECT_NEAR(view.to_px(kept).y, before.y - 3, 1e-6);
}

TEST(PathView, ZoomingEndsWhereNumbersDo) {
  PathView view(box_of({0, 0}, {100, 100}), 500, 300, true);
  for (int i = 0; i < 1000; ++i) view.zoom({250, 150}, 2);
  EXPECT_GT(view.per_px().x, 0);
  for (int i = 0; i < 1000; ++i) view.zoom({250, 150}, 0.5);
  EXPECT_LT(view.per_px().x, 1e13);
  view.zoom({250, 150}, 0);
  view.zoom({250, 150}, -1);
  EXPECT_GT(view.per_px().x, 0);
}

TEST(PathView, TheSamePartIsShownInAnotherSize) {
  PathView view(box_of({0, 0}, {100, 50}), 500, 300, true);
  view.resize(1000, 600);
  const PathView fresh(box_of({0, 0}, {100, 50}), 1000, 600, true);
  EXPECT_NEAR(view.to_px({100, 50}).x, fresh.to_px({100, 50}).x, 1e-9);
  EXPECT_NEAR(view.to_px({0, 0}).y, fresh.to_px({0, 0}).y, 1e-9);
}

TEST(PathView, APointHasAViewToo) {
  const PathView view(box_of({5, 5}, {5, 5}), 500, 300, false);
  EXPECT_NEAR(view.to_px({5, 5}).x, 250, 1e-6);
  EXPECT_GT(view.per_px().y, 0);
}

// ---- three axes

Box3 cuboid() {
  Box3 box;
  box.add(Point3{0, 0, 0}), box.add(Point3{100, 60, 30});
  return box;
}
PathView seen(const ViewDirection& from) {
  return {cuboid(), Projection(cuboid(), from, true), 400, 300, true};
}

TEST(Projection, StandardViewsShowTheirAxes) {
  struct Way {
    ViewDirection from;
    Point3 right, up;
  };
  for (const Way& w : {Way{views::top, {100, 0, 0}, {0, 60, 0}}, Way{views::front, {100, 0, 0}, {0, 0, 30}},
                       Way{views::side, {0, 60, 0}, {0, 0, 30}}}) {
    const PathView view = seen(w.from);
    const Point origin = view.to_px({}), right = view.to_px(w.right), up = view.to_px(w.up);
    EXPECT_GT(right.x, origin.x + 50);
    EXPECT_NEAR(right.y, origin.y, 1e-6);
    EXPECT_LT(up.y, origin.y - 25);
    EXPECT_NEAR(up.x, origin.x, 1e-6);
  }
  const PathView iso = seen(views::iso);
  const Point origin = iso.to_px({});
  EXPECT_GT(iso.to_px({50, 0, 0}).x, origin.x) << "the first axis goes to the right";
  EXPECT_LT(iso.to_px({0, 0, 30}).y, origin.y) << "and the third upwards";
}

TEST(Projection, NearObjectsAreLarger) {
  const PathView front = seen(views::front);
  const auto width = [&](double y) { return front.to_px({100, y, 0}).x - front.to_px({0, y, 0}).x; };
  EXPECT_GT(width(0), width(60) * 1.1);
  EXPECT_FALSE(front.flat());
}

TEST(Projection, AllOfABoxIsShownFromEverywhere) {
  for (double turn = -180; turn <= 180; turn += 37)
    for (double tilt = -90; tilt <= 90; tilt += 30) {
      const PathView view = seen({turn, tilt});
      for (int n = 0; n < 8; ++n) {
        const Point px = view.to_px(cuboid().corner(n));
        EXPECT_TRUE(px.x >= 0 && px.x <= 400 && px.y >= 0 && px.y <= 300) << turn << "," << tilt << ": " << n;
      }
    }
}

TEST(Projection, TurningLeavesWhatItIsTurnedAboutWhereItIs) {
  PathView view = seen(views::iso);
  view.zoom({100, 100}, 5);
  const Point3 about{100, 60, 0};
  const Point before = view.to_px(about), other = view.to_px({0, 0, 0});
  view.look(view.projection().turned({80, 20}), about);
  EXPECT_NEAR(view.to_px(about).x, before.x, 1e-6);
  EXPECT_NEAR(view.to_px(about).y, before.y, 1e-6);
  EXPECT_GT(std::hypot(view.to_px({0, 0, 0}).x - other.x, view.to_px({0, 0, 0}).y - other.y), 20);
  EXPECT_EQ(view.projection().from(), (ViewDirection{80, 20}));
}

TEST(Projection, APixelIsFoundAgainAsDeepAsTheMiddle) {
  const PathView view = seen({33, 21});
  const Point px = view.to_px(view.from_px({123, 45}));
  EXPECT_NEAR(px.x, 123, 1e-9);
  EXPECT_NEAR(px.y, 45, 1e-9);
}

TEST(Projection, AxesInSeveralUnitsAreAlike) {
  Box3 box;
  box.add(Point3{0, 0, 0}), box.add(Point3{1000, 2, 0.5});
  const PathView view(box, Projection(box, views::iso, false), 400, 300, true);
  const auto length_of = [&](Point3 end) {
    const Point a = view.to_px({}), b = view.to_px(end);
    return std::hypot(b.x - a.x, b.y - a.y);
  };
  EXPECT_NEAR(length_of({1000, 0, 0}), length_of({0, 2, 0}), length_of({0, 2, 0}) * 0.5);
  EXPECT_GT(length_of({0, 0, 0.5}), 50);
  const Point px = view.to_px(view.from_px({50, 60}));
  EXPECT_NEAR(px.x, 50, 1e-9);
}

TEST(Projection, ReportsWhatLiesBehindTheViewer) {
  const Projection p(cuboid(), views::iso, true);
  EXPECT_TRUE(p.reaches(cuboid()));
  Box3 larger = cuboid();
  larger.add(Point3{100, 60, 5000});
  EXPECT_FALSE(p.reaches(larger));
  EXPECT_TRUE(Projection(larger, views::iso, true).reaches(larger));
  EXPECT_TRUE(Projection().reaches(larger)) << "two axes are seen as they are";
  const Point behind = p.on_plane({1e9, -1e9, 1e9});
  EXPECT_TRUE(std::isfinite(behind.x) && std::isfinite(behind.y));
}

TEST(PathView, APictureIsMovedWithinItsProjection) {
  PathView before = seen(views::iso), now = before;
  now.pan(30, -10), now.zoom({10, 20}, 1.7);
  const Point3 p{20, 30, 10};
  const Point moved = now.moved_px(before, before.to_px(p));
  EXPECT_NEAR(moved.x, now.to_px(p).x, 1e-9);
  EXPECT_NEAR(moved.y, now.to_px(p).y, 1e-9);
}

}  // namespace
}  // namespace hw::drawing
