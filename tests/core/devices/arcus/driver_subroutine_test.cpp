// Subroutines that the host has called (GS): they run in a thread that no SR ends and no SASTAT shows
// (decision AMB-046).
#include "tests/core/devices/arcus/driver_fixture.h"

namespace hw::arcus {
namespace {

using testing::HasSubstr;

class Subroutine : public DriverTest {
 protected:
  static constexpr const char* pmx = "pmx-4ex-sa";
  static constexpr const char* dmx = "dmx-k-sa";
  const std::string program = "PRG 0\nDELAY=1\nEND\n";
  const std::string endless = "SUB 1\nABS\nWHILE 1=1\nX2000\nWAITX\nX0\nWAITX\nENDWHILE\nENDSUB\n";
  std::string load(std::string text) { return perform(intent::LoadProgram(0, program + std::move(text))); }
  std::string stop() { return perform(intent::Stop()); }
  int stops() {
    const std::string all = sent();
    int n = 0;
    for (auto at = all.find("STOP"); at != all.npos; at = all.find("STOP", at + 1)) ++n;
    return n;
  }
  void next() {
    TearDown();
    latest = Snapshot();
    notices.clear();
  }
};

TEST_F(Subroutine, OneThatGoesOnIsNeverReportedAsStopped) {
  for (const char* model : {pmx, dmx}) {
    start(model);
    ASSERT_EQ(load(endless), "");
    run(3);
    ASSERT_EQ(query("GS1"), "OK");
    run(0.3);
    sent();
    const Instant asked = time.now();
    const std::string sentence = stop();
    EXPECT_THAT(sentence, HasSubstr("subroutine")) << model;
    EXPECT_THAT(sentence, HasSubstr("Switch the power off")) << model;
    EXPECT_GT(stops(), 4) << "each move that it begins is stopped";
    EXPECT_LT(seconds(time.now() - asked), 15);
    next();
  }
}

TEST_F(Subroutine, OneThatEndsIsWaitedFor) {
  start(pmx);
  ASSERT_EQ(load("SUB 1\nDELAY=1000\nX2000\nWAITX\nENDSUB\n"), "");
  ASSERT_EQ(act("subroutine", {1}), "");
  EXPECT_EQ(stop(), "");
  const auto there = query("PX");
  run(4);
  EXPECT_EQ(query("PX"), there) << "its move was stopped when it began";
  EXPECT_LT(std::stoi(there), 300);
  sent();
  EXPECT_EQ(stop(), "") << "and it is known to have ended";
  EXPECT_EQ(stops(), 2);
}

TEST_F(Subroutine, ALongOneMayStillGoOn) {
  start(pmx);
  ASSERT_EQ(load("SUB 1\nDELAY=30000\nX2000\nWAITX\nENDSUB\n"), "");
  ASSERT_EQ(query("GS1"), "OK");
  EXPECT_THAT(stop(), HasSubstr("subroutine"));
  ASSERT_TRUE(run_until([&] { return latest.any_axis_moving(); }, 40));
  ASSERT_TRUE(wait_idle());
  run(60);
  EXPECT_EQ(stop(), "") << "over for long";
}

TEST_F(Subroutine, OneThatMovesNothingHoldsNoStop) {
  start(pmx);
  ASSERT_EQ(load("SUB 1\nDELAY=30000\nDO=1\nENDSUB\nSUB 2\nV1=2\nGOSUB 1\nENDSUB\n"), "");
  ASSERT_EQ(query("GS2"), "OK");
  EXPECT_EQ(stop(), "");
}

TEST_F(Subroutine, OneThatIsNotThereWasNotCalled) {
  start(pmx);
  ASSERT_EQ(load(endless), "");
  EXPECT_THAT(query("GS4"), HasSubstr("?Sub"));
  EXPECT_THAT(query("GS32"), HasSubstr("?"));
  EXPECT_EQ(stop(), "");
}

TEST_F(Subroutine, OneWhoseCallWasNotConfirmedMayRun) {
  start(pmx);
  ASSERT_EQ(load(endless), "");
  run(3);
  loop->drop(3);
  EXPECT_NE(act("subroutine", {1}), "");
  EXPECT_THAT(stop(), HasSubstr("subroutine"));
}

TEST_F(Subroutine, AnUnreadSubroutineMayDoAnything) {
  start(pmx);
  ASSERT_EQ(load("SUB 1\nV1=1\nENDSUB\n"), "");
  ASSERT_EQ(query("SA9=END"), "OK");
  ASSERT_EQ(query("GS1"), "OK");
  run(600);
  EXPECT_THAT(stop(), HasSubstr("subroutine"));
}

TEST_F(Subroutine, OneOfItsLoopsIsNoEnd) {
  start(pmx);
  ASSERT_EQ(load("SUB 1\nWHILE DI1=0\nENDWHILE\nX2000\nWAITX\nENDSUB\n"), "");
  ASSERT_EQ(query("GS1"), "OK");
  run(600);
  EXPECT_THAT(stop(), HasSubstr("ubroutine 1"));
  ASSERT_EQ(perform(intent::SetPosition(0, Steps(1234))), "");
  run(1);
  ASSERT_TRUE(loop->operate(bench::PowerCycle()));
  run(5);
  ASSERT_EQ(latest.restarts, 1u);
  EXPECT_EQ(stop(), "") << "the power switch has ended it";
}

}  // namespace
}  // namespace hw::arcus
