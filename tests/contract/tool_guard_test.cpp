// A program that switches a tool on, in the language of each listed controller, and all the ways in which it
// can come to its end: the tool is off then, on the machine.
#include "core/device/language.h"
#include "core/sequence/sequence.h"
#include "tests/contract/truth.h"

namespace hw {
namespace {

namespace seq = sequence;  // its names are those of commands too
using std::chrono::seconds;
using testing::HasSubstr;

class ToolGuardTest : public TruthTest {
 protected:
  void SetUp() override {
    TruthTest::SetUp();
    output_ = free_output(session->catalog());
    if (output_ < 0) GTEST_SKIP() << "it has no output for a tool";
    s_.axes = {{session->catalog().axes[0].name, 1}};
    s_.pen_up = {{seq::Output{output_, false}}};
    s_.pen_down = {{seq::Output{output_, true}}};
    s_.steps = {{seq::Speed{{2000, 0, 200}}}};
  }
  void add(seq::Step::Body body) { s_.steps.push_back({std::move(body)}); }
  void add_cut(double to) {
    add(seq::Pen{true});
    add_way(to);
  }
  void add_way(double to) {
    seq::Move m;
    m.to[0] = to;
    add(m);
    add(seq::WaitMotion{});
  }
  [[nodiscard]] std::string text() const {
    auto written = GetParam()->language().write(s_, session->catalog());
    EXPECT_TRUE(written) << written.error().sentence();
    return written ? written->text : std::string();
  }
  void start() {
    must(intent::LoadProgram(0, text()));
    must(intent::RunProgram(0));
    ASSERT_TRUE(run_until([this] { return is_on() && now().any_axis_moving(); }, seconds(5))) << text();
    run(seconds(2));
    ASSERT_TRUE(is_on());
  }
  [[nodiscard]] bool is_on() const {
    return (seen_on_bench().outputs >> session->catalog().find_output(output_) & 1u) != 0;
  }
  void expect_off_at_rest() {
    ASSERT_TRUE(becomes_idle(seconds(60)));
    EXPECT_TRUE(run_until([this] { return !is_on(); }, Millis(500)));
    run(seconds(3));
    EXPECT_FALSE(is_on());
    EXPECT_FALSE(session->pump().busy());
  }
  [[nodiscard]] std::string reported() {
    std::string all;
    session->notices().drain([&](const Notice& n) { all += n.text + "\n"; });
    return all;
  }

