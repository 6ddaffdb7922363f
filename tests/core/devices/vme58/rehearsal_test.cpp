// The data sheet's programming examples, run dry.
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/device/controller_state.h"
#include "core/devices/vme58/catalog.h"
#include "core/devices/vme58/program_language.h"

namespace hw::vme58 {
namespace {

using testing::HasSubstr;

Rehearsal rehearse(std::string_view text, RehearseOptions options = {}) {
  auto done = program_language().rehearse(text, options);
  EXPECT_TRUE(done) << (done ? "" : done.error().sentence());
  return done ? std::move(*done) : Rehearsal();
}

TEST(Vme58Rehearsal, HomeAndMove) {
  RehearseOptions options;
  options.bench_toml = "[axis.X]\nhome = [500, 600]\n";
  const Rehearsal r =
      rehearse("AX\nVL1000 AC10000\nKP2 KD6 HN\nHM0\nVL5000 AC50000\nMA-10000 GO ID\n", options);
  EXPECT_EQ(r.error, "");
  EXPECT_TRUE(r.finished);
  ASSERT_EQ(r.axes.size(), 8u) << "all axes of the board";
  EXPECT_EQ(r.axes[0].name, "X");
  EXPECT_EQ(r.axes[0].position, -10000);
  EXPECT_GT(r.duration_s, 2.5);
  EXPECT_LT(r.duration_s, 5);
}

TEST(Vme58Rehearsal, ThreeAxesTogether) {
  const Rehearsal r = rehearse(
      "AX KP2 KD6 HN\nAY KP2 KD6 HN\nAZ KP2 KD6 HN\nAM\nVL5000,5000,5000;\nAC50000,50000,50000;\n"
      "MA1000,2000,3000; GO ID\n");
  EXPECT_TRUE(r.finished) << r.error;
  ASSERT_EQ(r.axes.size(), 8u);
  EXPECT_EQ(r.axes[0].position, 1000);
  EXPECT_EQ(r.axes[1].position, 2000);
  EXPECT_EQ(r.axes[2].position, 3000);
  EXPECT_NEAR(r.duration_s, 0.7, 0.15);
}

TEST(Vme58Rehearsal, AHoleOfTenThousandCounts) {
  const Rehearsal r = rehearse(
      "AA\nCV1000\nCD,,0,0;\nAN0;\nCR0,5000,3.1415926\nCR0,0,6.2831853\nAF0;\nMT-10,10000\nCE\nMT,,-1000,0; "
      "GO\nCX\n");
  EXPECT_TRUE(r.finished) << r.error;
  EXPECT_EQ(r.axes[2].minimum, -10000);
  EXPECT_EQ(r.axes[2].maximum, 10000);
  EXPECT_EQ(r.axes[3].minimum, -10000);
  EXPECT_GE(r.duration_s, 78);
}

TEST(Vme58Rehearsal, SpeedStairsAreGoneUpBeforeWhatStandsBehindThem) {
  sequence::Sequence s;
  s.axes = {{"X"}, {"Z"}};
  sequence::Move behind;
  behind.to[0] = 100, behind.to[1] = 0;
  s.steps = {
      {sequence::Speed{{5000}}}, {sequence::SpeedStairs{1, {{2000, 1000}, {6000, 4000}}, 8000}}, {behind}};
  const auto text = program_language().write(s, *make_catalog({}));
  ASSERT_TRUE(text) << text.error().sentence();
  const Rehearsal r = rehearse(text->text);
  EXPECT_TRUE(r.finished) << r.error;
  EXPECT_EQ(r.axes[0].position, 100);
  EXPECT_EQ(r.axes[2].maximum, 8000) << "it rests there";
  EXPECT_EQ(r.axes[2].position, 0);
  EXPECT_GE(r.duration_s, 2 + 6000 / 4000.0 + 8000 / 5000.0) << "at its speeds";
  EXPECT_LT(r.duration_s, 7.5);
}

TEST(Vme58Rehearsal, ARejectedCommandEndsTheRehearsal) {
  const Rehearsal r = rehearse("AX HF\nMA1000 GO ID\n");
  EXPECT_FALSE(r.finished);
  EXPECT_THAT(r.error, HasSubstr("rejects"));
}

TEST(Vme58Rehearsal, AnEndlessTextEndsWithItsTime) {
  RehearseOptions options;
  options.for_seconds = 5;
  const Rehearsal r = rehearse("AX VL1000 JG1000\n", options);
  EXPECT_FALSE(r.finished);
  EXPECT_EQ(r.duration_s, 5);
  EXPECT_EQ(r.axes[0].position, 4999) << "short of 5000 by half of a ramp of 0.5 ms";
}

TEST(Vme58Rehearsal, AVerySlowJogIsNoRest) {
  for (const auto& [text, position] :
       {std::pair("AX JF0.25", 5), std::pair("AX JF0.4", 8), std::pair("AX JF0.6", 12)}) {
    RehearseOptions options;
    options.for_seconds = 21;
    const Rehearsal r = rehearse(text, options);
    EXPECT_FALSE(r.finished) << text;
    EXPECT_EQ(r.axes[0].position, position) << text;
  }
}

TEST(Vme58Rehearsal, TheEndsOfAWayAndItsLengthAreExact) {
  const auto span = [](const Rehearsal& r, std::size_t axis) {
    EXPECT_TRUE(r.finished) << r.error;
    return std::array{r.axes[axis].minimum, r.axes[axis].maximum, r.axes[axis].travel};
  };
  using Span = std::array<std::int64_t, 3>;
  EXPECT_EQ(span(rehearse("AX VL1000000 AC8000000 MR50 GO MR-50 GO"), 0), (Span{0, 50, 100}));
  EXPECT_EQ(span(rehearse("AX VL1000000 AC8000000 LS100 MR20 GO MR-20 GO LE"), 0), (Span{0, 20, 4000}));
  EXPECT_EQ(span(rehearse("AX LP100000"), 0), (Span{0, 100'000, 0})) << "nothing moves";
  const Rehearsal circle =
      rehearse("AA CV200000 AC8000000,8000000; MA1000,0;GO WA CD1000,0; CR0,0,6.2831853 CK CX");
  EXPECT_EQ(span(circle, 0)[0], -1000);
  EXPECT_EQ(span(circle, 0)[1], 1000);
  EXPECT_EQ(span(circle, 1)[0], -1000);
  EXPECT_EQ(span(circle, 1)[1], 1000);
  RehearseOptions options;
  options.bench_toml = "[axis.X]\nhome = [2000, 2400]\n";
  EXPECT_EQ(span(rehearse("AX VL1000 AC10000 HM0", options), 0), (Span{0, 2000, 2050}));
  EXPECT_EQ(span(rehearse("AX VL1000 AC10000 HM33500000", options), 0), (Span{0, 33'500'050, 2050}));
}

std::vector<std::pair<double, std::string>> events_of(const Rehearsal& r) {
  std::vector<std::pair<double, std::string>> all;
  for (const RehearsedEvent& e : r.events) all.emplace_back(std::round(e.t * 1e6) / 1e6, e.what);
  return all;
}
using Events = std::vector<std::pair<double, std::string>>;

TEST(Vme58Rehearsal, EachEventHasItsTime) {
  const Rehearsal r = rehearse("AX WT1000 MR10 GO WT1000 MR10 GO WT1000");
  EXPECT_EQ(
      events_of(r),
      (Events{
          {1, "X moves"}, {1.004472, "X rests at 10"}, {2.004472, "X moves"}, {2.008944, "X rests at 20"}}));
  EXPECT_EQ(r.moves, 2);
  EXPECT_NEAR(r.duration_s, 3.008944, 1e-6);
  EXPECT_EQ(rehearse("AX WT1500").duration_s, 1.5);
  EXPECT_NEAR(rehearse("AX AC10000 JG500 SP1000 ID").duration_s, 2.05, 1e-6);
  EXPECT_EQ(rehearse("AX").duration_s, 0);
}

TEST(Vme58Rehearsal, AHandComesAtItsTime) {
  RehearseOptions options;
  options.bench_toml = "[input]\n0 = true\n[[at]]\nt = 1.234\ninput = [0, false]\n";
  const Rehearsal r = rehearse("AX SW0 MR10 GO ID", options);
  EXPECT_EQ(events_of(r), (Events{{0, "reads line 0: low"},
                                  {1.234, "reads line 0: high"},
                                  {1.234, "X moves"},
                                  {1.238472, "X rests at 10"},
                                  {1.238472, "X done at 10"}}));
  EXPECT_NEAR(r.duration_s, 1.238472, 1e-6);
}

TEST(Vme58Rehearsal, OutputsAreAllOfThemAndOnIsOne) {
  const auto outputs = [](std::string_view text) { return rehearse(text).outputs; };
  const auto idle = outputs("AX");
  EXPECT_EQ(idle.size(), 14u);
  EXPECT_EQ(idle.at("8"), 0) << "high, which is off";
  EXPECT_EQ(idle.at("14"), 1) << "high, which is on (decision M37)";
  EXPECT_EQ(rehearse("BL8 AF").outputs_at_first, idle);
  EXPECT_EQ(outputs("BL8").at("8"), 1);
  EXPECT_EQ(outputs("AY AF").at("15"), 0);
  RehearseOptions options;
  options.device = {{"jumpers", "OIO"}, {"variant", "4"}};
  const auto other = rehearse("BL3", options).outputs;
  EXPECT_EQ(other.size(), 4u + 4 + 2 + 4);
  EXPECT_EQ(other.at("3"), 1);
  EXPECT_EQ(events_of(rehearse("AX BL8 WT5 BH8 AF AN RS")),
            (Events{{0, "Out 8 on"}, {0, "the board restarts"}, {0, "Out 8 off"}}))
      << "RS comes at once, and the queue with what waits is gone";
  EXPECT_EQ(events_of(rehearse("AX BL8 WT5 BH8 AF AN")),
            (Events{{0, "Out 8 on"}, {0.005, "Out 8 off"}, {0.005, "Aux X off"}, {0.005, "Aux X on"}}));
  EXPECT_EQ(outputs("AX PA1 SE100 MR5 GO").at("14"), 1);
}

TEST(Vme58Rehearsal, TheLaserOfAContourIsSeen) {
  const Rehearsal r = rehearse(
      "AX AF\nAA\nCV1000\nCD,,0,0;\nAN0;\nCR0,5000,3.1415926\nCR0,0,6.2831853\nAF0;\nMT-10,10000\nCE\n"
      "MT,,-1000,0; GO\nCX\n");
  std::vector<std::string> laser;
  for (const RehearsedEvent& e : r.events)
    if (e.what.substr(0, 3) == "Aux") laser.push_back(e.what);
  EXPECT_EQ(laser, (std::vector<std::string>{"Aux X off", "Aux X on", "Aux X off"}));
}

TEST(Vme58Rehearsal, AnEchoingBoardEndsToo) {
  const Rehearsal r = rehearse("AX EN VL1000 MR100 GO");
  EXPECT_TRUE(r.finished) << r.error;
  EXPECT_LT(r.duration_s, 1);
  EXPECT_THAT(r.sent_to_host, HasSubstr("MR100"));
}

TEST(Vme58Rehearsal, TheTextGoesOnBehindAReset) {
  EXPECT_EQ(rehearse("RS").duration_s, 0.1);
  const Rehearsal r = rehearse("AX BL8 MR5 GO RS MR7 GO RP");
  EXPECT_TRUE(r.finished) << r.error;
  EXPECT_EQ(r.axes[0].position, 7) << "the first move was cut before its first count";
  EXPECT_EQ(r.axes[0].travel, 7);
  EXPECT_EQ(r.outputs.at("8"), 0);
  EXPECT_NEAR(r.duration_s, 0.1 + 0.003742, 1e-6);
}

TEST(Vme58Rehearsal, TheTextGoesOnBehindAPowerCut) {
  RehearseOptions options;
  options.bench_toml = "[[at]]\nt = 1\npower_cycle = true\n";
  const Rehearsal r = rehearse("AX WT5000 WQ MR7 GO", options);
  EXPECT_TRUE(r.finished) << r.error;
  EXPECT_EQ(r.axes[0].position, 7);
}

TEST(Vme58Rehearsal, ACommandRejectedInAQueueIsNamedByItsLine) {
  EXPECT_EQ(rehearse("AX AC10000\nMP MV500,500 MA800\nGO RP").error, "Line 3: the board rejects \"GO\".");
  EXPECT_EQ(rehearse("AX AC10000 MP MV500,500 MM MV100,500 SP0").error,
            "Line 1: the board rejects \"MV100,500\".");
  EXPECT_EQ(rehearse("AX WT100 MA8\nGO WT100 HF\nMR5 GO").error, "Line 2: the board rejects \"GO\".")
      << "HF comes at once, before the move";
}

TEST(Vme58Rehearsal, LoopsOfSeveralAxesRunSideBySide) {
  const Rehearsal r = rehearse(
      "AX LS2 AY LS2 AZ LS2 AT LS2 AU LS2 AX MR5 GO LE AY MR6 GO LE AZ MR7 GO LE AT MR8 GO LE AU MR9 GO LE");
  EXPECT_TRUE(r.finished) << r.error;
  for (std::size_t i = 0; i < 5; ++i) EXPECT_EQ(r.axes[i].position, 2 * (5 + static_cast<int>(i)));
}

TEST(Vme58Rehearsal, ATabIsASpace) { EXPECT_EQ(rehearse("AX\tMR\t100\tGO").axes.at(0).position, 100); }

TEST(Vme58Rehearsal, RunsOnTheModelThatItIsMeantFor) {
  RehearseOptions options;
  options.device = {{"variant", "4s4"}};
  EXPECT_THAT(rehearse("AU KP2\n", options).error, HasSubstr("KP2")) << "U is a step axis there";
  EXPECT_EQ(rehearse("AU KP2\n").error, "") << "and a servo axis here";
  options.device = {{"variant", "4"}};
  EXPECT_THAT(rehearse("AX MR10 GO\nAU MR10 GO\n", options).error, HasSubstr("AU")) << "no such axis";
  options.device = {{"jumpers", "OIO"}};
  EXPECT_EQ(rehearse("BL3\n", options).error, "");
  options.device = {{"variant", "9"}};
  EXPECT_FALSE(program_language().rehearse("AX\n", options));
}

TEST(Vme58Rehearsal, RepliesAreSentToTheHost) {
  EXPECT_THAT(rehearse("AX LP55 RP").sent_to_host, HasSubstr("55"));
}

// ---- from a board that is known

std::shared_ptr<ControllerState> known_board(const Catalog& catalog) {
  auto state = std::make_shared<ControllerState>();
  Snapshot& now = state->now;
  now.axis_count = static_cast<int>(catalog.axes.size());
  for (int i = 0; i < now.axis_count; ++i) now.axes[i].position_known = true;
  now.inputs = now.inputs_known = 0x3FFF;
  now.outputs_known = (1u << catalog.outputs.size()) - 1;
  for (std::size_t i = 0; i < catalog.params.size(); ++i)
    now.params[i].known = true, now.params[i].value = catalog.params[i].fallback;
  return state;
}

TEST(Vme58Rehearsal, BeginsFromTheBoardAsItIs) {
  const Catalog catalog = make_catalog({}).value();
  auto state = known_board(catalog);
  const auto param = [&](const char* name) -> ParamState& {
    return state->now.params[static_cast<std::size_t>(catalog.find_param(name))];
  };
  param("VLX").value = 1000, param("ACX").value = 100'000, param("KPX").value = 250;
  param("LNY").value = 0;
  state->now.axes[0].position = state->now.axes[0].command = Steps(-300);
  state->now.outputs = 1u << static_cast<unsigned>(catalog.find_output(9));
  state->now.inputs &= ~(1u << 1);  // line 1 is low
  RehearseOptions options;
  options.from = state;
  options.for_seconds = 5;
  const Rehearsal r = rehearse("AX MA200 GO ID\nSW1 MA0 GO", options);
  EXPECT_EQ(r.axes.at(0).begin, -300);
  EXPECT_EQ(r.axes.at(0).position, 200) << "line 1 holds what is behind it";
  EXPECT_EQ(r.axes.at(0).maximum, 200);
  EXPECT_EQ(r.outputs_at_first.at("9"), 1);
  EXPECT_THAT(r.error, HasSubstr("line 2 waits until line 1 is high"));
  EXPECT_THAT(events_of(r), testing::Contains(testing::Pair(testing::_, "reads line 1: low")));
  ASSERT_EQ(r.assumptions.size(), 1u);
  EXPECT_EQ(r.assumptions[0].name, "UUX") << "no board tells its user units";
}

TEST(Vme58Rehearsal, AStepAxisBeginsWithItsEncoderWhereItStands) {
  RehearseOptions options;
  options.device = {{"variant", "4E"}};
  auto state = known_board(make_catalog(options.device).value());
  state->now.axes[0].has_encoder = true;
  state->now.axes[0].encoder = Steps(37);
  options.from = state;
  const Rehearsal r = rehearse("AX RE", options);
  EXPECT_THAT(r.sent_to_host, HasSubstr("37"));
  EXPECT_EQ(r.axes.at(0).begin, 0);
}

TEST(Vme58Rehearsal, AnEventNamesTheCommandThatIsAtWork) {
  const Rehearsal r = rehearse("AX VL1000 AC10000\nMR100 GO\nMR-100 GO ID\n");
  std::vector<int> begun;
  for (const RehearsedEvent& e : r.events)
    if (e.what == "X moves") begun.push_back(e.command);
  EXPECT_THAT(begun, testing::ElementsAre(4, 6)) << "both GO";
}

TEST(Vme58Rehearsal, NamesWhatCannotBeKnown) {
  const Catalog catalog = make_catalog({}).value();
  auto state = known_board(catalog);
  for (const char* name : {"HDX", "KPX", "HDY"})
    state->now.params[static_cast<std::size_t>(catalog.find_param(name))].known = false;
  RehearseOptions options;
  options.from = state;
  std::vector<std::string> names;
  for (const auto& a : rehearse("AX MR20 GO", options).assumptions) names.push_back(a.name + "=" + a.value);
  EXPECT_THAT(names, testing::ElementsAre("KPX=0.00", "HDX=0 counts", "UUX=off: positions in counts"));
}

TEST(Vme58Rehearsal, WaitingQueueEntriesAreNamedByTheirNumber) {
  const Catalog catalog = make_catalog({}).value();
  auto state = known_board(catalog);
  state->now.working = true;
  RehearseOptions options;
  options.from = state;
  const auto last = [&] {
    const auto all = rehearse("AX MR20 GO", options).assumptions;
    return all.empty() ? std::string() : all.back().name + ": " + all.back().value;
  };
  EXPECT_EQ(last(), "command queues: empty, since the board does not report what waits there");
  state->now.queue_known = 0b11;
  state->now.queue_free[0] = static_cast<std::int16_t>(catalog.queue_depth);
  state->now.queue_free[1] = static_cast<std::int16_t>(catalog.queue_depth - 12);
  EXPECT_EQ(last(), "queue of Y: empty, since the board does not report what its 12 entries say");
}

TEST(Vme58Rehearsal, ALimitIsReportedWithAxisDirectionLineAndTime) {
  RehearseOptions options;
  options.bench_toml = "[axis.Y]\nminus = -500\n";
  const Rehearsal r = rehearse("AX VL1000 AC1000000 MR10 GO\nAY VL1000 AC1000000\nMR-900 GO\n", options);
  ASSERT_EQ(r.stops.size(), 1u);
  EXPECT_EQ(r.stops[0].axis, "Y");
  EXPECT_EQ(r.stops[0].direction, -1);
  EXPECT_EQ(r.stops[0].line, 2);
  EXPECT_NEAR(r.stops[0].t, 0.5, 0.01);
}

TEST(Vme58Rehearsal, AnEndlessProgramIsReportedWithItsLine) {
  RehearseOptions options;
  options.for_seconds = 3;
  const Rehearsal loop = rehearse("AX VL1000 AC10000\nWH\nMR10 GO\nMR-10 GO\nWG\n", options);
  EXPECT_TRUE(loop.endless);
  EXPECT_THAT(loop.error, HasSubstr("the loop that begins in line 2 (WH) has no end"));
  const Rehearsal jog = rehearse("AX VL1000 AC10000\nJG100\n", options);
  EXPECT_TRUE(jog.endless);
  EXPECT_THAT(jog.error, HasSubstr("axis X is still moving, started by line 2"));
}

}  // namespace
}  // namespace hw::vme58
