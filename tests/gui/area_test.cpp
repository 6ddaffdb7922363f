#include "gui/widgets/area.h"

#include <gtest/gtest.h>

#include "gui/widgets/button.h"
#include "tests/gui/stage.h"

namespace hw::gui {
namespace {

/// A toolbar, and below it a part with more rows than there is room for; its lower edge reaches a little
/// beyond the window.
struct PartInAPart : testing::Test {
  Stage stage{in_window([](Ui& ui) {
                begin_part(ui, "whole", 0, ui.px(400), Tone::panel, 0, false);
                button(ui, "tool", "Tool", {});
                begin_part(ui, "rows", ui.px(300), ui.px(370), Tone::panel, 0);
                for (int row = 1; row <= 40; ++row) button(ui, row == 40 ? "last" : "row", "Row", {});
                end_part();
                end_part();
              }),
              800, 450};
};

TEST_F(PartInAPart, ScrollingToAWidgetWithinDoesNotScrollTheWhole) {
  stage.frames(3);
  const float tool = stage.find("tool")->rect.min.y;
  for (int n = 0; n < 5; ++n) {
    stage.surface.screen().registry().scroll_to("last");
    stage.frames(3);
  }
  EXPECT_TRUE(stage.find("last")->in_view());
  EXPECT_FLOAT_EQ(stage.find("tool")->rect.min.y, tool);
}

}  // namespace
}  // namespace hw::gui
