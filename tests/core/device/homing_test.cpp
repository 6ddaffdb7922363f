// Ways of homing: which directions they have, and which of them makes a doubtful count known.
#include "core/device/homing.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace hw {
namespace {

using testing::HasSubstr;

Catalog two_ways() {
  Catalog c;
  c.short_name = "Toy";
  c.axes = {{"X", ""}};
  c.homing_modes = {{.id = "dead", .label = "stop at the switch", .sets_position = false},
                    {.id = "limit", .label = "to the limit switch", .only_direction = Sign::minus}};
  return c;
}

std::string refusal(const Catalog& catalog, const intent::Home& request) {
  const auto checked = check_home(catalog, request);
  return checked ? "" : checked.error().sentence();
}

TEST(Homing, AWayWithOneDirectionIsRefusedInTheOther) {
  const Catalog c = two_ways();
  EXPECT_EQ(refusal(c, {AxisId{0}, Sign::minus, 1}), "");
  EXPECT_EQ(refusal(c, {AxisId{0}, Sign::plus, 0}), "") << "this one has both";
  const std::string refused = refusal(c, {AxisId{0}, Sign::plus, 1});
  EXPECT_THAT(refused, HasSubstr("to the limit switch runs only in the \u2212 direction"));
  EXPECT_THAT(refused, HasSubstr("Nothing was sent."));
}

TEST(Homing, AMissingAxisOrHomingModeIsRefused) {
  Catalog c = two_ways();
  EXPECT_THAT(refusal(c, {AxisId{1}, Sign::minus, 0}), HasSubstr("no axis 2"));
  EXPECT_THAT(refusal(c, {AxisId{0}, Sign::minus, 2}), HasSubstr("no homing mode number 2"));
  c.can.homes = false;
  EXPECT_THAT(refusal(c, {AxisId{0}, Sign::minus, 0}), HasSubstr("A Toy has no homing"));
}

TEST(Homing, TheModeThatSetsTheCountIsFoundForEachDirection) {
  Catalog c = two_ways();
  EXPECT_EQ(homing_that_sets(c, 0, Sign::minus), 1) << "the chosen one leaves the count";
  EXPECT_EQ(homing_that_sets(c, 1, Sign::minus), 1);
  EXPECT_EQ(homing_that_sets(c, -1, Sign::plus), 0) << "no mode sets it there";
  c.homing_modes.erase(c.homing_modes.begin());
  EXPECT_EQ(homing_that_sets(c, 0, Sign::plus), std::nullopt);
}

}  // namespace
}  // namespace hw
