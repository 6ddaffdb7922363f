// The sheet of a saved picture of a path: rulers in the units of the axes, and the path where they say.
#include <optional>

#include "gui/surface/path_picture.h"
#include "panels/path/path_sheet.h"
#include "tests/panels/panel_stage.h"

namespace hw::panels {
namespace {

/// Makes the sheet of a box of 100 x 50 (x 20), as if it were saved in each frame.
struct SheetPanel final : gui::Panel {
  void draw(gui::Frame& f) override {
    PathSubject subject;
    drawing::Box3 box;
    box.add({0, 0, 0}), box.add({100, 50, in_space ? 20.0 : 0.0});
    drawing::Projection from;
    if (in_space) from = drawing::Projection(box, drawing::views::iso, true), subject.axes.third = AxisId{2};
    sheet.emplace(f, subject, box, from, true);
  }
  bool in_space = false;
  std::optional<PathSheet> sheet;
};

struct PathSheetTest : testing::Test {
  static unsigned grey(std::uint32_t pixel) { return pixel >> IM_COL32_G_SHIFT & 255u; }
  [[nodiscard]] gui::Picture drawn(const drawing::ToolPath& path) const {
    gui::PathLook look;
    look.tool_on = IM_COL32_BLACK, look.on_width = 4;
    return panel.sheet->with(gui::path_picture(std::array{gui::PathLayer{&path, look}}, panel.sheet->view()));
  }
  /// In the part of the sheet between these shares of its width and height.
  static int written(const gui::Picture& sheet, double left, double top, double right, double bottom) {
    int dark = 0;
    for (int y = static_cast<int>(top * sheet.height); y < static_cast<int>(bottom * sheet.height); ++y)
      for (int x = static_cast<int>(left * sheet.width); x < static_cast<int>(right * sheet.width); ++x)
        dark += grey(sheet.pixels[static_cast<std::size_t>(y * sheet.width + x)]) < 0x70;
    return dark;
  }
  SheetPanel panel;
  test::PanelStage s{panel};
};

TEST_F(PathSheetTest, HasRulersAtItsLeftAndBelow) {
  s.stage.frames(2);
  const gui::Picture sheet = drawn({});
  EXPECT_GT(written(sheet, 0, 0.1, 0.058, 0.9), 20) << "numbers of the second axis";
  EXPECT_GT(written(sheet, 0.1, 0.965, 0.9, 1), 100) << "of the first";
  EXPECT_GT(written(sheet, 0, 0, 0.2, 0.03), 20) << "the name of the second axis, and its unit";
  EXPECT_EQ(written(sheet, 0.1, 0.1, 0.9, 0.9), 0) << "nothing but faint lines where the path will be";
}

TEST_F(PathSheetTest, ThePathLiesWhereItsRulersShow) {
  s.stage.frames(2);
  const drawing::PathView& view = panel.sheet->view();
  drawing::ToolPath path;
  path.go({20, 0}, {20, 50}, true, 0);
  const gui::Picture plain = drawn({}), sheet = drawn(path);
  const auto column = [&](const gui::Picture& picture, const auto& wanted) {
    const int row = sheet.height / 2 + 7;
    int sum = 0, count = 0;
    for (int x = 0; x < sheet.width; ++x)
      if (wanted(grey(picture.pixels[static_cast<std::size_t>(row * sheet.width + x)]))) sum += x, ++count;
    return std::pair(count > 0 ? static_cast<double>(sum) / count : -1.0, count);
  };
  const auto [at, width] = column(sheet, [](unsigned g) { return g < 0x40; });
  EXPECT_NEAR(width, 4, 1);
  const auto [zero, lines] = column(plain, [](unsigned g) { return g > 0x60 && g < 0xa0; });
  ASSERT_EQ(lines, 1) << "the ruler at 0";
  EXPECT_NEAR(at - zero, 20 / view.per_px().x, 1.5);
}

TEST_F(PathSheetTest, InPerspectiveItsEdgesShowTheirRange) {
  panel.in_space = true;
  s.stage.frames(2);
  const gui::Picture sheet = drawn({});
  EXPECT_GT(written(sheet, 0, 0, 1, 1), 300) << "three names with their ranges";
}

}  // namespace
}  // namespace hw::panels
