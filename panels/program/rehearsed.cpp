#include "panels/program/rehearsed.h"

#include <algorithm>
#include <vector>

#include "gui/model/tab.h"
#include "panels/program/threads.h"
#include "panels/program/travel_words.h"

namespace hw::panels {

using namespace gui;
namespace {

/// The obstacle that the rehearsal has found; empty: none.
std::string_view found(const Rehearsals::Outcome& o) {
  if (!o.result) return "Rehearsed: the program cannot run.";
  const Rehearsal& r = *o.result;
  const bool out_of_time = !r.finished && r.duration_s >= RehearseOptions().for_seconds;
  if (!r.error.empty() && !out_of_time) return "Rehearsed: the program ends with an error.";
  if (r.limit_touched) return "Rehearsed: a limit switch is hit.";
  if (!r.finished) return "Rehearsed: no end was found. The program loops, or waits for an operator.";
  return {};
}

/// Names values that were known then and are not known now.
std::string_view unread(StartMatch match) {
  switch (match) {
    case StartMatch::other_power: return "Rehearsed, but the loop of an axis has not been read again.";
    case StartMatch::other_switch: return "Rehearsed, but a limit or home switch has not been read again.";
    case StartMatch::other_setup: return "Rehearsed, but a parameter has not been read again.";
    case StartMatch::other_output: return "Rehearsed, but an output has not been read again.";
    case StartMatch::other_input: return "Rehearsed, but an input has not been read again.";
    case StartMatch::other_analog: return "Rehearsed, but an analog input has not been read again.";
    case StartMatch::other_readout:
      return "Rehearsed, but the move mode, a latch or a sync output has not been read again.";
    case StartMatch::other_variable: return "Rehearsed, but a variable has not been read again.";
    case StartMatch::other_program: return "Rehearsed, but another program has not been read again.";
    default: return "Rehearsed, but not everything has been read again.";
  }
}

/// The change since then, in words; empty: none.
std::string_view changed(const StartDifference& start) {
  if (start.unread) return unread(start.match);
  switch (start.match) {
    case StartMatch::here: return {};
    case StartMatch::elsewhere: return "Rehearsed from elsewhere: the axes have been moved since.";
    case StartMatch::moving: return "Rehearsed from elsewhere: an axis is moving.";
    case StartMatch::other_count:
      return "Rehearsed in other units: an axis counts its encoder now, or did then.";
    case StartMatch::unknown: return "Rehearsed from 0: the positions of the axes are not known.";
    case StartMatch::doubtful: return "Rehearsed, but the position of an axis may be wrong.";
    case StartMatch::other_bench: return "Rehearsed before the switches on the bench were moved.";
    case StartMatch::other_encoder: return "Rehearsed before the encoder of an axis changed.";
    case StartMatch::other_switch: return "Rehearsed before a limit or home switch changed.";
    case StartMatch::other_power: return "Rehearsed before an axis was switched, or its error came or went.";
    case StartMatch::other_setup: return "Rehearsed before a parameter was changed.";
    case StartMatch::other_output: return "Rehearsed before an output was switched.";
    case StartMatch::other_input: return "Rehearsed before an input changed.";
    case StartMatch::other_analog: return "Rehearsed before an analog input changed.";
    case StartMatch::other_readout:
      return "Rehearsed before the move mode, a latch or a sync output was changed.";
    case StartMatch::other_variable: return "Rehearsed before a variable was changed.";
    case StartMatch::other_program: return "Rehearsed before another program was changed.";
    case StartMatch::other_queue: return "Rehearsed with empty queues: commands wait there now.";
  }
  return {};
}

}  // namespace

Rehearsed rehearsed(const Frame& f) {
  Desk& desk = f.tab.desk();
  const int slot = desk.programs.texts.chosen(), started = desk.programs.texts.start_of(slot);
  if (desk.programs.rehearsals.under_way(started)) return {false, "Rehearsing."};
  return rehearsed(f, desk.programs.rehearsals.of(started), desk.programs.texts.text(slot));
}

Rehearsed rehearsed_thread(const Frame& f, int program) {
  Desk& desk = f.tab.desk();
  const HeldProgram& held = desk.programs.texts.held(0);
  if (!held.known) return {false, "Press Upload to read the controller's program: it is not rehearsed."};
  const std::vector<int>& there = held.report.programs;
  if (std::find(there.begin(), there.end(), program) == there.end())
    return {false, "The controller holds no program with this number."};
  if (desk.programs.rehearsals.under_way(program)) return {false, "Rehearsing."};
  const Rehearsals::Outcome* outcome = desk.programs.rehearsals.of(program);
  if (!outcome && there.size() == 1 && program == 0) return {false, "Not rehearsed: Simulate (F5) first."};
  if (!outcome) return {false, "Not rehearsed: choose its number above, then press Simulate."};
  if (outcome->text != held.text) return {false, "The controller holds another text than the rehearsed one."};
  for (int n = 0; n < std::min(f.catalog.program.threads, max_threads); ++n)
    if (n != program && is_busy(f.now.threads[static_cast<std::size_t>(n)]))
      return {false, "Rehearsed alone: another program is running now."};
  return rehearsed(f, outcome, held.text);
}

Rehearsed rehearsed(const Frame& f, const Rehearsals::Outcome* outcome, const std::string& text) {
  if (!outcome) return {false, "Not rehearsed: Simulate (F5) first."};
  if (outcome->text != text) return {false, "Rehearsed before the text was changed."};
  for (const std::string_view why : {found(*outcome), changed(outcome->start)})
    if (!why.empty()) return {false, why};
  if (passes_travel(f, *outcome->result)) return {false, "Rehearsed: the program goes past your limit."};
  if (!outcome->result->assumptions.empty())
    return {true, "Rehearsed: this text, from here, with the assumptions listed."};
  return {true, "Rehearsed: this text, from where the axes stand."};
}

}  // namespace hw::panels
