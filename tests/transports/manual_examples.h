#pragma once
// Every example that the makers' manuals print, in their order: as a case to be run, or with the reason why
// it cannot be. They are in examples/MODEL.toml.
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "tests/transports/agreement_cases.h"

namespace hw::test {

struct ManualExample {
  std::string name;
  std::string at;       ///< chapter of the manual, and page where the copy at hand tells it
  int number = 0;       ///< of those that the manual numbers
  std::string same_as;  ///< another of them that prints the same program
  std::string why_not;  ///< it cannot be run
  AgreementCase run;    ///< neither of the two
  [[nodiscard]] bool is_run() const { return why_not.empty() && same_as.empty(); }
};

struct Manual {
  int numbered = 0;  ///< how far its numbers go
  std::vector<ManualExample> examples;
};

/// The fault names the file and the entry.
Result<Manual> read_manual(std::string_view model);

/// Those that are run; none if the file cannot be read.
std::vector<AgreementCase> cases_of_manual(std::string_view model);

}  // namespace hw::test
