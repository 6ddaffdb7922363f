#include "tests/transports/agreement_cases.h"

#include <ostream>

#include "tests/transports/manual_examples.h"

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

BenchCommand travel(int axis, std::int64_t minus, std::int64_t plus) {
  AxisPlace place;
  place.minus = Steps(minus), place.plus = Steps(plus);
  return bench::Place(AxisId{static_cast<std::uint8_t>(axis)}, place);
}

std::vector<AgreementCase> with_manual(std::string_view model, std::vector<AgreementCase> own) {
  std::vector<AgreementCase> all = cases_of_manual(model);
  for (AgreementCase& c : own) all.push_back(std::move(c));
  return all;
}

}  // namespace

std::vector<AgreementCase> pmx_cases() {
  std::vector<AgreementCase> all;
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
  return with_manual("pmx-4ex-sa", std::move(all));
}

std::vector<AgreementCase> dmx_cases() {
  std::vector<AgreementCase> all;
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
  return with_manual("dmx-k-sa", std::move(all));
}

std::vector<AgreementCase> vxm_cases() {
  const std::vector<AgreementCase> own = {
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
  return with_manual("vxm", own);
}

std::vector<AgreementCase> vme58_cases() {
  const std::vector<AgreementCase> own = {
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
  return with_manual("vme58", own);
}

std::ostream& operator<<(std::ostream& out, const AgreementCase& c) { return out << c.name; }

}  // namespace hw::test