  seq::Sequence s_;
  int output_ = -1;
};
INSTANTIATE_TEST_SUITE_P(Every, ToolGuardTest, testing::ValuesIn(types_with_a_language()), name_of_type);

TEST_P(ToolGuardTest, AStopSwitchesItOff) {
  add_cut(60'000);
  add_way(0);
  start();
  session->send(intent::Stop());
  expect_off_at_rest();
}

TEST_P(ToolGuardTest, AStopWithoutARampSwitchesItOff) {
  add_cut(60'000);
  add_way(0);
  start();
  session->send(intent::Abort());
  expect_off_at_rest();
}

TEST_P(ToolGuardTest, HaltingItsProgramSwitchesItOff) {
  add_cut(20'000);
  add_way(0);
  start();
  must(intent::HaltProgram());
  expect_off_at_rest();
}

TEST_P(ToolGuardTest, AnEndThatLeavesItOnDoesNot) {
  add_cut(6'000);
  start();
  expect_off_at_rest();
  EXPECT_THAT(reported(), HasSubstr("with the tool on"));
}

TEST_P(ToolGuardTest, AnEndThatSwitchesItOffIsLeftAlone) {
  add_cut(6'000);
  add(seq::Pen{false});
  add_way(0);
  start();
  expect_off_at_rest();
  EXPECT_EQ(axis().position, Steps(0));
  EXPECT_EQ(reported().find("tool"), std::string::npos);
}

TEST_P(ToolGuardTest, AHoldSwitchesItOffUntilItGoesOn) {
  add_cut(6'000);
  add_way(12'000);
  add(seq::Pen{false});
  start();
  const IntentOutcome held = perform(intent::Pause());
  if (!session->catalog().can.outputs_while_held) {
    EXPECT_THAT(std::string(held.sentence.view()), HasSubstr("the tool"));
    session->send(intent::Stop());
    return expect_off_at_rest();
  }
  if (held.state == IntentState::refused) GTEST_SKIP() << held.sentence.view();
  ASSERT_TRUE(run_until([this] { return now().program.run == RunState::held && !now().any_axis_moving(); },
                        seconds(20)));
  EXPECT_TRUE(run_until([this] { return !is_on(); }, seconds(1)));
  run(seconds(5));
  EXPECT_FALSE(is_on());
  must(intent::Resume());
  run(seconds(1));
  EXPECT_TRUE(is_on()) << "what was cut goes on";
  expect_off_at_rest();
  EXPECT_EQ(axis().position, Steps(12'000));
}

TEST_P(ToolGuardTest, ALimitThatIsMetWithItOnStopsAll) {
  add_cut(20'000);
  add_way(0);
  place(0, Steps(-50'000), Steps(9'000));
  if (session->catalog().model == "vxm") must(intent::SetParam("O", 1, true));  // it tells of limits then
  start();
  expect_off_at_rest();
  const Steps there = load();
  EXPECT_GT(there, Steps(8'000)) << "it does not go back";
  run(seconds(20));
  EXPECT_EQ(load(), there);
}

TEST_P(ToolGuardTest, ALimitThatIsMetWithItOffIsThePrograms) {
  place(0, Steps(-50'000), Steps(4'000));
  add_cut(2'000);
  add(seq::Pen{false});
  add_way(8'000);
  must(intent::LoadProgram(0, text()));
  must(intent::RunProgram(0));
  EXPECT_TRUE(run_until([this] { return is_on(); }, seconds(5)));
  expect_off_at_rest();
  EXPECT_EQ(reported().find("with the tool on"), std::string::npos);
}

TEST_P(ToolGuardTest, ALimitThatWasMetBeforeIsNoneOfTheRun) {
  if (axes() < 2) GTEST_SKIP() << "its only axis is the one of the program";
  place(1, Steps(-500), Steps(50'000));
  (void)perform(intent::MoveBy({{id(1), Steps(-2000)}}));
  ASSERT_TRUE(becomes_idle(seconds(60)));
  ASSERT_EQ(load_of(1), Steps(-500));
  add_cut(8'000);
  add(seq::Pen{false});
  session->send(intent::LoadProgram(0, text()));  // no round of status between the two
  must(intent::RunProgram(0));
  expect_off_at_rest();
  EXPECT_EQ(load(), Steps(8'000)) << reported();
}

TEST_P(ToolGuardTest, ALostLinkSwitchesItOffWhenItIsBack) {
  add_cut(60'000);
  add_way(0);
  start();
  operate(bench::Unplug(true));
  ASSERT_TRUE(run_until([this] { return !now().link.connected(); }, seconds(20)));
  EXPECT_TRUE(is_on()) << "nobody can do anything about it";
  EXPECT_THAT(reported(), HasSubstr("Use the power switch of the tool"));
  operate(bench::Unplug(false));
  ASSERT_TRUE(run_until([this] { return now().link.connected(); }, seconds(60)));
  expect_off_at_rest();
}

TEST_P(ToolGuardTest, ATextThatGivesItInNoKnownFormIsNotTaken) {
  add_cut(6'000);
  std::string bad = text();
  const std::size_t at = bad.find("output ");
  ASSERT_NE(at, std::string::npos) << bad;
  bad.replace(at, 7, "the lamp ");
  const IntentOutcome outcome = perform(intent::LoadProgram(0, bad));
  EXPECT_EQ(outcome.state, IntentState::refused);
  EXPECT_THAT(std::string(outcome.sentence.view()), HasSubstr("does not say how the tool is switched off"));
}

}  // namespace
}  // namespace hw
