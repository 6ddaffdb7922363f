#include "gui/model/run_follower.h"

#include <gtest/gtest.h>

namespace hw::gui {
namespace {

/// One command a second, the last two twice: as a loop of two passes would run.
class Clockwork final : public Language {
 public:
  mutable std::vector<std::int64_t> begun_at;
  mutable int slot = -1;
  std::vector<RehearsedTurn> turns;
  [[nodiscard]] ProgramReport analyse(std::string_view text, int slot) const override {
    ProgramReport report;
    for (int i = 0; i < 3; ++i) {
      LineReport line;
      line.first_command = i, line.command_count = 1, line.slot = slot;
      report.lines.push_back(line);
      report.listing[slot].push_back(std::string(text.substr(0, 1)) + std::to_string(i));
    }
    return report;
  }
  [[nodiscard]] Result<Rehearsal> rehearse(std::string_view, const RehearseOptions& options) const override {
    begun_at.clear();
    slot = options.slot;
    for (int i = 0; i < options.from->now.axis_count; ++i)
      begun_at.push_back(options.from->now.axes[i].commanded().value);
    Rehearsal r;
    constexpr std::pair<double, int> run[] = {{0, 0}, {1, 1}, {2, 2}, {3, 1}, {4, 2}};
    for (const auto& [t, command] : run) r.events.push_back({t, "a command", options.slot, command});
    r.turns = turns;
    r.duration_s = 5;
    r.finished = true;
    return r;
  }
  [[nodiscard]] Result<SequenceText> write(const sequence::Sequence&, const Catalog&) const override {
    return SequenceText();
  }
  [[nodiscard]] Result<SequenceRead> read(std::string_view, const sequence::Sequence&,
                                          const Catalog&) const override {
    return fail(FaultKind::text, "Line 1: no block can represent this.");
  }
};

struct RunFollowerTest : testing::Test {
  Clockwork language;
  ProgramFacts facts;
  Worker worker;
  Snapshot now;
  ProgramTexts texts{slots(), &language};
  Catalog catalog;
  RunFollower follower{catalog};
  static ProgramFacts slots() {
    ProgramFacts f;
    f.slots = 2;
    return f;
  }
  static Instant at(double s) { return Instant(from_seconds(s)); }
  RunFollowerTest() {
    texts.loaded(1, "a\nb\nc\n", at(9));
    now.axis_count = 2;
    now.axes[1].position = Steps(-700);
    now.program.owned = true;
    now.program.slot = 1;
    now.program.command = -1;
    now.program.run = RunState::running;
    now.program.started_at = at(10);
    follower.follow(now, {}, at(10), texts, &language, worker);
    worker.deliver();
  }
  RunFollower::Place when(double s) {
    follower.follow(now, {}, at(s), texts, &language, worker);
    return follower.place();
  }
};

TEST_F(RunFollowerTest, ItIsRehearsedFromWhereTheAxesStood) {
  EXPECT_EQ(language.begun_at, (std::vector<std::int64_t>{0, -700}));
}

TEST_F(RunFollowerTest, WorksOutTheCommandAndItsPass) {
  const auto second = when(11.5);
  EXPECT_EQ(second.slot, 1);
  EXPECT_EQ(second.command, 1);
  EXPECT_EQ(second.pass, 1);
  EXPECT_EQ(second.passes, 2);
  EXPECT_NEAR(second.next_in_s, 0.5, 1e-6);
  EXPECT_NEAR(follower.left_s().value_or(-1), 3.5, 1e-6);
  const auto again = when(13.2);
  EXPECT_EQ(again.command, 1);
  EXPECT_EQ(again.pass, 2);
}

TEST_F(RunFollowerTest, ACommandOfWhichNothingHappensHasItsTurn) {
  language.turns = {{0, 0}, {1, 1}, {1.4, 2}, {2, 2}};
  now.program.started_at = at(20);
  follower.follow(now, {}, at(20), texts, &language, worker);
  worker.deliver();
  EXPECT_EQ(when(21.2).command, 1);
  EXPECT_NEAR(follower.place().next_in_s, 0.2, 1e-6);
  EXPECT_EQ(when(21.6).command, 2);
  EXPECT_EQ(when(23.2).command, 1) << "what has happened since is newer than the latest turn";
}

// "X moves" and "Y moves" are one pass of a contour.
TEST_F(RunFollowerTest, EventsOfOneTurnAreOnePass) {
  language.turns = {{0, 0}, {1, 1}};
  now.program.started_at = at(20);
  follower.follow(now, {}, at(20), texts, &language, worker);
  worker.deliver();
  const auto last = when(23.2);
  EXPECT_EQ(last.command, 1);
  EXPECT_EQ(last.passes, 1) << "two things happen of it";
}

TEST_F(RunFollowerTest, OfThreadsTheOneThatRunsIsRehearsed) {
  catalog.program.threads = 4;
  now.threads[2].run = RunState::running;
  now.program.started_at = at(20);
  follower.follow(now, {}, at(20), texts, &language, worker);
  worker.deliver();
  EXPECT_EQ(language.slot, 2);
}

TEST_F(RunFollowerTest, TimeStandsStillWhileItIsHeld) {
  when(11.2);
  now.program.run = RunState::held;
  when(11.4);
  when(60);
  now.program.run = RunState::running;
  EXPECT_EQ(when(60.1).command, 1);
  EXPECT_NEAR(follower.run_s(), 1.4, 1e-6);
}

TEST_F(RunFollowerTest, AReportOfTheControllerCorrectsIt) {
  when(11.2);  // it is later in truth
  now.program.run = RunState::held;
  now.program.command = 2;
  const auto reported = when(11.3);
  EXPECT_EQ(reported.command, 2);
  EXPECT_NEAR(follower.run_s(), 2.0, 1e-6);
}

TEST_F(RunFollowerTest, AProgramChangedByAnotherIsNotFollowed) {
  ASSERT_EQ(when(11.5).command, 1);
  texts.doubt();
  EXPECT_EQ(when(11.6).command, 1) << "the wire was lost, the run goes on";
  texts.forget();
  EXPECT_EQ(when(11.7).command, -1);
  EXPECT_FALSE(follower.left_s());
}

TEST_F(RunFollowerTest, ReportsNothingItCannotKnow) {
  EXPECT_EQ(when(30).command, -1) << "longer than the rehearsal: something waits that was not rehearsed";
  EXPECT_FALSE(follower.left_s());
  now.program.run = RunState::idle;
  EXPECT_EQ(when(31).command, -1);
  now.program.run = RunState::running;
  now.program.slot = 0;  // nobody knows what it holds
  now.program.started_at = at(32);
  follower.follow(now, {}, at(32), texts, &language, worker);
  worker.deliver();
  EXPECT_EQ(when(33).command, -1);
}

}  // namespace
}  // namespace hw::gui
