#include "gui/model/desk.h"

#include <utility>
#include <variant>

#include "core/device/track.h"
#include "gui/model/list_run.h"
#include "gui/model/rehearsal_reading.h"
#include "gui/model/step_recorder.h"

namespace hw::gui {

// Short enough that a crash costs a word or two, long enough that not every key press writes a file.
static constexpr Duration autosave_after = Millis(1000);

Desk::Desk(const Catalog& catalog, const Language* language, TrafficLog::Explain explain)
    : traffic(explain),
      texts(catalog.program, language),
      blocks(catalog),
      list_run(std::make_unique<ListRun>()),
      step_recorder(std::make_unique<StepRecorder>()),
      follower(catalog),
      setup(catalog),
      help(catalog),
      catalog_(catalog),
      language_(language) {}

Desk::~Desk() = default;

Result<> Desk::keep_texts(Autosave autosave, std::string key) {
  kept_.autosave = std::move(autosave);
  kept_.key = std::move(key);
  const auto restored = kept_.autosave.restore(kept_.key);
  if (!restored) return fail(restored.error());
  texts.restore(*restored);
  const Result<> blocks_restored = blocks.restore(*restored);
  kept_.saved = typed();
  return blocks_restored;
}

std::vector<std::filesystem::path> Desk::take_dropped(std::string_view panel) {
  const auto found = dropped.find(panel);
  return found == dropped.end() ? std::vector<std::filesystem::path>() : std::exchange(found->second, {});
}

void Desk::rehearse(const Snapshot& now, const BenchView& bench) {
  const std::string& text = texts.text(texts.chosen());
  if (!language_ || text.empty()) return;
  const int slot = texts.start_of(texts.chosen());
  unread_.begin();
  rehearsed_slot_ = job.busy() ? -1 : slot;
  if (job.busy() || !can_read_more(now)) {
    prepared_.erase(slot);
    return start_rehearsal(slot, text, now, bench);
  }
  if (rehearsals.under_way(slot)) return;
  prepared_[slot] = text;
  rehearsals.prepare(slot);
}

void Desk::start_rehearsal(int slot, const std::string& text, const Snapshot& now, const BenchView& bench) {
  RehearseOptions options;
  options.slot = slot;
  options.track_every_s = track_seen_every_s;
  rehearsals.start(*language_, text, options, state_of(now), bench, catalog_, worker());
}

// Continues however the reading ends: the rehearsal names what was not read. It does not wait for a run that
// is about to begin: the rehearsal would begin in the middle of it.
void Desk::rehearse_prepared(const Snapshot& now, const BenchView& bench, const Send& send) {
  look_for_unread_programs(now);
  if (prepared_.empty()) {
    set_up_read_by_ = 0;
    return;
  }
  const bool can_read = !job.busy() && now.link.connected();
  if (can_read && (reads_set_up(now, send) || !unread_.have_been_read(now, send))) return;
  for (const auto& [slot, text] : std::exchange(prepared_, {})) start_rehearsal(slot, text, now, bench);
}

bool Desk::reads_set_up(const Snapshot& now, const Send& send) {
  return can_read_more(now) && awaits_set_up(set_up_read_by_, now, send);
}

void Desk::look_for_unread_programs(const Snapshot& now) {
  const Rehearsals::Outcome* outcome = rehearsed_slot_ < 0 ? nullptr : rehearsals.of(rehearsed_slot_);
  if (!outcome || rehearsals.under_way(rehearsed_slot_)) return;
  if (!reached_unread(unread_, *outcome, now, catalog_) || job.busy()) return;
  prepared_[rehearsed_slot_] = outcome->text;
  rehearsals.prepare(rehearsed_slot_);
}

bool Desk::can_read_more(const Snapshot& now) const {
  if (!now.link.connected()) return false;
  for (std::size_t i = 0; i < catalog_.params.size(); ++i)
    if (catalog_.params[i].readable && !now.params[i].known) return true;
  return false;
}

ControllerState Desk::state_of(const Snapshot& now) const {
  ControllerState state{now, {}};
  for (int slot = 0; slot < texts.count(); ++slot)
    if (texts.held(slot).known) state.programs[slot] = texts.held(slot).text;
  return state;
}

void Desk::sent(const IntentBody& body) {
  if (std::holds_alternative<intent::Reset>(body)) texts.doubt();
  if (std::holds_alternative<intent::Stop>(body) || std::holds_alternative<intent::Abort>(body) ||
      std::holds_alternative<intent::HaltProgram>(body))
    stopped();
}

void Desk::stopped() {
  job.give_up();
  list_run->stopped();
  step_recorder->stopped();
  until_stopped_ = std::make_shared<int>(0);
}

void Desk::refresh(const Snapshot& now, const BenchView& bench, Instant clock, const Send& send) {
  if (!worker_) own_worker_.deliver();
  doubt_texts(now);
  job.update(texts, now, catalog_, clock, send);
  trace.follow(now);
  notice_program_changes(now);
  rehearse_prepared(now, bench, send);
  rehearsals.follow(now, bench, catalog_, [this](int slot) {
    const HeldProgram& held = texts.held(slot);
    return held.known ? &held.text : nullptr;
  });
  follower.follow(now, bench, clock, texts, language_, worker());
  if (std::exchange(started_at_, now.program.started_at) != now.program.started_at) ++starts_;
  setup_write.update(now, catalog_, send);
  setup.settle(now);
  places.follow(now, clock, send, worker());
  events.follow(now, catalog_);
  autosave(clock);
}

// Without a link, others may change the programs. Programs under way stay as they are until they end.
void Desk::doubt_texts(const Snapshot& now) {
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
void Desk::notice_program_changes(const Snapshot& now) {
  const std::uint32_t news = now.program_changes - std::exchange(program_changes_, now.program_changes);
  const bool ours = news == 1 && now.program_changed_by != 0 && now.program_changed_by == job.written_by();
  if (news > 0 && !ours) texts.forget();
}

void Desk::autosave(Instant clock) {
  if (!kept_.autosave.enabled() || typed() == kept_.saved) return;
  if (!kept_.dirty) {
    kept_.dirty = true;
    kept_.changed_at = clock;
  }
  if (clock - kept_.changed_at >= autosave_after) keep_texts_now();
}

void Desk::keep_now(Instant clock) {
  places.keep_now(clock, worker());
  keep_texts_now();
}

void Desk::keep_texts_now() {
  if (!kept_.autosave.enabled() || typed() == kept_.saved) return;
  kept_.dirty = false;
  kept_.saved = typed();
  worker().run(
      [autosave = kept_.autosave, key = kept_.key, unsaved = texts.unsaved(),
       of_blocks = blocks.unsaved()]() mutable {
        if (of_blocks) unsaved.push_back(of_blocks->text());
        // a full disk is reported on save; here it would only nag
        return autosave.keep(key, unsaved);
      },
      [](Result<>) {}, alive_);
}

double Desk::autosave_due_in(Instant clock) const {
  const double texts_in =
      kept_.dirty ? std::max(0.0, seconds(autosave_after - (clock - kept_.changed_at))) : -1;
  const double places_in = places.due_in(clock);
  return texts_in < 0 || places_in < 0 ? std::max(texts_in, places_in) : std::min(texts_in, places_in);
}

}  // namespace hw::gui
