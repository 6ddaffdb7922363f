// Every test process has a folder for temporary files of its own. Processes run side by side, and a test that
// writes "hw_drawing.dxf" must not meet the same test, or its sibling, in another process.
#include <filesystem>
#include <string>

#include <gtest/gtest.h>
#include <stdlib.h>

namespace {

class OwnTempFolder : public ::testing::Environment {
 public:
  void SetUp() override {
    std::string name = (std::filesystem::temp_directory_path() / "hw-XXXXXX").string();
    ASSERT_TRUE(::mkdtemp(name.data())) << name;
    path_ = name;
    ::setenv("TMPDIR", name.c_str(), 1);
  }
  void TearDown() override {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }

 private:
  std::filesystem::path path_;
};

// Before main(), and so before any thread.
[[maybe_unused]] const ::testing::Environment* const own =
    ::testing::AddGlobalTestEnvironment(new OwnTempFolder);

}  // namespace
