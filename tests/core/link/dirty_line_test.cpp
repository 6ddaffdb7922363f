// While a device owes answers that were given up, nothing that it says is believed: see OutstandingReplies.
#include <deque>

#include <gmock/gmock.h>

#include "tests/core/link/link_fixture.h"

namespace hw {
namespace {

using testing::ElementsAre;

constexpr ReplyKind letter{1}, number{2};

/// Asks V, answered by a letter, and X, answered by a number in a line.
struct DirtyLineTest : LinkTest {
  DirtyLineTest() {
    station.unmistakable = [](const OutstandingReplies& outstanding,
                              Instant now) -> std::optional<Station::Unmistakable> {
      if (!outstanding.may_be_outstanding(letter, now))
        return Station::Unmistakable{with_look("V", ReplyShape::bytes(1), letter),
                                     [](std::string_view answer) { return answer == "R"; }};
      if (!outstanding.may_be_outstanding(number, now))
        return Station::Unmistakable{with_look("X", ReplyShape::line(), number),
                                     [](std::string_view answer) { return answer.size() > 1; }};
      return std::nullopt;
    };
  }
  static Transaction with_look(std::string text, ReplyShape shape, ReplyKind reply_kind) {
    Transaction t(std::move(text), shape, Priority::poll);
    t.reply_kind = reply_kind;
    return t;
  }
  void ask_number(Answer& answer, std::string text = "X") {
    auto t = with_look(std::move(text), ReplyShape::line(), number);
    asio::co_spawn(io, ask(station, std::move(t), answer), asio::detached);
    time.run_for(Duration::zero());
  }
  void miss() {
    Answer silent;
    ask_number(silent);
    time.run_for(Millis(210));
    ASSERT_TRUE(silent.came && !silent.result);
  }
};

TEST_F(DirtyLineTest, ALateAnswerIsNotTakenForTheNext) {
  miss();
  EXPECT_TRUE(station.is_dirty());
  Answer next;
  ask_number(next, "Y");
  time.run_for(Millis(60));
  EXPECT_THAT(wire->sent, ElementsAre("X", "V"));
  arrive("R");
  EXPECT_FALSE(station.is_dirty());
  EXPECT_THAT(wire->sent, ElementsAre("X", "V", "Y"));
  arrive("7\r");
  EXPECT_EQ(*next.result, "7\r");
  EXPECT_EQ(station.times_cleaned(), 1u);
}

TEST_F(DirtyLineTest, AReplyThatMayBeALateOneLeavesTheLineDirty) {
  miss();
  time.run_for(Millis(2500));
  Answer greeting;
  auto t = with_look("X", ReplyShape::line(), number);
  t.on_dirty_line = true;
  asio::co_spawn(io, ask(station, std::move(t), greeting), asio::detached);
  time.run_for(Duration::zero());
  arrive("4\r");
  EXPECT_TRUE(greeting.came && greeting.result);
  time.run_for(std::chrono::seconds(2));
  EXPECT_TRUE(station.is_dirty()) << "the one that was given up may have been this";
  time.run_for(std::chrono::seconds(1));
  EXPECT_FALSE(station.is_dirty()) << "nothing comes so late";
}

TEST_F(DirtyLineTest, BytesBeforeSilenceDelayTheQuestion) {
  miss();
  Answer next;
  ask_number(next);
  for (int i = 0; i < 5; ++i) {
    time.run_for(Millis(30));
    arrive("4\r");
  }
  EXPECT_THAT(wire->sent, ElementsAre("X"));
  time.run_for(Millis(51));
  EXPECT_THAT(wire->sent, ElementsAre("X", "V"));
}

TEST_F(DirtyLineTest, ALineThatIsNeverSilentIsNoLine) {
  miss();
  Answer next;
  ask_number(next);
  for (int i = 0; i < 60; ++i) {
    time.run_for(Millis(20));
    arrive("4\r");
  }
  ASSERT_TRUE(next.came);
  EXPECT_EQ(next.result.error().kind, FaultKind::garbled);
  EXPECT_EQ(station.statistics().misses_in_a_row, 2);
}

TEST_F(DirtyLineTest, AStopAsksNothingBefore) {
  miss();
  Answer stop;
  start("D", ReplyShape::nothing(), Priority::stop, stop);
  EXPECT_THAT(wire->sent, ElementsAre("X", "D"));
}

TEST_F(DirtyLineTest, AStopEndsTheCleaning) {
  miss();
  Answer next;
  ask_number(next);
  time.run_for(Millis(20));
  station.preempt();
  time.run_for(Duration::zero());
  ASSERT_TRUE(next.came);
  EXPECT_EQ(next.result.error().kind, FaultKind::stopped);
  EXPECT_THAT(wire->sent, ElementsAre("X"));
}

TEST_F(DirtyLineTest, AStopThatComesWithTheCleaningAnswerEndsWhatWaitedForIt) {
  miss();
  Answer move;
  ask_number(move, "I1M400,R");
  time.run_for(Millis(60));
  ASSERT_THAT(wire->sent, ElementsAre("X", "V"));
  wire->listener->bytes_arrived("R");
  station.preempt();
  time.run_for(Duration::zero());
  ASSERT_TRUE(move.came);
  EXPECT_EQ(move.result.error().kind, FaultKind::stopped);
  EXPECT_THAT(wire->sent, ElementsAre("X", "V"));
}

TEST_F(DirtyLineTest, AWireThatClosesAtTheEndOfTheSilenceIsLost) {
  miss();
  Answer next;
  ask_number(next);
  Timer closing(time, [this] { station.close(Fault(FaultKind::lost, "The connection was closed.")); });
  closing.arm(time.now() + Millis(50));
  time.run_for(Millis(60));
  ASSERT_TRUE(next.came);
  EXPECT_EQ(next.result.error().kind, FaultKind::lost);
  EXPECT_THAT(wire->sent, ElementsAre("X"));
}

TEST_F(DirtyLineTest, EachAttemptAsksSomethingElseAndWaitsLonger) {
  miss();
  Answer first, second;
  ask_number(first);
  time.run_for(Millis(60 + 580));
  EXPECT_FALSE(first.came);
  time.run_for(Millis(30));
  ASSERT_TRUE(first.came && !first.result);
  ask_number(second);
  time.run_for(std::chrono::seconds(2));
  EXPECT_THAT(wire->sent, ElementsAre("X", "V")) << "both answers are owed: only time helps";
  time.run_for(std::chrono::seconds(1));
  EXPECT_THAT(wire->sent, ElementsAre("X", "V", "X")) << "of the first question nothing comes any more";
  time.run_for(std::chrono::seconds(2));
  arrive("7\r");
  arrive("9\r");
  ASSERT_TRUE(second.came && second.result);
  EXPECT_EQ(*second.result, "9\r");
}

TEST_F(DirtyLineTest, AGarbledReplyLeavesTheLineDirty) {
  miss();
  Answer next;
  ask_number(next);
  time.run_for(Millis(60));
  arrive("?");
  ASSERT_TRUE(next.came);
  EXPECT_EQ(next.result.error().kind, FaultKind::garbled);
  EXPECT_TRUE(station.is_dirty());
  time.run_for(std::chrono::seconds(4));
  EXPECT_FALSE(station.is_dirty()) << "nothing comes that late";
}

TEST_F(DirtyLineTest, AnAnswerThatMadeNoSenseMakesItDirty) {
  station.doubt(number);
  Answer next;
  ask_number(next);
  time.run_for(Millis(60));
  EXPECT_THAT(wire->sent, ElementsAre("V"));
}

// Everything is answered two seconds late.
TEST_F(DirtyLineTest, ASteadyDelayMakesItSlowAndIsNotALoss) {
  struct Owed {
    Instant at;
    std::string bytes;
  };
  std::deque<Owed> outstanding;
  std::size_t received = 0;
  int answered = 0, most_misses = 0, asked = 0;
  Answer answer;
  answer.came = true;
  for (int ms = 0; ms < 60'000; ++ms) {
    if (answer.came) {
      if (answer.result && *answer.result == "42\r") ++answered;
      most_misses = std::max(most_misses, station.statistics().misses_in_a_row);
      answer = Answer();
      ask_number(answer, ++asked % 2 ? "X" : "Y");
    }
    for (; received < wire->sent.size(); ++received)
      outstanding.push_back(
          {time.now() + std::chrono::seconds(2), wire->sent[received] == "V" ? "R" : "42\r"});
    for (; !outstanding.empty() && outstanding.front().at <= time.now(); outstanding.pop_front())
      arrive(outstanding.front().bytes);
    time.run_for(Millis(1));
  }
  EXPECT_GE(answered, 24) << "as fast as the line is";
  EXPECT_LT(most_misses, 3);
  EXPECT_GE(station.lateness(), std::chrono::seconds(2));
}

TEST_F(DirtyLineTest, ALineThatIsFastAgainIsForgiven) {
  miss();
  Answer next;
  ask_number(next);
  time.run_for(Millis(60));
  time.run_for(Millis(500));
  arrive("R");
  EXPECT_GE(station.lateness(), Millis(500));
  arrive("7\r");
  for (int i = 0; i < 6; ++i) {
    Answer quick;
    ask_number(quick);
    arrive("7\r");
    ASSERT_TRUE(quick.came);
  }
  EXPECT_EQ(station.lateness(), Duration::zero());
}

}  // namespace
}  // namespace hw
