// The tabs of the controllers.
#include <gtest/gtest.h>

#include "tests/panels/console_stage.h"

namespace hw::panels {
namespace {

/// Pixels of the tab in the colour of EMULATED: its word has many, its shape few.
int emulated_pixels(ConsoleStage& s, std::string_view tab) {
  s.stage.surface.render();
  const gui::Rect r = s.stage.find(tab)->rect;
  const ImU32 colour = s.stage.surface.screen().theme()[gui::Tone::emu];
  int count = 0;
  for (int y = static_cast<int>(r.min.y); y < static_cast<int>(r.max.y); ++y)
    for (int x = static_cast<int>(r.min.x); x < static_cast<int>(r.max.x); ++x)
      count += s.stage.surface.pixel(x, y) == colour;
  return count;
}

TEST(ControllerTabs, OnlyTheOneWithoutRoomShowsEmulatedAsItsShape) {
  int without_room = 0;
  for (int width = 1000; width <= 1440; width += 40) {
    ConsoleStage s(width, 800);
    s.add();
    Example& second = s.add();
    s.add(), s.add();
    s.run(0.1);
    if (!s.stage.find("controller/2")) continue;  // they are in a menu
    const int first_before = emulated_pixels(s, "controller/1"),
              second_before = emulated_pixels(s, "controller/2");
    second.now.axes[0].activity = Activity::stopping;
    s.run(0.1);
    EXPECT_EQ(emulated_pixels(s, "controller/1"), first_before) << "its state is the same, at " << width;
    without_room += emulated_pixels(s, "controller/2") != second_before;
  }
  EXPECT_GT(without_room, 0);
}

}  // namespace
}  // namespace hw::panels
