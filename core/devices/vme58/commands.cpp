#include "core/devices/vme58/commands.h"

#include <fmt/core.h>

#include "core/base/index.h"

namespace hw::vme58 {
namespace {

bool wants_closed_loop(Op op) {
  return begins_motion(op) || op == Op::MA || op == Op::MR || op == Op::MT || op == Op::ML;
}

}  // namespace

std::string Commands::open_loop_words(std::string_view text, Context context) const {
  for (const TextCommand& command : read_commands(text, context)) {
    if (!command.fact) continue;
    for (int i = 0; i < static_cast<int>(catalog_.axes.size()); ++i) {
      const bool one = command.context.mode == where::single;
      const bool meant = one ? i == command.context.axis
                             : ix(i) < command.numbers.size() && command.numbers[ix(i)].has_value();
      if (!meant || !catalog_.axes[ix(i)].switchable || snapshot_.axes[i].enabled ||
          !wants_closed_loop(command.fact->op))
        continue;
      return fmt::format(
          " The servo loop of axis {0} is open (off), so the axis accepts no motion. HN (Hold on, or the "
          "axis' power) closes the loop.",
          catalog_.axes[ix(i)].name);
    }
  }
  return {};
}

tl::unexpected<Fault> Commands::rejected(std::string_view text) const {
  const std::string open = open_loop_words(text, selection_.context());
  if (open.empty()) return rejected_by_board(text);
  return fail(FaultKind::controller, fmt::format("The board rejected \"{}\".{}", without_end(text), open),
              "The other commands of this text were carried out.", "Close the loop, then send it again.");
}

Result<> Commands::may_talk() const {
  if (!wire_.is_open()) return no_connection();
  if (!selection_.recording()) return {};
  return fail(FaultKind::refused, "A contour is being recorded: a command sent now would become part of it.",
              "Nothing was sent.", "End it with CE or CK in the terminal first.");
}

Task<Result<>> Commands::transmit(std::string text, Priority priority) {
  auto settled = co_await settle_late(priority);
  if (!settled) co_return settled;
  const int end_before = conversation_.end();
  auto written = co_await conversation_.write(text, priority);
  if (!written && conversation_.was_taken_back()) written.error().kind = FaultKind::refused;
  if (!written)
    co_return fail(conversation_.end() == end_before ? written.error() : when_put(written.error()));
  const auto bad = co_await readings_.was_rejected(priority);
  if (!bad) co_return fail(when_put(bad.error()));
  if (*bad) co_return rejected(text);
  co_return Result<>();
}

Task<Result<>> Commands::settle_late(Priority priority) {
  if (!snapshot_.working) co_return Result<>();
  const auto late = co_await readings_.was_rejected(priority);
  if (!late) co_return fail(late.error());
  if (*late) show_late();
  co_return Result<>();
}

void Commands::show_late() {
  std::string words = fmt::format("The board reports a command error, in a queued command or in \"{}\".",
                                  without_end(conversation_.last_not_polled()));
  if (rejected_late) rejected_late(words);
  wire_.report(Notice::Kind::error, std::move(words));
}

}  // namespace hw::vme58
