// How far an axis still goes when it is stopped, by what is known of its set-up.
#include <gtest/gtest.h>

#include "core/device/snapshot.h"
#include "core/devices/pmx_4ex_sa/catalog.h"

namespace hw::arcus {
namespace {

struct StoppingWayTest : ::testing::Test {
  void set(const char* name, std::int64_t value) {
    ParamState& p = now.params[static_cast<std::size_t>(catalog.find_param(name))];
    p.known = true, p.value = value;
  }
  std::optional<double> way(int axis) {
    return catalog.stopping_way(catalog, now, AxisId{static_cast<std::uint8_t>(axis)});
  }
  Catalog catalog = pmx_4ex_sa::make_catalog({}).value();
  Snapshot now;
};

TEST_F(StoppingWayTest, IsThatOfTheRampFromThePresentSpeed) {
  now.axes[0].speed = Pps{1000};
  EXPECT_FALSE(way(0)) << "nothing was read yet";
  set("HS", 1000), set("LS", 100), set("ACC", 300);
  EXPECT_DOUBLE_EQ(way(0).value_or(-1), 165) << "0.3 s at 550 on average";
  now.axes[0].speed = Pps{550};
  EXPECT_DOUBLE_EQ(way(0).value_or(-1), 0.15 * 325);
  set("EDEC", 1), set("DEC", 600);
  EXPECT_DOUBLE_EQ(way(0).value_or(-1), 0.3 * 325);
  now.axes[0].speed = Pps{};
  EXPECT_FALSE(way(0));
}

TEST_F(StoppingWayTest, AnAxisWithSpeedsOfItsOwnHasItsOwnRamp) {
  set("HS", 1000), set("LS", 100), set("ACC", 300);
  set("HSY", 2000), set("LSY", 100), set("ACCY", 1000);
  now.axes[0].speed = now.axes[1].speed = Pps{1000};
  EXPECT_DOUBLE_EQ(way(0).value_or(-1), 165);
  EXPECT_NEAR(way(1).value_or(-1), 550 * 900.0 / 1900, 1e-9);
}

}  // namespace
}  // namespace hw::arcus
