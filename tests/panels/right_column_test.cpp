// The right column: limits and inputs pinned, the bench below them by axis, and the place of each scroll bar
// its controller's own.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <imgui_internal.h>

#include "core/device/registry.h"
#include "tests/core/session/folder.h"
#include "tests/panels/console_stage.h"
#include "tests/panels/must.h"

namespace hw::panels {
namespace {

using namespace gui;

float top_of(ConsoleStage& s, const std::string& id) {
  const Widget* found = s.stage.find(id);
  EXPECT_TRUE(found) << id;
  return found ? found->rect.centre().y : -1;
}

Catalog made(std::string_view model) { return *find_device_type(model)->make_catalog({}); }

class EachController : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(All, EachController, testing::Values("vxm", "pmx-4ex-sa", "dmx-k-sa", "vme58"));

TEST_P(EachController, HasARowOfItsBenchForEachAxis) {
  ConsoleStage s;
  Example& a = s.add(made(GetParam()));
  s.run(0.1);
  float above = 0;
  for (const AxisInfo& axis : a.tab->catalog().axes) {
    const float row = top_of(s, fmt::format("bench/jam/{}", axis.name));
    EXPECT_GE(row, above + 28) << axis.name;
    for (const char* what : {"bench/limit/{}/-", "bench/limit/{}/+", "bench/home/{}", "bench/slip/{}"})
      EXPECT_NEAR(top_of(s, fmt::format(fmt::runtime(what), axis.name)), row, 2) << what;
    EXPECT_EQ(s.hand.exists(fmt::format("bench/alarm/{}", axis.name)), axis.alarm_input) << axis.name;
    above = row;
  }
  const std::string last = a.tab->catalog().axes.back().name;
  MUST(s.hand.click("bench/limit/" + last + "/-"));
  ASSERT_TRUE(a.last_operated<bench::Limit>());
  EXPECT_EQ(a.last_operated<bench::Limit>()->axis.index, a.tab->catalog().axes.size() - 1);
  EXPECT_EQ(a.last_operated<bench::Limit>()->sign, Sign::minus);
}

TEST_P(EachController, NothingOfARowLiesOverTheNextOne) {
  for (const auto& [width, height] : {std::pair{1440, 900}, {1280, 780}, {1024, 700}}) {
    ConsoleStage s(width, height);
    s.add(made(GetParam()));
    s.console.right_open = true;
    s.console.lower_right = Fold::open;
    s.run(0.1);
    std::vector<Widget> cells;
    for (const Widget& w : s.stage.surface.screen().registry().widgets())
      if (w.id.starts_with("bench/") && w.usable()) cells.push_back(w);
    for (std::size_t i = 0; i < cells.size(); ++i)
      for (std::size_t j = i + 1; j < cells.size(); ++j) {
        const Rect &p = cells[i].rect, &q = cells[j].rect;
        EXPECT_FALSE(p.min.x + 1 < q.max.x && q.min.x + 1 < p.max.x && p.min.y + 1 < q.max.y &&
                     q.min.y + 1 < p.max.y)
            << width << ": " << cells[i].id << " and " << cells[j].id;
      }
  }
}

TEST_P(EachController, ShowsAllThatIsPinnedInAWindowAsDrawn) {
  ConsoleStage s;
  s.add(made(GetParam()));
  s.run(0.1);
  for (const Widget& w : s.stage.surface.screen().registry().widgets())
    if (w.id.starts_with("io/")) {
      EXPECT_TRUE(w.in_view()) << w.id;
    }
  const Widget* bench = s.stage.find("bench/fold");
  ASSERT_TRUE(bench);
  EXPECT_TRUE(bench->in_view());
  EXPECT_TRUE(s.hand.exists("bench/unplug")) << "it is open";
}

TEST(RightColumn, LimitsStandStillWhileTheBenchMoves) {
  ConsoleStage s;
  s.add();
  s.run(0.1);
  const float limit = top_of(s, "io/limit/1/-"), switched = top_of(s, "bench/power");
  MUST(s.hand.click("bench/analog/1"));
  s.run(0.1);
  EXPECT_LT(top_of(s, "bench/power"), switched) << "the bench has moved";
  EXPECT_EQ(top_of(s, "io/limit/1/-"), limit);
}

TEST(RightColumn, EachControllerKeepsThePlaceOfItsScrollBar) {
  ConsoleStage s;
  Example &a = s.add(), &b = s.add();
  s.console.activate(*b.tab);
  s.run(0.1);
  const float at_top = top_of(s, "bench/power");
  s.console.activate(*a.tab);
  s.run(0.1);
  MUST(s.hand.click("bench/analog/1"));
  s.run(0.1);
  const float moved = top_of(s, "bench/power");
  ASSERT_LT(moved, at_top);
  s.console.activate(*b.tab);
  s.run(0.1);
  EXPECT_EQ(top_of(s, "bench/power"), at_top) << "another controller's has not moved";
  s.console.activate(*a.tab);
  s.run(0.1);
  EXPECT_EQ(top_of(s, "bench/power"), moved) << "where it was left";
}

TEST(RightColumn, TheBenchIsFoldedByItselfWhereThereIsNoRoomAndOpensOnAPress) {
  ConsoleStage s(1280, 780);
  s.add(made("vme58"));
  s.run(0.1);
  EXPECT_FALSE(s.hand.exists("bench/unplug"));
  for (const Widget& w : s.stage.surface.screen().registry().widgets())
    if (w.id.starts_with("io/")) {
      EXPECT_TRUE(w.in_view()) << w.id;
    }
  MUST(s.hand.click("bench/fold"));
  s.run(0.1);
  EXPECT_TRUE(s.stage.find("bench/jam/X"));
  EXPECT_TRUE(s.stage.find("bench/jam/X")->in_view());
  EXPECT_TRUE(s.stage.find("io/limit/S/+")->in_view());
  MUST(s.hand.click("bench/fold"));
  s.run(0.1);
  EXPECT_FALSE(s.hand.exists("bench/jam/X"));
}

TEST(RightColumn, AFoldedPartStaysFoldedInTheNextRun) {
  test::Folder folder;
  const UserFolders folders = UserFolders::below(folder.path());
  {
    ConsoleStage s(1440, 900, 1, true, folders);
    s.add();
    s.run(0.1);
    EXPECT_TRUE(s.hand.exists("bench/jam/1"));
    MUST(s.hand.click("bench/fold"));
    s.run(0.1);
    s.console.save();
  }
  ConsoleStage s(1440, 900, 1, true, folders);
  s.add();
  s.run(0.1);
  EXPECT_FALSE(s.hand.exists("bench/jam/1"));
}

TEST(RightColumn, ARealControllerHasNoBench) {
  ConsoleStage s;
  s.add().bench.present = false;
  s.run(0.1);
  EXPECT_FALSE(s.hand.exists("bench/fold"));
  EXPECT_TRUE(s.stage.find("io/limit/1/-"));
}

TEST(RightColumn, OfABusTheBenchHasARowForEachDevice) {
  ConsoleStage s;
  std::vector<Tab*> members;
  for (int id = 1; id <= 3; ++id) {
    Catalog c = example_catalog(1);
    c.address = id;
    c.axes[0].name = c.id();
    members.push_back(s.add(std::move(c)).tab);
  }
  s.console.join(members, "Example 01-03");
  s.run(0.1);
  EXPECT_LT(top_of(s, "bench/jam/01"), top_of(s, "bench/jam/02"));
  EXPECT_LT(top_of(s, "bench/jam/02"), top_of(s, "bench/jam/03"));
  MUST(s.hand.click("bench/jam/03"));
  ASSERT_TRUE(s.examples[2].last_operated<bench::Jam>());
  EXPECT_TRUE(s.examples[2].last_operated<bench::Jam>()->on);
  EXPECT_TRUE(s.examples[0].operated.empty()) << "the one in front is left alone";
}

/// In the order in which ImGui draws; -1: there is no such window.
int place_in_drawing_order(std::string_view name) {
  const ImVector<ImGuiWindow*>& windows = ImGui::GetCurrentContext()->Windows;
  for (int i = 0; i < windows.Size; ++i)
    if (std::string_view(windows[i]->Name).find(name) != std::string_view::npos) return i;
  return -1;
}

// The borders of the columns are windows of their own, which come with a larger size.
TEST(RightColumn, AnOpenDialogStaysAboveWhatComesLater) {
  ConsoleStage s(1024, 700);
  Example& a = s.add();
  s.run(0.1);
  s.console.dialogs.names(*a.tab);
  s.run(0.1);
  MUST(s.hand.window(1440, 900));
  s.run(0.1);
  const int border = place_in_drawing_order("##splitter/right"), dialog = place_in_drawing_order("dialog");
  ASSERT_GE(border, 0);
  ASSERT_GE(dialog, 0);
  EXPECT_GT(dialog, border);
}

}  // namespace
}  // namespace hw::panels
