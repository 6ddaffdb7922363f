// What a stop cuts short at any instant is either not put, or told as perhaps carried out; and nothing that
// it leaves behind is taken for something else.
#include "tests/core/devices/vme58/driver_rig.h"

namespace hw {
namespace {

using test::Seconds;
using testing::HasSubstr;
using Micros = std::chrono::microseconds;

class Vme58Cut : public test::Vme58Rig {
 protected:
  std::unique_ptr<Window> dressed(std::unique_ptr<Window> window) override {
    return std::make_unique<test::SlowBus>(time, std::move(window));
  }
  static constexpr int longest_us = 6000;  ///< of what is cut short, on this bus

  /// Of axis Y, while something is under way for others.
  void stop_beside(Duration after) {
    run(after);
    EXPECT_EQ(perform(intent::Stop(1)).state, IntentState::done);
  }
  [[nodiscard]] IntentOutcome outcome_of(IntentId id) const { return *now().outcome_of(id); }
};

TEST_F(Vme58Cut, AJogNeverOutlivesItsHand) {
  ASSERT_TRUE(query("AX VL2000 AC1000000"));
  int failed = 0, held = 0;
  for (int after_us = 0; after_us < longest_us; after_us += 90) {
    const IntentId jog = session->send(intent::JogStart(AxisId{0}, Sign::plus));
    stop_beside(Micros(after_us));
    run(Millis(50));
    if (outcome_of(jog).state == IntentState::done) {
      ++held;
      EXPECT_EQ(axis().activity, Activity::jogging) << after_us;
      EXPECT_EQ(perform(intent::JogStop()).state, IntentState::done);
    } else {
      ++failed;
    }
    run(Millis(100));
    const Steps there = axis().position;
    run(Seconds(1));
    EXPECT_EQ(axis().position, there) << after_us;
  }
  EXPECT_GT(failed, 0);
  EXPECT_GT(held, 0);
}

TEST_F(Vme58Cut, AMoveIsReportedAsNotSentOnlyIfItIsNot) {
  ASSERT_TRUE(query("AX VL20000 AC1000000"));
  int unsent = 0, unknown = 0, done = 0;
  for (int after_us = 0; after_us < longest_us; after_us += 90) {
    const Steps before = axis().position;
    const IntentId move = session->send(intent::MoveBy({{AxisId{0}, Steps(100)}}));
    stop_beside(Micros(after_us));
    ASSERT_TRUE(becomes_idle());
    run(Millis(500));
    const IntentOutcome outcome = outcome_of(move);
    const std::string sentence(outcome.sentence.view());
    const bool moved = axis().position == before + Steps(100);
    EXPECT_TRUE(moved || axis().position == before) << after_us;
    if (outcome.state == IntentState::done) {
      ++done;
      EXPECT_TRUE(moved) << after_us;
    } else if (sentence.find("not sent") != sentence.npos) {
      ++unsent;
      EXPECT_FALSE(moved) << after_us << ' ' << sentence;
    } else {
      ++unknown;
      EXPECT_THAT(sentence, HasSubstr("Whether the board has carried it out is unknown"));
    }
  }
  EXPECT_GT(unsent, 0);
  EXPECT_GT(unknown, 0);
  EXPECT_GT(done, 0);
}

TEST_F(Vme58Cut, AnAnswerIsNotTakenForThatOfTheNextQuestion) {
  ASSERT_EQ(perform(intent::SetPosition(0, Steps(1234))).state, IntentState::done);
  (void)lines();
  for (int after_us = 0; after_us < longest_us; after_us += 90) {
    Result<std::string> cut{std::string()};
    bool came = false;
    asio::co_spawn(io, ask_and_keep(session, "AX RP", cut, came), asio::detached);
    stop_beside(Micros(after_us));
    EXPECT_EQ(query("WY").value_or("no answer"), "VME58 ver 2.24-8S") << after_us;
    ASSERT_TRUE(came);
    EXPECT_TRUE(!cut || *cut == "1234") << after_us;
  }
  std::string left;
  EXPECT_FALSE(session->pump().take_unsolicited(left)) << left;
}

// Rounds of status ask the board too.
TEST_F(Vme58Cut, AnAnswerToARoundIsNotTakenForAnothers) {
  ASSERT_TRUE(query("AX VL2000 AC1000000"));
  for (int after_us = 0; after_us < 40000; after_us += 430) {
    ASSERT_TRUE(query("MR1 GO WT300")) << "its queue is asked for";
    stop_beside(Millis(40) + Micros(after_us));
    EXPECT_EQ(query("WY").value_or("no answer"), "VME58 ver 2.24-8S") << after_us;
    run(Millis(500));
  }
  std::string left;
  EXPECT_FALSE(session->pump().take_unsolicited(left)) << left;
}

TEST_F(Vme58Cut, AResetIsNoticedOnce) {
  int times = 0;
  for (int after_us = 0; after_us < 300000; after_us += 7100) {
    const auto before = now().restarts;
    session->send(intent::Reset());
    run(Micros(after_us));
    session->send(intent::Stop(1));
    run(Seconds(2));
    if (now().restarts == before) continue;  // the stop came first
    ++times;
    ASSERT_EQ(now().restarts, before + 1) << after_us;
    ASSERT_EQ(now().link.state, LinkState::good);
    ASSERT_TRUE(query("AX VL2000 AC1000000 MR10 GO")) << after_us;
    ASSERT_TRUE(becomes_idle());
    EXPECT_EQ(axis().position, Steps(10)) << after_us;
  }
  EXPECT_GT(times, 30);
}

TEST_F(Vme58Cut, APowerCutIsNoticedOnce) {
  for (int after_us = 0; after_us < 300000; after_us += 7100) {
    const auto before = now().restarts;
    operate(bench::PowerCycle());
    run(Micros(after_us));
    session->send(intent::Stop());
    run(Seconds(2));
    ASSERT_EQ(now().restarts, before + 1) << after_us;
    ASSERT_EQ(now().link.state, LinkState::good);
  }
}

}  // namespace
}  // namespace hw
