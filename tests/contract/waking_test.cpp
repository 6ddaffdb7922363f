// Whoever shows a controller is woken for what would look different, behind its publication, and for nothing
// else.
#include "tests/contract/rig.h"

namespace hw {
namespace {

using std::chrono::seconds;

class WakingTest : public ContractTest {};
INSTANTIATE_TEST_SUITE_P(Every, WakingTest, testing::ValuesIn(types_under_test()), name_of_type);

TEST_P(WakingTest, AfterTheLastByteItIsDrawnOnceMore) {
  const auto take = [this](int* others) {
    session->traffic().drain([&](const TrafficEntry& entry) {
      if (others && entry.kind != TrafficKind::poll) ++*others;
    });
  };
  take(nullptr);
  on_wake = [&] { take(nullptr); };
  session->send(intent::MoveBy({{AxisId{0}, Steps(400)}}));
  int unseen = 0;
  int ms = 0;
  for (; ms < 4000 && unseen == 0; ++ms) {
    run(Millis(1));
    take(&unseen);
  }
  EXPECT_EQ(unseen, 0) << "at " << ms << " ms something was in the record, and nobody had been woken for it";
  on_wake = nullptr;
}

TEST_P(WakingTest, TheRateOfPollsThatIsShownIsTheOneThatIs) {
  float shown = 0;
  int wakes = 0;
  on_wake = [&] {
    shown = session->snapshot().link.polls_per_second;
    ++wakes;
  };
  EXPECT_EQ(perform(intent::MoveBy({{AxisId{0}, Steps(2000)}})).state, IntentState::done);
  EXPECT_TRUE(becomes_idle(seconds(20)));
  run(seconds(10));
  EXPECT_NEAR(shown, now().link.polls_per_second, 0.16f * now().link.polls_per_second);
  wakes = 0;
  run(seconds(60));
  EXPECT_LE(wakes, 2) << "at rest";
  on_wake = nullptr;
}

}  // namespace
}  // namespace hw
