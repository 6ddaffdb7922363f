// What was begun through a session, and what somebody else began.
#include "core/session/begun_here.h"

#include <gtest/gtest.h>

namespace hw {
namespace {

struct BegunHereTest : testing::Test {
  Catalog catalog;
  Snapshot now;
  std::uint64_t rounds = 10;

  BegunHereTest() {
    catalog.axes.push_back({"X", "axis X"});
    CommandInfo position;
    position.form = "PX", position.help = "where axis X is";
    catalog.commands.push_back(position);
    now.axis_count = 1;
  }
  void round(BegunHere& begun, Activity activity, bool busy = false) {
    now.axes[0].activity = activity;
    begun.seen(now, busy, ++rounds);
  }
};

TEST_F(BegunHereTest, AMoveIsUntilItHasBeenSeenAtRest) {
  BegunHere begun(catalog);
  EXPECT_FALSE(begun.any());
  begun.posted(intent::MoveBy({{AxisId{0}, Steps(400)}}));
  round(begun, Activity::idle, true);
  EXPECT_TRUE(begun.any()) << "it waits to be sent";
  round(begun, Activity::idle);
  EXPECT_TRUE(begun.any()) << "the round may have begun before";
  round(begun, Activity::moving);
  round(begun, Activity::moving);
  round(begun, Activity::idle);
  round(begun, Activity::idle);
  EXPECT_TRUE(begun.any());
  round(begun, Activity::idle);
  EXPECT_FALSE(begun.any());
}

TEST_F(BegunHereTest, AMoveFromTheFrontPanelAfterwardsIsNotBegunHere) {
  BegunHere begun(catalog);
  begun.posted(intent::Home(AxisId{0}, Sign::minus));
  for (int i = 0; i < 3; ++i) round(begun, Activity::idle);
  round(begun, Activity::moving);
  EXPECT_FALSE(begun.any());
}

TEST_F(BegunHereTest, AQuestionMovesNothingAndWhatIsNotKnownMay) {
  BegunHere begun(catalog);
  begun.posted(intent::SendText("PX"));
  begun.posted(intent::SetOutput(1, true));
  begun.posted(intent::Stop());
  EXPECT_FALSE(begun.any());
  begun.posted(intent::SendText("X1000"));
  EXPECT_TRUE(begun.any());
}

TEST_F(BegunHereTest, AProgramThatWaitsIsUnderWay) {
  BegunHere begun(catalog);
  begun.posted(intent::RunProgram(0));
  now.program.run = RunState::waiting;
  for (int i = 0; i < 5; ++i) round(begun, Activity::idle);
  EXPECT_TRUE(begun.any());
  now.program.run = RunState::idle;
  for (int i = 0; i < 3; ++i) round(begun, Activity::idle);
  EXPECT_FALSE(begun.any());
}

}  // namespace
}  // namespace hw
