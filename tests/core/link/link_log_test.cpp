// What a link decides is logged: --log link=debug.
#include <gmock/gmock.h>

#include "tests/core/base/log_reader.h"
#include "tests/core/link/link_fixture.h"

namespace hw {
namespace {

using testing::HasSubstr;

struct LinkLog : LinkTest {
  test::LogReader log;
};

TEST_F(LinkLog, AMissedAnswerAndWhatCameInstead) {
  Answer answer;
  station.address = 3;
  start("X", ReplyShape::line(), Priority::poll, answer);
  arrive("+00");
  time.run_for(std::chrono::seconds(2));
  EXPECT_THAT(log.text(), HasSubstr("link: 03: no reply to \"X\" in "));
  EXPECT_THAT(log.text(), HasSubstr("received: \"+00\"\n"));
  EXPECT_THAT(log.text(), HasSubstr("link: 03: bytes not understood: \"+00\"\n"));
}

TEST_F(LinkLog, CommandsDroppedForAStopAreLogged) {
  Answer first, second;
  start("X", ReplyShape::line(), Priority::poll, first);
  start("Y", ReplyShape::line(), Priority::poll, second);
  station.preempt();
  EXPECT_THAT(log.text(), HasSubstr("link: \"Y\" dropped before it was sent: A stop came first."));
}

TEST_F(LinkLog, AQuestionThatIsCutShortForAStop) {
  Answer patient, stop;
  Transaction question("rsm\r", ReplyShape::line(), Priority::intent);
  question.patience = std::chrono::seconds(20);
  asio::co_spawn(io, ask(station, std::move(question), patient), asio::detached);
  time.run_for(std::chrono::seconds(1));
  start("D", ReplyShape::nothing(), Priority::stop, stop);
  EXPECT_THAT(log.text(),
              HasSubstr("link: a stop waits: the answer to \"rsm\\r\" is waited for 200 ms more, not "));
  time.run_for(std::chrono::seconds(1));
}

TEST_F(LinkLog, AnAnswerThatIsNoLongerAwaited) {
  station.doubt({});
  EXPECT_THAT(log.text(), HasSubstr("link: a reply that is no longer awaited may still come"));
}

TEST_F(LinkLog, ARateThatIsSet) {
  ASSERT_TRUE(station.set_rate(38400));
  EXPECT_THAT(log.text(), HasSubstr("link: rate 38400 baud: set\n"));
}

TEST_F(LinkLog, AnEndWithItsReason) {
  Answer answer;
  start("X", ReplyShape::line(), Priority::poll, answer);
  wire->listener->stream_closed(Fault(FaultKind::lost, "The cable was pulled."));
  EXPECT_THAT(log.text(), HasSubstr("link: the wire is closed, devices on it: 1: The cable was pulled.\n"));
  EXPECT_THAT(log.text(), HasSubstr("link: \"X\" was on the wire and is given up: The cable was pulled.\n"));
}

TEST_F(LinkLog, AJogThatNoWatchdogGuards) {
  EXPECT_FALSE(station.leave_will({}));
  EXPECT_THAT(log.text(), HasSubstr("link: no watchdog guards the held jog: it does not run\n"));
}

}  // namespace
}  // namespace hw
