#pragma once
// What a controller answers to the maker's questions about its set-up and its programs, asked of a copy of
// it, so that nobody notices: before the console has come, and after it has gone.
#include <set>
#include <string>
#include <vector>

#include "core/emulation/emulator.h"
#include "tests/simulation/plan.h"

namespace hw::simulation {

/// Numbers and words of a text.
using Words = std::set<std::string, std::less<>>;
Words words_of(std::string_view text);
/// Those that the plan's own steps may have put into the controller: not what it asks of single motions.
Words words_of(const Plan& plan);
/// What is left of a typed text that lost a part on the way: who typed it knows.
bool is_typed_in_part(const Plan& plan, std::string_view word);

/// The answer to each; `questions` as the controller receives them.
std::vector<std::string> settings_of(const Emulator& controller, Instant now,
                                     const std::vector<std::string>& questions);

}  // namespace hw::simulation
