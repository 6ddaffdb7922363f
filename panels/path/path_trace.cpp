#include "panels/path/path_trace.h"

#include <chrono>

#include "gui/model/tab.h"

namespace hw::panels {

using namespace gui;

void PathTrace::follow(const Frame& f, const PathAxes& axes) {
  constexpr std::size_t most_points = 200'000;  // then it begins anew with what is remembered
  const PositionTrace& trace = f.tab.desk().trace;
  const auto& places = trace.places();
  std::array<Steps, max_axes> a_step;
  a_step.fill(Steps(1));
  const Of of{trace.begun(), axes, place_of(f.tab, a_step, axes)};
  if (of != of_ || trace.count() - count_ > places.size() || path_.points.size() >= most_points) {
    of_ = of;
    count_ = trace.count() - places.size();
    first_ = places.empty() ? Instant{} : places.front().at;
    path_ = {};
  }
  for (std::size_t i = places.size() - (trace.count() - count_); i < places.size(); ++i)
    if (places[i].goes_on && i > 0)
      path_.go(place_of(f.tab, places[i - 1].position, axes), place_of(f.tab, places[i].position, axes), true,
               static_cast<int>(seconds(places[i].at - first_)));
  count_ = trace.count();
}

Instant PathTrace::when(std::size_t run) const {
  return first_ + std::chrono::seconds(path_.runs[run].source);
}

}  // namespace hw::panels
