// How drawings were made last time: kept by controller, and never in the way.
#include "core/session/kept_options.h"

#include <gmock/gmock.h>

#include "tests/core/session/folder.h"

namespace hw {
namespace {

using ::testing::HasSubstr;

struct KeptDrawingOptions : testing::Test {
  test::Folder folder;
  UserFolders folders = UserFolders::below(folder.path());
  KeptOptionsOfDrawings store{folders};
  KeptOptions some{{{"ramp", 100.5}}, {{"tool", "DO1"}}};
};

TEST_F(KeptDrawingOptions, AreThereAgainByTheirController) {
  ASSERT_TRUE(store.save("a", some));
  const auto kept = store.load("a");
  ASSERT_TRUE(kept);
  EXPECT_EQ(*kept, some);
  ASSERT_TRUE(kept->number("ramp"));
  EXPECT_EQ(*kept->number("ramp"), 100.5);
  EXPECT_EQ(kept->number("tool"), nullptr) << "it is a word";
  EXPECT_EQ(*store.load("b"), KeptOptions());
}

TEST_F(KeptDrawingOptions, ADamagedFileIsPutAsideWithASentence) {
  ASSERT_TRUE(store.save("a", some));
  for (const auto& entry : std::filesystem::directory_iterator(folders.config / "drawings"))
    ASSERT_TRUE(write_file(entry.path(), R"({"version": 1, "options": {"ramp": []}})"));
  const auto kept = store.load("a");
  ASSERT_FALSE(kept);
  EXPECT_THAT(kept.error().sentence(), HasSubstr("of drawings is damaged"));
  EXPECT_EQ(*store.load("a"), KeptOptions()) << "it is not read again";
}

TEST(KeptDrawingOptionsOfNobody, WithoutFoldersNothingIsKept) {
  const KeptOptionsOfDrawings store(UserFolders::none());
  EXPECT_TRUE(store.save("a", KeptOptions{{{"ramp", 1.0}}, {}}));
  EXPECT_EQ(*store.load("a"), KeptOptions());
}

}  // namespace
}  // namespace hw
