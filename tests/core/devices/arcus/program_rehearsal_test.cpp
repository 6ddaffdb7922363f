#include <algorithm>

#include <gtest/gtest.h>

#include "core/device/controller_state.h"
#include "core/device/registry.h"

namespace hw::arcus {
namespace {

class ArcusRehearsal : public testing::TestWithParam<const char*> {
 protected:
  [[nodiscard]] Result<Rehearsal> rehearse(const char* text, double for_seconds = 3600) const {
    RehearseOptions options;
    options.for_seconds = for_seconds;
    return find_device_type(GetParam())->language().rehearse(text, options);
  }
};
INSTANTIATE_TEST_SUITE_P(Both, ArcusRehearsal, testing::Values("pmx-4ex-sa", "dmx-k-sa"),
                         [](const auto& info) { return std::string(info.param).substr(0, 3); });

TEST_P(ArcusRehearsal, ReportsWhereTheAxisGoes) {
  const auto r = rehearse("X1000\nWAITX\nX200\nWAITX\nDO2=1\nEND\n");
  ASSERT_TRUE(r) << r.error().sentence();
  EXPECT_TRUE(r->finished);
  EXPECT_EQ(r->error, "");
  ASSERT_FALSE(r->axes.empty());
  EXPECT_EQ(r->axes[0].name, "X");
  EXPECT_EQ(r->axes[0].position, 200);
  EXPECT_EQ(r->axes[0].minimum, 0);
  EXPECT_EQ(r->axes[0].maximum, 1000);
  EXPECT_EQ(r->axes[0].travel, 1800);
  EXPECT_EQ(r->outputs.at("2"), 1);
  EXPECT_EQ(r->moves, 2);
  EXPECT_EQ(r->program_size.at("0"), 6);
}

TEST_P(ArcusRehearsal, AnEndlessProgramIsStoppedAndNamesItsLine) {
  const auto r = rehearse("V1=1\nWHILE 1=1\nDELAY=100\nENDWHILE\nEND\n", 5);
  ASSERT_TRUE(r);
  EXPECT_FALSE(r->finished);
  EXPECT_DOUBLE_EQ(r->duration_s, 5);
  EXPECT_NE(r->error.find("Program 0, line"), std::string::npos) << r->error;
}

TEST_P(ArcusRehearsal, AnEventNamesTheLineOfTheProgramThatItComesOf) {
  const char* text = "V1=1\nX1000\nWAITX\nJOGX+\nDO=0\nDO2=1\nDELAY=500\nSTOPX\nWAITX\nEND\n";
  const auto r = rehearse(text);
  ASSERT_TRUE(r) << r.error().sentence();
  const ProgramReport report = find_device_type(GetParam())->language().analyse(text, 0);
  const auto line_of = [&](std::string_view what) {
    for (const RehearsedEvent& e : r->events)
      if (e.slot == 0 && e.what == what) return e.command;
    return -2;
  };
  ASSERT_FALSE(r->events.empty());
  EXPECT_EQ(r->events.front().command, report.lines[1].first_command) << r->events.front().what;
  EXPECT_EQ(line_of("jogs X +"), report.lines[3].first_command);
  EXPECT_EQ(line_of("output 2 on"), report.lines[5].first_command);
}

// A full turn about (1000, 0): the circle's far ends lie between the ends of the motion.
TEST(PmxRehearsal, ACircleReachesItsFarEndsExactly) {
  RehearseOptions options;
  const auto r = find_device_type("pmx-4ex-sa")
                     ->language()
                     .rehearse("HSPD=20000\nLSPD=20000\nABS\nCIRP1000:0\nWAITX\nEND\n", options);
  ASSERT_TRUE(r) << r.error().sentence();
  EXPECT_EQ(r->axes[0].minimum, 0);
  EXPECT_EQ(r->axes[0].maximum, 2000);
  EXPECT_EQ(r->axes[1].minimum, -1000);
  EXPECT_EQ(r->axes[1].maximum, 1000);
  EXPECT_EQ(r->axes[0].travel, 4000);
  EXPECT_EQ(r->axes[1].travel, 4000);
}

// Ends in the middle of a jog: 45 ramped from 100 to 1000 in 0.3 s, then 4.7 s at 1000 a second.
TEST_P(ArcusRehearsal, WhenTheTimeIsOverMovingAxesAreWhereTheyAre) {
  const auto r = rehearse("JOGX+\nEND\n", 5);
  ASSERT_TRUE(r) << r.error().sentence();
  EXPECT_FALSE(r->finished);
  EXPECT_NEAR(static_cast<double>(r->axes[0].position), 165 + 4700, 5);
  EXPECT_EQ(r->axes[0].travel, r->axes[0].position);
  EXPECT_EQ(r->axes[0].maximum, r->axes[0].position);
}

TEST_P(ArcusRehearsal, ACounterThatIsWrittenMakesNoWay) {
  const auto r = rehearse("X500\nWAITX\nPX=5000\nEND\n");
  ASSERT_TRUE(r) << r.error().sentence();
  EXPECT_TRUE(r->finished) << r->error;
  EXPECT_EQ(r->axes[0].position, 5000);
  EXPECT_EQ(r->axes[0].minimum, 0);
  EXPECT_EQ(r->axes[0].maximum, 5000);
  EXPECT_EQ(r->axes[0].travel, 500);
}

// The counter is zeroed at the switch, and the ramp goes on behind it.
TEST(PmxRehearsal, HomingMakesTheWayToTheSwitchAndBehindIt) {
  RehearseOptions options;
  options.bench_toml = "[axis.X]\nhome = [2000, 2600]\n";
  const auto r = find_device_type("pmx-4ex-sa")->language().rehearse("HOMEX+\nWAITX\nEND\n", options);
  ASSERT_TRUE(r) << r.error().sentence();
  EXPECT_TRUE(r->finished) << r->error;
  EXPECT_EQ(r->axes[0].position, 165);
  EXPECT_EQ(r->axes[0].maximum, 2000);
  EXPECT_EQ(r->axes[0].minimum, 0);
  EXPECT_EQ(r->axes[0].travel, 2165);
}

TEST_P(ArcusRehearsal, ReportsTheUnitOfItsCounts) {
  const auto r = rehearse("X1000\nWAITX\nEND\n");
  ASSERT_TRUE(r) << r.error().sentence();
  EXPECT_EQ(r->axes[0].in_counts, std::string_view(GetParam()) == "dmx-k-sa");
}

TEST_P(ArcusRehearsal, ATextWithAnErrorIsNotRehearsed) {
  const auto r = rehearse("X1\nFOO\nEND\n");
  ASSERT_FALSE(r);
  EXPECT_NE(r.error().sentence().find("Line 2"), std::string::npos);
  EXPECT_NE(r.error().sentence().find("Nothing was rehearsed"), std::string::npos);
}

TEST_P(ArcusRehearsal, AValueThatTheRegisterCannotHoldIsAnErrorOfTheProgram) {
  for (const char* register_ : {"DO", "EO", "PX", "EX"}) {
    const std::string name(register_);
    const auto r = rehearse(("V1=999999999\n" + name + "=V1\nEND\n").c_str());
    ASSERT_TRUE(r) << r.error().sentence();
    EXPECT_EQ(r->error, "Program 0, line 2, stopped with an error: " + name +
                            " cannot be set to the value of V1 here.");
    EXPECT_EQ(r->axes[0].position, 0);
  }
  const auto complement = rehearse("DO=3\nV1=~DO\nDO=V1\nEND\n");
  ASSERT_TRUE(complement);
  EXPECT_NE(complement->error, "");
  EXPECT_EQ(complement->outputs.at("1"), 1);
  const auto any_is_on = rehearse("V1=-7\nDO2=V1\nEND\n");  // AMB-094
  ASSERT_TRUE(any_is_on);
  EXPECT_EQ(any_is_on->error, "");
  EXPECT_EQ(any_is_on->outputs.at("2"), 1);
}

TEST_P(ArcusRehearsal, OneThatWaitsForEverEndsWhileItsTrackIsKept) {
  RehearseOptions options;
  options.for_seconds = 2, options.track_every_s = 0.3;
  options.bench_toml = "[[at]]\nt = 1.9\ninput = [1, true]\n";
  const auto r = find_device_type(GetParam())->language().rehearse("WHILE DI2=0\nENDWHILE\nEND\n", options);
  ASSERT_TRUE(r) << r.error().sentence();
  EXPECT_EQ(r->duration_s, 2);
}

TEST_P(ArcusRehearsal, ReportsWhyAProgramStoppedInError) {
  const auto why = [&](const char* text, const char* bench = "") {
    RehearseOptions options;
    options.bench_toml = bench;
    const auto r = find_device_type(GetParam())->language().rehearse(text, options);
    return r ? r->error : r.error().sentence();
  };
  EXPECT_EQ(why("V1=5/V2\nEND\n"), "Program 0, line 1, stopped with an error: a division by zero.");
  EXPECT_EQ(why("GOSUB 1\nEND\nSUB 1\nGOSUB 1\nENDSUB\n"),
            "Program 0, line 4, stopped with an error: its calls nest more than eight deep.");
  EXPECT_EQ(why("JOGX+\nWAITX\nEND\n", "[axis.X]\nplus = 500\n"),
            "Program 0, line 2, stopped with an error: a limit switch has stopped one of its axes, and "
            "nothing has cleared the error.");
}

TEST_P(ArcusRehearsal, ATextWithoutProgram0HasNothingToStart) {
  const auto other = rehearse("PRG 1\nX1000\nEND\n");
  ASSERT_FALSE(other);
  EXPECT_NE(other.error().sentence().find("no program 0 to start; the text has PRG 1"), std::string::npos)
      << other.error().sentence();
  const auto sub = rehearse("SUB 3\nX1000\nENDSUB\n");
  ASSERT_FALSE(sub);
  EXPECT_NE(sub.error().sentence().find("subroutines only"), std::string::npos) << sub.error().sentence();
  EXPECT_TRUE(rehearse(""));
}

// ---- from a controller that is known

std::shared_ptr<ControllerState> known_at_rest(const Catalog& catalog) {
  auto state = std::make_shared<ControllerState>();
  Snapshot& now = state->now;
  now.axis_count = static_cast<int>(catalog.axes.size());
  for (int i = 0; i < now.axis_count; ++i)
    now.axes[i].position_known = now.axes[i].has_encoder = now.axes[i].enabled = true;
  now.inputs_known = now.outputs_known = 0xFF;
  now.readouts_known.set();
  for (std::size_t i = 0; i < catalog.params.size(); ++i)
    now.params[i].known = true, now.params[i].value = catalog.params[i].fallback;
  return state;
}

TEST_P(ArcusRehearsal, BeginsFromTheControllerAsItIs) {
  const DeviceType& type = *find_device_type(GetParam());
  const Catalog catalog = type.make_catalog({}).value();
  auto state = known_at_rest(catalog);
  const bool one_axis = catalog.axes.size() == 1;
  const auto param = [&](const char* name) -> ParamState& {
    return state->now.params[static_cast<std::size_t>(catalog.find_param(name))];
  };
  param(one_axis ? "HSPD" : "HS").value = 400;
  param(one_axis ? "LSPD" : "LS").value = 400;
  if (one_axis) param("SL").value = 0;
  state->now.axes[0].position = Steps(250), state->now.axes[0].encoder = Steps(77);
  state->now.variables[3] = 650, state->now.variables_known.set(3);
  state->now.outputs = 0b10;
  state->now.inputs = 0b01;
  RehearseOptions options;
  options.from = state;
  const auto r = type.language().rehearse("XV3\nWAITX\nV4=EX\nIF DI1=1\nX600\nENDIF\nEND\n", options);
  ASSERT_TRUE(r) << r.error().sentence();
  EXPECT_EQ(r->error, "");
  EXPECT_EQ(r->axes[0].begin, 250);
  EXPECT_EQ(r->axes[0].maximum, 650);
  EXPECT_EQ(r->axes[0].position, 600) << "input 1 is on";
  EXPECT_EQ(r->axes[0].travel, 450);
  EXPECT_NEAR(r->duration_s, 450 / 400.0, 0.01);
  EXPECT_EQ(r->outputs.at("2"), 1);
  EXPECT_TRUE(r->assumptions.empty()) << r->assumptions[0].name;
}

TEST_P(ArcusRehearsal, NamesWhatCannotBeKnown) {
  const DeviceType& type = *find_device_type(GetParam());
  const Catalog catalog = type.make_catalog({}).value();
  auto state = known_at_rest(catalog);
  const std::string ramp = "ACC";
  state->now.params[static_cast<std::size_t>(catalog.find_param(ramp))].known = false;
  RehearseOptions options;
  options.from = state;
  const auto r = type.language().rehearse("V2=7\nX100\nWAITX\nIF V1=V2\nDO1=1\nENDIF\nEND\n", options);
  ASSERT_TRUE(r) << r.error().sentence();
  ASSERT_EQ(r->assumptions.size(), 2u);
  EXPECT_EQ(r->assumptions[0].name, ramp);
  EXPECT_EQ(r->assumptions[0].value, "300 ms");
  EXPECT_EQ(r->assumptions[1].name, "V1");
  EXPECT_EQ(r->assumptions[1].value, "0");
}

// Only a DMX has words for its latch.
TEST(ArcusRehearsalOfALatch, BeginsWithWhatItHasCaught) {
  const DeviceType& type = *find_device_type("dmx-k-sa");
  const Catalog catalog = type.make_catalog({}).value();
  auto state = known_at_rest(catalog);
  state->now.readouts_known.reset(static_cast<std::size_t>(catalog.find_readout("LTS")));
  const auto put = [&](const char* id, std::int64_t value) {
    const auto place = static_cast<std::size_t>(catalog.find_readout(id));
    state->now.readouts[place] = value, state->now.readouts_known.set(place);
  };
  const std::string text = "V1=LTSX\nIF V1=2\nV2=LTPX\nXV2\nWAITX\nENDIF\nEND\n";
  RehearseOptions options;
  options.from = state;
  const auto unknown = type.language().rehearse(text, options);
  ASSERT_TRUE(unknown) << unknown.error().sentence();
  EXPECT_EQ(unknown->axes[0].position, 0);
  ASSERT_EQ(unknown->assumptions.size(), 1u);
  EXPECT_EQ(unknown->assumptions[0].name, "LTS");
  EXPECT_EQ(unknown->assumptions[0].value, "off");
  put("LTS", 2), put("LTP", 345), put("LTE", 346);
  const auto caught = type.language().rehearse(text, options);
  ASSERT_TRUE(caught) << caught.error().sentence();
  EXPECT_EQ(caught->axes[0].position, 345);
  EXPECT_TRUE(caught->assumptions.empty());
  put("LTS", 1);
  state->now.inputs = 0xF;  // has been so for long: it is no edge
  const auto waits = type.language().rehearse("V1=LTSX\nXV1\nWAITX\nEND\n", options);
  ASSERT_TRUE(waits) << waits.error().sentence();
  EXPECT_EQ(waits->axes[0].position, 1);
}

TEST_P(ArcusRehearsal, AnAxisThatIsInErrorHoldsItsProgram) {
  const DeviceType& type = *find_device_type(GetParam());
  auto state = known_at_rest(type.make_catalog({}).value());
  state->now.axes[0].error = AxisError::limit_plus;
  RehearseOptions options;
  options.from = state;
  const auto r = type.language().rehearse("DO1=1\nX100\nEND\n", options);
  ASSERT_TRUE(r) << r.error().sentence();
  EXPECT_EQ(r->error,
            "Program 0, line 2, stopped with an error: a limit switch has stopped one of its axes, and "
            "nothing has cleared the error.");
}

TEST_P(ArcusRehearsal, ALimitIsReportedWithAxisDirectionLineAndTime) {
  RehearseOptions options;
  options.bench_toml = "[axis.X]\nplus = 500\n";
  const auto r = find_device_type(GetParam())
                     ->language()
                     .rehearse("HSPD=1000\nLSPD=1000\nEO=1\nX4000\nDELAY=3000\nEND\n", options);
  ASSERT_TRUE(r) << r.error().sentence();
  ASSERT_EQ(r->stops.size(), 1u);
  EXPECT_EQ(r->stops[0].axis, "X");
  EXPECT_EQ(r->stops[0].direction, 1);
  EXPECT_EQ(r->stops[0].line, 3);
  EXPECT_EQ(r->stops[0].reason, "Axis X runs into its plus limit switch.");
  EXPECT_NEAR(r->stops[0].t, 0.5, 0.2);
}

TEST(PmxRehearsal, ReportsWhyEachProgramStopped) {
  RehearseOptions options;
  const auto r = find_device_type("pmx-4ex-sa")
                     ->language()
                     .rehearse(
                         "PRG 0\nSR1=1\nDELAY=50\nV1=1/V9\nEND\nPRG 1\nDELAY=10\nDO=V8\nV8=99999\nDO=V8\n"
                         "END\n",
                         options);
  ASSERT_TRUE(r) << r.error().sentence();
  EXPECT_EQ(r->error,
            "Program 1, line 10, stopped with an error: DO cannot be set to the value of V8 here. Program 0, "
            "line 4, stopped with an error: a division by zero.");
  ASSERT_EQ(r->stops.size(), 2u);
  EXPECT_EQ(r->stops[0].line, 9);
  EXPECT_EQ(r->stops[1].line, 3);
  EXPECT_LT(r->stops[0].t, r->stops[1].t);
}

TEST_P(ArcusRehearsal, ALoopWithoutEndIsReportedWithItsLines) {
  const auto for_ever =
      rehearse("V1=1\nWHILE 1=1\nDELAY=100\nGOSUB 2\nENDWHILE\nEND\nSUB 2\nDELAY=7\nENDSUB\n", 5);
  ASSERT_TRUE(for_ever);
  EXPECT_TRUE(for_ever->endless);
  EXPECT_NE(for_ever->error.find("the loop of lines 2 to 5 has no end"), std::string::npos)
      << for_ever->error;
  const auto waits = rehearse("V1=1\nWHILE DI1=0\nENDWHILE\nEND\n", 5);
  ASSERT_TRUE(waits);
  EXPECT_TRUE(waits->endless);
  EXPECT_NE(waits->error.find("the loop of lines 2 to 3 waits for a value that nothing changes"),
            std::string::npos)
      << waits->error;
  ASSERT_FALSE(waits->events.empty());
  EXPECT_EQ(waits->events.back().what, "reads DI1: 0");
  const auto long_one = rehearse("V1=1\nWHILE V1<999\nV1=V1+1\nDELAY=100\nENDWHILE\nEND\n", 5);
  ASSERT_TRUE(long_one);
  EXPECT_FALSE(long_one->endless);
  EXPECT_NE(long_one->error.find("the loop of lines 2 to 5 had not ended"), std::string::npos)
      << long_one->error;
}

TEST(PmxRehearsal, EachLoopWithoutEndIsReported) {
  RehearseOptions options;
  options.for_seconds = 5;
  const auto& language = find_device_type("pmx-4ex-sa")->language();
  const auto r = language.rehearse(
      "PRG 0\nSR1=1\nWHILE 1=1\nDELAY=50\nENDWHILE\nEND\nPRG 1\nWHILE 1=1\nDELAY=30\nENDWHILE\nEND\n",
      options);
  ASSERT_TRUE(r) << r.error().sentence();
  EXPECT_TRUE(r->endless);
  EXPECT_NE(r->error.find("the loop of lines 3 to 5 has no end."), std::string::npos) << r->error;
  EXPECT_NE(r->error.find("the loop of lines 8 to 10 has no end."), std::string::npos) << r->error;
  ASSERT_EQ(r->stops.size(), 2u);
  EXPECT_NE(r->stops[0].reason.find("Program 0, line "), std::string::npos) << r->stops[0].reason;
  EXPECT_NE(r->stops[1].reason.find("Program 1, line "), std::string::npos) << r->stops[1].reason;
  const auto one = language.rehearse(
      "PRG 0\nSR1=1\nV1=1\nWHILE V1<999\nV1=V1+1\nDELAY=50\nENDWHILE\nEND\nPRG 1\nWHILE 1=1\nDELAY=30\n"
      "ENDWHILE\nEND\n",
      options);
  ASSERT_TRUE(one) << one.error().sentence();
  EXPECT_TRUE(one->endless) << "program 1 is";
}

// DO1 shows In Position and DO3 shows no alarm: what was written to them is behind that until SL=0.
TEST(DmxRehearsal, OutputsOffDutyBringOutWhatPowerUpHasWritten) {
  const DeviceType& dmx = *find_device_type("dmx-k-sa");
  const Catalog catalog = *dmx.make_catalog({});
  auto state = std::make_shared<ControllerState>();
  state->now.axis_count = 1;
  state->now.outputs_known = 7, state->now.outputs = 1;
  const RehearseOptions options = rehearse_from(state, BenchView(), catalog);
  const auto r = dmx.language().rehearse("SL=0\nDELAY=10\nEND\n", options);
  ASSERT_TRUE(r) << r.error().sentence();
  EXPECT_EQ(r->outputs_at_first.at("3"), 0);
  EXPECT_EQ(r->outputs.at("1"), 1);
  EXPECT_EQ(r->outputs.at("2"), 0) << "it shows what was written";
  EXPECT_EQ(r->outputs.at("3"), 1);
  const auto named = [](const RehearsedAssumption& a) {
    return a.name.find("last value written to") != std::string::npos;
  };
  EXPECT_EQ(std::count_if(r->assumptions.begin(), r->assumptions.end(), named), 2);
}

}  // namespace
}  // namespace hw::arcus
