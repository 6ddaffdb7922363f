// The life of a connection, seen from the wire: a toy controller whose every byte the test reads.
#include "core/device/pump.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/time/virtual_scheduler.h"

namespace hw {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

/// The machine at the other end.
struct ToyMachine {
  std::vector<std::string> sent;  ///< what has gone out to it
  bool silent = false;            ///< answers nothing, but hears
  bool deaf_to_stops = false;     ///< and does not act on them
  bool moves = false;
};

/// Says what goes out; answers '?' with 'M' or '.'.
class ToyWire : public Stream {
 public:
  ToyWire(Scheduler& scheduler, ToyMachine& machine) : scheduler_(scheduler), machine_(machine) {}
  ~ToyWire() override { *alive_ = false; }
  void listen(Listener* listener) override { listener_ = listener; }
  void discard_unsent() override {}
  void send(std::string_view bytes) override {
    machine_.sent.emplace_back(bytes);
    if (bytes == "go" || bytes == "jog") machine_.moves = true;
    const bool stops = bytes == "stop" || bytes == "kill" || bytes == "STOP";
    if (stops && !machine_.deaf_to_stops) machine_.moves = false;
    if (bytes != "?" || machine_.silent) return;
    asio::post(scheduler_.executor(), [this, alive = alive_] {
      if (*alive && listener_) listener_->bytes_arrived(machine_.moves ? "M" : ".");
    });
  }
  Result<> set_rate(int) override { return {}; }
  [[nodiscard]] int rate() const override { return 0; }
  [[nodiscard]] std::string describe() const override { return "a toy"; }

 private:
  Scheduler& scheduler_;
  ToyMachine& machine_;
  Listener* listener_ = nullptr;
  std::shared_ptr<bool> alive_ = std::make_shared<bool>(true);
};

class ToyDriver : public Driver {
 public:
  explicit ToyDriver(DriverContext context) : context_(std::move(context)) {}

  void attach(Station& station) override { station_ = &station; }
  Task<Result<>> connect() override {
    auto greeted = co_await transmit("hello", Priority::intent);
    if (!greeted) co_return greeted;
    co_return co_await poll(Round::usual);
  }
  Task<Result<>> poll(Round) override {
    Transaction t("?", ReplyShape::bytes(1), Priority::poll);
    auto reply = co_await station_->transact(std::move(t));
    if (!reply) co_return fail(reply.error());
    context_.snapshot.axes[0].seen_at = context_.scheduler.now();
    context_.snapshot.axes[0].activity = *reply == "M" ? Activity::moving : Activity::idle;
    co_return Result<>();
  }
  Task<Result<>> perform(const IntentBody& body) override {
    if (std::holds_alternative<intent::LoadProgram>(body)) {
      for (int i = 0; i < 5; ++i) {
        auto sent = co_await transmit("line " + std::to_string(i), Priority::transfer);
        if (!sent) co_return sent;
        auto waited = co_await station_->pause(Millis(10));
        if (!waited) co_return waited;
      }
      co_return Result<>();
    }
    if (std::holds_alternative<intent::Store>(body))
      co_return fail(FaultKind::refused, "No memory.", "Nothing was sent.");
    if (std::holds_alternative<intent::Reset>(body)) throw std::runtime_error("a library gave up");
    if (const auto* text = std::get_if<intent::SendText>(&body))
      co_return co_await transmit(text->text, Priority::intent);
    const bool jog = std::holds_alternative<intent::JogStart>(body);
    co_return co_await transmit(jog ? "jog" : "go", Priority::intent);
  }
  Task<Result<std::string>> stop(const StopOrder& order) override {
    std::string text = order.at_once ? "kill" : "stop";
    if (order.what == StopOrder::What::words) text = order.words;
    auto stopped = co_await transmit(std::move(text), Priority::stop);
    if (!stopped) co_return fail(stopped.error());
    co_return std::string();
  }
  [[nodiscard]] LastWill last_will(unsigned) const override { return {}; }
  StopProgress stop_progress(const StopOrder&) override {
    return context_.snapshot.any_axis_moving() ? StopProgress::again() : StopProgress::stands();
  }
  void wire_lost() override {
    station_ = nullptr;
    context_.snapshot.axes[0].activity = Activity::unknown;
  }
  Task<Result<std::string>> query(std::string text, Duration) override {
    if (text == "defect") throw std::runtime_error("a library gave up");
    auto sent = co_await transmit(text, Priority::intent);
    if (!sent) co_return fail(sent.error());
    co_return "answer to " + text;
  }
  [[nodiscard]] TextMeaning meaning_of(const intent::SendText& text) const override {
    TextMeaning meaning;
    if (text.text == "STOP") meaning.stops = TextMeaning::Stops::all;
    return meaning;
  }
  [[nodiscard]] Duration moving_period() const override { return Millis(20); }
  [[nodiscard]] Duration idle_period() const override { return Millis(200); }

