#include "gui/model/program_job.h"

#include <cmath>
#include <utility>

#include <fmt/core.h>

#include "core/device/refusals.h"
#include "core/device/transfer_progress.h"
#include "gui/model/units_format.h"

namespace hw::gui {
namespace {

std::string progress_words(const TransferState& t) {
  if (!t.running || (t.done == 0 && t.total == 0)) return {};
  const bool compares = t.phase == TransferState::Phase::comparing;
  std::string progress = fmt::format(": {}{}", compares ? "comparing, " : "", t.done);
  progress += t.total > 0   ? fmt::format(" of {}", count_of(t.total, "lines"))
              : t.done == 1 ? " line"
                            : " lines";
  if (t.left > Duration{})
    progress += fmt::format(", {} left", format_duration(std::ceil(seconds(t.left))).view());
  return progress;
}

}  // namespace

void ProgramJob::refuse(std::string sentence) {
  stage_ = Stage::idle;
  report_ = {Severity::fault, std::move(sentence)};
}

bool ProgramJob::begin(Goal goal, int slot, ProgramTexts& texts, const Snapshot& now, const Catalog& catalog,
                       const Send& send, RunTerms run) {
  if (busy()) {  // the other job, or its question, stays
    report_ = {Severity::fault,
               stage_ == Stage::asking
                   ? "Answer the question about the program first."
                   : "One program transfer at a time: wait until the present one has ended."};
    return false;
  }
  ++begun_;
  given_up_ = false, run_ = std::move(run);
  // Loading a compiled program also keeps it: Store would write the present set-up, trial values and all.
  goal_ = goal == Goal::store && catalog.program.compiled ? Goal::load : goal;
  slot_ = slot, start_ = texts.start_of(slot);
  text_ = texts.text(slot);
  if (goal == Goal::fetch || goal == Goal::make_room) {
    stage_ = Stage::fetching;
    waiting_for_ = send(intent::UploadProgram(slot));
    return true;
  }
  if (goal == Goal::clear) {
    stage_ = Stage::clearing;
    waiting_for_ = written_by_ = send(intent::ClearProgram(slot));
    return true;
  }
  const ProgramReport& report = texts.report(slot);
  for (const Problem& p : report.problems)
    if (p.error) return refuse(fmt::format("Nothing was sent. Line {}: {}", p.line + 1, p.sentence)), false;
  const int capacity = catalog.program.capacity;
  if (const int cost = texts.cost(slot); capacity > 0 && cost > capacity)
    return refuse(
               fmt::format("Nothing was sent. The program needs {} {} and {} fit: {} too many. Shorten it.",
                           cost, catalog.program.capacity_unit, capacity, cost - capacity)),
           false;
  if (capacity > 0 && texts.controller_has(slot)) return after_load(send), true;
  const int used = now.slot_bytes_used[static_cast<std::size_t>(slot)];
  const HeldProgram& held = texts.held(slot);
  const bool torn = (now.slots_torn & torn_bit(catalog, slot)) != 0;  // half of a program from here
  const bool ours = torn || (held.known && held.from_here);
  if (used == 0 || ours || capacity <= 0) return load(send), true;
  stage_ = Stage::comparing;
  waiting_for_ = send(intent::UploadProgram(slot));
  return true;
}

void ProgramJob::load(const Send& send) {
  stage_ = Stage::loading;
  waiting_for_ = written_by_ = send(intent::LoadProgram(slot_, text_));
}

void ProgramJob::after_load(const Send& send) {
  if (goal_ == Goal::load) {
    stage_ = Stage::idle;
    report_ = {Severity::ok, "The controller holds this program now."};
    return;
  }
  if (goal_ == Goal::store) {
    stage_ = Stage::storing;
    waiting_for_ = send(intent::Store());
    return;
  }
  if (std::string why = run_.why_not_now ? run_.why_not_now() : std::string(); !why.empty())
    return refuse(std::move(why));
  stage_ = Stage::starting;
  if (goal_ == Goal::run_stepping) {
    send(intent::SelectProgram(start_));
    waiting_for_ = send(intent::SingleStep());
  } else {
    intent::RunProgram run(start_);
    run.despite_doubt = run_.despite_doubt;
    waiting_for_ = send(std::move(run));
  }
}

void ProgramJob::update(ProgramTexts& texts, const Snapshot& now, const Catalog& catalog, Instant clock,
                        const Send& send) {
  if (stage_ == Stage::idle) return;
  if (now.link.state == LinkState::lost || now.link.state == LinkState::closed) return lose_link(now);
  if (stage_ == Stage::asking) return;
  const IntentOutcome* outcome = now.outcome_of(waiting_for_);
  if (now.forgotten(waiting_for_)) {
    texts.forget();
    return refuse("The outcome of the transfer is not known. Check the controller's program.");
  }
  if (!outcome || outcome->state == IntentState::pending) return;
  if (outcome->state == IntentState::done && given_up_) return end_given_up(texts, clock);
  if (outcome->state == IntentState::done) return done(texts, now, catalog, clock, send);
  if (stage_ == Stage::loading || stage_ == Stage::clearing) texts.forget();
  refuse(std::string(outcome->sentence.view()));
}

/// The refusal includes what was written so far.
void ProgramJob::lose_link(const Snapshot& now) {
  const bool writes = stage_ == Stage::loading || stage_ == Stage::clearing;
  const std::string written = writes && now.slots_torn != 0 ? report_written(now.transfer) : std::string();
  refuse(written.empty()
             ? "The link was lost before the program was transferred. Check it when the link is back."
             : fmt::format("The link was lost while the program was transferred: {}. Load it again when the "
                           "link is back.",
                           written));
}

void ProgramJob::give_up() {
  given_up_ = busy();
  if (stage_ == Stage::asking || stage_ == Stage::starting) stage_ = Stage::idle;
}

void ProgramJob::end_given_up(ProgramTexts& texts, Instant clock) {
  if (stage_ == Stage::loading) texts.loaded(slot_, text_, clock);
  if (stage_ == Stage::clearing) texts.cleared(slot_, clock);
  stage_ = Stage::idle;
  report_ = {Severity::plain,
             "A stop came: the step under way was finished, and the next steps were dropped."};
}

void ProgramJob::fetched(ProgramTexts& texts, const Catalog& catalog) {
  const std::string& text = texts.held(slot_).text;
  const bool replaces = !texts.text(slot_).empty() && texts.text(slot_) != text;
  texts.set_text(slot_, text);
  report_ = {Severity::ok, fmt::format("{} {} was loaded from the controller.{}", catalog.program.slot_word,
                                       slot_, replaces ? " Ctrl+Z restores the earlier text." : "")};
}

void ProgramJob::done(ProgramTexts& texts, const Snapshot& now, const Catalog& catalog, Instant clock,
                      const Send& send) {
  switch (stage_) {
    case Stage::comparing: return compared(texts, now, catalog, send);
    case Stage::loading: texts.loaded(slot_, text_, clock); return after_load(send);
    case Stage::fetching:
      stage_ = Stage::idle;
      if (!texts.held(slot_).known)
        return refuse("The controller listed nothing. The text here is unchanged.");
      if (goal_ == Goal::make_room) return empty_kept(texts, catalog, send);
      return fetched(texts, catalog);
    case Stage::clearing:
      stage_ = Stage::idle;
      texts.cleared(slot_, clock);
      report_ = {Severity::ok,
                 fmt::format("{} {} in the controller is empty. {}", catalog.program.slot_word, slot_,
                             goal_ == Goal::make_room ? "Its text is kept in the editor. Move again."
                                                      : "The text here is unchanged.")};
      return;
    case Stage::storing:
      stage_ = Stage::idle;
      report_ = {Severity::ok, "Stored in the controller."};
      if (now.store_count >= 0 && catalog.can.store_life > 0)
        report_.sentence += fmt::format(" {} of {} writes used.", now.store_count, catalog.can.store_life);
      return;
    default: stage_ = Stage::idle;
  }
}

/// The controller's program must be in the editor before it may be cleared.
void ProgramJob::empty_kept(ProgramTexts& texts, const Catalog& catalog, const Send& send) {
  if (texts.text(slot_).find_first_not_of(" \t\r\n") == std::string::npos)
    texts.set_text(slot_, texts.held(slot_).text);
  else if (!texts.controller_has(slot_))
    return refuse(
        fmt::format("Save the text and clear the editor, or choose another {0}: the editor's {0} {1} differs "
                    "from the controller's, which would be lost. Nothing was emptied.",
                    catalog.program.slot_word, slot_));
  stage_ = Stage::clearing;
  waiting_for_ = written_by_ = send(intent::ClearProgram(slot_));
}

void ProgramJob::compared(ProgramTexts& texts, const Snapshot& now, const Catalog& catalog,
                          const Send& send) {
  const HeldProgram& held = texts.held(slot_);
  if (held.known && text_ == texts.text(slot_) && texts.controller_has(slot_)) return after_load(send);
  if (held.known && held.whole && held.listing.empty()) return load(send);
  const int used = now.slot_bytes_used[static_cast<std::size_t>(slot_)];
  question_ = fmt::format(
      "{} {} in the controller holds another program{}, which was not loaded from here. "
      "Loading this text would overwrite it.",
      catalog.program.slot_word, slot_,
      used > 0 ? " of " + count_of(used, catalog.program.capacity_unit) : "");
  stage_ = Stage::asking;
}

void ProgramJob::answer(Answer answer, ProgramTexts& texts, const Send& send) {
  if (stage_ != Stage::asking) return;
  switch (answer) {
    case Answer::overwrite:
      // The question was about the text at the time of Run, which is no longer the visible one.
      if (texts.text(slot_) != text_)
        return refuse("The text has changed since. Nothing was sent; press Run again.");
      return load(send);
    case Answer::fetch_instead:
      texts.set_text(slot_, texts.held(slot_).text);
      stage_ = Stage::idle;
      return;
    case Answer::leave:
      stage_ = Stage::idle;
      report_ = {Severity::plain, "Nothing was sent. The controller's program is unchanged."};
  }
}

std::string ProgramJob::words(const ProgramFacts& facts, const TransferState& transfer) const {
  const auto about = [&](const char* verb) {
    return fmt::format("{} {} {}{}", verb, facts.slot_word, slot_, progress_words(transfer));
  };
  switch (stage_) {
    case Stage::comparing: return about("Comparing");
    case Stage::loading: return about("Loading");
    case Stage::fetching: return about("Reading");
    case Stage::clearing: return about("Emptying");
    case Stage::storing: return "Storing";
    default: return {};
  }
}

}  // namespace hw::gui
