// Motions of a program that end where none of its commands takes them.
#include "core/device/way_watch.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "core/device/loaded_texts.h"
#include "core/device/registry.h"

namespace hw {
namespace {

struct WayWatchTest : testing::Test {
  WayWatchTest() {
    now.axis_count = 2;
    now.link.state = LinkState::good;
    now.axes[0].position_known = now.axes[1].position_known = true;
  }
  /// Started by the console, as the axes rest.
  void program(const std::string& text) {
    texts.loaded(intent::LoadProgram(0, text));
    rest(1);
    watch.starts(0, now.at);
    begins();
  }
  void begins() {
    now.program.owned = true;
    now.program.slot = 0;
    now.program.run = RunState::running;
    now.program.ended_by = EndedBy::nothing;
  }
  void look() {
    now.at += gap;
    now.axes[0].seen_at = now.axes[1].seen_at = now.at;
    for (const Ending& ending : watch.look(now)) cut.push_back(ending);
  }
  /// At 1000 steps/s.
  void go_to(std::int64_t place, std::size_t index = 0) {
    AxisState& axis = now.axes[index];
    const std::int64_t most = gap / Millis(1);
    axis.activity = Activity::moving;
    while (axis.position != Steps(place)) {
      axis.position += Steps(std::clamp(place - axis.position.value, -most, most));
      look();
    }
    axis.activity = Activity::idle;
  }
  void rest(double seconds) {
    now.axes[0].activity = now.axes[1].activity = Activity::idle;
    const Instant until = now.at + from_seconds(seconds);
    do look();
    while (now.at < until);
  }
  void program_ends() {
    now.program.owned = false;
    now.program.run = RunState::idle;
    now.program.ended_by = EndedBy::target;
    rest(1);
    EXPECT_FALSE(watch.is_judging());
  }

