// The board keeps no programs: a program is a command string that the console holds and feeds into the ring
// as the board takes it, each command by itself, so that the one that is rejected can be named.
#include <utility>

#include <fmt/core.h>

#include "core/base/index.h"
#include "core/devices/vme58/driver.h"

namespace hw::vme58 {
namespace {

constexpr int commands_a_round = 64;

int line_holding(std::string_view text, std::size_t at) {
  int line = 0;
  for (const char c : text.substr(0, at)) line += c == '\n';
  return line;
}

}  // namespace

Task<Result<>> Vme58Driver::perform_program(const IntentBody& body) {
  using namespace intent;
  if (const auto* i = std::get_if<LoadProgram>(&body)) co_return co_await load(i->text);
  if (std::holds_alternative<RunProgram>(body)) co_return co_await run_program();
  if (std::holds_alternative<UploadProgram>(body)) {
    Notice listing(Notice::Kind::program, now(), program_text_);
    listing.slot = 0;
    wire_.tell(std::move(listing));
    co_return Result<>();
  }
  if (std::holds_alternative<ClearProgram>(body)) co_return co_await load({});
  if (std::holds_alternative<SelectProgram>(body)) co_return Result<>();
  co_return fail(FaultKind::refused, "A VME58 has no command for this.", "Nothing was sent.");
}

Task<Result<>> Vme58Driver::load(std::string text) {
  if (draft_.program.run == RunState::running)
    co_return fail(FaultKind::refused, "The program is running.", "It was not replaced.", "Stop it first.");
  Context context;
  const std::string plain = without_comments(text);
  for (const TextCommand& command : read_commands(plain, context))
    if (!command.flaw.empty())
      co_return fail(FaultKind::refused,
                     fmt::format("Line {}: {}", line_holding(text, command.begin) + 1, command.flaw),
                     "The program was not taken.", "Correct it and load it again.");
  forget_rejection();
  program_text_ = std::move(text);
  draft_.slot_bytes_used[0] = static_cast<std::int16_t>(std::min<std::size_t>(program_text_.size(), 32767));
  co_return Result<>();
}

Task<Result<>> Vme58Driver::run_program() {
  if (auto may = commands_.may_talk(); !may) co_return may;
  if (draft_.program.run == RunState::running)
    co_return fail(FaultKind::refused, "The program is running already.", "Nothing was sent.");
  if (draft_.any_axis_moving())
    co_return fail(FaultKind::refused, "An axis is still moving.", "Nothing was sent.",
                   "Wait until it ends, or stop it.");
  auto own = co_await give_speeds_back(Priority::intent);
  if (!own) co_return own;
  auto selected = co_await conversation_.select_again(Priority::intent);
  if (!selected) co_return selected;
  Context context = selection_.context();
  fed_context_ = before_feeding_ = selection_.context();
  fed_apart_ = false;
  to_feed_.clear();
  const std::string plain = without_comments(program_text_);
  for (const TextCommand& command : read_commands(plain, context))
    to_feed_.emplace_back(line_holding(plain, command.begin), std::string(command.text));
  if (to_feed_.empty())
    co_return fail(FaultKind::refused, "There is no program to run: its text is empty.", "Nothing was sent.");
  for (int i = 0; i < axis_count(); ++i) {
    AxisMind& mind = minds_[ix(i)];
    mind.limit_hit = mind.turned = mind.by_text = false;
    mind.from_limit = (limits_ >> i & 1) != 0;
  }
  ProgramState& p = draft_.program;
  p.run = RunState::running;
  program_flawed_ = false;
  feeding_line_ = 0;
  p.owned = true;
  p.slot = 0;
  p.ended_by = EndedBy::nothing;
  p.started_at = now();
  draft_.feed.running = true;
  draft_.feed.sent = 0;
  draft_.feed.total = static_cast<std::int32_t>(to_feed_.size());
  for (int i = 0; i < axis_count(); ++i) draft_.axes[i].ended_by = EndedBy::nothing;
  co_return co_await feed();
}

/// With the selector that the program means, and back to the user's, where the user's text has selected an
/// axis meanwhile. Never within a contour: a selector would end it.
std::string Vme58Driver::fed_text(std::string_view command, const Context& after) const {
  const std::string users = selection_.selector(), own = fed_context_.selector();
  std::string text;
  if (!fed_context_.recording && (selection_.is_lost() || (fed_apart_ && own != users))) text = own + " ";
  text += fmt::format("{};", command);
  if (fed_apart_ && !after.recording && after.selector() != users) text += " " + users;
  return text + "\n";
}

/// As much as the board takes now. A command that waits for room stays in the ring until the next round.
Task<Result<>> Vme58Driver::feed() {
  for (int n = 0; n < commands_a_round; ++n) {
    if (!feeding_.empty()) {
      const auto taken = co_await conversation_.is_taken(Priority::transfer);
      if (!taken) co_return fail(taken.error());
      if (!*taken) {
        feeding_waits_ = true;
        co_return Result<>();
      }
      const auto bad = co_await readings_.was_rejected(Priority::transfer);
      if (!bad) co_return fail(bad.error());
      const std::string sent = std::exchange(feeding_, {});
      ++draft_.feed.sent;
      draft_.program.command = static_cast<std::int16_t>(draft_.feed.sent);
      std::string what = feeding_waits_
                             ? rejected_late()  // others had their turn meanwhile
                             : fmt::format("Line {}: the board rejected \"{}\".", feeding_line_ + 1, sent);
      if (*bad) {
        what += commands_.open_loop_words(sent, before_feeding_);
        selection_.lose();  // it may have been the one that selects
        if (!fed_apart_) selection_.set(before_feeding_);
        co_return co_await end_rejected(std::move(what));
      }
      Context read = before_feeding_;
      for (const TextCommand& command : read_commands(sent, read)) note_effects(command);
    }
    if (to_feed_.empty()) {
      draft_.feed.running = false;
      co_return Result<>();
    }
    const auto late = co_await readings_.was_rejected(Priority::transfer);
    if (!late) co_return fail(late.error());
    std::string what = rejected_late();
    if (*late) co_return co_await end_rejected(std::move(what));
    auto [line, command] = to_feed_.front();
    Context after = fed_context_;
    for (const TextCommand& read : read_commands(command, after)) note_group(read);
    std::string text = fed_text(command, after);
    const auto put = co_await conversation_.put(std::move(text), Priority::transfer);
    if (!put) co_return fail(put.error());
    if (!*put) co_return Result<>();
    to_feed_.pop_front();
    before_feeding_ = std::exchange(fed_context_, after);
    if (!fed_apart_) selection_.set(after);
    selection_.set_recording(after.recording);
    if (!after.recording) selection_.is_said();
    feeding_line_ = line;
    feeding_waits_ = false;
    feeding_ = std::move(command);
  }
  co_return Result<>();
}

void Vme58Driver::end_program(EndedBy ended_by) {
  to_feed_.clear();
  feeding_.clear();
  draft_.feed.running = false;
  if (selection_.end_recording())
    selection_.lose();  // a selector ends it on the board too
  for (AxisMind& mind : minds_) mind.by_text = mind.in_group = false, mind.at_home = AtHome::nothing;
  ProgramState& p = draft_.program;
  if (p.run != RunState::running) return;
  p.run = ended_by == EndedBy::error ? RunState::error : RunState::idle;
  p.owned = false;
  p.command = -1;
  p.ended_by = ended_by;
}

/// The program has ended when all of it has been taken, every queue is empty and nothing moves.
Task<Result<>> Vme58Driver::watch_program() {
  if (draft_.program.run != RunState::running) co_return Result<>();
  if (draft_.feed.running) {
    auto fed = co_await feed();
    if (!fed || draft_.feed.running) co_return fed;
  }
  if (draft_.any_axis_moving()) co_return Result<>();
  const auto worked_off = co_await is_worked_off();
  if (!worked_off) co_return fail(worked_off.error());
  if (!*worked_off) co_return Result<>();
  if (program_flawed_) {
    end_program(EndedBy::error);
    co_return Result<>();
  }
  bool limit = false;
  for (int i = 0; i < axis_count(); ++i) limit = limit || (minds_[ix(i)].turned && met_limit(minds_[ix(i)]));
  for (int i = 0; i < axis_count(); ++i)
    if (!limit) comes_home(i);
  end_program(limit ? EndedBy::limit : EndedBy::target);
  co_return Result<>();
}

void Vme58Driver::queued_was_rejected(std::string& words) {
  for (AxisMind& mind : minds_)
    if (!mind.ours) mind.at_home = AtHome::nothing;  // it may have been the homing
  if (draft_.program.run != RunState::running) return;
  rejection_ = words + " The program did not do all that it says.";
  words = rejection_;
  program_flawed_ = true;
}

std::string Vme58Driver::rejected_late() const {
  return fmt::format("The board rejected a command of lines 1 to {} when its turn in a queue came.",
                     feeding_line_ + 1);
}

/// It stays said until something else is done.
Task<Result<>> Vme58Driver::end_rejected(std::string what) {
  auto stopped = co_await stop_all("SA");
  if (!stopped && stopped.error().kind == FaultKind::stopped) {
    readings_.put_back_command_error();  // for the next round
    co_return stopped;
  }
  rejection_ = what + " The program ends there, and all axes were stopped.";
  end_program(EndedBy::error);
  draft_.notice = rejection_;
  tell(Notice::Kind::error, rejection_);
  co_return stopped;
}

void Vme58Driver::forget_rejection() {
  if (draft_.program.run != RunState::error) return;
  draft_.program.run = RunState::idle;
  draft_.notice.clear();
}

}  // namespace hw::vme58
