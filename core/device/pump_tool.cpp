// Cutting: the tool that a program switches, and drawings that run piece by piece.
#include <fmt/core.h>

#include "core/device/pump_job.h"

namespace hw {

/// Whether the next job must wait for a round that shows if a program with its tool on still runs. The wait
/// is bounded, as some controllers do not report it.
bool Pump::tool_is_seen_first() const {
  constexpr std::uint64_t enough_rounds = 3;
  if (!tool_.is_seen_before(jobs_.next().intent.body)) return false;
  const std::uint64_t since = jobs_.next().first_round;
  return rounds_.ended() < since + (tool_.looks() ? enough_rounds : 0);
}

/// After a status round: switches the tool off if the program has ended by itself, by an error, by a hold or
/// by another host's stop.
void Pump::watch_tool() {
  if (desk_.any()) return;
  switch (tool_.watch(snapshot_, rounds_.ended())) {
    case ToolGuard::Request::nothing: return;
    case ToolGuard::Request::look: return tool_.looks_by(rounds_.want(scheduler_.now()), scheduler_.now());
    case ToolGuard::Request::switch_off: return switch_tool_off();
    case ToolGuard::Request::stop:
      callbacks_.notify(Notice(
          Notice::Kind::warning, scheduler_.now(),
          "A limit switch was hit with the tool on, so everything was stopped and the tool switched off."));
      return post_stop(StopOrder());
  }
}

void Pump::switch_tool_off() {
  const bool held = snapshot_.program.run == RunState::held || snapshot_.pieces.draws;
  if (held) tool_.note_hold(snapshot_);
  callbacks_.notify(Notice(
      Notice::Kind::warning, scheduler_.now(),
      fmt::format("{} with the tool on: {} was switched off.{}",
                  held ? "The program is held" : "The program has ended", tool_outputs_words(tool_.outputs()),
                  held ? " The tool comes on again when the program continues." : "")));
  desk_.ask_tool(tool_.outputs());
  wake_.notify();
}

/// Switches on again the outputs that a hold has switched off, before cutting continues.
Task<Result<>> Pump::bring_tool_back() {
  const ToolOff held = tool_.of_hold();
  for (const ToolOutput& o : held) {
    const IntentBody on = intent::SetOutput(o.number, o.on);
    auto set = co_await guarded("tool", driver_->perform(on));
    if (!set) co_return set;
  }
  tool_.forget_hold();
  co_return Result<>();
}

Task<Result<>> Pump::perform_guarding_tool(const IntentBody& body) {
  auto may = tool_.begin(body, snapshot_);
  if (!may) co_return may;
  if (std::holds_alternative<intent::Resume>(body)) {
    auto back = co_await bring_tool_back();
    if (!back) co_return back;
  }
  auto performed = co_await guarded("command", driver_->perform(body));
  if (performed) tool_.done(body);
  const bool refused = !performed && performed.error().kind == FaultKind::refused;
  if (refused && snapshot_.slots_torn == 0) tool_.refused(body);
  co_return performed;
}

Task<Result<>> Pump::perform_beside_pieces(const IntentBody& body) {
  if (const auto* request = std::get_if<intent::RunInPieces>(&body)) {
    auto begun = pieces_.begin(*request);
    if (begun) tool_.pieces_begin(request->pieces->tool, snapshot_);
    co_return begun;
  }
  if (const auto* request = std::get_if<intent::OverrideSpeed>(&body))
    co_return pieces_.override_speed(request->percent);
  if (auto may = pieces_.allows(body); !may) co_return may;
  const bool holds = std::holds_alternative<intent::Pause>(body);
  if (pieces_.running() && (holds || std::holds_alternative<intent::Resume>(body))) {
    if (!holds && snapshot_.pieces.draws)
      if (auto back = co_await bring_tool_back(); !back) co_return back;
    pieces_.hold(holds);
    if (snapshot_.pieces.draws) co_return Result<>();
    const RunState run = snapshot_.program.run;
    const bool at_work =
        snapshot_.program.owned && (holds ? run == RunState::running : run == RunState::held);
    const bool can_hold = catalog_.can.single_step || catalog_.program.threads > 0;
    const bool within = at_work && can_hold && catalog_.can.outputs_while_held;
    if (holds && at_work && !within) report_hold_behind_piece();
    if (!within) co_return Result<>();
  }
  co_return co_await perform_guarding_tool(body);
}

/// The second half of a move relies on the settings before it, which the text may change.
void Pump::words_come_between(const TextMeaning& words) {
  if (words.only_asks || !pieces_.is_one_move()) return;
  pieces_end("Repeat the move: a command was sent while it took up backlash, so its last part was not made.",
             false);
}

/// For a program that cannot be held, or whose tool would stay on during a hold.
void Pump::report_hold_behind_piece() {
  callbacks_.notify(
      Notice(Notice::Kind::warning, scheduler_.now(),
             fmt::format("Piece {} is finished first, with its tool in use; then the run is held. Press "
                         "Stop to end the piece now and switch the tool off.",
                         snapshot_.pieces.done + 1)));
}

/// If a stop comes meanwhile, the pieces have ended.
Task<> Pump::perform_piece(const IntentBody& body) {
  const bool cuts = snapshot_.pieces.draws;
  const auto asked = pieces_.at_speed(body);  // a copy: the original may be destroyed with the pieces
  if (!asked) co_return pieces_end(asked.error().sentence(), cuts);
  count_program_change(Intent(0, *asked));
  const bool had_begun = pieces_.sends(*asked);
  auto performed = co_await perform_guarding_tool(*asked);
  if (!pieces_.running()) co_return;
  if (!performed && performed.error().kind == FaultKind::refused) pieces_.refused(had_begun);
  if (performed)
    pieces_.done(rounds_.want(scheduler_.now()), scheduler_.now());
  else
    pieces_end(performed.error().sentence(), cuts);
  publish();
}

/// `cuts`: the tool may be on, and an unanswered command may have begun, so a stop is sent.
void Pump::pieces_end(std::string why, bool cuts) {
  pump_log().debug("{}: the rest of the pieces is dropped: {}", LogName{catalog_}, why);
  if (cuts) {
    StopOrder order;
    order.by = StoppedBy::unknown;  // `why` gives the reason
    post_stop(std::move(order));
  }
  pieces_.end();
  snapshot_.pieces.ended_because = why;
  callbacks_.notify(Notice(Notice::Kind::error, scheduler_.now(), std::move(why)));
  publish();
}

}  // namespace hw
