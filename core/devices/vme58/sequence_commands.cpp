#include "core/devices/vme58/sequence_commands.h"

#include <fmt/format.h>

namespace hw::vme58 {
namespace {

bool sets_speed(Op op) { return op == Op::VL || op == Op::VB || op == Op::AC; }

/// A command in normalised spelling, with the axes it addresses.
std::string spelt(const TextCommand& command) {
  if (!command.fact) return std::string(command.text);
  std::string text = command.context.recording ? "contour" : command.context.selector();
  text.append(" ").append(command.fact->letters);
  std::size_t given = command.numbers.size();
  while (given > 0 && !command.numbers[given - 1]) --given;
  for (std::size_t i = 0; i < given; ++i)
    text += fmt::format("{}{}", i > 0 ? "," : "",
                        command.numbers[i] ? fmt::format("{}", *command.numbers[i]) : std::string());
  return text;
}

/// Drops a trailing selector that no command follows.
void drop_address(Operations& operations) {
  if (!operations.empty() && !operations.back().sets.empty()) operations.pop_back();
}

}  // namespace

Operations operations_of(std::string_view text) {
  const std::string plain = without_comments(text);
  Context context;
  Operations operations;
  for (const TextCommand& command : read_commands(plain, context)) {
    Operation operation;
    operation.at = {command.begin, command.begin + command.length};
    if (selects(command) && !command.context.recording) {
      drop_address(operations);
      operation.text = command.fact->letters;
      operation.sets = "address";
    } else {
      operation.text = spelt(command);
      operation.speed = command.fact && sets_speed(command.fact->op);
      if (command.is(Op::RS)) operation.flow = Operation::Flow::changes_all;
    }
    operations.push_back(std::move(operation));
  }
  drop_address(operations);
  return operations;
}

TextEffects effects_of(std::string_view text) {
  const std::string plain = without_comments(text);
  Context context{where::all};
  TextEffects all;
  for (const TextCommand& command : read_commands(plain, context)) {
    if (!command.fact || !command.flaw.empty() || command.is(Op::RS)) return {true, true, true, true};
    const Op op = command.fact->op;
    all.speeds |= sets_speed(op);
    all.records |= op == Op::CD;
    all.moves |= begins_motion(op) || op == Op::CX || op == Op::LP || op == Op::MV || op == Op::SP ||
                 op == Op::FP || op == Op::MP || op == Op::RM;
  }
  all.addresses = context.mode != where::all || context.recording;
  return all;
}

}  // namespace hw::vme58
