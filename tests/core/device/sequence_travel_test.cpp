// What a sequence is made of is bound by the user's travel before it is run, loops and their distances too.
#include "core/device/sequence_travel.h"

#include <gmock/gmock.h>

#include "core/device/registry.h"
#include "core/device/travel_check.h"
#include "core/sequence/places_before.h"

namespace hw {
namespace {

namespace seq = sequence;
using ::testing::HasSubstr;

struct SequenceTravel : testing::Test {
  SequenceTravel() {
    s.axes = {{"X"}, {"Y"}};
    now.axis_count = 2;
    for (AxisState& axis : now.axes) axis.position_known = true;
    now.axes[0].travel = {true, true, Steps(-1000), Steps(1000)};
  }
  static seq::Step by(double x) {
    seq::Move m;
    m.to[0] = x, m.relative = true;
    return {m};
  }
  static seq::Step to(double x, std::optional<double> y = {}) {
    seq::Move m;
    m.to[0] = x, m.to[1] = y;
    return {m};
  }
  std::vector<AxisTarget> places() { return places_of_run(s, catalog, now); }
  std::string refusal() {
    const auto past = past_travel(catalog, now, intent::RunProgram(0, places()));
    return past ? describe_past(catalog, *past, words_in_steps(catalog, now).position) : "";
  }
  const DeviceType& type = *find_device_type("pmx-4ex-sa");
  const Catalog catalog = *type.make_catalog({});
  Snapshot now;
  seq::Sequence s;
};

TEST_F(SequenceTravel, DistancesInALoopAddUpFromWhereTheAxisStands) {
  s.steps = {{seq::Repeat{9, {by(100)}}}};
  EXPECT_EQ(refusal(), "");
  now.axes[0].position = Steps(250);
  EXPECT_THAT(refusal(), HasSubstr("1150 pulses lies 150 pulses past the + limit of axis X, 1000"));
}

TEST_F(SequenceTravel, ALoopThatMovesOnForEverIsReportedAsLeavingTheLimit) {
  s.steps = {{seq::Repeat{0, {by(-3)}}}};
  EXPECT_THAT(
      refusal(),
      HasSubstr(
          "An endless loop moves axis X further in each pass, and so goes past its \u2212 limit, -1000"));
  s.steps = {{seq::Repeat{0, {by(-3), by(3)}}}};
  EXPECT_EQ(refusal(), "") << "it comes back";
  now.axes[0].travel = {};
  s.steps = {{seq::Repeat{0, {by(-3)}}}};
  EXPECT_EQ(refusal(), "") << "there is no limit";
}

TEST_F(SequenceTravel, ACountThatIsNotToBeTrustedIsOnlyNamedWhereItIsGoneBy) {
  now.axes[0].trust.doubt(Doubt::power_cut, {});
  const auto doubtful = [&] { return doubtful_axes(catalog, now, intent::RunProgram(0, places())); };
  s.steps = {to(5)};
  EXPECT_EQ(doubtful(), 1u);
  s.steps = {by(5)};
  EXPECT_EQ(doubtful(), 0u);
  s.steps = {{seq::Home{0}}, to(5)};
  EXPECT_EQ(doubtful(), 0u) << "its count is set first";
  s.steps = {by(5), {seq::Home{0}}, to(5)};
  EXPECT_EQ(doubtful(), 0u) << "a distance goes by no count";
  s.steps = {{seq::MoveOnInput{1, true, seq::MoveOnInput::Kind::home, 0}}, to(5)};
  EXPECT_EQ(doubtful(), 1u) << "the input may not let it be homed";
  s.pen_up = {to(5)};
  s.steps = {{seq::Pen{false}}, {seq::Home{0}}};
  EXPECT_EQ(doubtful(), 1u) << "the tool is lifted by it";
}

TEST_F(SequenceTravel, AnAxisThatStaysWhereItIsIsNotNamed) {
  now.axes[1].position = Steps(5000);
  now.axes[1].travel = {true, true, Steps(0), Steps(10)};
  s.steps = {to(5)};
  ASSERT_EQ(places().size(), 2u);
  for (const AxisTarget& place : places()) EXPECT_EQ(place.axis.index, 0);
}

TEST_F(SequenceTravel, HugeNumbersAreNoWayRound) {
  s.axes[0].per_unit = 1e12;
  s.steps = {to(1e12)};
  EXPECT_THAT(refusal(), HasSubstr("past the + limit"));
}

// The board itself is asked where a contour comes to rest.
TEST(ContourEnd, IsWhereItsRampTakesTheAxes) {
  const DeviceType& board = *find_device_type("vme58");
  const Catalog catalog = *board.make_catalog({});
  seq::Sequence s;
  s.axes = {{"X"}, {"Y"}};
  seq::Contour c;
  c.x = 3000, c.lead_in = 3000, c.own = seq::Speeds{10000};
  seq::Move right, up;
  right.to[0] = 9000, up.to[0] = 9000, up.to[1] = 5000;
  c.steps = {{right}, {up}};
  for (const seq::Speeds& speeds :
       {seq::Speeds{10000, 0, 500}, seq::Speeds{10000, 2000, 400}, seq::Speeds{20000, 0, 500}}) {
    s.steps = {{seq::Speed{speeds}}, {c}, {seq::WaitMotion{}}};
    const auto written = board.language().write(s, catalog);
    ASSERT_TRUE(written) << written.error().sentence();
    const auto rehearsed = board.language().rehearse(written->text, {});
    ASSERT_TRUE(rehearsed) << rehearsed.error().sentence();
    const seq::Places end = places_before(s, {2});
    for (const std::size_t a : {0u, 1u}) {
      ASSERT_TRUE(end[a]);
      EXPECT_NEAR(static_cast<double>(rehearsed->axes[a].position), *end[a], 1);
    }
  }
}

}  // namespace
}  // namespace hw
