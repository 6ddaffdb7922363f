#include <algorithm>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/core/link/link_fixture.h"

namespace hw {
namespace {

using testing::ElementsAre;

// ---- a device that babbles as fast as the wire bears costs bounded memory, and ends every question

TEST_F(LinkTest, AnAnswerWithoutEndIsGivenUpByItsLength) {
  for (const ReplyShape shape : {ReplyShape::line(), ReplyShape::text(), ReplyShape::until_quiet(50)}) {
    Answer answer;
    start("lst", shape, Priority::intent, answer);
    for (int kb = 0; kb < 128 && !answer.came; ++kb) arrive(std::string(1024, 'x'));
    EXPECT_TRUE(answer.came) << "without a pause, at one instant";
    time.run_for(std::chrono::seconds(2));
  }
}

TEST_F(LinkTest, AnEndlessUnsolicitedMessageIsNotKept) {
  std::size_t longest = 0;
  station.unsolicited = [&](std::string_view bytes) {
    longest = std::max(longest, bytes.size());
    return std::string_view::npos;  // it waits for the rest
  };
  for (int kb = 0; kb < 4096; ++kb) arrive(std::string(1024, '$'));
  arrive(std::string(4 << 20, '$'));
  EXPECT_LE(longest, 2u << 16);
  EXPECT_GE(station.statistics().unparsed_bytes, (8u << 20) - (2u << 16)) << "and is counted";
}

TEST_F(LinkTest, TheRecordIsInPiecesOfBoundedLength) {
  arrive(std::string(5000, 'x'));
  std::vector<std::size_t> sizes;
  std::string all;
  traffic.drain([&](const TrafficEntry& entry) { sizes.push_back(entry.bytes.size()), all += entry.bytes; });
  EXPECT_THAT(sizes, ElementsAre(1024, 1024, 1024, 1024, 904));
  EXPECT_EQ(all, std::string(5000, 'x'));
}

TEST_F(LinkTest, AStopGoesOutThroughBabble) {
  Answer list, stop;
  start("lst", ReplyShape::until_quiet(50), Priority::intent, list);
  start("D", ReplyShape::nothing(), Priority::stop, stop);
  for (int ms = 0; ms < 250; ++ms) {
    arrive(std::string(16'384, 'x'));
    time.run_for(Millis(1));
  }
  EXPECT_THAT(wire->sent, ElementsAre("lst", "D"));
  EXPECT_TRUE(stop.came);
}

// ---- order

TEST_F(LinkTest, AStopOvertakesEverythingThatWaits) {
  Answer first, poll, intent, stop;
  start("X", ReplyShape::line(), Priority::poll, first);
  start("Y", ReplyShape::line(), Priority::poll, poll);
  start("I1M400\r", ReplyShape::nothing(), Priority::intent, intent);
  start("D", ReplyShape::nothing(), Priority::stop, stop);
  EXPECT_THAT(wire->sent, ElementsAre("X"));
  arrive("+0000000\r");
  EXPECT_THAT(wire->sent, ElementsAre("X", "D", "I1M400\r", "Y"));
  EXPECT_TRUE(first.came && stop.came && intent.came);
  EXPECT_FALSE(poll.came);
}

TEST_F(LinkTest, AStopWaitsForNoPatientQuestion) {
  Answer patient, stop;
  Transaction question("rsm\r", ReplyShape::line(), Priority::intent);
  question.patience = std::chrono::seconds(20);
  asio::co_spawn(io, ask(station, std::move(question), patient), asio::detached);
  time.run_for(std::chrono::seconds(1));
  start("D", ReplyShape::nothing(), Priority::stop, stop);
  EXPECT_THAT(wire->sent, ElementsAre("rsm\r")) << "the answer may be coming just now";
  time.run_for(Millis(201));
  EXPECT_THAT(wire->sent, ElementsAre("rsm\r", "D"));
  EXPECT_TRUE(patient.came && !patient.result);
}

TEST_F(LinkTest, AStopWaitsForNoPatientStopEither) {
  Answer patient, stop;
  Transaction question("@02STOP\r", ReplyShape::line(), Priority::stop);
  question.patience = std::chrono::seconds(60);
  asio::co_spawn(io, ask(station, std::move(question), patient), asio::detached);
  time.run_for(std::chrono::seconds(1));
  start("@01STOP\r", ReplyShape::line(), Priority::stop, stop);
  time.run_for(Millis(201));
  EXPECT_THAT(wire->sent, ElementsAre("@02STOP\r", "@01STOP\r"));
}

TEST_F(LinkTest, AStopThatWaitsAlreadyHurriesTheOneBeforeIt) {
  Answer poll, patient, stop;
  start("X", ReplyShape::line(), Priority::poll, poll);
  Transaction question("@02STOP\r", ReplyShape::line(), Priority::stop);
  question.patience = std::chrono::seconds(60);
  asio::co_spawn(io, ask(station, std::move(question), patient), asio::detached);
  start("@01STOP\r", ReplyShape::line(), Priority::stop, stop);
  arrive("+0000000\r");
  time.run_for(Millis(201));
  EXPECT_THAT(wire->sent, ElementsAre("X", "@02STOP\r", "@01STOP\r"));
}

TEST_F(LinkTest, AnUnansweredQuestionEndsAtItsDeadlineAndALateReplyIsNotTakenForTheNext) {
  Answer lost, next;
  start("X", ReplyShape::line(), Priority::poll, lost);
  start("Y", ReplyShape::line(), Priority::poll, next);
  time.run_for(Millis(199));
  EXPECT_FALSE(lost.came);
  time.run_for(Millis(2));
  ASSERT_TRUE(lost.came);
  EXPECT_EQ(lost.result.error().kind, FaultKind::no_answer);
  arrive("+0000001\r");
  EXPECT_FALSE(next.came) << "the late answer to X is no answer to Y";
  time.run_for(Millis(60));
  arrive("+0000002\r");
  ASSERT_TRUE(next.came);
  EXPECT_EQ(*next.result, "+0000002\r");
  EXPECT_EQ(station.statistics().unparsed_bytes, 9u);
}

TEST_F(LinkTest, TextBeforeTheReplyIsPassedOn) {
  std::string unsolicited;
  station.unsolicited = [&](std::string_view bytes) { return unsolicited += bytes, bytes.size(); };
  Answer answer;
  Transaction t("X", ReplyShape::line(), Priority::poll);
  t.unsolicited_length = [](std::string_view received) -> std::size_t {
    if (received.front() != ':') return received.front() == '+' ? 0 : 1;
    const auto end = received.find('.');
    return end == received.npos ? end : end + 1;
  };
  asio::co_spawn(io, ask(station, std::move(t), answer), asio::detached);
  time.run_for(Duration::zero());
  arrive("^:+12\r");
  EXPECT_EQ(unsolicited, "^");
  arrive("3.+00");
  arrive("00400\r^");
  ASSERT_TRUE(answer.came);
  EXPECT_EQ(*answer.result, "+0000400\r");
  EXPECT_EQ(unsolicited, "^:+12\r3.^");
}

TEST_F(LinkTest, AStopEndsTheProcedureUnderWay) {
  Answer flying, waiting, later, after;
  start("X", ReplyShape::line(), Priority::poll, flying);
  start("S1M400\r", ReplyShape::nothing(), Priority::transfer, waiting);
  std::optional<Result<>> paused;
  const auto pause = [](Station& on, std::optional<Result<>>& result) -> Task<> {
    result = co_await on.pause(std::chrono::seconds(10));
  };
  asio::co_spawn(io, pause(station, paused), asio::detached);
  time.run_for(Duration::zero());
  station.preempt();
  time.run_for(Duration::zero());
  ASSERT_TRUE(paused.has_value());
  EXPECT_EQ(paused->error().kind, FaultKind::stopped);
  start("R", ReplyShape::nothing(), Priority::intent, later);
  for (const Answer* a : {&waiting, &later}) {
    ASSERT_TRUE(a->came);
    EXPECT_EQ(a->result.error().kind, FaultKind::stopped);
  }
  arrive("+0000000\r");
  EXPECT_TRUE(flying.result.has_value()) << "what is on the wire is heard to its end";
  station.begin_procedure();
  start("R", ReplyShape::nothing(), Priority::intent, after);
  EXPECT_THAT(wire->sent, ElementsAre("X", "R"));
}

TEST_F(LinkTest, AStopWaitsForStepsThatMustNotBeCutApart) {
  Answer first, second, after;
  {
    const Station::Uncut whole(station);
    start("B38400\r", ReplyShape::nothing(), Priority::intent, first);
    station.preempt();
    start("V", ReplyShape::bytes(1), Priority::intent, second);
    arrive("R");
    EXPECT_TRUE(second.came && second.result.has_value());
    EXPECT_FALSE(station.preempted());
  }
  EXPECT_TRUE(station.preempted());
  start("X", ReplyShape::line(), Priority::intent, after);
  ASSERT_TRUE(after.came);
  EXPECT_EQ(after.result.error().kind, FaultKind::stopped);
}

TEST_F(LinkTest, AClosedWireEndsEveryTransaction) {
  Answer flying, waiting;
  start("X", ReplyShape::line(), Priority::poll, flying);
  start("Y", ReplyShape::line(), Priority::poll, waiting);
  wire->listener->stream_closed(Fault(FaultKind::lost, "The cable was pulled."));
  time.run_for(Duration::zero());
  ASSERT_TRUE(flying.came && waiting.came);
  EXPECT_EQ(flying.result.error().what, "The cable was pulled.");
  EXPECT_FALSE(station.is_open());
  EXPECT_FALSE(link->is_open());
}

TEST_F(LinkTest, AListWithoutAnEndMarkEndsWhenTheWireIsQuiet) {
  Answer list;
  start("lst", ReplyShape::until_quiet(50), Priority::intent, list);
  arrive("PM0 M252\r");
  time.run_for(Millis(40));
  arrive("I1M400\r");
  time.run_for(Millis(40));
  EXPECT_FALSE(list.came);
  time.run_for(Millis(20));
  ASSERT_TRUE(list.came);
  EXPECT_EQ(*list.result, "PM0 M252\rI1M400\r");
  std::string recorded;
  traffic.drain([&](const TrafficEntry& entry) {
    if (entry.way == Way::received) recorded += entry.bytes;
  });
  EXPECT_EQ(recorded, *list.result) << "the record has what the asker got";
}

TEST_F(LinkTest, ACommandWithoutAReplyIsDoneWhenTheWireHasCarriedIt) {
  wire->rate_ = 9600;
  Answer line, next, stop;
  start("I1M400\r", ReplyShape::nothing(), Priority::transfer, line);
  start("I1M500\r", ReplyShape::nothing(), Priority::transfer, next);
  time.run_for(Millis(5));
  start("D", ReplyShape::nothing(), Priority::stop, stop);
  EXPECT_THAT(wire->sent, ElementsAre("I1M400\r"));
  time.run_for(Millis(3));
  EXPECT_TRUE(line.came);
  EXPECT_THAT(wire->sent, ElementsAre("I1M400\r", "D"));
}

TEST_F(LinkTest, PatienceGrowsWithTheTimeThatTheWireNeeds) {
  wire->rate_ = 9600;
  Answer answer;
  start("X", ReplyShape::line(), Priority::poll, answer);
  time.run_for(Millis(210));
  EXPECT_FALSE(answer.came);
  time.run_for(Millis(10));
  EXPECT_TRUE(answer.came);
}

// ---- several devices on one wire

struct BusTest : LinkTest {
  Station other{link, nullptr};
  void start_on(Station& station, std::string bytes, ReplyShape shape, Priority p, Answer& answer) {
    Transaction t(std::move(bytes), shape, p);
    asio::co_spawn(io, ask(station, std::move(t), answer), asio::detached);
    time.run_for(Duration::zero());
  }
};

TEST_F(BusTest, AStopOfOneDeviceOvertakesAllAndDropsOnlyItsOwn) {
  Answer flying, mine, others, stop;
  start_on(station, "@01PX\r", ReplyShape::line(), Priority::poll, flying);
  start_on(station, "@01X400\r", ReplyShape::nothing(), Priority::intent, mine);
  start_on(other, "@02X400\r", ReplyShape::nothing(), Priority::intent, others);
  station.preempt();
  time.run_for(Duration::zero());
  station.begin_procedure();
  start_on(station, "@01STOP\r", ReplyShape::line(), Priority::stop, stop);
  EXPECT_THAT(wire->sent, ElementsAre("@01PX\r"));
  arrive("0\r");
  EXPECT_THAT(wire->sent, ElementsAre("@01PX\r", "@01STOP\r"));
  arrive("OK\r");
  EXPECT_THAT(wire->sent, ElementsAre("@01PX\r", "@01STOP\r", "@02X400\r"));
  EXPECT_EQ(mine.result.error().kind, FaultKind::stopped);
  EXPECT_TRUE(stop.result.has_value() && others.result.has_value());
}

TEST_F(BusTest, BetweenTheTextsOfAStopNoOtherDeviceIsAsked) {
  Answer poll, first, second, other_device;
  bool stops = true;
  station.stops = [&] { return stops; };
  start_on(other, "@02PX\r", ReplyShape::line(), Priority::poll, poll);
  start_on(station, "@01SR0=0\r", ReplyShape::line(), Priority::stop, first);
  arrive("OK\r");
  EXPECT_THAT(wire->sent, ElementsAre("@01SR0=0\r"));
  start_on(other, "@02STOP\r", ReplyShape::line(), Priority::stop, other_device);
  arrive("OK\r");
  start_on(station, "@01STOP\r", ReplyShape::line(), Priority::stop, second);
  arrive("OK\r");
  EXPECT_THAT(wire->sent, ElementsAre("@01SR0=0\r", "@02STOP\r", "@01STOP\r"));
  stops = false;
  station.stop_was_sent();
  EXPECT_EQ(wire->sent.back(), "@02PX\r");
}

Task<> poll_for_ever(Station& station, std::string question, int& rounds) {
  for (;;) {
    Transaction t(question, ReplyShape::line(), Priority::poll);
    const auto reply = co_await station.transact(std::move(t));
    if (!reply) co_return;
    ++rounds;
  }
}

TEST_F(BusTest, PollsTakeTurns) {
  int first = 0, second = 0;
  asio::co_spawn(io, poll_for_ever(station, "@01PX\r", first), asio::detached);
  asio::co_spawn(io, poll_for_ever(other, "@02PX\r", second), asio::detached);
  time.run_for(Duration::zero());
  for (int i = 0; i < 6; ++i) arrive("0\r");
  EXPECT_THAT(wire->sent,
              ElementsAre("@01PX\r", "@02PX\r", "@01PX\r", "@02PX\r", "@01PX\r", "@02PX\r", "@01PX\r"));
  EXPECT_EQ(first, 3);
  EXPECT_EQ(second, 3);
}

TEST_F(BusTest, ADeviceThatIsSilentIsTheOnlyOneThatMisses) {
  Answer silent, talks;
  start_on(station, "@01PX\r", ReplyShape::line(), Priority::poll, silent);
  start_on(other, "@02PX\r", ReplyShape::line(), Priority::poll, talks);
  time.run_for(Millis(260));
  arrive("0\r");
  EXPECT_EQ(silent.result.error().kind, FaultKind::no_answer);
  EXPECT_TRUE(talks.result.has_value());
  EXPECT_EQ(station.statistics().misses_in_a_row, 1);
  EXPECT_EQ(other.statistics().misses_in_a_row, 0);
}

TEST_F(BusTest, AnOutstandingReplyIsKnownToAllOnTheWire) {
  const auto miss = [&] {
    Answer silent;
    start_on(station, "@01PX\r", ReplyShape::line(), Priority::poll, silent);
    time.run_for(Millis(250));
    EXPECT_TRUE(silent.came);
  };
  EXPECT_FALSE(other.others_outstanding());
  miss();
  EXPECT_TRUE(station.is_dirty() && !station.others_outstanding() && other.others_outstanding());
  EXPECT_FALSE(other.is_dirty());
  time.run_for(std::chrono::seconds(3));
  EXPECT_FALSE(other.others_outstanding()) << "nothing comes that late";
  miss();
  station.close(Fault(FaultKind::lost, "It was closed."));
  EXPECT_TRUE(other.others_outstanding()) << "it may still answer when nobody listens any more";
}

// A driver that sees to late answers by their looks needs no pause, and an answer that looks different is no
// reason to doubt another's.
TEST_F(BusTest, AReplyOfAnotherKindIsNotWaitedFor) {
  constexpr ReplyKind name{1}, number{2};
  Answer silent, next;
  station.unmistakable = [](const OutstandingReplies&, Instant) { return std::nullopt; };
  Transaction who("@01DN\r", ReplyShape::line(), Priority::poll);
  who.reply_kind = name;
  asio::co_spawn(io, ask(station, std::move(who), silent), asio::detached);
  start_on(other, "@02PX\r", ReplyShape::line(), Priority::poll, next);
  time.run_for(Millis(201));
  EXPECT_TRUE(silent.came);
  EXPECT_TRUE(other.others_outstanding(name));
  EXPECT_FALSE(other.others_outstanding(number));
  EXPECT_THAT(wire->sent, ElementsAre("@01DN\r", "@02PX\r"));
}

TEST_F(BusTest, UnsolicitedBytesGoToTheirStation) {
  const auto receives = [](std::string mark, std::string& received) {
    return [mark, &received](std::string_view bytes) -> std::size_t {
      const auto end = bytes.find('\r');
      if (end == bytes.npos) return bytes.front() == '$' ? bytes.npos : 0;
      if (bytes.substr(0, end) != mark) return 0;
      received += mark;
      return end + 1;
    };
  };
  std::string first, second;
  station.unsolicited = receives("$01P", first);
  other.unsolicited = receives("$02P", second);
  arrive("$02P\r$01P\r$02P\r");
  EXPECT_EQ(first, "$01P");
  EXPECT_EQ(second, "$02P$02P");
  for (const char* piece : {"$", "01", "P", "\r"}) arrive(piece);
  EXPECT_EQ(first, "$01P$01P");
  EXPECT_EQ(station.statistics().unparsed_bytes, 0u);
  arrive("$0");
  time.run_for(Millis(100));
  EXPECT_EQ(station.statistics().unparsed_bytes, 2u) << "what never ends is not waited for";
}

TEST_F(BusTest, ALeavingStationDropsItsTransactionsAndTheirLateAnswer) {
  Answer flying, mine, others;
  start_on(station, "@01PX\r", ReplyShape::line(), Priority::poll, flying);
  start_on(other, "@02PX\r", ReplyShape::line(), Priority::poll, others);
  station.close(Fault(FaultKind::lost, "It was closed."));
  time.run_for(Duration::zero());
  EXPECT_EQ(flying.result.error().what, "It was closed.");
  arrive("1000\r");
  EXPECT_FALSE(others.came);
  time.run_for(Millis(60));
  arrive("2000\r");
  EXPECT_EQ(*others.result, "2000\r");
  start_on(station, "@01PX\r", ReplyShape::line(), Priority::poll, mine);
  EXPECT_EQ(mine.result.error().kind, FaultKind::lost);
}

TEST_F(BusTest, AClosedWireIsClosedForAll) {
  int reported = 0;
  station.closed = other.closed = [&](const Fault&) { ++reported; };
  Answer waiting;
  start_on(other, "@02PX\r", ReplyShape::line(), Priority::poll, waiting);
  wire->listener->stream_closed(Fault(FaultKind::lost, "The cable was pulled."));
  time.run_for(Duration::zero());
  EXPECT_EQ(reported, 2);
  EXPECT_EQ(waiting.result.error().what, "The cable was pulled.");
  EXPECT_FALSE(station.is_open() || other.is_open());
}

}  // namespace
}  // namespace hw
