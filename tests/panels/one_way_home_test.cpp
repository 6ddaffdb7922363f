// A way of homing that has one direction: the other button is off and says why, and no remedy offers it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/panels/console_stage.h"
#include "tests/panels/must.h"

namespace hw::panels {
namespace {

using namespace gui;

class OneWayHomeTest : public testing::Test {
 protected:
  ConsoleStage s;
  Example& a = s.add(only_to_minus());

  static Catalog only_to_minus() {
    Catalog c = example_catalog();
    c.homing_modes = {
        {.id = "limit", .label = "to the limit switch", .only_direction = Sign::minus},
        {.id = "switch", .label = "onto the home switch", .sets_position = false},
    };
    return c;
  }
  void SetUp() override {
    s.run(0.1);
    a.tab->view.unset_read = true;
  }
};

TEST_F(OneWayHomeTest, TheOtherButtonIsOffAndShowsWhy) {
  const Widget* plus = s.stage.find("home/1/+");
  ASSERT_TRUE(plus);
  EXPECT_FALSE(plus->enabled);
  EXPECT_EQ(plus->reason, "Homing to the limit switch runs only in the \u2212 direction.");
  MUST(s.hand.click("home/1/-"));
  ASSERT_TRUE(a.last<intent::Home>());
  EXPECT_EQ(a.last<intent::Home>()->sign, Sign::minus);
}

TEST_F(OneWayHomeTest, ADoubtOffersTheDirectionThatSetsTheCount) {
  a.now.axes[0].trust.doubt(Doubt::power_cut, s.scheduler.now());
  s.run(0.1);
  MUST(s.hand.type("goto/1", "400\n"));
  a.outcome(IntentState::refused, "in the controller's own words", 1);
  s.run(0.1);
  ASSERT_TRUE(s.hand.exists("goto/1/home/-"));
  MUST(s.hand.click("goto/1/home/-"));
  ASSERT_TRUE(a.last<intent::Home>());
  EXPECT_EQ(a.last<intent::Home>()->mode, 0);
}

}  // namespace
}  // namespace hw::panels
