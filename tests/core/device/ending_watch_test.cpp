// Who is said to have ended a drawing.
#include "core/device/ending_watch.h"

#include <gtest/gtest.h>

#include "core/device/registry.h"
#include "core/device/stop.h"

namespace hw {
namespace {

struct EndingOfADrawing : testing::Test {
  EndingOfADrawing() {
    now.link.state = LinkState::good;
    now.pieces.running = true, now.pieces.total = 5;
    watch.look(now);
  }
  void stopped_by(StoppedBy by) {
    StopOrder order;
    order.by = by;
    watch.stop_asked(order, now, Instant{});
  }
  Ending ended() {
    now.pieces.running = false, now.pieces.done = 2;
    watch.look(now);
    return reported;
  }
  const Catalog catalog = *find_device_type("vxm")->make_catalog({});
  Snapshot now;
  Ending reported;
  EndingWatch watch{catalog, [this](const Ending& ending) { reported = ending; }};
};

TEST_F(EndingOfADrawing, NamesNoCauseAfterARefusedPiece) {
  stopped_by(StoppedBy::unknown);
  EXPECT_EQ(ended().by, EndedBy::elsewhere) << "it was cut short";
  EXPECT_EQ(reported.what, Ending::What::pieces);
  EXPECT_EQ(reported.stopped_by, StoppedBy::unknown);
}

TEST_F(EndingOfADrawing, RemainsTheUsersWhoStoppedItFirst) {
  stopped_by(StoppedBy::key);
  stopped_by(StoppedBy::unknown);
  EXPECT_EQ(ended().by, EndedBy::stop);
  EXPECT_EQ(reported.stopped_by, StoppedBy::key);
}

struct EndingOfAMotion : testing::Test {
  void look(double at, Activity activity, EndedBy by = EndedBy::nothing) {
    now.at = now.axes[0].seen_at = Instant(from_seconds(at));
    now.axes[0].activity = activity;
    now.axes[0].ended_by = by;
    watch.look(now);
  }
  void program(bool runs) {
    now.program.owned = true;
    now.program.run = runs ? RunState::running : RunState::idle;
    now.program.ended_by = runs ? EndedBy::nothing : EndedBy::target;
  }
  EndingOfAMotion() {
    now.axis_count = 1;
    now.link.state = LinkState::good;
  }
  const Catalog catalog = *find_device_type("vxm")->make_catalog({});
  Snapshot now;
  std::vector<Ending> all;
  EndingWatch watch{catalog, [this](const Ending& ending) { all.push_back(ending); }};
};

TEST_F(EndingOfAMotion, OfAProgramDoesNotLastIntoTheNextOne) {
  program(true);
  look(1, Activity::moving);
  program(false);
  look(2, Activity::idle);
  look(2.5, Activity::idle);
  program(true);
  look(4, Activity::moving);
  look(5, Activity::idle, EndedBy::stop);
  ASSERT_EQ(all.size(), 2u);
  EXPECT_EQ(all[0].what, Ending::What::program);
  EXPECT_EQ(all[1].what, Ending::What::motion);
  EXPECT_EQ(all[1].began, Instant(from_seconds(4)));
  EXPECT_TRUE(all[1].of_run);
}

TEST_F(EndingOfAMotion, IsReportedAlsoWhereTheControllerNeverReportsHow) {
  look(1, Activity::moving);
  look(2, Activity::idle);
  look(3, Activity::idle);
  EXPECT_TRUE(all.empty()) << "it may tell yet";
  look(4.5, Activity::idle);
  ASSERT_EQ(all.size(), 1u);
  EXPECT_EQ(all[0].by, EndedBy::nothing);
}

TEST_F(EndingOfAMotion, IsOneWithTheWayBackThatFollowsAtOnce) {
  look(1, Activity::moving);
  look(2, Activity::idle);
  look(2.2, Activity::moving);
  look(3, Activity::idle, EndedBy::target);
  ASSERT_EQ(all.size(), 1u);
  EXPECT_EQ(all[0].began, Instant(from_seconds(1)));
}

TEST_F(EndingOfAMotion, IsNotOverBecauseNoReadingHasCome) {
  look(1, Activity::moving);
  look(2, Activity::idle);
  now.at = Instant(from_seconds(9));
  watch.look(now);
  EXPECT_TRUE(all.empty()) << "it has been seen at rest only once";
  look(9.5, Activity::idle, EndedBy::target);
  ASSERT_EQ(all.size(), 1u);
  EXPECT_EQ(all[0].by, EndedBy::target);
}

TEST_F(EndingOfAMotion, IsWaitedForAnewBehindASilence) {
  look(1, Activity::moving);
  look(2, Activity::idle);
  look(2.5, Activity::unknown);
  look(9, Activity::idle);
  EXPECT_TRUE(all.empty()) << "it may tell yet";
  look(11.5, Activity::idle);
  ASSERT_EQ(all.size(), 1u);
  EXPECT_EQ(all[0].by, EndedBy::nothing);
}

}  // namespace
}  // namespace hw