  const DeviceType& type = *find_device_type("vxm");
  const Catalog catalog = *type.make_catalog({});
  LoadedTexts texts{catalog, &type.language()};
  WayWatch watch{catalog, [this](int slot) { return texts.ways_of(slot); }};
  Duration gap = Millis(20);
  Snapshot now;
  std::vector<Ending> cut;
};

TEST(WaysOfProgram, AreReadInEachLanguageOfFixedSteps) {
  struct Known {
    const char* model;
    int slot;
    const char* text;
  };
  for (const auto& [model, slot, text] :
       {Known{"vxm", 1, "S1M2000\nI1M20000\nP20\nI1M20000\n"},
        Known{"pmx-4ex-sa", 0, "EO=15\nHSPD=2000\nABS\nX20000\nWAITX\nDELAY=2000\nX0\nWAITX\nEND\n"},
        Known{"dmx-k-sa", 0, "EO=1\nHSPD=2000\nABS\nX20000\nWAITX\nDELAY=2000\nX0\nWAITX\nEND\n"}}) {
    const DeviceType& type = *find_device_type(model);
    const Catalog catalog = *type.make_catalog({});
    LoadedTexts texts(catalog, &type.language());
    texts.loaded(intent::LoadProgram(slot, text));
    const auto ways = texts.ways_of(slot);
    ASSERT_TRUE(ways) << model;
    EXPECT_TRUE((*ways)[0].known) << model;
    EXPECT_TRUE(was_cut_short((*ways)[0], Steps(0), Steps(6000))) << model;
    EXPECT_FALSE(was_cut_short((*ways)[0], Steps(0), Steps(20000))) << model;
  }
}

TEST(WaysOfProgram, AreUnknownWhereAUserUnitMayScaleThem) {
  const DeviceType& type = *find_device_type("vme58");
  const Catalog catalog = *type.make_catalog({});
  LoadedTexts texts(catalog, &type.language());
  texts.loaded(intent::LoadProgram(0, "AX MR20000 GO ID\n"));
  EXPECT_FALSE(texts.ways_of(0));
}

TEST_F(WayWatchTest, WholeDistancesAreNoCutOnes) {
  program("I1M4000\nP5\nI1M4000\n");
  go_to(4000);
  rest(3);
  go_to(8000);
  rest(0.2);
  program_ends();
  EXPECT_TRUE(cut.empty());
  EXPECT_FALSE(watch.last_cut());
}

TEST_F(WayWatchTest, ADistanceThatEndsEarlyWhileTheProgramWaitsIsReported) {
  program("I1M4000\nP50\nI1M4000\n");
  go_to(1200);
  rest(5);
  ASSERT_EQ(cut.size(), 1u);
  EXPECT_EQ(cut[0].by, EndedBy::elsewhere);
  EXPECT_EQ(cut[0].place, Steps(1200));
  EXPECT_TRUE(cut[0].of_run);
  go_to(5200);
  rest(0.2);
  program_ends();
  EXPECT_EQ(cut.size(), 1u);
  EXPECT_FALSE(watch.last_cut()) << "the last one was whole";
}

TEST_F(WayWatchTest, TheLastOneEndsTheProgramWithIt) {
  program("I1M-4000\n");
  go_to(-1200);
  rest(0.2);
  program_ends();
  ASSERT_EQ(cut.size(), 1u);
  ASSERT_TRUE(watch.last_cut());
  EXPECT_EQ(watch.last_cut()->by, EndedBy::elsewhere);
  EXPECT_TRUE(watch.last_cut()->perhaps_limit);
}

TEST_F(WayWatchTest, OnASwitchItIsTheSwitch) {
  program("I1M4000\n");
  go_to(1200);
  now.axes[0].limits_known = now.axes[0].limit_plus = true;
  rest(0.2);
  program_ends();
  ASSERT_EQ(cut.size(), 1u);
  EXPECT_EQ(cut[0].by, EndedBy::limit);
  EXPECT_TRUE(cut[0].limit_plus);
  ASSERT_TRUE(watch.last_cut());
  EXPECT_EQ(watch.last_cut()->by, EndedBy::limit);
}

TEST_F(WayWatchTest, TheLastMotionIsTheOneThatRestedLast) {
  program("I2M4000\nI1M4000\n");
  go_to(1200, 1);
  rest(0.2);
  go_to(4000, 0);
  rest(0.2);
  program_ends();
  ASSERT_EQ(cut.size(), 1u);
  EXPECT_EQ(cut[0].axis, 1);
  EXPECT_FALSE(watch.last_cut()) << "axis 1 came to its target behind it";
}

TEST_F(WayWatchTest, TwoCommandsOneBehindTheOtherAreOneWay) {
  program("I1M400\nI1M800\n");
  go_to(1200);
  rest(0.2);
  program_ends();
  EXPECT_TRUE(cut.empty());
}

TEST_F(WayWatchTest, APlaceIsReachedOrNot) {
  program("IA1M4000\nP50\nIA1M0\n");
  go_to(4000);
  rest(3);
  EXPECT_TRUE(cut.empty());
  go_to(2000);
  rest(0.2);
  program_ends();
  EXPECT_EQ(cut.size(), 1u);
}

TEST_F(WayWatchTest, ASlowMotionIsNoRestBetweenTwoSteps) {
  program("I1M4000\nP50\nI1M4000\n");
  for (int step = 1; step <= 30; ++step) {
    go_to(step);
    rest(0.8);
  }
  EXPECT_TRUE(cut.empty());
}

TEST_F(WayWatchTest, BothDirectionsAreNotJudgedHoweverSeldomTheReadings) {
  gap = Millis(200);
  program("I1M1000\nI1M-900\nI1M5000\n");
  go_to(1000);
  go_to(100);
  rest(3);
  go_to(600);
  rest(3);
  program_ends();
  EXPECT_TRUE(cut.empty());
}

TEST_F(WayWatchTest, ACountThatWasSetJustBeforeTheStartIsNoPlace) {
  rest(1);
  watch.disturbed();  // "N"
  watch.starts(0, now.at);
  texts.loaded(intent::LoadProgram(0, "I1M4000\n"));
  begins();
  now.axes[0].position = Steps(3000);
  look();
  go_to(4000);
  rest(0.2);
  program_ends();
  EXPECT_TRUE(cut.empty());
}

TEST_F(WayWatchTest, AProgramThatAnotherStartedIsNotJudged) {
  texts.loaded(intent::LoadProgram(0, "I1M4000\n"));
  rest(1);
  begins();
  go_to(1200);
  rest(0.2);
  program_ends();
  EXPECT_TRUE(cut.empty());
}

TEST_F(WayWatchTest, NorIsOneWhoseStartFollowedAStop) {
  program("I1M4000\nP50\nI1M4000\n");
  watch.stopped(0);
  watch.disturbed();
  go_to(1200);
  rest(3);
  program_ends();
  EXPECT_TRUE(cut.empty());
}

TEST_F(WayWatchTest, AStoppedAxisIsNotJudgedBeforeTheNextProgram) {
  program("I1M4000\nP50\nI1M4000\n");
  go_to(1200);
  watch.stopped(0);
  rest(3);
  go_to(2000);
  rest(3);
  program_ends();
  EXPECT_TRUE(cut.empty());
  program("I1M4000\n");
  go_to(3000);
  rest(0.2);
  program_ends();
  EXPECT_EQ(cut.size(), 1u);
}

TEST_F(WayWatchTest, NothingIsJudgedBehindATextOfTheUsers) {
  program("I1M4000\nP50\nI1M4000\n");
  rest(0.1);
  watch.disturbed();
  go_to(1200);
  rest(3);
  EXPECT_TRUE(cut.empty());
}

TEST_F(WayWatchTest, NorOfAProgramThatSearchesASwitch) {
  program("I1M-0\nP50\nI1M4000\n");
  go_to(-1200);
  rest(3);
  EXPECT_TRUE(cut.empty());
}

TEST_F(WayWatchTest, NorOfAMotionWhoseBeginWasNotSeen) {
  program("I1M-4000\nP50\nI1M-4000\n");
  now.link.state = LinkState::lost;
  look();
  now.axes[0].position = Steps(-2800);
  now.link.state = LinkState::good;
  go_to(-4000);
  rest(3);
  program_ends();
  EXPECT_TRUE(cut.empty());
}

}  // namespace
}  // namespace hw
