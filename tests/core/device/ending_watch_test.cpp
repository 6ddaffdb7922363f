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
  void stopped_by(StoppedBy who) {
    StopOrder order;
    order.by = who;
    watch.stop_asked(order, now, Instant{});
  }
  Ending ended() {
    now.pieces.running = false, now.pieces.done = 2;
    watch.look(now);
    return told;
  }
  const Catalog catalog = *find_device_type("vxm")->make_catalog({});
  Snapshot now;
  Ending told;
  EndingWatch watch{catalog, [this](const Ending& ending) { told = ending; }};
};

TEST_F(EndingOfADrawing, IsNobodysBehindAPieceThatWasRefused) {
  stopped_by(StoppedBy::nobody);
  EXPECT_EQ(ended().by, EndedBy::elsewhere) << "it was cut short";
  EXPECT_EQ(told.what, Ending::What::pieces);
  EXPECT_EQ(told.who, StoppedBy::nobody);
}

TEST_F(EndingOfADrawing, RemainsTheUsersWhoStoppedItFirst) {
  stopped_by(StoppedBy::key);
  stopped_by(StoppedBy::nobody);
  EXPECT_EQ(ended().by, EndedBy::stop);
  EXPECT_EQ(told.who, StoppedBy::key);
}

}  // namespace
}  // namespace hw
