// Hands on plants, and what is seen of them: what every emulator with loads does.
#include "core/emulation/plant_bench.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace hw {
namespace {

using testing::HasSubstr;

class PlantBench : public testing::Test {
 protected:
  Result<> act(const BenchCommand& command) {
    return act_on_plants(
        command, [this](AxisId a) { return a.index < plants.size() ? &plants[a.index] : nullptr; },
        [this](AxisId a) { changed.push_back(a.index); }, [this](bool on) { power.push_back(on); });
  }
  std::string refusal(const BenchCommand& command) {
    const auto acted = act(command);
    return acted ? "" : acted.error().sentence();
  }
  std::array<motion::Plant, 2> plants;
  std::vector<int> changed;
  std::vector<bool> power;
};

TEST_F(PlantBench, EachHandActsOnTheAxisThatItNames) {
  EXPECT_TRUE(act(bench::Limit(AxisId{1}, Sign::plus, true)));
  EXPECT_TRUE(act(bench::HomeSwitch(AxisId{1}, true)));
  EXPECT_TRUE(act(bench::Jam(AxisId{0}, true)));
  EXPECT_TRUE(act(bench::Slip(AxisId{0}, Steps(-7))));
  AxisPlace place;
  place.minus = Steps(-50), place.plus = Steps(60);
  EXPECT_TRUE(act(bench::Place(AxisId{0}, place)));
  EXPECT_TRUE(plants[1].limit_by_hand(Sign::plus));
  EXPECT_FALSE(plants[1].limit_by_hand(Sign::minus));
  EXPECT_TRUE(plants[1].home_by_hand());
  EXPECT_TRUE(plants[0].jammed());
  EXPECT_EQ(plants[0].load(), Steps(-7));
  EXPECT_EQ(plants[0].turns_until_limit(Sign::plus), std::nullopt) << "a jammed load does not get there";
  EXPECT_THAT(changed, testing::ElementsAre(1, 1, 0, 0, 0));
}

TEST_F(PlantBench, APowerCycleIsOffThenOn) {
  EXPECT_TRUE(act(bench::PowerCycle()));
  EXPECT_TRUE(act(bench::Power(false)));
  EXPECT_EQ(power, (std::vector<bool>{false, true, false}));
}

TEST_F(PlantBench, OperationsThatTheBenchLacksAreRefused) {
  EXPECT_THAT(refusal(bench::Jam(AxisId{2}, true)), HasSubstr("no axis number 3. Nothing was changed."));
  EXPECT_THAT(refusal(bench::Input(1, true)), HasSubstr("The bench of this controller cannot do that"));
  AxisPlace half;
  half.home_from = Steps(3);
  EXPECT_THAT(refusal(bench::Place(AxisId{0}, half)), HasSubstr("A home zone needs both ends."));
  AxisPlace servo;
  servo.motor.emplace();
  EXPECT_THAT(refusal(bench::Place(AxisId{0}, servo)), HasSubstr("stepping motors"));
  EXPECT_TRUE(check_place(servo, true));
  EXPECT_TRUE(changed.empty()) << "nothing was done";
}

TEST_F(PlantBench, TheViewShowsEachAxisInItsOwnBit) {
  BenchView view;
  view.limits_minus = view.jammed = 3;  // of the frame before
  plants[1].operate_limit(Sign::minus, true);
  plants[1].slip(Steps(12));
  plants[0].operate_home(true);
  for (int a = 0; a < 2; ++a) show_plant(view, a, SeenPlant(plants[static_cast<std::size_t>(a)]));
  EXPECT_EQ(view.limits_minus, 2u);
  EXPECT_EQ(view.limits_minus_by_hand, 2u);
  EXPECT_EQ(view.limits_plus, 0u);
  EXPECT_EQ(view.homes_by_hand, 1u);
  EXPECT_EQ(view.jammed, 0u);
  EXPECT_EQ(view.load_position[1], Steps(12));
  show_plant(view, 0, {plants[0], false, true});
  EXPECT_EQ(view.limits_plus, 1u) << "as the controller's own wiring says";
  EXPECT_EQ(view.limits_plus_by_hand, 0u);
}

}  // namespace
}  // namespace hw
