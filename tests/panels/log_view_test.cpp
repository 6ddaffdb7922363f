// The program's log in the place of the terminal.
#include "panels/log_view.h"

#include "core/base/log.h"
#include "panels/terminal.h"
#include "tests/panels/panel_stage.h"

namespace hw::panels {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

class LogViewTest : public ::testing::Test {
 protected:
  LogViewTest() {
    ::testing::internal::CaptureStderr();
    s.click("terminal/view/decisions");
  }
  ~LogViewTest() override {
    log::set_level("", log::Level::warning);
    ::testing::internal::GetCapturedStderr();
  }
  void write(std::string_view subject, log::Level level, std::string_view sentence) {
    log::subject(subject).add(level, sentence);
    s.console.log.follow();  // as the console does once a frame
    s.stage.frames(2);
  }
  Terminal panel;
  test::PanelStage s{panel, 704, 300};
};

TEST_F(LogViewTest, ShowsWhatToDoWhileItIsEmpty) {
  EXPECT_EQ(s.value("decisions/log"), "");
  EXPECT_FALSE(s.stage.find("terminal/log"));
  EXPECT_TRUE(s.stage.find("terminal/command")) << "the line is there in all lists";
}

TEST_F(LogViewTest, ShowsLinesOfOneSubjectOneLevelAndSomeWords) {
  write("link", log::Level::warning, "closed: pulled");
  write("pump", log::Level::error, "no thread");
  EXPECT_THAT(s.value("decisions/log"), HasSubstr("warning link: closed: pulled"));
  s.click("decisions/subject");
  s.click("decisions/subject/pump");
  EXPECT_THAT(s.value("decisions/log"), HasSubstr("error pump: no thread"));
  EXPECT_THAT(s.value("decisions/log"), Not(HasSubstr("pulled")));
  s.click("decisions/subject");
  s.click("decisions/subject/all");
  s.click("decisions/shown");
  s.click("decisions/shown/errors");
  EXPECT_THAT(s.value("decisions/log"), Not(HasSubstr("pulled")));
  s.click("decisions/shown");
  s.click("decisions/shown/all lines");
  s.type("decisions/words", "pulled");
  EXPECT_THAT(s.value("decisions/log"), HasSubstr("pulled"));
  EXPECT_THAT(s.value("decisions/log"), Not(HasSubstr("no thread")));
  s.click("decisions/copy");
  EXPECT_THAT(ImGui::GetClipboardText(), HasSubstr("warning link: closed: pulled\n"));
  EXPECT_THAT(s.toast(), HasSubstr("copied"));
}

TEST_F(LogViewTest, ChoosesHowMuchIsLogged) {
  s.click("decisions/subject");
  s.click("decisions/subject/driver");
  s.click("decisions/level");
  s.click("decisions/level/log all");
  EXPECT_TRUE(log::subject("driver.vxm").wants(log::Level::debug));
  EXPECT_FALSE(log::subject("link").wants(log::Level::debug));
  EXPECT_EQ(s.value("decisions/level"), "log all");
  write("driver.vxm", log::Level::debug, "refused: it moves");
  EXPECT_THAT(s.value("decisions/log"), HasSubstr("debug driver.vxm: refused: it moves"));
  s.click("decisions/subject");
  s.click("decisions/subject/all");
  EXPECT_EQ(s.value("decisions/level"), "log mixed");
  s.click("decisions/level");
  s.click("decisions/level/log nothing");
  EXPECT_FALSE(log::subject("driver.vxm").wants(log::Level::error)) << "everything is all of them";
}

TEST_F(LogViewTest, OnePartThatLogsMoreIsReportedOfItsFamily) {
  log::set_level("driver.vxm", log::Level::debug);
  s.stage.frames(2);
  EXPECT_EQ(s.value("decisions/level"), "log mixed") << "all of them";
  s.click("decisions/subject");
  s.click("decisions/subject/driver");
  EXPECT_EQ(s.value("decisions/level"), "log mixed");
  s.click("decisions/level");
  s.click("decisions/level/log mixed");
  EXPECT_TRUE(log::subject("driver.vxm").wants(log::Level::debug)) << "it is no choice";
  if (s.stage.find("decisions/level/log warnings") == nullptr) s.click("decisions/level");
  s.click("decisions/level/log warnings");
  EXPECT_FALSE(log::subject("driver.vxm").wants(log::Level::debug));
  EXPECT_EQ(s.value("decisions/level"), "log warnings");
}

TEST_F(LogViewTest, DrawsOnlyTheRowsThatAreSeen) {
  for (int i = 0; i < 500; ++i) log::subject("link").add(log::Level::warning, fmt::format("line {}.", i));
  write("link", log::Level::warning, "the newest");
  EXPECT_THAT(s.value("decisions/log"), HasSubstr("the newest"));
  EXPECT_THAT(s.value("decisions/log"), Not(HasSubstr("line 400.")));
}

TEST_F(LogViewTest, IsStillAtRest) {
  write("link", log::Level::warning, "closed: pulled");
  s.stage.frames(4);
  EXPECT_GT(s.stage.surface.screen().wake_in_s(), 10) << "a new line asks for its frame";
}

TEST_F(LogViewTest, LinesThatCameTooFastAreCounted) {
  for (int i = 0; i < 3000; ++i) log::subject("link").add(log::Level::warning, "many");
  s.console.log.follow();
  s.stage.frames(2);
  EXPECT_GT(s.console.log.lost(), 0u);
}

TEST_F(LogViewTest, IsReachedByTheMenuWhereThereIsNoRoomForATitle) {
  Terminal low;
  test::PanelStage small(low, 704, 116, 1, gui::Tier::medium);
  small.stage.frames(3);
  small.click("terminal/log_menu");
  small.click("terminal/log_menu/The program's log");
  small.click("terminal/log_menu");
  small.click("terminal/log_menu/Log all");
  EXPECT_TRUE(log::subject("link").wants(log::Level::debug));
  log::subject("link").add(log::Level::debug, "dropped");
  small.console.log.follow();
  small.stage.frames(2);
  EXPECT_THAT(small.value("decisions/log"), HasSubstr("debug link: dropped"));
  small.click("terminal/log_menu");
  small.click("terminal/log_menu/Copy");
  EXPECT_THAT(ImGui::GetClipboardText(), HasSubstr("dropped"));
  small.click("terminal/log_menu");
  small.click("terminal/log_menu/Log warnings");
  EXPECT_FALSE(log::subject("link").wants(log::Level::debug));
  small.click("terminal/log_menu");
  small.click("terminal/log_menu/The terminal");
  EXPECT_TRUE(small.stage.find("terminal/log"));
}

// The tools stay inside a window of 1024.
TEST_F(LogViewTest, ItsToolsFitIntoANarrowPlace) {
  for (const char* id :
       {"decisions/subject", "decisions/shown", "decisions/words", "decisions/level", "decisions/copy"}) {
    const gui::Widget* tool = s.stage.find(id);
    ASSERT_TRUE(tool) << id;
    EXPECT_LE(tool->rect.max.x, 704) << id;
  }
}

}  // namespace
}  // namespace hw::panels
