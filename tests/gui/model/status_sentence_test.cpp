#include "gui/model/status_sentence.h"

#include <fmt/core.h>
#include <gtest/gtest.h>

#include "gui/model/axis_look.h"

namespace hw::gui {
namespace {

class StatusSentenceTest : public testing::Test {
 protected:
  Catalog catalog;
  Snapshot now;
  Instant clock{Millis(10'000)};
  std::optional<JogHold::Control> held;
  RunPlace run;
  std::string failed;
  bool unset_read = false;

  StatusSentenceTest() {
    catalog.name = "Example Two";
    catalog.short_name = "Two";
    catalog.axes = {{"1", "motor 1"}, {"2", "motor 2"}};
    catalog.program.slot_word = "Program";
    catalog.can.store = true;
    ParamInfo type;
    type.mnemonic = "type1";
    type.axis = 0;
    type.before_moving = "No motor is chosen for motor 1, so it must not move. Choose it in Setup.";
    catalog.params.push_back(type);
    catalog.program.slots = 1;
    now.axis_count = 2;
    now.link.state = LinkState::good;
    now.poll_period = Millis(200);
    for (int i = 0; i < 2; ++i) {
      now.axes[i].position_known = now.axes[i].limits_known = true;
      now.axes[i].activity = Activity::idle;
      now.axes[i].seen_at = clock;
    }
    now.params[0].known = true;
    now.params[0].value = 3;
  }
  StatusSentence sentence() const {
    return status_sentence({catalog, now, clock, held, held.has_value(),
                            [](AxisId, Steps s) { return fmt::format("{} steps", s.value); },
                            [](AxisId, Pps v) { return fmt::format("{} steps/s", v.value); },
                            [](Instant) { return std::string("14:20:08"); }, run, failed, unset_read});
  }
};

TEST_F(StatusSentenceTest, Idle) {
  EXPECT_EQ(sentence().text, "Idle. Hold a jog button, type where to go, or run a program.");
  EXPECT_EQ(sentence().severity, Severity::plain);
}

TEST_F(StatusSentenceTest, WithoutProgramsItOffersNone) {
  catalog.program.slots = 0;
  EXPECT_EQ(sentence().text, "Idle. Hold a jog button or type where to go.");
}

TEST_F(StatusSentenceTest, BetweenTwoMotionsOfADrawingItIsNotIdle) {
  now.pieces.running = true;
  now.pieces.done = 12;
  now.pieces.total = 800;
  EXPECT_EQ(sentence().text, "Piece 13 of 800 is under way. Esc stops everything.");
  EXPECT_EQ(sentence().severity, Severity::motion);
  now.pieces.held = true;
  EXPECT_EQ(sentence().text, "Held at piece 13 of 800. Resume or stop it.");
}

TEST_F(StatusSentenceTest, TheWorstThingComesFirstWhateverMoves) {
  constexpr std::string_view moves = "Motor 1 moves. Esc stops everything.";
  now.axes[0].activity = Activity::moving;
  const auto expect_first = [&](std::string_view worst) {
    EXPECT_EQ(sentence().severity, Severity::warn) << worst;
    EXPECT_EQ(sentence().text.view().find(worst), 0u) << sentence().text.view();
    EXPECT_NE(sentence().text.view().find(moves), std::string::npos) << sentence().text.view();
  };
  now.axes[1].limit_plus = true;
  expect_first("Motor 2 is on its + limit. ");
  now.axes[1].loop = Loop::open;
  expect_first("The loop of motor 2 is open");
  now.axes[1].slipped = true;
  expect_first("Motor 2 has slipped");
  now.axes[1].trust.doubt(Doubt::power_cut, {});
  expect_first("The position of motor 2 cannot be trusted");
  now.notice = "The program memory is full.";
  expect_first("The program memory is full. ");
  now.link.state = LinkState::late;
  expect_first("Two is not understood. ");
  now.axes[1].alarm = true;
  EXPECT_EQ(sentence().severity, Severity::fault);
}

TEST_F(StatusSentenceTest, AnAxisThatIsBeingHomedOrLeavesItsLimitIsNotAdvisedToDoSo) {
  now.axes[0].activity = Activity::homing;
  now.axes[0].trust.doubt(Doubt::power_cut, {});
  EXPECT_EQ(sentence().severity, Severity::motion);
  now.axes[0].trust = {};
  now.axes[0].activity = Activity::moving;
  now.axes[0].limit_plus = true;
  EXPECT_EQ(sentence().text, "Motor 1 moves. Esc stops everything.");
}

TEST_F(StatusSentenceTest, ASlipIsReported) {
  now.axes[1].slipped = true;
  EXPECT_EQ(sentence().severity, Severity::warn);
  EXPECT_EQ(sentence().text.view().find("Motor 2 has slipped: its position error was larger than allowed."),
            0u);
  EXPECT_EQ(state_of(now, 1, clock), State::slipped);
  EXPECT_EQ(worst_state(now, clock), State::slipped) << "its tab says so too";
  now.axes[1].enabled = false;
  EXPECT_EQ(state_of(now, 1, clock), State::slipped) << "and it is why it is off";
  now.axes[1].activity = Activity::moving;
  EXPECT_EQ(sentence().severity, Severity::warn);
  EXPECT_EQ(state_of(now, 1, clock), State::moving);
}

TEST_F(StatusSentenceTest, AServoAxisShowsHowItStandsToItsCommand) {
  ParamInfo gain;
  gain.axis = 1;
  gain.drives = true;
  for (const char* name : {"KP2", "KI2"}) gain.mnemonic = name, catalog.params.push_back(gain);
  now.params[1] = {200, true, true};
  now.params[2] = {0, true, true};
  AxisState& a = now.axes[1];
  a.loop = Loop::in_place;
  a.command = a.position = Steps(5000);
  EXPECT_EQ(state_of(now, 1, clock), State::in_place);
  EXPECT_EQ(worst_state(now, clock), State::idle);
  EXPECT_EQ(sentence().severity, Severity::plain);
  a.loop = Loop::off_place;
  a.position = Steps(0);
  EXPECT_EQ(state_of(now, 1, clock), State::not_in_place);
  EXPECT_EQ(worst_state(now, clock), State::not_in_place);
  EXPECT_EQ(sentence(),
            (StatusSentence{Severity::warn,
                            "Motor 2 is not in place: it stands 5000 steps from its command, 5000 "
                            "steps. Check whether something blocks it, and check its gains."}));
  now.params[1].value = 0;
  EXPECT_NE(sentence().text.view().find("Nothing drives it while KP2 and KI2 are 0."), std::string::npos);
  a.loop = Loop::open;
  EXPECT_EQ(state_of(now, 1, clock), State::open_loop);
  EXPECT_EQ(sentence().text.view().find("The loop of motor 2 is open, so its motor is free."), 0u);
  a.loop = Loop::unknown;
  EXPECT_EQ(state_of(now, 1, clock), State::idle) << "what is not known is not shown as known";
  a.loop = Loop::following;
  a.activity = Activity::moving;
  EXPECT_EQ(sentence(), (StatusSentence{Severity::motion,
                                        "Motor 2 settles, 5000 steps from its command. Esc stops "
                                        "everything."}));
}

TEST_F(StatusSentenceTest, Moving) {
  now.axes[0].activity = Activity::moving;
  now.axes[0].has_target = true;
  now.axes[0].target = Steps(400);
  EXPECT_EQ(sentence(),
            (StatusSentence{Severity::motion, "Motor 1 moves to 400 steps. Esc stops everything."}));
}

TEST_F(StatusSentenceTest, AProgramInErrorIsReportedWhileOthersRun) {
  failed = "Program 2 stopped with an error in line 19: V2=5/V1.";
  EXPECT_EQ(sentence(),
            (StatusSentence{Severity::fault, failed + " Run starts it again, Stop clears the error."}));
  now.program.owned = true;
  now.program.run = RunState::running;
  run.subject = "Programs 0, 1 are";
  constexpr std::string_view programs = "Programs 0, 1 are running. Esc stops everything.";
  EXPECT_EQ(sentence(),
            (StatusSentence{Severity::fault, failed + " " + std::string(programs), programs.size()}));
  now.axes[0].activity = Activity::error;
  now.notice = "Axis X hit its + limit. Clear the errors before the next move.";
  EXPECT_EQ(sentence().text.view(),
            failed +
                " Axis X hit its + limit. Clear the errors before the next move. Programs 0, "
                "1 are running. Esc stops everything.")
      << "what stopped it stands beside it";
  now.program.run = RunState::idle;
  now.program.owned = false;
  EXPECT_EQ(sentence().text.view(),
            failed + " Axis X hit its + limit. Clear the errors before the next move.");
}

TEST_F(StatusSentenceTest, MotionBesideAnAxisInErrorIsReported) {
  now.axes[0].activity = Activity::error;
  now.notice = "Axis X hit its + limit. Clear the errors before the next move.";
  now.axes[1].activity = Activity::moving;
  constexpr std::string_view moves = "Motor 2 moves. Esc stops everything.";
  EXPECT_EQ(sentence(),
            (StatusSentence{Severity::fault, std::string(now.notice.view()) + " " + std::string(moves),
                            moves.size()}));
}

TEST_F(StatusSentenceTest, AProgramInErrorHidesNoMotion) {
  now.program.run = RunState::error;
  now.axes[1].activity = Activity::moving;
  constexpr std::string_view moves = "Motor 2 moves. Esc stops everything.";
  EXPECT_EQ(sentence(),
            (StatusSentence{Severity::fault,
                            "The program ended with an error. Motor 2 moves. Esc stops everything.",
                            moves.size()}));
  EXPECT_EQ(sentence().goes_on, moves.size()) << "where there is no room for both, this stays";
  now.notice = "Limit + of motor 1.";
  EXPECT_EQ(sentence().text, "Limit + of motor 1. Motor 2 moves. Esc stops everything.");
}

TEST_F(StatusSentenceTest, AProgramInErrorDoesNotHideThatTheAnswersAreLate) {
  failed = "Program 2 stopped with an error.";
  now.link.state = LinkState::late;
  now.link.misses_in_a_row = 2;
  now.axes[0].activity = Activity::moving;
  constexpr std::string_view moves = "Motor 1 moves. Esc stops everything.";
  EXPECT_EQ(sentence(),
            (StatusSentence{Severity::fault,
                            "Two answers late: 2 queries missed. Program 2 stopped with an error. "
                            "Motor 1 moves. Esc stops everything.",
                            moves.size()}));
}

TEST_F(StatusSentenceTest, OfSeveralProgramsOneInErrorNeedsAttentionWhateverMoves) {
  EXPECT_FALSE(needs_attention(now));
  now.axes[0].activity = Activity::moving;
  now.threads[1].known = true;
  now.threads[1].run = RunState::error;
  EXPECT_TRUE(needs_attention(now));
}

TEST_F(StatusSentenceTest, OfATextThatIsNotKnownTheStoredLineIsReported) {
  now.program.owned = true;
  now.program.slot = 0;
  now.program.run = RunState::running;
  run.stored_line = 2;
  EXPECT_EQ(sentence().text, "Program 0 is running at line 2 of its stored code. Esc stops everything.");
  run.line = 5;
  EXPECT_EQ(sentence().text, "Program 0 is running in line 6. Esc stops everything.");
}

TEST_F(StatusSentenceTest, SeveralAxesThatMoveAreNamedTogether) {
  now.axes[0].activity = now.axes[1].activity = Activity::moving;
  now.axes[0].has_target = true;
  EXPECT_EQ(sentence().text, "Motor 1 and motor 2 move. Esc stops everything.");
}

TEST_F(StatusSentenceTest, ADirectionThatIsNotKnownIsNotReported) {
  now.axes[0].activity = Activity::moving;
  EXPECT_EQ(sentence().text, "Motor 1 moves. Esc stops everything.");
}

TEST_F(StatusSentenceTest, ARunningProgramShowsLinePassAndTimeLeft) {
  now.program.owned = true;
  now.program.slot = 0;
  now.program.run = RunState::running;
  EXPECT_EQ(sentence().text, "Program 0 is running. Esc stops everything.");
  run.line = 5;
  EXPECT_EQ(sentence().text, "Program 0 is running in line 6. Esc stops everything.");
  run.pass = 7, run.passes = 20;
  run.left_s = 45.2;
  now.axes[0].activity = Activity::moving;
  now.axes[0].has_target = true;
  now.axes[0].target = Steps(4800);
  EXPECT_EQ(sentence().text,
            "Program 0 is running in line 6, pass 7 of 20. 46 s left. Motor 1 moves to 4800 steps. Esc stops "
            "everything.");
}

TEST_F(StatusSentenceTest, SeveralProgramsAreNamed) {
  now.program.owned = true;
  now.program.slot = 0;
  now.program.run = RunState::running;
  run.subject = "Programs 0, 2 are";
  EXPECT_EQ(sentence().text, "Programs 0, 2 are running. Esc stops everything.");
}

TEST_F(StatusSentenceTest, LateOrNotUnderstood) {
  now.link.state = LinkState::late;
  now.link.misses_in_a_row = 2;
  EXPECT_EQ(sentence().text, "Two answers late: 2 queries missed.");
  now.link.misses_in_a_row = 0;
  now.link.sentence = "Two devices have one address.";
  EXPECT_EQ(sentence().text, "Two is not understood. Two devices have one address.");
  EXPECT_EQ(sentence().severity, Severity::warn);
}

TEST_F(StatusSentenceTest, Held) {
  now.axes[0].activity = Activity::jogging;
  now.axes[0].direction = 1;
  now.axes[0].speed = Pps(2000);
  held = JogHold::Control{JogHold::Source::mouse, AxisId{0}, Sign::plus};
  EXPECT_EQ(sentence().text,
            "You hold 1+. Motor 1 moves at 2000 steps/s until you release it. Esc stops everything.");
}

TEST_F(StatusSentenceTest, LostIsTheWorstAndNamesTheWayOut) {
  now.axes[0].activity = Activity::moving;
  now.axes[1].limit_plus = true;
  now.link.state = LinkState::lost;
  now.link.sentence = "The cable is gone.";
  EXPECT_EQ(sentence(), (StatusSentence{Severity::fault,
                                        "No answer from Two since 14:20:08. Stop does not reach it: use its "
                                        "power switch. The cable is gone."}));
}

TEST_F(StatusSentenceTest, AnErrorOfTheControllerIsShownAsTheDriverReportsIt) {
  now.notice = "The program memory is full. Clear a program.";
  EXPECT_EQ(sentence().severity, Severity::warn);
  now.program.run = RunState::error;
  EXPECT_EQ(sentence(), (StatusSentence{Severity::fault, "The program memory is full. Clear a program."}));
}

TEST_F(StatusSentenceTest, LimitShowsWhereItCanGo) {
  now.axes[1].limit_plus = true;
  EXPECT_EQ(sentence(), (StatusSentence{Severity::warn, "Motor 2 is on its + limit. It can only move −."}));
  now.axes[1].limit_minus = true;
  EXPECT_EQ(sentence().text,
            "Both limits of motor 2 are active, so it cannot move. Check its switches and their cable.");
}

TEST_F(StatusSentenceTest, MotorThatIsNotChosenIsReportedBeforeTheFirstMove) {
  now.params[0].value = 0;
  EXPECT_EQ(sentence().severity, Severity::warn);
  EXPECT_EQ(sentence().text, catalog.params[0].before_moving);
  EXPECT_EQ(unset_before_moving(catalog, now, AxisId{0}), 0);
  EXPECT_EQ(unset_before_moving(catalog, now, AxisId{1}), -1);
  now.params[0].known = false;
  EXPECT_EQ(unset_before_moving(catalog, now, AxisId{0}), -1) << "what was not read is not claimed";
}

TEST_F(StatusSentenceTest, DoubtIsReported) {
  now.axes[0].trust.doubt(Doubt::power_cut, {});
  EXPECT_EQ(sentence().severity, Severity::warn);
  now.axes[0].position_known = false;
  EXPECT_EQ(sentence().text, "The position of motor 1 is not known. Home it, or set its position.");
}

TEST_F(StatusSentenceTest, OldValuesAreNotTakenForNew) {
  clock += Millis(5'000);
  EXPECT_EQ(sentence(), (StatusSentence{Severity::warn, "The position of motor 1 is 5.0 s old."}));
}

TEST_F(StatusSentenceTest, UnsavedSettingsAreShownByTheirMarkOnly) {
  now.unsaved_setup = true;
  EXPECT_EQ(sentence().text, "Idle. Hold a jog button, type where to go, or run a program.");
}

TEST_F(StatusSentenceTest, JoggingIsNotAdvisedWithoutMotorPower) {
  for (int i = 0; i < 2; ++i) {
    catalog.axes[static_cast<std::size_t>(i)].switchable = true;
    now.axes[i].enabled = false;
  }
  EXPECT_EQ(sentence().text, "Motor power is off. Switch it on to move.");
  now.axes[1].enabled = true;
  EXPECT_EQ(sentence().text, "Idle. Hold a jog button, type where to go, or run a program.")
      << "one of them can";
  now.axes[1].enabled = false;
  now.axes[0].position_known = false;
  EXPECT_EQ(sentence().severity, Severity::warn) << "what is worse is said first";
  now.axes[0].position_known = true;
  now.axis_count = 1;
  EXPECT_EQ(sentence().text, "Motor power of motor 1 is off. Switch it on to move it.");
}

TEST_F(StatusSentenceTest, AnAxisWithNoWayToGoInAMoveIsNotCalledMoving) {
  for (int i = 0; i < 2; ++i) {
    now.axes[i].activity = Activity::moving;
    now.axes[i].phase = Phase::constant;
  }
  now.axes[0].speed = Pps(1'000);
  now.axes[0].direction = now.axes[1].direction = 1;
  now.axes[1].has_target = true;
  EXPECT_EQ(state_of(now, 0, clock), State::moving_plus);
  EXPECT_EQ(state_of(now, 1, clock), State::waiting) << "it is where it goes";
  EXPECT_EQ(sentence().text, "Motor 1 moves +. Esc stops everything.");
  now.axes[1].target = Steps(3);
  EXPECT_EQ(state_of(now, 1, clock), State::moving_plus) << "so slowly that its speed is rounded to 0";
  now.axes[1].has_target = false;
  EXPECT_EQ(state_of(now, 1, clock), State::moving_plus) << "nobody knows where it goes";
  now.axes[1].has_target = true;
  now.axes[1].target = Steps(0);
  now.axes[1].direction = 0;
  now.axes[1].phase = Phase::unknown;
  EXPECT_EQ(state_of(now, 1, clock), State::moving) << "of a controller that tells no speed";
}

TEST_F(StatusSentenceTest, AnAlarmThatStandsIsNoErrorToClear) {
  now.axes[1].alarm = true;
  EXPECT_EQ(sentence(), (StatusSentence{Severity::fault,
                                        "The alarm input of motor 2 is active, so it takes no move. "
                                        "Look at its motor driver."}));
}

TEST_F(StatusSentenceTest, AStateShownByABannerIsNotRepeated) {
  now.params[0].value = 0;
  unset_read = true;
  EXPECT_EQ(sentence().text, "Idle. Hold a jog button, type where to go, or run a program.");
}

TEST_F(StatusSentenceTest, ProgramThatWaits) {
  now.program.owned = true;
  now.program.slot = 2;
  now.program.run = RunState::waiting;
  EXPECT_EQ(sentence().text,
            "Program 2 waits. It continues by itself when its condition is met. Esc stops everything.");
}

}  // namespace
}  // namespace hw::gui
