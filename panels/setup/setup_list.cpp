#include "panels/setup/setup_list.h"

#include <algorithm>

#include <fmt/core.h>

#include "gui/widgets/text.h"

namespace hw::panels {

using namespace gui;
namespace {

constexpr float least_field = 152, chevron_and_edges = 38, most_of_a_row = 0.54f;

/// Adjacent settings of one heading.
struct Adjacent {
  std::size_t first, end;
  int axis;  ///< common to all; -1: of several axes, or of none
};

Adjacent adjacent_to(const Catalog& c, std::size_t first) {
  Adjacent run{first, first, c.params[first].axis};
  for (; run.end < c.params.size() && c.params[run.end].group == c.params[first].group; ++run.end)
    if (c.params[run.end].axis != run.axis) run.axis = -1;
  if (c.axes.size() < 2) run.axis = -1;
  return run;
}

std::string title_of(const Catalog& c, const Adjacent& run) {
  const std::string& group = c.params[run.first].group;
  return run.axis < 0 ? group
                      : fmt::format("{} of {}", group, c.axes[static_cast<std::size_t>(run.axis)].name);
}

}  // namespace

const std::vector<SetupList::Section>& SetupList::sections(const Catalog& c) {
  if (!sections_.empty() || c.params.empty()) return sections_;
  for (std::size_t i = 0; i < c.params.size();) {
    const Adjacent run = adjacent_to(c, i);
    std::string title = title_of(c, run);
    auto section =
        std::find_if(sections_.begin(), sections_.end(), [&](const Section& s) { return s.title == title; });
    if (section == sections_.end()) section = sections_.insert(section, {std::move(title), {}});
    for (; i < run.end; ++i) section->params.push_back(i);
  }
  for (Section& s : sections_)  // settings without an axis come first
    std::stable_sort(s.params.begin(), s.params.end(),
                     [&](std::size_t a, std::size_t b) { return c.params[a].axis < c.params[b].axis; });
  return sections_;
}

float SetupList::field_width(const Ui& ui, const Catalog& c, float room) {
  if (scale_ == ui.scale && room_ == room) return width_;
  scale_ = ui.scale, room_ = room;
  float longest = 0;
  for (const ParamInfo& p : c.params)
    for (const ParamChoice& choice : p.choices)
      longest = std::max(longest, text_width(ui, Face::body_bold, choice.label) / ui.scale);
  return width_ =
             std::floor(std::max(least_field, std::min(longest + chevron_and_edges, room * most_of_a_row)));
}

}  // namespace hw::panels
