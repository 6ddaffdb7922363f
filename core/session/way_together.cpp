#include "core/session/way_together.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/base/index.h"
#include "core/device/track_path.h"

namespace hw {
namespace {

using drawing::Point3;
using drawing::ToolPath;

/// Chain and tool state of each step of the sequence.
struct PlaceOnWay {
  int chain = -1;  ///< -1: before all chains
  bool tool_on = false;
};
std::vector<PlaceOnWay> places_on_way(const Conversion& made) {
  std::vector<PlaceOnWay> places(made.sequence.steps.size());
  PlaceOnWay at;
  for (std::size_t i = 0; i < places.size(); ++i) {
    while (ix(at.chain + 1) < made.begins.size() && made.begins[ix(at.chain + 1)] <= i) ++at.chain;
    if (const auto* pen = std::get_if<sequence::Pen>(&made.sequence.steps[i].body)) at.tool_on = pen->down;
    places[i] = at;
  }
  return places;
}

TrackAxes axes_of(const sequence::Sequence& sequence, const Catalog& bus) {
  TrackAxes axes;
  TrackAxes::Axis* const seen[] = {&axes.right, &axes.up};
  for (std::size_t n = 0; n < std::min(std::size(seen), sequence.axes.size()); ++n)
    *seen[n] = {std::max(bus.find_axis(sequence.axes[n].name), 0), 1 / sequence.axes[n].per_unit};
  return axes;
}

/// Each line is a step, from corner to corner.
double beside_its_line(const ToolPath& path, const ToolPath::Run& run) {
  const Point3 a = path.points[run.first], way = path.points[run.first + run.size - 1] - a;
  const double length = drawing::length(way);
  if (!(length > 0)) return 0;
  double furthest = 0;
  for (std::size_t i = run.first; i < run.first + run.size; ++i) {
    const Point3 d = path.points[i] - a;
    furthest = std::max(furthest, std::fabs(d.x * way.y - d.y * way.x) / length);
  }
  return furthest;
}

}  // namespace

WayTogether way_together(const Conversion& made, const Rehearsal& done, const Catalog& bus) {
  const std::vector<PlaceOnWay> places = places_on_way(made);
  std::vector<int> steps(places.size());
  std::iota(steps.begin(), steps.end(), 0);
  const ToolPath by_steps = track_path(done, axes_of(made.sequence, bus), 0, steps);
  WayTogether way;
  for (const ToolPath::Run& run : by_steps.runs) {
    const PlaceOnWay place = run.source >= 0 ? places[ix(run.source)] : PlaceOnWay();
    if (place.tool_on) way.beside = std::max(way.beside, beside_its_line(by_steps, run));
    for (std::size_t i = run.first + 1; i < run.first + run.size; ++i)
      way.path.go(by_steps.points[i - 1], by_steps.points[i], place.tool_on, place.chain);
  }
  return way;
}

double seconds_from(int step, const Rehearsal& done) {
  double t = 0;
  for (const RehearsedEvent& came : done.events)
    if (came.command <= step) t = came.t;
  return std::max(done.duration_s - t, 0.0);
}

}  // namespace hw
