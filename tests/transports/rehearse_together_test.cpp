// What is told of a drawing on a bus beforehand is what its controllers do then.
#include "core/session/rehearse_together.h"

#include <gtest/gtest.h>

#include "core/session/session_group.h"
#include "core/time/virtual_scheduler.h"
#include "transports/open.h"

namespace hw {
namespace {

namespace seq = sequence;

seq::Step to(double x, double y) {
  seq::Move move;
  move.to[0] = x, move.to[1] = y;
  return {move};
}

seq::Sequence two_chains() {
  seq::Sequence drawing;
  drawing.axes = {{"01", 100}, {"02", 100}};
  drawing.pen_down = {{seq::Output{1, true}}};
  drawing.pen_up = {{seq::Output{1, false}}};
  drawing.steps = {{seq::Pen{false}}, {seq::Speed{{10, 1, 100}}}};
  for (const double x : {10.0, 30.0}) {
    drawing.steps.push_back(to(x, 0));
    drawing.steps.push_back({seq::Pen{true}});
    drawing.steps.push_back(to(x + 15, 5));
    drawing.steps.push_back(to(x, 10));
    drawing.steps.push_back({seq::Pen{false}});
  }
  return drawing;
}

/// Two controllers, as somebody has left them.
class BusAtWork : public testing::Test {
 protected:
  BusAtWork() {
    group = *SessionGroup::open(time, address, opener, [] {});
    done([](std::shared_ptr<SessionGroup> g) { return g->wait_until_connected(); });
    say("SL=0");  // else DO1 shows whether they are in position
    say("EO=1");
  }
  ~BusAtWork() override {
    asio::co_spawn(time.executor(), group->close(), asio::detached);
    time.run_for(std::chrono::seconds(5));
  }
  template <class Work>
  void done(Work work) {
    std::optional<Result<>> result;
    asio::co_spawn(time.executor(), work(group),
                   [&result](std::exception_ptr, Result<> r) { result = std::move(r); });
    time.run_until(time.now() + std::chrono::minutes(5), [&result] { return result.has_value(); });
    ASSERT_TRUE(result.has_value());
    ASSERT_TRUE(*result) << result->error().sentence();
  }
  void say(const std::string& text) {
    for (const auto& member : group->members()) member->send_text(text, false);
    time.run_for(std::chrono::seconds(5));
  }
  std::vector<ControllerState> states() {
    std::vector<ControllerState> all;
    for (const auto& member : group->members()) all.push_back({member->known(), {}});
    return all;
  }
  /// How long the controllers take.
  double draw(const seq::Sequence& drawing) {
    done([&](std::shared_ptr<SessionGroup> g) { return g->run_together(drawing, 0); });
    const Instant began = time.now();
    time.run_until(began + std::chrono::minutes(5), [this] {
      return !group->members()[0]->known().pieces.running && !group->members()[1]->known().pieces.running;
    });
    return seconds(time.now() - began);
  }

  const WireOpener opener = make_wire_opener();
  const Address address = *Address::parse("dmx-k-sa@emulator,id=01-02,wire=real");
  IoContext io{1};
  VirtualScheduler time{io};
  std::shared_ptr<SessionGroup> group;
};

constexpr Duration an_hour = std::chrono::hours(1);

TEST_F(BusAtWork, TakesAsLongAsWasRehearsed) {
  const auto rehearsed = rehearse_together(two_chains(), address, states(), opener, an_hour);
  ASSERT_TRUE(rehearsed) << rehearsed.error().sentence();
  const double took = draw(two_chains());
  EXPECT_NEAR(rehearsed->duration_s, took, 0.01 * took);
  ASSERT_EQ(rehearsed->piece_seconds.size(), 2u);
  EXPECT_NEAR(rehearsed->piece_seconds[0] + rehearsed->piece_seconds[1], took, 0.02 * took);
}

TEST_F(BusAtWork, IsRehearsedFromWhereItStands) {
  const auto from_zero = rehearse_together(two_chains(), address, states(), opener, an_hour);
  (void)draw(two_chains());
  seq::Sequence away = two_chains();
  away.steps = {{seq::Speed{{10, 1, 100}}}, to(200, 0)};
  (void)draw(away);
  const auto from_there = rehearse_together(two_chains(), address, states(), opener, an_hour);
  ASSERT_TRUE(from_zero && from_there);
  EXPECT_GT(from_there->duration_s, from_zero->duration_s + 15) << "190 mm of way at 10 mm/s";
  EXPECT_NEAR(from_there->duration_s, draw(two_chains()), 0.01 * from_there->duration_s);
}

TEST_F(BusAtWork, SaysWhyItDoesNotComeToItsEnd) {
  const auto in_time = rehearse_together(two_chains(), address, states(), opener, std::chrono::seconds(2));
  ASSERT_FALSE(in_time);
  EXPECT_NE(in_time.error().sentence().find("still not idle"), std::string::npos);
  const auto from_the_factory = rehearse_together(two_chains(), address, {}, opener, an_hour);
  ASSERT_FALSE(from_the_factory);
  EXPECT_NE(from_the_factory.error().sentence().find("DO1 stays on"), std::string::npos)
      << from_the_factory.error().sentence();
}

}  // namespace
}  // namespace hw
