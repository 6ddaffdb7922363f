// Files that nobody writes in good faith: each reader refuses them with a sentence.
#include <functional>

#include <gmock/gmock.h>
#include <sys/stat.h>

#include "core/device/bench_file.h"
#include "core/sequence/sequence_file.h"
#include "core/session/autosave.h"
#include "core/session/kept_options.h"
#include "core/session/kept_positions.h"
#include "core/session/parameter_file.h"
#include "core/session/profile.h"
#include "core/session/recent.h"
#include "tests/core/session/folder.h"

namespace hw {
namespace {

using ::testing::HasSubstr;

std::string again(std::string_view part, int times) {
  std::string all;
  for (int i = 0; i < times; ++i) all += part;
  return all;
}

std::vector<std::string> hostile_toml() {
  constexpr int many = 100'000;
  return {
      "[" + again("a.", many) + "a]\n",                             // a table in a table ...
      again("a.", many) + "a = 1\n",                                // ... by a name
      "a = " + again("[", many) + again("]", many) + "\n",          // arrays
      "a = " + again("{a=", many) + "1" + again("}", many) + "\n",  // tables in one line
      "a = [\"\"\"x\"\"\"\", {" + again("b.", many) + "b = 1}]\n",  // behind a string that ends in four
      "a = \"\"\"\n\"\"\"\n[" + again("'b'.", many) + "b]\n",       // names in quotation marks
      "a = \"" + std::string(10'000'000, 'x') + "\"\n",             // a line of 10 MB
      "\"" + std::string(5000, 'n') + "\" = 1\n",                   // a name that fills a screen
      "\"\\u001B[2J\" = 1\n",                                       // one that clears it
  };
}

using Refusal = std::optional<Fault>;

void expect_refused(const std::function<Refusal(const std::string&)>& read) {
  for (const std::string& text : hostile_toml()) {
    const Refusal why = read(text);
    ASSERT_TRUE(why) << text.substr(0, 40);
    EXPECT_LT(why->sentence().size(), 400u) << text.substr(0, 40);
    EXPECT_EQ(why->sentence().find('\x1B'), std::string::npos);
  }
}

template <class T>
Refusal refusal_of(const Result<T>& read) {
  return read ? Refusal() : Refusal(read.error());
}

TEST(HostileFiles, ASequenceIsRefused) {
  expect_refused([](const std::string& text) { return refusal_of(sequence::read_sequence(text, "s.toml")); });
}

TEST(HostileFiles, ABenchIsRefused) {
  const Catalog catalog;
  expect_refused(
      [&](const std::string& text) { return refusal_of(parse_bench_file(text, catalog, "b.toml")); });
}

TEST(HostileFiles, ABackupIsRefused) {
  expect_refused([](const std::string& text) { return refusal_of(parse_backup(text, "p.toml")); });
}

TEST(HostileFiles, TheLineIsNamed) {
  const auto read = parse_backup("model = \"x\"\n\n[" + again("a.", 100'000) + "a]\n", "p.toml");
  ASSERT_FALSE(read);
  EXPECT_THAT(read.error().sentence(), HasSubstr("line 3: a name has too many parts"));
}

TEST(HostileFiles, WhatIsOrdinaryIsRead) {
  const auto read = parse_backup(
      "model = 'x' # [[[[ a.b.c\n[programs]\n0 = \"\"\"\n" + again("[.", 1000) + "\n\"\"\"\n", "p.toml");
  ASSERT_TRUE(read) << read.error().sentence();
  EXPECT_GE(read->programs.at(0).size(), 2000u);
}

TEST(HostileFiles, WhatIsKeptAndNestedIsPutAside) {
  const std::string deep = again("[", 2'000'000);
  for (const std::string& value : {deep, deep + again("]", 2'000'000), again("{\"a\":", 100'000)}) {
    test::Folder folder;
    const UserFolders folders = UserFolders::below(folder.path());
    const std::string file = file_name_for("k") + ".json";
    for (const char* name : {"config/profiles/", "config/drawings/", "state/unsaved/", "state/positions/"})
      folder.put(name + file,
                 "{\"axes\": " + value + ", \"texts\": " + value + ", \"options\": " + value + "}");
    folder.put("state/recent.json", "{\"connections\": " + value + "}");
    EXPECT_FALSE(ProfileStore(folders).load("k"));
    EXPECT_FALSE(Autosave(folders).restore("k"));
    EXPECT_FALSE(KeptPositions(folders).load("k", {}));
    EXPECT_FALSE(KeptOptionsOfDrawings(folders).load("k"));
    RecentConnections recent(folders);
    const auto loaded = recent.load();
    ASSERT_FALSE(loaded);
    EXPECT_THAT(loaded.error().sentence(), HasSubstr("is damaged"));
  }
}

// A name that clears a screen, in what is read without asking.
TEST(HostileFiles, ANameOfKeptOptionsIsNoOptionAndStaysOutOfSentences) {
  test::Folder folder;
  const UserFolders folders = UserFolders::below(folder.path());
  const std::string file = file_name_for("k") + ".json";
  folder.put("config/drawings/" + file, "{\"options\": {\"\\u001B[2J\": []}}");
  const auto read = KeptOptionsOfDrawings(folders).load("k");
  ASSERT_FALSE(read);
  EXPECT_EQ(read.error().sentence().find('\x1B'), std::string::npos);
}

mode_t mode_of(const std::filesystem::path& path) {
  struct stat about {};
  EXPECT_EQ(::stat(path.c_str(), &about), 0) << path;
  return about.st_mode & 0777;
}

TEST(KeptFiles, AreForTheirOwnerOnly) {
  test::Folder folder;
  const UserFolders folders = UserFolders::below(folder.path());
  ASSERT_TRUE(Autosave(folders).keep("k", {{0, "I1M400", ""}}));
  ASSERT_TRUE(ProfileStore(folders).save("k", Profile()));
  ASSERT_TRUE(KeptOptionsOfDrawings(folders).save("k", KeptOptions()));
  const std::string file = file_name_for("k") + ".json";
  EXPECT_EQ(mode_of(folder.path() / "state/unsaved" / file), 0600u);
  EXPECT_EQ(mode_of(folder.path() / "config/profiles" / file), 0600u);
  EXPECT_EQ(mode_of(folder.path() / "config/drawings" / file), 0600u);
  for (const char* made : {"state", "state/unsaved", "config", "config/profiles", "config/drawings"})
    EXPECT_EQ(mode_of(folder.path() / made), 0700u) << made;
}

TEST(KeptFiles, WhatWasOpenToOthersIsClosedWhenItIsWritten) {
  test::Folder folder;
  const UserFolders folders = UserFolders::below(folder.path());
  const auto path = folder.put("state/unsaved/" + file_name_for("k") + ".json", "{}");
  ::chmod(path.c_str(), 0644);
  ::chmod(path.parent_path().c_str(), 0755);
  ASSERT_TRUE(Autosave(folders).keep("k", {{0, "I1M400", ""}}));
  EXPECT_EQ(mode_of(path), 0600u);
  EXPECT_EQ(mode_of(path.parent_path()), 0700u);
}

}  // namespace
}  // namespace hw
