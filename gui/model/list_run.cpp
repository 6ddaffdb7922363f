#include "gui/model/list_run.h"

namespace hw::gui {

void ListRun::begin(std::string text, std::vector<AxisTarget> places, const Send& send) {
  places_ = std::move(places);
  may_start_ = true;
  loading_ = send(intent::LoadProgram(0, std::move(text)));
}

const IntentOutcome* ListRun::ended(IntentId& id, const Snapshot& now) const {
  if (id == 0) return nullptr;
  const IntentOutcome* outcome = now.outcome_of(id);
  const bool forgotten = now.forgotten(id);
  if (forgotten || (outcome && outcome->state != IntentState::pending)) id = 0;
  return id == 0 ? outcome : nullptr;
}

void ListRun::follow(const Snapshot& now, const Send& send, const Words& words) {
  const bool was_away = !std::exchange(seen_, false);
  if (was_away) may_start_ = false;
  if (const IntentOutcome* loaded = ended(loading_, now)) {
    if (loaded->state != IntentState::done) {
      reports_.push_back({Severity::fault, words(*loaded)});
    } else if (may_start_) {
      start_.emplace(0, places_);
      starting_ = send(*start_);
    } else {
      reports_.push_back(
          {Severity::warn,
           "Start the list again: it was loaded, but another panel came to the front before it began."});
    }
  }
  const IntentOutcome* started = ended(starting_, now);
  if (!started || started->state == IntentState::done) return;
  if (was_away)
    reports_.push_back({Severity::fault, words(*started)});
  else
    refusal_ = *started;
}

}  // namespace hw::gui
