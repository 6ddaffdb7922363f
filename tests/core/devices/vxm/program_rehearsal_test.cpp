// The dry run of program texts.
#include <cmath>
#include <ctime>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/device/controller_state.h"
#include "core/devices/vxm/catalog.h"
#include "core/devices/vxm/program_language.h"

using namespace hw;
using testing::HasSubstr;

namespace {

Rehearsal rehearse(std::string_view text, RehearseOptions options = {}) {
  auto r = vxm::program_language().rehearse(text, options);
  if (!r) {
    ADD_FAILURE() << r.error().sentence();
    return {};
  }
  return *r;
}

TEST(VxmRehearsal, Example6EndsWhereItBegan) {
  const Rehearsal r = rehearse("P10,I1M400,L10,I1M-3600\nR\n");
  EXPECT_TRUE(r.finished);
  EXPECT_EQ(r.error, "");
  ASSERT_EQ(r.axes.size(), 2u);
  EXPECT_EQ(r.axes[0].name, "1");
  EXPECT_EQ(r.axes[0].position, 0);
  EXPECT_EQ(r.axes[0].maximum, 3600);
  EXPECT_EQ(r.axes[0].minimum, 0);
  EXPECT_EQ(r.axes[0].travel, 7200);
  EXPECT_EQ(r.program_size.at("0"), 14);
  EXPECT_EQ(r.sent_to_host, "^");
  EXPECT_EQ(r.moves, 10);
  // Ten seconds of pauses, nine triangles of 400 steps, one trapezoid of 3600.
  EXPECT_NEAR(r.duration_s, 10 + 9 * 2 * std::sqrt(400 / 2000.0) + (1 + 1600 / 2000.0 + 1), 1e-6);
  ASSERT_FALSE(r.events.empty());
  EXPECT_EQ(r.events[0].what, "P10");
  EXPECT_EQ(r.events[0].command, 0);
}

TEST(VxmRehearsal, AnswersTheWaitForTheHost) {
  const Rehearsal r = rehearse("I1M200, P10, L7, I2M400, L-4, U6, LM-2, R");
  EXPECT_TRUE(r.finished);
  EXPECT_EQ(r.sent_to_host, "WW^");
  EXPECT_EQ(r.axes[0].position, 0);
  EXPECT_EQ(r.axes[1].position, 0);
  EXPECT_EQ(r.axes[1].maximum, 1200);
  int answers = 0;
  for (const auto& e : r.events) answers += e.what == "the host answers W with G";
  EXPECT_EQ(answers, 2);
}

TEST(VxmRehearsal, AWaitWithoutEndIsDescribed) {
  RehearseOptions options;
  options.for_seconds = 120;
  const Rehearsal r = rehearse("I1M400,U50,I1M-400", options);
  EXPECT_FALSE(r.finished);
  EXPECT_EQ(r.duration_s, 120);
  EXPECT_EQ(r.error, "Program 0 waits in U50 for input 1, and nothing switches it.");
  EXPECT_EQ(r.axes[0].position, 400);
}

TEST(VxmRehearsal, ABenchFileOperatesTheInput) {
  RehearseOptions options;
  options.bench_toml = "[[at]]\nt = 2.0\ninput = [1, true]\n[[at]]\nt = 2.5\ninput = [1, false]\n";
  const Rehearsal r = rehearse("U50,I1M-400", options);
  EXPECT_TRUE(r.finished) << r.error;
  EXPECT_NEAR(r.duration_s, 2.52 + 2 * std::sqrt(400 / 2000.0), 1e-6);
}

TEST(VxmRehearsal, EndlessProgramsEnd) {
  RehearseOptions options;
  options.for_seconds = 3600;
  const std::clock_t began = std::clock();  // of the processor: other work on the machine does not count
  for (const auto* text : {"I1M400,P10,I1M-400,L0", "L0", "U5,U4,L0", "LM0,LA65535,LA65535,LA65535", "J0"}) {
    const Rehearsal r = rehearse(text, options);
    EXPECT_FALSE(r.finished);
    EXPECT_EQ(r.duration_s, 3600) << text;
    EXPECT_THAT(r.error, HasSubstr("still running"));
  }
  EXPECT_LT(std::clock() - began, 20 * CLOCKS_PER_SEC);
}

TEST(VxmRehearsal, ErrorsOfTheRunAreSentences) {
  const Rehearsal r = rehearse("PM-1,JM2,PM-2,JM3,PM-3,JM4,PM-4,JM1,PM-0,JM1");
  EXPECT_FALSE(r.finished);
  EXPECT_THAT(r.error, HasSubstr("more than four JM jumps"));
  EXPECT_EQ(r.sent_to_host, "EJ");
}

TEST(VxmRehearsal, HomingTouchesTheLimit) {
  const Rehearsal r = rehearse("S1M600,I1M0,I1M-200,IA1M-0,R");
  EXPECT_TRUE(r.finished);
  EXPECT_TRUE(r.limit_touched);
  EXPECT_EQ(r.axes[0].position, 0);
  EXPECT_EQ(r.axes[0].travel, 100200);
}

TEST(VxmRehearsal, AnAbsoluteMoveDependsOnWhereItBegins) {
  RehearseOptions options;
  options.start_at = {400, -50};
  const Rehearsal r = rehearse("IA1M400,IA2M0", options);
  EXPECT_EQ(r.axes[0].position, 400);
  EXPECT_EQ(r.axes[0].travel, 0);
  EXPECT_EQ(r.axes[0].minimum, 400);
  EXPECT_EQ(r.axes[1].travel, 50);
  EXPECT_EQ(r.axes[1].maximum, 0);
}

TEST(VxmRehearsal, MotorsThreeAndFourNeedTheSlave) {
  const Rehearsal r = rehearse("(I3M800,I1M400,)R");
  ASSERT_EQ(r.axes.size(), 4u);
  EXPECT_EQ(r.axes[2].position, 800);
  EXPECT_EQ(r.axes[0].position, 400);
  EXPECT_NEAR(r.duration_s, 2 * std::sqrt(800 / 2000.0), 1e-6);
}

TEST(VxmRehearsal, ATextWithErrorsIsNotRun) {
  const auto r = vxm::program_language().rehearse("I1M400\nS1M9999", {});
  ASSERT_FALSE(r);
  EXPECT_THAT(r.error().sentence(), HasSubstr("Line 2: 9999 is too fast for motor 1."));
  EXPECT_THAT(r.error().sentence(), HasSubstr("Nothing was rehearsed."));
}

TEST(VxmRehearsal, OneHourIsQuick) {
  // 1,200 moves and as many pauses.
  RehearseOptions options;
  options.for_seconds = 7200;
  const std::clock_t began = std::clock();
  const Rehearsal r = rehearse("I1M2000,P10,L-600,LM0,I2M2000,P10,I2M-2000,L600", options);
  const std::clock_t took = std::clock() - began;
  EXPECT_TRUE(r.finished);
  EXPECT_GT(r.duration_s, 3600);
#if defined(NDEBUG) && !defined(HW_SANITIZED)
  EXPECT_LT(took, CLOCKS_PER_SEC / 5) << "a shared machine: the figure itself is in tests/bench";
#endif
  (void)took;
}

// ---- setDM in the text

TEST(VxmRehearsal, InNf90EmulationRampsAreDoubled) {
  EXPECT_NEAR(rehearse("setDM9,I1M400,\n").duration_s, 2 * std::sqrt(400 / 4000.0), 1e-6);
  EXPECT_NEAR(rehearse("setDM9,setDM1,I1M400,\n").duration_s, 2 * std::sqrt(400 / 2000.0), 1e-6);
}

TEST(VxmRehearsal, InNf90EmulationIM0GoesToZero) {
  const Rehearsal r = rehearse("setDM9\nI1M100,I1M0,\n");
  EXPECT_EQ(r.axes[0].position, 0);
  EXPECT_FALSE(r.limit_touched);
  EXPECT_NEAR(r.duration_s, 4 * std::sqrt(100 / 4000.0), 1e-6);
}

TEST(VxmRehearsal, InNf90EmulationPausesRaiseOutputOne) {
  RehearseOptions options;
  options.for_seconds = 0.25;
  EXPECT_EQ(rehearse("setDM9\nP5\n", options).outputs.at("1"), 1);
  EXPECT_EQ(rehearse("setDM9\nP5\n").outputs.at("1"), 0);
  EXPECT_EQ(rehearse("P5\n", options).outputs.at("1"), 0);
}

TEST(VxmRehearsal, InNf90EmulationLMinusZeroIsAMarker) {
  const Rehearsal r = rehearse("setDM9\nI1M100,L-0,I1M5,L3,\n");
  EXPECT_EQ(r.axes[0].position, 110) << "back to behind the marker, the last pass without the index";
  EXPECT_EQ(r.program_size.at("0"), 12);
  EXPECT_FALSE(vxm::program_language().rehearse("L-0,I1M5,L3,\n", {}).has_value());
}

TEST(VxmRehearsal, ProgramFourComesFirstWithItsBitOfSetDM) {
  const Rehearsal r = rehearse("setDM129\nPM4,I2M7,PM0,I1M5,\n");
  EXPECT_EQ(r.axes[0].position, 5);
  EXPECT_EQ(r.axes[1].position, 7);
}

TEST(VxmRehearsal, TheSlaveThatTheMotorsNeedIsThereWhateverSetDMIs) {
  const Rehearsal r = rehearse("setDM9\nI3M400,\n");
  EXPECT_EQ(r.error, "");
  ASSERT_EQ(r.axes.size(), 4u);
  EXPECT_EQ(r.axes[2].position, 400);
  EXPECT_NEAR(r.duration_s, 2 * std::sqrt(400 / 4000.0), 1e-6);
  EXPECT_EQ(rehearse("setDM65\nI1M4,\n").error, "");
}

TEST(VxmRehearsal, RunsTheProgramThatTheTextRuns) {
  const Rehearsal r = rehearse("PM2,I1M5,R\n");
  EXPECT_EQ(r.axes[0].position, 5);
  EXPECT_EQ(r.events.at(0).slot, 2);
  EXPECT_EQ(rehearse("PM1,I1M3,PM2,I1M5,PM1,R,PM0,I1M9,\n").axes[0].position, 3);
  EXPECT_EQ(rehearse("PM2,I1M5,\n").axes[0].position, 5) << "without R: program 0 is empty";
  EXPECT_EQ(rehearse("PM2,I1M5,PM0,I1M7,PM2,\n").axes[0].position, 7) << "program 0 is not";
  RehearseOptions options;
  options.slot = 3;
  EXPECT_EQ(rehearse("I1M8\n", options).axes[0].position, 8);
}

TEST(VxmRehearsal, AFractionIsDropped) {
  const Rehearsal r = rehearse("I1M400.0\nP10.0,I1M5.75,\n");
  EXPECT_EQ(r.axes[0].position, 405);
  EXPECT_EQ(r.program_size.at("0"), 11);
}

// ---- from a controller that is known

std::shared_ptr<ControllerState> vxm_at_rest() {
  auto state = std::make_shared<ControllerState>();
  const Catalog catalog = vxm::make_catalog({}).value();
  state->now.axis_count = 2;
  state->now.axes[0].position_known = state->now.axes[1].position_known = true;
  state->now.inputs = 0xFF, state->now.inputs_known = 0xFF;
  state->now.outputs_known = 0xF;
  for (std::size_t i = 0; i < catalog.params.size(); ++i) {
    state->now.params[i].known = catalog.params[i].readable;
    state->now.params[i].value = catalog.params[i].fallback;
  }
  return state;
}
std::vector<std::string> assumed_in(const Rehearsal& r) {
  std::vector<std::string> all;
  for (const RehearsedAssumption& a : r.assumptions) all.push_back(a.name + "=" + a.value);
  return all;
}

TEST(VxmRehearsal, BeginsFromTheControllerAsItIs) {
  const Catalog catalog = vxm::make_catalog({}).value();
  auto state = vxm_at_rest();
  state->now.axes[0].position = Steps(432), state->now.axes[1].position = Steps(-50);
  const auto backlash = static_cast<std::size_t>(catalog.find_param("Bx"));
  state->now.params[backlash].value = 7;
  state->now.outputs = 0b0100;
  state->now.inputs = 0xFF & ~1u;  // input 1 is operated
  state->programs[2] = "I2M77";
  RehearseOptions options;
  options.from = state;
  const Rehearsal r = rehearse("S1M2000,A1M2,S2M2000,A2M2,IA1M400,U0,JM2", options);
  EXPECT_EQ(r.error, "");
  EXPECT_EQ(r.axes[0].begin, 432);
  EXPECT_EQ(r.axes[0].position, 400);
  EXPECT_EQ(r.axes[0].minimum, 393) << "backlash overruns";
  EXPECT_EQ(r.axes[1].position, 27) << "program 2 is the controller's";
  EXPECT_EQ(r.outputs.at("3"), 1);
  EXPECT_EQ(r.outputs_at_first.at("3"), 1);
  EXPECT_TRUE(r.finished) << "the wait for input 1 ends";
  EXPECT_THAT(assumed_in(r), testing::IsEmpty());
}

TEST(VxmRehearsal, NamesWhatCannotBeKnown) {
  const Catalog catalog = vxm::make_catalog({}).value();
  auto state = vxm_at_rest();
  state->now.axes[1].position_known = false;
  state->now.params[static_cast<std::size_t>(catalog.find_param("Bx"))].known = false;
  state->now.params[static_cast<std::size_t>(catalog.find_param("L2M"))].known = false;
  RehearseOptions options;
  options.from = state;
  EXPECT_THAT(assumed_in(rehearse("A1M3,I1M400", options)),
              testing::ElementsAre("S1M=2000 steps/s, as after power-up", "Bx=0 steps"))
      << "of motor 2, which does not move, nothing is taken for granted";
  EXPECT_THAT(assumed_in(rehearse("S2M900,A2M3,I2M400,A2M4", options)),
              testing::ElementsAre("L2M=0", "Bx=0 steps", "position of 2=0"));
}

TEST(VxmRehearsal, NamesUnreadProgramsThatTheRunMayReach) {
  auto state = vxm_at_rest();
  state->now.slot_bytes_used.fill(-1);
  state->now.slot_bytes_used[1] = 0;
  state->programs[2] = "JM4";
  RehearseOptions options;
  options.from = state;
  const auto assumed = [&](std::string_view text) { return assumed_in(rehearse(text, options)); };
  const std::string of_3 = "program 3=empty, because it was not read";
  const std::string of_4 = "program 4=empty, because it was not read";
  const std::string speed = "S1M900,A1M2,I1M100,";
  EXPECT_THAT(assumed(speed + "JM3"), testing::ElementsAre(of_3));
  EXPECT_THAT(assumed(speed + "J3"), testing::ElementsAre(of_3));
  EXPECT_THAT(assumed(speed + "JM-3"), testing::ElementsAre(of_3));
  EXPECT_THAT(assumed(speed + "U11,JM3"), testing::ElementsAre(of_3)) << "though the input leaves it out";
  EXPECT_THAT(assumed(speed + "JM2"), testing::ElementsAre(of_4)) << "program 2 goes on there";
  EXPECT_THAT(assumed(speed + "JM1"), testing::IsEmpty()) << "it holds nothing";
  EXPECT_THAT(assumed(speed), testing::IsEmpty());
  EXPECT_THAT(assumed("PM-3,I1M5,PM-0," + speed + "JM3"), testing::Not(testing::Contains(of_3)))
      << "the text fills it";
  state->now.inputs = 0xFF & ~4u;  // input 3 is operated
  EXPECT_THAT(assumed(speed + "U0"), testing::ElementsAre(of_3)) << "a wait ends there";
  state->now.slot_bytes_used[2] = 9, state->programs.clear();
  EXPECT_THAT(assumed(speed + "U23"), testing::Contains("program 2=empty, because it was not read"));
}

TEST(VxmRehearsal, TheAnalogInputIsAsItIsRead) {
  auto state = vxm_at_rest();
  state->now.analog[0] = 1024, state->now.analog_known = 1;
  RehearseOptions options;
  options.from = state;
  const Rehearsal fast = rehearse("A1M9,S1M-1,I1M2000", options);
  EXPECT_THAT(assumed_in(fast), testing::IsEmpty());
  state->now.analog[0] = 256;
  EXPECT_GT(rehearse("A1M9,S1M-1,I1M2000", options).duration_s, 3 * fast.duration_s);
  state->now.analog_known = 0;
  const std::string middle = "analog input=512, the middle";
  EXPECT_THAT(assumed_in(rehearse("A1M9,S1M-1,I1M2000", options)), testing::ElementsAre(middle));
  EXPECT_THAT(assumed_in(rehearse("A1M9,SA1M-1,I1M2000", options)), testing::ElementsAre(middle));
  EXPECT_THAT(assumed_in(rehearse("A1M9,S1M900,I1M2000", options)), testing::IsEmpty());
}

TEST(VxmRehearsal, ALimitIsReportedWithMotorDirectionLineAndTime) {
  RehearseOptions options;
  options.bench_toml = "[axis.1]\nminus = -500\nplus = 1000\n";
  const Rehearsal r = rehearse("I1M400\nP10\nI1M4000\nI2M10\n", options);
  ASSERT_EQ(r.stops.size(), 1u);
  EXPECT_EQ(r.stops[0].axis, "1");
  EXPECT_EQ(r.stops[0].direction, 1);
  EXPECT_EQ(r.stops[0].line, 2);
  EXPECT_EQ(r.stops[0].reason, "Motor 1 runs into its plus limit switch.");
  const double first = 2 * std::sqrt(400 / 2000.0);
  EXPECT_NEAR(r.stops[0].t, first + 1 + std::sqrt(2 * 600 / 2000.0), 1e-3);
  EXPECT_TRUE(r.finished) << "O=0: the program goes on";
  EXPECT_THAT(rehearse("S1M600,I1M0", options).stops, testing::IsEmpty()) << "it was to go there";
}

TEST(VxmRehearsal, ALoopWithoutEndIsReportedWithItsLines) {
  RehearseOptions options;
  options.for_seconds = 30;
  const Rehearsal r = rehearse("S1M2000\nLM0\nI1M400\nI1M-400\nL0\n", options);
  EXPECT_TRUE(r.endless);
  EXPECT_EQ(
      r.error,
      "Program 0 was still running when the rehearsal ended: the loop of lines 3 to 5 (L0) has no end.");
  ASSERT_EQ(r.stops.size(), 1u);
  EXPECT_EQ(r.stops[0].reason, r.error);
  EXPECT_EQ(r.stops[0].t, 30);
  EXPECT_FALSE(rehearse("LM0\nI1M4\nU21\nL0\nI1M9\n", options).endless) << "an input may lead out of it";
  const Rehearsal again = rehearse("P5\nJ0\n", options);
  EXPECT_TRUE(again.endless);
  EXPECT_THAT(again.error, HasSubstr("the loop of lines 1 to 2 (J0) has no end"));
  EXPECT_FALSE(rehearse("P10\nL65535\n", options).endless) << "it only takes long";
}

TEST(VxmRehearsal, ALoopOfJumpsThroughProgramsIsReportedWithItsLines) {
  RehearseOptions options;
  options.for_seconds = 31;
  const Rehearsal r = rehearse("PM-0\nP5\nJ1\nPM-1\nP7\nJ0\n", options);
  EXPECT_TRUE(r.endless);
  EXPECT_THAT(r.error, HasSubstr("the loop of lines 2 to 3 and lines 5 to 6 (J1) has no end"));
  ASSERT_EQ(r.stops.size(), 1u);
  EXPECT_EQ(r.stops[0].line, 4);
  EXPECT_TRUE(rehearse("PM-0\nP5,J1\nPM-1\nJM2,J0\nPM-2\nP5\n", options).endless);

  const auto goes_round = [&](std::string_view text) {
    const Rehearsal going = rehearse(text, options);
    EXPECT_FALSE(going.endless) << text;
    EXPECT_THAT(going.error, HasSubstr("had not ended")) << text;
  };
  goes_round("PM-0\nP5,J1\nPM-1\nP7,U21,J0\n");
  goes_round("PM-0\nP5,J1\nPM-1\nP7,JM2,J0\nPM-2\nU21,P1\n");
}

TEST(VxmRehearsal, AJumpThatOnlyGoesOnIsNoLoop) {
  RehearseOptions options;
  options.for_seconds = 31;
  const Rehearsal once = rehearse("PM-0\nP5,J1\nPM-1\nP10,L65535\n", options);
  EXPECT_FALSE(once.endless);
  EXPECT_THAT(once.error, testing::Not(HasSubstr("loop"))) << "a counted one ends";
  const Rehearsal again = rehearse("PM-0\nJM1,L65535\nPM-1\nP5,J2\nPM-2\nP7\n", options);
  EXPECT_FALSE(again.endless) << "it comes to J2 again and again, and back from there";
}

TEST(VxmRehearsal, OutputsAndWaitsStandOnTheTimeLine) {
  RehearseOptions options;
  options.bench_toml = "[[at]]\nt = 2.0\ninput = [1, true]\n";
  const Rehearsal r = rehearse("U5,U0,U4,P5", options);
  std::vector<std::string> seen;
  for (const RehearsedEvent& e : r.events)
    if (e.command < 0) seen.push_back(e.what);
  EXPECT_THAT(seen, testing::ElementsAre("output 1 on", "waits for input 1", "output 1 off", "goes on",
                                         "the program ends"));
}

}  // namespace
