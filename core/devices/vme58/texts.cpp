#include "core/devices/vme58/texts.h"

#include <algorithm>
#include <utility>

#include <fmt/core.h>

#include "core/devices/vme58/moves.h"
#include "core/devices/vme58/text_meaning.h"

namespace hw::vme58 {
namespace {

constexpr std::size_t longest_text = 240;  // bytes that the ring takes at once, less room for separators

bool is_queued(const TextCommand& command) { return command.fact && command.fact->when == When::queued; }

}  // namespace

Task<Result<std::string>> Texts::send(std::string text, Duration patience) {
  forget_rejection(snapshot_);
  Context context = selection_.context();
  const auto commands = read_commands(text, context);
  if (auto may = may_send_while_feeding(commands); !may) co_return fail(may.error());
  auto prepared = co_await prepare(commands);
  if (!prepared) co_return fail(prepared.error());
  std::string answers;
  for (const TextCommand& command : commands) {
    auto sent = co_await transmit(command, patience);
    if (!sent && sent.error().kind != FaultKind::controller) prepared_.doubt(command);
    if (!sent) co_return fail(sent.error());
    if (!sent->empty()) answers += (answers.empty() ? "" : "\n") + *sent;
    note_sent(command);
  }
  next_.asks_flags();
  co_return answers;
}

/// Gives the axes the user's own speeds, and the board the user's selected axis.
Task<Result<>> Texts::prepare(const std::vector<TextCommand>& commands) {
  auto own = co_await speeds_.give_all_back(Priority::intent);
  if (own && std::any_of(commands.begin(), commands.end(), is_queued))
    own = co_await speeds_.give_back_behind_motions(Priority::intent);
  if (!own) co_return own;
  co_return co_await conversation_.select_again(Priority::intent);
}

/// Returns the reply, if there is one.
Task<Result<std::string>> Texts::transmit(const TextCommand& command, Duration patience) {
  std::string word(command.text);
  if (word.size() > longest_text)
    co_return fail(FaultKind::refused, "One command of this text is longer than the board's ring.",
                   "It was not sent.");
  word += ";\n";
  if (is_question(command) && command.flaw.empty()) {
    const ReplyForm form = reply_form(command, static_cast<int>(catalog_.axes.size()));
    co_return co_await conversation_.ask(std::move(word), Priority::intent, form, patience);
  }
  Result<> done;
  if (command.is(Op::RS) && command.flaw.empty())
    done = co_await reset(std::move(word));
  else
    done = co_await put(command, std::move(word));
  if (!done) co_return fail(done.error());
  co_return std::string();
}

/// Sends a command that is no question.
Task<Result<>> Texts::put(const TextCommand& command, std::string word) {
  auto settled = co_await commands_.settle_late(Priority::intent);
  if (!settled) co_return settled;
  if (!command.fact || command.fact->when == When::queued) next_.awaits_queues();
  programs_.note_stop(command);
  motions_.note_group(command);  // before a stop can intervene
  const int end_before = conversation_.end();
  auto written =
      co_await conversation_.write(std::move(word), Priority::intent, Conversation::WhenStuck::leave);
  if (!written && conversation_.end() == end_before) co_return written;
  if (!written && written.error().kind == FaultKind::stopped) co_return cut_short(command, written.error());
  if (!written) {
    if (selects(command))
      note_sent(command);  // it takes effect later, from the ring, also for texts sent after it
    co_return written;
  }
  auto accepted = co_await accepts(command);
  if (!accepted && accepted.error().kind == FaultKind::stopped)
    co_return cut_short(command, accepted.error());
  if (!accepted && selects(command)) selection_.lose();  // the board may have selected it
  co_return accepted;
}

/// A stop came while the command was under way: the command was taken back or carried out.
Result<> Texts::cut_short(const TextCommand& command, Fault why) {
  effects_.note(command);
  if (selects(command)) selection_.lose();
  return fail(when_put(std::move(why)));
}

/// Checks that the command, taken from the ring, was no command error.
Task<Result<>> Texts::accepts(const TextCommand& command) {
  const auto bad = co_await readings_.was_rejected(Priority::intent);
  if (!bad) co_return fail(bad.error());
  if (!*bad) co_return Result<>();
  if (selection_.recording() && (command.is(Op::CE) || command.is(Op::CK))) {
    selection_.set_recording(false);  // the recording cannot end otherwise
    selection_.lose();
    next_.awaits_queues();
  }
  if (!command.flaw.empty())
    co_return fail(FaultKind::controller,
                   fmt::format("The board rejected \"{}\": {}", command.text, command.flaw),
                   "The commands before it were carried out; nothing after it was sent.");
  co_return commands_.rejected(command.text);
}

/// Refuses the text while a contour is recorded (CD to CE), by the user or by a program: it would become part
/// of the contour.
Result<> Texts::may_send_while_feeding(const std::vector<TextCommand>& commands) const {
  const auto stops = [](const TextCommand& command) {
    return command.fact && stops_motion(command.fact->op);
  };
  if (!feed_.is_under_way() || std::all_of(commands.begin(), commands.end(), stops)) return {};
  if (selection_.recording())
    return fail(FaultKind::refused,
                "The program that runs is recording a contour: this text would become part of it.",
                "Nothing was sent.", "Send it again when the contour has ended, or stop the program first.");
  const auto records = [](const TextCommand& command) { return command.is(Op::CD); };
  if (std::any_of(commands.begin(), commands.end(), records))
    return fail(FaultKind::refused,
                "A program is being sent to the board: its commands would become part of this contour.",
                "Nothing was sent.", "Wait until the program ends, or stop it.");
  return {};
}

void Texts::note_stop(std::string_view words) {
  Context context = selection_.context();
  for (const TextCommand& command : read_commands(words, context))
    prepared_.note(command, selection_.user_units());
}

void Texts::note_sent(const TextCommand& command) {
  if (!command.fact || !command.flaw.empty()) return;
  prepared_.note(command, selection_.user_units());
  if (selects(command)) feed_.user_selects();
  const bool recorded = selection_.recording();
  selection_.observe(command);
  if (recorded && !selection_.recording())
    next_.awaits_queues();  // no question was possible during the recording
  effects_.note(command);
}

}  // namespace hw::vme58
