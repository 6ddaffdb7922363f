// How a session ended is told once, in words.
#include "core/session/last_end.h"

#include <gmock/gmock.h>

#include "tests/core/session/folder.h"

namespace hw {
namespace {

using ::testing::HasSubstr;

LastEnd some_end() {
  LastEnd end{"2026-11-23", "14:02:11", "SIGTERM", {}};
  end.controllers = {{"PMX table", "axis X was moving", LastEnd::Outcome::at_rest}};
  return end;
}

TEST(LastEnds, AreTakenOnce) {
  test::Folder folder;
  const LastEnds ends(UserFolders::below(folder.path()));
  EXPECT_TRUE(ends.take()->empty());
  ASSERT_TRUE(ends.keep(some_end()));
  const auto taken = ends.take();
  ASSERT_EQ(taken->size(), 1u);
  EXPECT_EQ((*taken)[0], some_end());
  EXPECT_TRUE(ends.take()->empty());
}

TEST(LastEnds, AConfirmedEndReplacesTheOneWrittenFirst) {
  test::Folder folder;
  const LastEnds ends(UserFolders::below(folder.path()));
  LastEnd first = some_end(), other = some_end();
  first.controllers[0].outcome = LastEnd::Outcome::stop_sent;
  other.time = "14:02:12";
  ASSERT_TRUE(ends.keep(first) && ends.keep(other) && ends.keep(some_end()));
  const auto taken = ends.take();
  ASSERT_EQ(taken->size(), 2u);
  EXPECT_EQ((*taken)[1], some_end());
}

TEST(LastEnds, ADamagedFileIsPutAsideWithASentence) {
  test::Folder folder;
  const LastEnds ends(UserFolders::below(folder.path()));
  ASSERT_TRUE(ends.keep(some_end()));
  folder.put("state/last-end.json", "{\"ends\": [{\"date\": 5}]}");
  EXPECT_FALSE(ends.take());
  EXPECT_TRUE(ends.take()->empty());
}

TEST(LastEnds, HeadlessRunsWriteNone) {
  const LastEnds ends(UserFolders::none());
  EXPECT_TRUE(ends.keep(some_end()));
  EXPECT_TRUE(ends.take()->empty());
}

TEST(LastEnd, ReportsWhatIsKnown) {
  LastEnd end = some_end();
  EXPECT_EQ(end.sentence("2026-11-23"),
            "At 14:02:11 the session was ended (SIGTERM). PMX table: axis X was moving; it was stopped, and "
            "confirmed at rest.");
  EXPECT_TRUE(end.harmless());
  end.controllers.push_back({"Stage", "Program 2 was running", LastEnd::Outcome::stop_sent});
  EXPECT_FALSE(end.harmless());
  EXPECT_THAT(end.sentence("2026-11-24"), HasSubstr("On 2026-11-23 at 14:02:11"));
  EXPECT_THAT(end.sentence("2026-11-24"), HasSubstr("before it was seen at rest"));
}

}  // namespace
}  // namespace hw
