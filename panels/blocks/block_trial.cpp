#include "panels/blocks/block_trial.h"

#include <algorithm>

#include <fmt/format.h>

#include "core/base/index.h"
#include "core/device/step_times.h"
#include "core/device/track_path.h"
#include "gui/model/tab.h"
#include "gui/model/units_format.h"

namespace hw::panels {

using namespace gui;
namespace {

constexpr double tried_for_s = 600, block_seen_every_s = 0.02;

}  // namespace

void BlockTrial::forget() {
  times_.clear(), total_.clear();
  path_ = nullptr;
  none_ = "Nothing moves yet.";
  ends_ = false;
}

void BlockTrial::follow(Frame& f, const std::shared_ptr<const WrittenBlocks>& written) {
  const Rehearsals::Outcome* outcome = rehearsals_.of(0);
  if (outcome && outcome->number != taken_) {
    taken_ = outcome->number;
    if (outcome->text == tried_->text.text) take(f, *outcome);
  }
  if (written == tried_ || rehearsals_.under_way(0)) return;
  const bool same = tried_ && written->problem.empty() && written->text.text == tried_->text.text;
  tried_ = written;
  if (same) {  // but not of the same blocks
    if (outcome && outcome->text == tried_->text.text) take(f, *outcome);
    return;
  }
  if (!written->problem.empty() || written->text.text.empty()) return forget();
  RehearseOptions wish;
  wish.track_every_s = block_seen_every_s;
  wish.for_seconds = tried_for_s;
  Desk& desk = f.tab.desk();
  rehearsals_.start(*desk.language(), written->text.text, wish, desk.state_of(f.now), f.bench, f.catalog,
                    desk.worker());
  f.ui.wake_in(0);
}

/// The output that the tool's own routine switches on; -1: none.
static int tool_output_of(const sequence::Sequence& sequence, const Catalog& catalog) {
  for (const sequence::Step& step : sequence.pen_down)
    if (const auto* output = std::get_if<sequence::Output>(&step.body); output && output->on && !step.skipped)
      return catalog.find_output(output->output);
  return -1;
}

void BlockTrial::take(Frame& f, const Rehearsals::Outcome& outcome) {
  forget();
  if (!outcome.result) return;
  const Rehearsal& r = *outcome.result;
  const std::vector<int>& steps = tried_->step_of_command;
  for (const double s : seconds_of_parts(r, steps)) times_.push_back(s > 0 ? fmt::format("{:.1f} s", s) : "");
  ends_ = r.finished;
  total_ = r.finished         ? std::string(format_duration(r.duration_s).view())
           : !r.error.empty() ? r.error
                              : fmt::format("no end within {}", format_duration(r.duration_s).view());
  if (f.catalog.axes.size() < 2) return;
  TrackAxes axes;
  axes.right = {0, from_steps(Steps(1), f.tab.unit(AxisId{0}))};
  axes.up = {1, from_steps(Steps(1), f.tab.unit(AxisId{1}))};
  axes.tool_output = tool_output_of(f.tab.desk().blocks.editor.sequence(), f.catalog);
  auto path = std::make_shared<const drawing::ToolPath>(track_path(r, axes, 0, steps));
  if (!path->runs.empty()) path_ = std::move(path);
  const bool others_move =
      std::any_of(r.axes.begin() + 2, r.axes.end(), [](const RehearsedAxis& a) { return a.travel > 0; });
  if (!path_ && others_move)
    none_ = fmt::format("Only other axes than {} and {} move.", r.axes[0].name, r.axes[1].name);
}

std::string_view BlockTrial::time_of(std::size_t step) const {
  return step < times_.size() ? std::string_view(times_[step]) : std::string_view();
}

void BlockTrial::draw_path(Frame& f, int lit_step, float width, float height) {
  PathSubject subject;
  subject.path = path_;
  subject.none = none_;
  subject.lit = lit_step;
  canvas_.draw(f, "blocks/path", subject, width, height);
}

int BlockTrial::clicked_step() const {
  const auto& hit = canvas_.clicked();
  return hit && path_ ? path_->runs[hit->run].source : -1;
}

}  // namespace hw::panels
