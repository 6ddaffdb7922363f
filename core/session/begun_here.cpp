#include "core/session/begun_here.h"

#include <algorithm>
#include <variant>

namespace hw {

/// True for single complete commands only, as a combination may do anything. False for a command that starts
/// a motion in another state of the controller.
bool BegunHere::only_asks(const std::string& text) {
  if (harmless_.empty())
    for (const CommandInfo& command : catalog_.commands)
      (command.moves ? moving_ : harmless_).emplace_back(command, catalog_.axes);
  const auto one_of = [&text](const std::vector<CommandForm>& forms) {
    return std::any_of(forms.begin(), forms.end(), [&text](const CommandForm& form) {
      return form.match(text) == CommandForm::Match::whole;
    });
  };
  return one_of(harmless_) && !one_of(moving_);
}

bool BegunHere::may_move(const IntentBody& body) {
  if (const auto* text = std::get_if<intent::SendText>(&body)) return !only_asks(text->text);
  if (const auto* act = std::get_if<intent::Act>(&body)) {
    const auto at = static_cast<std::size_t>(act->action);
    return at >= catalog_.actions.size() || catalog_.actions[at].moves;
  }
  return is_any_of<intent::MoveTo, intent::MoveBy, intent::JogStart, intent::Home, intent::RunProgram,
                   intent::Resume, intent::SingleStep, intent::FeedMoves, intent::RunInPieces,
                   intent::Sample>(body);
}

void BegunHere::posted(const IntentBody& body) {
  if (!may_move(body)) return;
  rests_in_.reset();
  any_ = true;
}

void BegunHere::seen(const Snapshot& now, bool busy, std::uint64_t rounds_ended) {
  if (!any_) return;
  const bool runs = now.program.run != RunState::idle && now.program.run != RunState::error;
  if (busy || runs || now.working || now.feed.running || now.pieces.running || now.any_axis_moving())
    return rests_in_.reset();
  // A round under way may have begun before; only the next is certain.
  if (!rests_in_) rests_in_ = rounds_ended + 2;
  if (rounds_ended >= *rests_in_) any_ = false;
}

}  // namespace hw
