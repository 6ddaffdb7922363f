// What is told of ends, losses and doubts, and in which words.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "gui/model/ending_words.h"

namespace hw::gui {
namespace {

using std::chrono::seconds;
using testing::HasSubstr;

Catalog two_axes() {
  Catalog c;
  c.axes.resize(2);
  c.axes[0].name = "X", c.axes[1].name = "Y";
  c.program.slot_word = "Program";
  return c;
}
const Catalog catalog = two_axes();
std::string in_mm(AxisId, Steps place) { return std::to_string(place.value / 100) + " mm"; }

std::string words(const Ending& e) {
  const LoggedEvent event = event_of(e, catalog, in_mm);
  return event.subject + " " + event.words;
}

Ending motion(EndedBy by, StoppedBy stopped_by = StoppedBy::unknown) {
  Ending e;
  e.axis = 1;
  e.began = Instant{seconds(2)}, e.at = Instant{seconds(9)};
  e.by = by, e.stopped_by = stopped_by;
  e.place_known = true, e.place = Steps(8500);
  return e;
}

TEST(EndingWords, ShowHowAMotionEndedAndWhere) {
  EXPECT_EQ(words(motion(EndedBy::target)), "Y reached its target, at 85 mm");
  EXPECT_EQ(words(motion(EndedBy::stop, StoppedBy::key)), "Y motion stopped by Esc, at 85 mm");
  EXPECT_EQ(words(motion(EndedBy::abort, StoppedBy::script)),
            "Y motion stopped at once, without a ramp, by the script, at 85 mm");
  EXPECT_EQ(words(motion(EndedBy::elsewhere)),
            "Y motion was cut short by another host or at the controller, at 85 mm");
  EXPECT_DOUBLE_EQ(event_of(motion(EndedBy::target), catalog, in_mm).took_s, 7);
}

Ending of_run(Ending e, double at) {
  e.of_run = e.beside_program = true;
  e.at = Instant(from_seconds(at));
  return e;
}
Ending program(EndedBy by, double at, StoppedBy stopped_by = StoppedBy::unknown) {
  Ending e;
  e.what = Ending::What::program;
  e.slot = 2;
  e.began = Instant{seconds(1)}, e.at = Instant(from_seconds(at));
  e.by = by, e.stopped_by = stopped_by;
  return e;
}
/// All lines, oldest first.
std::string reported(std::initializer_list<Ending> endings) {
  EventLog log;
  for (const Ending& ending : endings) log.add(ending, catalog, in_mm);
  std::string all;
  for (const LoggedEvent& event : log.list())
    all += (all.empty() ? "" : " | ") + event.subject + " " + event.words;
  return all;
}

TEST(OneThingIsOneLine, AProgramAndTheMotionThatAStopEndsWithIt) {
  Ending y = of_run(motion(EndedBy::stop, StoppedBy::key), 9);
  y.timed = true;
  y.to_rest = Millis(84), y.ran_on = Steps(100);
  constexpr const char* line = "Program 2 stopped by Esc; Y at rest 84 ms later, 1 mm on, at 85 mm";
  EXPECT_EQ(reported({y, program(EndedBy::stop, 9.2, StoppedBy::key)}), line);
  EXPECT_EQ(reported({program(EndedBy::stop, 8.5, StoppedBy::key), y}), line) << "it still slowed down";
  Ending x = y;
  x.axis = 0;
  EXPECT_EQ(reported({y, x, program(EndedBy::stop, 9.2, StoppedBy::key)}),
            std::string(line) + "; X at rest 84 ms later, 1 mm on, at 85 mm");
}

TEST(OneThingIsOneLine, AProgramThatALimitEnds) {
  Ending y = of_run(motion(EndedBy::limit), 9);
  y.limit_plus = true;
  Ending run = program(EndedBy::limit, 9.1);
  run.failed_axis = 1, run.error = AxisError::limit_plus;
  EXPECT_EQ(reported({y, run}), "Program 2 ended on a limit: Y hit its + limit, at 85 mm");
}

TEST(OneThingIsOneLine, NotAMotionThatEndedLongBeforeOrAsItWasMeant) {
  Ending y = of_run(motion(EndedBy::limit), 4);
  y.limit_plus = true;
  EXPECT_EQ(reported({y, program(EndedBy::target, 9)}),
            "Y motion ended on its + limit, at 85 mm | Program 2 ran to its end");
  EXPECT_EQ(reported({of_run(motion(EndedBy::target), 9), program(EndedBy::stop, 9, StoppedBy::key)}),
            "Y reached its target, at 85 mm | Program 2 stopped by Esc");
  EXPECT_EQ(reported({motion(EndedBy::stop, StoppedBy::key), program(EndedBy::stop, 9, StoppedBy::key)}),
            "Y motion stopped by Esc, at 85 mm | Program 2 stopped by Esc")
      << "it was no motion of the program";
}

TEST(OneThingIsOneLine, NotAMotionBesideAProgramThatRanToItsEnd) {
  Ending y = of_run(motion(EndedBy::limit), 6.5);
  y.limit_plus = true;
  EXPECT_EQ(reported({y, program(EndedBy::target, 9)}),
            "Y motion ended on its + limit, at 85 mm | Program 2 ran to its end");
}

TEST(OneThingIsOneLine, NotAMotionThatEndsLongAfterTheProgram) {
  const Ending y = of_run(motion(EndedBy::stop, StoppedBy::key), 9);
  EXPECT_EQ(reported({program(EndedBy::stop, 5, StoppedBy::key), y}),
            "Program 2 stopped by Esc | Y motion stopped by Esc, at 85 mm");
}

TEST(EndingWords, AnEndThatIsNotKnownIsNotShownAsGood) {
  const LoggedEvent event = event_of(motion(EndedBy::nothing), catalog, in_mm);
  EXPECT_EQ(event.mark, LoggedEvent::Mark::message);
  EXPECT_TRUE(is_shown(event, EventFilter::ends)) << "an end all the same";
}

TEST(EndingWords, NameTheLimitAndTheError) {
  Ending e = motion(EndedBy::limit);
  e.limit_plus = true;
  EXPECT_EQ(words(e), "Y motion ended on its + limit, at 85 mm");
  e.limit_minus = true;
  EXPECT_EQ(words(e), "Y motion ended on a limit, at 85 mm");
  e = motion(EndedBy::error);
  e.error = AxisError::alarm;
  EXPECT_EQ(words(e), "Y motion ended with an error: its driver gave an alarm, at 85 mm");
  e = motion(EndedBy::not_in_place);
  e.off = Steps(-300);
  EXPECT_EQ(words(e), "Y motion ended 3 mm from its command, at 85 mm");
}

TEST(EndingWords, NameWhatMayHaveCutItShortOrLostIt) {
  Ending e = motion(EndedBy::elsewhere);
  e.beside_program = true;
  EXPECT_EQ(words(e),
            "Y motion was cut short by the running program, by another host or at the controller, at 85 mm");
  e.beside_program = false, e.perhaps_limit = true;
  EXPECT_EQ(words(e),
            "Y motion was cut short by a limit switch, by another host or at the controller, at 85 mm");
  e = motion(EndedBy::lost);
  EXPECT_EQ(words(e), "Y motion ended unseen: the cause is not known, at 85 mm");
  e.lost_with = Doubt::power_cut;
  EXPECT_EQ(words(e), "Y motion ended unseen: its power was cut, at 85 mm");
  e = motion(EndedBy::limit);
  e.axis = -1, e.what = Ending::What::program, e.slot = 0, e.failed_axis = 0;
  e.error = AxisError::limit_plus;
  EXPECT_EQ(words(e), "Program 0 ended on a limit: X hit its + limit");
}

TEST(OneThingIsOneLine, AProgramThatAnotherHostCutsShort) {
  Ending y = of_run(motion(EndedBy::elsewhere), 9);
  y.beside_program = false;
  EXPECT_EQ(reported({y, program(EndedBy::elsewhere, 9.3)}),
            "Program 2 was cut short by another host or at the controller; Y stopped, at 85 mm");
  EXPECT_EQ(reported({y, program(EndedBy::target, 9.3)}),
            "Y motion was cut short by another host or at the controller, at 85 mm | "
            "Program 2 ran to its end");
}

TEST(EndingWords, ShowAStopsCourse) {
  Ending e = motion(EndedBy::stop, StoppedBy::key);
  e.timed = true, e.to_rest = Millis(84), e.ran_on = Steps(200);
  EXPECT_EQ(words(e), "Y motion stopped by Esc: at rest 84 ms later, 2 mm on, at 85 mm");
  e.to_slowing = Millis(31);
  EXPECT_EQ(words(e),
            "Y motion stopped by Esc: slowing down 31 ms later, at rest 84 ms later, 2 mm on, at 85 mm");
}

TEST(EndingWords, DistinguishAJogAHomingAndARun) {
  Ending e = motion(EndedBy::stop, StoppedBy::let_go);
  e.what = Ending::What::jog;
  EXPECT_EQ(words(e), "Y jog ended when its button was released, at 85 mm");
  e = motion(EndedBy::target);
  e.what = Ending::What::homing;
  e.place_known = false;
  EXPECT_EQ(words(e), "Y found home");
  Ending run;
  run.what = Ending::What::program, run.slot = 2, run.by = EndedBy::target;
  EXPECT_EQ(words(run), "Program 2 ran to its end");
  run.what = Ending::What::list, run.by = EndedBy::stop, run.stopped_by = StoppedBy::button;
  run.done = 4, run.total = 12;
  EXPECT_EQ(words(run), "List stopped by the Stop button after 4 of 12");
}

TEST(EndingWords, OfAProgramInErrorShowTheLineAndTheAxisAsFarAsTheyAreKnown) {
  Ending run;
  run.what = Ending::What::program, run.slot = 1, run.by = EndedBy::error;
  EXPECT_EQ(words(run), "Program 1 stopped with an error");
  run.line = 12;
  EXPECT_EQ(words(run), "Program 1 stopped with an error at line 12 of its stored code");
  run.failed_axis = 0, run.error = AxisError::limit_plus;
  EXPECT_EQ(words(run), "Program 1 stopped with an error at line 12 of its stored code: X hit its + limit");
}

class EventLogTest : public testing::Test {
 protected:
  Snapshot now;
  EventLog log;
  void SetUp() override {
    now.axis_count = 2;
    at(1, LinkState::good);
  }
  void at(int s, LinkState link) {
    now.at = Instant{seconds(s)};
    now.link.state = link;
    log.follow(now, catalog);
  }
  std::string text(EventFilter filter = EventFilter::all) { return log.text(filter, DayClock{}); }
};

TEST_F(EventLogTest, AxesThatOneCauseMakesDoubtfulAreOneEvent) {
  for (AxisState& axis : now.axes) axis.trust.doubt(Doubt::power_cut, Instant{seconds(2)});
  at(2, LinkState::good);
  EXPECT_EQ(text(), "00:00:02  X and Y cannot be trusted any more: its power was cut\n");
}

TEST_F(EventLogTest, AxesThatOneCauseMakesDoubtfulAtOtherTimesAreTwoEvents) {
  now.axes[0].trust.doubt(Doubt::power_cut, Instant{seconds(2)});
  now.axes[1].trust.doubt(Doubt::power_cut, Instant{seconds(5)});
  at(6, LinkState::good);
  EXPECT_EQ(text(),
            "00:00:05  Y cannot be trusted any more: its power was cut\n"
            "00:00:02  X cannot be trusted any more: its power was cut\n");
}

TEST_F(EventLogTest, ALinkThatGoesAndComesBackIsReportedOnceEach) {
  EXPECT_EQ(text(), "");
  at(2, LinkState::lost);
  at(3, LinkState::lost);
  at(4, LinkState::connecting);
  at(5, LinkState::good);
  at(6, LinkState::late);
  EXPECT_EQ(text(), "00:00:05  answers again (3.0 s)\n00:00:02  no reply any more: the link is lost\n");
  EXPECT_EQ(text(EventFilter::trouble), "00:00:02  no reply any more: the link is lost\n");
  EXPECT_EQ(text(EventFilter::ends), "");
}

TEST_F(EventLogTest, StepsThatAKillMayHaveLostAreReportedByItsMessageAlone) {
  now.axes[1].trust.doubt(Doubt::killed, Instant{seconds(2)});
  at(2, LinkState::good);
  EXPECT_EQ(text(), "");
}

TEST_F(EventLogTest, APlaceThatIsLostIsTroubleOfItsAxis) {
  now.axes[1].trust.doubt(Doubt::power_cut, Instant{seconds(2)});
  at(3, LinkState::good);
  at(4, LinkState::good);
  EXPECT_EQ(text(EventFilter::trouble), "00:00:02  Y cannot be trusted any more: its power was cut\n");
}

TEST_F(EventLogTest, TheOldestGo) {
  for (std::size_t i = 0; i < EventLog::capacity + 5; ++i)
    log.add({LoggedEvent::Mark::message, false, {}, {}, std::to_string(i), -1});
  EXPECT_EQ(log.list().size(), EventLog::capacity);
  EXPECT_EQ(log.list().front().words, "5");
}

}  // namespace
}  // namespace hw::gui
