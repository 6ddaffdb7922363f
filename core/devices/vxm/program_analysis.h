#pragma once
// A walk through a program text with the controller's own reader.
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "core/device/language.h"
#include "core/devices/vxm/program_syntax.h"

namespace hw::vxm {

/// Where a stored command stands in the text.
struct Place {
  int line = 0, column = 0, length = 0;
};

struct StoredCommand {
  Command command;
  Place place;
};

struct Analysis {
  ProgramReport report;
  std::map<int, std::vector<StoredCommand>> programs;  ///< by slot
  bool has_headings = false;
  int motors = 0;      ///< the highest that is spoken of; a Slave's inputs count as 3
  std::string script;  ///< what has to be sent to bring the text into a controller that is on-line
  int run_slot = -1;   ///< the program that the text's last R runs; -1: it has no R
  int last_slot = 0;   ///< the program that is selected at its end
};

[[nodiscard]] Analysis analyse_text(std::string_view text, int slot);

/// What is wrong with whole programs: appended to the report (program_checks.cpp).
void check_programs(Analysis& analysis);

/// Why a word means nothing, with a fix where there is one (program_problems.cpp). `text` is the word as
/// typed.
[[nodiscard]] Problem problem_of(const Reading& word, const Refusal& refusal, std::string_view text,
                                 const Place& place, int current_motor);
/// Whether the controller takes the number of a set command, B, O or PMA; and what to say if not.
[[nodiscard]] bool may_be_set(const Reading& word);
[[nodiscard]] Problem problem_of_setting(const Reading& word, std::string_view text, const Place& place);
/// Likewise for what is no command at all.
[[nodiscard]] Problem problem_of_text(std::string_view text, const Place& place, bool number_missing);

}  // namespace hw::vxm
