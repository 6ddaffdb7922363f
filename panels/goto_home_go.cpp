// The targets of Go, and the results of its moves.
#include <algorithm>

#include "core/device/travel_check.h"
#include "gui/model/tab.h"
#include "panels/goto_home.h"
#include "panels/widget_path.h"

namespace hw::panels {

using namespace gui;

bool can_go_together(const Frame& f) { return f.catalog.can.interpolates && f.catalog.axes.size() > 1; }

// ---- results

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
  if (const auto past = past_travel(f.catalog, f.now, intent::MoveTo({{axis, target}}))) {
    row.nearest = by_ ? past->nearest - here : past->nearest;
    row.offers = true;
    row.refused = describe_past(f.catalog, *past, [&](AxisId, Steps place) {
      return std::string(format_with_unit(place, unit).view());
    });
    return {};
  }
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
  send(f, std::vector<AxisTarget>(1, AxisTarget{axis, target}), by_, speed_of(f, axis));
}

/// The row of the first axis shows the result.
void GotoHome::send(Frame& f, std::vector<AxisTarget> targets, bool by, Pps speed) {
  Row& row = rows_[targets.front().axis.index];
  row.refused.clear();
  row.offers = false;
  if (by)
    row.asked = row.doubt.send(f, intent::MoveBy(std::move(targets), speed));
  else
    row.asked = row.doubt.send(f, intent::MoveTo(std::move(targets), speed));
}

// ---- several axes

bool GotoHome::chosen(const Frame& f, std::size_t axis) const {
  return !can_go_together(f) || ((together_ >> axis) & 1u);
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
  const IntentOutcome* outcome = f.now.outcome_of(row.asked);
  if (!outcome || outcome->state == IntentState::pending) return;
  row.asked = 0;
  if (outcome->state != IntentState::done && !row.doubt.take_refusal(f, *outcome))
    row.refused = f.tab.words_of(*outcome);
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
