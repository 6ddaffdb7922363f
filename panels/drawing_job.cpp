#include "panels/drawing_job.h"

#include <algorithm>
#include <utility>

#include "core/drawing/sequence_path.h"
#include "gui/console.h"
#include "gui/tab.h"
#include "gui/units_format.h"

namespace hw::panels {

using namespace gui;
namespace {

constexpr double tried_for = 24 * 3600;

/// All that a drawing becomes. Long.
Result<DrawingJob::Made> make(const drawing::Drawing& drawing, const Catalog& catalog,
                              const Language& language, const ConversionOptions& options,
                              drawing::Point scale) {
  auto converted = convert(drawing, catalog, options);
  if (!converted) return fail(converted.error());
  auto written = language.write(converted->sequence, catalog);
  if (!written) return fail(written.error());
  auto frame = language.write(converted->frame, catalog);
  if (!frame) return fail(frame.error());
  DrawingJob::Made made;
  made.conversion = std::move(*converted), made.written = std::move(*written);
  made.frame = std::move(frame->text);
  if (auto pieces = language.in_pieces(made.conversion.sequence, catalog))
    made.pieces = std::make_shared<const Pieces>(std::move(*pieces));
  else
    made.no_pieces = pieces.error().sentence();
  made.path = std::make_shared<const drawing::ToolPath>(sequence_path(made.conversion.sequence, scale));
  for (const Problem& p : language.analyse(made.written.text, 0).problems)
    if (p.error && made.problem.empty()) made.problem = p.sentence;
  if (!made.problem.empty()) return made;
  RehearseOptions rehearse;
  rehearse.device = catalog.made_from;
  rehearse.for_seconds = tried_for;
  if (const auto done = language.rehearse(made.written.text, rehearse); done && done->finished)
    made.duration_s = done->duration_s;
  return made;
}

}  // namespace

void DrawingJob::open(Frame& f, const std::filesystem::path& file, const ConversionOptions& wanted) {
  if (reading_)
    return f.toast(Mood::plain, "Another drawing is being read. Open this one again when it is there.");
  reading_ = true;
  read_chord_ = finest_chord(wanted);
  f.tab.desk().worker().run(
      [file, wanted]() -> Result<Drawing> {
        return read_drawing(file, wanted).map([](drawing::Drawing&& d) {
          return std::make_shared<const drawing::Drawing>(std::move(d));
        });
      },
      [this, file, &console = f.console](Result<Drawing> read) { take(std::move(read), file, console); },
      alive_);
  f.ui.wake_in(0);
}

void DrawingJob::take(Result<Drawing> read, const std::filesystem::path& file, Console& console) {
  reading_ = false;
  if (!read) return console.toast(Mood::fault, read.error().sentence());
  drawing_ = std::move(*read);
  file_ = file;
  made_.reset(), fault_.clear();
  old_ = true;
  ++version_;
}

void DrawingJob::follow(Frame& f, const ConversionOptions& wanted, std::uint64_t version) {
  const Language* language = f.tab.desk().language();
  const auto units = [&](std::size_t axis) {
    const double steps = axis < wanted.axes.size() ? wanted.axes[axis].per_unit : 1;
    const int place = axis < wanted.axes.size() ? f.catalog.find_axis(wanted.axes[axis].name) : -1;
    return steps * from_steps(Steps(1), f.tab.unit(AxisId{static_cast<std::uint8_t>(std::max(0, place))}));
  };
  const drawing::Point scale{units(0), units(1)};
  if (std::exchange(scale_, scale) != scale) old_ = true;
  // What was flattened more coarsely than is wanted now is read again.
  if (drawing_ && !reading_ && finest_chord(wanted) < read_chord_) return open(f, file_, wanted);
  if (!drawing_ || !language || converting_ || (wanted_ == version && !old_)) return;
  wanted_ = version;
  old_ = false;
  converting_ = true;
  f.tab.desk().worker().run([drawing = drawing_, catalog = f.catalog, language, wanted,
                             scale] { return make(*drawing, catalog, *language, wanted, scale); },
                            [this](Result<Made> made) {
                              converting_ = false;
                              ++version_;
                              if (old_) return;  // of the drawing before
                              made_.reset(), fault_.clear();
                              if (made)
                                made_ = std::make_shared<const Made>(std::move(*made));
                              else
                                fault_ = made.error().sentence();
                            },
                            alive_);
  f.ui.wake_in(0);
}

}  // namespace hw::panels
