#pragma once
// The panel of drawings with a file that can be dropped on it.
#include "core/device/registry.h"
#include "core/session/user_files.h"
#include "panels/drawing/drawing_tab.h"
#include "tests/panels/panel_stage.h"

namespace hw::panels {

inline constexpr std::string_view square_and_text =
    "0\nSECTION\n2\nHEADER\n9\n$INSUNITS\n70\n4\n0\nENDSEC\n0\nSECTION\n2\nENTITIES\n"
    "0\nLINE\n8\ncut\n10\n10\n20\n10\n11\n30\n21\n10\n"
    "0\nLINE\n8\ncut\n10\n30\n20\n10\n11\n30\n21\n20\n"
    "0\nCIRCLE\n8\nholes\n10\n20\n20\n15\n40\n2\n"
    "0\nTEXT\n8\ncut\n10\n0\n20\n0\n40\n1\n1\nhello\n"
    "0\nENDSEC\n0\nEOF\n";

struct DrawingTabTest : ::testing::Test {
  explicit DrawingTabTest(const char* model = "pmx-4ex-sa", const DeviceOptions& options = {})
      : type(*find_device_type(model)),
        s(panel, 864, 1400, 1, gui::Tier::wide, true, *type.make_catalog(options), &type.language()) {
    s.now.axis_count = 4;
    for (AxisState& a : s.now.axes) a.position_known = true, a.activity = Activity::idle;
    s.stage.frames(2);
    file = std::filesystem::temp_directory_path() / (std::string("hw_drawing_") + model + ".dxf");
    EXPECT_TRUE(write_file(file, square_and_text));
  }
  ~DrawingTabTest() override { std::filesystem::remove(file); }
  void drop() {
    s.tab.desk().dropped["drawing"].push_back(file);
    s.stage.frames(6);
  }
  void two_hundred_pulses_in_a_mm() {
    s.type("drawing/per_unit/X", "200");
    s.type("drawing/per_unit/Y", "200");
  }
  const DeviceType& type;
  DrawingTab panel;
  std::filesystem::path file;
  test::PanelStage s;
};
struct VxmDrawingTabTest : DrawingTabTest {
  VxmDrawingTabTest() : DrawingTabTest("vxm") { s.now.axis_count = 2; }
};

struct SlaveDrawingTabTest : DrawingTabTest {
  SlaveDrawingTabTest() : DrawingTabTest("vxm", {{"motors", "4"}}) {}
};

}  // namespace hw::panels
