// A servo axis in the console: its place, its command and its error, and the question before it is driven.
#include <gmock/gmock.h>

#include "tests/panels/console_stage.h"
#include "tests/panels/must.h"

namespace hw::panels {
namespace {

Catalog servo_catalog(int axes) {
  Catalog c = example_catalog(axes);
  for (AxisInfo& axis : c.axes) axis.servo = axis.switchable = true;
  return c;
}

struct ServoAxis : testing::Test {
  ConsoleStage s;
  Example* e = nullptr;
  void open(int axes) {
    e = &s.add(servo_catalog(axes));
    for (int i = 0; i < axes; ++i) e->now.axes[i].loop = Loop::in_place;
    s.run(0.1);
  }
  AxisState& second() { return e->now.axes[1]; }
  void leave_behind() {
    second().loop = Loop::off_place;
    second().command = Steps(5000);
    second().far_off = true;
    s.run(0.1);
  }
  /// The driver asks first.
  void ask(const char* sentence) {
    e->outcome(IntentState::refused, sentence);
    e->now.outcomes[0].asks = true;
    s.run(0.1);
  }
  void click(const char* id) {
    const auto done = s.hand.click(id);
    ASSERT_TRUE(done) << id << ": " << done.error().sentence();
    s.run(0.1);
  }
  int toasts() { return static_cast<int>(s.console.toasts().list().size()); }
};

TEST_F(ServoAxis, ShowsPlaceCommandAndError) {
  for (const int axes : {2, 4, 8}) {
    open(axes);
    EXPECT_EQ(s.value("dro/2/state"), "IN PLACE") << axes;
    leave_behind();
    EXPECT_EQ(s.value("dro/2/state"), "OFF PLACE") << axes;
    EXPECT_EQ(s.value("dro/2/position"), "0");
    EXPECT_EQ(s.value("dro/2/command"), "5000");
    EXPECT_EQ(s.value("dro/2/error"), "5000");
    second().loop = Loop::open;
    s.run(0.1);
    EXPECT_EQ(s.value("dro/2/state"), "OPEN LOOP") << axes;
    second().loop = Loop::none;
    s.run(0.1);
    EXPECT_EQ(s.value("dro/2/state"), "IDLE") << "a step axis says what it always said";
    EXPECT_FALSE(s.stage.find("dro/2/error"));
  }
}

TEST_F(ServoAxis, ItsPowerStandsStillWhileItsStateChanges) {
  open(4);
  const auto left = [this] { return s.stage.find("dro/2/power")->rect.min.x; };
  const float before = left();
  for (const Loop loop : {Loop::following, Loop::off_place, Loop::open}) {
    second().loop = loop;
    s.run(0.1);
    EXPECT_EQ(left(), before) << static_cast<int>(loop);
  }
}

TEST_F(ServoAxis, ClosingTheLoopIsAskedFirstAndSentAgainWithTheAnswer) {
  open(2);
  leave_behind();
  second().loop = Loop::open;
  second().enabled = false;
  s.run(0.1);
  click("dro/2/power");
  const auto* power = e->last<intent::SetPower>();
  ASSERT_TRUE(power);
  EXPECT_EQ(power->closing, intent::Closing::ask);
  ask("The loop of 2 is open, and its encoder stands 5000 counts from its command.");
  EXPECT_TRUE(s.stage.find("closing/cancel"));
  EXPECT_EQ(toasts(), 0) << "the dialog says it";
  click("closing/stay");
  EXPECT_EQ(e->count<intent::SetPower>(), 2);
  EXPECT_EQ(e->last<intent::SetPower>()->closing, intent::Closing::stay);
  EXPECT_TRUE(e->last<intent::SetPower>()->on);
  EXPECT_FALSE(s.stage.find("closing/cancel"));

  e->now.outcomes[0].asks = false;
  e->outcome(IntentState::done);
  s.run(0.1);
  click("dro/2/power");
  ask("Again.");
  click("closing/drive");
  EXPECT_EQ(e->last<intent::SetPower>()->closing, intent::Closing::drive);
  EXPECT_EQ(e->count<intent::SetPower>(), 4);
}

TEST_F(ServoAxis, CancelAndEscapeSendNothing) {
  open(2);
  leave_behind();
  for (const bool by_key : {false, true}) {
    const int before = e->count<intent::SetPower>();
    click("dro/2/power");
    ask("Far off.");
    ASSERT_TRUE(s.stage.find("closing/cancel"));
    if (by_key) {
      ASSERT_TRUE(s.hand.key("Escape"));
      s.run(0.1);
    } else {
      click("closing/cancel");
    }
    EXPECT_FALSE(s.stage.find("closing/cancel"));
    EXPECT_EQ(e->count<intent::SetPower>(), before + 1) << "the first, which was refused";
    e->now.outcomes[0].asks = false;
  }
}

}  // namespace
}  // namespace hw::panels
