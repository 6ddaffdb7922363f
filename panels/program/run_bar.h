#pragma once
// Starts, holds and ends a program in the controller, the same way in every panel that runs one. Ids:
// `WHERE/run`, `WHERE/rehearsed`, `WHERE/hold`, `WHERE/step` (where the controller has it), `WHERE/stop`.
#include <cstdint>
#include <optional>
#include <string_view>

#include "gui/model/run_places.h"
#include "gui/model/units_format.h"
#include "gui/shell/frame.h"
#include "panels/program/rehearsed.h"

namespace hw::panels {

enum class RunRequest : std::uint8_t { none, run, run_stepping };

/// A stored program of the user's is running, waiting or held.
[[nodiscard]] bool is_under_way(const ProgramState& program);
/// Why nothing can be started, whatever the text; empty: it can, or a waiting program can continue.
[[nodiscard]] std::string_view why_none_runs(const gui::Frame& frame);

struct RunBarLook {
  std::string_view why_not = {};  ///< run: why nothing can be started
  Rehearsed rehearsed = {};       ///< Run's tip about the rehearsal; its words are empty if there is none
  std::string_view tip = {};      ///< run: what to know first
  bool keys = false;              ///< show the chord on Run
  bool brief = false;             ///< all but Run as icons only
};
/// Draws at ImGui's cursor; more may follow in the row. Continues, holds and stops a running program itself;
/// leaves a new run to the panel.
RunRequest run_bar(gui::Frame& frame, std::string_view where, const RunBarLook& look);
/// Progress of the running program by its rehearsal; none: unknown, or nothing runs.
struct RunProgress {
  float share = 0;
  gui::NumberText left;  ///< "46 s left"
};
std::optional<RunProgress> run_progress(const gui::Frame& frame);
/// Draws the progress and the time left in a row of 40 at ImGui's cursor, at `right`, not further left than
/// `left` (pixels). Id: `WHERE/left`.
void draw_run_progress(gui::Frame& frame, std::string_view where, const RunProgress& progress, float left,
                       float right);
/// The same for a chord: continues a waiting program, else returns the request to the panel.
RunRequest go_on_or(gui::Frame& frame, RunRequest request);
/// Runs the chosen text, rehearsing it first if needed: the rehearsal tracks the run. `agreed`: the doubts
/// about positions despite which it is run for this once; none: it is not run despite any.
void begin_run(gui::Frame& frame, RunRequest request, const std::optional<gui::AgreedDoubts>& agreed = {});
/// Tells the result of a run, transfer or store once.
void describe_what_came(gui::Frame& frame);

}  // namespace hw::panels
