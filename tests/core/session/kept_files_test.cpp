// Profiles, unsaved texts and last connections: what survives, and that a damaged file never blocks.
#include <gmock/gmock.h>

#include "core/session/autosave.h"
#include "core/session/profile.h"
#include "core/session/recent.h"
#include "tests/core/session/folder.h"

namespace hw {
namespace {

using ::testing::HasSubstr;

Profile stage() {
  Profile p;
  p.name = "VXM stage";
  p.bus_name = "Lift bus";
  p.unit = "mm";
  p.axes[0].name = "across";
  p.axes[0].unit_choice = "BiSlide E04";
  p.axes[1].reversed = true;
  p.axes[1].travel = {true, true, Steps(-20), Steps(4000), true};
  p.axes[2].travel.has_plus = true;
  p.axes[3].unit_choice = own_unit_choice;
  p.axes[3].own_unit = {"inch", 0.000125};
  p.axes[3].backlash = {Steps(60), Sign::minus};
  p.axes[3].jog_speed = Pps(120);
  p.places = {{"load", {{AxisId{0}, Steps(5)}, {AxisId{2}, Steps(-7)}}},
              {"u\u00e9 \"x\"", {{AxisId{1}, Steps(1)}}}};
  p.jog_step = Steps(40);
  p.jog_speed = Pps(800);
  return p;
}

TEST(Profile, ComesBackAsItWas) {
  test::Folder folder;
  const ProfileStore store(UserFolders::below(folder.path()));
  ASSERT_TRUE(store.save("usb-A10K2LQX", stage()));
  EXPECT_EQ(*store.load("usb-A10K2LQX"), stage());
  EXPECT_EQ(*store.load("usb-other"), Profile());
}

TEST(Profile, KeyIsTheAdapterThenThePathThenTheAddress) {
  Address serial;
  serial.model = "vxm", serial.transport = "serial", serial.where = "/dev/ttyS0";
  EXPECT_EQ(profile_key(serial, "A10K"), "usb-A10K");
  EXPECT_EQ(profile_key(serial, ""), "/dev/ttyS0");
  Address emulated;
  emulated.model = "vxm", emulated.transport = "emulator";
  EXPECT_EQ(profile_key(emulated, ""), "vxm@emulator");
}

TEST(Profile, DamagedFileIsPutAsideWithASentence) {
  for (const char* damage : {"{\"name\": ", "{\"name\": 5}", "[]", "{\"axes\": [3]}", ""}) {
    test::Folder folder;
    const ProfileStore store(UserFolders::below(folder.path()));
    const std::string file = "config/profiles/" + file_name_for("k") + ".json";
    folder.put(file, damage);
    const auto loaded = store.load("k");
    ASSERT_FALSE(loaded) << damage;
    EXPECT_THAT(loaded.error().sentence(), HasSubstr("is damaged"));
    EXPECT_THAT(loaded.error().sentence(), HasSubstr(".damaged, and a new file was started"));
    EXPECT_EQ(folder.get(file + ".damaged"), damage);
    EXPECT_TRUE(store.load("k")) << "the next start goes on";
    EXPECT_TRUE(store.save("k", stage()));
  }
}

TEST(Profile, OfBeforeThereWereVersionsIsRead) {
  test::Folder folder;
  const ProfileStore store(UserFolders::below(folder.path()));
  folder.put("config/profiles/" + file_name_for("k") + ".json",
             R"({"controller": "k", "name": "VXM stage", "unit": "mm", "axes": [{"name": "across"}]})");
  const auto loaded = store.load("k");
  ASSERT_TRUE(loaded);
  EXPECT_EQ(loaded->name, "VXM stage");
  EXPECT_EQ(loaded->axes[0].name, "across");
}

TEST(Profile, CarriesTheVersionOfItsForm) {
  test::Folder folder;
  ASSERT_TRUE(ProfileStore(UserFolders::below(folder.path())).save("k", stage()));
  EXPECT_THAT(folder.get("config/profiles/" + file_name_for("k") + ".json"), HasSubstr("\"version\": 1"));
}

TEST(Profile, OfANewerHandwheelIsKeptWhole) {
  test::Folder folder;
  const ProfileStore store(UserFolders::below(folder.path()));
  const std::string file = "config/profiles/" + file_name_for("k") + ".json";
  const std::string bytes = R"({"version": 2, "name": {"first": "VXM", "last": "stage"}})";
  folder.put(file, bytes);
  const auto loaded = store.load("k");
  ASSERT_FALSE(loaded);
  EXPECT_THAT(loaded.error().sentence(), HasSubstr("The file with the name and units"));
  EXPECT_THAT(loaded.error().sentence(), HasSubstr(".newer, and a new file was started"));
  ASSERT_TRUE(store.save("k", stage()));
  EXPECT_EQ(folder.get(file + ".newer"), bytes);
}

TEST(Autosave, UnsavedTextsComeBackAndGo) {
  test::Folder folder;
  const Autosave autosave(UserFolders::below(folder.path()));
  const std::vector<UnsavedText> texts = {{0, "I1M400\n; 45\xC2\xB0\n", "/tmp/a.vxm"}, {3, "", ""}};
  ASSERT_TRUE(autosave.keep("/dev/ttyUSB0", texts));
  EXPECT_EQ(*autosave.restore("/dev/ttyUSB0"), texts);
  EXPECT_TRUE(autosave.restore("/dev/ttyUSB1")->empty());
  ASSERT_TRUE(autosave.keep("/dev/ttyUSB0", {}));
  EXPECT_TRUE(autosave.restore("/dev/ttyUSB0")->empty());
  EXPECT_EQ(folder.files(), 0);
}

TEST(Autosave, TextsCarryAVersionAndOlderOnesComeBack) {
  test::Folder folder;
  const Autosave autosave(UserFolders::below(folder.path()));
  const std::string file = "state/unsaved/" + file_name_for("k") + ".json";
  folder.put(file, R"({"controller": "k", "texts": [{"slot": 2, "text": "I1M400", "path": ""}]})");
  const auto old = autosave.restore("k");
  ASSERT_TRUE(old);
  EXPECT_EQ(*old, (std::vector<UnsavedText>{{2, "I1M400", ""}}));
  ASSERT_TRUE(autosave.keep("k", *old));
  EXPECT_THAT(folder.get(file), HasSubstr("\"version\": 1"));
  EXPECT_EQ(*autosave.restore("k"), *old);
}

TEST(Autosave, DamagedFileIsPutAside) {
  test::Folder folder;
  const Autosave autosave(UserFolders::below(folder.path()));
  folder.put("state/unsaved/" + file_name_for("k") + ".json", "{\"texts\": [{\"slot\": \"x\"}]}");
  const auto restored = autosave.restore("k");
  ASSERT_FALSE(restored);
  EXPECT_THAT(restored.error().sentence(), HasSubstr("unsaved program texts is damaged"));
  EXPECT_TRUE(autosave.restore("k"));
}

TEST(Recent, NewestFirstWithoutDoubles) {
  test::Folder folder;
  RecentConnections recent(UserFolders::below(folder.path()));
  ASSERT_TRUE(recent.load());
  ASSERT_TRUE(recent.opened("vxm@emulator", "Bench"));
  ASSERT_TRUE(recent.opened("vxm@serial:/dev/ttyUSB0", ""));
  ASSERT_TRUE(recent.opened("vxm@emulator", ""));
  RecentConnections again(UserFolders::below(folder.path()));
  ASSERT_TRUE(again.load());
  const std::vector<RecentConnection> expected = {{"vxm@emulator", "Bench"}, {"vxm@serial:/dev/ttyUSB0", ""}};
  EXPECT_EQ(again.list(), expected);
  ASSERT_TRUE(again.remove("vxm@emulator"));
  ASSERT_TRUE(again.renamed("vxm@serial:/dev/ttyUSB0", "Stage"));
  EXPECT_EQ(again.list(), (std::vector<RecentConnection>{{"vxm@serial:/dev/ttyUSB0", "Stage"}}));
}

TEST(Recent, KeepsTheLastTwelve) {
  test::Folder folder;
  RecentConnections recent(UserFolders::below(folder.path()));
  for (int i = 0; i < 20; ++i) ASSERT_TRUE(recent.opened("vxm@tcp:h:" + std::to_string(i), ""));
  EXPECT_EQ(recent.list().size(), RecentConnections::capacity);
  EXPECT_EQ(recent.list().front().address, "vxm@tcp:h:19");
}

TEST(Recent, AConnectionClosedByHandIsNotReopenedWithTheOthers) {
  test::Folder folder;
  const UserFolders folders = UserFolders::below(folder.path());
  {
    RecentConnections first(folders);
    ASSERT_TRUE(first.opened("vxm@tcp:h:1", ""));
    ASSERT_TRUE(first.opened("vxm@tcp:h:2", ""));
    ASSERT_TRUE(first.closed("vxm@tcp:h:1"));
  }
  RecentConnections now(folders);
  ASSERT_TRUE(now.load());
  EXPECT_EQ(now.last_time(), std::vector<std::string>{"vxm@tcp:h:2"});
  EXPECT_EQ(now.list().size(), 2u) << "it stays among what was used before";
}

TEST(Recent, KnowsWhatTheLastRunHasOpened) {
  test::Folder folder;
  const UserFolders folders = UserFolders::below(folder.path());
  {
    RecentConnections first(folders);
    ASSERT_TRUE(first.opened("vxm@tcp:old:1", ""));
  }
  {
    RecentConnections second(folders);
    ASSERT_TRUE(second.load());
    ASSERT_TRUE(second.opened("vxm@emulator", ""));
    ASSERT_TRUE(second.opened("vxm@serial:/dev/ttyUSB0", ""));
    EXPECT_TRUE(second.is_of_last_time("vxm@tcp:old:1")) << "what is opened now is of this time";
    EXPECT_FALSE(second.is_of_last_time("vxm@emulator"));
  }
  {
    RecentConnections idle(folders);  // it opens nothing, and forgets nothing
    ASSERT_TRUE(idle.load());
    ASSERT_TRUE(idle.renamed("vxm@emulator", "Bench"));
  }
  RecentConnections now(folders);
  ASSERT_TRUE(now.load());
  const std::vector<std::string> both = {"vxm@serial:/dev/ttyUSB0", "vxm@emulator"};
  EXPECT_EQ(now.last_time(), both);
  ASSERT_TRUE(now.remove("vxm@emulator"));
  EXPECT_EQ(now.last_time(), std::vector<std::string>{"vxm@serial:/dev/ttyUSB0"});
}

TEST(Recent, KnowsWhenTheLastRunEnded) {
  test::Folder folder;
  const UserFolders folders = UserFolders::below(folder.path());
  const ClosingTime evening{"2026-11-27", "18:02"};
  {
    RecentConnections first(folders);
    ASSERT_TRUE(first.opened("vxm@tcp:h:1", ""));
    ASSERT_TRUE(first.ended(evening));
  }
  {
    RecentConnections idle(folders);  // it opens nothing: "last time" is still the run before
    ASSERT_TRUE(idle.load());
    EXPECT_EQ(idle.last_end(), evening);
    ASSERT_TRUE(idle.renamed("vxm@tcp:h:1", "Stage"));
    ASSERT_TRUE(idle.ended({"2026-11-28", "09:48"}));
  }
  RecentConnections broken_off(folders);
  ASSERT_TRUE(broken_off.load());
  EXPECT_EQ(broken_off.last_end(), evening);
  ASSERT_TRUE(broken_off.opened("vxm@tcp:h:2", ""));
  RecentConnections now(folders);
  ASSERT_TRUE(now.load());
  EXPECT_EQ(now.last_end(), ClosingTime()) << "nobody knows when it broke off";
  folder.put("state/recent.json", R"({"connections": [], "closed": 7})");
  EXPECT_FALSE(now.load());
}

TEST(Recent, DamagedFileIsPutAside) {
  test::Folder folder;
  folder.put("state/recent.json", "not json");
  RecentConnections recent(UserFolders::below(folder.path()));
  const auto loaded = recent.load();
  ASSERT_FALSE(loaded);
  EXPECT_THAT(loaded.error().sentence(), HasSubstr("the last connections is damaged"));
  EXPECT_TRUE(recent.opened("vxm@emulator", ""));
}

TEST(KeptFiles, HeadlessRunsTouchNothing) {
  const ProfileStore profiles(UserFolders::none());
  const Autosave autosave(UserFolders::none());
  RecentConnections recent(UserFolders::none());
  EXPECT_TRUE(profiles.save("k", stage()));
  EXPECT_EQ(*profiles.load("k"), Profile());
  EXPECT_TRUE(autosave.keep("k", {{0, "I1M1", ""}}));
  EXPECT_TRUE(autosave.restore("k")->empty());
  EXPECT_TRUE(recent.load());
  EXPECT_TRUE(recent.opened("vxm@emulator", ""));
}

TEST(KeptFiles, NamesOfFilesDiffer) {
  EXPECT_NE(file_name_for("/dev/ttyUSB0"), file_name_for("dev-ttyUSB0"));
  EXPECT_EQ(file_name_for("/dev/ttyUSB0").find('/'), std::string::npos);
  EXPECT_LT(file_name_for(std::string(500, 'x')).size(), 80u);
  EXPECT_NE(file_name_for("..").front(), '-');
}

}  // namespace
}  // namespace hw
