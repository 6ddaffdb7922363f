#include "core/device/travel_check.h"

#include <algorithm>
#include <cctype>
#include <vector>

#include <fmt/format.h>

#include "core/base/index.h"
#include "core/device/axis_check.h"
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

/// A relative move begins at the present target of the axis.
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
      if (act.what && !std::holds_alternative<intent::MoveBy>(*act.what))  // its start is not known yet
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

/// A unit may count against the steps.
std::string distance_in_words(const PlaceWords& place, AxisId axis, Steps distance) {
  std::string words = place(axis, distance);
  if (words.starts_with('-') || words.starts_with("\u2212")) words = place(axis, Steps(0) - distance);
  return words;
}

std::string capital(std::string words) {
  if (!words.empty())
    words.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(words.front())));
  return words;
}

}  // namespace

bool some_travel_holds(const Snapshot& now) {
  const auto end = now.axes.begin() + std::min<std::ptrdiff_t>(now.axis_count, max_axes);
  return std::any_of(now.axes.begin(), end, [](const AxisState& axis) { return axis.travel_holds(); });
}

std::optional<PastTravel> past_travel(const Catalog& catalog, const Snapshot& now, const IntentBody& body) {
  if (!some_travel_holds(now)) return {};
  for (const Goal& goal : goals_of(catalog, now, body))
    if (auto found = past(now.axes[goal.at.axis.index], goal)) return found;
  return {};
}

std::string describe_past(const Catalog& catalog, const PastTravel& past, const PlaceWords& place) {
  const std::string name = spoken_name(catalog, past.axis.index), limit = place(past.axis, past.nearest);
  const char* sign = past.side == Sign::plus ? "+" : "\u2212";
  const std::string_view done =
      past.of == PastTravel::Of::text ? "It was sent as it is." : "Nothing was sent.";
  if (past.of == PastTravel::Of::jog)
    return fmt::format(
        "{} is at the {} limit set for it, {}, or beyond. {} Jog it the other way, or change the "
        "limit.",
        capital(name), sign, limit, done);
  const bool endless = past.place == without_end || past.place == Steps(0) - without_end;
  if (endless && past.of == PastTravel::Of::text)
    return fmt::format(
        "This text moves past a limit: nothing in it ends the motion of {} before its {} limit, "
        "{}. {}",
        name, sign, limit, done);
  if (endless)
    return fmt::format("An endless loop moves {} further in each pass, and so goes past its {} limit, {}. {}",
                       name, sign, limit, done);
  const Steps beyond = past.side == Sign::plus ? past.place - past.nearest : past.nearest - past.place;
  std::string where = past.row < 0 ? std::string() : fmt::format("Row {}: ", past.row + 1);
  if (past.of == PastTravel::Of::backlash)
    where += "To take up backlash, the move would go further than its target: ";
  if (past.of == PastTravel::Of::text) where += "This text moves past a limit: ";
  return fmt::format("{}{} lies {} past the {} limit of {}, {}. {}", where, place(past.axis, past.place),
                     distance_in_words(place, past.axis, beyond), sign, name, limit, done);
}

Steps nearest_allowed(const Snapshot& now, const PastTravel& past) {
  if (past.of != PastTravel::Of::backlash) return past.nearest;
  const Backlash& backlash = now.axes[past.axis.index].backlash;
  return past.nearest + (backlash.last == Sign::plus ? backlash.by : Steps(0) - backlash.by);
}

std::optional<PastTravel> bound_by_travel(const Snapshot& now, intent::JogStart& jog) {
  if (jog.axis.index >= max_axes) return {};  // its driver refuses it
  const AxisState& axis = now.axes[jog.axis.index];
  if (!axis.travel_holds() || !axis.travel.has(jog.sign)) return {};
  const Steps end = axis.travel.end(jog.sign);
  if (axis.travel.past(jog.sign, axis.commanded()) >= Steps(0))
    return PastTravel{jog.axis, jog.sign, axis.commanded(), end, -1, PastTravel::Of::jog};
  jog.up_to = end;
  return {};
}

std::string describe_no_travel(const Catalog& catalog, const intent::SetTravel& request,
                               const PlaceWords& place) {
  if (request.axis.index >= catalog.axes.size()) return describe_no_axis(request.axis.index);
  const Travel& t = request.travel;
  if (t.has_minus && t.has_plus && t.minus >= t.plus)
    return fmt::format(
        "The \u2212 limit of {}, {}, must lie on the \u2212 side of its + limit, {}. Nothing was "
        "changed.",
        spoken_name(catalog, request.axis.index), place(request.axis, t.minus), place(request.axis, t.plus));
  return {};
}

std::string describe_warned(const Catalog& catalog, const PastTravel& past, const PlaceWords& place) {
  if (past.of == PastTravel::Of::text) return describe_past(catalog, past, place);
  return fmt::format("{} has passed its {} limit, {}: nothing ends this motion there.",
                     capital(spoken_name(catalog, past.axis.index)), past.side == Sign::plus ? "+" : "\u2212",
                     place(past.axis, past.nearest));
}

std::optional<PastTravel> TravelWatch::look(const Snapshot& now) {
  for (int i = 0; i < now.axis_count; ++i) {
    const AxisState& axis = now.axes[ix(i)];
    if (!axis.travel_holds()) {
      outside_ &= ~(1u << i);
      continue;
    }
    const Sign side = axis.travel.past(Sign::plus, axis.position) > Steps(0) ? Sign::plus : Sign::minus;
    const bool outside = axis.travel.past(side, axis.position) > Steps(0);
    const bool before = (outside_ >> i & 1u) != 0;
    outside_ = outside ? outside_ | 1u << i : outside_ & ~(1u << i);
    if (!outside || before || !now.axis_moves(i) || axis.activity == Activity::homing)
      continue;  // set by the user
    return PastTravel{AxisId{static_cast<std::uint8_t>(i)}, side, axis.position, axis.travel.end(side)};
  }
  return {};
}

}  // namespace hw
