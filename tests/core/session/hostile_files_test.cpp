// Files that nobody writes in good faith: each reader refuses them with a sentence.
#include <functional>

#include <gmock/gmock.h>
#include <sys/stat.h>

#include "core/emulation/bench_file.h"
#include "core/sequence/sequence_file.h"
#include "core/session/autosave.h"
#include "core/session/kept_options.h"
#include "core/session/kept_positions.h"
#include "core/session/last_end.h"
#include "core/session/parameter_file.h"
#include "core/session/profile.h"
#include "core/session/recent.h"
#include "core/session/text_file.h"
#include "core/session/user_files.h"
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

TEST(HostileFiles, AnOrdinaryFileIsRead) {
  const auto read = parse_backup(
      "model = 'x' # [[[[ a.b.c\n[programs]\n0 = \"\"\"\n" + again("[.", 1000) + "\n\"\"\"\n", "p.toml");
  ASSERT_TRUE(read) << read.error().sentence();
  EXPECT_GE(read->programs.at(0).size(), 2000u);
}

TEST(HostileFiles, DeeplyNestedKeptFilesArePutAside) {
  const std::string deep = again("[", 500'000);
  for (const std::string& value : {deep, deep + again("]", 500'000), again("{\"a\":", 100'000)}) {
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

/// Every file that the console reads without asking, with `value` in the place of each of its words.
struct KeptKind {
  const char* name;
  std::string file;  ///< below the user's folders
  std::string (*with)(const std::string& value);
  std::string (*words)(const UserFolders& folders);  ///< all that would be shown; a fault's sentence
};

template <class T>
std::string sentence_or(const Result<T>& read, const std::string& words) {
  return read ? words : read.error().sentence();
}

std::vector<KeptKind> kept_kinds() {
  const std::string file = file_name_for("k") + ".json";
  return {
      {"profile", "config/profiles/" + file,
       [](const std::string& v) {
         return "{\"name\": " + v + ", \"bus_name\": " + v + ", \"unit\": " + v +
                ", \"axes\": [{\"name\": " + v + ", \"unit_choice\": " + v +
                ", \"own_unit\": {\"name\": " + v + ", \"per_step\": 1}}], \"places\": [{\"name\": " + v +
                ", \"at\": [[0, 1]]}]}";
       },
       [](const UserFolders& folders) {
         const auto read = ProfileStore(folders).load("k");
         if (!read) return read.error().sentence();
         const Profile& p = *read;
         return p.name + p.bus_name + p.unit + p.axes[0].name + p.axes[0].unit_choice +
                p.axes[0].own_unit.name + p.places.at(0).name;
       }},
      {"recent", "state/recent.json",
       [](const std::string& v) {
         return "{\"connections\": [{\"address\": " + v + ", \"name\": " + v + "}]}";
       },
       [](const UserFolders& folders) {
         RecentConnections recent(folders);
         const auto read = recent.load();
         return read ? recent.list().at(0).address + recent.list().at(0).name : read.error().sentence();
       }},
      {"last end", "state/last-end.json",
       [](const std::string& v) {
         return "{\"ends\": [{\"date\": " + v + ", \"time\": " + v + ", \"how\": " + v +
                ", \"controllers\": [{\"name\": " + v + ", \"what\": " + v + ", \"fate\": 1}]}]}";
       },
       [](const UserFolders& folders) {
         const auto read = LastEnds(folders).take();
         return read ? read->at(0).sentence("today") : read.error().sentence();
       }},
      {"positions", "state/positions/" + file,
       [](const std::string& v) {
         return "{\"axes\": [{\"position\": 5, \"trust\": " + v + ", \"doubt\": " + v + ", \"since\": 0}]}";
       },
       [](const UserFolders& folders) { return sentence_or(KeptPositions(folders).load("k", {}), ""); }},
      {"unsaved", "state/unsaved/" + file,
       [](const std::string& v) {
         return "{\"texts\": [{\"slot\": 0, \"text\": \"I1M1\", \"path\": \"\", \"name\": " + v + "}]}";
       },
       [](const UserFolders& folders) { return sentence_or(Autosave(folders).restore("k"), ""); }},
  };
}

TEST(HostileFiles, NoKeptNameActsOnTheScreenOrFillsIt) {
  for (const KeptKind& kind : kept_kinds())
    for (const std::string& value :
         {std::string("\"\\u001B[2J\\n\\u202E\\u0085\""), "\"" + std::string(10'000'000, 'x') + "\"",
          "\"" + again("\\n", 1000) + "\"", "\"\xFF\xFE\"" + std::string()}) {
      test::Folder folder;
      folder.put(kind.file, kind.with(value));
      const std::string words = kind.words(UserFolders::below(folder.path()));
      EXPECT_LT(words.size(), 40'000u) << kind.name;
      for (const char* acts : {"\x1B", "\n", "\u202E", "\u0085"})
        EXPECT_EQ(words.find(acts), std::string::npos) << kind.name << ": " << words.substr(0, 200);
    }
}

TEST(HostileFiles, NoKeptNumberIsBeyondReason) {
  test::Folder folder;
  const UserFolders folders = UserFolders::below(folder.path());
  const std::string file = file_name_for("k") + ".json";
  const std::string least = "-9223372036854775808", most = "9223372036854775807";
  folder.put("config/profiles/" + file, "{\"jog_step\": " + least +
                                            ", \"jog_speed\": 1e300, \"axes\": [{\"minus_limit\": " + least +
                                            ", \"plus_limit\": " + most + ", \"backlash\": " + most +
                                            ", \"own_unit\": {\"name\": \"mm\", \"per_step\": 1e-300}}], "
                                            "\"places\": [{\"name\": \"a\", \"at\": [[" +
                                            most + ", 1], [0, " + least + "]]}]}");
  folder.put("state/positions/" + file,
             "{\"axes\": [{\"position\": " + least +
                 ", \"trust\": \"homed\", \"doubt\": \"none\", \"since\": " + least + "}]}");
  const auto profile = ProfileStore(folders).load("k");
  ASSERT_TRUE(profile) << profile.error().sentence();
  constexpr Steps far(std::int64_t{1} << 53);
  EXPECT_GE(profile->jog_step, -far);
  EXPECT_EQ(profile->jog_speed, Pps()) << "the controller's own";
  EXPECT_GE(profile->axes[0].travel.minus, -far);
  EXPECT_LE(profile->axes[0].travel.plus, far);
  EXPECT_LE(profile->axes[0].backlash.by, far);
  EXPECT_EQ(profile->axes[0].own_unit.per_step, 0.0);
  ASSERT_EQ(profile->places.size(), 1u);
  EXPECT_EQ(profile->places[0].at, (std::vector<AxisTarget>{{AxisId{0}, -far}}));
  const auto positions = KeptPositions(folders).load("k", {});
  ASSERT_TRUE(positions);
  EXPECT_EQ(positions->at(0).position, -far);
}

// What is opened by name: the sentence names it, and does nothing else to the line that shows it.
TEST(HostileFiles, TheNameOfAFileStaysOnItsLine) {
  test::Folder folder;
  for (const std::string& name :
       {std::string("a\x1B[2J\nb"), std::string("\u202Egnp.exe"), std::string("\xFF\xFE"),
        std::string(250, 'x'), std::string(100'000, 'x'), std::string("a\rb")}) {
    const auto path = folder.path() / name;
    std::vector<std::string> sentence;
    if (const auto read = read_file(path, 100); !read) sentence.push_back(read.error().sentence());
    if (const auto read = load_text(path); !read) sentence.push_back(read.error().sentence());
    if (const auto read = load_backup(path); !read) sentence.push_back(read.error().sentence());
    if (const auto written = write_file(path / "a", "b"); !written)
      sentence.push_back(written.error().sentence());
    if (const auto read = decode_text(std::string(1, '\0'), name); !read)
      sentence.push_back(read.error().sentence());
    EXPECT_EQ(sentence.size(), 5u);
    for (const std::string& sentence : sentence) {
      EXPECT_LT(sentence.size(), 1500u) << sentence.substr(0, 200);
      for (const char* acts : {"\x1B", "\n", "\r", "\u202E", "\xFF"})
        EXPECT_EQ(sentence.find(acts), std::string::npos) << sentence.substr(0, 200);
    }
  }
}

mode_t mode_of(const std::filesystem::path& path) {
  struct stat about {};
  EXPECT_EQ(::stat(path.c_str(), &about), 0) << path;
  return about.st_mode & 0777;
}

/// Everything that the console keeps by itself.
void keep_everything(const UserFolders& folders) {
  ASSERT_TRUE(Autosave(folders).keep("k", {{0, "I1M400", ""}}));
  ASSERT_TRUE(ProfileStore(folders).save("k", Profile()));
  ASSERT_TRUE(KeptOptionsOfDrawings(folders).save("k", KeptOptions()));
  ASSERT_TRUE(KeptPositions(folders).save("k", {}, {}));
  ASSERT_TRUE(RecentConnections(folders).opened("vxm@emulator", "a"));
  ASSERT_TRUE(LastEnds(folders).keep(LastEnd()));
}

/// How many files and folders; each is for its owner only.
int expect_private(const UserFolders& folders) {
  int all = 0;
  for (const auto& top : {folders.config, folders.state})
    for (const auto& entry : std::filesystem::recursive_directory_iterator(top)) {
      EXPECT_EQ(mode_of(entry.path()), entry.is_directory() ? 0700u : 0600u) << entry.path();
      ++all;
    }
  return all;
}

TEST(KeptFiles, AreForTheirOwnerOnly) {
  test::Folder folder;
  const UserFolders folders = UserFolders::below(folder.path());
  ASSERT_NO_FATAL_FAILURE(keep_everything(folders));
  EXPECT_EQ(expect_private(folders), 6 + 4);
  EXPECT_EQ(mode_of(folders.config), 0700u);
  EXPECT_EQ(mode_of(folders.state), 0700u);
  for (const auto& top : {folders.config, folders.state})
    for (const auto& entry : std::filesystem::recursive_directory_iterator(top))
      ::chmod(entry.path().c_str(), entry.is_directory() ? 0755 : 0666);
  ASSERT_NO_FATAL_FAILURE(keep_everything(folders));
  expect_private(folders);
}

TEST(KeptFiles, FilesPutAsideAreForTheirOwnerOnlyToo) {
  for (const char* bytes : {"not json", "{\"version\": 99}"}) {
    test::Folder folder;
    const UserFolders folders = UserFolders::below(folder.path());
    const auto path = folder.put("state/unsaved/" + file_name_for("k") + ".json", bytes);
    ::chmod(path.c_str(), 0644);
    EXPECT_FALSE(Autosave(folders).restore("k"));
    EXPECT_FALSE(std::filesystem::exists(path));
    for (const auto& aside : std::filesystem::directory_iterator(path.parent_path()))
      EXPECT_EQ(mode_of(aside.path()), 0600u) << aside.path();
  }
}

TEST(KeptFiles, FilesOpenToOthersAreRestrictedWhenWritten) {
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