 private:
  Task<Result<>> transmit(std::string text, Priority priority) {
    Transaction t(std::move(text), ReplyShape::nothing(), priority);
    auto sent = co_await station_->transact(std::move(t));
    if (!sent) co_return fail(sent.error());
    co_return Result<>();
  }
  DriverContext context_;
  Station* station_ = nullptr;
};

std::unique_ptr<Driver> make_toy(DriverContext context) {
  return std::make_unique<ToyDriver>(std::move(context));
}

struct PumpTest : testing::Test {
  IoContext io;
  VirtualScheduler time{io};
  Catalog catalog = [] {
    Catalog c;
    c.axes.push_back({"1", "motor 1"});
    c.name = "Toy";
    return c;
  }();
  DeviceType type{};
  ToyMachine machine;
  std::vector<std::string>& sent = machine.sent;
  bool& silent = machine.silent;
  int opened = 0;
  bool port_missing = false;
  std::vector<std::string> notices;
  Snapshot latest;
  std::unique_ptr<Pump> pump;
  IntentId last_id = 0;

  void SetUp() override {
    type.make_driver = &make_toy;
    Pump::Callbacks callbacks;
    callbacks.open_wire = [this] { return open(); };
    callbacks.publish = [this](const Snapshot& s) { latest = s; };
    callbacks.notify = [this](Notice n) { notices.push_back(std::move(n.text)); };
    callbacks.traffic = &traffic;
    callbacks.recorded = [this] { ++recorded; };
    pump = std::make_unique<Pump>(time, type, catalog, std::move(callbacks));
    pump->start();
    time.run_for(Millis(1));
  }
  void TearDown() override {
    asio::co_spawn(io, pump->shut_down(), asio::detached);
    time.run_for(std::chrono::seconds(9));  // a stop that is owed
    EXPECT_EQ(latest.link.state, LinkState::closed);
  }
  Task<Result<std::shared_ptr<Link>>> open() {
    ++opened;
    if (port_missing) co_return fail(FaultKind::port, "/dev/ttyUSB0 does not exist.");
    std::unique_ptr<Stream> wire = std::make_unique<ToyWire>(time, machine);
    co_return std::make_shared<Link>(time, std::move(wire));
  }
  IntentId post(IntentBody body) {
    pump->post(Intent(++last_id, std::move(body)));
    return last_id;
  }
  [[nodiscard]] std::vector<std::string> commands() const {
    std::vector<std::string> all;
    for (const std::string& s : sent)
      if (s != "?") all.push_back(s);
    return all;
  }
  /// What has gone out since the last call, but polls.
  std::vector<std::string> news() {
    std::vector<std::string> all = commands();
    sent.clear();
    return all;
  }
  void lose_it() {
    silent = true;
    while (latest.link.state != LinkState::lost) time.run_for(Millis(10));
  }
  [[nodiscard]] IntentState outcome(IntentId id) const { return latest.outcome_of(id)->state; }
  [[nodiscard]] std::string sentence(IntentId id) const {
    return std::string(latest.outcome_of(id)->sentence.view());
  }
  TrafficRing traffic{256};
  int recorded = 0;
  [[nodiscard]] int polls() const { return static_cast<int>(std::count(sent.begin(), sent.end(), "?")); }
};

TEST_F(PumpTest, PollsSlowlyAtRestAfterAFewQuickRounds) {
  time.run_for(Millis(100));
  sent.clear();
  time.run_for(std::chrono::seconds(2));
  EXPECT_EQ(polls(), 10);
  EXPECT_EQ(latest.link.state, LinkState::good);
}

TEST_F(PumpTest, TrafficBesidePollsIsReportedSoThatItIsShown) {
  time.run_for(std::chrono::seconds(1));
  const int before = recorded;
  time.run_for(std::chrono::seconds(1));
  EXPECT_EQ(recorded, before) << "polls do not count";
  post(intent::MoveTo({{AxisId{0}, Steps(400)}}));
  time.run_for(Millis(10));
  EXPECT_EQ(recorded, before + 1);
}

TEST_F(PumpTest, NothingOfADownloadGoesOutBehindAStop) {
  const IntentId load = post(intent::LoadProgram(0, "text"));
  time.run_for(Millis(25));
  const IntentId stop = post(intent::Stop());
  time.run_for(Millis(100));
  EXPECT_THAT(commands(), ElementsAre("hello", "line 0", "line 1", "line 2", "stop"));
  EXPECT_EQ(latest.outcome_of(stop)->state, IntentState::done);
  EXPECT_EQ(latest.outcome_of(load)->state, IntentState::failed);
  EXPECT_THAT(std::string(latest.outcome_of(load)->sentence.view()), HasSubstr("A stop came first"));
}

TEST_F(PumpTest, AStopInTheControllersOwnWordsWaitsForNothingEither) {
  const IntentId load = post(intent::LoadProgram(0, "text"));
  time.run_for(Millis(5));
  const IntentId move = post(intent::MoveTo({{AxisId{0}, Steps(400)}}));
  const IntentId stop = post(intent::SendText("STOP"));
  time.run_for(Millis(100));
  EXPECT_THAT(commands(), ElementsAre("hello", "line 0", "STOP"));
  EXPECT_EQ(latest.outcome_of(load)->state, IntentState::failed);
  EXPECT_EQ(latest.outcome_of(move)->state, IntentState::refused);
  EXPECT_EQ(latest.outcome_of(stop)->state, IntentState::done);
}

TEST_F(PumpTest, AStopInItsOwnWordsPushesNoOtherAsideAndWaitsForNone) {
  post(intent::MoveTo({{AxisId{0}, Steps(400)}}));
  time.run_for(Millis(5));
  machine.deaf_to_stops = true;
  post(intent::Stop());
  post(intent::SendText("STOP"));
  time.run_for(Millis(10));
  news();
  machine.deaf_to_stops = false;
  time.run_for(Millis(100));
  EXPECT_THAT(news(), ElementsAre("stop")) << "in the same form, and the typed one is not said again";
  post(intent::MoveTo({{AxisId{0}, Steps(400)}}));
  time.run_for(Millis(50));
  EXPECT_THAT(news(), ElementsAre("go")) << "and the way is free again";
}

TEST_F(PumpTest, AStopRefusesCommandsThatWaitBehindAProcedure) {
  post(intent::LoadProgram(0, "text"));
  time.run_for(Millis(5));
  const IntentId move = post(intent::MoveTo({{AxisId{0}, Steps(400)}}));
  post(intent::Stop());
  time.run_for(Millis(200));
  EXPECT_EQ(latest.outcome_of(move)->state, IntentState::refused);
  EXPECT_THAT(commands(), ElementsAre("hello", "line 0", "stop"));
  post(intent::MoveTo({{AxisId{0}, Steps(400)}}));
  time.run_for(Millis(50));
  EXPECT_THAT(commands(), ElementsAre("hello", "line 0", "stop", "go"))
      << "after the stop the console works again";
}

TEST_F(PumpTest, AJogWithoutKeepAlivesIsStopped) {
  post(intent::JogStart(AxisId{0}, Sign::plus));
  for (int i = 0; i < 10; ++i) {
    time.run_for(Millis(100));
    post(intent::JogKeepAlive());
  }
  EXPECT_THAT(commands(), ElementsAre("hello", "jog"));
  time.run_for(Millis(249));
  EXPECT_THAT(commands(), ElementsAre("hello", "jog"));
  time.run_for(Millis(2));
  EXPECT_THAT(commands(), ElementsAre("hello", "jog", "stop"));
  EXPECT_THAT(notices, ElementsAre(HasSubstr("The jog was no longer held")));
}

struct PumpClosing : PumpTest {
  void close_now() { asio::co_spawn(io, pump->shut_down(), asio::detached); }
};

TEST_F(PumpClosing, AHeldJogIsStopped) {
  post(intent::JogStart(AxisId{0}, Sign::plus));
  time.run_for(Millis(100));
  close_now();
  time.run_for(std::chrono::seconds(3));
  EXPECT_THAT(commands(), ElementsAre("hello", "jog", "stop"));
  EXPECT_EQ(latest.link.state, LinkState::closed);
}

TEST_F(PumpClosing, AStopThatWasAskedForGoesOut) {
  const IntentId stop = post(intent::Abort());
  close_now();
  time.run_for(Millis(10));
  const IntentId move = post(intent::MoveTo({{AxisId{0}, Steps(400)}}));
  time.run_for(std::chrono::seconds(3));
  EXPECT_THAT(commands(), ElementsAre("hello", "kill"));
  EXPECT_EQ(outcome(stop), IntentState::done);
  EXPECT_EQ(outcome(move), IntentState::refused) << "what comes while it closes is not begun";
  EXPECT_EQ(latest.link.state, LinkState::closed);
}

TEST_F(PumpClosing, AStopThatIsTypedWhileItClosesGoesOut) {
  post(intent::MoveTo({{AxisId{0}, Steps(400)}}));
  time.run_for(Millis(50));
  machine.deaf_to_stops = true;
  post(intent::Stop());
  close_now();
  time.run_for(Millis(10));
  news();
  const IntentId typed = post(intent::SendText("STOP"));
  time.run_for(Millis(5));
  EXPECT_THAT(news(), testing::Contains("STOP"));
  machine.deaf_to_stops = false;
  time.run_for(std::chrono::seconds(3));
  EXPECT_EQ(outcome(typed), IntentState::done);
  EXPECT_EQ(latest.link.state, LinkState::closed);
}

TEST_F(PumpClosing, AStopGoesOutBehindAQuestionThatIsNeverAnswered) {
  post(intent::JogStart(AxisId{0}, Sign::plus));
  silent = true;
  const int asked = polls();
  while (polls() == asked) time.run_for(Millis(1));
  post(intent::JogStop());
  close_now();
  time.run_for(Millis(1));
  EXPECT_THAT(commands(), ElementsAre("hello", "jog")) << "the question is on the wire";
  time.run_for(std::chrono::seconds(9));
  ASSERT_GE(commands().size(), 3u);
  EXPECT_EQ(commands()[2], "stop");
  EXPECT_EQ(latest.link.state, LinkState::closed);
}

// ---- stops and lost links

// The third miss, which makes a loss of it, may take seconds: a held jog does not wait for that.
TEST_F(PumpTest, AJogIsStoppedAtTheSecondMissedRound) {
  const auto hold_until = [&](auto seen) {
    for (int ms = 0; ms < 5000 && !seen(); ++ms) {
      if (ms % 100 == 0) post(intent::JogKeepAlive());
      time.run_for(Millis(1));
    }
  };
  post(intent::JogStart(AxisId{0}, Sign::plus));
  hold_until([&] { return machine.moves; });
  silent = true;
  hold_until([&] { return latest.link.misses_in_a_row == 1; });
  EXPECT_TRUE(machine.moves);
  hold_until([&] { return latest.link.misses_in_a_row == 2; });
  time.run_for(Millis(1));
  EXPECT_FALSE(machine.moves);
  EXPECT_NE(latest.link.state, LinkState::lost);
  EXPECT_THAT(notices, testing::Contains(HasSubstr("so a stop is being sent")));
  silent = false;
  time.run_for(Millis(300));
}

// In the silence before a loss nobody knows whether it has got through.
TEST_F(PumpTest, AStopThatALossCutsShortIsMadeGood) {
  post(intent::MoveTo({{AxisId{0}, Steps(400)}}));
  time.run_for(Millis(50));
  machine.deaf_to_stops = true;
  silent = true;
  const IntentId stop = post(intent::Abort());
  while (latest.link.state != LinkState::lost) time.run_for(Millis(10));
  EXPECT_EQ(outcome(stop), IntentState::failed);
  machine.deaf_to_stops = silent = false;
  news();
  time.run_for(std::chrono::seconds(1));
  EXPECT_THAT(news(), ElementsAre("kill", "hello")) << "first of all, in the same form";
  EXPECT_FALSE(machine.moves);
}

TEST_F(PumpTest, AStopIsWrittenToAnOpenWireWhateverTheLinkIsThoughtToBe) {
  post(intent::MoveTo({{AxisId{0}, Steps(400)}}));
  time.run_for(Millis(50));
  lose_it();
  news();
  const IntentId stop = post(intent::Stop());
  time.run_for(Millis(1));
  EXPECT_THAT(news(), testing::Contains("stop")) << "at once";
  EXPECT_FALSE(machine.moves);
  time.run_for(Millis(300));
  EXPECT_EQ(outcome(stop), IntentState::failed);
  EXPECT_THAT(sentence(stop), HasSubstr("does not answer"));
}

TEST_F(PumpTest, WhileAStopIsPendingTheWireIsTriedEveryQuarterOfASecond) {
  post(intent::MoveTo({{AxisId{0}, Steps(400)}}));
  time.run_for(Millis(50));
  lose_it();
  machine.deaf_to_stops = true;
  post(intent::Stop());
  time.run_for(std::chrono::seconds(20));
  const auto stops = [&] { return std::count(sent.begin(), sent.end(), "stop"); };
  const auto before = stops();
  time.run_for(std::chrono::seconds(10));
  EXPECT_GE(stops() - before, 39);
  machine.deaf_to_stops = false;
  time.run_for(Millis(260));
  EXPECT_FALSE(machine.moves);
  silent = false;
  time.run_for(Millis(300));
  EXPECT_EQ(latest.link.state, LinkState::good);
  EXPECT_THAT(notices, testing::Each(testing::Not(HasSubstr("It is stopped now")))) << "nothing ran any more";
}

TEST_F(PumpTest, AMotionStillRunningWhenAPendingStopGetsThroughIsReported) {
  post(intent::MoveTo({{AxisId{0}, Steps(400)}}));
  time.run_for(Millis(50));
  machine.deaf_to_stops = true;
  lose_it();
  post(intent::Stop());
  time.run_for(std::chrono::seconds(2));
  silent = false;
  time.run_for(Millis(400));
  EXPECT_THAT(notices, testing::Contains(HasSubstr("during a jog or a stop")));
  machine.deaf_to_stops = false;
  time.run_for(Millis(100));
  EXPECT_FALSE(machine.moves);
}

// Another host may have begun something since, or begin it before the wire is back.
TEST_F(PumpTest, AStopWithoutALinkIsPendingEvenWhenAllAxesStood) {
  lose_it();
  post(intent::Stop());
  time.run_for(std::chrono::seconds(1));
  news();
  machine.moves = true;
  silent = false;
  time.run_for(std::chrono::seconds(10));
  EXPECT_EQ(news().front(), "stop");
  EXPECT_FALSE(machine.moves);
  EXPECT_EQ(latest.link.state, LinkState::good);
}

// A driver knows no more after a loss what its axes do; what they did is told until it is known again.
TEST_F(PumpTest, AMotionAtALossIsTakenToGoOnUntilTheLinkIsGood) {
  post(intent::MoveTo({{AxisId{0}, Steps(400)}}));
  time.run_for(Millis(50));
  EXPECT_FALSE(latest.link.when_lost.any());
  silent = true;
  while (latest.link.state != LinkState::lost) time.run_for(Millis(10));
  EXPECT_EQ(latest.under_way().axes, 1u);
  time.run_for(std::chrono::seconds(10));
  EXPECT_EQ(latest.under_way().axes, 1u) << "attempts in between change nothing";
  silent = false;
  while (latest.link.state != LinkState::good) time.run_for(Millis(10));
  EXPECT_FALSE(latest.link.when_lost.any());
}

TEST_F(PumpTest, AnAxisAtRestAtALossIsNotTakenToMove) {
  silent = true;
  while (latest.link.state != LinkState::lost) time.run_for(Millis(10));
  EXPECT_FALSE(latest.under_way().any());
}

TEST_F(PumpTest, ALateKeepAliveDoesNotReviveAStoppedJog) {
  post(intent::JogStart(AxisId{0}, Sign::plus));
  time.run_for(Millis(100));
  post(intent::JogStop());
  post(intent::JogKeepAlive());
  time.run_for(std::chrono::seconds(1));
  EXPECT_THAT(commands(), ElementsAre("hello", "jog", "stop"));
}

TEST_F(PumpTest, ThreeMissesAreALossThatIsReportedAndHeals) {
  time.run_for(Millis(500));
  silent = true;
  while (latest.link.state != LinkState::lost) time.run_for(Millis(10));
  EXPECT_LT(time.now(), Instant(std::chrono::seconds(2)));
  EXPECT_THAT(std::string(latest.link.sentence.view()), HasSubstr("no motion will resume by itself"));
  const IntentId move = post(intent::MoveTo({{AxisId{0}, Steps(400)}}));
  time.run_for(Millis(300));
  silent = false;
  time.run_for(std::chrono::seconds(6));
  EXPECT_EQ(latest.link.state, LinkState::good);
  EXPECT_GE(opened, 2);
  EXPECT_EQ(std::count(sent.begin(), sent.end(), "go"), 0)
      << "a move asked for while the link was lost is not replayed";
  ASSERT_NE(latest.outcome_of(move), nullptr);
  EXPECT_EQ(latest.outcome_of(move)->state, IntentState::refused);
}

TEST_F(PumpTest, AStopWithoutAConnectionReportsThatItDoesNotReach) {
  silent = port_missing = true;
  time.run_for(std::chrono::seconds(10));
  const IntentId stop = post(intent::Stop());
  time.run_for(Millis(1));
  EXPECT_EQ(outcome(stop), IntentState::failed);
  EXPECT_THAT(sentence(stop), HasSubstr("power switch"));
}

TEST_F(PumpTest, ReconnectTriesAtOnce) {
  time.run_for(Millis(100));
  silent = true;
  port_missing = true;
  time.run_for(std::chrono::seconds(20));
  EXPECT_EQ(latest.link.state, LinkState::lost);
  EXPECT_THAT(std::string(latest.link.sentence.view()), HasSubstr("/dev/ttyUSB0 does not exist"));
  port_missing = silent = false;
  const Instant before = time.now();
  post(intent::Reconnect());
  time.run_for(Millis(10));
  EXPECT_EQ(latest.link.state, LinkState::good);
  EXPECT_LT(time.now() - before, Millis(11));
}

TEST_F(PumpTest, ARefusalDiffersFromAFailure) {
  const IntentId store = post(intent::Store());
  time.run_for(Millis(50));
  EXPECT_EQ(latest.outcome_of(store)->state, IntentState::refused);
  EXPECT_EQ(latest.outcome_of(store)->sentence.view(), "No memory. Nothing was sent.");
}

TEST_F(PumpTest, ADefectInTheDriverFailsThatCommandAndLosesNothingElse) {
  const IntentId bad = post(intent::Reset());
  const IntentId good = post(intent::MoveTo({{AxisId{0}, Steps(400)}}));
  std::optional<Result<std::string>> reply;
  auto ask = [&]() -> Task<> { reply = co_await pump->query("defect", Millis(100)); };
  asio::co_spawn(io, ask(), asio::detached);
  time.run_for(Millis(50));
  EXPECT_EQ(latest.outcome_of(bad)->state, IntentState::failed);
  EXPECT_THAT(std::string(latest.outcome_of(bad)->sentence.view()), HasSubstr("a library gave up"));
  EXPECT_EQ(latest.outcome_of(good)->state, IntentState::done);
  ASSERT_TRUE(reply.has_value()) << "whoever asked still waits";
  EXPECT_FALSE(reply->has_value());
  EXPECT_EQ(latest.link.state, LinkState::good);
  EXPECT_THAT(commands(), ElementsAre("hello", "go"));
}

TEST_F(PumpTest, AQueryWaitsItsTurnAndGetsItsAnswer) {
  Result<std::string> answer{std::string()};
  const auto ask = [](Pump& p, Result<std::string>& out) -> Task<> {
    std::string text = "X";
    out = co_await p.query(std::move(text), Millis(100));
  };
  post(intent::LoadProgram(0, "text"));
  asio::co_spawn(io, ask(*pump, answer), asio::detached);
  time.run_for(Millis(200));
  EXPECT_EQ(*answer, "answer to X");
  EXPECT_EQ(commands().back(), "X");
}

}  // namespace
}  // namespace hw
