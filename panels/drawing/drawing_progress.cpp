// Draws the progress and speed of a running drawing.
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "gui/model/tab.h"
#include "gui/model/units_format.h"
#include "gui/widgets/message.h"
#include "gui/widgets/slider.h"
#include "gui/widgets/text.h"
#include "panels/drawing/drawing_run.h"
#include "panels/drawing/drawn_together.h"
#include "panels/widget_path.h"

namespace hw::panels {

using namespace gui;
namespace {

/// Whether no piece runs; a piece that waits has been sent.
bool runs_none(const ProgramState& p) { return p.run == RunState::idle || p.run == RunState::error; }

bool was_stopped(const PiecesState& p) { return !p.running && p.step >= 0 && p.done < p.total; }

}  // namespace

void DrawingRun::draw_override(Frame& f) {
  const PiecesState& now = pieces_of(f);
  const bool is_last = !now.draws && !now.held && now.done + 1 >= now.total;
  double percent = now.percent;
  speed_.clear();
  fmt::format_to(std::back_inserter(speed_), "Speed: {:.0f} % of the given speed", percent);
  gap(f.ui, 8);
  wrapped(f.ui, Face::small, Tone::ink2, speed_);
  const SliderOptions o{
      .min = 10,
      .max = 200,
      .step = 10,
      .normal = 100,
      .disabled = is_last ? "The last piece runs at the speeds written in it." : "",
      .tip = now.draws ? "Applies to all moves sent from now on." : "Applies from the next piece on.",
      .value_text = speed_};
  if (slider(f.ui, "drawing/override", "Speed", percent, o))
    send_to_all(f, intent::OverrideSpeed(static_cast<int>(std::lround(percent))));
}

/// The only piece of a controller needs no number.
void DrawingRun::describe_progress(const PiecesState& now, bool is_sent, RunState program) {
  progress_.clear();
  const auto to = std::back_inserter(progress_);
  const Path piece("piece {} of {}", now.done + 1, now.total);
  const std::string_view what = traces_ ? "the frame" : now.total == 1 ? "the drawing" : piece.view();
  if (now.done == now.total)
    fmt::format_to(to, "{}", traces_ ? "The frame has been traced" : "Everything is drawn");
  else if (was_stopped(now))
    fmt::format_to(to, "Stopped in {}", what);
  else if (now.held && program == RunState::running)
    fmt::format_to(to, "{}{} is finished first, then the run is held", traces_ || now.total == 1 ? 'T' : 'P',
                   what.substr(1));
  else if (now.held)
    fmt::format_to(to, "Held {} {}", now.draws || program == RunState::held ? "in" : "before", what);
  else if (is_sent)
    fmt::format_to(to, "The controller is being sent {}", what);
  else if (traces_)
    fmt::format_to(to, "The frame is being traced");
  else if (now.total == 1)
    fmt::format_to(to, "The drawing is being cut");
  else
    fmt::format_to(to, "At {}", what);
}

/// The progress is by time if it is known, because pieces and steps differ in length, and some controllers
/// report no steps.
void DrawingRun::draw_progress(Frame& f) {
  const PiecesState& now = pieces_of(f);
  if (now.total == 0) return;
  const bool by_itself = !draws_together(f) && !now.draws;  // it draws by a stored program
  const bool is_sent = now.running && !now.held && by_itself && runs_none(f.now.program);
  const DrawingJob::Made* made = at_work(f);
  const bool counts = !is_sent || (made && made->with_transfers);
  clock_.follow(now, f.clock, counts);
  // On a bus, another panel may have begun another drawing since.
  traces_ = traces_ && (!draws_together(f) || f.tab.bus->begun.get() == traced_);
  describe_progress(now, is_sent, by_itself && f.now.program.owned ? f.now.program.run : RunState::idle);
  const auto left =
      made ? DrawingJob::seconds_left(*made, now.step, now.percent, clock_.time_at_step_s()) : std::nullopt;
  if (left && now.running)
    fmt::format_to(std::back_inserter(progress_), ", {} left", format_duration(*left).view());
  gap(f.ui, 8);
  meter(f.ui, "drawing/cut_progress", "Progress", static_cast<float>(share_done(now, made, left)),
        {.tone = Tone::motion, .old = !now.running, .words = progress_});
  gap(f.ui, 4);
  constexpr int lines = 2;  // always, so that nothing below moves with the words
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const Rect in{at, ImVec2(at.x + ImGui::GetContentRegionAvail().x, at.y + f.ui.px(16 * lines))};
  draw_text_in_lines(f.ui, in, Face::small, f.ui[Tone::ink2], progress_, lines);
  gap(f.ui, 16 * lines);
}

double DrawingRun::share_done(const PiecesState& now, const DrawingJob::Made* made,
                              std::optional<double> left) {
  if (now.done == now.total) return 1;
  const auto all = made ? DrawingJob::seconds_left(*made, 0, now.percent) : std::nullopt;
  if (left && all && *all > 0) return std::clamp(1 - *left / *all, 0.0, 1.0);
  const auto steps = made ? made->conversion.sequence.steps.size() : 0;
  return steps > 0 && now.step > 0 ? std::min(static_cast<double>(now.step) / static_cast<double>(steps), 1.0)
                                   : static_cast<double>(now.done) / static_cast<double>(now.total);
}

}  // namespace hw::panels
