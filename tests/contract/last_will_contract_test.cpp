// What every driver leaves with the watchdog for a held jog: when it is there, and that its bytes alone stop
// the axis.
#include "tests/contract/rig.h"
#include "transports/serve.h"

namespace hw {
namespace {

using std::chrono::seconds;

/// A wire that another process could reach.
class SharedStream final : public Stream, private Stream::Listener {
 public:
  explicit SharedStream(std::unique_ptr<Stream> inner) : inner_(std::move(inner)) {}
  void listen(Stream::Listener* listener) override {
    listener_ = listener;
    inner_->listen(listener ? this : nullptr);
  }
  void send(std::string_view bytes) override { inner_->send(bytes); }
  void discard_unsent() override { inner_->discard_unsent(); }
  Result<> set_rate(int baud) override { return inner_->set_rate(baud); }
  [[nodiscard]] int rate() const override { return inner_->rate(); }
  [[nodiscard]] bool carries_messages() const override { return inner_->carries_messages(); }
  [[nodiscard]] WireShare share() const override { return {WireShare::How::bytes, 0, {}, 0}; }
  [[nodiscard]] std::string describe() const override { return inner_->describe(); }

 private:
  void bytes_arrived(std::string_view bytes) override { listener_->bytes_arrived(bytes); }
  void stream_closed(const Fault& why) override { listener_->stream_closed(why); }
  std::unique_ptr<Stream> inner_;
  Stream::Listener* listener_ = nullptr;
};
class ReachedWindow final : public Window {
 public:
  explicit ReachedWindow(std::unique_ptr<Window> inner) : inner_(std::move(inner)) {}
  void listen(Listener* listener) override { inner_->listen(listener); }
  Task<Result<>> run(std::span<BusCycle> cycles) override { return inner_->run(cycles); }
  [[nodiscard]] bool reports_interrupts() const override { return inner_->reports_interrupts(); }
  [[nodiscard]] WireShare share() const override { return {WireShare::How::memory, 0, {}, 0}; }
  [[nodiscard]] std::string describe() const override { return inner_->describe(); }

 private:
  std::unique_ptr<Window> inner_;
};

/// Keeps what is left, and carries nothing out.
class Notary final : public WillKeeper {
 public:
  std::vector<LastWill> left;  ///< now
  bool silent = false;

  std::shared_ptr<Will> leave(Scheduler&, const WireShare&, const LastWill& will) override {
    left.push_back(will);
    return std::make_shared<Left>(*this);
  }
  [[nodiscard]] bool is_there() const override { return true; }

 private:
  struct Left final : Will {
    Notary& notary;
    explicit Left(Notary& n) : notary(n) {}
    ~Left() override { notary.left.erase(notary.left.begin()); }
    [[nodiscard]] bool may_be_carried_out() const override { return notary.silent; }
  };
};

class LastWillContract : public ContractTest {
 protected:
  void SetUp() override {
    ContractTest::open([this](Scheduler& scheduler, Address address, std::shared_ptr<BenchAccess> again) {
      return reached(scheduler, std::move(address), std::move(again));
    });
    if (session->catalog().axes[0].switchable) perform(intent::SetPower(0, true));
    run(seconds(1));
  }
  Task<Result<Wire>> reached(Scheduler& scheduler, Address address, std::shared_ptr<BenchAccess> again) {
    ++times_opened;
    auto usual = make_wire_opener();
    auto wire = co_await usual(scheduler, std::move(address), std::move(again));
    if (!wire) co_return wire;
    if (wire->stream) wire->stream = std::make_unique<SharedStream>(std::move(wire->stream));
    if (wire->window) wire->window = std::make_unique<ReachedWindow>(std::move(wire->window));
    wire->keeper = notary;
    co_return wire;
  }
  void jog(Duration time_held) {
    ASSERT_EQ(perform(intent::JogStart(AxisId{0}, Sign::plus)).state, IntentState::done);
    hold(time_held);
  }
  void hold(Duration time_held) {
    for (Duration held{}; held < time_held; held += Millis(50)) {
      session->send(intent::JogKeepAlive());
      run(Millis(50));
    }
  }
  bool moves() {
    const Steps before = load();
    hold(Millis(100));
    return load() != before;
  }
  /// As the watchdog does: by another end of the same wire.
  void carry_out(const LastWill& will) {
    const auto host = EmulatorHost::of(session->bench());
    ASSERT_NE(host, nullptr);
    std::unique_ptr<Stream> stream;
    std::unique_ptr<Window> window;
    if (host->is_board())
      window = std::move(*host->plug_in_window());
    else
      stream = std::move(*host->plug_in());
    Millis sentence{};
    for (WillStep words : will) {
      hold(words.after - sentence);
      sentence = words.after;
      if (stream) stream->send(words.bytes);
      if (window)
        asio::co_spawn(
            io,
            [](Window& w, std::vector<BusCycle> c) -> Task<> { (void)co_await w.run(c); }(*window,
                                                                                          words.cycles),
            asio::detached);
      run(Millis(1));
    }
  }

