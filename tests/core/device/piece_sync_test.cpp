// Those who do their pieces together: nobody is ahead, nobody is left behind.
#include "core/device/piece_sync.h"

#include <gtest/gtest.h>

#include "core/time/virtual_scheduler.h"

namespace hw {
namespace {

struct PieceSyncTest : ::testing::Test {
  IoContext io;
  VirtualScheduler time{io};
  Event wake{time};
  std::vector<std::shared_ptr<PieceSeat>> seats = PieceSync::seats(2);
  PieceSeat &first = *seats[0], &second = *seats[1];
  void both_begin(std::size_t act) {
    EXPECT_FALSE(first.may_begin(act));
    EXPECT_TRUE(second.may_begin(act));
    EXPECT_TRUE(first.may_begin(act));
  }
  void both_take_part() {
    first.take(wake), second.take(wake);
    first.has_done(0), second.has_done(0);
  }
};

TEST_F(PieceSyncTest, NoneBeginsBeforeAllAreThere) {
  first.take(wake);
  first.has_done(0);
  EXPECT_FALSE(first.may_begin(0));
  second.take(wake);
  second.has_done(0);
  EXPECT_FALSE(first.may_begin(0)) << "it stands before the first act too, and is still in a round";
  EXPECT_TRUE(second.may_begin(0));
  EXPECT_TRUE(first.may_begin(0));
}

TEST_F(PieceSyncTest, AnActBeginsWhenAllHaveEndedTheOneBefore) {
  both_take_part();
  both_begin(0);
  first.has_done(1);
  EXPECT_FALSE(first.may_begin(1));
  EXPECT_FALSE(first.waits_ready()) << "the other one is under way, and may be for long";
  second.has_done(1);
  both_begin(1);
}

TEST_F(PieceSyncTest, OneAsksNothingWhileTheOthersEndTheirRound) {
  both_take_part();
  EXPECT_FALSE(first.may_begin(0));
  EXPECT_TRUE(first.waits_ready());
  EXPECT_FALSE(second.waits_ready());
  EXPECT_TRUE(second.may_begin(0));
  EXPECT_FALSE(first.waits_ready());
  EXPECT_TRUE(first.may_begin(0));
}

TEST_F(PieceSyncTest, AHoldLetsTheRoundsGoOn) {
  both_take_part();
  EXPECT_FALSE(first.may_begin(0));
  second.hold();
  EXPECT_FALSE(first.waits_ready());
  first.go_on(), second.go_on();
  EXPECT_FALSE(second.may_begin(0)) << "the first one is in a round";
  EXPECT_TRUE(first.may_begin(0));
}

TEST_F(PieceSyncTest, AControllerThatHasLeftIsNotWaitedFor) {
  both_take_part();
  EXPECT_FALSE(first.may_begin(0));
  second.leave();
  EXPECT_FALSE(first.waits_ready());
}

TEST_F(PieceSyncTest, AHoldLetsAnActThatOneHasBegunBeDoneByAll) {
  both_take_part();
  EXPECT_FALSE(first.may_begin(0));
  EXPECT_TRUE(second.may_begin(0));
  second.hold();
  EXPECT_TRUE(first.is_held());
  EXPECT_FALSE(first.rests());
  EXPECT_TRUE(first.may_begin(0)) << "the other is on its way";
  first.has_done(1), second.has_done(1);
  EXPECT_FALSE(first.may_begin(1));
  EXPECT_TRUE(first.rests());
}

TEST_F(PieceSyncTest, AllHaveToGoOn) {
  both_take_part();
  first.hold();
  second.go_on();
  EXPECT_FALSE(second.may_begin(0)) << "the first one still has its tool off";
  first.go_on();
  EXPECT_FALSE(second.may_begin(0));
  EXPECT_TRUE(first.may_begin(0));
}

TEST_F(PieceSyncTest, AControllerThatLeavesEndsTheRunForAll) {
  both_take_part();
  second.leave();
  EXPECT_TRUE(first.has_ended());
  EXPECT_FALSE(first.may_begin(0));
}

TEST_F(PieceSyncTest, ASeatThatIsNotTakenEndsAll) {
  first.take(wake);
  seats[1].reset();
  EXPECT_TRUE(first.has_ended());
}

TEST_F(PieceSyncTest, OneThatHasFinishedLetsTheOthersEnd) {
  both_take_part();
  both_begin(0);
  first.has_done(1);
  first.finish();
  first.leave();
  EXPECT_FALSE(second.has_ended());
  EXPECT_TRUE(second.may_begin(0));
}

}  // namespace
}  // namespace hw
