#include "tests/gui/gallery.h"

#include <filesystem>
#include <set>

#include <gtest/gtest.h>

#include "tests/gui/stage.h"

namespace hw::gui {
namespace {

// Leaves pictures of every component in every state beside the build, to be looked at.
TEST(Gallery, IsDrawnInBothThemesAndScales) {
  const std::filesystem::path folder = std::filesystem::path(HW_BINARY_DIR) / "pictures";
  std::filesystem::create_directories(folder);
  for (const bool dark : {true, false})
    for (const float scale : {1.0f, 2.0f}) {
      Stage stage(in_window(draw_gallery), 1440, 1064, scale, dark);
      stage.frames(3);
      const std::string name =
          std::string("gallery-") + (dark ? "dark" : "light") + (scale > 1 ? "-200.png" : ".png");
      ASSERT_TRUE(stage.surface.screenshot((folder / name).string()));
      EXPECT_TRUE(std::filesystem::exists(folder / name));
    }
}

TEST(Gallery, EachIdOnce) {
  Stage stage(in_window(draw_gallery), 1440, 1064);
  stage.frames(2);
  std::set<std::string> seen;
  for (const auto& w : stage.hand.list()) EXPECT_TRUE(seen.insert(w.id).second) << w.id << " twice";
  EXPECT_GT(seen.size(), 70u);
}

}  // namespace
}  // namespace hw::gui
