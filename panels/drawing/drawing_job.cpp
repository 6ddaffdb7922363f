#include "panels/drawing/drawing_job.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include <fmt/format.h>

#include "core/base/index.h"
#include "core/device/pieces_together.h"
#include "core/device/step_times.h"
#include "core/device/track_path.h"
#include "core/drawing/sequence_path.h"
#include "core/sequence/steps_in.h"
#include "core/session/rehearse_together.h"
#include "core/session/way_together.h"
#include "gui/model/tab.h"
#include "gui/model/units_format.h"
#include "gui/shell/console.h"
#include "gui/surface/ui.h"
#include "panels/drawing/drawn_together.h"

namespace hw::panels {

using namespace gui;
namespace {

constexpr double tried_for = 24 * 3600;

/// The chain that each step is of, a step as SequenceText counts them; -1: it stands before all.
std::vector<int> chains_of_steps(const Conversion& made) {
  std::vector<int> chains;
  int chain = -1;
  for (std::size_t i = 0; i < made.sequence.steps.size(); ++i) {
    while (ix(chain + 1) < made.begins.size() && made.begins[ix(chain + 1)] <= i) ++chain;
    const sequence::Step& step = made.sequence.steps[i];
    const sequence::StepList* inner = steps_in(step);
    chains.insert(chains.end(), 1 + ix(inner ? count_steps(*inner) : 0), chain);
  }
  return chains;
}

/// How far its chords lie beside its arcs, where they go through a controller's buffer; else 0.
double chord_of(const sequence::Sequence& sequence, const Parts& parts) {
  constexpr double half_a_step = 0.5;
  const bool streams = !parts.empty() && std::any_of(parts.front()->all.begin(), parts.front()->all.end(),
                                                     [](const Piece& piece) { return piece.draws >= 0; });
  return streams ? std::max(half_a_step / sequence.axes[0].per_unit, sequence.tolerance) : 0;
}

/// The path as the machine goes it; each run with its chain.
std::shared_ptr<const drawing::ToolPath> path_of(const Conversion& made, const Parts& parts,
                                                 drawing::Point scale) {
  drawing::ToolPath path = sequence_path(made.sequence, scale, chord_of(made.sequence, parts));
  for (drawing::ToolPath::Run& run : path.runs) {
    const auto next = std::upper_bound(made.begins.begin(), made.begins.end(),
                                       static_cast<std::size_t>(std::max(run.source, 0)));
    run.source = static_cast<int>(next - made.begins.begin()) - 1;
  }
  return std::make_shared<const drawing::ToolPath>(std::move(path));
}

/// By chain, with the way to it. Empty: it goes at the controller's own speeds.
std::vector<double> without_ramps(const Conversion& made, const ConversionOptions& options) {
  std::vector<double> all;
  if (!(options.cutting.high > 0) || !(options.travel.high > 0)) return all;
  drawing::Point at;
  for (const drawing::Chain& chain : made.chains) {
    double drawn = 0;
    for (const drawing::Curve& curve : chain.curves) drawn += curve.length();
    const double way = std::hypot(chain.begin().x - at.x, chain.begin().y - at.y);
    all.push_back(drawn / options.cutting.high + way / options.travel.high);
    at = chain.end();
  }
  return all;
}

/// The text of a controller that draws by itself, and how long it takes.
Result<> write(DrawingJob::Made& made, const Catalog& catalog, const Language& language) {
  auto written = language.write(made.conversion.sequence, catalog);
  if (!written) return fail(written.error());
  auto frame = language.write(made.conversion.frame, catalog);
  if (!frame) return fail(frame.error());
  made.written = std::move(*written), made.frame = std::move(frame->text);
  const ProgramReport report = language.analyse(made.written.text, 0);
  for (const Problem& p : report.problems)
    if (p.error && made.problem.empty()) made.problem = p.sentence;
  if (!made.problem.empty()) return {};
  RehearseOptions rehearse;
  rehearse.device = catalog.made_from;
  rehearse.for_seconds = tried_for;
  const auto done = language.rehearse(made.written.text, rehearse);
  if (!done || !done->finished) return {};
  made.duration_s = done->duration_s;
  const std::vector<int> chain_of_step = chains_of_steps(made.conversion);
  std::vector<int> parts = lines_of_commands(report, 0);
  for (int& part : parts) {
    const int step =
        part >= 0 && ix(part) < made.written.step_of_line.size() ? made.written.step_of_line[ix(part)] : -1;
    part = step >= 0 && ix(step) < chain_of_step.size() ? chain_of_step[ix(step)] : -1;
  }
  made.chain_seconds = seconds_of_parts(*done, parts);
  return {};
}

Result<> say_tool(DrawingJob::Made& made, const Catalog& catalog) {
  auto tool = said_of_tool(made.conversion.sequence, catalog);
  if (!tool) return fail(tool.error());
  made.written.tool = std::move(*tool);
  return {};
}

/// What was not rehearsed stays as it is meant.
void take_way(DrawingJob::Made& made, WayTogether&& way) {
  const drawing::ToolPath& meant = *made.meant;
  const int last = way.path.runs.empty() ? -1 : way.path.runs.back().source;
  for (const drawing::ToolPath::Run& run : meant.runs)
    for (std::size_t i = run.first + 1; run.source > last && i < run.first + run.size; ++i)
      way.path.go(meant.points[i - 1], meant.points[i], run.tool_on, run.source);
  made.beside = way.beside;
  made.path = std::make_shared<const drawing::ToolPath>(std::move(way.path));
}

void time_by_ramps(DrawingJob::Made& made, const Catalog& catalog) {
  std::vector<Pieces> parts;
  for (const auto& part : made.parts) parts.push_back(*part);
  std::vector<double> seconds = least_seconds(parts, catalog);
  if (seconds.size() != made.conversion.chains.size()) return;
  made.at_least_s = std::accumulate(seconds.begin(), seconds.end(), 0.0);
  made.chain_seconds = std::move(seconds);
}

/// Of controllers that draw together, in mm; a piece is a chain.
void take_rehearsal(DrawingJob::Made& made, const Catalog& catalog, const Console::Together& rehearse) {
  made.path = made.meant = path_of(made.conversion, made.parts, {1, 1});
  made.written.remarks.push_back(made.parts.front()->remark);
  auto done = rehearse ? rehearse(made.conversion.sequence) : RehearsedTogether();
  if (!done)
    made.written.remarks.insert(
        made.written.remarks.begin(),
        "Its lines are drawn straight, as it was not rehearsed to its end: " + done.error().sentence());
  if (!done || !done->finished) time_by_ramps(made, catalog);
  if (!done || done->track.empty()) return;
  take_way(made, way_together(made.conversion, *done, catalog));
  if (done->finished) {
    made.duration_s = done->duration_s;
    made.chain_seconds = std::move(done->piece_seconds);
  } else {
    for (std::size_t c = 0; c < std::min(made.chain_seconds.size(), done->piece_seconds.size()); ++c)
      made.chain_seconds[c] = done->piece_seconds[c];
    made.written.remarks.insert(
        made.written.remarks.begin(),
        fmt::format("The first {} of it were rehearsed. Behind that lines are drawn straight.",
                    format_duration(done->duration_s).view()));
  }
  made.together = std::make_shared<const Rehearsal>(std::move(*done));
}

/// Of one controller that does it in pieces. What is behind the rehearsed time takes as much longer than
/// its length says as what came before.
void time_pieces(DrawingJob::Made& made, const Console::InPieces& rehearse) {
  std::vector<double>& chains = made.chain_seconds;  // by their lengths, so far
  if (!rehearse) return;
  const auto done = rehearse(made.parts.front());
  if (!done) {
    made.written.remarks.insert(made.written.remarks.begin(),
                                "It was not rehearsed to its end: " + done.error().sentence());
    return;
  }
  const std::vector<std::size_t>& begins = made.conversion.begins;
  if (done->finished) made.duration_s = done->duration_s;
  if (!done->told.empty()) made.written.remarks.insert(made.written.remarks.begin(), done->told);
  chains.resize(begins.size());
  const int last_step = done->came_to.empty() ? -1 : done->came_to.back().step;
  double before = 0, of_length = 0;
  for (std::size_t c = 0; c < begins.size(); ++c) {
    const bool last = c + 1 == begins.size();
    if (!done->finished && (last || static_cast<int>(begins[c + 1]) > last_step)) {
      const double stretch = of_length > 0 ? std::max(before / of_length, 1.0) : 1.0;
      for (; c < chains.size(); ++c) chains[c] *= stretch;
      return;
    }
    const double behind = last ? done->duration_s : done->when(static_cast<int>(begins[c + 1]));
    of_length += chains[c];
    chains[c] = behind - std::exchange(before, behind);
  }
}

/// How a worker rehearses what is done in pieces; null: it cannot.
struct Rehearsing {
  Console::Together together;
  Console::InPieces alone;
};

/// All that a drawing becomes. Long.
Result<DrawingJob::Made> make(const drawing::Drawing& drawing, const Catalog& catalog,
                              const Language* language, const Rehearsing& rehearsing,
                              const ConversionOptions& options, drawing::Point scale,
                              std::atomic<float>& ordered) {
  auto converted = convert(drawing, catalog, options, [&](double done) {
    ordered = static_cast<float>(done);
    return true;
  });
  ordered = 1;
  if (!converted) return fail(converted.error());
  DrawingJob::Made made;
  std::vector<double> least = without_ramps(*converted, options);
  if (!least.empty()) made.at_least_s = std::accumulate(least.begin(), least.end(), 0.0);
  made.conversion = std::move(*converted);
  if (language)
    if (auto text = write(made, catalog, *language); !text) return fail(text.error());
  if (auto parts = parts_of(made.conversion.sequence, catalog, language, 0))
    made.parts = std::move(*parts);
  else
    made.no_pieces = parts.error().sentence();
  if (!language && !made.parts.empty()) {
    if (auto said = say_tool(made, catalog); !said) return fail(said.error());
    take_rehearsal(made, catalog, rehearsing.together);
  } else if (made.chain_seconds.empty() && !made.parts.empty()) {
    made.chain_seconds = std::move(least);
    time_pieces(made, rehearsing.alone);
  }
  if (!made.path) made.path = path_of(made.conversion, made.parts, scale);
  return made;
}

}  // namespace

Result<Parts> parts_of(const sequence::Sequence& sequence, const Catalog& catalog, const Language* language,
                       int from_step) {
  Parts parts;
  if (language) {
    auto pieces = language->in_pieces(sequence, catalog, from_step);
    if (!pieces) return fail(pieces.error());
    parts.push_back(std::make_shared<const Pieces>(std::move(*pieces)));
    return parts;
  }
  auto together = pieces_together(sequence, catalog, from_step);
  if (!together) return fail(together.error());
  for (Pieces& pieces : *together) parts.push_back(std::make_shared<const Pieces>(std::move(pieces)));
  return parts;
}

std::optional<double> DrawingJob::seconds_left(const Made& made, int step, int percent, double at_it_s) {
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
  return std::max(left * 100 / percent - at_it_s, 0.0);
}

void StepClock::follow(const PiecesState& now, Instant clock) {
  if (now.step != step_ || now.done != done_) at_it_s_ = 0;
  if (now.running && !now.held && now.step == step_ && now.done == done_)
    at_it_s_ += std::max(hw::seconds(clock - seen_at_), 0.0);
  step_ = now.step, done_ = now.done, seen_at_ = clock;
}

void DrawingJob::open(Frame& f, const std::filesystem::path& file, const ConversionOptions& wanted) {
  const bool opening = reading_ && anew_;        // else the one of before is read again, for nobody any more
  if (opening && file == reading_file_) return;  // let fall twice
  if (opening)
    return f.toast(Mood::plain, "Another drawing is being read. Open this one again when it is there.");
  read(f, file, wanted, true);
}

void DrawingJob::read(Frame& f, const std::filesystem::path& file, const ConversionOptions& wanted,
                      bool anew) {
  reading_ = true, anew_ = anew;
  reading_file_ = file;
  read_as_ = as(f, wanted);
  f.tab.desk().worker().run(
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
    if (anew_) read_as_ = flattened_as_;  // the one of before stays, as it is
    return console.toast(Mood::fault, read.error().sentence());
  }
  drawing_ = std::move(*read);
  file_ = reading_file_;
  flattened_as_ = read_as_;
  opened_ += anew_ ? 1 : 0;
  made_.reset(), fault_.clear();
  old_ = true;
  ++version_;
}

std::string_view DrawingJob::busy_with() const {
  if (reading_) return "reading the file";
  if (!converting_) return {};
  return *ordered_ < 1 ? "putting it into order" : "rehearsing it";
}

void DrawingJob::follow(Frame& f, const ConversionOptions& wanted, std::uint64_t version,
                        drawing::Point scale) {
  const Language* language = f.tab.desk().language();
  const bool together = draws_together(f);
  if (busy()) f.ui.wake_in(0.1);  // the bar moves
  if (std::exchange(scale_, scale) != scale) old_ = true;
  // What was flattened otherwise than is wanted now is read again.
  if (drawing_ && !reading_ && as(f, wanted) != read_as_) return read(f, file_, wanted, false);
  if (!drawing_ || !language || converting_ || (wanted_ == version && !old_)) return;
  wanted_ = version;
  old_ = false;
  converting_ = true;
  *ordered_ = 0;
  f.tab.desk().worker().run(
      [drawing = drawing_, catalog = f.catalog, language = together ? nullptr : language,
       rehearsing = together ? Rehearsing{f.console.rehearsal_of(*f.tab.bus), nullptr}
                             : Rehearsing{nullptr, f.console.rehearsal_of(f.tab)},
       wanted, scale,
       ordered = ordered_] { return make(*drawing, catalog, language, rehearsing, wanted, scale, *ordered); },
      [this, bus = together ? f.tab.bus : nullptr](Result<Made> made) {
        converting_ = false;
        ++version_;
        if (old_) return;  // of the drawing before
        made_.reset(), fault_.clear();
        if (made)
          made_ = std::make_shared<const Made>(std::move(*made));
        else
          fault_ = made.error().sentence();
        if (bus) show_on_bus(*bus);
      },
      alive_);
  f.ui.wake_in(0);
}

/// Whoever else draws it: the path of the bus.
void DrawingJob::show_on_bus(Bus& bus) const {
  DrawnTogether& drawn = bus.drawn;
  drawn = {file_.filename().string(), nullptr, nullptr, drawn.number + 1};
  if (!made_ || !made_->together) return;
  drawn.sequence = {made_, &made_->conversion.sequence}, drawn.rehearsal = made_->together;
}

}  // namespace hw::panels
