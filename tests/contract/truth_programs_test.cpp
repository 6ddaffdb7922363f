// Stored programs: what was loaded is in the controller, what was run has run.
#include "tests/contract/truth.h"

namespace hw {
namespace {

using std::chrono::seconds;

class ProgramTruthTest : public TruthTest {
 protected:
  void SetUp() override {
    TruthTest::SetUp();
    if (facts().slots == 0) GTEST_SKIP() << "it has no programs";
  }
  [[nodiscard]] const ProgramFacts& facts() const { return session->catalog().program; }
  /// Whether the controller keeps what is loaded, rather than the console.
  [[nodiscard]] bool keeps() const { return facts().capacity > 0; }
  std::string listing() {
    session->notices().drain([](const Notice&) {});
    must(intent::UploadProgram(0));
    std::string text;
    session->notices().drain([&](const Notice& n) {
      if (n.kind == Notice::Kind::program) text = n.text;
    });
    return text;
  }
};
INSTANTIATE_TEST_SUITE_P(Every, ProgramTruthTest, testing::ValuesIn(types_under_test()), name_of_type);

TEST_P(ProgramTruthTest, ALoadedProgramIsInTheController) {
  const std::string empty = listing();
  must(intent::LoadProgram(0, facts().example));
  const std::string loaded = listing();
  EXPECT_NE(loaded, empty);
  if (keeps()) {
    open_afresh();
    EXPECT_EQ(listing(), loaded) << "as another session reads it";
  }
  must(intent::ClearProgram(0));
  EXPECT_EQ(listing(), empty);
}

TEST_P(ProgramTruthTest, TheProgramShownIsTheOneInTheController) {
  if (!keeps()) GTEST_SKIP() << "the console keeps it";
  must(intent::LoadProgram(0, facts().example));
  operate(bench::PowerCycle());  // some have lost it then
  run(seconds(10));
  ASSERT_EQ(now().link.state, LinkState::good);
  const std::string shown = listing();
  open_afresh();
  EXPECT_EQ(listing(), shown);
}

TEST_P(ProgramTruthTest, ARunningProgramMovesItsAxes) {
  must(intent::LoadProgram(0, facts().example));
  const BenchView begin = seen_on_bench();
  must(intent::RunProgram(0));
  EXPECT_TRUE(run_until([&] { return seen_on_bench().load_position != begin.load_position; }, seconds(5)));
  EXPECT_EQ(now().program.run, RunState::running);
  EXPECT_TRUE(becomes_idle(seconds(120)));
  EXPECT_EQ(why_not_finished(now(), session->catalog()), "");
}

}  // namespace
}  // namespace hw
