#include "gui/model/event_log.h"

#include <utility>

#include <fmt/format.h>

#include "core/base/index.h"
#include "core/device/refusals.h"

namespace hw::gui {

void EventLog::add(Happening event) {
  list_.push_back(std::move(event));
  if (list_.size() > capacity) list_.pop_front();
  ++version_;
}

void EventLog::follow(const Snapshot& now, const Catalog& catalog) {
  follow_link(now);
  if (!now.link.connected()) return;
  follow_trust(now, catalog);
  looked_ = true;
}

void EventLog::follow_link(const Snapshot& now) {
  const bool there = now.link.connected();
  if (there == was_there_ || (!there && now.link.state == LinkState::connecting)) return;
  was_there_ = there;
  if (!there) lost_at_ = now.at;
  if (now.link.state == LinkState::lost)
    add({Happening::Mark::link, true, now.at, {}, "no answer any more: the link is lost", -1});
  else if (there && looked_)
    add({Happening::Mark::link, false, now.at, {}, "answers again", seconds(now.at - lost_at_)});
}

void EventLog::follow_trust(const Snapshot& now, const Catalog& catalog) {
  for (int i = 0; i < now.axis_count; ++i) {
    const PositionTrust trust = now.axes[ix(i)].trust, before = std::exchange(trust_[ix(i)], trust);
    const bool as_before = before.doubtful() && before.cause == trust.cause && before.since == trust.since;
    const bool told = trust.cause == Doubt::killed && looked_;  // by the driver, with the speed
    if (!trust.doubtful() || as_before || told) continue;
    add({Happening::Mark::place_lost, true, trust.since, catalog.axes[ix(i)].name,
         fmt::format("cannot be trusted any more: {}", words_of(trust.cause)), -1});
  }
}

bool is_shown(const Happening& event, EventFilter filter) {
  switch (filter) {
    case EventFilter::ends:
      return event.mark != Happening::Mark::message && event.mark != Happening::Mark::link;
    case EventFilter::trouble: return event.bad;
    case EventFilter::all: break;
  }
  return true;
}

NumberText duration_of(const Happening& event) {
  return event.took_s < 0 ? NumberText() : format_duration(event.took_s);
}

std::string EventLog::text(EventFilter filter, const DayClock& day) const {
  std::string all;
  for (auto event = list_.rbegin(); event != list_.rend(); ++event) {
    if (!is_shown(*event, filter)) continue;
    char time[16];
    all += fmt::format("{}  {}{}{}", format_time_of_day(day.of(event->at), false, time), event->who,
                       event->who.empty() ? "" : " ", event->words);
    if (event->took_s >= 0) all += fmt::format(" ({})", duration_of(*event).view());
    all += '\n';
  }
  return all;
}

}  // namespace hw::gui
