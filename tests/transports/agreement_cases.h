#pragma once
// Programs whose rehearsal is compared with their run: the manuals' own (manual_examples.h), and others from
// states that the examples do not begin with.
#include <iosfwd>
#include <string>
#include <vector>

#include "core/device/bench.h"
#include "core/device/intent.h"

namespace hw::test {

struct AgreementCase {
  std::string name;
  std::string text;                     ///< of the program, or @FILE below tests/
  int slot = 0;                         ///< that is started
  double seconds = 120;                 ///< at most, or of a program without end
  std::string bench = {};               ///< what hands do later, counted from the start of the program
  std::string keys = {};                ///< of the address
  std::vector<IntentBody> before = {};  ///< done first, each to its end
  std::vector<BenchCommand> bench_before = {};             ///< and this, last
  std::vector<std::pair<int, std::string>> programs = {};  ///< that the controller holds in other slots
  std::string stands = {};                                 ///< a bench file: how all stands before, as well
};

std::vector<AgreementCase> vxm_cases(), pmx_cases(), dmx_cases(), vme58_cases();

std::ostream& operator<<(std::ostream& out, const AgreementCase& c);

}  // namespace hw::test
