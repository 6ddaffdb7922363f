#include "tests/transports/agreement_cases.h"

#include <ostream>

namespace hw::test {
namespace {

AxisTarget to(int axis, std::int64_t value) {
  AxisTarget target;
  target.axis = AxisId{static_cast<std::uint8_t>(axis)};
  target.value = Steps(value);
  return target;
}
IntentBody moved(std::vector<std::int64_t> places) {
  std::vector<AxisTarget> targets;
  for (const std::int64_t place : places) targets.push_back(to(static_cast<int>(targets.size()), place));
  return intent::MoveTo(std::move(targets));
}
IntentBody set(std::string mnemonic, std::int64_t value) {
  return intent::SetParam(std::move(mnemonic), value, true);
}

std::string file(const std::string& name) { return "@" + name; }
BenchCommand travel(int axis, std::int64_t minus, std::int64_t plus) {
  AxisPlace place;
  place.minus = Steps(minus), place.plus = Steps(plus);
  return bench::Place(AxisId{static_cast<std::uint8_t>(axis)}, place);
}
BenchCommand home(int axis, std::int64_t from, std::int64_t to) {
  AxisPlace place;
  place.home_from = Steps(from), place.home_to = Steps(to);
  return bench::Place(AxisId{static_cast<std::uint8_t>(axis)}, place);
}

// Both manuals of the family print the same eight programs; inputs come and go as their comments ask.
constexpr const char* four_taps =
    "[[at]]\nt = 0.05\ninput = [1, true]\n[[at]]\nt = 0.075\ninput = [1, false]\n"
    "[[at]]\nt = 0.2\ninput = [2, true]\n[[at]]\nt = 0.225\ninput = [2, false]\n"
    "[[at]]\nt = 0.4\ninput = [3, true]\n[[at]]\nt = 0.425\ninput = [3, false]\n"
    "[[at]]\nt = 0.6\ninput = [5, true]\n[[at]]\nt = 0.625\ninput = [5, false]\n";
constexpr const char* held_a_second =
    "[[at]]\nt = 0.5\ninput = [1, true]\n[[at]]\nt = 1.5\ninput = [1, false]\n";
constexpr const char* three_taps =
    "[[at]]\nt = 0.1\ninput = [1, true]\n[[at]]\nt = 0.3\ninput = [1, false]\n"
    "[[at]]\nt = 0.4\ninput = [1, true]\n[[at]]\nt = 0.7\ninput = [1, false]\n"
    "[[at]]\nt = 0.75\ninput = [1, true]\n";
constexpr const char* stopped_for_a_second =
    "[[at]]\nt = 1.0\ninput = [1, true]\n[[at]]\nt = 2.0\ninput = [1, false]\n";

constexpr double a_minute = 60;  // of those that do not end

std::vector<AgreementCase> arcus_cases(const std::string& family) {
  const auto example = [&](int n) {
    return file("language/good/" + family + "_example_" + std::to_string(n) + ".prg");
  };
  return {
      {"example_1", example(1)},
      {"example_2", example(2), 0, a_minute},
      {"example_3", example(3)},
      {"example_4", example(4), 0, a_minute, held_a_second},
      {"example_5", example(5), 0, a_minute, three_taps},
      {"example_6", example(6), 0, a_minute, four_taps, "", {}, {home(0, -600, 0)}},
      {"example_7", example(7), 1, a_minute, stopped_for_a_second},
      {"example_8", example(8), 0, a_minute},
      {"example_8_watch", example(8), 1, a_minute},
  };
}

}  // namespace

std::vector<AgreementCase> pmx_cases() {
  std::vector<AgreementCase> all = arcus_cases("pmx");
  const std::string line = "ABS\nX2000Y1000\nWAITX\nXV1\nWAITX\nIF DI2=1\nDO3=1\nYV2\nWAITY\nENDIF\nEND\n";
  all.push_back({"speeds_places_lines_variables",
                 line,
                 0,
                 60,
                 "",
                 "",
                 {intent::SetPower(-1, true), set("HS", 3210), set("LS", 210), set("ACC", 170),
                  set("SCVX", 1), set("DIP", 1), moved({777, -333, 50}), intent::SetVariable(1, -450),
                  intent::SetVariable(2, 90), intent::SetOutput(3, true), intent::SetOutput(5, true)},
                 {bench::Input(1, true)}});
  all.push_back({"step_n_loop",
                 "HSPD=5000\nLSPD=500\nX1000Y400\nWAITX\nX-250\nWAITX\nEND\n",
                 0,
                 60,
                 "",
                 "",
                 {intent::SetPower(-1, true), set("SLX", 1), set("SLY", 1), moved({120, 60})}});
  all.push_back({"into_a_limit",
                 "HSPD=8000\nX5000\nWAITX\nEND\nSUB 31\nECLEARX\nY900\nWAITY\nENDSUB\n",
                 0,
                 10,
                 "",
                 "",
                 {intent::SetPower(-1, true)},
                 {travel(0, -2000, 1500)}});
  return all;
}

std::vector<AgreementCase> dmx_cases() {
  std::vector<AgreementCase> all = arcus_cases("dmx");
  all.push_back({"step_n_loop_and_variables",
                 "X1000\nWAITX\nXV1\nWAITX\nIF DI2=1\nDO2=1\nX5\nWAITX\nENDIF\nEND\n",
                 0,
                 60,
                 "",
                 "",
                 {intent::SetPower(-1, true), set("HSPD", 4321), set("ACC", 120), moved({333}),
                  intent::SetVariable(1, -77)},
                 {bench::Input(2, true)}});
  all.push_back({"open_loop",
                 "X1000\nWAITX\nX-250\nWAITX\nEND\n",
                 0,
                 60,
                 "",
                 "",
                 {intent::SetPower(-1, true), set("SL", 0), set("HSPD", 2500), moved({150})}});
  return all;
}

std::vector<AgreementCase> vxm_cases() {
  const auto example = [](int n) {
    return file("core/devices/vxm/examples/example_" + std::to_string(n) + ".vxm");
  };
  const char* taps =
      "[[at]]\nt = 3.0\ninput = [1, true]\n[[at]]\nt = 3.1\ninput = [1, false]\n"
      "[[at]]\nt = 6.0\ninput = [1, true]\n[[at]]\nt = 6.1\ninput = [1, false]\n"
      "[[at]]\nt = 9.0\ninput = [1, true]\n[[at]]\nt = 9.1\ninput = [1, false]\n";
  const char* run_button =
      "[[at]]\nt = 110.0\nbutton = [\"Run\", true]\n[[at]]\nt = 110.2\nbutton = [\"Run\", false]\n";
  return {
      {"example_2_index", "I1M400"},
      {"example_4_negative_index", "I2M-600"},
      {"example_5_auto_reverse", "I1M800,I1M-800"},
      {"example_6_repeating_index", "P10,I1M400,L10,I1M-3600"},
      {"example_7_home_to_limit", "S1M600,I1M0,I1M-200,IA1M-0", 0, 120, "", "", {}, {travel(0, -5000, 3000)}},
      {"example_8_raster_scan", "I1M200,P10,L7,I2M400,L-4,U6,LM-2", 0, 300},
      {"example_9_rectangle", "I1M2000,U1,I2M1000,U1,LM-3,L0", 0, a_minute, taps},
      {"example_10_raster_scans", "I1M2000,I2M300,L-4,LM0,I2M600,I1M3000,L-3,IA2M0,LM-0,LA5", 0, 300},
      {"example_11_matrix", "I3M2000,I3M-2000,I1M1600,L5,I2M400,L-3,IA1M0,IA2M0", 0, 300, "", ",motors=4"},
      {"example_12_pick_and_place", example(12), 0, 300},
      {"example_14_two_rows", example(14), 0, 300},
      {"example_15_three_rows", example(15), 0, 150, run_button, ",motors=4"},
      {"example_16_one_point", example(16), 0, 300, "", ",motors=4"},
      {"example_17_slow", example(17), 0, 60, "", "", {}, {bench::Input(1, true)}},
      {"example_17_fast", example(17)},
      {"example_18_program_0", example(18)},
      {"example_18_program_1", example(18), 0, 60, "", "", {moved({5000, 0})}, {bench::Input(2, true)}},
      {"appendix_d_stop_output", "I1M400,PA10"},
      {"appendix_d_continuous", "S1M1500,U7,I1M1000,I1M100,I1M50,I1M100,U9,IA1M0"},
      {"appendix_d_hundred", "U7,I2M400,LA100,U9"},
      {"appendix_d_three_speeds", "S2M1500,U7,I2M2000,S2M3000,I2M4000,S2M500,I2M800,U9,S2M3000,IA2M0"},
      {"appendix_g_one_after_the_other", "I1M400,I3M800", 0, 60, "", ",motors=4"},
      {"appendix_g_together", "(I3M800,I1M400,)", 0, 60, "", ",motors=4"},
      {"appendix_i_speed_by_the_middle", "S1M-12,I1M4000"},
      {"appendix_i_speed_by_a_potentiometer",
       "S1M-12,I1M4000,I1M-4000,L3",
       0,
       60,
       "[[at]]\nt = 4.0\nanalog = [1, 60]\n[[at]]\nt = 9.0\nanalog = [1, 1024]\n",
       "",
       {},
       {bench::Analog(1, 900)}},
      {"appendix_n_home_switch",
       "S1M600,I1M-0,I1M4000,I1M-0,IA1M-0",
       0,
       60,
       "",
       "",
       {set("L1M", -2)},
       {home(0, -3000, -2000)}},
      {"appendix_t_branch_on_input_3",
       "U0,I1M9",
       0,
       10,
       "[[at]]\nt = 1.0\ninput = [3, true]\n",
       "",
       {},
       {},
       {{3, "I2M5"}}},
      {"places_outputs_backlash",
       "S1M1234,A1M5,IA1M-700,U15,I2M-300,S2M900,A2M1,IA2M0,JM2",
       0,
       60,
       "",
       "",
       {set("Bx", 7), moved({432, -123}), intent::SetOutput(1, true)},
       {bench::Input(2, true)},
       {{2, "I1M77,P3"}}},
      {"onto_a_limit_that_ends_the_program",
       "S1M3000,A1M4,I1M9000,I2M500",
       0,
       60,
       "",
       "",
       {set("O", 3), moved({100, 200})},
       {travel(0, -5000, 4000)}},
  };
}

std::vector<AgreementCase> vme58_cases() {
  return {
      {"home_then_a_move",
       "AX\nVL1000 AC10000\nKP2 KD6 HN\nHM0\nVL5000 AC50000\nMA-10000 GO ID\n",
       0,
       60,
       "",
       "",
       {},
       {home(0, 3000, 3500)}},
      {"three_axes_in_space",
       "AX KP2 KD6 HN\nAY KP2 KD6 HN\nAZ KP2 KD6 HN\nAM\nVL5000,5000,5000;\nAC50000,50000,50000;\n"
       "MA1000,2000,3000; GO ID\n"},
      {"a_hole_is_cut",
       "AX AF\nAA\nAC,,10000,10000;\nCV1000\nCD,,0,0;\nAN0;\nCR0,5000,3.1415926\nCR0,0,6.2831853\nAF0;\n"
       "MT-10,10000\nCE\nMT,,-1000,0; GO\nCX\n",
       0, 200},
      {"speeds_places_outputs",
       "AX\nMR500 GO\nBL9\nAY\nSW1\nMA-100 GO ID\n",
       0,
       60,
       "[[at]]\nt = 2.5\ninput = [2, false]\n",
       "",
       {set("VLX", 777), set("ACX", 12345), set("VLY", 2222), set("ACY", 9000), set("VBY", 100), set("PN", 3),
        moved({-400, 650}), intent::SetOutput(8, true)},
       {bench::Input(2, true)}},
  };
}

std::ostream& operator<<(std::ostream& out, const AgreementCase& c) { return out << c.name; }

}  // namespace hw::test
