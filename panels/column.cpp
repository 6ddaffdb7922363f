#include "panels/column.h"

#include <algorithm>
#include <cmath>

#include "gui/model/tab.h"
#include "panels/measures.h"
#include "panels/position/axis_extras.h"

namespace hw::panels {

using namespace gui;
namespace {

constexpr float hairline = 1, position_title = 44, steps_row = 32, speed_row = 32, travel_bar = 20,
                above_go = 4;

bool interpolates(const Frame& f) { return f.catalog.can.interpolates && f.catalog.axes.size() > 1; }

/// Three or four axes in a wide window. All numbers are in lines of the same height.
LeftColumn of_many(const Frame& f) {
  LeftColumn c;
  c.head = 24, c.caption = 17;
  c.between_steps = 4;
  c.go_title = 28, c.go_row = 32, c.go_control = 28;
  c.together_in_title = interpolates(f);
  return c;
}

LeftColumn of_few(const Frame& f) {
  const bool wide = f.tier == Tier::wide;
  LeftColumn c;
  c.below = wide ? 8 : 4;
  c.above = hairline + c.below;
  c.digits = wide ? 48 : 36, c.caption = 16;
  c.extras = axis_extras_height(f.catalog, AxisId{0});
  c.cell = wide ? 56 : 48;
  c.between_steps = f.catalog.axes.size() == 2 ? 12 : 8;
  c.go_title = wide ? 40 : 36;
  c.speed_over_slider = wide;
  c.below_steps = wide ? 8 : 0;
  return c;
}

/// The height of the column without travel bars.
float height_of(const Frame& f, const LeftColumn& c) {
  const auto axes = static_cast<float>(f.catalog.axes.size());
  const float pad = axes < 2 ? c.cell : 3 * c.cell + 2 * close_between;
  const float steps = axes == 2 ? c.between_steps : c.between_steps + steps_row + c.below_steps;
  const float jog = c.title + c.reason + pad + steps + (c.speed_over_slider ? 58 : speed_row) + hairline;
  const float go = axes > 2 ? above_go + 2 * c.go_row : c.go_title + (axes + 1) * c.go_row;
  return position_title + axes * c.block() + jog + go;
}

/// The height of jog and Go where each axis has a row with jog buttons.
float height_below_rows(const LeftColumn& c) {
  const float jog = c.title + c.reason + c.wide_stop + c.between_steps + steps_row + c.below_steps;
  return jog + hairline + above_go + 2 * c.go_row;
}

/// Makes the rows of axes lower in a low window, so that Go stays visible.
void keep_go_in_view(LeftColumn& c) {
  c.title = 32, c.reason = 48, c.wide_stop = 32;
  c.between_steps = 4, c.below_steps = 0;
  c.go_row = 29, c.go_control = 28;
}

}  // namespace

float LeftColumn::block() const { return above + head + digits + caption + extras + travel + below; }

LeftColumn column_of(const Frame& f) {
  const std::size_t axes = f.catalog.axes.size();
  const bool wide = f.tier == Tier::wide, rows = axes > 4 || f.tab.bus;
  LeftColumn c = axes <= 2 ? of_few(f) : wide && !rows ? of_many(f) : LeftColumn{.above = 4, .below = 3};
  if (f.tier == Tier::medium) {
    c.title = 36, c.reason = 52;  // a line more, because the column is narrower
    c.speed_in_title = true;
    c.below_steps = 8;
    if (axes > 2)
      c.cell = std::min(48.0f, std::floor((f.area.width + 4) / (static_cast<float>(axes) + 1)) - 4);
    if (axes > 2 && !rows) {  // keeps Go and Home visible in the lowest window of this kind
      c.above = 2, c.below = 1, c.title = 32, c.below_steps = 2;
      c.cell = std::min(40.0f, c.cell);
      c.go_row = 32, c.go_control = 28;
    }
  }
  if (rows) c.speed_over_slider = false, c.between_steps = 8, c.below_steps = wide ? 0 : 8;
  if (rows && f.tier == Tier::medium && f.area.height < height_below_rows(c)) keep_go_in_view(c);
  if (wide && !rows) {
    const float left_over = f.area.height - height_of(f, c);
    if (left_over >= travel_bar * static_cast<float>(axes)) c.travel = travel_bar;
  }
  return c;
}

}  // namespace hw::panels
