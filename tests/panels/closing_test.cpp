// What becomes of the user's work when a controller or the window is closed, and of what comes while
// something is being asked.
#include <chrono>
#include <thread>

#include <gmock/gmock.h>

#include "core/session/last_end.h"
#include "gui/model/worker.h"
#include "tests/core/session/folder.h"
#include "tests/panels/console_stage.h"
#include "tests/panels/full_catalog.h"

namespace hw::panels {
namespace {

using ::testing::HasSubstr;

struct Closing : testing::Test {
  test::Folder folder;
  UserFolders folders = UserFolders::below(folder.path());
  Autosave autosave{folders};
  ConsoleStage s{1440, 900, 1, true, folders};

  void click(const char* id) {
    const auto done = s.hand.click(id);
    EXPECT_TRUE(done) << id << ": " << done.error().sentence();
    s.run(0.1);
  }
  void close_controller() {
    click("menu");
    click("menu/close");
  }
  Example& with_a_list() {
    Example& e = s.add(test::full_catalog());
    s.run(0.1);
    click("tab/list");
    click("list/add");
    return e;
  }
  /// As drivers leave it: what it does now is not known any more.
  void lose(Example& e) {
    e.now.link.when_lost = e.now.shows_under_way();
    e.now.link.state = LinkState::lost;
    for (AxisState& a : e.now.axes) a.activity = Activity::unknown;
    e.now.program = ProgramState();
    s.run(0.1);
  }
  /// At the next start.
  [[nodiscard]] std::string shown_at_next_start() const {
    std::string all;
    const auto ends = LastEnds(folders).take();
    for (const LastEnd& end : ends.value_or(std::vector<LastEnd>()))
      all += end.sentence(date_of_today()).substr(std::string_view("At 14:02:11 ").size());
    return all;
  }
  [[nodiscard]] std::string kept(const char* key) const {
    const auto texts = autosave.restore(key);
    return texts && !texts->empty() ? texts->front().text : "";
  }
};

TEST_F(Closing, TextTypedJustBeforeIsKept) {
  Example& e = s.add();
  ASSERT_TRUE(e.tab->desk().kept.begin(autosave, "stage"));
  s.run(0.1);
  e.tab->desk().programs.texts.set_text(0, "I1M400");
  s.run(0.1);
  EXPECT_EQ(kept("stage"), "") << "it is too new";
  s.console.close(*e.tab);
  EXPECT_EQ(kept("stage"), "I1M400");
}

TEST_F(Closing, TextEmptiedJustBeforeDoesNotComeBack) {
  Example& e = s.add();
  ASSERT_TRUE(e.tab->desk().kept.begin(autosave, "stage"));
  e.tab->desk().programs.texts.set_text(0, "I1M400");
  s.run(1.5);
  ASSERT_EQ(kept("stage"), "I1M400");
  e.tab->desk().programs.texts.set_text(0, "");
  s.console.close(*e.tab);
  EXPECT_EQ(kept("stage"), "");
}

TEST(WorkerEnd, FinishWaitsForWhatIsStillToBeWritten) {
  gui::Worker worker({}, true);
  const auto alive = std::make_shared<int>(0);
  std::atomic<int> written = 0;
  for (int i = 0; i < 3; ++i)
    worker.run(
        [&written] {
          std::this_thread::sleep_for(std::chrono::milliseconds(20));
          return ++written;
        },
        [](int) {}, alive);
  worker.finish();
  EXPECT_EQ(written, 3);
}

TEST_F(Closing, AListThatIsInNoFileIsAskedAbout) {
  with_a_list();
  close_controller();
  ASSERT_EQ(s.console.tabs().size(), 1u);
  click("close/cancel");
  close_controller();
  click("close/lose");
  EXPECT_TRUE(s.console.tabs().empty());
}

TEST_F(Closing, MotionAndAnUnsavedListAreOneQuestion) {
  Example& e = with_a_list();
  e.now.axes[0].activity = Activity::moving;
  s.run(0.1);
  close_controller();
  EXPECT_FALSE(s.stage.find("close/lose"));
  click("close/leave");
  EXPECT_TRUE(s.console.tabs().empty());
}

TEST_F(Closing, TheWindowAsksAboutAListToo) {
  s.add();
  EXPECT_TRUE(s.console.dialogs.may_end(s.console)) << "there is nothing to lose";
  with_a_list();
  s.console.activate(*s.console.tabs().front());
  EXPECT_FALSE(s.console.dialogs.may_end(s.console));
  s.run(0.1);
  click("close/cancel");
  EXPECT_FALSE(s.console.ended());
  EXPECT_FALSE(s.console.dialogs.may_end(s.console));
  s.run(0.1);
  click("close/lose");
  EXPECT_TRUE(s.console.ended());
  EXPECT_EQ(s.console.tabs().size(), 2u) << "they are left in order by whoever ends the window";
}

// ---- what moves or runs

struct ClosingWhatMoves : Closing {
  Example& moving = s.add();
  Example& resting = s.add();

