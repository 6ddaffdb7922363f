#include "core/devices/vme58/sequence_commands.h"

#include <algorithm>
#include <cmath>

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

bool goes_to_a_place(Op op) {
  return op == Op::MA || op == Op::MT || op == Op::MV || op == Op::SP || op == Op::FP;
}
bool sets_count(Op op) { return op == Op::LP || op == Op::HM || op == Op::HR; }

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

std::vector<AxisTarget> places_of_text(std::string_view text) {
  const std::string plain = without_comments(text);
  Context context;
  unsigned counted = 0;
  std::vector<AxisTarget> places;
  for (const TextCommand& command : read_commands(plain, context)) {
    const bool goes = command.fact && goes_to_a_place(command.fact->op);
    if (!goes && !(command.fact && sets_count(command.fact->op))) continue;
    const bool one = command.context.mode == where::single;
    for (std::size_t n = 0;
         n < (one ? std::min<std::size_t>(1, command.numbers.size()) : command.numbers.size()); ++n) {
      if (!command.numbers[n]) continue;
      const auto axis = one ? static_cast<unsigned>(command.context.axis) : static_cast<unsigned>(n);
      if (!goes)
        counted |= 1u << axis;
      else if ((counted >> axis & 1u) == 0)
        places.push_back({AxisId{static_cast<std::uint8_t>(axis)}, Steps(std::llround(*command.numbers[n]))});
    }
  }
  return places;
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
