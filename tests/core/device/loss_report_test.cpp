#include "core/device/loss_report.h"

#include <gtest/gtest.h>

#include "core/devices/vme58/catalog.h"

namespace hw {
namespace {

struct LossReportTest : testing::Test {
  LossReportTest() {
    known.axis_count = static_cast<int>(catalog.axes.size());
    read_at(1);
  }
  static Instant at(int s) { return Instant(std::chrono::seconds(s)); }
  void read_at(int s) {
    for (AxisState& axis : known.axes) axis.position_known = true, axis.seen_at = at(s);
  }
  std::string back() { return report.back(catalog, known, false, at(6)); }

  Catalog catalog = vme58::make_catalog({{"variant", "4"}}).value();
  Snapshot known;
  LossReport report;
};

TEST_F(LossReportTest, ACommandOnItsWayIsReportedByWhereTheAxesStand) {
  report.lost(known, false, true, at(2));
  read_at(5);
  known.axes[1].position = Steps(400);
  EXPECT_EQ(back(),
            "The connection was lost for 4.0 s while a command was on its way. The controller is at rest; "
            "step axis Y stands at 400 counts. Nothing was sent again.");
  EXPECT_EQ(back(), "") << "once";
}

TEST_F(LossReportTest, OneThatWasNotCarriedOutShowsInThatNothingMoved) {
  report.lost(known, false, true, at(2));
  EXPECT_EQ(back(), "") << "the positions are those of before";
  read_at(5);
  EXPECT_NE(back().find("every axis is where it was"), std::string::npos);
}

TEST_F(LossReportTest, AtRestNothingIsReportedAndNothingOfWhatARestartEnded) {
  report.lost(known, false, false, at(2));
  read_at(5);
  EXPECT_EQ(back(), "");
  report.lost(known, true, false, at(5));
  read_at(6);
  ++known.restarts;
  EXPECT_EQ(back(), "");
}

}  // namespace
}  // namespace hw
