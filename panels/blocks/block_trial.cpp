#include "panels/blocks/block_trial.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "core/base/index.h"
#include "core/device/track_path.h"
#include "gui/model/rehearsal_reading.h"
#include "gui/model/tab.h"
#include "gui/model/units_format.h"
#include "gui/surface/ui.h"
#include "panels/blocks/block_times.h"
#include "panels/program/rehearsal_words.h"
#include "panels/program/run_bar.h"

namespace hw::panels {

using namespace gui;
namespace {

/// The first trial is brief, with a fine path. If it has not ended by then, the next trial is as long as that
/// of Simulate.
struct Length {
  double for_s, seen_every_s;
};
constexpr Length brief{600, 0.02};
const Length as_simulated{RehearseOptions().for_seconds, 0.2};

bool out_of_time(const Rehearsal& r, double for_s) {
  return !r.finished && !r.endless && r.duration_s >= for_s;
}

/// The first two axes, unless others move instead. A single axis is drawn over time.
PathAxes axes_of(const Rehearsal& r, const Catalog& catalog) {
  std::vector<AxisId> moving;
  for (std::size_t a = 0; a < r.axes.size() && a < catalog.axes.size(); ++a)
    if (r.axes[a].travel > 0) moving.push_back(AxisId{static_cast<std::uint8_t>(a)});
  PathAxes axes;
  if (moving.size() > 1) axes.right = moving[0], axes.up = moving[1];
  const bool another = moving.size() == 1 && moving[0] != axes.right && moving[0] != axes.up;
  axes.over_time = another || catalog.axes.size() < 2;
  if (axes.over_time) axes.right = axes.up = moving.empty() ? AxisId{0} : moving[0];
  return axes;
}

}  // namespace

void BlockTrial::forget() {
  times_.clear(), total_.clear(), assumed_.clear(), stops_.clear();
  path_ = nullptr;
  without_.clear();
  ends_ = goes_on_ = false;
}

void BlockTrial::follow(Frame& f, const std::shared_ptr<const WrittenBlocks>& written) {
  Desk& desk = f.tab.desk();
  if (!tried_) shown_ = axes_of(Rehearsal(), f.catalog);
  rehearsals_.follow(f.now, f.bench, f.catalog, [&desk](int slot) {
    const HeldProgram& held = desk.programs.texts.held(slot);
    return held.known ? &held.text : nullptr;
  });
  const Rehearsals::Outcome* done = outcome();
  if (done && done->number != taken_) {
    taken_ = done->number;
    if (done->text == tried_->text.text) {
      take(f, *done);
      if (!at_length_ && done->result && out_of_time(*done->result, brief.for_s) && written == tried_)
        return start(f, true);
    }
  }
  if (rehearsals_.under_way(program_) || reads_what_it_reached(f, done)) return;
  if (again_ && reads_set_up(f)) return;
  reading_ = 0;
  const bool again = std::exchange(again_, false);
  // The blocks are the first program of their text.
  const int program = f.catalog.program.threads > 0 ? 0 : desk.programs.texts.chosen();
  if (written == tried_ && program == program_ && !again) return;
  const bool same = tried_ && !written->text.text.empty() && written->text.text == tried_->text.text;
  tried_ = written;
  if (same && program == program_ && !again) {  // the same text from different blocks
    if (!done || done->text != tried_->text.text) return;
    take(f, *done);
    if (!at_length_ && done->result && out_of_time(*done->result, brief.for_s)) start(f, true);
    return;
  }
  program_ = program, may_read_ = again;
  if (written->text.text.empty()) return forget();
  start(f, false);
}

void BlockTrial::again() {
  again_ = may_read_ = true;
  reads_reached_ = false;
  unread_.begin();
}

bool BlockTrial::can_read(const Frame& f) const {
  return f.now.link.connected() && !f.tab.desk().programs.job.busy() && !is_under_way(f.now.program);
}

/// Reads the set-up, as Simulate does. A value that cannot be read is named as an assumption.
bool BlockTrial::reads_set_up(Frame& f) {
  if (!can_read(f) || !f.tab.desk().programs.requests.can_read_more(f.now)) return false;
  return awaits_set_up(reading_, f.now, [&f](IntentBody body) { return f.send(std::move(body)); });
}

/// Reads the programs and variables that the rehearsal reached, then calls again().
bool BlockTrial::reads_what_it_reached(Frame& f, const Rehearsals::Outcome* done) {
  if (!may_read_ || again_) return false;
  if (!reads_reached_)
    reads_reached_ = done && can_read(f) && reached_unread(unread_, *done, f.now, f.catalog);
  if (!reads_reached_) return false;
  if (can_read(f) &&
      !unread_.have_been_read(f.now, [&f](IntentBody body) { return f.send(std::move(body)); }))
    return true;
  reads_reached_ = false;
  again_ = true;
  return false;
}

void BlockTrial::start(Frame& f, bool at_length) {
  at_length_ = at_length;
  const Length& length = at_length ? as_simulated : brief;
  RehearseOptions request;
  request.slot = program_;
  request.track_every_s = length.seen_every_s;
  request.for_seconds = length.for_s;
  Desk& desk = f.tab.desk();
  rehearsals_.start(*desk.programs.language(), tried_->text.text, request,
                    known_state(desk.programs.texts, f.now), f.bench, f.catalog, desk.work.worker());
  f.ui.wake_in(0);
}

Rehearsed BlockTrial::rehearsed(const Frame& f) const {
  if (!tried_ || tried_->text.text.empty()) return {};
  if (rehearsals_.under_way(program_) || again_ || reads_reached_) return {false, "Rehearsing."};
  if (goes_on_ && outcome() && outcome()->text == tried_->text.text)
    return {false, "It takes longer than the hour that was rehearsed."};
  return panels::rehearsed(f, outcome(), tried_->text.text);
}

bool BlockTrial::is_old() const {
  const Rehearsals::Outcome* done = outcome();
  if (!done || !done->result || rehearsals_.under_way(program_)) return false;
  const StartMatch match = done->start.match;
  return match != StartMatch::here && match != StartMatch::unknown && match != StartMatch::doubtful;
}

/// "without 3 and 5.1": the blocks left out, by their numbers in the list.
static std::string without_words(const WrittenBlocks& written) {
  constexpr std::size_t most = 3;
  std::string all;
  std::size_t named = 0;
  for (const RefusedStep& r : written.refused) {
    if (r.step < 0) continue;
    if (++named > most) continue;
    const std::size_t begin = r.what.find(' ') + 1, end = r.what.find(" (");
    all += fmt::format(
        "{}{}", all.empty() ? "without " : ", ",
        r.what.starts_with("Step ") ? r.what.substr(begin, end - begin) : std::to_string(r.step + 1));
  }
  if (named > most) all += fmt::format(" and {} more", named - most);
  return all;
}

void BlockTrial::take(Frame& f, const Rehearsals::Outcome& outcome) {
  forget();
  if (!outcome.result) return;
  const Rehearsal& r = *outcome.result;
  const std::vector<int>& steps = tried_->step_of_command;
  BlockTimes times = block_times(f.tab.desk().blocks.editor.sequence().steps, r, steps);
  times_ = std::move(times.of_step);
  ends_ = r.finished;
  goes_on_ = times.goes_on;
  total_ = r.finished ? std::string(format_duration(r.duration_s).view())
           : goes_on_ ? fmt::format("at least {}", format_duration(times.at_least_s).view())
           : out_of_time(r, brief.for_s)
               ? fmt::format("Rehearsed for {}. {}", format_duration(r.duration_s).view(), r.error)
               : r.error;
  without_ = without_words(*tried_);
  stops_ = stop_words(r);
  assumed_ = assumption_words(r);
  take_path(f, r);
}

void BlockTrial::take_path(const Frame& f, const Rehearsal& r) {
  const PathAxes before = std::exchange(shown_, axes_of(r, f.catalog));
  if (before != shown_) canvas_.fit();
  const auto axis = [&f](AxisId id) {
    return TrackAxes::Axis{id.index, from_steps(Steps(1), f.tab.settings.unit(id))};
  };
  TrackAxes axes;
  axes.right = axis(shown_.right), axes.up = axis(shown_.up), axes.over_time = shown_.over_time;
  take_tool_of(f.tab.desk().blocks.editor.sequence(), f.catalog, axes);
  auto path = std::make_shared<const drawing::ToolPath>(track_path(r, axes, 0, tried_->step_of_command));
  const bool any_moves =
      std::any_of(r.axes.begin(), r.axes.end(), [](const RehearsedAxis& a) { return a.travel > 0; });
  if (any_moves && !path->runs.empty()) path_ = std::move(path);
}

std::string_view BlockTrial::time_of(std::size_t step) const {
  return step < times_.size() ? std::string_view(times_[step]) : std::string_view();
}

void BlockTrial::draw_path(Frame& f, int lit_step, float width, float height) {
  PathSubject subject;
  subject.path = path_;
  subject.none = "Nothing moves yet.";
  subject.axes = shown_;
  subject.lit = lit_step;
  canvas_.draw(f, "blocks/path", subject, width, height);
}

int BlockTrial::clicked_step() const {
  const auto& hit = canvas_.clicked();
  return hit && path_ ? path_->runs[hit->run].source : -1;
}

}  // namespace hw::panels
