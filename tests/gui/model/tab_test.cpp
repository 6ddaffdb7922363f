#include "gui/model/tab.h"

#include <gtest/gtest.h>

namespace hw::gui {
namespace {

class TabTest : public testing::Test {
 protected:
  static Catalog two_axes() {
    Catalog c;
    c.name = "Example Two";
    c.short_name = "Two";
    c.axes = {{"1", "motor 1"}, {"2", "motor 2"}};
    c.units = {{"screw", "mm", 0.0025, 3}, {"screw in inches", "inch", 0.0001, 4}};
    c.program.slot_word = "Program";
    ParamInfo type;
    type.axis = 0;
    type.before_moving = "No motor is chosen.";
    c.params.push_back(type);
    return c;
  }
  std::vector<IntentBody> sent;
  Snapshot now;
  BenchView bench;
  Tab tab{Address(),
          two_axes(),
          {[this](IntentBody body, std::optional<double>) {
             sent.push_back(std::move(body));
             return static_cast<IntentId>(sent.size());
           },
           [](BenchCommand) {}}};

  TabTest() {
    now.axis_count = 2;
    now.link.state = LinkState::good;
  }
  void show() { tab.show(now, bench, Instant{}); }
};

TEST_F(TabTest, EveryStopEndsWhatIsBeingPrepared) {
  const auto begin = [this] {
    tab.desk().programs.job.begin(ProgramJob::Goal::clear, 0, tab.desk().programs.texts, now, tab.catalog(),
                                  [this](IntentBody body) { return tab.send(std::move(body)); });
    return tab.desk().until_stopped();
  };
  std::weak_ptr<void> go_ahead = begin();
  EXPECT_FALSE(go_ahead.expired());
  tab.stop_all();
  EXPECT_TRUE(go_ahead.expired());
  go_ahead = begin();
  tab.stopped_with(99);
  EXPECT_TRUE(go_ahead.expired());
  go_ahead = begin();
  tab.send(intent::HaltProgram());
  EXPECT_TRUE(go_ahead.expired());
}

TEST_F(TabTest, UnitsComeFromTheProfile) {
  EXPECT_EQ(tab.settings.unit(AxisId{0}).name, "steps");
  tab.settings.profile.unit = "real";
  tab.settings.profile.axes[1].unit_choice = "screw";
  tab.settings.edited();
  EXPECT_EQ(tab.settings.unit(AxisId{0}).name, "steps") << "an axis without a conversion stays in steps";
  EXPECT_EQ(tab.settings.unit(AxisId{1}).name, "mm");
  tab.settings.profile.unit = "steps";
  tab.settings.edited();
  EXPECT_FALSE(tab.settings.unit(AxisId{1}).real);
  EXPECT_TRUE(tab.settings.changed);
}

TEST_F(TabTest, NamesComeFromTheProfileElseFromTheCatalog) {
  EXPECT_EQ(tab.name(), "Two");
  tab.settings.profile.name = "Stage";
  EXPECT_EQ(tab.name(), "Stage");
}

TEST_F(TabTest, AnUnwatchedRefusalBecomesAComplaint) {
  const IntentId id = tab.send_followed(intent::Home(AxisId{0}, Sign::minus));
  show();
  EXPECT_TRUE(tab.messages.complaints().empty());
  now.outcomes[0].id = id;
  now.outcomes[0].state = IntentState::refused;
  now.outcomes[0].sentence = "Not now. Nothing was sent.";
  show();
  show();
  ASSERT_EQ(tab.messages.complaints().size(), 1u) << "once";
  EXPECT_EQ(tab.messages.complaints()[0], "Not now. Nothing was sent.");
}

TEST_F(TabTest, ATapRefusedAtALimitIsReportedByThePadElseByAComplaint) {
  const auto refuse_a_tap = [this] {
    const JogHold::Control plus{JogHold::Source::keyboard, AxisId{0}, Sign::plus};
    tab.jog.press(plus, {Steps(1), Pps()}, 0);
    tab.jog.release(plus, 0.1);
    now.outcomes[0].id = tab.jog.tap_intent();
    now.outcomes[0].state = IntentState::refused;
    now.outcomes[0].past = PastTravel{AxisId{0}, Sign::plus, Steps(11), Steps(10)};
    show();
  };
  refuse_a_tap();
  EXPECT_EQ(tab.messages.complaints().size(), 1u) << "no pad is drawn";
  EXPECT_FALSE(tab.messages.tap_past_limit);
  tab.messages.look_at_pad();
  refuse_a_tap();
  EXPECT_EQ(tab.messages.complaints().size(), 1u);
  EXPECT_TRUE(tab.messages.tap_past_limit);
  refuse_a_tap();
  EXPECT_EQ(tab.messages.complaints().size(), 2u) << "it was drawn in an earlier frame only";
}

TEST_F(TabTest, ARefusedJogIsNotHeldOn) {
  tab.jog.press({JogHold::Source::mouse, AxisId{0}, Sign::plus}, {Steps(1), Pps()}, 0);
  for (double t = 0; t < 0.3; t += 0.016) {
    tab.jog.confirm({JogHold::Source::mouse, AxisId{0}, Sign::plus});
    tab.jog.tick(t);
  }
  ASSERT_TRUE(tab.jog.jogging());
  now.outcomes[0].id = tab.jog.jog_intent();
  now.outcomes[0].state = IntentState::refused;
  show();
  EXPECT_FALSE(tab.jog.holding());
}

TEST_F(TabTest, StopEndsTheHoldWithoutASecondStop) {
  tab.jog.press({JogHold::Source::mouse, AxisId{0}, Sign::plus}, {Steps(1), Pps()}, 0);
  tab.stop_all();
  tab.jog.release({JogHold::Source::mouse, AxisId{0}, Sign::plus}, 0.1);
  ASSERT_EQ(sent.size(), 1u);
  EXPECT_TRUE(std::holds_alternative<intent::Stop>(sent[0]));
}

TEST_F(TabTest, ReportsWhyNothingMayMove) {
  show();
  EXPECT_EQ(tab.why_not_move(), "");
  now.program.owned = true;
  now.program.slot = 0;
  now.program.run = RunState::running;
  show();
  EXPECT_EQ(tab.why_not_move(),
            "Program 0 is running. Jog, Go and Home are available again when it ends or is stopped.");
  now.link.state = LinkState::lost;
  show();
  EXPECT_EQ(tab.why_not_move(),
            "There is no link. Jog, Go and Home are available again when the controller answers.");
}

}  // namespace
}  // namespace hw::gui
