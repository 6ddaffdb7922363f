// What the board rejects: at once, or when its turn in a queue comes (decision M17). One bit of the status
// register tells both, and which command it was has to be worked out.
#include <utility>

#include <fmt/core.h>

#include "core/base/index.h"
#include "core/devices/vme58/driver.h"

namespace hw::vme58 {
namespace {

bool wants_closed_loop(Op op) {
  switch (op) {
    case Op::MA:
    case Op::MR:
    case Op::MT:
    case Op::ML:
    case Op::GO:
    case Op::GD:
    case Op::JG:
    case Op::JF:
    case Op::HM:
    case Op::HR:
    case Op::KM:
    case Op::KR: return true;
    default: return false;
  }
}

}  // namespace

/// Whose servo loop is open takes no motion; said only when the text would move it.
std::string Vme58Driver::open_loop_words(std::string_view text, Context context) const {
  for (const TextCommand& command : read_commands(text, context)) {
    if (!command.fact) continue;
    for (int i = 0; i < axis_count(); ++i) {
      const bool one = command.context.mode == where::single;
      const bool meant = one ? i == command.context.axis
                             : ix(i) < command.numbers.size() && command.numbers[ix(i)].has_value();
      if (!meant || !catalog_.axes[ix(i)].switchable || draft_.axes[i].enabled ||
          !wants_closed_loop(command.fact->op))
        continue;
      return fmt::format(
          " The servo loop of axis {0} is open (off), and so it takes no motion: HN (Hold on, or the axis' "
          "power) closes it.",
          axis_name(i));
    }
  }
  return {};
}

tl::unexpected<Fault> Vme58Driver::rejected(std::string_view text) const {
  if (const std::string open = open_loop_words(text, context_); !open.empty())
    return fail(FaultKind::controller, fmt::format("The board rejected \"{}\".{}", without_end(text), open),
                "The rest of what it understood was carried out.", "Close the loop, then send it again.");
  return fail(FaultKind::controller,
              fmt::format("The board rejected \"{}\": its status register reports a command error.",
                          without_end(text)),
              "The rest of what it understood was carried out.",
              "Look at the axis' fitting (servo, step, encoder), the range of the number, and the mode.");
}

// A command error stays until the status register is read, which clears it.
Task<Result<bool>> Vme58Driver::was_rejected(Priority priority) {
  const auto registers = co_await read_registers(priority, false);
  if (!registers) co_return fail(registers.error());
  take_registers(*registers);
  co_return std::exchange(command_error_, false);
}

// What waits in a queue may be rejected at any time: not to be taken for the fault of what is sent next.
Task<Result<>> Vme58Driver::settle_late_rejection(Priority priority) {
  if (!draft_.working) co_return Result<>();
  const auto late = co_await was_rejected(priority);
  if (!late) co_return fail(late.error());
  if (*late) show_late_rejection();
  co_return Result<>();
}

// The error came to light in a round of status: what had waited in a queue was rejected when its turn came.
void Vme58Driver::show_late_rejection() {
  for (AxisMind& mind : minds_)
    if (!mind.ours) mind.at_home = AtHome::nothing;  // it may have been the homing
  std::string words = fmt::format(
      "The board reports a command error: of what waited in a queue, or of \"{}\".", without_end(last_said_));
  if (draft_.program.run == RunState::running) {
    rejection_ = words + " The program did not do all that it says.";
    words = rejection_;
    program_flawed_ = true;
  }
  tell(Notice::Kind::error, std::move(words));
}

std::string Vme58Driver::rejected_late() const {
  return fmt::format("The board rejected a command of lines 1 to {} when its turn in a queue came.",
                     feeding_line_ + 1);
}

/// It stays said until something else is done.
Task<Result<>> Vme58Driver::end_rejected(std::string what) {
  auto stopped = co_await stop_all("SA");
  if (!stopped && stopped.error().kind == FaultKind::stopped) {
    command_error_ = true;  // for the next round
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
