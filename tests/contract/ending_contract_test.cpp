// Every end of a motion or a program is told once, with what it was and who has ended it.
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
};

INSTANTIATE_TEST_SUITE_P(Every, EndingContract, testing::ValuesIn(types_under_test()), name_of_type);

TEST_P(EndingContract, AMoveThatComesToItsTarget) {
  switch_motor_on();
  ASSERT_EQ(perform(intent::MoveTo({{AxisId{0}, Steps(500)}})).fate, Fate::done);
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
  EXPECT_EQ(perform(intent::JogStart(AxisId{0}, Sign::plus, Pps(1000), false)).fate, Fate::done);
  run(seconds(1));
  EXPECT_EQ(perform(intent::Stop(-1, StoppedBy::key)).fate, Fate::done);
  ASSERT_TRUE(becomes_idle(seconds(60)));
  run(seconds(1));
  const auto all = endings();
  ASSERT_EQ(all.size(), 1u);
  EXPECT_EQ(all[0].what, Ending::What::jog);
  EXPECT_EQ(all[0].by, EndedBy::stop);
  EXPECT_EQ(all[0].who, StoppedBy::key);
  EXPECT_TRUE(all[0].timed);
  EXPECT_LT(all[0].to_wire, Millis(100)) << "nothing is under way but a poll";
  EXPECT_GT(all[0].to_rest, all[0].to_wire);
  EXPECT_LT(all[0].ran_on, Steps(1000)) << "it was at 1000 a second";
}

TEST_P(EndingContract, AStopIsTimedFromThePressOfTheHand) {
  switch_motor_on();
  EXPECT_EQ(perform(intent::JogStart(AxisId{0}, Sign::plus, Pps(1000), false)).fate, Fate::done);
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
  ASSERT_EQ(perform(intent::MoveTo({{AxisId{0}, Steps(1'000'000)}})).fate, Fate::done);
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

TEST_P(EndingContract, AProgramThatIsOverAtOnceTellsItsEndToo) {
  if (session->catalog().program.threads == 0) GTEST_SKIP() << "it is told by its prompt";
  switch_motor_on();
  ASSERT_EQ(perform(intent::LoadProgram(0, "V1=1\nEND\n")).fate, Fate::done);
  for (int time = 0; time < 3; ++time) {
    ASSERT_EQ(perform(intent::RunProgram(0)).fate, Fate::done);
    run(seconds(1));
    const auto all = endings();
    ASSERT_EQ(all.size(), 1u);
    EXPECT_EQ(all[0].what, Ending::What::program);
    EXPECT_EQ(all[0].slot, 0);
    EXPECT_EQ(all[0].by, EndedBy::target);
  }
}

TEST_P(EndingContract, AProgramThatALimitEndsTellsWhereItStoodAndWhichAxisItWas) {
  if (session->catalog().program.threads == 0) GTEST_SKIP() << "its programs do not tell a line";
  switch_motor_on();
  ASSERT_EQ(perform(intent::LoadProgram(0, "V1=1\nX1000000\nWAITX\nEND\n")).fate, Fate::done);
  ASSERT_EQ(perform(intent::RunProgram(0)).fate, Fate::done);
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
