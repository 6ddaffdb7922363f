#include "panels/drawing/drawing_making.h"

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
#include "panels/drawing/drawn_together.h"

namespace hw::panels {

using namespace gui;
namespace {

constexpr double tried_for = 24 * 3600;

/// The chain of each step, as SequenceText counts steps; -1: before all chains.
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

/// The largest distance between chords and arcs, if the arcs go through a controller's buffer; else 0.
double chord_of(const sequence::Sequence& sequence, const Parts& parts) {
  constexpr double half_a_step = 0.5;
  const bool streams = !parts.empty() && std::any_of(parts.front()->all.begin(), parts.front()->all.end(),
                                                     [](const Piece& piece) { return piece.draws >= 0; });
  return streams ? std::max(half_a_step / sequence.axes[0].per_unit, sequence.tolerance) : 0;
}

/// The path as the machine runs it. The source of each run is its chain.
std::shared_ptr<const drawing::ToolPath> tool_path_of(const Conversion& made, const Parts& parts,
                                                      drawing::Point scale) {
  drawing::ToolPath path = sequence_path(made.sequence, scale, chord_of(made.sequence, parts));
  for (drawing::ToolPath::Run& run : path.runs) {
    const auto next = std::upper_bound(made.begins.begin(), made.begins.end(),
                                       static_cast<std::size_t>(std::max(run.source, 0)));
    run.source = static_cast<int>(next - made.begins.begin()) - 1;
  }
  return std::make_shared<const drawing::ToolPath>(std::move(path));
}

double length_of_chain(const drawing::Chain& chain) {
  double length = 0;
  for (const drawing::Curve& curve : chain.curves) length += curve.length();
  return length;
}

/// Durations by chain, with the travel to it. Empty: no speeds are set, so the controller's own speeds apply.
std::vector<double> without_ramps(const Conversion& made, const ConversionOptions& options) {
  std::vector<double> all;
  if (!(options.cutting.high > 0) || !(options.travel.high > 0)) return all;
  drawing::Point at;
  for (const drawing::Chain& chain : made.chains) {
    const double drawn = length_of_chain(chain);
    const double way = std::hypot(chain.begin().x - at.x, chain.begin().y - at.y);
    all.push_back(drawn / options.cutting.high + way / options.travel.high);
    at = chain.end();
  }
  return all;
}

/// Writes the text of a controller that draws by itself, and rehearses its duration.
Result<> write(DrawingJob::Made& made, const Catalog& catalog, const Language& language) {
  auto written = language.write(made.conversion.sequence, catalog);
  if (!written) return fail(written.error());
  made.written = std::move(*written);
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

Result<> note_tool(DrawingJob::Made& made, const Catalog& catalog) {
  auto tool = tool_remark(made.conversion.sequence, catalog);
  if (!tool) return fail(tool.error());
  made.written.tool = std::move(*tool);
  return {};
}

/// Durations by chain. A piece may draw several chains, because dots are drawn with the chain that follows.
std::vector<double> by_chain(const std::vector<double>& seconds, const DrawingJob::Made& made) {
  const Conversion& c = made.conversion;
  const auto& pieces = made.parts.front()->all;
  const auto chain_at = [&](std::size_t piece) {
    if (piece >= pieces.size()) return c.begins.size();
    const auto step = static_cast<std::size_t>(std::max(pieces[piece].first_step, 0));
    const auto next = std::upper_bound(c.begins.begin(), c.begins.end(), step) - c.begins.begin();
    return static_cast<std::size_t>(std::max<std::ptrdiff_t>(next - 1, 0));
  };
  std::vector<double> all(c.begins.size());
  for (std::size_t p = 0; p < std::min(seconds.size(), pieces.size()); ++p) {
    const std::size_t first = chain_at(p), end = std::max(chain_at(p + 1), first + 1);
    double length = 0;
    for (std::size_t i = first; i < std::min(end, all.size()); ++i) length += length_of_chain(c.chains[i]);
    for (std::size_t i = first; i < std::min(end, all.size()); ++i)
      all[i] += seconds[p] *
                (length > 0 ? length_of_chain(c.chains[i]) / length : 1.0 / static_cast<double>(end - first));
  }
  return all;
}

/// Parts not rehearsed keep their intended path.
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
  const std::vector<double> seconds = least_seconds(parts, catalog);
  if (seconds.empty()) return;
  made.at_least_s = std::accumulate(seconds.begin(), seconds.end(), 0.0);
  made.chain_seconds = by_chain(seconds, made);
}

/// Rehearses controllers that draw together, in mm. A piece is a chain.
void take_rehearsal(DrawingJob::Made& made, const Catalog& catalog, const Console::Together& rehearse) {
  made.path = made.meant = tool_path_of(made.conversion, made.parts, {1, 1});
  made.written.remarks.push_back(made.parts.front()->remark);
  made.with_transfers = true;  // no piece is sent in advance
  auto done = rehearse ? rehearse(made.conversion.sequence) : RehearsedTogether();
  if (!done)
    made.written.remarks.insert(
        made.written.remarks.begin(),
        "Its lines are drawn straight, because it was not rehearsed to its end: " + done.error().sentence());
  if (!done || !done->finished) time_by_ramps(made, catalog);
  if (!done || done->track.empty()) return;
  take_way(made, way_together(made.conversion, *done, catalog));
  if (done->finished) {
    made.duration_s = done->duration_s;
    made.chain_seconds = by_chain(done->piece_seconds, made);
  } else {
    const std::vector<double> rehearsed = by_chain(done->piece_seconds, made);
    for (std::size_t c = 0; c < std::min(made.chain_seconds.size(), rehearsed.size()); ++c)
      if (rehearsed[c] > 0) made.chain_seconds[c] = rehearsed[c];
    made.written.remarks.insert(
        made.written.remarks.begin(),
        fmt::format("The first {} of it were rehearsed. After that, lines are drawn straight.",
                    format_duration(done->duration_s).view()));
  }
  made.together = std::make_shared<const Rehearsal>(std::move(*done));
}

/// Rehearses a controller that draws in pieces. Pieces beyond the rehearsed time are extrapolated from their
/// lengths, in the ratio found before.
void time_pieces(DrawingJob::Made& made, const Console::InPieces& rehearse) {
  std::vector<double>& chains = made.chain_seconds;  // so far from their lengths
  if (!rehearse) return;
  const auto done = rehearse(made.parts.front());
  made.with_transfers = done.has_value();
  if (!done) {
    made.written.remarks.insert(made.written.remarks.begin(),
                                "It was not rehearsed to its end: " + done.error().sentence());
    return;
  }
  const std::vector<std::size_t>& begins = made.conversion.begins;
  if (done->finished) made.duration_s = done->duration_s;
  if (!done->messages.empty()) made.written.remarks.insert(made.written.remarks.begin(), done->messages);
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

}  // namespace

Result<Parts> parts_of(const sequence::Sequence& sequence, const Catalog& catalog, const Language* language,
                       int from_step, std::uint64_t number) {
  Parts parts;
  if (language) {
    auto pieces = language->in_pieces(sequence, catalog, from_step);
    if (!pieces) return fail(pieces.error());
    pieces->drawing = number;
    parts.push_back(std::make_shared<const Pieces>(std::move(*pieces)));
    return parts;
  }
  auto together = pieces_together(sequence, catalog, from_step);
  if (!together) return fail(together.error());
  for (Pieces& pieces : *together) {
    pieces.drawing = number;
    parts.push_back(std::make_shared<const Pieces>(std::move(pieces)));
  }
  return parts;
}

Result<DrawingJob::Made> make_all(const drawing::Drawing& drawing, const Catalog& catalog,
                                  const Language* language, const RehearsalCalls& rehearsing,
                                  const ConversionOptions& options, drawing::Point scale,
                                  std::atomic<float>& ordered) {
  auto converted = convert(drawing, catalog, options, [&](double done) {
    ordered = static_cast<float>(done);
    return true;
  });
  ordered = 1;
  if (!converted) return fail(converted.error());
  static std::atomic<std::uint64_t> number = 0;
  DrawingJob::Made made;
  made.number = ++number;
  std::vector<double> least = without_ramps(*converted, options);
  if (!least.empty()) made.at_least_s = std::accumulate(least.begin(), least.end(), 0.0);
  made.conversion = std::move(*converted);
  if (language)
    if (auto text = write(made, catalog, *language); !text) return fail(text.error());
  if (auto parts = parts_of(made.conversion.sequence, catalog, language, 0, made.number))
    made.parts = std::move(*parts);
  else
    made.no_pieces = parts.error().sentence();
  if (!language && !made.parts.empty()) {
    if (auto done = note_tool(made, catalog); !done) return fail(done.error());
    take_rehearsal(made, catalog, rehearsing.together);
  } else if (made.chain_seconds.empty() && !made.parts.empty()) {
    made.chain_seconds = std::move(least);
    time_pieces(made, rehearsing.alone);
  }
  if (!made.path) made.path = tool_path_of(made.conversion, made.parts, scale);
  return made;
}

}  // namespace hw::panels