  int times_opened = 0;
  std::shared_ptr<Notary> notary = std::make_shared<Notary>();
};

INSTANTIATE_TEST_SUITE_P(Every, LastWillContract, testing::ValuesIn(types_under_test()), name_of_type);

TEST_P(LastWillContract, IsThereWhileAJogIsHeldAndUntilItsStopIsOver) {
  EXPECT_TRUE(notary->left.empty());
  ASSERT_NO_FATAL_FAILURE(jog(Millis(500)));
  EXPECT_EQ(notary->left.size(), 1u);
  session->send(intent::JogStop());
  run(Millis(1));
  EXPECT_EQ(notary->left.size(), 1u) << "the stop has just gone out";
  ASSERT_TRUE(becomes_idle(seconds(10)));
  run(Millis(500));
  EXPECT_TRUE(notary->left.empty());
}

TEST_P(LastWillContract, IsNotLeftForMovesAndScripts) {
  perform(intent::MoveBy({{AxisId{0}, Steps(2000)}}));
  run(Millis(100));
  EXPECT_TRUE(notary->left.empty());
  ASSERT_TRUE(becomes_idle(seconds(60)));
  perform(intent::JogStart(AxisId{0}, Sign::plus, {}, false));
  run(Millis(300));
  EXPECT_TRUE(notary->left.empty());
  perform(intent::Stop());
}

TEST_P(LastWillContract, StopsTheJogByItsBytesAlone) {
  ASSERT_NO_FATAL_FAILURE(jog(Millis(600)));
  ASSERT_TRUE(moves());
  ASSERT_EQ(notary->left.size(), 1u);
  const LastWill will = notary->left.front();
  carry_out(will);
  hold(seconds(3));
  EXPECT_FALSE(moves());
}

TEST_P(LastWillContract, ComesBehindAMessageThatWasCutShort) {
  ASSERT_NO_FATAL_FAILURE(jog(Millis(600)));
  const auto host = EmulatorHost::of(session->bench());
  if (host->is_board()) GTEST_SKIP() << "a board has no messages that are cut short";
  const LastWill will = notary->left.front();
  auto torn = std::move(*host->plug_in());
  torn->send(session->catalog().addressed() ? "@01X10" : "I1M30");
  run(Millis(2));
  carry_out(will);
  hold(seconds(3));
  EXPECT_FALSE(moves());
}

TEST_P(LastWillContract, NothingIsSentOnAWireWhoseWatchdogMayHaveSpoken) {
  ASSERT_NO_FATAL_FAILURE(jog(Millis(500)));
  notary->silent = true;
  std::string why;
  on_wake = [&] {
    if (now().link.state == LinkState::lost) why = now().link.sentence.view();
    notary->silent = notary->silent && why.empty();
  };
  const int opened_before = times_opened;
  ASSERT_TRUE(run_until([&] { return times_opened > opened_before; }, seconds(5)));
  EXPECT_NE(why.find("watchdog"), std::string::npos) << why;
  EXPECT_TRUE(run_until([this] { return now().link.state == LinkState::good; }, seconds(10)));
  EXPECT_TRUE(becomes_idle(seconds(10)));
  on_wake = nullptr;
}

}  // namespace
}  // namespace hw
