// A driver that lies is noticed: what it says was done is compared with what the emulated machine did, for
// every axis, verb and setting of every listed controller.
#include <algorithm>
#include <cmath>
#include <cstdlib>

#include <fmt/format.h>

#include "core/device/command_form.h"
#include "core/device/emulator.h"
#include "tests/contract/rig.h"

namespace hw {
namespace {

using std::chrono::seconds;

class TruthTest : public ContractTest {
 protected:
  void SetUp() override {
    ContractTest::SetUp();
    const auto& infos = session->catalog().axes;
    if (std::any_of(infos.begin(), infos.end(), [](const AxisInfo& a) { return a.switchable; })) {
      must(intent::SetPower(-1, true));
      run(seconds(1));
    }
  }
  void reopen() {
    TearDown();
    session.reset();
    SetUp();
  }
  static AxisId id(int i) { return AxisId{static_cast<std::uint8_t>(i)}; }
  [[nodiscard]] int axes() const { return now().axis_count; }
  [[nodiscard]] const AxisState& axis_at(int i) const { return now().axes[static_cast<std::size_t>(i)]; }
  [[nodiscard]] Steps load_of(int i) const {
    BenchView view;
    session->bench()->look(view);
    return view.load_position[static_cast<std::size_t>(i)];
  }
  void must(IntentBody body) {
    const IntentFate fate = perform(std::move(body), seconds(60));
    ASSERT_EQ(fate.fate, Fate::done) << fate.sentence.view();
  }
  void place(int i, Steps minus, Steps plus) {
    AxisPlace travel;
    travel.minus = minus;
    travel.plus = plus;
    operate(bench::Place(id(i), travel));
  }
};
INSTANTIATE_TEST_SUITE_P(Every, TruthTest, testing::ValuesIn(types_under_test()), name_of_type);

// ---- moves

TEST_P(TruthTest, EachAxisMovesItsOwnLoadAndNoOther) {
  for (int i = 0; i < axes(); ++i) {
    std::vector<Steps> before;
    for (int k = 0; k < axes(); ++k) before.push_back(load_of(k));
    const Steps distance(1000 + 100 * i);
    must(intent::MoveBy({{id(i), distance}}));
    ASSERT_TRUE(becomes_idle(seconds(30)));
    for (int k = 0; k < axes(); ++k) {
      const auto moved = (load_of(k) - before[static_cast<std::size_t>(k)]).value;
      if (k == i) {
        EXPECT_NEAR(static_cast<double>(moved), static_cast<double>(distance.value), 0.25 * 1100)
            << k << ": counts and pulses may differ, axes may not";
      } else {
        EXPECT_EQ(moved, 0) << "axis " << k << " moved with " << i;
      }
    }
    EXPECT_EQ(axis_at(i).position, distance);
    EXPECT_EQ(axis_at(i).ended_by, EndedBy::target);
  }
}

TEST_P(TruthTest, ADistanceInMinusGoesInMinus) {
  for (int i = 0; i < axes(); ++i) {
    must(intent::MoveBy({{id(i), Steps(-700)}}));
    ASSERT_TRUE(becomes_idle(seconds(30)));
    EXPECT_EQ(axis_at(i).position, Steps(-700));
    EXPECT_LT(load_of(i), Steps(-400));
  }
}

TEST_P(TruthTest, AMoveTakesTheTimeOfItsSpeed) {
  for (int i = 0; i < axes(); ++i)
    for (const double speed : {500.0, 1000.0}) {
      const Instant from = time.now();
      must(intent::MoveBy({{id(i), Steps(2000)}}, Pps{speed}));
      ASSERT_TRUE(
          run_until([&] { return !now().axis_moves(i) && time.now() - from > seconds(1); }, seconds(60)));
      const double took = std::chrono::duration<double>(time.now() - from).count();
      EXPECT_GE(took, 2000 / speed) << "axis " << i << " at " << speed;
      EXPECT_LE(took, 2000 / speed + 0.8) << "axis " << i << " at " << speed;
    }
}

TEST_P(TruthTest, AJogRunsItsWayAtItsSpeed) {
  for (int i = 0; i < axes(); ++i)
    for (const Sign sign : {Sign::minus, Sign::plus}) {
      const Steps from = load_of(i);
      must(intent::JogStart(id(i), sign, Pps{800}, false));
      run(seconds(3));
      const auto way = (load_of(i) - from).value;
      EXPECT_EQ(axis_at(i).direction, sign == Sign::plus ? 1 : -1);
      must(intent::Stop(i));
      ASSERT_TRUE(becomes_idle(seconds(20)));
      EXPECT_EQ(way > 0, sign == Sign::plus) << "axis " << i;
      EXPECT_NEAR(static_cast<double>(std::abs(way)), 2400, 0.3 * 2400) << "axis " << i;
    }
}

TEST_P(TruthTest, AbortStopsShorterThanStopAndEachSaysWhichItWas) {
  std::int64_t ran_on[2] = {0, 0};
  for (const bool at_once : {false, true}) {
    must(intent::MoveBy({{id(0), Steps(40000)}}, Pps{5000}));
    run(seconds(3));
    const Steps there = load();
    if (at_once)
      session->send(intent::Abort(0));
    else
      session->send(intent::Stop(0));
    ASSERT_TRUE(becomes_idle(seconds(30)));
    ran_on[at_once] = (load() - there).value;
    EXPECT_EQ(axis().ended_by, at_once ? EndedBy::abort : EndedBy::stop);
    EXPECT_LT(axis().position, Steps(40000 * (at_once ? 2 : 1)));
    must(intent::SetPosition(0));  // after an abort steps may be lost
  }
  EXPECT_GT(ran_on[false], ran_on[true]) << "a ramp takes its way";
}

// ---- what a position is

TEST_P(TruthTest, ASetPositionIsTheControllersOwnFromThen) {
  for (int i = 0; i < axes(); ++i) {
    must(intent::MoveTo({{id(i), Steps(400)}}));
    ASSERT_TRUE(becomes_idle(seconds(20)));
    const Steps there = load_of(i);
    must(intent::SetPosition(i, Steps(0)));
    run(seconds(1));
    EXPECT_EQ(axis_at(i).position, Steps(0));
    EXPECT_EQ(load_of(i), there) << "setting it moves nothing";
    must(intent::MoveTo({{id(i), Steps(500)}}));
    ASSERT_TRUE(becomes_idle(seconds(20)));
    EXPECT_EQ(axis_at(i).position, Steps(500));
    EXPECT_GT(load_of(i), there + Steps(350)) << "axis " << i << " counts from what was set";
  }
}

// Read again after the link was lost: what the console remembers is not what counts.
TEST_P(TruthTest, PositionsAreReadAndNotRemembered) {
  must(intent::MoveTo({{id(0), Steps(900)}}));
  ASSERT_TRUE(becomes_idle(seconds(20)));
  must(intent::SetPosition(0));
  operate(bench::Unplug(true));
  ASSERT_TRUE(run_until([this] { return now().link.state == LinkState::lost; }, seconds(10)));
  operate(bench::Unplug(false));
  ASSERT_TRUE(run_until([this] { return now().link.state == LinkState::good; }, seconds(30)));
  run(seconds(2));
  EXPECT_EQ(axis().position, Steps(0));
}

// ---- homing

struct HomedAt {
  Steps from, to;  ///< the load, in the direction of homing
};
/// By the names that modes have everywhere.
HomedAt place_of_mode(std::string_view mode, Sign sign) {
  if (mode.find("limit") != mode.npos) return {Steps(4000), Steps(5000)};
  if (mode == "index") return {Steps(600), Steps(800)};
  if (mode == "switch") return {sign == Sign::plus ? Steps(1000) : Steps(1000), Steps(5000)};
  return {Steps(900), Steps(2100)};  // from the edge of the switch to the end of the ramp behind it
}

TEST_P(TruthTest, EveryWayOfHomingEndsAtItsPlaceInItsDirection) {
  const auto modes = session->catalog().homing_modes;
  for (std::size_t mode = 0; mode < modes.size(); ++mode)
    for (const Sign sign : {Sign::minus, Sign::plus}) {
      reopen();
      AxisPlace travel;
      travel.minus = Steps(-5000);
      travel.plus = Steps(5000);
      travel.home_from = Steps(sign == Sign::plus ? 1000 : -1200);
      travel.home_to = Steps(sign == Sign::plus ? 1200 : -1000);
      travel.index_every = Steps(700);
      operate(bench::Place(id(0), travel));
      must(intent::Home(id(0), sign, static_cast<int>(mode)));
      run(Millis(50));
      const std::string what = fmt::format("{}{}", modes[mode].id, sign == Sign::plus ? "+" : "-");
      ASSERT_TRUE(becomes_idle(seconds(120))) << what;
      const std::int64_t homed = sign == Sign::plus ? load().value : -load().value;
      const HomedAt there = place_of_mode(modes[mode].id, sign);
      EXPECT_GE(homed, there.from.value) << what;
      EXPECT_LE(homed, there.to.value) << what;
      EXPECT_EQ(axis().ended_by, EndedBy::target) << what;
      EXPECT_NE(axis().activity, Activity::error) << what;
    }
}

// ---- limits

TEST_P(TruthTest, ALimitIsToldOfTheSideThatWasRunInto) {
  for (int i = 0; i < axes(); ++i)
    for (const Sign sign : {Sign::minus, Sign::plus}) {
      reopen();
      const bool plus = sign == Sign::plus;
      place(i, Steps(-1500), Steps(1500));
      must(intent::MoveBy({{id(i), Steps(plus ? 6000 : -6000)}}));
      ASSERT_TRUE(becomes_idle(seconds(30)));
      run(seconds(2));
      const std::string what = fmt::format("axis {} {}", i, plus ? "+" : "-");
      ASSERT_TRUE(axis_at(i).limits_known) << what;
      EXPECT_EQ(axis_at(i).limit_plus, plus) << what;
      EXPECT_EQ(axis_at(i).limit_minus, !plus) << what;
      EXPECT_EQ(axis_at(i).ended_by, EndedBy::limit) << what;
      for (int k = 0; k < axes(); ++k)
        EXPECT_TRUE(k == i || !(axis_at(k).limit_plus || axis_at(k).limit_minus)) << what << ": at " << k;
    }
}

// ---- set-up

/// A value that it does not have from the factory and that is harmless to try.
std::optional<std::int64_t> another_value(const ParamInfo& p) {
  if (!p.readable || !p.warning.empty() || !p.bits.empty() || !p.prefix.empty()) return std::nullopt;
  for (const ParamChoice& c : p.choices)
    if (c.value != p.fallback) return c.value;
  if (!p.choices.empty()) return std::nullopt;
  for (const std::int64_t v : {p.fallback + 7, p.fallback - 7, p.fallback + 1, p.fallback - 1})
    if (v >= p.minimum && v <= p.maximum) return v;
  return std::nullopt;
}

TEST_P(TruthTest, AChangedParameterIsReadBackFromTheController) {
  const Catalog& c = session->catalog();
  int tried = 0;
  for (std::size_t i = 0; i < c.params.size(); ++i) {
    const auto value = another_value(c.params[i]);
    if (!value) continue;
    const std::string& name = c.params[i].mnemonic;
    const IntentFate set = perform(intent::SetParam(name, *value, true), seconds(60));
    if (set.fate == Fate::refused) continue;  // by another one: in words
    ASSERT_EQ(set.fate, Fate::done) << name << ": " << set.sentence.view();
    ++tried;
    ASSERT_EQ(perform(intent::ReadParams(name), seconds(60)).fate, Fate::done) << name;
    EXPECT_EQ(now().params[i].value, *value) << name;
    ASSERT_EQ(perform(intent::SetParam(name, c.params[i].fallback, true), seconds(60)).fate, Fate::done)
        << name;
  }
  EXPECT_GE(tried, static_cast<int>(c.params.size()) / 3);
}

TEST_P(TruthTest, AnOutputIsSwitchedOnTheMachine) {
  const Catalog& c = session->catalog();
  int tried = 0;
  for (std::size_t place = 0; place < c.outputs.size(); ++place) {
    if (!c.outputs[place].settable) continue;
    for (const std::string& duty : c.outputs[place].duty.while_not_zero)
      if (c.find_param(duty) >= 0) must(intent::SetParam(duty, 0, true));
    const auto of_machine = [&] {
      BenchView view;
      session->bench()->look(view);
      return (view.outputs >> place & 1u) != 0;
    };
    bool seen[2] = {false, false};
    for (const bool on : {true, false}) {
      const IntentFate set = perform(intent::SetOutput(c.output_number(place), on));
      if (set.fate == Fate::refused) break;
      run(seconds(1));
      seen[on] = of_machine();
      EXPECT_EQ((now().outputs >> place & 1u) != 0, on) << c.outputs[place].name;
      ++tried;
    }
    EXPECT_TRUE(tried == 0 || seen[true] != seen[false]) << c.outputs[place].name;
  }
  EXPECT_TRUE(c.outputs.empty() || tried > 0);
}

// ---- raw text, forms, foreign devices

TEST_P(TruthTest, ExamplesFitTheirForms) {
  const Catalog& c = session->catalog();
  for (const CommandInfo& command : c.commands) {
    ASSERT_FALSE(command.example.empty()) << command.form;
    EXPECT_EQ(CommandForm(command, c.axes).match(command.example), CommandForm::Match::whole)
        << command.form << ": " << command.example;
  }
}

TEST_P(TruthTest, AForeignDeviceIsNotTakenForThisOne) {
  for (const DeviceType* other : types_under_test()) {
    if (other->model == GetParam()->model) continue;
    const auto catalog = other->make_catalog({});
    ASSERT_TRUE(catalog);
    if (catalog->can.window != session->catalog().can.window) continue;  // no plug fits
    const WireOpener usual = make_wire_opener();
    const WireOpener foreign = [usual, other](Scheduler& s, Address a, std::shared_ptr<BenchAccess> again) {
      a.model = other->model;
      return usual(s, std::move(a), std::move(again));
    };
    const auto opened = open_by(foreign);
    run(seconds(15));
    EXPECT_NE(opened->known().link.state, LinkState::good) << other->model;
    EXPECT_FALSE(opened->known().link.sentence.empty()) << other->model;
    EXPECT_FALSE(opened->known().axes[0].position_known) << other->model;
    asio::co_spawn(io, opened->close(), asio::detached);
    run(seconds(2));
  }
}

// ---- the emulated machine itself

TEST_P(TruthTest, OneStrideOfTimeEqualsMany) {
  must(intent::MoveBy({{id(0), Steps(3000)}}));
  session->send(intent::JogStart(id(axes() - 1), Sign::minus, {}, false));
  run(Millis(100));
  const auto once = session->bench()->emulator().clone(), often = session->bench()->emulator().clone();
  const Instant begin = time.now(), end = begin + seconds(8);
  once->advance_to(end);
  for (Instant t = begin; t < end; t += std::chrono::microseconds(700)) often->advance_to(t);
  often->advance_to(end);
  BenchView a, b;
  once->look(a);
  often->look(b);
  EXPECT_EQ(a, b);
  std::string said_once, said_often;
  once->take_output(said_once);
  often->take_output(said_often);
  EXPECT_EQ(said_once, said_often);
}

}  // namespace
}  // namespace hw
