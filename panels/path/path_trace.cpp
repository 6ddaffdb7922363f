#include "panels/path/path_trace.h"

#include <algorithm>
#include <chrono>

#include "gui/model/tab.h"
#include "gui/surface/ui.h"

namespace hw::panels {

using namespace gui;
using drawing::Point3;

// ---- age

TraceAges ages_of(const drawing::ToolPath& trace) {
  TraceAges ages;
  if (trace.runs.empty()) return ages;
  const int newest = trace.runs.back().source;
  for (std::size_t age = 1; age < TraceAges::count; ++age) {
    const int oldest = newest - TraceAges::seconds[age - 1];
    const auto begin = std::partition_point(trace.runs.begin(), trace.runs.end(),
                                            [oldest](const auto& run) { return run.source < oldest; });
    ages.begin[age] = static_cast<std::size_t>(begin - trace.runs.begin());
  }
  return ages;
}

ImU32 trace_colour(const Ui& ui, std::size_t age) {
  constexpr std::array<unsigned, TraceAges::count> of_motion{64, 112, 176,
                                                             256};  // of 256; the rest is edge colour
  ImU32 out = IM_COL32_A_MASK;
  for (const int shift : {IM_COL32_R_SHIFT, IM_COL32_G_SHIFT, IM_COL32_B_SHIFT}) {
    const unsigned motion = ui[Tone::motion] >> shift & 255u, edge = ui[Tone::edge] >> shift & 255u;
    out |= (motion * of_motion[age] + edge * (256 - of_motion[age])) / 256 << shift;
  }
  return out;
}

float trace_width(const Ui& ui, std::size_t age) {
  return (age + 1 == TraceAges::count ? 2.0f : 1.0f) * ui.hair();
}

// ---- the trace

namespace {

using Place = PositionTrace::Place;

PositionTrace& trace_of(Tab& tab) { return tab.desk().records.trace; }

/// The nth recorded place, from 1; null: dropped, or not recorded yet.
const Place* nth(Tab& tab, std::uint64_t n) {
  const auto& trace = trace_of(tab);
  const std::uint64_t gone = trace.count() - trace.places().size();
  return n > gone && n <= trace.count() ? &trace.places()[static_cast<std::size_t>(n - gone - 1)] : nullptr;
}

double share_of_way(Instant from, Instant to, Instant at) {
  return to > from ? std::clamp(seconds(at - from) / seconds(to - from), 0.0, 1.0) : 1;
}

}  // namespace

void PathTrace::begin(const Directions& all) {
  path_ = {};
  source_count_ = 0;
  first_ = Instant::max();
  for (const Direction& d : all) {
    const auto known = [&d](const Source& s) { return s.tab == d.tab; };
    if (!d.tab || std::any_of(sources_.begin(), sources_.begin() + source_count_, known)) continue;
    const PositionTrace& trace = trace_of(*d.tab);
    sources_[source_count_++] = {d.tab, trace.count() - trace.places().size()};
    if (!trace.places().empty()) first_ = std::min(first_, trace.places().front().at);
  }
  if (first_ == Instant::max()) first_ = {};
}

/// Whether the next place was already dropped.
bool PathTrace::is_lost() const {
  return std::any_of(sources_.begin(), sources_.begin() + source_count_, [](const Source& s) {
    const PositionTrace& trace = trace_of(*s.tab);
    return trace.count() - s.taken > trace.places().size();
  });
}

/// The source with the earliest next place, if the positions of all other sources at that time are known;
/// null: none.
PathTrace::Source* PathTrace::soonest() {
  Source* soonest = nullptr;
  Instant at = Instant::max(), known = Instant::max();
  for (std::size_t i = 0; i < source_count_; ++i) {
    Source& s = sources_[i];
    const Place* next = nth(*s.tab, s.taken + 1);
    if (next && next->at < at) soonest = &s, at = next->at;
    known = std::min(known, next ? next->at : s.tab->now().at);
  }
  return soonest && (source_count_ == 1 || at <= known) ? soonest : nullptr;
}

/// The point at that time; nullopt: not all axes were recorded so early.
std::optional<Point3> PathTrace::point(const Directions& all, Instant at) const {
  Point3 p;
  for (std::size_t n = 0; n < all.count; ++n) {
    const Direction& d = all.all[n];
    if (!d.tab) {
      along(p, n) = seconds(at - of_.zero);
      continue;
    }
    const auto source = std::find_if(sources_.begin(), sources_.begin() + source_count_,
                                     [&d](const Source& s) { return s.tab == d.tab; });
    const Place *here = nth(*d.tab, source->taken), *next = nth(*d.tab, source->taken + 1);
    if (!here || (at > here->until && !(next && next->goes_on))) return std::nullopt;
    along(p, n) = d.place(here->position);
    if (at > here->until)
      along(p, n) += (d.place(next->position) - along(p, n)) * share_of_way(here->until, next->at, at);
  }
  return p;
}

void PathTrace::add(const std::optional<Point3>& from, const std::optional<Point3>& to, Instant at) {
  if (from && to && *from != *to) path_.go(*from, *to, true, static_cast<int>(seconds(at - first_)));
}

/// The end of a rest is a point of its own, for a view over time and for another axis that moved meanwhile.
void PathTrace::take_next(const Directions& all, Source& s) {
  const Place *here = nth(*s.tab, s.taken), *next = nth(*s.tab, s.taken + 1);
  Instant from = Instant::min();  // all sources were followed up to this time
  for (std::size_t i = 0; i < source_count_; ++i)
    if (const Place* p = nth(*sources_[i].tab, sources_[i].taken)) from = std::max(from, p->at);
  auto begin = from >= of_.zero ? point(all, from) : std::nullopt;
  if (here && here->until > from) {
    const auto rested = point(all, here->until);
    if (next->goes_on) add(begin, rested, here->until);
    begin = here->until >= of_.zero ? rested : std::nullopt;
  }
  ++s.taken;
  if (here && next->goes_on) add(begin, point(all, next->at), next->at);
}

void PathTrace::follow(const Frame& f, const PathAxes& axes) {
  constexpr std::size_t most_points = 200'000;  // then the trace restarts from the places kept
  const Directions all = directions_of(f, axes);
  Key of{axes, {}, {}, {}};
  for (std::size_t n = 0; n < all.count; ++n) {
    const Direction& d = all.all[n];
    if (!d.tab) of.zero = zero_of_time(*all.all[1].tab);
    if (d.tab) of.begun[n] = trace_of(*d.tab).begun(), of.scale[n] = from_steps(Steps(1), d.unit());
  }
  if (of != of_ || is_lost() || path_.points.size() >= most_points) {
    of_ = of;
    begin(all);
  }
  while (Source* s = soonest()) take_next(all, *s);
}

Instant PathTrace::when(std::size_t run) const {
  return first_ + std::chrono::seconds(path_.runs[run].source);
}

}  // namespace hw::panels
