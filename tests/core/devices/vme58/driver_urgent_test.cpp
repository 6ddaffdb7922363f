// A stop reaches a board that takes no command, or does nothing with its mail.
#include "core/devices/vme58/facts.h"
#include "tests/core/devices/vme58/driver_rig.h"

namespace hw {
namespace {

using test::Seconds;
using testing::HasSubstr;

class Vme58Urgent : public test::Vme58Rig {
 protected:
  Vme58Urgent() : Vme58Rig({{"variant", "8"}}) {}
  void turn(const char* how = "AX VL20000 AC40000 MR1000000 GO") {
    ASSERT_TRUE(query(how));
    run(Seconds(1));
    ASSERT_NEAR(axis().speed.value, 20000, 1);
  }
  void expect_stays() {
    const Steps there = axis().position;
    run(Seconds(3));
    EXPECT_EQ(axis().position, there);
    EXPECT_EQ(axis().speed.value, 0);
  }
  bool is_lost() {
    operate(bench::Unplug(true));
    return run_until([this] { return now().link.state == LinkState::lost; }, Seconds(20));
  }
  bool comes_back() {
    operate(bench::Unplug(false));
    return run_until([this] { return now().link.state == LinkState::good; }, Seconds(20));
  }
};

// ---- a ring that is held

/// So the board takes no command, and none by which the console connects.
constexpr const char* waits_in_wq = "WT60000 WQ MR50000 GO";
constexpr const char* more_than_a_queue = "WT1 ";

TEST_F(Vme58Urgent, APendingStopIsMailedBeforeTheRingIsUsed) {
  for (const bool full : {false, true})
    for (const bool at_once : {false, true}) {
      turn();
      std::string text = full ? "" : waits_in_wq;
      for (int i = 0; full && i < 150; ++i) text += more_than_a_queue;
      (void)query(text);
      ASSERT_TRUE(is_lost());
      ASSERT_NE(axis().activity, Activity::idle);
      if (at_once)
        EXPECT_EQ(perform(intent::Abort()).state, IntentState::failed);
      else
        EXPECT_EQ(perform(intent::Stop()).state, IntentState::failed);
      (void)lines();
      operate(bench::Unplug(false));
      const std::string mail = at_once ? "> mailbox KL" : "> mailbox SA";
      std::vector<std::string> sent;
      ASSERT_TRUE(run_until(
          [&] {
            for (std::string& line : lines()) sent.push_back(std::move(line));
            return !sent.empty();
          },
          Seconds(1)));
      EXPECT_EQ(sent.front(), mail) << full;
      ASSERT_TRUE(run_until([this] { return now().link.state == LinkState::good; }, Seconds(3)));
      run(Seconds(1));
      expect_stays();
      EXPECT_EQ(query("AX RQ").value_or("no answer"), "200");
    }
}

TEST_F(Vme58Urgent, ATypedStopOpensABoardThatTakesNoCommand) {
  turn();
  (void)query(waits_in_wq);
  ASSERT_TRUE(is_lost());
  operate(bench::Unplug(false));
  ASSERT_TRUE(
      run_until([this] { return std::string(now().link.sentence.view()).find("WQ") != std::string::npos; },
                Seconds(10)))
      << now().link.sentence.view();
  ASSERT_NE(now().link.state, LinkState::good);
  session->send(intent::SendText("SA"));
  ASSERT_TRUE(run_until([this] { return now().link.state == LinkState::good; }, Seconds(3)));
  run(Seconds(1));
  expect_stays();
}

TEST_F(Vme58Urgent, AJogThatWasHeldWhenTheWireWentIsStoppedFirst) {
  ASSERT_TRUE(query("AX VL20000 AC40000"));
  session->send(intent::JogStart(AxisId{0}, Sign::plus));
  for (int i = 0; i < 5; ++i) {
    run(Millis(100));
    session->send(intent::JogKeepAlive());
  }
  ASSERT_TRUE(is_lost());
  (void)lines();
  ASSERT_TRUE(comes_back());
  EXPECT_EQ(lines().front(), "> mailbox SA");
  run(Seconds(1));
  expect_stays();
}

/// Another program has left its ring so.
class Vme58HeldFromTheStart : public Vme58Urgent {
 protected:
  void SetUp() override {
    opening_takes = Millis(1);
    open();
  }
  std::unique_ptr<Window> dressed(std::unique_ptr<Window> window) override {
    if (std::exchange(text_put_, true)) return window;
    std::uint32_t cell = 0;
    for (const char c : std::string("AX VL20000 AC40000 MR1000000 GO WQ MR50000 GO "))
      poke(2, static_cast<std::uint16_t>(vme58::at::output_buffer + 2 * cell++),
           static_cast<unsigned char>(c));
    poke(2, vme58::at::output_put_index, cell);
    return window;
  }

