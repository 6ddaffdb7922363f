#include "panels/goto_home.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "gui/model/tab.h"
#include "gui/widgets/button.h"
#include "gui/widgets/choice.h"
#include "gui/widgets/message.h"
#include "gui/widgets/text.h"
#include "panels/column.h"
#include "panels/measures.h"
#include "panels/widget_path.h"

namespace hw::panels {

using namespace gui;

namespace {

bool medium(const Frame& f) { return f.tier == Tier::medium; }  // narrower columns
float go_width(const Frame& f) { return medium(f) ? 36 : 44; }
float home_width(const Frame& f) { return medium(f) ? 34 : 42; }
float apart(const Frame& f) { return medium(f) ? 4 : 8; }

bool several(const Frame& f) { return f.catalog.can.interpolates && f.catalog.axes.size() > 1; }
/// A name that can be chosen is a button.
float name_width_of(const Frame& f) { return several(f) ? 36 : f.catalog.axes.size() > 1 ? 20 : 28; }

/// Of many axes only the chosen one has a row, unless all are asked for.
bool many(const Frame& f) { return f.catalog.axes.size() > 4; }
float homes_width(const Frame& f) { return f.catalog.can.homes ? 2 * home_width(f) + close_between : 0; }

}  // namespace

void GotoHome::draw(Frame& f) {
  draw_title(f);
  for (std::size_t i = 0; i < f.catalog.axes.size(); ++i) {
    const AxisId axis{static_cast<std::uint8_t>(i)};
    follow(f, axis);
    if (!many(f) || all_ || axis == f.tab.chosen_axis) draw_row(f, axis);
  }
  const Column column = column_of(f);
  const bool foot =
      (!many(f) || all_) && !column.together_in_title && (several(f) || f.catalog.axes.size() == 1);
  const ImVec2 at = ImGui::GetCursorScreenPos();
  if (foot) draw_together(f, {0, 0, f.area.width, 32}, at);
  ImGui::SetCursorScreenPos(ImVec2(at.x, at.y + f.ui.px(foot ? column.go_row : 0)));
  if (many(f)) draw_all_or_one(f);
  ImGui::Dummy(ImVec2(1, 0));
}

void GotoHome::draw_all_or_one(Frame& f) {
  ButtonOptions o;
  o.style = ButtonStyle::quiet;
  o.width = f.area.width;
  o.icon_after = all_ ? Icon::chevron_up : Icon::chevron_down;
  o.tip =
      all_ ? "Only the axis that is chosen above." : "A row for each axis, and moves of several together.";
  if (button(f.ui, "goto/all", all_ ? "The chosen axis only" : "All axes", o).clicked) all_ = !all_;
}

void GotoHome::draw_title(Frame& f) {
  Ui& ui = f.ui;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const Column column = column_of(f);
  const float height = column.go_title;
  static constexpr std::array<std::string_view, 2> ways = {"To", "By"};
  const float word = column.together_in_title ? 0 : 28;
  if (word > 0)
    draw_text_line(ui, at.x, at.x + ui.px(40), at.y + ui.px(height / 2), Face::body_bold, ui[Tone::ink],
                   "Go");
  ImGui::SetCursorScreenPos(ImVec2(at.x + ui.px(word), at.y + ui.px((height - column.go_control) / 2)));
  const int way = segment(ui, "goto/way", ways, by_ ? 1 : 0,
                          {.cell_width = word > 0 ? 36.0f : 32.0f, .height = column.go_control});
  if (way >= 0) by_ = way == 1;
  if (column.together_in_title) {
    const float ways_end = (ImGui::GetItemRectMax().x - at.x) / ui.scale + close_between;
    draw_together(f,
                  {ways_end, 0, f.area.width - homes_width(f) - close_between - ways_end, column.go_control},
                  ImVec2(at.x, at.y + ui.px((height - column.go_control) / 2)));
  }
  const ImVec2 after(at.x, at.y + ui.px(height));
  ImGui::SetCursorScreenPos(after);
  if (!f.catalog.can.homes) return;
  const float x = at.x + ui.px(f.area.width - homes_width(f));
  if (f.catalog.homing_modes.size() < 2) {
    draw_text_line(ui, x, x + ui.px(90), at.y + ui.px(height / 2), Face::body_bold, ui[Tone::ink], "Home");
    return;
  }
  // The way of homing, for all axes; its button says Home.
  ImGui::SetCursorScreenPos(ImVec2(x, at.y + ui.px((height - column.go_control) / 2)));
  names_.clear();
  for (const HomingMode& mode : f.catalog.homing_modes) names_.push_back(mode.label);
  const int picked = menu(ui, "home/mode", "Home", names_, {}, column.go_control);
  if (picked >= 0) {
    mode_ = picked;
    f.toast(Mood::plain, fmt::format("Home now means: {}.", names_[static_cast<std::size_t>(picked)]));
  }
  ImGui::SetCursorScreenPos(after);
}

void GotoHome::draw_row(Frame& f, AxisId axis) {
  Ui& ui = f.ui;
  Row& row = rows_[axis.index];
  const std::string& name = f.catalog.axes[axis.index].name;
  const DisplayUnit& unit = f.tab.unit(axis);
  const std::string_view why = f.tab.why_not_move(axis);
  const Column column = column_of(f);
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float name_width = name_width_of(f);
  draw_name(f, axis, at);
  const float homes = homes_width(f) > 0 ? homes_width(f) + apart(f) : 0;
  NumberOptions o;
  o.range.decimals = unit.real ? unit.decimals : 0;
  // The controller's own word stands beside the digits already; numbers need the room.
  if (unit.real || !medium(f)) o.range.unit = unit.name;
  o.width = f.area.width - name_width - go_width(f) - close_between - homes;
  o.height = column.go_control;
  o.disabled = why;
  o.refused = row.refused;
  o.sentence_below = false;
  ImGui::SetCursorScreenPos(ImVec2(at.x + ui.px(name_width), at.y));
  const NumberEvent typed =
      number_field(ui, Path("goto/{}", name), Path("Go to, axis {}", name), std::nullopt, row.field, o);
  if (typed.field.edited) row.refused.clear(), row.offers = false;
  ImGui::SetCursorScreenPos(ImVec2(at.x + ui.px(f.area.width - homes - go_width(f)), at.y));
  ButtonOptions button_options;
  button_options.moving = true;
  button_options.width = go_width(f);
  button_options.height = column.go_control;
  button_options.disabled = !why.empty() ? why : row.field.text.empty() ? "Type where to go first." : "";
  const bool clicked = button(ui, Path("goto/{}/go", name), "Go", button_options).clicked;
  if (homes > 0) {
    ImGui::SetCursorScreenPos(ImVec2(at.x + ui.px(f.area.width - homes_width(f)), at.y));
    draw_homes(f, axis, why);
  }
  if (clicked || typed.entered) go(f, axis);
  draw_refusal(f, axis, {at, ImVec2(at.x + ui.px(f.area.width), at.y + ui.px(32))});
  ImGui::SetCursorScreenPos(ImVec2(at.x, at.y + ui.px(column.go_row)));
}

void GotoHome::draw_homes(Frame& f, AxisId axis, std::string_view why) {
  const std::string& name = f.catalog.axes[axis.index].name;
  for (const Sign sign : {Sign::minus, Sign::plus}) {
    ButtonOptions o;
    o.moving = true;
    o.width = home_width(f);
    o.height = column_of(f).go_control;
    o.disabled = why;
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

// ---- what becomes of it

std::optional<Steps> GotoHome::target_of(Frame& f, AxisId axis) {
  Row& row = rows_[axis.index];
  const DisplayUnit& unit = f.tab.unit(axis);
  row.offers = false;
  const auto typed = parse_position(row.field.text, unit);
  if (!typed) {
    row.refused = typed.error().sentence();
    return {};
  }
  const Steps here = f.now.axes[axis.index].commanded();
  const Steps target = by_ ? here + *typed : *typed;
  const Steps low = f.catalog.position_min, high = f.catalog.position_max;
  if (low >= high || (target >= low && target <= high)) return *typed;
  const Steps nearest = std::clamp(target, low, high);
  row.nearest = by_ ? nearest - here : nearest;
  row.offers = true;
  const bool above = target > high;
  const Steps past = above ? target - high : low - target;
  row.refused =
      fmt::format("{} lies {} past the {} end of what {} can count, {}. Nothing was sent.",
                  format_with_unit(target, unit).view(), format_with_unit(past, unit).view(),
                  above ? "+" : "\u2212", f.catalog.short_name, format_with_unit(nearest, unit).view());
  return {};
}

void GotoHome::go(Frame& f, AxisId axis) {
  if (const auto target = target_of(f, axis)) go_to(f, axis, *target);
}

void GotoHome::go_to(Frame& f, AxisId axis, Steps target) {
  send(f, std::vector<AxisTarget>(1, AxisTarget{axis, target}), by_);
}

/// The row of the first one tells what became of it.
void GotoHome::send(Frame& f, std::vector<AxisTarget> targets, bool by) {
  Row& row = rows_[targets.front().axis.index];
  row.refused.clear();
  row.offers = false;
  if (by)
    row.asked = row.doubt.send(f, intent::MoveBy(std::move(targets)));
  else
    row.asked = row.doubt.send(f, intent::MoveTo(std::move(targets)));
}

// ---- several axes

bool GotoHome::chosen(const Frame& f, std::size_t axis) const {
  return !several(f) || ((together_ >> axis) & 1u);
}

/// Where several axes can move together, the name chooses whether this one does.
void GotoHome::draw_name(Frame& f, AxisId axis, ImVec2 at) {
  Ui& ui = f.ui;
  const std::string& name = f.catalog.axes[axis.index].name;
  if (!several(f) || (many(f) && !all_))
    return draw_text_line(ui, at.x, at.x + ui.px(name_width_of(f)), at.y + ui.px(column_of(f).go_control / 2),
                          Face::body_bold, ui[Tone::ink], name);
  ButtonOptions o;
  o.style = ButtonStyle::segment;
  o.on = chosen(f, axis.index);
  o.width = name_width_of(f) - close_between;
  o.height = column_of(f).go_control;
  o.tip = "Takes part when several axes go together.";
  ImGui::SetCursorScreenPos(at);
  if (button(ui, Path("goto/{}/with", name), name, o).clicked) together_ ^= 1u << axis.index;
}

/// In `place`, logical, from `at` on. In the title the words are short.
void GotoHome::draw_together(Frame& f, const Box& place, ImVec2 at) {
  if (!several(f) && f.catalog.axes.size() != 1) return;
  Ui& ui = f.ui;
  const bool brief = column_of(f).together_in_title;
  const std::string_view why = why_not_together(f);
  const bool none = several(f) && together_ == 0;
  ButtonOptions o;
  o.moving = true;
  o.width = several(f) ? std::floor((place.width - close_between) / 2) : place.width;
  o.height = place.height;
  o.disabled = !why.empty() ? why : none ? "Choose the axes by their names first." : "";
  ImGui::SetCursorScreenPos(ImVec2(at.x + ui.px(place.x), at.y));
  if (several(f)) {
    o.tip = "The chosen axes move together on a straight line.";
    if (button(ui, "goto/go", brief ? "Go all" : "Go together", o).clicked) go_together(f);
    ImGui::SetCursorScreenPos(ImVec2(at.x + ui.px(place.x + o.width + close_between), at.y));
  }
  o.tip = several(f) ? "The chosen axes move to 0 together." : "Moves to 0.";
  if (button(ui, "goto/zero", brief ? "To 0" : "Return to zero", o).clicked) go_to_zero(f);
}

void GotoHome::go_together(Frame& f) {
  std::vector<AxisTarget> targets;
  bool all = true;
  for (std::uint8_t i = 0; i < f.catalog.axes.size(); ++i) {
    if (!chosen(f, i)) continue;
    rows_[i].refused.clear();
    const auto target = target_of(f, AxisId{i});
    all = all && target;
    if (target) targets.push_back({AxisId{i}, *target});
  }
  if (all && !targets.empty()) send(f, std::move(targets), by_);
}

void GotoHome::go_to_zero(Frame& f) {
  std::vector<AxisTarget> targets;
  for (std::uint8_t i = 0; i < f.catalog.axes.size(); ++i)
    if (chosen(f, i)) targets.push_back({AxisId{i}, Steps{}});
  send(f, std::move(targets), false);
}

std::string_view GotoHome::why_not_together(const Frame& f) const {
  for (std::uint8_t i = 0; i < f.catalog.axes.size(); ++i)
    if (const std::string_view why = f.tab.why_not_move(AxisId{i}); chosen(f, i) && !why.empty()) return why;
  return f.tab.why_not_move();
}

void GotoHome::follow(Frame& f, AxisId axis) {
  Row& row = rows_[axis.index];
  if (f.now.forgotten(row.asked)) row.asked = 0;
  const IntentFate* fate = f.now.fate_of(row.asked);
  if (!fate || fate->fate == Fate::pending) return;
  row.asked = 0;
  if (fate->fate != Fate::done && !row.doubt.hear(f, *fate)) row.refused = fate->sentence.view();
}

void GotoHome::draw_refusal(Frame& f, AxisId axis, const Rect& beside) {
  Row& row = rows_[axis.index];
  const std::string& name = f.catalog.axes[axis.index].name;
  const Path about("Go, {}", name);
  if (row.doubt.open()) {
    if (const IntentId sent = row.doubt.draw(f, "goto", about, beside, mode_)) row.asked = sent;
    return;
  }
  if (row.refused.empty()) return;
  const DisplayUnit& unit = f.tab.unit(axis);
  const Path id("goto/{}/refused", name), nearest("goto/{}/nearest", name);
  const Path label("Go {} {}", by_ ? "by" : "to", format_with_unit(row.nearest, unit).view());
  const std::array<Action, 1> actions = {
      Action{.id = nearest, .label = label, .disabled = f.tab.why_not_move(axis), .moving = true}};
  row.card.begin(
      f, {.id = id, .about = about, .words = row.refused, .actions = {actions.data(), row.offers ? 1u : 0u}},
      beside);
  const RefusalTouch done = row.card.end();
  if (done.action == 0) {
    row.field.set(from_steps(row.nearest, unit), unit.real ? unit.decimals : 0);
    go_to(f, axis, row.nearest);
  }
  if (done.closed) row.refused.clear(), row.offers = false;
}

}  // namespace hw::panels
