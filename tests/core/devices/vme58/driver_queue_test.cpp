// Command queues of the board as the console shows them, and text that waits in the ring behind a full one.
#include "core/devices/vme58/emulator_vme58.h"
#include "tests/core/devices/vme58/driver_rig.h"

namespace hw {
namespace {

using test::Seconds;
using testing::HasSubstr;

class Vme58DriverQueues : public test::Vme58Rig {
 protected:
  void watch_queues() { session->send(intent::Watch(1u << 1)); }
  int truly_free(int i) {
    auto& emulator = dynamic_cast<vme58::Vme58Emulator&>(const_cast<Emulator&>(host->bench()->emulator()));
    return emulator.board().task(i).queue.room();
  }
  bool known(int i) { return (now().queue_known >> i & 1) != 0; }
  int shown(int i) { return now().queue_free[static_cast<std::size_t>(i)]; }
  bool ring_is_blocked() {
    return peek(2, vme58::at::output_get_index) != peek(2, vme58::at::output_put_index);
  }
};

TEST_F(Vme58DriverQueues, AreFollowedWhileAnAxisWorksOffALongOne) {
  watch_queues();
  std::string text = "AX VL1000 AC1000000 ";
  for (int i = 0; i < 60; ++i) text += "MR100 GO ";  // 3 entries and a tenth of a second each
  ASSERT_TRUE(query(text));
  run(Millis(500));
  const int at_first = shown(0);
  EXPECT_LT(at_first, 40);
  int last = 0;
  for (int i = 0; i < 50; ++i) {
    run(Millis(100));
    ASSERT_TRUE(known(0));
    EXPECT_GE(shown(0), last) << "it only gets emptier";
    EXPECT_NEAR(shown(0), truly_free(0), 2 * 3) << "as it was a moment ago";
    EXPECT_EQ(shown(1), vme58::queue_entries);
    last = shown(0);
  }
  EXPECT_GT(last, at_first + 100);
  ASSERT_TRUE(becomes_idle());
  run(Seconds(2));
  EXPECT_EQ(shown(0), vme58::queue_entries);
  EXPECT_EQ(axis(0).position, Steps(6000));
}

TEST_F(Vme58DriverQueues, OfAProgramThatIsLongerThanItsQueueIsShownAsFull) {
  std::string text = "AY VL1000 AC1000000\n";
  for (int i = 0; i < 120; ++i) text += "MR100 GO\n";
  ASSERT_EQ(perform(intent::LoadProgram(0, text)).state, IntentState::done);
  ASSERT_EQ(perform(intent::RunProgram(0)).state, IntentState::done);
  run(Seconds(2));
  ASSERT_TRUE(ring_is_blocked());
  EXPECT_TRUE(known(1));
  EXPECT_EQ(shown(1), 0);
  EXPECT_LT(truly_free(1), 2);
  EXPECT_FALSE(known(0)) << "nothing can be asked of the others meanwhile";
  ASSERT_TRUE(becomes_idle(Seconds(60)));
  run(Seconds(2));
  for (int i = 0; i < 8; ++i) {
    EXPECT_TRUE(known(i));
    EXPECT_EQ(shown(i), vme58::queue_entries);
  }
  EXPECT_EQ(axis(1).position, Steps(12000));
}

TEST_F(Vme58DriverQueues, AndLoopsAreReadoutsToo) {
  const auto reported = [&](const char* id) -> std::optional<std::int64_t> {
    const auto i = static_cast<std::size_t>(session->catalog().find_readout(id));
    return now().readouts_known[i] ? std::optional(now().readouts[i]) : std::nullopt;
  };
  watch_queues();
  ASSERT_TRUE(query("AY HN"));
  ASSERT_TRUE(query("AX VL1000 AC1000000 WT2000 MR100 GO"));
  run(Millis(1000));
  EXPECT_EQ(reported("RQX"), truly_free(0));
  EXPECT_LT(*reported("RQX"), vme58::queue_entries);
  EXPECT_EQ(reported("RQZ"), vme58::queue_entries);
  EXPECT_EQ(reported("HNY"), 1);
  ASSERT_TRUE(query("AY HF"));
  run(Seconds(3));
  EXPECT_EQ(reported("HNY"), 0);
  EXPECT_EQ(reported("RQX"), vme58::queue_entries);
}

TEST_F(Vme58DriverQueues, StatusRoundsLeaveCommandsWaitingInTheRing) {
  watch_queues();
  std::string text = "AX VL1000 AC1000000 MR3000 GO ";
  for (int i = 0; i < 99; ++i) text += "WT1 ";
  ASSERT_TRUE(query(text));
  const auto waits = query("MR77");
  ASSERT_FALSE(waits);
  EXPECT_THAT(waits.error().sentence(), HasSubstr("wait in the ring and will be carried out"));
  run(Seconds(1));
  ASSERT_TRUE(ring_is_blocked());
  EXPECT_EQ(shown(0), 0);
  run(Seconds(5));
  EXPECT_FALSE(ring_is_blocked());
  ASSERT_TRUE(query("GO"));
  ASSERT_TRUE(becomes_idle());
  EXPECT_EQ(axis(0).position, Steps(3077)) << "it was carried out";
}

TEST_F(Vme58DriverQueues, ACommandOfTheConsoleThatDoesNotFitIsTakenBackAlone) {
  std::string text = "AX VL1000 AC1000000 MR3000 GO ";
  for (int i = 0; i < 99; ++i) text += "WT1 ";
  ASSERT_TRUE(query(text));
  ASSERT_FALSE(query("MR77"));
  const IntentOutcome outcome = perform(intent::MoveBy({AxisTarget{AxisId{1}, Steps(500)}}));
  EXPECT_NE(outcome.state, IntentState::done);
  EXPECT_THAT(std::string(outcome.sentence.view()), HasSubstr("removed from the ring"));
  run(Seconds(6));
  EXPECT_EQ(axis(1).position, Steps(0)) << "nothing moves later by itself";
  ASSERT_TRUE(query("AX GO"));
  ASSERT_TRUE(becomes_idle());
  EXPECT_EQ(axis(0).position, Steps(3077)) << "what stood before it is still there";
}

TEST_F(Vme58DriverQueues, WhileTheTextWaitsInWqNoQueueIsCalledFull) {
  watch_queues();
  EXPECT_FALSE(query("AX VL1000 AC1000000 MR3000 GO WQ")) << "what stands behind it is not read yet";
  ASSERT_FALSE(query("MR5"));
  run(Seconds(1));
  ASSERT_TRUE(ring_is_blocked());
  EXPECT_EQ(now().queue_known, 0u);
  run(Seconds(4));
  EXPECT_EQ(shown(0), vme58::queue_entries);
  ASSERT_TRUE(query("GO"));
  ASSERT_TRUE(becomes_idle());
  EXPECT_EQ(axis(0).position, Steps(3005)) << "MR5 has been taken in the end";
}

}  // namespace
}  // namespace hw
