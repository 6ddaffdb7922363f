#pragma once
// What begins, holds and ends a program in the controller: alike wherever there is something to run. Ids:
// `WHERE/run`, `WHERE/rehearsed`, `WHERE/hold`, `WHERE/step` (where the controller has it), `WHERE/stop`.
#include <cstdint>
#include <string_view>

#include "gui/shell/frame.h"
#include "panels/program/rehearsed.h"

namespace hw::panels {

enum class RunWish : std::uint8_t { none, run, run_stepping };

/// A stored program of the user's runs, waits or is held.
[[nodiscard]] bool is_under_way(const ProgramState& program);
/// Why nothing can be begun, whatever the text is; empty: it can, or what waits can go on.
[[nodiscard]] std::string_view why_none_runs(const gui::Frame& frame);

struct RunBarLook {
  std::string_view why_not = {};  ///< run: why nothing can be begun
  Rehearsed rehearsed = {};       ///< what Run says of that; its words are empty where nothing is known of it
  std::string_view tip = {};      ///< run: what is to be known of it first
  bool keys = false;              ///< with the chord on Run
  bool brief = false;             ///< all but Run by their signs alone
};
/// At ImGui's cursor, in a row with what follows. What is under way goes on, is held and stopped from here; a
/// new run is left to the panel.
RunWish run_bar(gui::Frame& frame, std::string_view where, const RunBarLook& look);
/// The same for a chord: what waits goes on, else the wish is the panel's.
RunWish go_on_or(gui::Frame& frame, RunWish wish);
/// Runs the chosen text, and rehearses it where that is not done yet: what runs is followed by it.
void begin_run(gui::Frame& frame, RunWish wish);
/// What came of a run, transfer or store, said once.
void say_what_came(gui::Frame& frame);

}  // namespace hw::panels
