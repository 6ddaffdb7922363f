#include "gui/model/tab_messages.h"

#include <utility>

#include "core/device/refusals.h"

namespace hw::gui {

TabMessages::TabMessages(const Catalog& catalog, const UserSettings& settings, JogHold& jog, EventLog& events)
    : catalog_(catalog), settings_(settings), jog_(jog), events_(events) {}

void TabMessages::add(Notice notice) {
  if (notice.past) notice.text = describe_warned(catalog_, *notice.past, settings_.place_words());
  const bool bad = notice.kind == Notice::Kind::warning || notice.kind == Notice::Kind::error;
  events_.add({LoggedEvent::Mark::message, bad, notice.at, {}, notice.text, -1});
  notices_.push_back(std::move(notice));
}

void TabMessages::follow(const Snapshot& now, Instant clock) {
  followed.refresh(now, [&](const IntentOutcome& outcome) { complain(outcome, clock); });
  pad_looked_at_ = false;
}

void TabMessages::complain(const IntentOutcome& outcome, Instant clock) {
  if (outcome.id == jog_.jog_intent()) jog_.forget();  // there is no jog to stop
  std::string words = words_of(outcome);
  events_.add({LoggedEvent::Mark::message, true, clock, {}, words, -1});
  if (pad_looked_at_ && outcome.past && outcome.id == jog_.tap_intent())
    tap_past_limit = {*outcome.past, std::move(words)};
  else
    complaints_.push_back(std::move(words));
}

std::string TabMessages::words_of(const IntentOutcome& outcome) const {
  return outcome.past ? describe_past(catalog_, *outcome.past, settings_.place_words())
                      : std::string(outcome.sentence.view());
}

std::vector<Notice> TabMessages::take_notices() { return std::exchange(notices_, {}); }

}  // namespace hw::gui
