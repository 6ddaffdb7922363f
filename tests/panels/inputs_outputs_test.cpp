// Inputs and outputs of lines with directions: each stands under the name of its group.
#include "panels/inputs_outputs.h"

#include "core/device/registry.h"
#include "tests/panels/panel_stage.h"

namespace hw::panels {
namespace {

struct LinesTest : ::testing::Test {
  LinesTest() {
    s.now.inputs = 0x3FFE;
    s.now.inputs_known = 0x3FFF;
    s.now.outputs_known = 0x3F;
    s.now.outputs = 1;
    s.now.io_seen_at = Instant(from_seconds(1e6));
    s.stage.frames(2);
  }
  float top(const char* id) {
    const gui::Widget* found = s.stage.find(id);
    EXPECT_TRUE(found) << id;
    return found ? found->rect.min.y : 0;
  }
  InputsOutputs panel;
  test::PanelStage s{panel, 240, 700, 1, gui::Tier::wide, true, *find_device_type("vme58")->make_catalog({})};
};

TEST_F(LinesTest, EachStandsUnderItsDirection) {
  EXPECT_EQ(s.value("io/group/Lines 0 to 7: inputs"), "Lines 0 to 7: inputs");
  const float inputs = top("io/group/Lines 0 to 7: inputs"), outputs = top("io/group/Lines 8 to 13: outputs"),
              auxiliary = top("io/group/Auxiliary: outputs");
  for (const char* id : {"io/in/0", "io/in/7"}) {
    EXPECT_GT(top(id), inputs) << id;
    EXPECT_LT(top(id), outputs) << id;
  }
  for (const char* id : {"io/out/8", "io/out/13", "io/in/8", "io/in/13"}) {
    EXPECT_GT(top(id), outputs) << id;
    EXPECT_LT(top(id), auxiliary) << id;
  }
  EXPECT_GT(top("io/in/8"), top("io/out/13")) << "levels under the switches";
  EXPECT_GT(top("io/out/14"), auxiliary);
}

TEST_F(LinesTest, LevelsAndSwitchesAreThoseOfTheirLines) {
  EXPECT_EQ(s.value("io/in/0"), "low");
  EXPECT_EQ(s.value("io/in/7"), "high");
  EXPECT_EQ(s.value("io/in/13"), "high");
  EXPECT_EQ(s.stage.find("io/in/0")->label, "In 0");
  EXPECT_EQ(s.stage.find("io/in/8")->label, "Line 8");
  s.click("io/out/9");
  const auto* asked = s.last<intent::SetOutput>();
  ASSERT_TRUE(asked);
  EXPECT_EQ(asked->number, 9);
  EXPECT_TRUE(asked->on);
}

}  // namespace
}  // namespace hw::panels
