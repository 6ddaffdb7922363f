#include "core/base/log.h"

#include <gmock/gmock.h>

#include "core/base/log_feed.h"
#include "core/base/log_levels.h"
#include "tests/core/session/folder.h"

namespace hw {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

// Levels are of the process: each test leaves them as it found them.
class Log : public ::testing::Test {
 protected:
  ~Log() override { log::set_level("", log::Level::warning); }
  /// What `act` writes on stderr.
  template <class Act>
  static std::string written(Act act) {
    ::testing::internal::CaptureStderr();
    act();
    return ::testing::internal::GetCapturedStderr();
  }
};

TEST_F(Log, LogsNothingBelowAWarningUnlessAsked) {
  log::Subject& link = log::subject("link");
  EXPECT_EQ(written([&] { link.debug("dropped {}", 7); }), "");
  EXPECT_THAT(written([&] { link.warning("dropped {}", 7); }), HasSubstr("warning link: dropped 7\n"));
}

TEST_F(Log, OpensTheSubjectThatIsChosenAndNoOther) {
  ASSERT_TRUE(log::choose("link=debug"));
  const std::string lines = written([] {
    log::subject("link").debug("{} is lost", "the wire");
    log::subject("pump").debug("refused");
  });
  EXPECT_THAT(lines, HasSubstr("debug link: the wire is lost\n"));
  EXPECT_THAT(lines, Not(HasSubstr("refused")));
}

TEST_F(Log, TakesAFamilyAndOneOfItApart) {
  ASSERT_TRUE(log::choose("driver=debug,driver.vxm=off"));
  EXPECT_TRUE(log::subject("driver.vme58").wants(log::Level::debug));
  EXPECT_FALSE(log::subject("driver.vxm").wants(log::Level::error));
  EXPECT_FALSE(log::subject("pump").wants(log::Level::debug));
}

TEST_F(Log, OpensSubjectsThatComeLater) {
  ASSERT_TRUE(log::choose("driver=debug"));
  EXPECT_TRUE(log::subject("driver.made-later").wants(log::Level::debug));
}

TEST_F(Log, OfEverythingIsOneWord) {
  ASSERT_TRUE(log::choose("debug"));
  EXPECT_TRUE(log::subject("gui").wants(log::Level::debug));
}

TEST_F(Log, AWrongChoiceShowsTheForm) {
  for (const char* wrong : {"", "lnik=debug", "link=loud", "link=", "=debug", "link=debug,", "link",
                            "link.vxm=debug", "driver.=debug"}) {
    const auto chosen = log::choose(wrong);
    ASSERT_FALSE(chosen) << wrong;
    EXPECT_THAT(chosen.error().sentence(), HasSubstr("Give SUBJECT=LEVEL"));
  }
}

TEST_F(Log, LevelOfAPathIsOfAllBelowIt) {
  log::set_level("driver.vxm", log::Level::debug);
  EXPECT_EQ(log::subject("driver").level(), log::Level::warning);
  log::set_level("driver", log::Level::info);
  EXPECT_EQ(log::subject("driver.vxm").level(), log::Level::info) << "its own level is replaced";
  EXPECT_EQ(log::subject("drivers").level(), log::Level::warning) << "another name that only begins so";
  log::set_level("", log::Level::error);
  EXPECT_EQ(log::subject("driver.vxm").level(), log::Level::error);
  EXPECT_EQ(log::subject("").level(), log::Level::error);
}

TEST_F(Log, TheLevelOfAFamilyIsShownOnlyWhileAllBelowItShareIt) {
  EXPECT_EQ(log::common_level("driver"), log::Level::warning);
  log::set_level("driver.never_opened", log::Level::debug);
  EXPECT_EQ(log::common_level("driver"), std::nullopt);
  EXPECT_EQ(log::common_level(""), std::nullopt) << "everything: the driver is a part of it";
  EXPECT_EQ(log::common_level("link"), log::Level::warning);
  log::set_level("driver", log::Level::info);
  EXPECT_EQ(log::common_level("driver"), log::Level::info);
  EXPECT_EQ(log::common_level("driver.never_opened"), log::Level::info);
  log::set_level("", log::Level::warning);
  EXPECT_EQ(log::common_level(""), log::Level::warning);
}

TEST_F(Log, EveryFamilyAndLevelThatIsOfferedCanBeChosen) {
  for (const std::string_view family : log::families())
    for (int level = 0; level <= static_cast<int>(log::Level::debug); ++level) {
      const auto word = log::word_of(static_cast<log::Level>(level));
      EXPECT_TRUE(log::choose(fmt::format("{}={}", family, word))) << family << " " << word;
      EXPECT_EQ(log::subject(family).level(), static_cast<log::Level>(level));
    }
}

TEST_F(Log, IsReadByAFeedWhileThatLives) {
  int woken = 0;
  log::Subject& link = log::subject("link");
  written([&] {
    link.warning("before");
    {
      log::Feed feed([&] { ++woken; });
      link.warning("lost {}", 7);
      link.debug("not wanted");
      std::vector<log::Line> read;
      EXPECT_EQ(feed.lines.drain([&](log::Line& line) { read.push_back(line); }), 1u);
      ASSERT_EQ(read.size(), 1u);
      EXPECT_EQ(read[0].subject, "link");
      EXPECT_EQ(read[0].sentence, "lost 7");
      EXPECT_EQ(read[0].level, log::Level::warning);
      EXPECT_THAT(read[0].time, ::testing::MatchesRegex("..:..:..[.]..."));
      for (std::size_t i = 0; i < feed.lines.capacity() + 3; ++i) link.warning("many");
      EXPECT_EQ(feed.lines.lost(), 3u);
      EXPECT_EQ(woken, static_cast<int>(feed.lines.capacity()) + 4);
    }
    link.warning("after");
  });
  EXPECT_EQ(woken, 1028);
}

// Formatting is what costs: a value of this type counts how often that happens.
struct Counted {
  int& times;
};

}  // namespace
}  // namespace hw

