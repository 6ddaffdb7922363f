// A home search that another host has stopped halfway looks at its end like one that has found its home.
#include "core/device/home_proof.h"

#include <gtest/gtest.h>

namespace hw {
namespace {

class HomeProofTest : public testing::Test {
 protected:
  HomeProof proof;
  std::int64_t place = 0;
  Instant now{};

  /// Searches to minus at 1000 steps/s, read every 20 ms.
  void search(std::int64_t from, int readings) {
    proof.begin();
    place = from;
    for (int i = 0; i < readings; ++i) read(Pps(1000)), place -= 20;
  }
  void read(Pps speed) {
    now += Millis(20);
    proof.read(Steps(place), speed, now);
  }
  /// 100 ms, 50 steps.
  std::int64_t slow_down() {
    for (const int speed : {800, 600, 400, 200}) place -= speed / 50, read(Pps(speed));
    return place;
  }
};

TEST_F(HomeProofTest, OneThatRestsFarFromZeroHasFoundNothing) {
  search(5000, 40);
  EXPECT_FALSE(proof.may_have_found(Steps(slow_down())));
  search(-3000, 40);
  EXPECT_FALSE(proof.may_have_found(Steps(slow_down())));
}

TEST_F(HomeProofTest, OneThatRestsBehindItsFirstReadingHasFoundNothing) {
  place = 5000;
  read(Pps(4000));
  place -= 80;
  read(Pps(0));
  EXPECT_FALSE(proof.may_have_found(Steps(place)));
}

TEST_F(HomeProofTest, ACountThatWasSetOnTheWayShows) {
  search(5000, 40);
  place = -10;
  EXPECT_TRUE(proof.may_have_found(Steps(slow_down())));
  search(-3000, 40);
  place = -10;
  EXPECT_TRUE(proof.may_have_found(Steps(slow_down())));
}

TEST_F(HomeProofTest, SoItMayWhereItRestsNearZero) {
  search(800, 40);
  EXPECT_TRUE(proof.may_have_found(Steps(slow_down())));
}

/// Its reading before the search shows what its first one behind the command cannot.
TEST_F(HomeProofTest, AShortSearchWhoseFirstReadingIsAtRestHasFoundHome) {
  proof.begin(Steps(5000), now + Millis(1), -1, Pps(1000));
  place = -150;  // 150 behind a home that was at 4900
  now += Millis(100);
  read(Pps(0));
  EXPECT_TRUE(proof.may_have_found(Steps(place)));
}

TEST_F(HomeProofTest, OneStoppedOnItsFirstRampHasFoundNothing) {
  for (const int began : {-300, 300, 3000}) {  // to plus: it stops before the old zero, or began behind it
    proof.begin(Steps(began), now + Millis(1), 1, Pps(1000));
    place = began + 4;
    read(Pps(200));
    place += 2;
    read(Pps(0));
    EXPECT_FALSE(proof.may_have_found(Steps(place))) << began;
  }
}

TEST_F(HomeProofTest, OneThatFindsHomeWhereItWasHasFoundIt) {
  for (const int home : {0, 10, -10}) {
    proof.begin(Steps(400), now + Millis(1), -1, Pps(1000));
    for (place = 380; place > home; place -= 20) read(Pps(1000));
    place -= home;
    EXPECT_TRUE(proof.may_have_found(Steps(slow_down()))) << home;
  }
}

/// To the limit, and slowly back from it to a home that was zero already.
TEST_F(HomeProofTest, OneThatComesBackSlowlyFromALimitMayHaveFoundHome) {
  place = 500;
  proof.begin(Steps(place), now + Millis(1), 1, Pps(1000));
  for (place = 520; place < 1000; place += 20) read(Pps(1000));
  for (; place > 0; place -= 4) read(Pps(200));
  read(Pps(0));
  EXPECT_TRUE(proof.may_have_found(Steps(place)));
}

TEST_F(HomeProofTest, OfAnUnseenHomingNothingIsReported) {
  proof.begin();
  EXPECT_TRUE(proof.may_have_found(Steps(70'000)));
}

}  // namespace
}  // namespace hw
