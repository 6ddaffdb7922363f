// Every kind of open list: Esc closes it and stops everything, and says so; a click outside and choosing
// close it.
#include <gmock/gmock.h>

#include "tests/panels/console_stage.h"
#include "tests/panels/must.h"

namespace hw::panels {
namespace {

using gui::InputEvent;
using ::testing::HasSubstr;

struct Lists : testing::Test {
  ConsoleStage s;
  Example& a = s.add();

  /// How it opens, and something that is seen while it is open.
  struct List {
    std::vector<const char*> opened_by;
    const char* row;
  };
  const std::vector<List> all = {
      {{"menu"}, "menu/help"},
      {{"dro/1/position"}, "dro/1/copy"},
      {{"dro/unit"}, "dro/unit/steps"},
      {{"home/mode"}, "home/mode/onto the home switch"},
      {{"program/more"}, "program/more/Find"},
      {{"dro/unit", "dro/unit/axis/1"}, "dro/unit/axis/1/table"},
  };
  void open(const List& list) {
    for (const char* id : list.opened_by) MUST(s.hand.click(id));
    s.run(0.1);
    ASSERT_TRUE(s.stage.find(list.row)) << list.row;
  }
  std::string toasts() {
    std::string text;
    for (const auto& toast : s.console.toasts().list()) text += toast.shown_text + "\n";
    return text;
  }
};

TEST_F(Lists, EscClosesItAndStopsAndReportsWhatItStopped) {
  s.run(0.1);
  for (const List& list : all) {
    open(list);
    const int stops = a.count<intent::Stop>();
    a.now.axes[0].activity = Activity::moving;
    s.run(0.1);
    MUST(s.hand.key("Escape"));
    s.run(0.2);
    EXPECT_FALSE(s.stage.find(list.row)) << list.row;
    EXPECT_EQ(a.count<intent::Stop>(), stops + 1) << list.row;
    EXPECT_THAT(toasts(),
                HasSubstr("Esc closed the open list or dialog. It also stopped Example, which was moving."))
        << list.row;
    a.now.axes[0].activity = Activity::idle;
    s.run(7);
  }
}

TEST_F(Lists, WhereNothingMovedThatIsReported) {
  s.run(0.1);
  open(all[0]);
  MUST(s.hand.key("Escape"));
  s.run(0.1);
  EXPECT_EQ(a.count<intent::Stop>(), 1);
  EXPECT_THAT(toasts(), HasSubstr("Nothing was moving or running."));
}

TEST_F(Lists, EscWithoutAListIsTheStopAlone) {
  a.now.axes[0].activity = Activity::moving;
  s.run(0.1);
  MUST(s.hand.key("Escape"));
  s.run(0.1);
  EXPECT_EQ(a.count<intent::Stop>(), 1);
  EXPECT_EQ(toasts(), "");
}

TEST_F(Lists, OfSeveralThoseThatMovedOrRanAreNamed) {
  Example& b = s.add();
  Example& c = s.add();
  s.console.rename(*a.tab, "stage");
  s.console.rename(*b.tab, "table");
  s.console.rename(*c.tab, "laser");
  a.now.axes[1].activity = Activity::homing;
  b.now.program.run = RunState::running;
  c.now.link.state = LinkState::lost;
  s.run(0.1);
  open(all[0]);
  MUST(s.hand.key("Escape"));
  s.run(0.1);
  EXPECT_THAT(toasts(), HasSubstr("It also stopped stage, which was moving. It also stopped table, which was "
                                  "running. Stop does not reach laser."));
}

TEST_F(Lists, AClickOutsideClosesItAndStopsNothing) {
  s.run(0.1);
  for (const List& list : all) {
    open(list);
    const ImVec2 outside(700, 300);
    s.stage.push(InputEvent::mouse_button(0, true, outside, s.stage.now_s));
    s.stage.push(InputEvent::mouse_button(0, false, outside, s.stage.now_s));
    s.run(0.2);
    EXPECT_FALSE(s.stage.find(list.row)) << list.row;
    s.run(0.2);
  }
  EXPECT_EQ(a.count<intent::Stop>(), 0);
}

TEST_F(Lists, ChoosingClosesIt) {
  s.run(0.1);
  for (const List& list : {all[1], all[2], all[3]}) {
    open(list);
    MUST(s.hand.click(list.row));
    s.run(0.2);
    EXPECT_FALSE(s.stage.find(list.row)) << list.row;
  }
}

}  // namespace
}  // namespace hw::panels