 private:
  bool text_put_ = false;
};

TEST_F(Vme58HeldFromTheStart, NothingOfTheRingActsBehindTheStop) {
  session->send(intent::SendText("SA"));  // before anything else
  ASSERT_TRUE(run_until([this] { return now().link.state == LinkState::good; }, Seconds(3)));
  EXPECT_EQ(lines().front(), "> mailbox SA");
  run(Seconds(1));
  expect_stays();
  EXPECT_LT(axis().position, Steps(10000)) << "MR50000 was not carried out";
}

TEST_F(Vme58HeldFromTheStart, AStopLaterOpensTheBoard) {
  ASSERT_TRUE(run_until([this] { return !now().link.sentence.empty(); }, Seconds(10)));
  EXPECT_THAT(std::string(now().link.sentence.view()), HasSubstr("waits in WQ"));
  (void)lines();
  session->send(intent::SendText("SA"));
  ASSERT_TRUE(run_until([this] { return now().link.state == LinkState::good; }, Seconds(3)));
  EXPECT_EQ(lines().front(), "> mailbox SA");
  run(Seconds(1));
  expect_stays();
}

// ---- a mailbox that is acknowledged and nothing comes of it

class Vme58DeafMailbox : public Vme58Urgent {
 protected:
  class Deaf final : public Window {
   public:
    explicit Deaf(std::unique_ptr<Window> window) : window_(std::move(window)) {}
    void listen(Listener* listener) override { window_->listen(listener); }
    [[nodiscard]] std::string describe() const override { return window_->describe(); }
    Task<Result<>> run(std::span<BusCycle> cycles) override {
      for (BusCycle& c : cycles)
        if (c.write && c.offset == vme58::reg::control) c.value &= ~vme58::control::interrupt_board;
      return window_->run(cycles);
    }

