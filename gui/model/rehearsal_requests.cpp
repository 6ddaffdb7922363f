#include "gui/model/rehearsal_requests.h"

#include <utility>

#include "core/device/track.h"
#include "gui/model/rehearsal_reading.h"

namespace hw::gui {

RehearsalRequests::RehearsalRequests(const Catalog& catalog, const Language* language, ProgramTexts& texts,
                                     const ProgramJob& job, Rehearsals& rehearsals, DeskWork& work)
    : catalog_(catalog),
      language_(language),
      texts_(texts),
      job_(job),
      rehearsals_(rehearsals),
      work_(work) {}

void RehearsalRequests::rehearse(const Snapshot& now, const BenchView& bench) {
  const std::string& text = texts_.text(texts_.chosen());
  if (!language_ || text.empty()) return;
  const int slot = texts_.start_of(texts_.chosen());
  unread_.begin();
  latest_slot_ = job_.busy() ? -1 : slot;
  if (job_.busy() || !can_read_more(now)) {
    prepared_.erase(slot);
    return start(slot, text, now, bench);
  }
  if (rehearsals_.under_way(slot)) return;
  prepared_[slot] = text;
  rehearsals_.prepare(slot);
}

void RehearsalRequests::start(int slot, const std::string& text, const Snapshot& now,
                              const BenchView& bench) {
  RehearseOptions options;
  options.slot = slot;
  options.track_every_s = track_seen_every_s;
  rehearsals_.start(*language_, text, options, known_state(texts_, now), bench, catalog_, work_.worker());
}

// Continues however the reading ends: the rehearsal names what was not read. It does not wait for a run that
// is about to begin: the rehearsal would begin in the middle of it.
void RehearsalRequests::follow(const Snapshot& now, const BenchView& bench, const Send& send) {
  look_for_unread_programs(now);
  if (prepared_.empty()) {
    set_up_read_by_ = 0;
    return;
  }
  const bool can_read = !job_.busy() && now.link.connected();
  if (can_read && (reads_set_up(now, send) || !unread_.have_been_read(now, send))) return;
  for (const auto& [slot, text] : std::exchange(prepared_, {})) start(slot, text, now, bench);
}

bool RehearsalRequests::reads_set_up(const Snapshot& now, const Send& send) {
  return can_read_more(now) && awaits_set_up(set_up_read_by_, now, send);
}

void RehearsalRequests::look_for_unread_programs(const Snapshot& now) {
  const Rehearsals::Outcome* outcome = latest_slot_ < 0 ? nullptr : rehearsals_.of(latest_slot_);
  if (!outcome || rehearsals_.under_way(latest_slot_)) return;
  if (!reached_unread(unread_, *outcome, now, catalog_) || job_.busy()) return;
  prepared_[latest_slot_] = outcome->text;
  rehearsals_.prepare(latest_slot_);
}

bool RehearsalRequests::can_read_more(const Snapshot& now) const {
  if (!now.link.connected()) return false;
  for (std::size_t i = 0; i < catalog_.params.size(); ++i)
    if (catalog_.params[i].readable && !now.params[i].known) return true;
  return false;
}

}  // namespace hw::gui
