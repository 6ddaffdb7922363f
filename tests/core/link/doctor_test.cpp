// The link doctor: what the record of a wire says about it, and what is made of that.
#include "core/link/doctor.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace hw {
namespace {

using testing::HasSubstr;
using Fix = LinkFinding::Fix;
using Kind = LinkFinding::Kind;
using State = LinkFinding::State;

struct Talk {
  TalkRecorder recorder;
  Instant now{};
  void ask(std::string_view question) { recorder.record(now, Way::sent, TrafficKind::poll, question); }
  void receive(std::string_view bytes, TrafficKind kind = TrafficKind::poll) {
    recorder.record(now, Way::received, kind, bytes);
  }
  void question(std::string_view question, std::string_view answer, Duration takes) {
    ask(question);
    now += takes;
    receive(answer);
    now += Millis(100);
  }
};

const LinkFinding* find(const std::vector<LinkFinding>& all, Kind kind) {
  for (const LinkFinding& finding : all)
    if (finding.kind == kind) return &finding;
  return nullptr;
}

/// As on a line of four with an adapter of the usual make: 6 bytes out, 7 in.
LinkFacts slow_line() {
  Talk talk;
  for (int i = 0; i < 32; ++i) talk.question("@01PX\r", "123456\r", Millis(31));
  LinkFacts f;
  f.talk = talk.recorder.measure();
  f.rate = 9600;
  f.rates = {9600, 19200, 115200};
  f.rate_is_set_by = "DB";
  f.port_looked_at = true;
  f.adapter_waits = Millis(16);
  f.adapter_timer_can_be_set = true;
  return f;
}

TEST(TalkMeasure, MeasuresQuestionsFromTheFirstByteToTheLast) {
  Talk talk;
  for (int i = 1; i <= 100; ++i) talk.question("X", "+0001200\r", Millis(i));
  const TalkMeasure m = talk.recorder.measure();
  EXPECT_EQ(m.questions, 100);
  EXPECT_EQ(m.least, Millis(1));
  EXPECT_EQ(m.median, Millis(51));
  EXPECT_EQ(m.slowest_of_hundred, Millis(100));
  EXPECT_EQ(m.bytes_out, 1);
  EXPECT_EQ(m.bytes_in, 9);
  EXPECT_EQ(m.received, 900u);
}

TEST(TalkMeasure, CountsOnlyTheLatestQuestions) {
  Talk talk;
  for (int i = 0; i < 100; ++i) talk.question("X", "1\r", Millis(500));
  for (std::size_t i = 0; i < TalkRecorder::most_questions; ++i) talk.question("X", "1\r", Millis(2));
  EXPECT_EQ(talk.recorder.measure().slowest_of_hundred, Millis(2)) << "what was slow an hour ago is past";
}

TEST(TalkMeasure, DistinguishesEchoSecondAnswerAndNonsense) {
  Talk talk;
  talk.question("@01PX\r", "@01PX\r", Millis(5));
  talk.question("@01PX\r", "1200\r", Millis(5));
  talk.receive("1200\r", TrafficKind::unparsed);
  talk.question("@01PX\r", "1200\r", Millis(5));
  talk.receive("\xF0\x81\xFE", TrafficKind::unparsed);
  talk.receive("^", TrafficKind::unsolicited);
  const TalkMeasure m = talk.recorder.measure();
  EXPECT_EQ(m.echoes, 1);
  EXPECT_EQ(m.second_answers, 1);
  EXPECT_EQ(m.wrong, 3u);
}

TEST(TalkMeasure, AOneLetterAnswerThatEqualsItsQuestionIsNoEcho) {
  Talk talk;
  talk.question("V", "V", Millis(5));
  EXPECT_EQ(talk.recorder.measure().echoes, 0);
}

TEST(TalkMeasure, AnEchoThatIsNoAnswerIsAnEchoAllTheSame) {
  Talk talk;
  for (const std::string_view letter : {"V", "X", "Y"}) {
    talk.ask(letter);
    talk.receive(letter, TrafficKind::unparsed);
    talk.receive("R");
  }
  talk.ask("@01PX\r");
  talk.receive("@01PX\r", TrafficKind::unparsed);
  talk.receive("1200\r", TrafficKind::unparsed);
  const TalkMeasure m = talk.recorder.measure();
  EXPECT_EQ(m.echoes, 4);
  EXPECT_EQ(m.second_answers, 0) << "the answer behind an echo is the first";
  EXPECT_EQ(m.wrong, 0u);
}

TEST(TalkMeasure, TheSameAnswerTwiceIsASecondAnswerHoweverItEnds) {
  Talk talk;
  talk.question("V", "R", Millis(5));
  talk.receive("R", TrafficKind::unparsed);
  talk.question("@01PX\r", std::string_view("1200\0", 5), Millis(5));
  talk.receive(std::string_view("1300\0", 5), TrafficKind::unparsed);
  EXPECT_EQ(talk.recorder.measure().second_answers, 2);
  EXPECT_EQ(talk.recorder.measure().wrong, 0u);
}

TEST(TalkMeasure, AQuestionRepeatedWithoutAReplyCountsAsUnanswered) {
  Talk talk;
  talk.ask("@01PX\r");
  talk.ask("@01PX\r");
  talk.question("@01PX\r", "1200\r", Millis(5));
  EXPECT_EQ(talk.recorder.measure().unanswered, 2);
}

TEST(LinkDoctor, ReportsWhereTheTimeOfAQuestionGoes) {
  const LinkBudget now = link_budget(slow_line()), then = best_link_budget(slow_line());
  EXPECT_EQ(in_millis(now.question), "6.2 ms");
  EXPECT_EQ(in_millis(now.answer), "7.3 ms");
  EXPECT_EQ(in_millis(now.adapter), "16.0 ms");
  EXPECT_EQ(now.whole(), Millis(31));
  EXPECT_EQ(in_millis(then.whole()), "3.6 ms");
  EXPECT_EQ(link_summary(slow_line()),
            "One query takes 31.0 ms: 32 per second. 3.6 ms is possible: 279 per second.");
}

TEST(LinkDoctor, OffersTheFixesThatCanBeTakenBack) {
  const auto found = examine_link(slow_line());
  const LinkFinding* adapter = find(found, Kind::adapter);
  ASSERT_TRUE(adapter);
  EXPECT_EQ(adapter->what, "The USB adapter waits up to 16 ms before it passes bytes on");
  EXPECT_THAT(adapter->why, HasSubstr("A timer of 1 ms saves 15.0 ms per query. No controller is affected."));
  EXPECT_EQ(adapter->fix, Fix::set_adapter_timer);
  const LinkFinding* rate = find(found, Kind::rate);
  ASSERT_TRUE(rate);
  EXPECT_EQ(rate->what, "The wire runs at 9600 baud, the controller can do 115\u2009200 baud");
  EXPECT_EQ(rate->fix, Fix::raise_rate);
  EXPECT_EQ(rate->rate, 115200);
  EXPECT_EQ(found.back().state, State::good) << "what is good comes last";
}

TEST(LinkDoctor, ShowsHowToSetATimerThatThisUserMayNotSet) {
  LinkFacts f = slow_line();
  f.adapter_timer_can_be_set = false;
  f.adapter_timer = "/sys/bus/usb-serial/devices/ttyUSB0/latency_timer";
  const auto found = examine_link(f);
  EXPECT_EQ(find(found, Kind::adapter)->fix, Fix::none);
  EXPECT_THAT(find(found, Kind::adapter)->why,
              HasSubstr("echo 1 | sudo tee /sys/bus/usb-serial/devices/ttyUSB0/latency_timer"));
}

TEST(LinkDoctor, FindsNothingToMendOnAGoodLink) {
  LinkFacts f = slow_line();
  f.rate = 115200;
  f.adapter_waits = Millis(1);
  for (const LinkFinding& finding : examine_link(f)) EXPECT_EQ(finding.state, State::good) << finding.what;
}

TEST(LinkDoctor, DistinguishesSilenceFromAWrongRate) {
  LinkFacts f;
  f.answers = false;
  f.rate = 9600;
  EXPECT_EQ(examine_link(f).front().what, "Nothing comes back");
  f.talk.received = f.talk.wrong = 12;
  const auto found = examine_link(f);
  EXPECT_EQ(found.front().what, "The replies are not understood");
  EXPECT_THAT(found.front().why, HasSubstr("most likely it is not 9600 baud"));
  EXPECT_EQ(found.front().fix, Fix::change_address);
  EXPECT_FALSE(find(found, Kind::rate)) << "nothing is raised where nothing answers";
}

TEST(LinkDoctor, AnEchoIsReasonEnoughForNoAnswer) {
  LinkFacts f;
  f.answers = false;
  f.rate = 9600;
  f.talk.received = 60;
  f.talk.echoes = 10;
  const auto found = examine_link(f);
  EXPECT_EQ(found.front().what, "The console receives its own bytes");
  EXPECT_FALSE(find(found, Kind::silence)) << "the rate is not to blame";
}

TEST(LinkDoctor, NamesEchoSecondAnswersLossesAndTheOtherProgram) {
  LinkFacts f = slow_line();
  f.talk.echoes = 30;
  f.talk.second_answers = 4;
  f.talk.unanswered = 8;
  f.holder = "minicom (process 4182)";
  std::string all;
  for (const LinkFinding& finding : examine_link(f))
    if (finding.state == State::wrong) all += finding.what + "\n";
  EXPECT_THAT(all, HasSubstr("The console receives its own bytes"));
  EXPECT_THAT(all, HasSubstr("Two replies came to one query"));
  EXPECT_THAT(all, HasSubstr("8 of 40 queries got no reply"));
  EXPECT_THAT(all, HasSubstr("minicom (process 4182) has the port open too"));
}

TEST(LinkDoctor, ALineWithoutARateHasNoBytesToSave) {
  LinkFacts f = slow_line();
  f.rate = 0;
  f.adapter_waits.reset();
  f.port_looked_at = false;
  EXPECT_EQ(link_budget(f).rest, Millis(31));
  EXPECT_EQ(link_summary(f), "One query takes 31.0 ms: 32 per second.");
  EXPECT_FALSE(find(examine_link(f), Kind::rate));
}

}  // namespace
}  // namespace hw
