// Staircases as command strings, checked by the language that the board's own rules are written in.
#include "core/devices/vme58/staircase_text.h"

#include <gmock/gmock.h>

#include "core/device/servo_tuning.h"
#include "core/devices/vme58/catalog.h"
#include "core/devices/vme58/program_check.h"

namespace hw::vme58 {
namespace {

Catalog board() { return *make_catalog({}); }

void expect_taken(const std::string& text) {
  for (const Problem& p : check_program(text).problems)
    EXPECT_FALSE(p.error) << "line " << p.line + 1 << ": " << p.sentence << "\n" << text;
}

TEST(StaircaseText, BothWays) {
  StaircasePlan plan;
  plan.axis = AxisId{1};
  plan.steps = {{Steps(1000), Pps(500)}, {Steps(5000), Pps(2000)}};
  plan.stop_at = Steps(6000);
  const Catalog c = board();
  auto text = staircase_text(plan, c);
  ASSERT_TRUE(text) << text.error().sentence();
  EXPECT_EQ(*text, "AY\nMP\nMV1000,500;\nMV5000,2000;\nSP6000;\n");
  expect_taken(*text);
  plan.from = Steps(9000);
  EXPECT_FALSE(staircase_text(plan, c)) << "5000 does not lie behind 1000 on the way down";
  plan.steps = {{Steps(8000), Pps(500)}};
  text = staircase_text(plan, c);
  ASSERT_TRUE(text);
  EXPECT_EQ(*text, "AY\nMM\nMV8000,500;\nSP6000;\n");
}

TEST(Gains, StandUnderTheHeadingThatTheTuningPanelLooksFor) {
  const Catalog c = board();
  const int kp = c.find_param("KPX");
  ASSERT_GE(kp, 0);
  EXPECT_EQ(c.params[static_cast<std::size_t>(kp)].group, servo_loop_group);
}

}  // namespace
}  // namespace hw::vme58
