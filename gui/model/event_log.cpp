#include "gui/model/event_log.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "core/base/index.h"
#include "core/device/refusals.h"
#include "gui/model/bus.h"
#include "gui/model/ending_words.h"

namespace hw::gui {
namespace {

constexpr std::size_t most_recent = 16;

bool ended_as_planned(EndedBy by) { return by == EndedBy::target || by == EndedBy::nothing; }

/// Both were cut short together: the motion a moment before the run, or it slowed down a moment longer.
bool ended_with(const Ending& motion, const Ending& run) {
  constexpr Duration a_moment = std::chrono::seconds(3);
  if (!motion.of_run || ended_as_planned(motion.by) || ended_as_planned(run.by)) return false;
  if (motion.at < run.began || motion.began > run.at) return false;
  return std::chrono::abs(motion.at - run.at) <= a_moment;
}

}  // namespace

void EventLog::add(LoggedEvent event) {
  event.number = ++last_number_;
  list_.push_back(std::move(event));
  if (list_.size() > capacity) list_.pop_front();
  ++version_;
}

void EventLog::add(const Ending& ending, const Catalog& catalog, const ShowPosition& position) {
  if (ending.axis >= 0)
    add_motion(ending, catalog, position);
  else
    add_run(ending, catalog, position);
}

void EventLog::add_motion(const Ending& ending, const Catalog& catalog, const ShowPosition& position) {
  const auto run = std::find_if(recent_.rbegin(), recent_.rend(), [&](const Recent& recent) {
    return recent.ending.axis < 0 && ended_with(ending, recent.ending);
  });
  if (run != recent_.rend() && find(run->number)) return join(ending, *run, catalog, position);
  add(event_of(ending, catalog, position));
  keep_recent(ending);
}

void EventLog::add_run(const Ending& ending, const Catalog& catalog, const ShowPosition& position) {
  add(event_of(ending, catalog, position));
  const Recent run{ending, last_number_};
  std::erase_if(recent_, [&](const Recent& motion) {
    if (motion.ending.axis < 0 || !ended_with(motion.ending, ending)) return false;
    std::erase_if(list_, [&](const LoggedEvent& event) { return event.number == motion.number; });
    join(motion.ending, run, catalog, position);
    return true;
  });
  keep_recent(ending);
}

void EventLog::keep_recent(const Ending& ending) {
  recent_.push_back({ending, last_number_});
  if (recent_.size() > most_recent) recent_.erase(recent_.begin());
}

LoggedEvent* EventLog::find(std::uint64_t number) {
  const auto found = std::find_if(list_.rbegin(), list_.rend(),
                                  [number](const LoggedEvent& event) { return event.number == number; });
  return found == list_.rend() ? nullptr : &*found;
}

void EventLog::join(const Ending& motion, const Recent& run, const Catalog& catalog,
                    const ShowPosition& position) {
  LoggedEvent* event = find(run.number);
  if (!event) return;
  const LoggedEvent own = event_of(motion, catalog, position);
  if (own.bad && !event->bad) event->mark = own.mark, event->bad = true;
  event->words += words_beside_run(motion, run.ending, catalog, position);
  ++version_;
}

void EventLog::follow(const Snapshot& now, const Catalog& catalog) {
  follow_link(now);
  if (!now.link.connected()) return;
  follow_trust(now, catalog);
  if (!std::exchange(looked_, true)) first_answer_at_ = now.at;
}

void EventLog::follow_link(const Snapshot& now) {
  const bool there = now.link.connected();
  if (there == was_there_ || (!there && now.link.state == LinkState::connecting)) return;
  was_there_ = there;
  if (!there) lost_at_ = now.at;
  if (now.link.state == LinkState::lost)
    add({LoggedEvent::Mark::link, true, now.at, {}, "no reply any more: the link is lost", -1});
  else if (there && looked_)
    add({LoggedEvent::Mark::link, false, now.at, {}, "answers again", seconds(now.at - lost_at_)});
}

/// Axes that one cause makes doubtful at once are one event.
void EventLog::follow_trust(const Snapshot& now, const Catalog& catalog) {
  constexpr Duration at_once = std::chrono::seconds(1);
  struct Loss {
    PositionTrust trust;
    std::vector<std::string_view> axes;
  };
  std::vector<Loss> losses;
  for (int i = 0; i < now.axis_count; ++i) {
    const PositionTrust trust = now.axes[ix(i)].trust, before = std::exchange(trust_[ix(i)], trust);
    const bool as_before = before.doubtful() && before.cause == trust.cause && before.since == trust.since;
    const bool reported = trust.cause == Doubt::killed && looked_;  // by the driver, with the speed
    if (!trust.doubtful() || as_before || reported) continue;
    auto loss = std::find_if(losses.begin(), losses.end(), [&](const Loss& one) {
      return one.trust.cause == trust.cause && std::chrono::abs(one.trust.since - trust.since) <= at_once;
    });
    if (loss == losses.end()) loss = losses.insert(losses.end(), {trust, {}});
    loss->axes.push_back(catalog.axes[ix(i)].name);
  }
  for (const Loss& loss : losses) {
    const bool one = loss.axes.size() == 1;
    const std::string words = fmt::format("cannot be trusted any more: {}", words_of(loss.trust.cause));
    add({LoggedEvent::Mark::place_lost, true, loss.trust.since,
         one ? std::string(loss.axes[0]) : std::string(),
         one ? words : fmt::format("{} {}", in_words(loss.axes), words), -1});
  }
}

bool is_shown(const LoggedEvent& event, EventFilter filter) {
  switch (filter) {
    case EventFilter::ends:
      if (event.mark == LoggedEvent::Mark::message) return event.took_s >= 0;  // an unknown end
      return event.mark != LoggedEvent::Mark::link;
    case EventFilter::trouble: return event.bad;
    case EventFilter::all: break;
  }
  return true;
}

NumberText duration_of(const LoggedEvent& event) {
  return event.took_s < 0 ? NumberText() : format_duration(event.took_s);
}

std::string EventLog::text(EventFilter filter, const DayClock& day) const {
  std::string all;
  for (auto event = list_.rbegin(); event != list_.rend(); ++event) {
    if (!is_shown(*event, filter)) continue;
    char time[16];
    all += fmt::format("{}  {}{}{}", format_time_of_day(day.of(event->at), false, time), event->subject,
                       event->subject.empty() ? "" : " ", event->words);
    if (event->took_s >= 0) all += fmt::format(" ({})", duration_of(*event).view());
    all += '\n';
  }
  return all;
}

}  // namespace hw::gui