template <>
struct fmt::formatter<hw::Counted> {
  constexpr auto parse(format_parse_context& context) { return context.begin(); }
  auto format(const hw::Counted& value, format_context& context) const {
    ++value.times;
    return context.out();
  }
};

namespace hw {
namespace {

TEST_F(Log, FormatsNothingBelowTheLevel) {
  int times = 0;
  const Counted value{times};
  log::subject("link").debug("{}", value);
  EXPECT_EQ(times, 0);
  ASSERT_TRUE(log::choose("link=debug"));
  written([&] { log::subject("link").debug("{}", value); });
  EXPECT_EQ(times, 1);
}

TEST_F(Log, WritesBytesSoThatTheyCanBeRead) {
  EXPECT_EQ(fmt::format("{}", log::Bytes{"PM-1\r\n\x06\\"}), "PM-1\\r\\n\\x06\\\\");
  EXPECT_EQ(fmt::format("{}", log::Bytes{std::string(230, 'x')}), std::string(200, 'x') + " and 30 bytes");
}

TEST_F(Log, IsKeptInAFileThatIsTurnedOver) {
  const test::Folder folder;
  ASSERT_TRUE(log::keep_in(folder.path() / "handwheel.log"));
  log::Subject& pump = log::subject("pump");
  const std::string line(100'000, 'x');
  written([&] {
    pump.warning("first");
    for (int i = 0; i < 60; ++i) pump.warning("{}", line);
    pump.warning("last");
  });
  EXPECT_THAT(folder.get("handwheel.log"), HasSubstr("warning pump: last\n"));
  EXPECT_EQ(folder.files(), 4) << "the newest and three older ones";
  for (const auto& entry : std::filesystem::directory_iterator(folder.path())) {
    EXPECT_LE(std::filesystem::file_size(entry), 1'000'000u) << entry.path();
    EXPECT_EQ(entry.status().permissions(),
              std::filesystem::perms::owner_read | std::filesystem::perms::owner_write)
        << entry.path();
  }

  ASSERT_TRUE(log::keep_in("/dev/null"));
}

TEST_F(Log, ThatCannotBeKeptReportsWhy) {
  const test::Folder folder;
  const auto kept = log::keep_in(folder.put("a file", "") / "handwheel.log");
  ASSERT_FALSE(kept);
  EXPECT_THAT(kept.error().sentence(), HasSubstr("The log cannot be kept in"));
}

}  // namespace
}  // namespace hw
