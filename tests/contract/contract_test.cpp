#include <algorithm>
#include <cctype>
#include <cstring>
#include <set>

#include "tests/contract/rig.h"

namespace hw {
namespace {

using std::chrono::seconds;
using testing::HasSubstr;

INSTANTIATE_TEST_SUITE_P(Every, ContractTest, testing::ValuesIn(types_under_test()), name_of_type);

/// What a stranger reads of it: a name that is no mnemonic, an explanation in sentences, every value in
/// words.
void expect_explained(const ParamInfo& p) {
  EXPECT_GE(p.label.size(), 5u) << p.mnemonic;
  EXPECT_NE(p.label, p.mnemonic);
  EXPECT_FALSE(p.label.starts_with(p.mnemonic + " ") && p.mnemonic.size() > 1) << p.label;
  EXPECT_TRUE(p.label[0] >= 'A' && p.label[0] <= 'Z') << p.label;
  EXPECT_GE(std::count(p.explanation.begin(), p.explanation.end(), ' '), 8)
      << p.mnemonic << ": " << p.explanation;
  EXPECT_TRUE(p.explanation.ends_with('.')) << p.mnemonic << ": " << p.explanation;
  EXPECT_FALSE(p.group.empty()) << p.mnemonic;
  const auto letters = [](const std::string& s) {
    return std::count_if(s.begin(), s.end(), [](unsigned char c) { return std::isalpha(c); });
  };
  for (const ParamChoice& choice : p.choices)
    EXPECT_GE(letters(choice.label), 2) << p.mnemonic << ": " << choice.label;
  for (const auto& bit : p.bits) EXPECT_GE(letters(bit.label), 4) << p.mnemonic << ", bit " << bit.bit;
}

TEST_P(ContractTest, TheCatalogIsWhole) {
  const Catalog& c = session->catalog();
  EXPECT_EQ(c.model, GetParam()->model);
  EXPECT_FALSE(c.axes.empty());
  EXPECT_LE(c.params.size(), static_cast<std::size_t>(max_params));
  std::set<std::string> mnemonics;
  for (const ParamInfo& p : c.params) {
    EXPECT_TRUE(mnemonics.insert(p.mnemonic).second) << p.mnemonic << " stands twice";
    expect_explained(p);
    EXPECT_TRUE(p.accepts(p.fallback)) << p.mnemonic << ": the factory value is out of range";
  }
  for (const CommandInfo& command : c.commands) EXPECT_FALSE(command.help.empty()) << command.form;
}

TEST_P(ContractTest, AFreshControllerIsKnownAndAtRest) {
  EXPECT_TRUE(axis().position_known);
  EXPECT_EQ(axis().position, Steps(0));
  EXPECT_EQ(axis().activity, Activity::idle);
  EXPECT_FALSE(is_stale(axis().seen_at, time.now(), now().poll_period));
}

TEST_P(ContractTest, AMoveEndsWhereItWasSent) {
  EXPECT_EQ(perform(intent::MoveTo({{AxisId{0}, Steps(400)}})).state, IntentState::done);
  ASSERT_TRUE(becomes_idle(seconds(20)));
  EXPECT_EQ(axis().position, Steps(400));
  EXPECT_EQ(axis().ended_by, EndedBy::target);
  EXPECT_EQ(perform(intent::MoveBy({{AxisId{0}, Steps(-100)}})).state, IntentState::done);
  ASSERT_TRUE(becomes_idle(seconds(20)));
  EXPECT_EQ(axis().position, Steps(300));
}

TEST_P(ContractTest, AHeldJogMovesAndStopsWhenItIsLetGo) {
  session->send(intent::JogStart(AxisId{0}, Sign::plus));
  for (int i = 0; i < 10; ++i) {
    run(Millis(100));
    session->send(intent::JogKeepAlive());
  }
  EXPECT_GT(axis().direction, 0);
  session->send(intent::JogStop());
  ASSERT_TRUE(becomes_idle(seconds(20)));
  const Steps there = axis().position;
  EXPECT_GT(there, Steps(0));
  run(seconds(5));
  EXPECT_EQ(axis().position, there);
}

TEST_P(ContractTest, AJogThatIsNotHeldEndsByItself) {
  session->send(intent::JogStart(AxisId{0}, Sign::plus));
  ASSERT_TRUE(becomes_idle(seconds(20)));
  const Steps there = axis().position;
  run(seconds(5));
  EXPECT_EQ(axis().position, there);
}

TEST_P(ContractTest, StopEndsALongMoveAtOnceAndItStaysEnded) {
  perform(intent::MoveBy({{AxisId{0}, Steps(50000)}}));
  run(Millis(100));  // some do these steps in a third of a second
  ASSERT_EQ(axis().activity, Activity::moving);
  const IntentId stop = session->send(intent::Stop());
  ASSERT_TRUE(becomes_idle(seconds(20)));
  EXPECT_EQ(now().outcome_of(stop)->state, IntentState::done);
  const Steps there = axis().position;
  EXPECT_LT(there, Steps(49000));
  run(seconds(5));
  EXPECT_EQ(axis().position, there);
  EXPECT_EQ(axis().ended_by, EndedBy::stop);
}

TEST_P(ContractTest, APulledCableIsReportedAndHealsWithoutMovingAnything) {
  perform(intent::MoveBy({{AxisId{0}, Steps(2000)}}));
  run(Millis(500));
  operate(bench::Unplug(true));
  ASSERT_TRUE(run_until([this] { return now().link.state == LinkState::lost; }, seconds(10)));
  EXPECT_FALSE(now().link.sentence.empty());
  run(seconds(20));
  EXPECT_FALSE(axis().position_known && !is_stale(axis().seen_at, time.now(), now().poll_period))
      << "a position that cannot be read may not look live";
  operate(bench::Unplug(false));
  ASSERT_TRUE(run_until([this] { return now().link.state == LinkState::good; }, seconds(20)));
  ASSERT_TRUE(becomes_idle(seconds(20)));
  EXPECT_EQ(axis().position, Steps(2000)) << "the controller went on by itself; nothing was repeated";
}

// Whether what was on its way came there no wire can know: it is not called lost, and the place is told.
TEST_P(ContractTest, AMoveFinishedDuringALostLinkIsReportedWithItsPosition) {
  session->send(intent::MoveBy({{AxisId{0}, Steps(2000)}}, Pps{500}));
  run(Millis(500));
  operate(bench::Unplug(true));
  ASSERT_TRUE(run_until([this] { return now().link.state == LinkState::lost; }, seconds(10)));
  EXPECT_THAT(std::string(now().link.sentence.view()), Not(HasSubstr("is lost")));
  run(seconds(20));
  operate(bench::Unplug(false));
  ASSERT_TRUE(run_until([this] { return now().link.state == LinkState::good; }, seconds(20)));
  run(seconds(2));
  std::vector<std::string> places;
  session->notices().drain([&](const Notice& n) {
    if (n.text.find("The connection was lost for") != n.text.npos) places.push_back(n.text);
  });
  ASSERT_EQ(places.size(), 1u);
  EXPECT_THAT(places[0], HasSubstr("It has finished meanwhile; "));
  EXPECT_THAT(places[0], HasSubstr("stands at 2000 " + session->catalog().step_word));
}

TEST_P(ContractTest, AJogThatLostItsLinkIsStoppedWhenTheLinkIsBack) {
  session->send(intent::JogStart(AxisId{0}, Sign::plus));
  for (int i = 0; i < 5; ++i) {
    run(Millis(100));
    session->send(intent::JogKeepAlive());
  }
  operate(bench::Unplug(true));
  ASSERT_TRUE(run_until([this] { return now().link.state == LinkState::lost; }, seconds(10)));
  const Instant lost_at = now().link.lost_at;
  session->send(intent::JogStop());
  run(seconds(4));
  EXPECT_EQ(now().link.lost_at, lost_at) << "attempts in between do not move it";
  operate(bench::Unplug(false));
  ASSERT_TRUE(run_until([this] { return now().link.state == LinkState::good; }, seconds(20)));
  ASSERT_TRUE(becomes_idle(seconds(10)));
  const Steps there = load();
  run(seconds(5));
  EXPECT_EQ(load(), there);
}

TEST_P(ContractTest, AStopWithoutALinkIsSentWhenTheLinkIsBack) {
  perform(intent::MoveBy({{AxisId{0}, Steps(1'000'000)}}));
  run(Millis(200));
  operate(bench::Unplug(true));
  ASSERT_TRUE(run_until([this] { return now().link.state == LinkState::lost; }, seconds(10)));
  EXPECT_EQ(perform(intent::Stop(0)).state, IntentState::failed) << "and it is said";
  operate(bench::Unplug(false));
  ASSERT_TRUE(run_until([this] { return now().link.state == LinkState::good; }, seconds(20)));
  ASSERT_TRUE(becomes_idle(seconds(10)));
  const Steps there = load();
  run(seconds(5));
  EXPECT_EQ(load(), there);
}

TEST_P(ContractTest, AScriptsJogThatALimitHasEndedStopsNothingElse) {
  perform(intent::SetPosition(0));
  session->send(intent::JogStart(AxisId{0}, Sign::plus, {}, false));
  run(seconds(1));
  operate(bench::Limit(AxisId{0}, Sign::plus, true));
  ASSERT_TRUE(becomes_idle(seconds(20)));
  operate(bench::Limit(AxisId{0}, Sign::plus, false));
  clear_errors();
  const Steps there = axis().position;
  EXPECT_EQ(perform(intent::MoveTo({{AxisId{0}, there - Steps(3000)}}, Pps(1000))).state, IntentState::done);
  run(Millis(300));
  ASSERT_TRUE(now().any_axis_moving());
  operate(bench::Unplug(true));
  ASSERT_TRUE(run_until([this] { return now().link.state == LinkState::lost; }, seconds(10)));
  operate(bench::Unplug(false));
  ASSERT_TRUE(run_until([this] { return now().link.state == LinkState::good; }, seconds(20)));
  ASSERT_TRUE(becomes_idle(seconds(20)));
  EXPECT_EQ(axis().position, there - Steps(3000));
}

TEST_P(ContractTest, ARefusedMoveLeavesAHeldJogGuarded) {
  const auto hold = [this](int times) {
    for (int i = 0; i < times; ++i) {
      run(Millis(100));
      session->send(intent::JogKeepAlive());
    }
  };
  session->send(intent::JogStart(AxisId{0}, Sign::plus));
  hold(5);
  const IntentId refused = session->send(intent::MoveTo({{AxisId{0}, Steps(2'000'000'000)}}));
  hold(5);
  EXPECT_EQ(now().outcome_of(refused)->state, IntentState::refused);
  session->send(intent::JogStop());
  ASSERT_TRUE(becomes_idle(seconds(10)));
  const Steps there = load();
  run(seconds(3));
  EXPECT_EQ(load(), there);
}

// Where two axes can jog at once: a hand lets go of its own, whatever a script holds or has let go.
TEST_P(ContractTest, AHandLetsGoOfItsOwnJogBesideAScripts) {
  if (!axes_jog_at_once()) GTEST_SKIP() << "one axis moves at a time";
  for (const bool script_ends_first : {false, true}) {
    session->send(intent::JogStart(AxisId{0}, Sign::plus));
    run(Millis(100));
    session->send(intent::JogKeepAlive());
    const IntentId scripts = session->send(intent::JogStart(AxisId{1}, Sign::plus, {}, false));
    run(Millis(200));
    session->send(intent::JogKeepAlive());
    ASSERT_EQ(now().outcome_of(scripts)->state, IntentState::done);
    if (script_ends_first) session->send(intent::Stop(1));
    run(Millis(200));
    session->send(intent::JogStop());
    ASSERT_TRUE(run_until([this] { return axis().activity == Activity::idle; }, seconds(10)));
    const Steps there = load();
    run(seconds(2));
    EXPECT_EQ(load(), there);
    EXPECT_EQ(now().axes[1].activity, script_ends_first ? Activity::idle : Activity::jogging);
    session->send(intent::Stop());
    ASSERT_TRUE(becomes_idle(seconds(20)));
  }
}

// Where several axes can move at once: a stop is the second one only of what is stopping already.
TEST_P(ContractTest, StopsOfDifferentAxesAreNotAStopAskedTwice) {
  if (!axes_jog_at_once()) GTEST_SKIP() << "one axis moves at a time";
  const auto jogs = [this](std::uint8_t i, bool guarded = false) {
    const IntentId jog = session->send(intent::JogStart(AxisId{i}, Sign::plus, {}, guarded));
    run(Millis(200));
    return now().outcome_of(jog)->state == IntentState::done;
  };
  const int axes = std::min(now().axis_count, 3);
  ASSERT_TRUE(jogs(0));
  ASSERT_TRUE(jogs(1));
  const bool third = axes > 2 && jogs(2);
  session->send(intent::Stop(0));
  run(Millis(20));
  session->send(intent::Stop(1));
  run(seconds(1));
  for (const int i : {0, 1}) EXPECT_EQ(now().axes[i].ended_by, EndedBy::stop) << i;
  EXPECT_EQ(now().axes[2].activity == Activity::jogging, third);
  ASSERT_TRUE(jogs(0));
  session->send(intent::Stop(0));
  run(Millis(20));
  session->send(intent::Stop());
  ASSERT_TRUE(becomes_idle(seconds(20)));
  EXPECT_EQ(now().axes[axes - 1].ended_by, EndedBy::stop) << "the first stop of all";
  ASSERT_TRUE(jogs(1));
  ASSERT_TRUE(jogs(0, true));
  session->send(intent::JogStop());
  run(Millis(20));
  session->send(intent::Stop());
  ASSERT_TRUE(becomes_idle(seconds(20)));
  EXPECT_EQ(now().axes[1].ended_by, EndedBy::stop) << "letting go was none";
  ASSERT_TRUE(jogs(0));
  session->send(intent::Stop(0));
  run(Millis(20));
  session->send(intent::Stop(0));
  ASSERT_TRUE(becomes_idle(seconds(20)));
  EXPECT_EQ(now().axes[0].ended_by, EndedBy::abort) << "asked twice";
}

TEST_P(ContractTest, AStopWhileAReleasedJogRampsIsTheFirst) {
  session->send(intent::JogStart(AxisId{0}, Sign::plus));
  run(Millis(200));
  session->send(intent::JogStop());
  run(Millis(20));
  ASSERT_NE(axis().speed.value, 0);
  session->send(intent::Stop());
  ASSERT_TRUE(becomes_idle(seconds(20)));
  EXPECT_EQ(axis().ended_by, EndedBy::stop);
}

TEST_P(ContractTest, AJogWhoseAnswerIsLostDoesNotOutliveItsHand) {
  for (int delay_ms = 0; delay_ms < 24; delay_ms += 2) {
    session->send(intent::JogStart(AxisId{0}, delay_ms % 4 == 0 ? Sign::plus : Sign::minus));
    run(Millis(delay_ms));
    operate(bench::Drop(3));
    for (int i = 0; i < 4; ++i) {
      run(Millis(100));
      session->send(intent::JogKeepAlive());
    }
    session->send(intent::JogStop());
    run(seconds(3));
    const Steps there = load();
    run(seconds(2));
    EXPECT_EQ(load(), there) << delay_ms;
    ASSERT_TRUE(run_until([this] { return now().link.state == LinkState::good; }, seconds(60)));
    ASSERT_TRUE(becomes_idle(seconds(20)));
  }
}

TEST_P(ContractTest, AJogThatIsLetGoBeforeItsTurnMovesNothing) {
  session->send(intent::MoveTo({{AxisId{0}, Steps(400)}}));
  const IntentId jog = session->send(intent::JogStart(AxisId{0}, Sign::plus));
  session->send(intent::JogStop());
  ASSERT_TRUE(
      run_until([&] { return now().outcome_of(jog) && now().outcome_of(jog)->state == IntentState::refused; },
                seconds(5)));
  ASSERT_TRUE(becomes_idle(seconds(20)));
  EXPECT_EQ(axis().position, Steps(400)) << "and the move before it is not stopped";
}

// Begun at each moment of an attempt to connect.
TEST_P(ContractTest, AStopWhileTheLinkIsRestoredGoesOutWhole) {
  for (int into_it_ms = 0; into_it_ms <= 40; into_it_ms += 2) {
    ASSERT_TRUE(run_until([this] { return now().link.state == LinkState::good; }, seconds(60)));
    ASSERT_TRUE(becomes_idle(seconds(120)));
    perform(intent::MoveBy({{AxisId{0}, Steps(into_it_ms % 4 == 0 ? 50000 : -50000)}}));
    run(Millis(50));
    operate(bench::Unplug(true));
    ASSERT_TRUE(run_until([this] { return now().link.state == LinkState::lost; }, seconds(10)));
    operate(bench::Unplug(false));
    run(now().link.next_attempt - time.now() + Millis(into_it_ms));
    const IntentId stop = session->send(intent::Stop());
    run(seconds(4));
    const IntentOutcome* outcome = now().outcome_of(stop);
    ASSERT_TRUE(outcome);
    EXPECT_EQ(outcome->state, IntentState::done) << into_it_ms << ": " << outcome->sentence.view();
    const Steps there = load();
    run(seconds(3));
    EXPECT_EQ(load(), there) << into_it_ms;
  }
}

TEST_P(ContractTest, GarbledAndDroppedBytesLoseNothing) {
  for (int i = 0; i < 5; ++i) {
    operate(bench::Garble(7));
    run(seconds(1));
    operate(bench::Drop(5));
    run(seconds(1));
  }
  // What is still to be garbled hits the greetings of the next connections, one by one.
  ASSERT_TRUE(run_until([this] { return now().link.state == LinkState::good; }, seconds(300)))
      << now().link.sentence.view();
  EXPECT_EQ(perform(intent::MoveTo({{AxisId{0}, Steps(400)}})).state, IntentState::done);
  ASSERT_TRUE(becomes_idle(seconds(20)));
  EXPECT_EQ(axis().position, Steps(400));
}

TEST_P(ContractTest, APowerCycleIsNoticedAndNothingMoves) {
  perform(intent::MoveTo({{AxisId{0}, Steps(400)}}));
  ASSERT_TRUE(becomes_idle(seconds(20)));
  perform(intent::Stop());  // which keeps nothing back afterwards
  operate(bench::PowerCycle());
  ASSERT_TRUE(run_until([this] { return now().link.state == LinkState::good && axis().position == Steps(0); },
                        seconds(30)));
  run(seconds(5));
  EXPECT_EQ(axis().position, Steps(0));
  Notice reported;
  bool sentence = false;
  session->notices().drain(
      [&](const Notice& n) { sentence = sentence || n.text.find("switched off and on") != n.text.npos; });
  EXPECT_TRUE(sentence);
}

TEST_P(ContractTest, ValuesOutOfRangeAreRefusedInWordsAndNothingIsSent) {
  for (const ParamInfo& p : session->catalog().params) {
    if (!p.choices.empty() || !p.bits.empty()) continue;
    const IntentOutcome outcome = perform(intent::SetParam(p.mnemonic, p.maximum + 1, true));
    EXPECT_EQ(outcome.state, IntentState::refused) << p.mnemonic;
    EXPECT_THAT(std::string(outcome.sentence.view()), HasSubstr("Nothing was sent")) << p.mnemonic;
  }
}

TEST_P(ContractTest, EveryParameterCanBeReadAndTakesItsFactoryValueAgain) {
  ASSERT_EQ(perform(intent::ReadParams(), seconds(60)).state, IntentState::done);
  const Catalog& c = session->catalog();
  for (std::size_t i = 0; i < c.params.size(); ++i) {
    if (!c.params[i].readable) continue;
    EXPECT_TRUE(now().params[i].known) << c.params[i].mnemonic;
    EXPECT_EQ(now().params[i].value, c.params[i].fallback) << c.params[i].mnemonic;
  }
}

TEST_P(ContractTest, TheLanguageNeverFailsOnAnyText) {
  if (!GetParam()->language) GTEST_SKIP() << "it has no programs";
  const Language& language = GetParam()->language();
  for (const char* text : {"", "\n\n\n", ";", "\xff\xfe", "I1M", "ÄÖÜ", "((((", "99999999999999999999"}) {
    const ProgramReport report = language.analyse(text, 0);
    const auto lines = std::count(text, text + std::strlen(text), '\n') + 1;
    EXPECT_GE(static_cast<long>(report.lines.size()) + 1, lines) << text;
  }
}

// Each axis begins where it is said to stand, and what the text does is counted from there.
TEST_P(ContractTest, ARehearsalBeginsWhereTheAxesStand) {
  if (!GetParam()->language) GTEST_SKIP() << "it has no programs";
  const Catalog& catalog = session->catalog();
  RehearseOptions options;
  options.for_seconds = 5;
  options.axes = static_cast<int>(catalog.axes.size());
  options.device = catalog.made_from;
  options.start_at.assign(catalog.axes.size(), 20000);
  const auto rehearsed = GetParam()->language().rehearse(catalog.program.example, options);
  ASSERT_TRUE(rehearsed) << rehearsed.error().sentence();
  ASSERT_FALSE(rehearsed->axes.empty());
  for (const RehearsedAxis& rehearsed_axis : rehearsed->axes) {
    EXPECT_EQ(rehearsed_axis.begin, 20000) << rehearsed_axis.name;
    EXPECT_LE(rehearsed_axis.minimum, 20000) << rehearsed_axis.name;
    EXPECT_GE(rehearsed_axis.maximum, 20000) << rehearsed_axis.name;
  }
}

TEST_P(ContractTest, UnwatchedItStaysGoodForAnHour) {
  run(std::chrono::hours(1));
  EXPECT_EQ(now().link.state, LinkState::good);
  EXPECT_EQ(now().link.timeouts, 0u);
  EXPECT_EQ(now().link.unparsed_bytes, 0u);
}

}  // namespace
}  // namespace hw
