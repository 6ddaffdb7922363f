#pragma once
// Starts, holds and ends a program in the controller, in the same way in all panels that run one. Ids:
// `WHERE/run`, `WHERE/rehearsed`, `WHERE/hold`, `WHERE/step` (if the controller has it), `WHERE/stop`.
#include <cstdint>
#include <optional>
#include <string_view>

#include "gui/model/run_places.h"
#include "gui/model/units_format.h"
#include "gui/shell/frame.h"
#include "panels/program/rehearsed.h"

namespace hw::panels {

enum class RunRequest : std::uint8_t { none, run, run_stepping };

/// Whether a stored program of the user is running, waiting or held.
[[nodiscard]] bool is_under_way(const ProgramState& program);
/// Why no program can be started, whatever the text; empty: it can, or a waiting program can continue.
[[nodiscard]] std::string_view why_none_runs(const gui::Frame& frame);
/// The same where a waiting program would be replaced.
[[nodiscard]] std::string_view why_no_new_run(const gui::Frame& frame);
/// A text written for a run that a stop has prevented.
inline constexpr std::string_view put_but_not_run =
    "A stop came first. The text was put into the program and not run.";

struct RunBarLook {
  std::string_view why_not = {};  ///< Run: why no program can be started
  Rehearsed rehearsed = {};       ///< Run's tip about the rehearsal; its words are empty if there is none
  std::string_view tip = {};      ///< Run: facts that the user must know first
  bool keys = false;              ///< show the chord on Run
  bool brief = false;             ///< all but Run as icons only
};
/// Draws at ImGui's cursor. The row may continue after it. Continues, holds and stops a running program
/// itself; leaves a new run to the panel.
RunRequest run_bar(gui::Frame& frame, std::string_view where, const RunBarLook& look);
/// Progress of the running program by its rehearsal; nullopt: unknown, or no program runs.
struct RunProgress {
  float share = 0;
  gui::NumberText left;  ///< "46 s left"
};
std::optional<RunProgress> run_progress(const gui::Frame& frame);
/// Draws the progress and the time left in a row of 40 at ImGui's cursor, at `right`, not further left than
/// `left` (pixels). Id: `WHERE/left`.
void draw_run_progress(gui::Frame& frame, std::string_view where, const RunProgress& progress, float left,
                       float right);
/// Acts on a chord: continues a waiting program, else returns the request to the panel.
RunRequest go_on_or(gui::Frame& frame, RunRequest request);
/// Runs the chosen text. Rehearses it first if needed, because the rehearsal tracks the run. `agreed` are the
/// doubts about positions despite which the text is run this time; nullopt: it is not run despite a doubt.
void begin_run(gui::Frame& frame, RunRequest request, const std::optional<gui::AgreedDoubts>& agreed = {});
/// Shows the result of a run, transfer or store in a toast, once.
void report_outcome(gui::Frame& frame);

}  // namespace hw::panels
