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
  int motors = 0;      ///< the highest motor that is used; a Slave's inputs count as motor 3
  std::string script;  ///< bytes to send to load the text into an on-line controller
  int run_slot = -1;   ///< the program run by the last R; -1: no R
  int last_slot = 0;   ///< the program selected at the end
};

[[nodiscard]] Analysis analyse_text(std::string_view text, int slot);

/// Appends the problems of whole programs to the report (program_checks.cpp).
void check_programs(Analysis& analysis);

/// Why a word is not understood, with a fix where there is one (program_problems.cpp). `text` is the word as
/// typed.
[[nodiscard]] Problem problem_of(const Reading& word, const Refusal& refusal, std::string_view text,
                                 const Place& place, int current_motor);
/// Whether the controller accepts the number of a set command, B, O or PMA. problem_of() names the problem.
[[nodiscard]] bool may_be_set(const Reading& word);
[[nodiscard]] Problem problem_of_setting(const Reading& word, std::string_view text, const Place& place);
/// The problem of a text that is no command.
[[nodiscard]] Problem problem_of_text(std::string_view text, const Place& place, bool number_missing);

}  // namespace hw::vxm
