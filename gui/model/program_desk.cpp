#include "gui/model/program_desk.h"

#include <utility>

namespace hw::gui {

ProgramDesk::ProgramDesk(const Catalog& catalog, const Language* language, DeskWork& work)
    : texts(catalog.program, language),
      requests(catalog, language, texts, job, rehearsals, work),
      follower(catalog),
      catalog_(catalog),
      language_(language),
      work_(work) {}

void ProgramDesk::refresh(const Snapshot& now, const BenchView& bench, Instant clock, const Send& send) {
  doubt_texts(now);
  job.update(texts, now, catalog_, clock, send);
  notice_changes(now);
  requests.follow(now, bench, send);
  rehearsals.follow(now, bench, catalog_, [this](int slot) {
    const HeldProgram& held = texts.held(slot);
    return held.known ? &held.text : nullptr;
  });
  follower.follow(now, bench, clock, texts, language_, work_.worker());
  if (std::exchange(started_at_, now.program.started_at) != now.program.started_at) ++starts_;
}

// Without a link, others may change the programs. Programs under way stay as they are until they end.
void ProgramDesk::doubt_texts(const Snapshot& now) {
  switch (now.link.state) {
    case LinkState::closed: return texts.forget();
    case LinkState::lost: return texts.doubt();
    case LinkState::connecting: return;
    case LinkState::good:
    case LinkState::late: break;
  }
  const RunState run = now.program.run;
  if (run == RunState::idle || run == RunState::error) texts.nothing_runs();
}

// A script, a raw command or a restored backup has written something unknown to the controller.
void ProgramDesk::notice_changes(const Snapshot& now) {
  const std::uint32_t news = now.program_changes - std::exchange(changes_, now.program_changes);
  const bool ours = news == 1 && now.program_changed_by != 0 && now.program_changed_by == job.written_by();
  if (news > 0 && !ours) texts.forget();
}

}  // namespace hw::gui
