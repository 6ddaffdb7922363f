#include "core/devices/vme58/one_axis_text.h"

#include <algorithm>
#include <vector>

#include "core/devices/vme58/command_text.h"

namespace hw::vme58 {
namespace {

/// Commands with the same effect from the queue of one axis and from that of all, while the other axes stand.
/// Not ID: it would set the flags of all axes.
bool is_alike(Op op) {
  switch (op) {
    case Op::VL:
    case Op::VB:
    case Op::AC:
    case Op::MA:
    case Op::MR:
    case Op::GO:
    case Op::JG:
    case Op::HM:
    case Op::HR:
    case Op::WT:
    case Op::SW:
    case Op::BL:
    case Op::BH:
    case Op::LS:
    case Op::LE:
    case Op::WH:
    case Op::WG: return true;
    default: return false;
  }
}

bool is_alike(const TextCommand& command, int axis) {
  const bool addressed = command.context.mode == where::single && command.context.axis == axis;
  return command.fact && command.flaw.empty() && addressed && is_alike(command.fact->op);
}

std::string in_list(const TextCommand& command) {
  if (command.fact->shape != Shape::list) return std::string(command.text);
  std::string text(command.fact->letters);
  text.append(static_cast<std::size_t>(command.context.axis), ',');
  const std::string_view number = command.text.substr(command.fact->letters.size());
  text += number.substr(std::min(number.find_first_not_of(' '), number.size()));
  return text + ';';
}

}  // namespace

std::optional<std::string> in_lists(std::string_view text) {
  const std::string plain = without_comments(text);
  Context context;
  const std::vector<TextCommand> commands = read_commands(plain, context);
  if (commands.empty() || !selects(commands.front())) return std::nullopt;
  if (commands.front().is(Op::AA) || commands.front().is(Op::AM)) return std::nullopt;
  Context first = commands.front().context;
  follow(commands.front(), first);
  std::string lists;
  std::size_t end = 0;
  for (const TextCommand& command : commands) {
    lists.append(text.substr(end, command.begin - end));
    end = command.begin + command.length;
    if (selects(command)) {
      Context next = command.context;
      follow(command, next);
      if (next != first) return std::nullopt;
      lists += "AA";
    } else {
      if (!is_alike(command, first.axis)) return std::nullopt;
      lists += in_list(command);
    }
  }
  return lists.append(text.substr(end));
}

}  // namespace hw::vme58