  ClosingWhatMoves() {
    moving.tab->settings.default_name = "Stage", resting.tab->settings.default_name = "Table";
    moving.now.axes[0].activity = Activity::moving;
    s.console.activate(*moving.tab);
    s.run(0.1);
  }
  void key(const char* keys) {
    EXPECT_TRUE(s.hand.key(keys));
    s.run(0.1);
  }
  bool window_may_close() {
    const bool may = s.console.dialogs.may_end(s.console);
    s.run(0.1);
    return may;
  }
};

TEST_F(ClosingWhatMoves, TheWindowNamesEachThatMovesOrRuns) {
  resting.now.program.owned = true, resting.now.program.run = RunState::running;
  resting.now.program.slot = 2;
  s.run(0.1);
  EXPECT_FALSE(window_may_close());
  EXPECT_EQ(s.value("close/why"),
            "Stage: axis 1 is moving. Table: Program 2 is running. After closing, this console no longer "
            "watches them.");
  click("close/stop");
  EXPECT_TRUE(s.console.ended());
  EXPECT_EQ(moving.count<intent::Stop>(), 1);
  EXPECT_EQ(resting.count<intent::Stop>(), 1);
}

TEST_F(ClosingWhatMoves, EnterStays) {
  EXPECT_FALSE(window_may_close());
  key("Enter");
  EXPECT_FALSE(s.console.dialogs.open());
  EXPECT_FALSE(s.console.ended());
  EXPECT_EQ(moving.count<intent::Stop>(), 0);
  EXPECT_FALSE(window_may_close()) << "and it is asked again";
}

TEST_F(ClosingWhatMoves, AskedAgainWhileItIsAskedStopsAndCloses) {
  EXPECT_FALSE(window_may_close());
  EXPECT_TRUE(window_may_close());
  EXPECT_EQ(moving.count<intent::Stop>(), 1);
  EXPECT_EQ(resting.count<intent::Stop>(), 0) << "it did nothing";
}

TEST_F(ClosingWhatMoves, LetItRunStopsNothing) {
  EXPECT_FALSE(window_may_close());
  click("close/leave");
  EXPECT_TRUE(s.console.ended());
  EXPECT_EQ(moving.count<intent::Stop>(), 0);
}

TEST_F(ClosingWhatMoves, CtrlWAsksAboutTheTabAndAgainStopsAndClosesIt) {
  key("Ctrl+W");
  ASSERT_TRUE(s.stage.find("close/cancel"));
  EXPECT_EQ(moving.count<intent::Stop>(), 0);
  key("Ctrl+W");
  EXPECT_EQ(moving.count<intent::Stop>(), 1);
  EXPECT_EQ(s.console.tabs().size(), 1u);
  key("Ctrl+W");
  EXPECT_TRUE(s.console.tabs().empty()) << "the other does nothing: it is not asked about";
}

TEST_F(ClosingWhatMoves, AnAxisThatComesToRestMovesNoButton) {
  resting.now.axes[0].activity = Activity::moving;
  s.run(0.1);
  EXPECT_FALSE(window_may_close());
  const auto before = s.stage.find("close/stop")->rect;
  moving.now.axes[0].activity = resting.now.axes[0].activity = Activity::idle;
  s.run(0.1);
  EXPECT_EQ(s.value("close/why"), "Nothing is moving now.");
  const auto after = s.stage.find("close/stop")->rect;
  EXPECT_EQ(before.min.x, after.min.x);
  EXPECT_EQ(before.min.y, after.min.y);
}

TEST_F(ClosingWhatMoves, UnsavedWorkIsNamedInTheSameQuestion) {
  with_a_list();
  EXPECT_FALSE(window_may_close());
  EXPECT_THAT(s.value("close/why"), HasSubstr("Stage: axis 1 is moving."));
  EXPECT_THAT(s.value("close/why"), HasSubstr("Closing loses it."));
}

// ---- what moved or ran when the link was lost

TEST_F(ClosingWhatMoves, OfWhatWasLostTheTabIsAskedAboutToo) {
  lose(moving);
  key("Ctrl+W");
  EXPECT_EQ(s.value("close/why"),
            "Axis 1 was moving when the link was lost. A stop cannot reach it now: use its power switch.");
  key("Enter");
  EXPECT_EQ(s.console.tabs().size(), 2u) << "Enter stays";
  EXPECT_EQ(shown_at_next_start(), "");
  key("Ctrl+W");
  click("close/leave");
  EXPECT_EQ(s.console.tabs().size(), 1u);
  EXPECT_EQ(moving.count<intent::Stop>(), 0);
  EXPECT_EQ(shown_at_next_start(),
            "the session was ended (Stage was closed). Stage: axis 1 was moving; no stop could be sent, "
            "because there was no link. It may still be moving: check it first.");
}

TEST_F(ClosingWhatMoves, OfWhatWasLostTheWindowAsksToo) {
  resting.now.program.owned = true, resting.now.program.run = RunState::running;
  resting.now.program.slot = 2;
  lose(resting);
  EXPECT_FALSE(window_may_close());
  EXPECT_EQ(s.value("close/why"),
            "Stage: axis 1 is moving. Table: Program 2 was running when the link was lost. After closing, "
            "this console no longer watches it. A stop cannot reach Table now: use its power switch.");
  EXPECT_TRUE(window_may_close()) << "asked again, it stops what it can and closes";
  EXPECT_EQ(moving.count<intent::Stop>(), 1);
  EXPECT_THAT(shown_at_next_start(), testing::StartsWith("the session was ended (the window was closed). "
                                                         "Table: Program 2 was running; no stop could"));
}

TEST_F(ClosingWhatMoves, AMotionAtALossIsAskedAboutWhileReconnecting) {
  lose(moving);
  moving.now.link.state = LinkState::connecting;
  s.run(0.1);
  EXPECT_FALSE(window_may_close());
  EXPECT_THAT(s.value("close/why"), HasSubstr("axis 1 was moving when the link was lost"));
}

TEST_F(ClosingWhatMoves, AnAxisSeenAtRestAfterALossIsNotAskedAbout) {
  lose(moving);
  moving.now.link.state = LinkState::good;
  moving.now.link.when_lost = UnderWay();
  moving.now.axes[0].activity = Activity::idle;
  s.run(0.1);
  EXPECT_TRUE(window_may_close());
  EXPECT_EQ(shown_at_next_start(), "");
}

TEST_F(ClosingWhatMoves, AnAxisAtRestWhenTheLinkWasLostIsNotAskedAbout) {
  moving.now.axes[0].activity = Activity::idle;
  lose(moving);
  EXPECT_TRUE(window_may_close());
}

TEST_F(ClosingWhatMoves, AMotionLeftBehindByASignalIsReportedAtTheNextStart) {
  lose(moving);
  s.console.shut_down("SIGTERM");
  EXPECT_EQ(shown_at_next_start(),
            "the session was ended (SIGTERM). Stage: axis 1 was moving; no stop could be sent, because there "
            "was no link. It may still be moving: check it first.");
}

TEST_F(Closing, OfABusItIsReportedWhichMembersWereLost) {
  for (const char* id : {"01", "02"}) {
    Catalog c = example_catalog(1);
    c.axes[0].name = id, c.address = id[1] - '0';
    s.add(std::move(c)).now.axes[0].activity = Activity::moving;
  }
  s.console.join({s.examples[0].tab, s.examples[1].tab}, "Line");
  lose(s.examples[1]);
  close_controller();
  EXPECT_EQ(s.value("close/why"), std::string(s.examples[0].tab->id()) + " moves. " +
                                      std::string(s.examples[1].tab->id()) +
                                      " was under way when the link was lost. After closing, this console no "
                                      "longer watches it. A stop cannot reach " +
                                      std::string(s.examples[1].tab->id()) + " now: use its power switch.");
}

// ---- a session that ends by itself

TEST(Departing, TheEndingOfASessionIsReportedOnceAtTheNextStart) {
  test::Folder folder;
  IoContext io{1};
  VirtualScheduler scheduler{io};
  gui::Outside outside(scheduler, WireOpener(), [] {});
  outside.folders = UserFolders::below(folder.path());
  ConsoleStage s;
  Example& moving = s.add();
  moving.now.axes[0].activity = Activity::moving;
  s.run(0.1);
  gui::Console& console = s.console;
  console.shut_down("SIGTERM");
  EXPECT_EQ(moving.count<intent::Stop>(), 1);
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "state" / "last-end.json"))
      << "headless keeps nothing";

