// The console's list of log lines: what it takes, keeps and shows.
#include "gui/model/log_lines.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace hw::gui {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

class LogLinesTest : public ::testing::Test {
 protected:
  LogLinesTest() { ::testing::internal::CaptureStderr(); }
  ~LogLinesTest() override {
    log::set_level("", log::Level::warning);
    ::testing::internal::GetCapturedStderr();
  }
  void write(std::string_view subject, log::Level level, std::string_view sentence) {
    log::subject(subject).add(level, sentence);
    lines.follow();
  }
  [[nodiscard]] std::string shown() const {
    std::string text;
    lines.append_text(text, 0, lines.count());
    return text;
  }
  LogLines lines{nullptr};
};

TEST_F(LogLinesTest, ShowsTheNewestFirst) {
  write("link", log::Level::warning, "first");
  write("driver.vxm", log::Level::error, "second");
  ASSERT_EQ(lines.count(), 2u);
  EXPECT_EQ(lines.line(0).sentence, "second");
  EXPECT_THAT(shown(), ::testing::MatchesRegex(".* error driver.vxm: second\n.* warning link: first\n"));
}

TEST_F(LogLinesTest, AreChosenByFamilyLevelAndWords) {
  log::set_level("", log::Level::debug);
  write("link", log::Level::debug, "no reply to \"V\"");
  write("driver.vxm", log::Level::debug, "round failed");
  write("driver.vme58", log::Level::warning, "power was cut");
  lines.set_view({.family = "driver"});
  EXPECT_EQ(lines.count(), 2u);
  lines.set_view({.family = "driver", .least = log::Level::warning});
  EXPECT_THAT(shown(), HasSubstr("power was cut"));
  EXPECT_THAT(shown(), Not(HasSubstr("round failed")));
  lines.set_view({.words = "REPLY"});
  EXPECT_THAT(shown(), HasSubstr("no reply"));
  EXPECT_EQ(lines.count(), 1u);
  lines.set_view({.words = "vxm"});
  EXPECT_THAT(shown(), HasSubstr("round failed")) << "the subject counts too";
  write("driver.vxm", log::Level::debug, "refused");
  EXPECT_EQ(lines.count(), 2u) << "new lines are chosen likewise";
}

TEST_F(LogLinesTest, ChangeTheirVersionOnlyWithWhatIsShown) {
  write("link", log::Level::warning, "first");
  const auto before = lines.version();
  lines.follow();
  lines.set_view(lines.view());
  EXPECT_EQ(lines.version(), before);
  write("link", log::Level::warning, "second");
  EXPECT_NE(lines.version(), before);
}

TEST_F(LogLinesTest, KeepABoundedNumberOfLines) {
  for (std::size_t i = 0; i < LogLines::capacity + 10; ++i)
    write("link", log::Level::warning, fmt::format("line {}", i));
  EXPECT_EQ(lines.count(), LogLines::capacity);
  EXPECT_EQ(lines.line(0).sentence, fmt::format("line {}", LogLines::capacity + 9));
  EXPECT_EQ(lines.lost(), 0u);
}

TEST_F(LogLinesTest, KeepALineInOneRow) {
  write("link", log::Level::warning, "one\ntwo\x1b[31m");
  EXPECT_EQ(lines.line(0).sentence, "one two [31m");
}

}  // namespace
}  // namespace hw::gui
