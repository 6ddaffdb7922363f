// Errors are cleared where they are shown: in the status line that tells of them, and at the axis.
#include "gui/model/clearing.h"

#include <gtest/gtest.h>

#include "tests/panels/console_stage.h"

namespace hw::panels {
namespace {

Catalog with_clearing() {
  Catalog c = example_catalog();
  ActionInfo clear;
  clear.id = "clear";
  clear.label = "Clear errors";
  clear.help = "Clears limit errors.";
  ActionField axis;
  axis.id = "axis";
  axis.choices = {{-1, "all axes"}, {0, "1"}, {1, "2"}};
  axis.fallback = -1;
  clear.fields = {axis};
  c.actions = {clear};
  c.axis_tables = {{"Motion", "", {{AxisColumn::Shows::motion, "clear", "what it does"}}}};
  return c;
}

TEST(Clearing, TheStatusLineClearsTheAxisThatItNames) {
  ConsoleStage s;
  Example& a = s.add(with_clearing());
  a.tab->view.unset_read = true;
  s.run(0.2);
  EXPECT_FALSE(s.stage.find("status/clear")) << "there is nothing to clear";
  a.now.axes[1].activity = Activity::error;
  a.now.axes[1].error = AxisError::limit_plus;
  s.run(0.2);
  const gui::Widget* button = s.stage.find("status/clear");
  ASSERT_TRUE(button);
  EXPECT_EQ(button->label, "Clear 2");
  ASSERT_TRUE(s.hand.click("status/clear").has_value());
  s.run(0.1);
  ASSERT_TRUE(a.last<intent::Act>());
  EXPECT_EQ(a.last<intent::Act>()->values, std::vector<std::int64_t>{1}) << "of that axis alone";
  ASSERT_TRUE(std::holds_alternative<intent::Act>(a.sent.back()));
  a.outcome(IntentState::refused, "Not now.");
  s.run(0.1);
  ASSERT_FALSE(s.console.toasts().list().empty());
  EXPECT_EQ(s.console.toasts().list().back().text, "Not now.");
  a.now.link.state = LinkState::lost;
  s.run(0.2);
  EXPECT_FALSE(s.stage.find("status/clear")) << "nobody would hear it";
}

TEST(Clearing, TheMenuOfAnAxisInErrorHasIt) {
  ConsoleStage s;
  Example& a = s.add(with_clearing());
  a.tab->view.unset_read = true;
  a.now.axes[0].activity = Activity::error;
  s.run(0.2);
  ASSERT_TRUE(s.hand.click("dro/1/position").has_value());
  s.run(0.2);
  ASSERT_TRUE(s.hand.click("dro/1/menu/clear").has_value());
  s.run(0.1);
  ASSERT_TRUE(a.last<intent::Act>());
  EXPECT_EQ(a.last<intent::Act>()->values, std::vector<std::int64_t>{0});
}

TEST(Clearing, AControllerWithoutACommandForItIsStopped) {
  ConsoleStage s;
  Example& a = s.add();
  a.tab->view.unset_read = true;
  for (int i = 0; i < 2; ++i) a.now.axes[i].activity = Activity::error;
  s.run(0.2);
  const gui::Widget* button = s.stage.find("status/clear");
  ASSERT_TRUE(button);
  EXPECT_EQ(button->label, "Stop") << "all of it, not one axis";
  ASSERT_TRUE(s.hand.click("status/clear").has_value());
  s.run(0.1);
  EXPECT_EQ(a.count<intent::Stop>(), 1);
}

TEST(Clearing, AFlagThatIsNoErrorIsClearedByItsOwnAction) {
  Catalog c = with_clearing();
  c.actions[0].id = "clear_flags";
  AxisColumn flag{AxisColumn::Shows::action, "clear_flags", ""};
  flag.state = "SLIP*";
  c.axis_tables = {{"Slip", "", {flag}}};
  Snapshot now;
  now.axis_count = 2;
  now.link.state = LinkState::good;
  EXPECT_FALSE(gui::first_clearing(c, now));
  now.axes[1].slipped = true;
  const auto way = gui::first_clearing(c, now);
  ASSERT_TRUE(way);
  EXPECT_EQ(way->axis, AxisId{1});
  EXPECT_TRUE(std::holds_alternative<intent::Act>(way->request));
  EXPECT_FALSE(way->of_all);
}

TEST(Clearing, ACommandThatClearsTheFlagsOfAllAxesReportsIt) {
  Catalog c = with_clearing();
  c.actions[0].id = "clear_flags";
  c.actions[0].fields.clear();
  AxisColumn flag{AxisColumn::Shows::action, "clear_flags", ""};
  flag.state = "SLIP*";
  c.axis_tables = {{"Slip", "", {flag}}};
  ConsoleStage s;
  Example& a = s.add(c);
  a.tab->view.unset_read = true;
  a.now.axes[1].slipped = true;
  s.run(0.2);
  const gui::Widget* button = s.stage.find("status/clear");
  ASSERT_TRUE(button);
  EXPECT_EQ(button->label, "Clear all");
  ASSERT_TRUE(s.hand.click("dro/2/position").has_value());
  s.run(0.2);
  const gui::Widget* row = s.stage.find("dro/2/menu/clear");
  ASSERT_TRUE(row);
  EXPECT_EQ(row->label, "Clear the flags of all axes");
}

}  // namespace
}  // namespace hw::panels
