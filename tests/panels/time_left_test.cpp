// Beside the bar of a run stands how much of it is left, and on the card when outputs and inputs have their
// turn.
#include "core/device/registry.h"
#include "panels/program/program.h"
#include "tests/panels/panel_stage.h"

namespace hw::panels {
namespace {

using ::testing::HasSubstr;

struct RunLeft : ::testing::Test {
  void begin(const char* text) {
    s.now.slot_bytes_used.fill(0);
    for (AxisState& a : s.now.axes) a.position_known = true, a.activity = Activity::idle;
    s.tab.desk().programs.texts.set_text(0, text);
    s.stage.frames(2);
    s.click("program/simulate");
    s.stage.frames(4);
    s.tab.desk().programs.texts.loaded(0, text, s.tab.clock());
    ProgramState& p = s.now.program;
    p.owned = true, p.slot = 0, p.run = RunState::running, p.started_at = s.tab.clock();
    s.stage.frames(4);
  }
  const DeviceType& vxm = *find_device_type("vxm");
  Program panel;
  test::PanelStage s{panel, 1440, 900, 1, gui::Tier::wide, true, *vxm.make_catalog({}), &vxm.language()};
};

TEST_F(RunLeft, StandsInTheBarInPlaceOfTheMemory) {
  begin("S1M1000,I1M20000\n");
  EXPECT_THAT(s.value("program/left"), HasSubstr(" s left"));
  EXPECT_THAT(s.value("rehearsal/progress"), HasSubstr(" s left"));
  EXPECT_FALSE(s.stage.find("program/memory"));
  s.now.program.run = RunState::idle;
  s.stage.frames(2);
  EXPECT_FALSE(s.stage.find("program/left"));
  EXPECT_TRUE(s.stage.find("program/memory"));
}

TEST_F(RunLeft, OutputsHaveTheirLineOfTime) {
  begin("U5,P10,U4,I1M20000\n");
  EXPECT_EQ(s.value("rehearsal/io/1"), "on from 0.0 s to 1.0 s");
}

/// The card is as high as in a window of 1440x900.
TEST(LineOfTime, OfOutputsAndInputsIsSeenWithoutScrolling) {
  const DeviceType& pmx = *find_device_type("pmx-4ex-sa");
  Program panel;
  test::PanelStage s(panel, 864, 560, 1, gui::Tier::wide, true, *pmx.make_catalog({}), &pmx.language());
  s.now.axis_count = 4;
  for (AxisState& a : s.now.axes) a.position_known = true, a.activity = Activity::idle;
  s.tab.desk().programs.texts.set_text(
      0, "EO=15\nDO1=1\nDO2=1\nX500Y400Z300U200\nWAITX\nDO1=0\nIF DI1=0\nDO2=0\nENDIF\nEND\n");
  s.stage.frames(2);
  s.click("program/simulate");
  s.stage.frames(6);
  for (const char* id : {"rehearsal/io/1", "rehearsal/io/2", "rehearsal/io/3"}) {
    ASSERT_TRUE(s.stage.find(id)) << id;
    EXPECT_TRUE(s.stage.find(id)->wholly_in_view()) << id;
  }
}

// It counts in pulses at the end of the text, and in encoder counts before it: both are as they were told.
TEST(RehearsalOfALoop, ThatTheTextSwitchesOffBeginsWhereTheAxisStands) {
  const DeviceType& dmx = *find_device_type("dmx-k-sa");
  Program panel;
  test::PanelStage s(panel, 1440, 900, 1, gui::Tier::wide, true, *dmx.make_catalog({}), &dmx.language());
  s.now.axis_count = 1;
  s.now.axes[0].position_known = true, s.now.axes[0].activity = Activity::idle;
  const int loop = s.catalog.find_param("SL");
  ASSERT_GE(loop, 0);
  s.now.params[static_cast<std::size_t>(loop)] = {1, true};
  s.now.axes[0].in_counts = true;
  s.tab.desk().programs.texts.set_text(0, "EO=1\nSL=0\nX500\nWAITX\nEND\n");
  s.stage.frames(2);
  s.click("program/simulate");
  s.stage.frames(4);
  const gui::Rehearsals::Outcome* outcome = s.tab.desk().programs.rehearsals.of(0);
  ASSERT_TRUE(outcome && outcome->result);
  EXPECT_FALSE(outcome->result->axes[0].in_counts);
  EXPECT_NE(outcome->start.match, gui::StartMatch::other_count);
  EXPECT_THAT(s.value("rehearsal/axis/X"), HasSubstr(s.catalog.step_word)) << "not in counts";
}

}  // namespace
}  // namespace hw::panels
