#include "gui/surface/layout.h"

#include <gtest/gtest.h>

namespace hw::gui {
namespace {

Layout at(float width, float height, int controllers = 1) {
  LayoutInput w;
  w.width = width;
  w.height = height;
  w.controllers = controllers;
  w.strip_height = 96;
  return lay_out(w);
}

TEST(Layout, TiersByLogicalSize) {
  EXPECT_EQ(at(1440, 900).tier, Tier::wide);
  EXPECT_EQ(at(1280, 780).tier, Tier::wide);
  EXPECT_EQ(at(1024, 700).tier, Tier::medium);
  EXPECT_EQ(at(720, 450).tier, Tier::narrow);  // 1440 x 900 at 200 %
  EXPECT_EQ(at(640, 400).tier, Tier::narrow);
}

TEST(Layout, WideIsAsDrawn) {
  const Layout l = at(1440, 900);
  EXPECT_EQ(l.left.width, 304);
  EXPECT_EQ(l.right.width, 272);
  EXPECT_EQ(l.centre.width, 864);
  EXPECT_EQ(l.status.height, 36);
  EXPECT_EQ(l.stop.width, 200);
}

TEST(Layout, StopHasNoMarginToTheCornerInAnyWindow) {
  for (const float width : {640.f, 720.f, 1024.f, 1440.f, 3840.f}) {
    const Layout l = at(width, 900);
    EXPECT_EQ(l.stop.right(), width);
    EXPECT_EQ(l.stop.y, 0);
    EXPECT_GE(l.stop.width, 160);
    EXPECT_EQ(l.stop.height, 56);
  }
}

TEST(Layout, NothingOverlapsAndEverythingIsFilled) {
  for (const auto& [w, h] : {std::pair{1440.f, 900.f}, {1024.f, 700.f}, {720.f, 450.f}, {640.f, 400.f}})
    for (int controllers : {0, 1, 4, 9}) {
      const Layout l = at(w, h, controllers);
      EXPECT_LE(l.brand.right(), l.tabs.x);
      EXPECT_LE(l.add.right(), l.link.x + 0.5f) << w << " " << controllers;
      EXPECT_EQ(l.link.right(), l.stop.x);
      EXPECT_EQ(l.status.bottom(), h);
      EXPECT_GT(l.centre.height, 100);
      EXPECT_EQ(l.centre.bottom(), l.status.y);
      if (l.tier != Tier::narrow) {
        EXPECT_EQ(l.left.width + l.centre.width + l.right.width, w);
      }
    }
}

TEST(Layout, TooManyControllersBecomeOneMenu) {
  EXPECT_FALSE(at(1440, 900, 4).controller_menu);
  EXPECT_TRUE(at(1440, 900, 9).controller_menu);
  EXPECT_TRUE(at(720, 450, 1).controller_menu);
}

TEST(Layout, FourControllersHaveTabsInEveryWindowButANarrowOne) {
  for (const auto& [w, h] : {std::pair{1366.f, 768.f}, {1366.f, 820.f}, {1280.f, 800.f}, {1024.f, 700.f}}) {
    const Layout l = at(w, h, 4);
    EXPECT_FALSE(l.controller_menu) << w << " x " << h;
    EXPECT_GE(l.tab_width, 120) << w << " x " << h;
    EXPECT_LE(l.tabs.x + 4 * l.tab_width, l.add.x + 0.5f) << w << " x " << h;
    EXPECT_LE(l.add.right(), l.link.x + 0.5f) << w << " x " << h;
  }
  EXPECT_EQ(at(1440, 900, 4).tab_width, 176) << "as drawn where there is room";
}

TEST(Layout, SplittersStayWithinTheirLimits) {
  LayoutInput w;
  w.splitters.left = 10;
  w.splitters.right = 9000;
  const Layout l = lay_out(w);
  EXPECT_EQ(l.left.width, 264);
  EXPECT_EQ(l.right.width, 400);
}

TEST(Layout, TerminalShrinksToThreeRowsThenBecomesATab) {
  EXPECT_GT(below_height(800, Splitters(), Tier::wide), 200);
  EXPECT_GE(below_height(608, Splitters(), Tier::medium), 3 * 20);
  EXPECT_EQ(below_height(300, Splitters(), Tier::medium), 0);
  EXPECT_EQ(below_height(350, Splitters(), Tier::narrow), 0);
}

TEST(Layout, TheTerminalGivesWayToAPanelThatWantsHeightUnlessItWasDragged) {
  EXPECT_EQ(below_height(768, Splitters(), Tier::wide, 616), 152);
  EXPECT_EQ(below_height(1200, Splitters(), Tier::wide, 616), Splitters().below) << "there is room for both";
  Splitters dragged;
  dragged.below = 320;
  EXPECT_EQ(below_height(768, dragged, Tier::wide, 616), 320);
  EXPECT_EQ(below_height(768, Splitters(), Tier::wide), Splitters().below);
}

TEST(Layout, AnUnfoldedColumnStandsBesideACentreThatHasRoom) {
  LayoutInput w;
  w.right_open = true;
  w.width = 1366, w.height = 768;
  const Layout laptop = lay_out(w);
  EXPECT_FALSE(laptop.unfolded_covers);
  EXPECT_EQ(laptop.centre.right(), laptop.unfolded.x);
  EXPECT_EQ(laptop.unfolded.right(), laptop.right.x);
  w.width = 1024, w.height = 700;
  const Layout small = lay_out(w);
  EXPECT_TRUE(small.unfolded_covers);
  EXPECT_EQ(small.centre.right(), small.right.x);
  w.width = 1440, w.height = 900;
  EXPECT_TRUE(lay_out(w).unfolded.empty()) << "it is never folded there";
}

TEST(Layout, TheTerminalOfALaptopHasItsTitleAndThreeRows) {
  constexpr float title_and_rows = 44 + 3 * 20 + 48;
  const float laptop = at(1366, 768).centre.height - 40, small = at(1024, 700).centre.height - 40;
  EXPECT_GE(below_height(laptop, Splitters(), Tier::medium, 560), title_and_rows);
  EXPECT_LT(below_height(small, Splitters(), Tier::medium), title_and_rows);
}

}  // namespace
}  // namespace hw::gui
