#include "gui/model/stop_times.h"

#include <algorithm>
#include <vector>

#include <fmt/core.h>

namespace hw::gui {
namespace {

/// The smallest value that 99 in 100 do not exceed.
template <class Value>
Value percentile_99(std::vector<Value> values) {
  const std::size_t place = (values.size() * 99 + 99) / 100 - 1;
  std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(place), values.end());
  return values[place];
}

double ms(Duration d) { return 1000 * seconds(d); }

}  // namespace

void StopTimes::add(const Ending& ending, const ShowPosition& position) {
  if (!ending.timed || ending.axis < 0) return;
  stops_.push_back(ending);
  if (stops_.size() > most) stops_.pop_front();
  const AxisId axis{static_cast<std::uint8_t>(ending.axis)};
  words_ = fmt::format("Last stop: first byte after {:.1f} ms, ", ms(ending.to_wire));
  if (ending.to_slowing)
    words_ += fmt::format("slowing down seen after {:.0f} ms, ", ms(*ending.to_slowing));
  else
    words_ += "slowing down not seen, ";
  words_ += fmt::format("at rest after {:.0f} ms, {} on.", ms(ending.to_rest), position(axis, ending.ran_on));
  if (stops_.size() > 1) words_ += of_all(axis, position);
  tip_ = fmt::format("{} {}", twice, words_);
}

std::string StopTimes::of_all(AxisId axis, const ShowPosition& position) const {
  std::vector<Duration> bytes, slowings, rests;
  std::vector<Steps> on;  // of this axis only: others may count in another unit
  for (const Ending& stop : stops_) {
    bytes.push_back(stop.to_wire);
    if (stop.to_slowing) slowings.push_back(*stop.to_slowing);
    rests.push_back(stop.to_rest);
    if (stop.axis == axis.index) on.push_back(stop.ran_on);
  }
  const std::string of_some =
      slowings.size() < stops_.size() ? fmt::format(" (in {} of them)", slowings.size()) : "";
  const std::string slowing = slowings.empty() ? std::string()
                                               : fmt::format(", slowing down was seen within {:.0f} ms{}",
                                                             ms(percentile_99(slowings)), of_some);
  return fmt::format(
      " In 99 of 100 of the last {} stops the first byte went out within {:.1f} ms{} and the axis was at "
      "rest "
      "within {:.0f} ms and {}.",
      stops_.size(), ms(percentile_99(std::move(bytes))), slowing, ms(percentile_99(std::move(rests))),
      position(axis, percentile_99(std::move(on))));
}

}  // namespace hw::gui
