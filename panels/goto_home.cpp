#include "panels/goto_home.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <vector>

#include "core/device/homing.h"
#include "core/device/travel_check.h"
#include "gui/model/tab.h"
#include "gui/model/tap_size.h"
#include "gui/widgets/button.h"
#include "gui/widgets/choice.h"
#include "gui/widgets/message.h"
#include "gui/widgets/text.h"
#include "panels/column.h"
#include "panels/goto_speed.h"
#include "panels/measures.h"
#include "panels/widget_path.h"

namespace hw::panels {

using namespace gui;

namespace {

bool medium(const Frame& f) { return f.tier == Tier::medium; }  // its columns are narrower
float go_width(const Frame& f) { return medium(f) ? 36 : 44; }
float home_width(const Frame& f) { return medium(f) ? 34 : 42; }
float apart(const Frame& f) { return medium(f) ? 4 : 8; }

/// Logical width of the name, which is a button if the axis can be chosen.
float name_width_of(const Frame& f) { return can_go_together(f) ? 36 : f.catalog.axes.size() > 1 ? 20 : 28; }

/// With many axes only the chosen axis has a row, unless the user shows all.
bool many(const Frame& f) { return f.catalog.axes.size() > 2; }
float homes_width(const Frame& f) { return f.catalog.can.homes ? 2 * home_width(f) + close_between : 0; }

constexpr std::string_view all_axes = "All axes";
constexpr float by_width = 34;
float places_width(const Frame& f) { return medium(f) ? 58 : 62; }

}  // namespace

void GotoHome::draw(Frame& f) {
  speed_is_shown_ = false;
  follow_units(f);
  for (std::size_t i = 0; i < f.catalog.axes.size(); ++i) follow(f, AxisId{static_cast<std::uint8_t>(i)});
  if (many(f) && !all_)
    draw_chosen(f);
  else
    draw_rows(f);
  ImGui::Dummy(ImVec2(1, 0));
}

// ---- the chosen axis of many: two rows

/// Draws "X v [240.000 mm] at [20 mm/s] Go", and below it to or by, the saved places and Home.
void GotoHome::draw_chosen(Frame& f) {
  Ui& ui = f.ui;
  const AxisId axis = f.tab.view.chosen_axis;
  const LeftColumn column = column_of(f);
  constexpr float name = 48;
  ImVec2 at = ImGui::GetCursorScreenPos();
  const auto next_row = [&] {
    at.y += ui.px(column.go_row);
    ImGui::SetCursorScreenPos(at);
  };
  ImGui::SetCursorScreenPos(ImVec2(at.x, at.y + ui.px(4)));
  at.y += ui.px(4);
  draw_axis_choice(f, name);
  ImGui::SetCursorScreenPos(ImVec2(at.x + ui.px(name + close_between), at.y));
  draw_target(f, axis, f.area.width - name - close_between, medium(f) ? 56 : 68);
  draw_refusal(f, axis, {at, ImVec2(at.x + ui.px(f.area.width), at.y + ui.px(32))});
  next_row();
  draw_by(f);
  ImGui::SetCursorScreenPos(ImVec2(at.x + ui.px(by_width + close_between), at.y));
  draw_places(f, places_width(f));
  if (f.catalog.can.homes) {
    const float homes = homes_width(f);
    const float word = button_width(ui, "Home", {.style = ButtonStyle::quiet});
    draw_home_ways(f, ImVec2(at.x + ui.px(f.area.width - homes - word), at.y), ui.px(word));
    ImGui::SetCursorScreenPos(ImVec2(at.x + ui.px(f.area.width - homes), at.y));
    draw_homes(f, axis, f.tab.why_not_move(axis));
  }
  next_row();
}

/// Draws the switch that makes the typed number a distance.
void GotoHome::draw_by(Frame& f) {
  ButtonOptions o{
      .style = ButtonStyle::segment, .width = by_width, .height = column_of(f).go_control, .on = by_};
  o.tip = "Go by a distance instead of to a place.";
  if (button(f.ui, "goto/way/By", "By", o).clicked) by_ = !by_;
}

void GotoHome::draw_axis_choice(Frame& f, float width) {
  names_.clear();
  for (const AxisInfo& axis : f.catalog.axes) names_.push_back(axis.name);
  names_.push_back(all_axes);
  DropdownOptions o;
  o.width = width;
  o.height = column_of(f).go_control;
  o.tip = "The axis to move. All axes: a row for each, and moves of several together.";
  const int picked = dropdown(f.ui, "goto/axis", "Axis", names_, f.tab.view.chosen_axis.index, o);
  if (picked < 0) return;
  all_ = picked == static_cast<int>(f.catalog.axes.size());
  if (all_) return;
  if (f.tab.view.chosen_axis.index != picked)
    speed_.reset(), speed_.text.clear();  // the speed was typed for another axis
  f.tab.view.chosen_axis = AxisId{static_cast<std::uint8_t>(picked)};
}

// ---- a row for each axis

void GotoHome::draw_rows(Frame& f) {
  follow_unit_of_speed(f.tab.settings.unit(AxisId{0}));
  speed_is_shown_ = true;  // the title, or a line below the rows, shows it
  draw_title(f);
  for (std::uint8_t i = 0; i < f.catalog.axes.size(); ++i) draw_row(f, AxisId{i});
  const LeftColumn column = column_of(f);
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float places = many(f) && !column.together_in_title ? 0 : places_width(f);
  if (column.together_in_title) {
    ImGui::SetCursorScreenPos(ImVec2(at.x + f.ui.px(places + close_between), at.y));
    draw_speed(f, AxisId{0}, 140);
    ImGui::SetCursorScreenPos(at);
  }
  if (places > 0) draw_places(f, places);
  if (!column.together_in_title && (can_go_together(f) || f.catalog.axes.size() == 1))
    draw_together(f,
                  {places + (places > 0 ? close_between : 0), 0,
                   f.area.width - places - (places > 0 ? close_between : 0), column.go_control},
                  at);
  ImGui::SetCursorScreenPos(ImVec2(at.x, at.y + f.ui.px(column.go_row)));
  if (!many(f)) return;
  ButtonOptions o;
  o.style = ButtonStyle::quiet;
  o.width = f.area.width;
  o.icon_after = Icon::chevron_up;
  if (button(f.ui, "goto/all", "The chosen axis only", o).clicked) all_ = false;
}

void GotoHome::draw_title(Frame& f) {
  Ui& ui = f.ui;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const LeftColumn column = column_of(f);
  const float height = column.go_title, top = at.y + ui.px((height - column.go_control) / 2);
  constexpr float cell = 38, ways_end = 2 * cell + close_between;
  ImGui::SetCursorScreenPos(ImVec2(at.x, top));
  draw_way(f, cell);
  const float free = f.area.width - homes_width(f) - close_between - ways_end;
  if (column.together_in_title) {
    draw_together(f, {ways_end, 0, free, column.go_control}, ImVec2(at.x, top));
  } else {
    ImGui::SetCursorScreenPos(ImVec2(at.x + ui.px(ways_end), top));
    draw_speed(f, AxisId{0}, free);
  }
  if (f.catalog.can.homes)
    draw_home_ways(f, ImVec2(at.x + ui.px(f.area.width - homes_width(f)), top), ui.px(homes_width(f)));
  ImGui::SetCursorScreenPos(ImVec2(at.x, at.y + ui.px(height)));
}

/// Draws the choice between targets and distances.
void GotoHome::draw_way(Frame& f, float cell) {
  static constexpr std::array<std::string_view, 2> ways = {"To", "By"};
  const int way =
      segment(f.ui, "goto/way", ways, by_ ? 1 : 0, {.cell_width = cell, .height = column_of(f).go_control});
  if (way >= 0) by_ = way == 1;
}

/// Draws the choice of homing for all axes; its button says Home.
void GotoHome::draw_home_ways(Frame& f, ImVec2 at, float width) {
  const float height = column_of(f).go_control;
  if (f.catalog.homing_modes.size() < 2)
    return draw_text_line(f.ui, at.x, at.x + width, at.y + f.ui.px(height / 2), Face::body_bold,
                          f.ui[Tone::ink], "Home");
  ImGui::SetCursorScreenPos(at);
  names_.clear();
  for (const HomingMode& mode : f.catalog.homing_modes) names_.push_back(mode.label);
  const int picked = menu(f.ui, "home/mode", "Home", names_, {}, height);
  if (picked < 0) return;
  mode_ = picked;
  f.toast(Severity::plain, fmt::format("Home now means: {}.", names_[static_cast<std::size_t>(picked)]));
}

void GotoHome::draw_row(Frame& f, AxisId axis) {
  Ui& ui = f.ui;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float name_width = name_width_of(f);
  draw_name(f, axis, at);
  const float homes = homes_width(f) > 0 ? homes_width(f) + apart(f) : 0;
  ImGui::SetCursorScreenPos(ImVec2(at.x + ui.px(name_width), at.y));
  draw_target(f, axis, f.area.width - name_width - homes, 0);
  if (homes > 0) {
    ImGui::SetCursorScreenPos(ImVec2(at.x + ui.px(f.area.width - homes_width(f)), at.y));
    draw_homes(f, axis, f.tab.why_not_move(axis));
  }
  draw_refusal(f, axis, {at, ImVec2(at.x + ui.px(f.area.width), at.y + ui.px(32))});
  ImGui::SetCursorScreenPos(ImVec2(at.x, at.y + ui.px(column_of(f).go_row)));
}

/// Converts typed targets when the unit changes, so that no axis goes to a target that was not typed.
void GotoHome::follow_units(const Frame& f) {
  for (std::size_t i = 0; i < f.catalog.axes.size(); ++i) {
    Row& row = rows_[i];
    const DisplayUnit& unit = f.tab.settings.unit(AxisId{static_cast<std::uint8_t>(i)});
    if (row.unit == unit) continue;
    const auto typed = parse_position(row.field.text, row.unit);
    if (typed)
      row.field.set(from_steps(*typed, unit), unit.real ? unit.decimals : 0);
    else
      row.field.reset();
    row.unit = unit;
    row.refused.clear(), row.instead.reset();
  }
}

void GotoHome::follow_unit_of_speed(const DisplayUnit& unit) {
  if (speed_unit_ == unit) return;
  const auto per_step = [](const DisplayUnit& u) { return u.real ? std::abs(u.per_step) : 1; };
  if (const auto typed = speed_.value())
    speed_.set(*typed / per_step(speed_unit_) * per_step(unit), unit.real ? unit.decimals : 0);
  speed_unit_ = unit;
}

/// Draws target, optional speed and Go in a line of this width at the cursor.
void GotoHome::draw_target(Frame& f, AxisId axis, float width, float speed_width) {
  Ui& ui = f.ui;
  Row& row = rows_[axis.index];
  const std::string& name = f.catalog.axes[axis.index].name;
  const DisplayUnit& unit = f.tab.settings.unit(axis);
  const std::string_view why = f.tab.why_not_move(axis);
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float speed = speed_width > 0 ? speed_width + 20 : 0;
  NumberOptions o;
  o.range.decimals = unit.real ? unit.decimals : 0;
  // The digits already show the controller's own unit, and the numbers need the width.
  if (unit.real || (!medium(f) && speed == 0)) o.range.unit = unit.name;
  o.width = width - go_width(f) - close_between - speed;
  o.height = column_of(f).go_control;
  o.disabled = why;
  o.refused = row.refused;
  o.sentence_below = false;
  const NumberEvent typed =
      number_field(ui, Path("goto/{}", name), Path("Go to, axis {}", name), std::nullopt, row.field, o);
  if (typed.field.edited) row.refused.clear(), row.instead.reset();
  if (speed > 0) {
    ImGui::SetCursorScreenPos(ImVec2(at.x + ui.px(o.width), at.y));
    draw_speed(f, axis, speed);
  }
  ImGui::SetCursorScreenPos(ImVec2(at.x + ui.px(width - go_width(f)), at.y));
  ButtonOptions button_options;
  button_options.moving = true;
  button_options.width = go_width(f);
  button_options.height = o.height;
  button_options.disabled = !why.empty() ? why : row.field.text.empty() ? "Type a target first." : "";
  const bool clicked = button(ui, Path("goto/{}/go", name), "Go", button_options).clicked;
  if (clicked || typed.entered) go(f, axis);
}

/// Draws "at [20]", in the unit of that axis: the speed of Go until the field is emptied.
void GotoHome::draw_speed(Frame& f, AxisId axis, float width) {
  Ui& ui = f.ui;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const DisplayUnit& unit = f.tab.settings.unit(axis);
  draw_text_line(ui, at.x + ui.px(4), at.x + ui.px(20), at.y + ui.px(column_of(f).go_control / 2),
                 Face::small, ui[Tone::ink2], "at");
  follow_unit_of_speed(unit);
  speed_is_shown_ = true;
  ImGui::SetCursorScreenPos(ImVec2(at.x + ui.px(20), at.y));
  NumberOptions o;
  o.range.decimals = unit.real ? unit.decimals : 0;
  o.range.unit = "/s";
  o.range.min = 0;
  o.width = width - 20 - close_between;
  o.height = column_of(f).go_control;
  o.sentence_below = false;
  const bool differ = unit_of_taps(f.tab) && !(many(f) && !all_);
  const Path tip("Speed of Go, in {} per second. Empty: as set in the controller.{}",
                 differ ? std::string_view("each axis' own unit") : std::string_view(unit.name),
                 speed_together_is(f, std::popcount(together_) < 2 ? ~0u : together_));
  o.tip = tip;
  (void)number_field(ui, "goto/speed", "Speed of Go", std::nullopt, speed_, o);
}

double GotoHome::typed_speed() const { return speed_is_shown_ ? std::abs(speed_.value().value_or(0)) : 0; }

void GotoHome::draw_places(Frame& f, float width) {
  const auto to = places_.draw(f, width, column_of(f).go_control);
  if (to && !to->empty()) send(f, {*to, false});
}

void GotoHome::draw_homes(Frame& f, AxisId axis, std::string_view why) {
  const std::string& name = f.catalog.axes[axis.index].name;
  for (const Sign sign : {Sign::minus, Sign::plus}) {
    const std::string why_not = why_not_home(f.catalog, mode_, sign);
    ButtonOptions o;
    o.moving = true;
    o.width = home_width(f);
    o.height = column_of(f).go_control;
    o.disabled = why.empty() ? std::string_view(why_not) : why;
    if (sign == Sign::minus)
      o.icon = Icon::home_minus;
    else
      o.icon_after = Icon::home_plus;
    const std::string_view mode = f.catalog.homing_modes.empty()
                                      ? std::string_view()
                                      : f.catalog.homing_modes[static_cast<std::size_t>(mode_)].label;
    const Path tip("Home, {}: {}", sign == Sign::minus ? "in the \u2212 direction" : "in the + direction",
                   mode);
    o.tip = tip;
    if (button(f.ui, Path("home/{}/{}", name, letter(sign)), sign_text(sign), o).clicked)
      f.send(intent::Home(axis, sign, mode_));
    if (sign == Sign::minus) ImGui::SameLine(0, f.ui.px(close_between));
  }
}

// ---- several axes together

/// If several axes can move together, a press on the name includes or excludes the axis.
void GotoHome::draw_name(Frame& f, AxisId axis, ImVec2 at) {
  Ui& ui = f.ui;
  const std::string& name = f.catalog.axes[axis.index].name;
  if (!can_go_together(f))
    return draw_text_line(ui, at.x, at.x + ui.px(name_width_of(f)), at.y + ui.px(column_of(f).go_control / 2),
                          Face::body_bold, ui[Tone::ink], name);
  ButtonOptions o;
  o.style = ButtonStyle::segment;
  o.on = chosen(f, axis.index);
  o.width = name_width_of(f) - close_between;
  o.height = column_of(f).go_control;
  o.tip = "Includes the axis in moves of several together.";
  ImGui::SetCursorScreenPos(at);
  if (button(ui, Path("goto/{}/with", name), name, o).clicked) together_ ^= 1u << axis.index;
}

/// Draws within `place` (logical), from `at` on. In the title the words are short.
void GotoHome::draw_together(Frame& f, const Box& place, ImVec2 at) {
  if (!can_go_together(f) && f.catalog.axes.size() != 1) return;
  Ui& ui = f.ui;
  const bool brief = column_of(f).together_in_title;
  const std::string_view why = why_not_together(f);
  const bool none = can_go_together(f) && together_ == 0;
  ButtonOptions o;
  o.moving = true;
  o.width = can_go_together(f) ? std::floor((place.width - close_between) / 2) : place.width;
  o.height = place.height;
  o.disabled = !why.empty() ? why : none ? "Choose the axes by their names first." : "";
  ImGui::SetCursorScreenPos(ImVec2(at.x + ui.px(place.x), at.y));
  if (can_go_together(f)) {
    o.tip = "The chosen axes move together on a straight line.";
    if (button(ui, "goto/go", brief ? "Go all" : "Go together", o).clicked) go_together(f);
    ImGui::SetCursorScreenPos(ImVec2(at.x + ui.px(place.x + o.width + close_between), at.y));
  }
  o.tip = can_go_together(f) ? "The chosen axes move to 0 together." : "Moves to 0.";
  if (button(ui, "goto/zero", brief ? "To 0" : "Return to zero", o).clicked) go_to_zero(f);
}

}  // namespace hw::panels
