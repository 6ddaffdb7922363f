#include "core/devices/vme58/text_meaning.h"

#include <algorithm>
#include <set>

namespace hw::vme58 {
namespace {

constexpr int several = -1;

/// The stops in a text of nothing but stops; none for any other text.
struct StopsInText {
  bool all = false;    ///< all axes, whatever is selected
  std::set<int> axes;  ///< stopped by ST, or `several`

  [[nodiscard]] bool any() const { return all || !axes.empty(); }
};

StopsInText stops_in(const std::vector<TextCommand>& commands, int axes) {
  StopsInText stops;
  bool selected = false;
  for (const TextCommand& command : commands) {
    if (!command.fact || !command.flaw.empty()) return {};
    const Op op = command.fact->op;
    if (selects(command)) {
      if (op >= Op::AX && op <= Op::AS && static_cast<int>(op) - static_cast<int>(Op::AX) >= axes) return {};
      selected = true;
    } else if (!stops_motion(op) || (op == Op::ST && !selected)) {
      return {};
    } else if (op == Op::ST) {
      stops.axes.insert(command.context.mode == where::single ? command.context.axis : several);
    } else {
      stops.all = true;
    }
  }
  return stops;
}

/// RA and RI clear the flags that they report.
bool only_asks(const std::vector<TextCommand>& commands) {
  const auto changes = [](const TextCommand& c) {
    if (!c.fact || !c.flaw.empty()) return true;
    return !selects(c) && (!is_question(c) || c.fact->op == Op::RA || c.fact->op == Op::RI);
  };
  return !commands.empty() && std::none_of(commands.begin(), commands.end(), changes);
}

}  // namespace

bool stops_motion(Op op) { return op == Op::ST || op == Op::SA || op == Op::SD || op == Op::KL; }

bool moves_in_queue(Op op) {
  switch (op) {
    case Op::GO:
    case Op::GD:
    case Op::HM:
    case Op::HR:
    case Op::KM:
    case Op::KR:
    case Op::MV:
    case Op::SP:
    case Op::CX: return true;
    default: return false;
  }
}

bool is_question(const TextCommand& command) { return command.fact && command.fact->when == When::query; }

ReplyForm reply_form(const TextCommand& question, int axes) {
  switch (question.fact->op) {
    case Op::WY: return {ReplyForm::Of::greeting};
    case Op::RP:
    case Op::RE:
    case Op::RC:
    case Op::RV:
    case Op::RQ: return {ReplyForm::Of::numbers};
    case Op::BX:
    case Op::RB: return {ReplyForm::Of::hex};
    case Op::RL: return {ReplyForm::Of::slips, axes};
    case Op::RI:
    case Op::QI: return {ReplyForm::Of::flags, axes};
    case Op::RA:
    case Op::QA: return {ReplyForm::Of::flags, 1};
    case Op::EA: return {ReplyForm::Of::loop};
    default: return {};  // other firmware may have more questions
  }
}

TextMeaning meaning_of(std::string_view text, Context context, int axes) {
  const std::vector<TextCommand> commands = read_commands(text, context);
  TextMeaning meaning;
  const bool answers = std::any_of(commands.begin(), commands.end(), is_question);
  meaning.answered = answers ? TextMeaning::Answered::at_once : TextMeaning::Answered::never;
  meaning.restarts = std::any_of(commands.begin(), commands.end(), [](const TextCommand& command) {
    return command.fact && command.fact->op == Op::RS && command.flaw.empty();
  });
  meaning.only_asks = only_asks(commands);
  const StopsInText stops = stops_in(commands, axes);
  if (stops.any()) meaning.stops = stops.all ? TextMeaning::Stops::all : TextMeaning::Stops::some;
  if (stops.all) return meaning;
  if (stops.axes.size() == 1) meaning.axis = *stops.axes.begin();
  for (const int axis : stops.axes) meaning.axes |= axis == several ? (1u << axes) - 1 : 1u << axis;
  return meaning;
}

}  // namespace hw::vme58
