// The targets of Go, and the results of its moves.
#include <algorithm>

#include "core/device/travel_check.h"
#include "gui/model/tab.h"
#include "panels/goto_home.h"
#include "panels/goto_speed.h"
#include "panels/widget_path.h"

namespace hw::panels {

using namespace gui;

bool can_go_together(const Frame& f) { return f.catalog.can.interpolates && f.catalog.axes.size() > 1; }

// ---- results

std::optional<Steps> GotoHome::target_of(Frame& f, AxisId axis) {
  Row& row = rows_[axis.index];
  const DisplayUnit& unit = f.tab.settings.unit(axis);
  row.instead.reset();
  const auto typed = parse_position(row.field.text, unit);
  if (!typed) {
    row.refused = typed.error().sentence();
    return {};
  }
  const Steps here = f.now.axes[axis.index].commanded();
  const Steps target = by_ ? here + *typed : *typed;
  const auto offer = [&](Steps nearest) {
    row.instead = Motion{std::vector<AxisTarget>(1, {axis, by_ ? nearest - here : nearest}), by_};
  };
  const Steps low = f.catalog.position_min, high = f.catalog.position_max;
  if (const auto past = past_travel(f.catalog, f.now, intent::MoveTo({{axis, target}}))) {
    offer(past->nearest);
    row.refused = describe_past(f.catalog, *past, f.tab.settings.place_words());
    return {};
  }
  if (low >= high || (target >= low && target <= high)) return *typed;
  const Steps nearest = std::clamp(target, low, high);
  offer(nearest);
  const bool above = target > high;
  const Steps past = above ? target - high : low - target;
  row.refused =
      fmt::format("{} lies {} past the {} end of the range of {}, {}. Nothing was sent.",
                  format_with_unit(target, unit).view(),
                  format_with_unit(past, f.tab.settings.units().length(axis)).view(), above ? "+" : "\u2212",
                  f.catalog.short_name, format_with_unit(nearest, unit).view());
  return {};
}

void GotoHome::go(Frame& f, AxisId axis) {
  if (const auto target = target_of(f, axis)) send(f, {std::vector<AxisTarget>(1, {axis, *target}), by_});
}

/// The row of the first axis shows the result.
void GotoHome::send(Frame& f, Motion motion) {
  Row& row = rows_[motion.targets.front().axis.index];
  row.refused.clear();
  row.instead.reset();
  row.sent = motion;
  const GoSpeed speed = speed_of_go(f, motion.targets, motion.by, typed_speed());
  const auto send = [&](auto move) {
    move.own_speeds = speed.own_speeds;
    row.asked = row.doubt.send(f, std::move(move));
  };
  if (motion.by)
    send(intent::MoveBy(std::move(motion.targets), speed.speed));
  else
    send(intent::MoveTo(std::move(motion.targets), speed.speed));
}

/// The motion in which each axis ends as near to its target as its limits allow. nullopt: it would still be
/// refused.
std::optional<GotoHome::Motion> GotoHome::nearest_to(const Frame& f, const Motion& motion,
                                                     const PastTravel& past) {
  Motion nearest = motion;
  for (AxisTarget& target : nearest.targets) {
    const Steps from = motion.by ? f.now.axes[target.axis.index].goal() : Steps(0);
    const Steps place = from + target.value;
    const auto its_own = past_travel(f.catalog, f.now, intent::MoveTo({{target.axis, place}}));
    if (its_own) target.value = its_own->nearest - from;
    if (!its_own && target.axis == past.axis) target.value = nearest_allowed(f.now, past) - from;
  }
  return nearest;
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
  if (all && !targets.empty()) send(f, {std::move(targets), by_});
}

void GotoHome::go_to_zero(Frame& f) {
  std::vector<AxisTarget> targets;
  for (std::uint8_t i = 0; i < f.catalog.axes.size(); ++i)
    if (chosen(f, i)) targets.push_back({AxisId{i}, Steps{}});
  send(f, {std::move(targets), false});
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
  if (outcome->state == IntentState::done || row.doubt.take_refusal(f, *outcome)) return;
  row.refused = f.tab.messages.words_of(*outcome);
  if (outcome->past) row.instead = nearest_to(f, row.sent, *outcome->past);
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
  const Path id("goto/{}/refused", name), nearest("goto/{}/nearest", name);
  const Path label = label_of_nearest(f, axis, row.instead ? &*row.instead : nullptr);
  const std::array<Action, 1> actions = {
      Action{.id = nearest, .label = label, .disabled = f.tab.why_not_move(axis), .moving = true}};
  row.card.begin(
      f, {.id = id, .about = about, .words = row.refused, .actions = {actions.data(), row.instead ? 1u : 0u}},
      beside);
  const RefusalTouch done = row.card.end();
  if (done.action == 0) go_instead(f, axis);
  if (done.closed) row.refused.clear(), row.instead.reset();
}

/// "Go to 300.000 mm"; for several axes it says only that the limits hold.
Path GotoHome::label_of_nearest(const Frame& f, AxisId axis, const Motion* nearest) {
  if (!nearest || nearest->targets.size() != 1) return Path("Go as far as the limits allow");
  return Path("Go {} {}", nearest->by ? "by" : "to",
              format_with_unit(nearest->targets.front().value, f.tab.settings.unit(axis)).view());
}

void GotoHome::go_instead(Frame& f, AxisId axis) {
  Row& row = rows_[axis.index];
  Motion nearest = std::move(*row.instead);
  const DisplayUnit& unit = f.tab.settings.unit(axis);
  if (nearest.targets.size() == 1 && !row.field.text.empty() && nearest.by == by_)
    row.field.set(from_steps(nearest.targets.front().value, unit), unit.real ? unit.decimals : 0);
  send(f, std::move(nearest));
}

}  // namespace hw::panels
