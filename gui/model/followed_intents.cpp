#include "gui/model/followed_intents.h"

#include <utility>

namespace hw::gui {

void FollowedIntents::refresh(const Snapshot& now, const std::function<void(const IntentOutcome&)>& failed) {
  const auto settled = [&](IntentId id) {
    const IntentOutcome* outcome = now.outcome_of(id);
    if (!outcome) return now.forgotten(id);  // else not received yet
    if (outcome->state == IntentState::pending) return false;
    if (outcome->state != IntentState::done && !outcome->asks)
      failed(*outcome);  // look_for_questions() handles the others
    return true;
  };
  std::erase_if(followed_, settled);
  look_for_questions(now);
  look_at_stop(now);
}

void FollowedIntents::look_for_questions(const Snapshot& now) {
  const auto settled = [&](Intent& intent) {
    const IntentOutcome* outcome = now.outcome_of(intent.id);
    if (!outcome) return now.forgotten(intent.id);
    if (outcome->state == IntentState::pending) return false;
    if (outcome->asks) question_ = Question{std::move(intent.body), std::string(outcome->sentence.view())};
    return true;
  };
  std::erase_if(may_ask_, settled);
}

// A stop that failed while there was no link is still to be sent.
void FollowedIntents::look_at_stop(const Snapshot& now) {
  const IntentOutcome* outcome = now.outcome_of(stop_);
  if (outcome ? outcome->state == IntentState::pending : !now.forgotten(stop_)) return;
  if ((outcome && outcome->state == IntentState::done) || now.link.connected()) stop_ = 0;
}

}  // namespace hw::gui