   private:
    std::unique_ptr<Window> window_;
  };
  std::unique_ptr<Window> dressed(std::unique_ptr<Window> window) override {
    return std::make_unique<Deaf>(std::move(window));
  }
};

TEST_F(Vme58DeafMailbox, AStopGoesThroughTheRingToo) {
  turn();
  (void)reported();
  (void)lines();
  session->send(intent::Stop());
  run(Millis(130));
  EXPECT_THAT(lines(), testing::IsSupersetOf({"> mailbox SA", "> SA"}));
  EXPECT_LT(axis().speed.value, 20000);
  EXPECT_THAT(reported(), HasSubstr("acknowledged a stop in its mailbox but did not act on it"));
  run(Seconds(1));
  expect_stays();
  EXPECT_EQ(axis().ended_by, EndedBy::stop);
  // From here on at once, and without words.
  turn("AX MR1000000 GO");
  session->send(intent::Stop());
  run(Millis(60));
  EXPECT_LT(axis().speed.value, 20000);
  EXPECT_EQ(reported(), "");
  run(Seconds(1));
  expect_stays();
}

TEST_F(Vme58DeafMailbox, ATypedStopIsWatchedToo) {
  turn();
  (void)reported();
  (void)lines();
  session->send(intent::SendText("SA"));
  run(Millis(130));
  EXPECT_THAT(lines(), testing::IsSupersetOf({"> mailbox SA", "> SA"}));
  EXPECT_LT(axis().speed.value, 20000);
  EXPECT_THAT(reported(), HasSubstr("acknowledged a stop in its mailbox but did not act on it"));
  run(Seconds(1));
  expect_stays();
}

// Between two motions an axis rests: a look at its speed alone takes that for the stop's doing.
TEST_F(Vme58DeafMailbox, AnAxisWaitingInItsQueueIsNotTakenForStopped) {
  for (const char* typed : {"", "SA"}) {
    ASSERT_TRUE(query("AX AC1000000 LS200 MR1 GO WT30 LE"));
    run(Millis(300));
    (void)lines();
    if (*typed)
      session->send(intent::SendText(typed));
    else
      session->send(intent::Stop());
    run(Millis(300));
    EXPECT_THAT(lines(), testing::Contains("> SA")) << typed;
    expect_stays();
  }
}

TEST_F(Vme58DeafMailbox, AnAbortGoesThroughTheRingToo) {
  turn();
  EXPECT_EQ(perform(intent::Abort()).state, IntentState::done);
  EXPECT_THAT(lines(), testing::IsSupersetOf({"> mailbox KL", "> KL"}));
  EXPECT_EQ(axis().speed.value, 0);
  EXPECT_EQ(axis().ended_by, EndedBy::abort);
  EXPECT_EQ(axis().trust.cause, Doubt::killed);
  const std::string words = reported();
  EXPECT_EQ(words.find("may have lost"), words.rfind("may have lost")) << "said once: " << words;
  expect_stays();
}

TEST_F(Vme58DeafMailbox, AStopOfAMoveThatEndsByItselfDoesNotClaimIt) {
  ASSERT_TRUE(query("AX VL20000 AC40000 MR20000 GO MR20000 GO MR-40000 GO"));
  run(Millis(200));
  EXPECT_EQ(perform(intent::Stop()).state, IntentState::done);
  expect_stays();
  EXPECT_LT(axis().position, Steps(20000)) << "none of the moves was carried out to its end";
}

TEST_F(Vme58DeafMailbox, AStopOfOneAxisThatAGroupMovesStaysOneOfAll) {
  turn("AA VL20000,20000; AC40000,40000; MR1000000,1000000; GO");
  EXPECT_EQ(perform(intent::Stop(0)).state, IntentState::done);
  EXPECT_EQ(axis(1).speed.value, 0);
  expect_stays();
  const std::string words = reported();
  EXPECT_EQ(words.find("so all axes were stopped"), words.rfind("so all axes were stopped")) << words;
}

TEST_F(Vme58DeafMailbox, WhereTheRingIsHeldTooItIsReported) {
  turn();
  (void)query(waits_in_wq);
  const IntentOutcome stopped = perform(intent::Stop(), Seconds(20));
  EXPECT_EQ(stopped.state, IntentState::failed);
  EXPECT_THAT(std::string(stopped.sentence.view()), HasSubstr("Stop was sent, but the board still moves"));
  EXPECT_THAT(std::string(stopped.sentence.view()), HasSubstr("Switch the power of the drives off"));
  run(Millis(50));
  EXPECT_EQ(axis().activity, Activity::moving) << "it is shown as it is";
  EXPECT_THAT(lines(), testing::IsSupersetOf({"> mailbox SA", "> mailbox KL"}));
}

// ---- ramps that show late

TEST_F(Vme58Urgent, AGentleRampIsNotTakenForAStopInVain) {
  for (const char* shape : {"PF", "PN10", "CN"}) {
    ASSERT_TRUE(query(std::string(shape) + " AX VL200 AC20 MR1000000 GO"));
    run(Seconds(40));
    ASSERT_NEAR(axis().speed.value, 200, 1) << shape;
    (void)lines();
    EXPECT_EQ(perform(intent::Stop(), Seconds(60)).state, IntentState::done) << shape;
    const auto sent = lines();
    EXPECT_EQ(std::count(sent.begin(), sent.end(), "> mailbox SA"), 1) << shape;
    EXPECT_EQ(axis().ended_by, EndedBy::stop) << shape;
    run(Seconds(1));  // for its last count
    expect_stays();
  }
  EXPECT_EQ(reported(), "");
}

TEST_F(Vme58Urgent, TheLeastOfAGroupMaySlowDownLate) {
  ASSERT_TRUE(query("AA VL20000,20000; AC10000,10000; AM"));
  ASSERT_EQ(perform(intent::MoveBy({{AxisId{0}, Steps(1000000)}, {AxisId{1}, Steps(100)}})).state,
            IntentState::done);
  run(Seconds(4));
  (void)lines();
  EXPECT_EQ(perform(intent::Stop(), Seconds(20)).state, IntentState::done);
  const auto sent = lines();
  EXPECT_EQ(std::count(sent.begin(), sent.end(), "> mailbox SA"), 1);
}

}  // namespace
}  // namespace hw
