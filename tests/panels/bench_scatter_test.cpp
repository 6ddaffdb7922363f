// The row of the bench that says how well its switches repeat.
#include <gtest/gtest.h>

#include "tests/panels/console_stage.h"
#include "tests/panels/must.h"

namespace hw::panels {
namespace {

TEST(BenchScatter, IsSetForEveryAxisAndReportedAsTheBenchHasIt) {
  ConsoleStage s;
  Example& a = s.add();
  s.run(0.1);
  EXPECT_EQ(s.value("bench/scatter"), "none");
  MUST(s.hand.click("bench/scatter"));
  std::vector<const bench::Place*> places;
  for (const BenchCommand& command : a.operated)
    if (const auto* place = std::get_if<bench::Place>(&command)) places.push_back(place);
  ASSERT_EQ(places.size(), 2u);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(places[i]->axis.index, i);
    ASSERT_TRUE(places[i]->place.scatter);
    EXPECT_NEAR(static_cast<double>(places[i]->place.scatter->value), 25, 3) << "the middle of the line";
    EXPECT_FALSE(places[i]->place.minus) << "the switches stay where they are";
  }
  a.bench.switches[0].scatter = Steps(6);
  s.run(0.05);
  EXPECT_EQ(s.value("bench/scatter"), "up to 6");
}

}  // namespace
}  // namespace hw::panels
