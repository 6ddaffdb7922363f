#include "panels/drawing/drawing_job.h"

#include <algorithm>
#include <utility>

#include "core/base/index.h"
#include "gui/model/tab.h"
#include "gui/shell/console.h"
#include "gui/surface/ui.h"
#include "panels/drawing/drawing_making.h"
#include "panels/drawing/drawn_together.h"

namespace hw::panels {

using namespace gui;
namespace {

using SharedOutline = std::shared_ptr<const Outline>;

/// The outline of a drawing that cannot be made with these options; null: it has no outline either.
SharedOutline outline_in_units(const drawing::Drawing& drawing, const ConversionOptions& options,
                               drawing::Point scale) {
  auto outline = outline_of(drawing, options);
  if (!outline) return nullptr;
  drawing::ToolPath in_units;
  const drawing::ToolPath& path = outline->path;
  const auto put = [&](std::size_t i) {
    return drawing::Point3(path.points[i].x * scale.x, path.points[i].y * scale.y);
  };
  for (const drawing::ToolPath::Run& run : path.runs)
    for (std::size_t i = run.first + 1; i < run.first + run.size; ++i)
      in_units.go(put(i - 1), put(i), true, run.source);
  outline->path = std::move(in_units);
  return std::make_shared<const Outline>(std::move(*outline));
}

}  // namespace

std::optional<double> DrawingJob::seconds_left(const Made& made, int step, int percent,
                                               double time_at_step_s) {
  const std::vector<std::size_t>& begins = made.conversion.begins;
  if (made.chain_seconds.empty() || made.chain_seconds.size() != begins.size() || percent <= 0)
    return std::nullopt;
  const std::size_t at = ix(std::max(step, 0));
  double left = 0;
  for (std::size_t chain = 0; chain < begins.size(); ++chain) {
    const std::size_t end =
        chain + 1 < begins.size() ? begins[chain + 1] : made.conversion.sequence.steps.size();
    if (at >= end) continue;
    const double share =
        at <= begins[chain] ? 1.0 : static_cast<double>(end - at) / static_cast<double>(end - begins[chain]);
    left += share * made.chain_seconds[chain];
  }
  return std::max(left * 100 / percent - time_at_step_s, 0.0);
}

void StepClock::follow(const PiecesState& now, Instant clock, bool at_work) {
  const bool begins = now.running && !running_;
  if (begins || now.step != step_ || now.done != done_)
    time_at_step_s_ = 0;
  else if (now.running && !now.held && at_work)
    time_at_step_s_ += std::max(hw::seconds(clock - seen_at_), 0.0);
  step_ = now.step, done_ = now.done, running_ = now.running, seen_at_ = clock;
}

void DrawingJob::open(Frame& f, const std::filesystem::path& file, const ConversionOptions& wanted) {
  const bool opening = reading_ && anew_;  // otherwise the previous file is read again in the background
  if (opening && file == reading_file_) return;  // the same file was dropped twice
  if (opening) return f.toast(Severity::plain, "Open this drawing again when the other one has been read.");
  read(f, file, wanted, true);
}

void DrawingJob::read(Frame& f, const std::filesystem::path& file, const ConversionOptions& wanted,
                      bool anew) {
  reading_ = true, anew_ = anew;
  reading_file_ = file;
  read_as_ = as(f, wanted);
  f.tab.desk().work.worker().run(
      [file, catalog = f.catalog, wanted]() -> Result<Drawing> {
        return read_drawing(file, catalog, wanted).map([](drawing::Drawing&& d) {
          return std::make_shared<const drawing::Drawing>(std::move(d));
        });
      },
      [this, number = ++reads_, &console = f.console](Result<Drawing> read) {
        if (number == reads_) take(std::move(read), console);
      },
      alive_);
  f.ui.wake_in(0);
}

void DrawingJob::take(Result<Drawing> read, Console& console) {
  reading_ = false;
  if (!read) {
    if (anew_) read_as_ = flattened_as_;  // the previous drawing stays unchanged
    return console.toast(Severity::fault, read.error().sentence());
  }
  drawing_ = std::move(*read);
  file_ = reading_file_;
  flattened_as_ = read_as_;
  opened_ += anew_ ? 1 : 0;
  made_.reset(), outline_.reset(), fault_.clear();
  old_ = true;
  ++version_;
}

std::string_view DrawingJob::busy_with() const {
  if (reading_) return "reading the file";
  if (!converting_) return {};
  return *ordered_ < 1 ? "sorting its lines" : "rehearsing it";
}

void DrawingJob::follow(Frame& f, const ConversionOptions& wanted, std::uint64_t version,
                        drawing::Point scale) {
  const Language* language = f.tab.desk().programs.language();
  const bool together = draws_together(f);
  if (busy()) f.ui.wake_in(0.1);  // for the progress bar
  if (std::exchange(scale_, scale) != scale) old_ = true;
  // Reads the file again if it was flattened with other options.
  if (drawing_ && !reading_ && as(f, wanted) != read_as_) return read(f, file_, wanted, false);
  if (!drawing_ || !language || converting_ || (wanted_ == version && !old_)) return;
  wanted_ = version;
  old_ = false;
  converting_ = true;
  *ordered_ = 0;
  f.tab.desk().work.worker().run(
      [drawing = drawing_, catalog = f.catalog, language = together ? nullptr : language,
       rehearsing = together ? RehearsalCalls{f.console.rehearsal_of(*f.tab.bus), nullptr}
                             : RehearsalCalls{nullptr, f.console.rehearsal_of(f.tab)},
       wanted, scale, ordered = ordered_] {
        auto made = make_all(*drawing, catalog, language, rehearsing, wanted, scale, *ordered);
        auto outline = made ? nullptr : outline_in_units(*drawing, wanted, scale);
        return std::pair(std::move(made), std::move(outline));
      },
      [this, bus = together ? f.tab.bus : nullptr](std::pair<Result<Made>, SharedOutline> done) {
        auto& [made, outline] = done;
        converting_ = false;
        ++version_;
        if (old_) return;  // the result is for the previous drawing
        made_.reset(), fault_.clear();
        outline_ = std::move(outline);
        if (made)
          made_ = std::make_shared<const Made>(std::move(*made));
        else
          fault_ = made.error().sentence();
        if (outline_ && !outline_->unit_is_given) fault_ += " Until then its outline is shown as if in mm.";
        if (bus) show_on_bus(*bus);
      },
      alive_);
  f.ui.wake_in(0);
}

/// Shows the path on the bus, so that all its controllers show it.
void DrawingJob::show_on_bus(Bus& bus) const {
  DrawnTogether& drawn = bus.drawn;
  drawn = {file_.filename().string(), nullptr, nullptr, drawn.number + 1, made_ ? made_->number : 0};
  if (!made_ || !made_->together) return;
  drawn.sequence = {made_, &made_->conversion.sequence}, drawn.rehearsal = made_->together;
}

}  // namespace hw::panels
