#include "core/session/text_file.h"

#include <csignal>

#include <gmock/gmock.h>
#include <sys/resource.h>
#include <sys/stat.h>

#include "tests/core/session/folder.h"

namespace hw {
namespace {

using ::testing::HasSubstr;

TEST(TextFile, OpensTextWithAnyLineEndAndGivesThemBack) {
  test::Folder folder;
  const auto path = folder.put("dos.vxm", "I1M400,R\r\n; end\r\n\x1A");
  auto file = load_text(path);
  ASSERT_TRUE(file);
  EXPECT_EQ(file->text, "I1M400,R\n; end\n");
  EXPECT_TRUE(file->dos_lines);
  ASSERT_TRUE(save_text(path, *file));
  EXPECT_EQ(folder.get("dos.vxm"), "I1M400,R\r\n; end\r\n");
}

TEST(TextFile, ReadsLatin1AndByteOrderMark) {
  EXPECT_EQ(decode_text("; 45\xB0", "a.vxm")->text, "; 45\xC2\xB0");
  EXPECT_TRUE(decode_text("; 45\xB0", "a.vxm")->was_latin1);
  EXPECT_EQ(decode_text("\xEF\xBB\xBFI1M1", "a.vxm")->text, "I1M1");
  EXPECT_EQ(decode_text("a\rb", "mac.vxm")->text, "a\nb");
}

TEST(TextFile, RefusesWhatIsNoText) {
  test::Folder folder;
  auto file = load_text(folder.put("photo.vxm", std::string("\x89PNG\r\n\x1a\n\0\0", 10)));
  ASSERT_FALSE(file);
  EXPECT_THAT(file.error().sentence(), HasSubstr("photo.vxm is not a text: its byte 7 is 1A hex."));
  EXPECT_THAT(file.error().sentence(), HasSubstr("nothing else was changed"));
}

TEST(TextFile, RefusesWhatIsTooBigOrNotThere) {
  test::Folder folder;
  auto big = load_text(folder.put("big.vxm", std::string(largest_program_text + 1, 'x')));
  ASSERT_FALSE(big);
  EXPECT_THAT(big.error().sentence(), HasSubstr("big.vxm is larger than 1000 kB"));
  auto absent = load_text(folder.path() / "absent.vxm");
  ASSERT_FALSE(absent);
  EXPECT_THAT(absent.error().sentence(), HasSubstr("There is no file"));
  auto directory = load_text(folder.path());
  ASSERT_FALSE(directory);
  EXPECT_THAT(directory.error().sentence(), HasSubstr("is a folder"));
}

TEST(TextFile, DiskFullKeepsTheOldFileAndReportsIt) {
  test::Folder folder;
  const auto path = folder.put("scan.vxm", "old text\n");
  // The kernel refuses to let any file grow past this, as a full disk does.
  rlimit before{};
  ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &before), 0);
  const auto ignored = std::signal(SIGXFSZ, SIG_IGN);
  rlimit small = before;
  small.rlim_cur = 4096;
  ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &small), 0);
  TextFile file;
  file.text = std::string(20000, 'x');
  const auto saved = save_text(path, file);
  ::setrlimit(RLIMIT_FSIZE, &before);
  std::signal(SIGXFSZ, ignored);
  ASSERT_FALSE(saved);
  EXPECT_THAT(saved.error().sentence(), HasSubstr("scan.vxm was not written"));
  EXPECT_THAT(saved.error().sentence(), HasSubstr("The text is kept here, and the old file is unchanged."));
  EXPECT_EQ(folder.get("scan.vxm"), "old text\n");
  EXPECT_EQ(folder.files(), 1) << "no half file stays behind";
}

TEST(TextFile, FullDeviceIsNamedAsFull) {
  TextFile file;
  file.text = "I1M400\n";
  const auto saved = save_text("/dev/full", file);
  ASSERT_FALSE(saved);
  EXPECT_THAT(saved.error().sentence(), HasSubstr("the disk is full"));
  EXPECT_THAT(saved.error().sentence(), HasSubstr("Free some space"));
  EXPECT_TRUE(std::filesystem::is_character_file("/dev/full")) << "a device is never replaced by a file";
}

TEST(TextFile, SavingKeepsLinkAndPermissions) {
  test::Folder folder;
  const auto path = folder.put("real.vxm", "old");
  ASSERT_EQ(::chmod(path.c_str(), 0640), 0);
  std::filesystem::create_symlink(path, folder.path() / "link.vxm");
  TextFile file;
  file.text = "new";
  ASSERT_TRUE(save_text(folder.path() / "link.vxm", file));
  EXPECT_TRUE(std::filesystem::is_symlink(folder.path() / "link.vxm"));
  EXPECT_EQ(folder.get("real.vxm"), "new");
  struct stat about {};
  ::stat(path.c_str(), &about);
  EXPECT_EQ(about.st_mode & 0777, 0640u);
}

TEST(TextFile, MissingFolderIsReported) {
  test::Folder folder;
  TextFile file;
  const auto saved = save_text(folder.path() / "no" / "such" / "a.vxm", file);
  ASSERT_FALSE(saved);
  EXPECT_THAT(saved.error().sentence(), HasSubstr("there is no such folder"));
}

}  // namespace
}  // namespace hw
