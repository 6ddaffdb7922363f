// Every end of a motion or a program is told once, with what it was and who has ended it.
#include <map>

#include "tests/contract/another_host.h"
#include "tests/contract/rig.h"

namespace hw {
namespace {

using std::chrono::seconds;

class EndingContract : public ContractTest {
 protected:
  std::vector<Ending> endings() {
    std::vector<Ending> all;
    session->endings().drain([&all](const Ending& ending) { all.push_back(ending); });
    return all;
  }
  void switch_motor_on() {
    if (session->catalog().axes[0].switchable) perform(intent::SetPower(0, true));
    run(seconds(1));
    endings();
  }
  /// Another program on the wire stops the first axis with its ramp.
  void another_stops_it() {
    send_as_another(
        io, *session, [this](Duration d) { run(d); }, std::string(wire_texts(GetParam()->model).stop));
  }
  Ending ends_by_another() {
    run(seconds(2));
    another_stops_it();
    EXPECT_TRUE(becomes_idle(seconds(60)));
    run(seconds(1));
    const auto all = endings();
    EXPECT_EQ(all.size(), 1u);
    return all.empty() ? Ending() : all[0];
  }
};

INSTANTIATE_TEST_SUITE_P(Every, EndingContract, testing::ValuesIn(types_under_test()), name_of_type);

TEST_P(EndingContract, AMoveThatComesToItsTarget) {
  switch_motor_on();
  ASSERT_EQ(perform(intent::MoveTo({{AxisId{0}, Steps(500)}})).state, IntentState::done);
  ASSERT_TRUE(becomes_idle(seconds(60)));
  run(seconds(1));
  const auto all = endings();
  ASSERT_EQ(all.size(), 1u);
  EXPECT_EQ(all[0].what, Ending::What::motion);
  EXPECT_EQ(all[0].by, EndedBy::target);
  EXPECT_EQ(all[0].axis, 0);
  EXPECT_EQ(all[0].place, Steps(500));
}

TEST_P(EndingContract, AJogThatIsStoppedByEsc) {
  switch_motor_on();
  EXPECT_EQ(perform(intent::JogStart(AxisId{0}, Sign::plus, Pps(1000), false)).state, IntentState::done);
  run(seconds(1));
  EXPECT_EQ(perform(intent::Stop(-1, StoppedBy::key)).state, IntentState::done);
  ASSERT_TRUE(becomes_idle(seconds(60)));
  run(seconds(1));
  const auto all = endings();
  ASSERT_EQ(all.size(), 1u);
  EXPECT_EQ(all[0].what, Ending::What::jog);
  EXPECT_EQ(all[0].by, EndedBy::stop);
  EXPECT_EQ(all[0].stopped_by, StoppedBy::key);
  EXPECT_TRUE(all[0].timed);
  EXPECT_LT(all[0].to_wire, Millis(100)) << "nothing is under way but a poll";
  EXPECT_GT(all[0].to_rest, all[0].to_wire);
  EXPECT_LT(all[0].ran_on, Steps(1000)) << "it was at 1000 a second";
}

TEST_P(EndingContract, AStopIsTimedFromThePressOfTheHand) {
  switch_motor_on();
  EXPECT_EQ(perform(intent::JogStart(AxisId{0}, Sign::plus, Pps(1000), false)).state, IntentState::done);
  run(seconds(1));
  constexpr Duration until_its_frame = Millis(150);
  session->send(intent::Stop(), session->now() - until_its_frame);
  ASSERT_TRUE(becomes_idle(seconds(60)));
  run(seconds(1));
  const auto all = endings();
  ASSERT_EQ(all.size(), 1u);
  ASSERT_TRUE(all[0].timed);
  EXPECT_GE(all[0].to_wire, until_its_frame);
  EXPECT_LT(all[0].to_wire, until_its_frame + Millis(100));
}

TEST_P(EndingContract, AMotionThatALimitEnds) {
  switch_motor_on();
  ASSERT_EQ(perform(intent::MoveTo({{AxisId{0}, Steps(1'000'000)}})).state, IntentState::done);
  run(Millis(300));
  operate(bench::Limit(AxisId{0}, Sign::plus, true));
  ASSERT_TRUE(becomes_idle(seconds(60)));
  run(seconds(1));
  const auto all = endings();
  ASSERT_EQ(all.size(), 1u);
  EXPECT_EQ(all[0].by, EndedBy::limit);
  EXPECT_TRUE(all[0].limit_plus);
  EXPECT_FALSE(all[0].limit_minus);
}

TEST_P(EndingContract, AJogThatIsLetGoOnItsLimitHasEndedThere) {
  switch_motor_on();
  ASSERT_EQ(perform(intent::JogStart(AxisId{0}, Sign::plus, Pps(1000), false)).state, IntentState::done);
  run(Millis(500));
  operate(bench::Limit(AxisId{0}, Sign::plus, true));
  ASSERT_TRUE(run_until([this] { return axis().limit_plus; }, seconds(5)));
  session->send(intent::JogStop{0});
  ASSERT_TRUE(becomes_idle(seconds(60)));
  run(seconds(1));
  const auto all = endings();
  ASSERT_EQ(all.size(), 1u);
  EXPECT_EQ(all[0].what, Ending::What::jog);
  EXPECT_EQ(all[0].by, EndedBy::limit);
  EXPECT_TRUE(all[0].limit_plus);
}

TEST_P(EndingContract, AMoveThatAnotherHostStops) {
  switch_motor_on();
  ASSERT_EQ(perform(intent::MoveTo({{AxisId{0}, Steps(1'000'000)}})).state, IntentState::done);
  const Ending ending = ends_by_another();
  EXPECT_EQ(ending.by, EndedBy::elsewhere);
  EXPECT_EQ(ending.what, Ending::What::motion);
}

TEST_P(EndingContract, AMoveThatATypedTextStops) {
  const std::map<std::string_view, std::string> stops{
      {"vxm", "D"}, {"pmx-4ex-sa", "STOPX"}, {"dmx-k-sa", "STOP"}, {"vme58", "AX ST"}};
  const auto text = stops.find(GetParam()->model);
  if (text == stops.end()) GTEST_SKIP() << "write its stop, if it has one that may be typed";
  switch_motor_on();
  ASSERT_EQ(perform(intent::MoveTo({{AxisId{0}, Steps(1'000'000)}})).state, IntentState::done);
  run(seconds(1));
  EXPECT_EQ(perform(intent::SendText(text->second)).state, IntentState::done);
  ASSERT_TRUE(becomes_idle(seconds(60)));
  run(seconds(1));
  const auto all = endings();
  ASSERT_EQ(all.size(), 1u);
  EXPECT_EQ(all[0].by, EndedBy::stop);
  EXPECT_EQ(all[0].stopped_by, StoppedBy::text);
}

TEST_P(EndingContract, AJogThatAnotherHostStops) {
  switch_motor_on();
  EXPECT_EQ(perform(intent::JogStart(AxisId{0}, Sign::plus, Pps(1000), false)).state, IntentState::done);
  const Ending ending = ends_by_another();
  EXPECT_EQ(ending.by, EndedBy::elsewhere);
  EXPECT_EQ(ending.what, Ending::What::jog);
}

TEST_P(EndingContract, AHomeSearchThatAnotherHostStopsHasFoundNothing) {
  const auto modes = session->catalog().homing_modes;  // of a session that is replaced
  for (int mode = 0; mode < static_cast<int>(modes.size()); ++mode) {
    SCOPED_TRACE(modes[static_cast<std::size_t>(mode)].label);
    if (mode > 0) close(), open();
    switch_motor_on();
    AxisPlace far;
    far.minus = Steps(-900'000);
    far.home_from = Steps(-890'000), far.home_to = Steps(-880'000);
    operate(bench::Place(AxisId{0}, far));
    const Sign sign = modes[static_cast<std::size_t>(mode)].only_direction.value_or(Sign::minus);
    const IntentOutcome outcome = perform(intent::Home(AxisId{0}, sign, mode));
    ASSERT_EQ(outcome.state, IntentState::done) << outcome.sentence.view();
    const Ending ending = ends_by_another();
    EXPECT_EQ(ending.what, Ending::What::homing);
    EXPECT_EQ(ending.by, EndedBy::elsewhere);
    EXPECT_EQ(axis().trust.kind, Trust::counted) << "nothing has set its count";
    EXPECT_NE(axis().position, Steps(0)) << "nothing has been written there";
  }
}

/// A motion, a wait and another motion, at 2000 steps/s.
struct LongProgram {
  int slot;
  std::string text;
};
const std::map<std::string_view, LongProgram> long_programs{
    {"vxm", {1, "S1M2000\nI1M20000\nP40\nI1M20000\n"}},
    {"pmx-4ex-sa", {0, "HSPD=2000\nABS\nX20000\nWAITX\nDELAY=4000\nX0\nWAITX\nEND\n"}},
    {"dmx-k-sa", {0, "HSPD=2000\nABS\nX20000\nWAITX\nDELAY=4000\nX0\nWAITX\nEND\n"}},
    {"vme58", {0, "AX VL2000 MR20000 GO ID\nAX MR-4000 GO ID\n"}}};

TEST_P(EndingContract, AMotionOfAProgramThatAnotherHostStopsIsReportedWhereItsPlaceShowsIt) {
  const auto program = long_programs.find(GetParam()->model);
  if (program == long_programs.end()) GTEST_SKIP() << "write one in its language, if it has programs";
  switch_motor_on();
  const auto& [slot, text] = program->second;
  ASSERT_EQ(perform(intent::LoadProgram(slot, text)).state, IntentState::done);
  endings();
  ASSERT_EQ(perform(intent::RunProgram(slot)).state, IntentState::done);
  run(seconds(3));
  another_stops_it();
  ASSERT_TRUE(run_until([this] { return !now().program.owned; }, seconds(60)));
  ASSERT_TRUE(becomes_idle(seconds(60)));
  run(seconds(3));
  int motions = 0, programs = 0;
  for (const Ending& ending : endings()) {
    EXPECT_EQ(ending.stopped_by, StoppedBy::unknown);
    if (ending.what == Ending::What::program) {
      ++programs;
      EXPECT_EQ(ending.by, EndedBy::target) << "what comes behind it";
    } else {
      ++motions;
      EXPECT_EQ(ending.by, EndedBy::elsewhere);
      EXPECT_TRUE(ending.of_run);
      EXPECT_GT(ending.place, Steps(2000));
      EXPECT_LT(ending.place, Steps(12000));
    }
  }
  const bool scaled = session->catalog().can.window;  // user units may scale its distances
  const bool corrected = axis().in_counts;            // it rests where its encoder says
  const bool judged = !scaled && !corrected;
  EXPECT_EQ(motions, judged ? 1 : 0);
  EXPECT_EQ(programs, 1);
}

TEST_P(EndingContract, AProgramOfWholeMotionsIsReportedAlone) {
  const auto program = long_programs.find(GetParam()->model);
  if (program == long_programs.end()) GTEST_SKIP() << "write one in its language, if it has programs";
  switch_motor_on();
  const auto& [slot, text] = program->second;
  ASSERT_EQ(perform(intent::LoadProgram(slot, text)).state, IntentState::done);
  endings();
  ASSERT_EQ(perform(intent::RunProgram(slot)).state, IntentState::done);
  run(seconds(3));
  ASSERT_TRUE(run_until([this] { return !now().program.owned; }, seconds(60)));
  ASSERT_TRUE(becomes_idle(seconds(60)));
  run(seconds(3));
  const auto all = endings();
  ASSERT_EQ(all.size(), 1u);
  EXPECT_EQ(all[0].what, Ending::What::program);
  EXPECT_EQ(all[0].by, EndedBy::target);
}

TEST_P(EndingContract, AStopAtOnceBehindAnotherIsReportedAsOne) {
  switch_motor_on();
  EXPECT_EQ(perform(intent::JogStart(AxisId{0}, Sign::plus, Pps(1000), false)).state, IntentState::done);
  run(seconds(1));
  session->send(intent::Stop(-1, StoppedBy::key));
  session->send(intent::Stop(-1, StoppedBy::key));
  ASSERT_TRUE(becomes_idle(seconds(60)));
  run(seconds(1));
  const auto all = endings();
  ASSERT_EQ(all.size(), 1u);
  EXPECT_EQ(all[0].by, EndedBy::abort);
}

TEST_P(EndingContract, AStopReportsWhenItIsSeenToSlowDown) {
  switch_motor_on();
  const Pps speed(session->catalog().can.window ? 200'000 : 2'000);  // so that the ramp is seen
  EXPECT_EQ(perform(intent::JogStart(AxisId{0}, Sign::plus, speed, false)).state, IntentState::done);
  run(seconds(3));
  EXPECT_EQ(perform(intent::Stop()).state, IntentState::done);
  ASSERT_TRUE(becomes_idle(seconds(60)));
  run(seconds(1));
  const auto all = endings();
  ASSERT_EQ(all.size(), 1u);
  ASSERT_TRUE(all[0].to_slowing);
  EXPECT_GT(*all[0].to_slowing, all[0].to_wire);
  EXPECT_LT(*all[0].to_slowing, all[0].to_rest);
}

TEST_P(EndingContract, APowerCutThatEndsAMotionIsNamed) {
  switch_motor_on();
  ASSERT_EQ(perform(intent::MoveTo({{AxisId{0}, Steps(1'000'000)}})).state, IntentState::done);
  run(seconds(2));
  operate(bench::PowerCycle());
  run(seconds(20));
  const auto all = endings();
  ASSERT_EQ(all.size(), 1u);
  EXPECT_EQ(all[0].by, EndedBy::lost);
  EXPECT_NE(all[0].lost_with, Doubt::none);
}

TEST_P(EndingContract, AProgramThatIsOverAtOnceReportsItsEndToo) {
  if (session->catalog().program.threads == 0) GTEST_SKIP() << "it is told by its prompt";
  switch_motor_on();
  ASSERT_EQ(perform(intent::LoadProgram(0, "V1=1\nEND\n")).state, IntentState::done);
  for (int time = 0; time < 3; ++time) {
    ASSERT_EQ(perform(intent::RunProgram(0)).state, IntentState::done);
    run(seconds(1));
    const auto all = endings();
    ASSERT_EQ(all.size(), 1u);
    EXPECT_EQ(all[0].what, Ending::What::program);
    EXPECT_EQ(all[0].slot, 0);
    EXPECT_EQ(all[0].by, EndedBy::target);
  }
}

TEST_P(EndingContract, AProgramEndedByALimitReportsTheLineAndTheAxis) {
  if (session->catalog().program.threads == 0) GTEST_SKIP() << "its programs do not tell a line";
  switch_motor_on();
  ASSERT_EQ(perform(intent::LoadProgram(0, "V1=1\nX1000000\nWAITX\nEND\n")).state, IntentState::done);
  ASSERT_EQ(perform(intent::RunProgram(0)).state, IntentState::done);
  run(seconds(1));
  operate(bench::Limit(AxisId{0}, Sign::plus, true));
  ASSERT_TRUE(becomes_idle(seconds(60)));
  run(seconds(1));
  int programs = 0;
  for (const Ending& ending : endings()) {
    if (ending.what != Ending::What::program) continue;
    ++programs;
    EXPECT_EQ(ending.by, EndedBy::error);
    EXPECT_EQ(ending.line, 2) << "it waited there";
    EXPECT_EQ(ending.failed_axis, 0);
    EXPECT_EQ(ending.error, AxisError::limit_plus);
  }
  EXPECT_EQ(programs, 1);
}

}  // namespace
}  // namespace hw
