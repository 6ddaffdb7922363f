#include "gui/model/command_help.h"

#include <atomic>
#include <thread>

#include <gmock/gmock.h>

#include "gui/model/worker.h"
#include "tests/gui/model/toy_language.h"

namespace hw::gui {
namespace {

using ::testing::HasSubstr;

struct CommandHelpTest : ::testing::Test {
  std::string hint(const char* line) { return help.hint(line).sentence; }
  Catalog catalog = test::toy_catalog();
  CommandHelp help{catalog};
};

TEST_F(CommandHelpTest, ShowsWhatEnterWouldDo) {
  EXPECT_EQ(hint("S1M500"), "speed of motor m. Stored in the program, moves nothing now");
  EXPECT_EQ(hint("S1M"), "speed of motor m. Stored in the program, moves nothing now") << "half typed";
  EXPECT_EQ(hint("R"), "run the program. Enter moves something now");
  EXPECT_TRUE(help.hint("R").moves);
  EXPECT_FALSE(help.hint("S1M500").moves);
}

TEST_F(CommandHelpTest, OneMovingCommandMakesTheLineMove) {
  EXPECT_TRUE(help.hint("R,S1M").moves);
  EXPECT_THAT(hint("I1M400,R"), HasSubstr("run the program. Enter moves something now"));
  EXPECT_THAT(hint("R,"), HasSubstr("may move"));
}

TEST_F(CommandHelpTest, AnUnknownCommandIsReportedAsSuch) {
  EXPECT_TRUE(help.hint("zzz").unknown);
  EXPECT_THAT(hint("zzz"), HasSubstr("no command of this controller begins this way"));
  EXPECT_TRUE(help.hint("r").unknown == false) << "rsm begins with r";
  EXPECT_TRUE(help.hint("S1M5x").unknown);
  EXPECT_EQ(hint(""), "");
}

TEST_F(CommandHelpTest, LettersOfAFormAreLettersUnlessTheExampleHasDigits) {
  EXPECT_EQ(hint("rsm"), "store all");
  EXPECT_TRUE(help.hint("rs1").unknown);
  EXPECT_EQ(hint("setM2M"), "set the type of motor m");
}

TEST_F(CommandHelpTest, TabAddsWhatAllHaveInCommon) {
  EXPECT_EQ(help.complete("s"), "set");
  EXPECT_EQ(help.complete("setD"), "setDM");
  EXPECT_EQ(help.complete("I1M400,rs"), "I1M400,rsm");
  EXPECT_EQ(help.complete("zzz"), "zzz");
  EXPECT_EQ(help.with("I1M400,se", 5), "I1M400,setDM");
}

TEST(Worker, RunsBesideAndHandsOver) {
  std::atomic<int> woken = 0;
  int result = 0;
  const auto alive = std::make_shared<int>(0);
  {
    Worker worker([&] { ++woken; }, true);
    worker.run([] { return 42; }, [&](int value) { result = value; }, alive);
    while (!worker.deliver()) std::this_thread::yield();
    EXPECT_EQ(result, 42);
    EXPECT_FALSE(worker.deliver()) << "nothing is left";
  }
  EXPECT_GE(woken, 1);
}

TEST(Worker, FinishesFilesAtTheEndAndDropsResultsOfTheGone) {
  std::atomic<bool> ran = false;
  bool reported = false;
  {
    Worker worker({}, true);
    auto gone = std::make_shared<int>(0);
    worker.run([&] { return ran = true, 0; }, [&](int) { reported = true; }, gone);
    gone.reset();
  }
  EXPECT_TRUE(ran);
  EXPECT_FALSE(reported);
}

}  // namespace
}  // namespace hw::gui
