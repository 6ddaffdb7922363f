// What is told of a drawing on a bus beforehand is what its controllers do then.
#include "core/session/rehearse_together.h"

#include <cmath>

#include <gtest/gtest.h>

#include "core/device/track_path.h"
#include "core/session/session_group.h"
#include "core/session/track_together.h"
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
    send_text("SL=0");  // else DO1 shows whether they are in position
    send_text("EO=1");
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
  void send_text(const std::string& text) {
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
  EXPECT_NEAR(rehearsed->duration_s, took, 0.02 * took) << "rounds of status fall elsewhere";
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

TEST_F(BusAtWork, ALongRehearsalIsReportedAsFarAsItCame) {
  const auto seen = rehearse_together(two_chains(), address, states(), opener, std::chrono::seconds(4));
  ASSERT_TRUE(seen) << seen.error().sentence();
  EXPECT_FALSE(seen->finished);
  EXPECT_NEAR(seen->duration_s, 4, 0.5);
  EXPECT_NEAR(seen->track.back().t, 4, 0.5);
  EXPECT_LT(seen->piece_seconds.size(), 2u);
}

TEST_F(BusAtWork, GoesTheWayThatWasRehearsed) {
  seq::Sequence drawing = two_chains();
  drawing.steps.insert(drawing.steps.begin() + 2, to(5, 5));  // from elsewhere
  const auto rehearsed = rehearse_together(drawing, address, states(), opener, an_hour);
  ASSERT_TRUE(rehearsed) << rehearsed.error().sentence();
  TrackTogether::Benches benches;
  for (const auto& member : group->members()) benches.push_back(member->bench());
  TrackTogether live(time, benches, 0);
  (void)draw(drawing);
  const TrackAxes axes{{0, 1}, {1, 1}};
  const auto way_of = [&axes](std::vector<RehearsedPlace> track) {
    Rehearsal one;
    one.track = std::move(track);
    return track_path(one, axes, 0, {});
  };
  const drawing::ToolPath meant = way_of(rehearsed->track), gone = way_of(live.take());
  EXPECT_NEAR(meant.way_on, gone.way_on, 0.005 * gone.way_on);
  ASSERT_GT(gone.points.size(), 100u);
  const drawing::PathView in_steps(gone.bounds, 1000, 1000, true);
  for (const drawing::Point3& p : gone.points) {
    const auto near = nearest(meant, in_steps, in_steps.to_px(p), 200);
    ASSERT_TRUE(near);
    EXPECT_LE(drawing::length(near->at - p), 40) << p.x << ", " << p.y << ": rounds of status fall otherwise";
  }
  EXPECT_EQ(rehearsed->axes[1].name, "02");
  EXPECT_EQ(rehearsed->axes[0].begin, 0);
  EXPECT_EQ(rehearsed->events.back().command, static_cast<int>(drawing.steps.size()) - 1);
}

TEST_F(BusAtWork, ALineIsNotStraightWhereTheyHaveTheSameStartAndOtherSpeeds) {
  seq::Sequence line;
  line.axes = {{"01", 100}, {"02", 100}};
  line.steps = {{seq::Speed{{10, 4, 500}}}, {seq::Pen{true}}, to(20, 10), {seq::Pen{false}}};
  const auto rehearsed = rehearse_together(line, address, states(), opener, an_hour);
  ASSERT_TRUE(rehearsed) << rehearsed.error().sentence();
  double beside = 0;
  for (const RehearsedPlace& place : rehearsed->track)
    beside = std::max(
        beside, std::fabs(static_cast<double>(place.position[0] - 2 * place.position[1])) / std::sqrt(5.0));
  EXPECT_GT(beside, 3) << "steps";
  EXPECT_EQ(rehearsed->track.back().position[0], 2000);
  EXPECT_EQ(rehearsed->track.back().position[1], 1000);
}

TEST_F(BusAtWork, ReportsWhyItDoesNotComeToItsEnd) {
  const auto from_the_factory = rehearse_together(two_chains(), address, {}, opener, an_hour);
  ASSERT_FALSE(from_the_factory);
  EXPECT_NE(from_the_factory.error().sentence().find("DO1 stays on"), std::string::npos)
      << from_the_factory.error().sentence();
}

/// Chains of short lines, more than the memory of a VXM holds and than a PMX stores.
seq::Sequence many_chains(const Catalog& catalog, int chains, int lines) {
  seq::Sequence drawing;
  drawing.axes = {{catalog.axes[0].name, 100}, {catalog.axes[1].name, 100}};
  drawing.tolerance = 0.05;
  const int output = catalog.output_number(catalog.outputs.size() - 1);
  drawing.pen_down = {{seq::Output{output, true}}};
  drawing.pen_up = {{seq::Output{output, false}}};
  drawing.steps = {{seq::Pen{false}}, {seq::Speed{{10, 0, 100}}}};
  for (int c = 0; c < chains; ++c) {
    drawing.steps.push_back(to(c, 0));
    drawing.steps.push_back({seq::WaitMotion{}});
    drawing.steps.push_back({seq::Pen{true}});
    for (int n = 0; n < lines; ++n) {
      drawing.steps.push_back(n % 2 == 0 ? to(c, 0.5 * (n + 1)) : to(c + 0.4, 0.5 * n));
      drawing.steps.push_back({seq::WaitMotion{}});
    }
    drawing.steps.push_back({seq::Pen{false}});
  }
  return drawing;
}

class InPieces : public testing::TestWithParam<const char*> {
 protected:
  InPieces() {
    group = *SessionGroup::open(time, address, opener, [] {});
    done([](std::shared_ptr<SessionGroup> g) { return g->wait_until_connected(); });
    time.run_for(std::chrono::seconds(5));
    for (int axis = 0; axis < session().known().axis_count; ++axis)
      if (session().catalog().axes[static_cast<std::size_t>(axis)].switchable)
        session().send(intent::SetPower(axis, true));
    time.run_for(std::chrono::seconds(5));
  }
  ~InPieces() override {
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
  [[nodiscard]] Session& session() { return *group->members().front(); }
  std::shared_ptr<const Pieces> pieces_of(const seq::Sequence& drawing) {
    auto pieces = session().type().language().in_pieces(drawing, session().catalog());
    EXPECT_TRUE(pieces) << pieces.error().sentence();
    return pieces ? std::make_shared<const Pieces>(std::move(*pieces)) : nullptr;
  }
  Result<RehearsedPieces> rehearsed(std::shared_ptr<const Pieces> pieces, Duration at_most) {
    return rehearse_pieces(std::move(pieces), address, {session().known(), {}}, opener, at_most);
  }

  const WireOpener opener = make_wire_opener();
  const Address address = *Address::parse(std::string(GetParam()) + "@emulator,wire=real");
  IoContext io{1};
  VirtualScheduler time{io};
  std::shared_ptr<SessionGroup> group;
};
INSTANTIATE_TEST_SUITE_P(Each, InPieces, testing::Values("vxm", "pmx-4ex-sa"),
                         [](const auto& info) { return std::string(info.param).substr(0, 3); });

TEST_P(InPieces, TheRunTakesTheTimesThatWereRehearsed) {
  const bool stores_little = session().catalog().program.capacity < 1000;
  const auto pieces = pieces_of(many_chains(session().catalog(), stores_little ? 12 : 40, 36));
  ASSERT_TRUE(pieces);
  ASSERT_GT(pieces->all.size(), 1u);
  const auto seen = rehearsed(pieces, an_hour);
  ASSERT_TRUE(seen) << seen.error().sentence();
  ASSERT_TRUE(seen->finished);
  EXPECT_EQ(seen->messages.find("Local mode"), std::string::npos) << "of the opening: " << seen->messages;
  session().send(intent::RunInPieces(pieces));
  std::vector<RehearsedPieces::Arrival> came_to;
  const Instant began = time.now();
  ASSERT_TRUE(time.run_until(began + std::chrono::hours(1), [&] {
    const PiecesState& now = session().known().pieces;
    if (now.running && now.step > (came_to.empty() ? -1 : came_to.back().step))
      came_to.push_back({now.step, seconds(time.now() - began)});
    return !now.running && !came_to.empty();
  }));
  const double took = seconds(time.now() - began);
  EXPECT_EQ(session().known().pieces.done, session().known().pieces.total);
  EXPECT_NEAR(seen->duration_s, took, 0.02 * took);
  ASSERT_GT(came_to.size(), 5u);
  for (const auto& [step, t] : came_to) EXPECT_NEAR(seen->when(step), t, 0.02 * took + 1) << step;
}

TEST_P(InPieces, ALongRehearsalIsReportedAsFarAsItCame) {
  const auto pieces = pieces_of(many_chains(session().catalog(), 40, 36));
  ASSERT_TRUE(pieces);
  const auto seen = rehearsed(pieces, std::chrono::seconds(20));
  ASSERT_TRUE(seen) << seen.error().sentence();
  EXPECT_FALSE(seen->finished);
  ASSERT_FALSE(seen->came_to.empty());
  EXPECT_GT(seen->came_to.back().step, 0);
  EXPECT_LE(seen->came_to.back().t, 21);
}

TEST_P(InPieces, LinesThatCannotBeSentInTimeAreReportedBeforehand) {
  if (session().catalog().move_list.columns.empty()) GTEST_SKIP() << "it stores all that it draws";
  seq::Sequence drawing = many_chains(session().catalog(), 40, 36);
  drawing.steps[1] = {seq::Speed{{5, 0, 100}}};
  const auto leisurely = rehearsed(pieces_of(drawing), an_hour);
  ASSERT_TRUE(leisurely);
  EXPECT_EQ(leisurely->messages.find("slower"), std::string::npos) << leisurely->messages;
  drawing.steps[1] = {seq::Speed{{100, 0, 100}}};
  const auto hasty = rehearsed(pieces_of(drawing), an_hour);
  ASSERT_TRUE(hasty);
  EXPECT_NE(hasty->messages.find("Short lines are drawn more slowly than set"), std::string::npos)
      << hasty->messages;
}

TEST(RehearsedInPieces, TheTimeBetweenTwoStepsThatWereReportedIsShared) {
  RehearsedPieces seen;
  seen.came_to = {{0, 1}, {10, 3}};
  EXPECT_DOUBLE_EQ(seen.when(0), 1);
  EXPECT_DOUBLE_EQ(seen.when(5), 2);
  EXPECT_DOUBLE_EQ(seen.when(10), 3);
  EXPECT_DOUBLE_EQ(seen.when(20), 3);
}

}  // namespace
}  // namespace hw
