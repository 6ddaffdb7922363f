#include "core/device/travel_check.h"

#include <algorithm>
#include <cctype>
#include <vector>

#include <fmt/format.h>

#include "core/base/index.h"
#include "core/device/pieces.h"
#include "core/device/sequence_travel.h"

namespace hw {
namespace {

struct Goal {
  AxisTarget at;
  int row = -1;
};
using Goals = std::vector<Goal>;

void add(Goals& goals, const std::vector<AxisTarget>& places, int row = -1) {
  for (const AxisTarget& place : places)
    if (place.axis.index < max_axes) goals.push_back({place, row});
}

/// A relative move begins where the axis is sent now.
void add_distances(Goals& goals, const Snapshot& now, const intent::MoveBy& by) {
  for (const AxisTarget& distance : by.distances)
    if (distance.axis.index < max_axes)
      goals.push_back({{distance.axis, now.axes[distance.axis.index].goal() + distance.value}, -1});
}

void add_rows(Goals& goals, const Catalog& catalog, const intent::FeedMoves& list) {
  const auto& columns = catalog.move_list.columns;
  for (std::size_t row = 0; row < list.rows.size(); ++row)
    for (std::size_t i = 0; i < std::min(columns.size(), list.rows[row].size()); ++i) {
      const std::int64_t value = list.rows[row][i];
      const int axis = columns[i].is_place ? columns[i].of_axis : -1;
      if (axis >= 0 && axis < max_axes && value != intent::FeedMoves::as_it_is)
        goals.push_back({{AxisId{static_cast<std::uint8_t>(axis)}, Steps(value)}, static_cast<int>(row)});
    }
}

Goals goals_of(const Catalog& catalog, const Snapshot& now, const IntentBody& body);

void add_pieces(Goals& goals, const Catalog& catalog, const Snapshot& now, const Pieces& pieces) {
  for (const Piece& piece : pieces.all) {
    add(goals, piece.ends_at);
    add(goals, piece.reaches);
    for (const PieceAct& act : piece.does)
      if (act.what && !std::holds_alternative<intent::MoveBy>(*act.what))  // from wherever it is then
        for (Goal& goal : goals_of(catalog, now, *act.what)) goals.push_back({goal.at, -1});
  }
}

Goals goals_of(const Catalog& catalog, const Snapshot& now, const IntentBody& body) {
  Goals goals;
  if (const auto* i = std::get_if<intent::MoveBy>(&body))
    add_distances(goals, now, *i);
  else if (const auto* i = std::get_if<intent::FeedMoves>(&body))
    add_rows(goals, catalog, *i);
  else if (const auto* i = std::get_if<intent::RunInPieces>(&body)) {
    if (i->pieces) add_pieces(goals, catalog, now, *i->pieces);
  } else if (const auto* i = std::get_if<intent::Act>(&body); i && i->action >= 0 &&
                                                              ix(i->action) < catalog.actions.size() &&
                                                              catalog.actions[ix(i->action)].reaches)
    add(goals, catalog.actions[ix(i->action)].reaches(now, i->values));
  else
    add(goals, places_of(catalog, body));
  return goals;
}

std::optional<PastTravel> past(const AxisState& axis, const Goal& goal) {
  if (!axis.travel_holds()) return {};
  for (const Sign side : {Sign::minus, Sign::plus}) {
    const Steps beyond = axis.travel.past(side, goal.at.value);
    if (beyond > Steps(0) && beyond > axis.travel.past(side, axis.commanded()))
      return PastTravel{goal.at.axis, side, goal.at.value, axis.travel.end(side), goal.row};
  }
  return {};
}

}  // namespace

std::optional<PastTravel> past_travel(const Catalog& catalog, const Snapshot& now, const IntentBody& body) {
  const auto end = now.axes.begin() + std::min<std::ptrdiff_t>(now.axis_count, max_axes);
  if (std::none_of(now.axes.begin(), end, [](const AxisState& axis) { return axis.travel_holds(); }))
    return {};
  for (const Goal& goal : goals_of(catalog, now, body))
    if (auto found = past(now.axes[goal.at.axis.index], goal)) return found;
  return {};
}

std::string describe_past(const Catalog& catalog, const PastTravel& past, const PlaceWords& place) {
  if (past.place == without_end || past.place == Steps(0) - without_end)
    return fmt::format(
        "An endless loop moves {} further in each pass, and so past its {} limit, {}. Nothing was sent.",
        spoken_name(catalog, past.axis.index), past.side == Sign::plus ? "+" : "\u2212",
        place(past.axis, past.nearest));
  const Steps beyond = past.side == Sign::plus ? past.place - past.nearest : past.nearest - past.place;
  const std::string where = past.row < 0 ? std::string() : fmt::format("Row {}: ", past.row + 1);
  return fmt::format("{}{} lies {} past the {} limit of {}, {}. Nothing was sent.", where,
                     place(past.axis, past.place), place(past.axis, beyond),
                     past.side == Sign::plus ? "+" : "\u2212", spoken_name(catalog, past.axis.index),
                     place(past.axis, past.nearest));
}

std::string bound_by_travel(const Catalog& catalog, const Snapshot& now, intent::JogStart& jog) {
  if (jog.axis.index >= max_axes) return {};  // its driver refuses it
  const AxisState& axis = now.axes[jog.axis.index];
  if (!axis.travel_holds() || !axis.travel.has(jog.sign)) return {};
  const Steps end = axis.travel.end(jog.sign);
  if (axis.travel.past(jog.sign, axis.commanded()) < Steps(0)) {
    jog.up_to = end;
    return {};
  }
  return fmt::format(
      "{} stands at the {} limit that is set for it, {}, or beyond. Nothing was sent. Jog it "
      "the other way, or change the limit.",
      spoken_name(catalog, jog.axis.index), jog.sign == Sign::plus ? "+" : "\u2212",
      words_in_steps(catalog, now).position(jog.axis, end));
}

std::string describe_no_travel(const Catalog& catalog, const intent::SetTravel& request) {
  if (request.axis.index >= catalog.axes.size())
    return fmt::format("There is no axis {}.", request.axis.index + 1);
  const Travel& t = request.travel;
  if (t.has_minus && t.has_plus && t.minus >= t.plus)
    return fmt::format("The \u2212 limit of {}, {}, must lie below its + limit, {}. Nothing was changed.",
                       spoken_name(catalog, request.axis.index), t.minus.value, t.plus.value);
  return {};
}

std::string TravelWatch::look(const Snapshot& now) {
  std::string said;
  for (int i = 0; i < now.axis_count; ++i) {
    const AxisState& axis = now.axes[ix(i)];
    if (!axis.travel_holds()) {
      outside_ &= ~(1u << i);
      continue;
    }
    const bool plus = axis.travel.past(Sign::plus, axis.position) > Steps(0);
    const bool outside = plus || axis.travel.past(Sign::minus, axis.position) > Steps(0);
    const bool before = (outside_ >> i & 1u) != 0;
    outside_ = outside ? outside_ | 1u << i : outside_ & ~(1u << i);
    if (!outside || before || !now.axis_moves(i) || axis.activity == Activity::homing)
      continue;  // where it is merely set, a hand has said so
    const auto words = words_in_steps(catalog_, now).position;
    const AxisId id{static_cast<std::uint8_t>(i)};
    said = fmt::format("{} has passed its {} limit, {}: nothing ends this motion there.",
                       spoken_name(catalog_, i), plus ? "+" : "\u2212",
                       words(id, axis.travel.end(plus ? Sign::plus : Sign::minus)));
    said.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(said.front())));
  }
  return said;
}

}  // namespace hw
