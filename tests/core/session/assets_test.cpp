#include "core/session/assets.h"

#include <gtest/gtest.h>

#include "tests/core/session/folder.h"

namespace hw {
namespace {

TEST(Assets, AreFoundInTheTreeThatWasBuilt) {
  const test::Folder tree;
  const auto page = tree.put("assets/manual/vxm.md", "#");
  tree.put("build/handwheel", "");
  EXPECT_EQ(find_asset(tree.path() / "build", "manual/vxm.md"), page);
}

TEST(Assets, AreFoundWhereTheyAreInstalled) {
  const test::Folder root;
  const auto page = root.put("usr/share/handwheel/manual/vxm.md", "#");
  root.put("usr/bin/handwheel", "");
  EXPECT_EQ(find_asset(root.path() / "usr/bin", "manual/vxm.md"), page);
  EXPECT_TRUE(is_installed(root.path() / "usr/bin"));
  EXPECT_FALSE(is_installed(HW_SOURCE_DIR "/build"));
}

TEST(Assets, ThatAreNowhereHaveNoPath) {
  const test::Folder root;
  EXPECT_EQ(find_asset(root.path() / "bin", "manual"), "");
}

TEST(Assets, OfThisTreeAreFoundByAProgramInIt) {
  EXPECT_EQ(find_asset(HW_SOURCE_DIR "/build", "manual/vxm.md"),
            std::filesystem::path(HW_SOURCE_DIR) / "assets/manual/vxm.md");
}

}  // namespace
}  // namespace hw
