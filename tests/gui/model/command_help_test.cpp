#include "gui/model/command_help.h"

#include <atomic>
#include <thread>

#include <gmock/gmock.h>

#include "gui/model/rehearsals.h"
#include "tests/gui/model/toy_language.h"

namespace hw::gui {
namespace {

using ::testing::HasSubstr;

struct CommandHelpTest : ::testing::Test {
  std::string hint(const char* line) { return help.hint(line).sentence; }
  Catalog catalog = test::toy_catalog();
  CommandHelp help{catalog};
};

TEST_F(CommandHelpTest, SaysWhatEnterWouldDo) {
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

TEST_F(CommandHelpTest, UnknownCommandIsSaidSo) {
  EXPECT_TRUE(help.hint("zzz").unknown);
  EXPECT_THAT(hint("zzz"), HasSubstr("no command of this controller begins like this"));
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

TEST(Rehearsals, ResultComesInALaterFrameWithTheTextItIsOf) {
  test::ToyLanguage language;
  Worker worker;
  Rehearsals rehearsals;
  RehearseOptions options;
  options.slot = 1;
  const Catalog catalog;
  rehearsals.start(language, "I1\nI2\nI3", options, {}, {}, catalog, worker);
  rehearsals.start(language, "I1", options, {}, {}, catalog, worker);
  EXPECT_TRUE(rehearsals.under_way(1));
  EXPECT_EQ(rehearsals.of(1), nullptr);
  worker.deliver();
  EXPECT_EQ(language.rehearsed, 1);
  ASSERT_NE(rehearsals.of(1), nullptr);
  EXPECT_FALSE(rehearsals.under_way(1));
  EXPECT_EQ(rehearsals.of(1)->result->moves, 40);
  EXPECT_EQ(rehearsals.older_than_line(1, "I1\nI2\nI3"), -1);
  EXPECT_EQ(rehearsals.older_than_line(1, "I1\nI2\nI4"), 2);
}

TEST(Rehearsals, SayWhenTheyDoNotBeginWhereTheAxesStand) {
  test::ToyLanguage language;  // whose rehearsals begin at 0
  Worker worker;
  Rehearsals rehearsals;
  Catalog catalog;
  catalog.axes = {{"1", "motor 1"}, {"2", "motor 2"}};
  Snapshot now;
  now.axis_count = 2;
  now.axes[0].position_known = now.axes[1].position_known = true;
  BenchView bench;
  bench.present = true;
  rehearsals.start(language, "I1", {}, {now, {}}, bench, catalog, worker);
  worker.deliver();
  const auto stand = [&] {
    rehearsals.follow(now, bench, catalog);
    return rehearsals.of(0)->stand;
  };
  EXPECT_EQ(stand().footing, Footing::here);
  now.axes[1].position = Steps(400);
  EXPECT_EQ(stand(), (Stand{Footing::elsewhere, 1, Steps(0), Steps(400)}));
  now.axes[0].activity = Activity::moving;
  EXPECT_EQ(stand().footing, Footing::moving);
  now.axes[0].activity = Activity::idle, now.axes[1].position = Steps(0);
  bench.switches[0].plus = Steps(100);
  EXPECT_EQ(stand().footing, Footing::other_bench);
  bench.switches[0].plus.reset();
  now.axes[0].position_known = false;
  EXPECT_EQ(stand().footing, Footing::unknown);
  now.axes[0].position_known = true;
  EXPECT_EQ(stand().footing, Footing::here);
  now.program.owned = true, now.program.run = RunState::running, now.axes[0].position = Steps(7);
  EXPECT_EQ(stand().footing, Footing::here) << "it is on its way, and began there";
  now.program.run = RunState::idle;
  EXPECT_EQ(stand().footing, Footing::elsewhere);
}

// What has changed is told by its kind and its place, whatever it is of all that the rehearsal began from.
TEST(Rehearsals, SayWhatHasChangedOfTheWholeController) {
  test::ToyLanguage language;
  Worker worker;
  Rehearsals rehearsals;
  Catalog catalog;
  catalog.axes = {{"1", "motor 1"}};
  catalog.params.resize(3);
  catalog.params[2].fallback = 40;
  catalog.analog = {{"AI1", "mV", 0, 5000}, {"AI2", "mV", 0, 5000}};
  catalog.readouts.resize(4);
  catalog.readouts[2].id = "MM";
  catalog.readouts[3].id = "LTS", catalog.readouts[3].axis = 0;
  Snapshot now;
  now.analog[1] = 900, now.analog_known = 3;
  now.readouts_known.set(0).set(2);
  now.axes[0].has_encoder = true, now.axes[0].limits_known = true;
  now.axis_count = 1;
  now.axes[0].position_known = true;
  now.params[1].known = true, now.params[1].value = 7;
  now.outputs_known = now.inputs_known = 0xF;
  now.variables_known.set(5);
  std::string other_program = "I1M5";
  rehearsals.start(language, "I1", {}, {now, {{0, "old"}, {2, "I1M5"}}}, {}, catalog, worker);
  worker.deliver();
  const auto stand = [&] {
    rehearsals.follow(now, {}, catalog, [&](int slot) { return slot == 1 ? nullptr : &other_program; });
    return rehearsals.of(0)->stand;
  };
  EXPECT_EQ(stand(), Stand());
  const auto told = [&](auto change) {
    const Snapshot before = now;
    change();
    const Stand stood = stand();
    now = before;
    other_program = "I1M5";
    EXPECT_EQ(stand(), Stand()) << "as before";
    return stood;
  };
  EXPECT_EQ(told([&] { now.params[1].value = 8; }), (Stand{Footing::other_setup, 1, Steps(7), Steps(8)}));
  EXPECT_EQ(told([&] { now.params[2].known = true, now.params[2].value = 41; }),
            (Stand{Footing::other_setup, 2, Steps(40), Steps(41)}))
      << "it was taken to be 40";
  EXPECT_EQ(told([&] { now.params[2].known = true, now.params[2].value = 40; }), Stand());
  EXPECT_EQ(told([&] { now.outputs = 4; }), (Stand{Footing::other_output, 2, Steps(0), Steps(1)}));
  EXPECT_EQ(told([&] { now.inputs = 8; }), (Stand{Footing::other_input, 3, Steps(0), Steps(1)}));
  EXPECT_EQ(told([&] { now.variables[5] = -9; }), (Stand{Footing::other_variable, 5, Steps(0), Steps(-9)}));
  EXPECT_EQ(told([&] { now.axes[0].enabled = false; }).footing, Footing::other_power);
  EXPECT_EQ(told([&] { now.axes[0].error = AxisError::limit_plus; }).footing, Footing::other_power);
  EXPECT_EQ(told([&] { now.axes[0].alarm = true; }).footing, Footing::other_power);
  EXPECT_EQ(told([&] { now.axes[0].encoder = Steps(9); }).footing, Footing::other_encoder);
  EXPECT_EQ(told([&] { now.axes[0].encoder = Steps(1); }), Stand()) << "it only trembles";
  EXPECT_EQ(told([&] { now.axes[0].limit_plus = true; }).footing, Footing::other_switch);
  EXPECT_EQ(told([&] { now.axes[0].limits_known = false; }), Stand()) << "nobody knows them any more";
  EXPECT_EQ(told([&] { now.analog[1] = 100; }), (Stand{Footing::other_analog, 1, Steps(900), Steps(100)}));
  EXPECT_EQ(told([&] { now.analog[1] = 930; }), Stand()) << "it only trembles";
  EXPECT_EQ(told([&] { now.readouts[2] = 1; }), (Stand{Footing::other_readout, 2, Steps(0), Steps(1)}));
  EXPECT_EQ(told([&] { now.readouts_known.set(3), now.readouts[3] = 2; }),
            (Stand{Footing::other_readout, 3, Steps(0), Steps(2)}))
      << "it was taken to be off";
  EXPECT_EQ(told([&] { now.readouts[0] = 1; }), Stand()) << "no rehearsal begins from it";
  EXPECT_EQ(told([&] { other_program = "I1M6"; }), (Stand{Footing::other_program, 2, {}, {}}));
  EXPECT_EQ(told([&] { now.inputs_known = 0, now.inputs = 1; }), Stand()) << "nobody knows it any more";
}

// What is not compared afterwards does not come into a rehearsal at all.
TEST(Rehearsals, AreToldWhatIsComparedAndNothingElse) {
  test::ToyLanguage language;
  Worker worker;
  Rehearsals rehearsals;
  const Catalog catalog = test::toy_catalog();
  ControllerState from;
  from.now.axis_count = 2;
  from.now.axes[1].position = Steps(12), from.now.axes[1].position_known = true;
  from.now.axes[1].speed = Pps(5), from.now.readouts_known.set();
  from.programs[2] = "I1";
  rehearsals.start(language, "I1", {}, from, {}, catalog, worker);
  worker.deliver();
  const ControllerState& told = *rehearsals.of(0)->scene.state;
  EXPECT_EQ(told.now.axes[1].position, Steps(12));
  EXPECT_EQ(told.programs, from.programs);
  EXPECT_EQ(told.now.axes[1].speed, Pps());
  EXPECT_TRUE(told.now.readouts_known.none());
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
    EXPECT_TRUE(worker.idle());
  }
  EXPECT_GE(woken, 1);
}

TEST(Worker, FinishesFilesAtTheEndAndDropsResultsOfTheGone) {
  std::atomic<bool> ran = false;
  bool told = false;
  {
    Worker worker({}, true);
    auto gone = std::make_shared<int>(0);
    worker.run([&] { return ran = true, 0; }, [&](int) { told = true; }, gone);
    gone.reset();
  }
  EXPECT_TRUE(ran);
  EXPECT_FALSE(told);
}

}  // namespace
}  // namespace hw::gui
