// What the controller holds beside the text that is rehearsed is read first, where the run comes to it.
#include "core/device/registry.h"
#include "panels/program/program.h"
#include "tests/panels/panel_stage.h"

namespace hw::panels {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

struct RehearsalReads : ::testing::Test {
  RehearsalReads() {
    for (AxisState& a : s.now.axes) a.position_known = true, a.activity = Activity::idle;
    s.now.slot_bytes_used.fill(-1);
    s.stage.frames(2);
  }
  void rehearse(const char* text) {
    s.tab.desk().programs.texts.set_text(0, text);
    s.stage.frames(2);
    s.click("program/simulate");
    s.stage.frames(4);
  }
  void listed(int slot, const char* text) {
    s.tab.desk().programs.texts.listed(slot, text, s.tab.clock());
    s.settle(IntentState::done);
    s.stage.frames(4);
  }
  [[nodiscard]] const Rehearsal& rehearsal() { return *s.tab.desk().programs.rehearsals.of(0)->result; }

  const DeviceType& vxm = *find_device_type("vxm");
  Program panel;
  test::PanelStage s{panel, 1440, 900, 1, gui::Tier::wide, true, *vxm.make_catalog({}), &vxm.language()};
};

TEST_F(RehearsalReads, EachProgramThatTheRunComesTo) {
  rehearse("I1M400,JM2");
  ASSERT_TRUE(s.last<intent::UploadProgram>());
  EXPECT_EQ(s.last<intent::UploadProgram>()->slot, 2);
  EXPECT_EQ(s.reason("program/simulate"), "Calculating.");
  listed(2, "I2M300,JM1");
  ASSERT_EQ(s.last<intent::UploadProgram>()->slot, 1);
  listed(1, "I1M100");
  EXPECT_EQ(s.sent.size(), 2u) << "programs 3 and 4 are not met";
  EXPECT_EQ(rehearsal().axes[0].position, 500);
  EXPECT_EQ(rehearsal().axes[1].position, 300);
  EXPECT_THAT(s.value("rehearsal/assumed"), Not(HasSubstr("program ")));
}

TEST_F(RehearsalReads, AnUnreadProgramIsNamed) {
  rehearse("I1M400,JM2");
  ASSERT_TRUE(s.last<intent::UploadProgram>());
  s.settle(IntentState::refused, "An axis moves.");
  s.stage.frames(4);
  EXPECT_EQ(s.sent.size(), 1u) << "once is enough";
  EXPECT_EQ(rehearsal().axes[0].position, 400);
  EXPECT_THAT(s.value("rehearsal/assumed"), HasSubstr("program 2: empty, because it was not read"));
}

TEST_F(RehearsalReads, NothingWhereNoOtherProgramIsMet) {
  rehearse("I1M400");
  EXPECT_TRUE(s.sent.empty());
  EXPECT_EQ(rehearsal().axes[0].position, 400);
}

TEST_F(RehearsalReads, RunDistinguishesNoEndFromARefusal) {
  rehearse("U0,I1M400");
  EXPECT_THAT(s.value("program/rehearsed"), HasSubstr("no end was found")) << "nobody operates the input";
  rehearse("I1M400,I1M-400,L0");
  EXPECT_THAT(s.value("program/rehearsed"), HasSubstr("no end was found"));
  rehearse("U7,I1M400,I2M400,U9");
  EXPECT_THAT(s.value("program/rehearsed"), HasSubstr("the program cannot run"));
}

TEST_F(RehearsalReads, NothingWhileAnAxisMoves) {
  s.now.axes[0].activity = Activity::moving;
  rehearse("I1M400,JM2");
  EXPECT_TRUE(s.sent.empty());
  s.now.axes[0].activity = Activity::idle;
  s.stage.frames(4);
  EXPECT_TRUE(s.sent.empty()) << "it would begin elsewhere";
}

TEST_F(RehearsalReads, ALimitOfTheUsersThatItWouldPassIsReported) {
  s.now.axes[0].travel.has_plus = true;
  s.now.axes[0].travel.plus = Steps(300);
  rehearse("I1M400");
  EXPECT_THAT(s.value("rehearsal/stop/1"), HasSubstr("Past the + limit of 1, 300 steps, after "));
  EXPECT_THAT(s.value("rehearsal/stop/1"), HasSubstr("and up to 400 steps."));
  s.now.axes[0].travel.plus = Steps(500);
  s.stage.frames(4);
  EXPECT_FALSE(s.stage.find("rehearsal/stop/1"));
}

}  // namespace
}  // namespace hw::panels
