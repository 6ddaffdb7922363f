#include "panels/drawing/drawn_together.h"

#include <cmath>

#include <fmt/format.h>

#include "gui/model/units_format.h"

namespace hw::panels {

using namespace gui;

std::string places_in_words(const Frame& f, const sequence::Sequence& of, const sequence::Places& places) {
  std::string all;
  for (std::size_t a = 0; a < of.axes.size(); ++a) {
    const int axis = f.catalog.find_axis(of.axes[a].name);
    if (!places[a] || axis < 0) continue;
    const Steps steps(std::llround(*places[a] * of.axes[a].per_unit));
    all += fmt::format("{}{} at {}", all.empty() ? "" : ", ", of.axes[a].name,
                       format_with_unit(steps, unit_of_axis(f, axis)).view());
  }
  return all;
}

}  // namespace hw::panels
