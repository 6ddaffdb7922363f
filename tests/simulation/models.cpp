#include "tests/simulation/models.h"

namespace hw::simulation {
namespace {

// clang-format off
const std::vector<ModelFacts>& all_models() {
  static const std::vector<ModelFacts> models = {
      {"vxm",
       {"", "motors=4"}, {}, {"quirk=e-bar", "quirk=mode-while-running"}, {"quirk=overrun"}, '^', "wire=real", false, false, true, true,
       {{"D"}, {"K", -1, true}},
       {"S1M800\nA1M4\nI1M900\nI1M-900\nL0", "S1M1500\nI1M700\nP5\nI1M-300", "I2M1200\nI2M-1200\nL4"},
       {"; Tool off: output 1 off\nS1M800\nA1M4\nU5\nI1M900\nU4\nI1M-900\nL0", "; Tool off: output 1 off\nU5\nS1M1500\nA1M4\nI1M700\nP5\nI1M-300"}, 0,
       {"V", "X", "Y", "M", "?", "~", "lst", "getmm", "x9", "setzz", "#", "I1M", "getP"},
       "lst", "PM",
       {"j1M", "j2M"},
       {"F", "PM\r", "PM0\r", "lst", "PM1\r", "lst", "PM2\r", "lst", "PM3\r", "lst", "PM4\r", "lst", "getj1M\r",
        "getI\r", "getO\r"},
       {"getDA", "getjA"},
       {},
       "K", 2},
      {"pmx-4ex-sa",
       {""}, {"id=00-01"}, {"quirk=motor-power"}, {}, 0, "wire=real", true, false, false, false,
       {{"STOP"}, {"ABORT", -1, true}, {"STOPX", 0}, {"STOPY", 1}},
       {"PRG 0\nINC\nHSPD=2000\nWHILE 1=1\nX1500\nWAITX\nX-1500\nWAITX\nENDWHILE\nEND",
        "PRG 0\nINC\nHSPD=3000\nY900\nWAITY\nDELAY=300\nY-900\nWAITY\nEND"},
       {"; Tool off: output 2 off\nPRG 0\nINC\nHSPD=2000\nWHILE 1=1\nDO2=1\nX1500\nWAITX\nDO2=0\nX-1500\nWAITX\nENDWHILE\nEND",
        "; Tool off: output 2 off\nPRG 0\nINC\nHSPD=3000\nDO2=1\nY900\nWAITY\nDELAY=300\nEND"}, 1,
       {"PX", "MST", "ID", "VER", "DN", "DI", "V5=7", "NOSUCH", "HSPD", "SASTAT0", "PX="},
       "ID", "Performax",
       {"HS", "ACC", "LS"},
       {"@{}HS\r", "@{}LS\r", "@{}HSX\r", "@{}HSY\r", "@{}HSZ\r", "@{}EO\r"},
       {"AI", "SCV", "SYN", "SLS"},
       {"@00STOP\r", "@00X500\r", "@00DN\r"},
       "ABORT"},
      {"dmx-k-sa",
       {"id=01"}, {"id=01-02", "id=01-04"}, {"quirk=reply-cr", "quirk=motor-power"}, {}, 0, "wire=real", true, false, false, false,
       {{"STOP"}, {"ABORT", -1, true}},
       {"PRG 0\nINC\nHSPD=2000\nWHILE 1=1\nX1500\nWAITX\nX-1500\nWAITX\nENDWHILE\nEND",
        "PRG 0\nINC\nHSPD=3000\nX900\nWAITX\nDELAY=300\nX-900\nWAITX\nEND"},
       {"; Tool off: output 2 off\nPRG 0\nINC\nHSPD=2000\nWHILE 1=1\nDO2=1\nX1500\nWAITX\nDO2=0\nX-1500\nWAITX\nENDWHILE\nEND",
        "; Tool off: output 2 off\nPRG 0\nINC\nHSPD=3000\nDO2=1\nX900\nWAITX\nDELAY=300\nEND"}, 1,
       {"PX", "MST", "ID", "VER", "DN", "DI", "V5=7", "NOSUCH", "HSPD", "SASTAT0"},
       "ID", "DriveMax",
       {"HSPD", "ACC", "LSPD"},
       {"@{}HSPD\r", "@{}LSPD\r", "@{}EO\r"},
       {"CUR", "TOC", "SYN", "SLS"},
       {"@01STOP\r", "@01X500\r", "@01DN\r", "@09PX\r"},
       "ABORT"},
      {"vme58",
       {"", "variant=4S4", "quirk=padded+deaf-mailbox"}, {}, {"quirk=padded", "quirk=oms-kk"}, {}, 0, "",
       false, true, true, true,
       {{"SA"}, {"KL", -1, true}, {"AX ST", 0}, {"AY ST", 1}},
       {"AX\nVL4000 AC20000\nLS20\nMR3000 GO\nMR-3000 GO\nLE", "AY\nVL3000\nMR1200 GO ID\nMR-1200 GO ID"},
       {"# Tool off: output 8 off\nAX\nVL4000 AC20000\nLS20\nBL8\nMR3000 GO\nBH8\nMR-3000 GO\nLE", "# Tool off: output 8 off\nAY\nBL8\nVL3000\nMR1200 GO ID\nMR-1200 GO ID"}, 0,
       {"WY", "RP", "AX RP", "QA", "RA", "AX RE", "ZZ", "AA RP", "AX VL8000", "WQ"},
       "WY", "VME58",
       {},
       {},
       {},
       {},
       "KL"},
  };
  return models;
}
// clang-format on

}  // namespace

const ModelFacts* find_model(std::string_view model) {
  for (const ModelFacts& facts : all_models())
    if (facts.model == model) return &facts;
  return nullptr;
}

std::vector<std::string_view> model_names() {
  std::vector<std::string_view> names;
  for (const ModelFacts& facts : all_models()) names.push_back(facts.model);
  return names;
}

}  // namespace hw::simulation