  const LastEnds ends(outside.folders);
  LastEnd end{date_of_today(), "14:02:11", "SIGTERM", {}};
  end.controllers = {{"PMX table", "axis X was moving", LastEnd::Outcome::at_rest}};
  ASSERT_TRUE(ends.keep(end));
  gui::Console next(panel_list(), outside);
  ASSERT_EQ(next.toasts().list().size(), 1u);
  EXPECT_EQ(next.toasts().list()[0].text,
            "At 14:02:11 the session was ended (SIGTERM). PMX table: axis X was moving; it was stopped, and "
            "confirmed at rest.");
  next.toasts().tick(0);
  next.toasts().tick(3600);
  EXPECT_EQ(next.toasts().list().size(), 1u) << "until it has been read";
  gui::Console later(panel_list(), outside);
  EXPECT_TRUE(later.toasts().list().empty());
}

TEST_F(Closing, AFileDroppedOntoAQuestionIsNotOpened) {
  Example& e = s.add();
  e.tab->desk().programs.texts.set_text(0, "I1M400");
  s.run(0.1);
  const std::vector<std::string> files = {folder.put("a.txt", "I1M5\n").string()};
  click("menu");
  click("menu/names");
  s.console.drop(files);
  s.run(0.1);
  EXPECT_TRUE(s.stage.find("names/cancel")) << "and the question stays";
  click("names/cancel");
  EXPECT_EQ(e.tab->desk().programs.texts.text(0), "I1M400");
  ASSERT_FALSE(s.console.toasts().list().empty());
  EXPECT_THAT(s.console.toasts().list().back().text, HasSubstr("Nothing was opened"));
  e.tab->desk().programs.texts.set_text(0, "");
  s.console.drop(files);
  s.run(0.1);
  EXPECT_EQ(e.tab->desk().programs.texts.text(0), "I1M5\n");
}

}  // namespace
}  // namespace hw::panels
