#include "core/devices/vme58/programs.h"

#include <algorithm>
#include <utility>

#include <fmt/core.h>

#include "core/devices/vme58/moves.h"
#include "core/devices/vme58/text_meaning.h"

namespace hw::vme58 {

Result<> Programs::load(std::string text) {
  if (is_running())
    return fail(FaultKind::refused, "The program is running.", "It was not replaced.", "Stop it first.");
  Context context;
  const std::string plain = without_comments(text);
  for (const TextCommand& command : read_commands(plain, context))
    if (!command.flaw.empty())
      return fail(FaultKind::refused,
                  fmt::format("Line {}: {}", line_holding(text, command.begin) + 1, command.flaw),
                  "The program was not loaded.", "Correct it and load it again.");
  forget_rejection(snapshot_);
  text_ = std::move(text);
  snapshot_.slot_bytes_used[0] = static_cast<std::int16_t>(std::min<std::size_t>(text_.size(), 32767));
  return {};
}

void Programs::show() {
  Notice listing(Notice::Kind::program, wire_.now(), text_);
  listing.slot = 0;
  wire_.report(std::move(listing));
}

Task<Result<>> Programs::run() {
  if (auto may = commands_.may_talk(); !may) co_return may;
  if (is_running())
    co_return fail(FaultKind::refused, "The program is running already.", "Nothing was sent.");
  if (snapshot_.any_axis_moving())
    co_return fail(FaultKind::refused, "An axis is still moving.", "Nothing was sent.",
                   "Wait until the motion ends, or stop it.");
  auto own = co_await speeds_.give_all_back(Priority::intent);
  if (!own) co_return own;
  auto selected = co_await conversation_.select_again(Priority::intent);
  if (!selected) co_return selected;
  const std::string plain = without_comments(text_);
  if (!feed_.load(plain))
    co_return fail(FaultKind::refused, "There is no program to run: its text is empty.", "Nothing was sent.");
  motions_.program_begins();
  ProgramState& p = snapshot_.program;
  p.run = RunState::running;
  ends_by_ = EndedBy::target;
  p.owned = true;
  p.slot = 0;
  p.ended_by = EndedBy::nothing;
  p.started_at = wire_.now();
  feed_.begin();
  co_return co_await feed();
}

Task<Result<>> Programs::feed() {
  auto fed = co_await feed_.go_on();
  if (!fed) co_return fail(fed.error());
  if (!*fed) co_return Result<>();
  std::string what = std::move(**fed);
  co_return co_await end_rejected(std::move(what));
}

/// The rejection stays shown until something else is done.
Task<Result<>> Programs::end_rejected(std::string what) {
  auto stopped = co_await all_stop_.send("SA");
  if (!stopped && stopped.error().kind == FaultKind::stopped) {
    readings_.put_back_command_error();  // the next round reports it
    co_return stopped;
  }
  rejection_ = what + " The program ends there, and all axes were stopped.";
  end(EndedBy::error);
  snapshot_.notice = rejection_;
  wire_.report(Notice::Kind::error, rejection_);
  co_return stopped;
}

void Programs::end(EndedBy ended_by) {
  feed_.end();
  motions_.program_ends();
  ProgramState& p = snapshot_.program;
  if (!is_running()) return;
  p.run = ended_by == EndedBy::error ? RunState::error : RunState::idle;
  p.owned = false;
  p.command = -1;
  p.ended_by = ended_by;
  feed_.program_ended(ended_by == EndedBy::target);
}

Task<Result<>> Programs::watch() {
  if (!is_running()) co_return Result<>();
  if (feed_.is_under_way()) {
    auto fed = co_await feed();
    if (!fed || feed_.is_under_way()) co_return fed;
  }
  if (snapshot_.any_axis_moving()) co_return Result<>();
  const auto worked_off = co_await questions_.is_worked_off();
  if (!worked_off) co_return fail(worked_off.error());
  if (!*worked_off) co_return Result<>();
  if (ends_by_ == EndedBy::target && motions_.met_limit()) ends_by_ = EndedBy::limit;
  if (ends_by_ == EndedBy::target) motions_.come_home();
  end(ends_by_);
  co_return Result<>();
}

void Programs::note_stop(const TextCommand& command) {
  if (!is_running() || !command.fact || !stops_motion(command.fact->op)) return;
  if (!command.is(Op::ST)) return end(command.is(Op::KL) ? EndedBy::abort : EndedBy::stop);
  feed_.end();
  if (ends_by_ == EndedBy::target) ends_by_ = EndedBy::stop;
}

void Programs::queued_was_rejected(std::string& words) {
  if (!is_running()) return;
  rejection_ = words + " The program was not carried out in full.";
  words = rejection_;
  ends_by_ = EndedBy::error;
}

/// Marks a running program as lost: its end is not seen.
void Programs::lose() {
  if (is_running()) snapshot_.program.ended_by = EndedBy::lost;
}

void Programs::forget() {
  feed_.program_ended(false);
  feed_.forget();
  snapshot_.program.run = RunState::idle;
  snapshot_.program.owned = false;
}

}  // namespace hw::vme58
