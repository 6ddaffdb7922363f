#include "core/device/transfer_progress.h"

#include <gtest/gtest.h>

namespace hw {
namespace {

using Phase = TransferState::Phase;

struct TransferProgressTest : testing::Test {
  void work(int times) {
    for (; times > 0; --times) {
      now += Millis(100);
      progress.worked(now);
      progress.line_done();
    }
  }
  Catalog catalog;
  TransferState shown;
  TransferProgress progress{shown, catalog};
  Instant now{};
};

TEST_F(TransferProgressTest, TheTimeThatIsLeftIsNotKnownAtOnce) {
  progress.begin(0, now);
  progress.enter(Phase::writing, 100);
  progress.expect(200);
  work(3);
  EXPECT_EQ(shown.done, 3);
  EXPECT_EQ(shown.left, Duration{});
  work(17);
  EXPECT_EQ(shown.left, Millis(100) * 180) << "by the rate so far, with what is to come behind the writing";
}

TEST_F(TransferProgressTest, WithoutATotalNoTimeIsReported) {
  progress.begin(0, now);
  progress.enter(Phase::reading, 0);
  work(50);
  EXPECT_EQ(shown.done, 50);
  EXPECT_EQ(shown.left, Duration{});
}

TEST_F(TransferProgressTest, WrittenLinesStayKnownWhenATransferIsBrokenOff) {
  progress.begin(0, now);
  progress.enter(Phase::writing, 302);
  EXPECT_EQ(report_written(shown), "at most the first of its 302 lines is written");
  work(41);
  progress.end();
  EXPECT_FALSE(shown.running);
  EXPECT_EQ(report_written(shown), "the first 41 of its 302 lines are written");
  progress.begin(0, now);
  progress.enter(Phase::writing, 302);
  work(1);
  EXPECT_EQ(report_written(shown), "the first of its 302 lines is written");
  progress.begin(0, now);
  progress.enter(Phase::writing, 1);
  EXPECT_EQ(report_written(shown), "its line may be written");
  work(1);
  EXPECT_EQ(report_written(shown), "its line is written, and was not compared");
  progress.begin(0, now);
  progress.enter(Phase::comparing, 300);
  EXPECT_EQ(report_written(shown), "all of its lines are written, and 0 of 300 were compared");
  progress.begin(0, now);
  progress.enter(Phase::reading, 300);
  EXPECT_EQ(report_written(shown), "");
}

}  // namespace
}  // namespace hw
