#pragma once
// The example programs of the manuals, and the states from which they are run.
#include <iosfwd>
#include <string>
#include <vector>

#include "core/device/bench.h"
#include "core/device/intent.h"

namespace hw::test {

struct AgreementCase {
  const char* name;
  std::string text;                     ///< of the program, or @FILE below tests/
  int slot = 0;                         ///< that is started
  double seconds = 120;                 ///< at most, or of a program without end
  const char* bench = "";               ///< what hands do later, counted from the start of the program
  const char* keys = "";                ///< of the address
  std::vector<IntentBody> before = {};  ///< done first, each to its end
  std::vector<BenchCommand> bench_before = {};             ///< and this, last
  std::vector<std::pair<int, std::string>> programs = {};  ///< that the controller holds in other slots
};

std::vector<AgreementCase> vxm_cases(), pmx_cases(), dmx_cases(), vme58_cases();

std::ostream& operator<<(std::ostream& out, const AgreementCase& c);

}  // namespace hw::test
