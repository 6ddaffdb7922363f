// A stop at every moment of a procedure: what it has ended is shown as stopped, and nothing begins behind it.
#include "tests/core/devices/arcus/driver_fixture.h"

namespace hw::arcus {
namespace {

using testing::HasSubstr;

class StopAtAnyTime : public DriverTest {
 protected:
  static constexpr const char* pmx = "pmx-4ex-sa";
  static constexpr const char* dmx = "dmx-k-sa";
  /// True when it was stopped after its command had gone out.
  bool stopped_after(IntentBody body, int ms) {
    const IntentId id = post(std::move(body));
    run(ms / 1000.0);
    EXPECT_EQ(perform(intent::Stop()), "") << ms;
    EXPECT_TRUE(wait_idle()) << ms;
    return outcome(id) == IntentState::done;
  }
};

TEST_F(StopAtAnyTime, AHomingThatWasStoppedLiftsNoDoubt) {
  start(dmx, {}, true);
  ASSERT_EQ(perform(intent::MoveTo(targets({500}))), "");
  ASSERT_TRUE(wait_idle());
  ASSERT_TRUE(loop->operate(bench::PowerCycle()));
  run(25);
  ASSERT_TRUE(latest.axes[0].trust.doubtful());
  int stopped = 0;
  for (int ms = 2; ms < 260; ms += 4) {
    stopped += stopped_after(intent::Home(AxisId{0}, Sign::plus, 0), ms) ? 1 : 0;
    ASSERT_TRUE(latest.axes[0].trust.doubtful()) << ms;
  }
  EXPECT_GT(stopped, 5);
}

TEST_F(StopAtAnyTime, AListOfMovesBehindAFullBufferDoesNotBegin) {
  start(pmx, {}, true);
  for (int ms = 20; ms < 420; ms += 5) {
    ASSERT_EQ(query("BO"), "OK");
    for (int i = 0; query("I" + std::to_string(900000 + i) + ":0:0:500") == "OK"; ++i) ASSERT_LT(i, 60);
    post(intent::FeedMoves({{77777, 0, 0, 1000}, {-500, 0, 0, 1000}}));
    run(ms / 1000.0);
    EXPECT_EQ(perform(intent::Stop()), "") << ms;
    run(0.5);
    EXPECT_FALSE(latest.feed.running) << ms;
    ASSERT_FALSE(latest.any_axis_moving()) << ms;
  }
}

TEST_F(StopAtAnyTime, AStoreThatItCutsShortNamesNoWaitingTime) {
  start(dmx);
  loop->lose(9);
  const IntentId id = post(intent::Store());
  run(0.05);
  EXPECT_EQ(perform(intent::Stop()), "");
  run(4);
  const IntentOutcome* store = pump->known().outcome_of(id);
  ASSERT_TRUE(store);
  EXPECT_THAT(std::string(store->sentence.view()), HasSubstr("did not confirm in time that it has stored"));
}

// ---- a speed for one motion

TEST_F(StopAtAnyTime, TheUsersSpeedIsBackWhenTheConsoleIsClosed) {
  start(pmx, {}, true);
  for (int ms = 2; ms < 240; ms += 4) {
    post(intent::JogStart(AxisId{0}, Sign::plus, Pps{5000}, false));
    run(ms / 1000.0);
    asio::co_spawn(io, pump->shut_down(), asio::detached);
    run(4);
    pump.reset();
    latest = Snapshot();
    open();
    EXPECT_EQ(query("HS"), "1000") << ms;
    ASSERT_TRUE(wait_idle());
  }
}

TEST_F(StopAtAnyTime, ASpeedThatCannotBePutBackIsNamedWhenTheConsoleIsClosed) {
  start(pmx, {}, true);
  post(intent::MoveTo(targets({400000}), Pps{5000}));
  const auto out = [&] { return loop->to_controller.find("HS=5000") != std::string::npos; };
  ASSERT_TRUE(run_until(out, 2));
  run(0.01);
  EXPECT_THAT(pump->leaves_behind(), HasSubstr("Set HS=1000 before the next motion: HS is still 5000"));
  asio::co_spawn(io, pump->shut_down(), asio::detached);
  const Instant closed = time.now();
  ASSERT_TRUE(run_until([&] { return latest.link.state == LinkState::closed; }, 12));
  EXPECT_LT(seconds(time.now() - closed), 1) << "it does not wait for the end of the move";
  pump.reset();
  latest = Snapshot();
  open();
  EXPECT_EQ(query("HS"), "1000");
  EXPECT_TRUE(latest.any_axis_moving());
  EXPECT_EQ(perform(intent::Stop()), "");
}

}  // namespace
}  // namespace hw::arcus
