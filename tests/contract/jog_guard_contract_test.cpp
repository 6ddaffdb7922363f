// The guard of held jogs that a controller runs itself, where its catalog offers one: silence in the middle
// of a held jog stops it, silence at any other time stops nothing, and it goes without a trace.
#include "core/session/session_group.h"
#include "tests/contract/rig.h"

namespace hw {
namespace {

using std::chrono::seconds;
using testing::HasSubstr;

std::vector<const DeviceType*> with_a_guard() {
  std::vector<const DeviceType*> all = types_under_test();
  std::erase_if(all, [](const DeviceType* type) { return !type->make_catalog({})->jog_guard.offered(); });
  return all;
}

class JogGuardContract : public ContractTest {
 protected:
  void SetUp() override {
    ContractTest::SetUp();
    perform(intent::SetPower(0, true));
    run(seconds(1));
  }
  void TearDown() override {
    operate(bench::Unplug(false));
    run(seconds(5));
    ContractTest::TearDown();
  }
  void install() {
    const IntentOutcome outcome = perform(intent::GuardJogs(true), seconds(60));
    ASSERT_EQ(outcome.state, IntentState::done) << outcome.sentence.view();
    ASSERT_EQ(now().jog_guard.state, JogGuard::State::installed);
    EXPECT_GE(now().jog_guard.silence, Millis(500));
  }
  void jog(Duration time_held, bool by_hand = true) {
    const IntentOutcome outcome = perform(intent::JogStart(AxisId{0}, Sign::plus, {}, by_hand));
    ASSERT_EQ(outcome.state, IntentState::done) << outcome.sentence.view();
    for (Duration held{}; held < time_held; held += Millis(50)) {
      session->send(intent::JogKeepAlive());
      run(Millis(50));
    }
    ASSERT_TRUE(moves());
  }
  bool moves() {
    const Steps before = load();
    run(Millis(100));
    return load() != before;
  }
  void cut_the_line() { operate(bench::Unplug(true)); }
  void mend_the_line() {
    operate(bench::Unplug(false));
    ASSERT_TRUE(run_until([this] { return now().link.state == LinkState::good; }, seconds(60)));
    run(seconds(10));
  }
  std::int64_t time_out() {
    EXPECT_EQ(perform(intent::ReadParams("TOC")).state, IntentState::done);
    return now().params[static_cast<std::size_t>(session->catalog().find_param("TOC"))].value;
  }
  std::int32_t variable(int number) {
    run_until([&] { return now().variables_known.test(static_cast<std::size_t>(number)); }, seconds(60));
    return now().variables[static_cast<std::size_t>(number)];
  }
  static constexpr Duration ramp = Millis(400);
};

INSTANTIATE_TEST_SUITE_P(Every, JogGuardContract, testing::ValuesIn(with_a_guard()), name_of_type);

TEST_P(JogGuardContract, WithoutItAHeldJogRunsOnWhenTheLineIsCut) {
  EXPECT_EQ(now().jog_guard.state, JogGuard::State::absent);
  ASSERT_NO_FATAL_FAILURE(jog(Millis(500)));
  cut_the_line();
  run(seconds(3));
  EXPECT_TRUE(moves());
}

TEST_P(JogGuardContract, StopsAHeldJogWhenTheLineIsCut) {
  ASSERT_NO_FATAL_FAILURE(install());
  ASSERT_NO_FATAL_FAILURE(jog(Millis(500)));
  EXPECT_EQ(now().program.run, RunState::idle) << "it is no program of the user's";
  const Duration silence = now().jog_guard.silence;
  cut_the_line();
  run(silence - Millis(300));
  EXPECT_TRUE(moves()) << "it waits for as long as it says";
  run(Millis(200) + ramp);
  EXPECT_FALSE(moves());
  ASSERT_NO_FATAL_FAILURE(mend_the_line());
  EXPECT_EQ(now().jog_guard.state, JogGuard::State::installed);
  EXPECT_EQ(time_out(), 0) << "as it was";
}

TEST_P(JogGuardContract, SilenceStopsNoMove) {
  ASSERT_NO_FATAL_FAILURE(install());
  ASSERT_NO_FATAL_FAILURE(jog(Millis(500)));
  session->send(intent::JogStop());
  ASSERT_TRUE(becomes_idle(seconds(10)));
  run(seconds(1));
  EXPECT_EQ(time_out(), 0);
  ASSERT_EQ(perform(intent::MoveBy({{AxisId{0}, Steps(5000)}})).state, IntentState::done);
  run(Millis(500));
  cut_the_line();
  run(seconds(2));
  EXPECT_TRUE(moves());
}

TEST_P(JogGuardContract, NorAMoveRightBehindAJog) {
  ASSERT_NO_FATAL_FAILURE(install());
  ASSERT_NO_FATAL_FAILURE(jog(Millis(500)));
  session->send(intent::JogStop());
  const IntentOutcome outcome = perform(intent::MoveBy({{AxisId{0}, Steps(5000)}}), seconds(10));
  ASSERT_EQ(outcome.state, IntentState::done) << outcome.sentence.view();
  cut_the_line();
  run(seconds(2));
  EXPECT_TRUE(moves());
}

TEST_P(JogGuardContract, NorAJogOfAScript) {
  ASSERT_NO_FATAL_FAILURE(install());
  ASSERT_NO_FATAL_FAILURE(jog(Millis(300), false));
  cut_the_line();
  run(seconds(2));
  EXPECT_TRUE(moves());
}

TEST_P(JogGuardContract, AMoveBehindAJogThatItHasStoppedIsLeftAlone) {
  ASSERT_NO_FATAL_FAILURE(install());
  ASSERT_NO_FATAL_FAILURE(jog(Millis(500)));
  cut_the_line();
  run(seconds(2));
  ASSERT_FALSE(moves());
  ASSERT_NO_FATAL_FAILURE(mend_the_line());
  EXPECT_EQ(perform(intent::MoveBy({{AxisId{0}, Steps(5000)}})).state, IntentState::done);
  cut_the_line();
  run(seconds(2));
  EXPECT_TRUE(moves());
}

TEST_P(JogGuardContract, AStopOfAllEndsItAndTheNextJogIsGuardedAgain) {
  ASSERT_NO_FATAL_FAILURE(install());
  ASSERT_NO_FATAL_FAILURE(jog(Millis(500)));
  session->send(intent::Stop());
  ASSERT_TRUE(becomes_idle(seconds(10)));
  run(seconds(1));
  EXPECT_EQ(time_out(), 0);
  EXPECT_EQ(variable(49), 0);
  ASSERT_NO_FATAL_FAILURE(jog(Millis(300)));
  cut_the_line();
  run(now().jog_guard.silence + ramp);
  EXPECT_FALSE(moves());
}

TEST_P(JogGuardContract, GoesWithoutATrace) {
  ASSERT_NO_FATAL_FAILURE(install());
  EXPECT_EQ(perform(intent::GuardJogs(true), seconds(60)).state, IntentState::refused)
      << "it is there already";
  EXPECT_EQ(perform(intent::GuardJogs(false), seconds(60)).state, IntentState::done);
  EXPECT_EQ(now().jog_guard.state, JogGuard::State::absent);
  EXPECT_EQ(time_out(), 0);
  EXPECT_EQ(variable(48), 0);
  EXPECT_EQ(variable(49), 0);
  ASSERT_NO_FATAL_FAILURE(install());  // which takes an empty program memory
}

TEST_P(JogGuardContract, IsWrittenOnlyIntoAnEmptyProgramMemory) {
  ASSERT_EQ(perform(intent::LoadProgram(0, "V1=1\nEND\n"), seconds(60)).state, IntentState::done);
  const IntentOutcome refused = perform(intent::GuardJogs(true), seconds(60));
  EXPECT_EQ(refused.state, IntentState::refused);
  EXPECT_THAT(std::string(refused.sentence.view()), HasSubstr("holds a program"));
  EXPECT_EQ(now().jog_guard.state, JogGuard::State::no_room);
  EXPECT_EQ(perform(intent::RunProgram(0)).state, IntentState::done) << "what was there is there";
  EXPECT_EQ(perform(intent::GuardJogs(false), seconds(60)).state, IntentState::refused);
}

TEST_P(JogGuardContract, TheNextSessionFindsIt) {
  ASSERT_NO_FATAL_FAILURE(install());
  open_afresh();
  ASSERT_TRUE(run_until([this] { return now().jog_guard.state == JogGuard::State::installed; }, seconds(30)));
  ASSERT_NO_FATAL_FAILURE(jog(Millis(500)));
  cut_the_line();
  run(now().jog_guard.silence + ramp);
  EXPECT_FALSE(moves());
}

TEST_P(JogGuardContract, AProgramOfTheUsersTakesItsPlace) {
  ASSERT_NO_FATAL_FAILURE(install());
  ASSERT_EQ(perform(intent::LoadProgram(0, "V1=1\nEND\n"), seconds(60)).state, IntentState::done);
  run(seconds(2));
  EXPECT_EQ(now().jog_guard.state, JogGuard::State::no_room);
  ASSERT_NO_FATAL_FAILURE(jog(Millis(300)));  // and starts nothing
  EXPECT_EQ(now().program.run, RunState::idle);
}

TEST_P(JogGuardContract, ItsThreadIsTheGuardsOnlyWhileAJogIsHeld) {
  ASSERT_NO_FATAL_FAILURE(install());
  ASSERT_NO_FATAL_FAILURE(jog(Millis(500)));
  EXPECT_EQ(now().program.run, RunState::idle);
  session->send(intent::JogStop());
  ASSERT_TRUE(becomes_idle(seconds(10)));
  run(seconds(5));
  EXPECT_EQ(now().program.run, RunState::idle) << "it has ended, and is asked whether it has";
}

TEST_P(JogGuardContract, AJogDoesNotOverwriteATimeOutThatWasSetSince) {
  ASSERT_NO_FATAL_FAILURE(install());
  ASSERT_EQ(perform(intent::SendText("TOC=5000")).state, IntentState::done);
  const IntentOutcome outcome = perform(intent::JogStart(AxisId{0}, Sign::plus, {}, true));
  EXPECT_EQ(outcome.state, IntentState::refused);
  EXPECT_THAT(std::string(outcome.sentence.view()), HasSubstr("TOC is 5000"));
  EXPECT_FALSE(moves());
  EXPECT_EQ(time_out(), 5000);
}

// Of the devices of one line, those that hear a text to all.
TEST(JogGuardOnALine, AfterATextToAllThatMayHaveWrittenOverItItIsLookedFor) {
  IoContext io;
  VirtualScheduler time{io};
  const auto opened =
      SessionGroup::open(time, *Address::parse("dmx-k-sa@emulator,id=01-02"), make_wire_opener(), [] {});
  ASSERT_TRUE(opened) << opened.error().sentence();
  const auto& bus = *opened;
  time.run_for(seconds(5));
  Session& first = *bus->members()[0];
  first.send(intent::GuardJogs(true));
  const auto is = [&](JogGuard::State state) { return first.known().jog_guard.state == state; };
  EXPECT_TRUE(time.run_until(time.now() + seconds(60), [&] { return is(JogGuard::State::installed); }));
  time.run_for(seconds(1));
  bus->members()[1]->send(intent::SendText("@00SA3=END"));
  EXPECT_TRUE(time.run_until(time.now() + seconds(20), [&] { return is(JogGuard::State::no_room); }));
  asio::co_spawn(io, bus->close(), asio::detached);
  time.run_for(seconds(2));
}

}  // namespace
}  // namespace hw
