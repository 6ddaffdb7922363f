#include "core/device/refusals.h"

#include <algorithm>

#include <fmt/format.h>

#include "core/base/index.h"
#include "core/device/pieces.h"

namespace hw {
namespace {

/// "X", "X and Y", "X, Y and Z"
std::string listed(const std::vector<std::string>& names) {
  std::string all;
  for (std::size_t i = 0; i < names.size(); ++i)
    all += fmt::format("{}{}", i == 0 ? "" : i + 1 == names.size() ? " and " : ", ", names[i]);
  return all;
}

/// Adds the columns that are places, each with its axis.
void add_places(std::vector<AxisTarget>& places, const std::vector<ActionField>& fields,
                const std::vector<std::int64_t>& values) {
  const std::size_t known = std::min(fields.size(), values.size());  // else its driver refuses it
  int chosen = 0;
  for (std::size_t i = 0; i < known; ++i)
    if (fields[i].id == "axis") chosen = static_cast<int>(values[i]);
  for (std::size_t i = 0; i < known; ++i) {
    if (!fields[i].is_place) continue;
    const int axis = fields[i].of_axis >= 0 ? fields[i].of_axis : chosen;
    if (axis >= 0 && axis < max_axes)
      places.push_back({AxisId{static_cast<std::uint8_t>(axis)}, Steps(values[i])});
  }
}

template <class Request>
bool goes_despite_doubt(const Request& request) {
  if constexpr (requires { request.despite_doubt; }) return request.despite_doubt;
  return false;
}

}  // namespace

std::string spoken_name(const Catalog& catalog, int axis) {
  const AxisInfo& info = catalog.axes[ix(axis)];
  const std::string name = info.description.empty() ? "axis " + info.name : info.description;
  if (!catalog.addressed() || catalog.axes.size() > 1) return name;
  const std::string device = "device " + catalog.id();
  return info.name == catalog.id() ? device : name + " of " + device;  // the console's name on a bus
}

// ---- the count

std::vector<AxisTarget> places_of(const Catalog& catalog, const IntentBody& body) {
  std::vector<AxisTarget> places;
  if (const auto* i = std::get_if<intent::MoveTo>(&body)) return i->targets;
  if (const auto* i = std::get_if<intent::RunProgram>(&body)) return i->places;
  if (const auto* i = std::get_if<intent::Act>(&body);
      i && i->action >= 0 && i->action < static_cast<int>(catalog.actions.size()))
    add_places(places, catalog.actions[ix(i->action)].fields, i->values);
  if (const auto* i = std::get_if<intent::FeedMoves>(&body); i && !i->rows.empty())
    add_places(places, catalog.move_list.columns, i->rows.front());
  if (const auto* i = std::get_if<intent::RunInPieces>(&body); i && i->pieces && !i->pieces->all.empty())
    return i->pieces->all.front().ends_at;
  return places;
}

std::uint32_t doubtful_axes(const Catalog& catalog, const Snapshot& now, const IntentBody& body) {
  if (std::visit([](const auto& request) { return goes_despite_doubt(request); }, body)) return 0;
  std::uint32_t doubtful = 0;
  for (const AxisTarget& place : places_of(catalog, body))
    if (place.axis.index < catalog.axes.size() && now.axes[place.axis.index].trust.doubtful())
      doubtful |= 1u << place.axis.index;
  return doubtful;
}

DoubtWords words_in_steps(const Catalog& catalog, const Snapshot& now) {
  return {[&catalog, &now](AxisId axis, Steps place) {
            const bool counts = now.axes[axis.index].in_counts && !catalog.loop_word.empty();
            return fmt::format("{} {}", place.value, counts ? catalog.loop_word : catalog.step_word);
          },
          nullptr};
}

std::string_view words_of(Doubt cause, bool several) {
  switch (cause) {
    case Doubt::power_cut: return several ? "their power was cut" : "its power was cut";
    case Doubt::restarted:
      return several ? "their power was cut, or they were reset" : "its power was cut, or it was reset";
    case Doubt::after_silence:
      return several ? "they read zero after replies were missing"
                     : "it reads zero after replies were missing";
    case Doubt::reset: return several ? "they were reset" : "it was reset";
    case Doubt::killed:
      return several ? "they were stopped without a ramp at speed" : "it was stopped without a ramp at speed";
    case Doubt::slipped:
      return several ? "their encoders and counts differed" : "its encoder and its count differed";
    case Doubt::zero_since:
      return several ? "they read zero, and stood elsewhere in the last session"
                     : "it reads zero, and stood elsewhere in the last session";
    case Doubt::another:
      return several ? "their counts were changed by another program or at the controller"
                     : "its count was changed by another program or at the controller";
    case Doubt::none: break;
  }
  return "steps may be lost";
}

std::string_view brief_words_of(Doubt cause) {
  switch (cause) {
    case Doubt::power_cut: return "power was cut";
    case Doubt::restarted: return "was restarted";
    case Doubt::after_silence: return "replies were missing";
    case Doubt::reset: return "was reset";
    case Doubt::killed: return "stopped without a ramp";
    case Doubt::slipped: return "has slipped";
    case Doubt::zero_since: return "zero since the last session";
    case Doubt::another: return "count was changed";
    case Doubt::none: break;
  }
  return "steps may be lost";
}

namespace {

constexpr std::string_view may_lie_elsewhere = "may differ from before. Nothing was sent.";

std::string describe_of_one(const Catalog& catalog, const PositionTrust& trust, const AxisTarget& place,
                            const DoubtWords& words) {
  return fmt::format(
      "The position of {} cannot be trusted: {}{}. {} {} Home it, set its position, or go on just this once.",
      spoken_name(catalog, place.axis.index), words_of(trust.cause), words.when(trust.since),
      words.position(place.axis, place.value), may_lie_elsewhere);
}

std::string describe_of_several(const Catalog& catalog, const Snapshot& now,
                                const std::vector<AxisTarget>& places, const DoubtWords& words) {
  const auto trust_of = [&now](const AxisTarget& place) { return now.axes[place.axis.index].trust; };
  const PositionTrust first = trust_of(places.front());
  const bool one_cause = std::all_of(places.begin(), places.end(), [&](const AxisTarget& place) {
    return trust_of(place).cause == first.cause;
  });
  std::vector<std::string> names;
  for (const AxisTarget& place : places)
    names.push_back(one_cause ? spoken_name(catalog, place.axis.index)
                              : fmt::format("{} ({})", spoken_name(catalog, place.axis.index),
                                            brief_words_of(trust_of(place).cause)));
  const std::string why =
      one_cause ? fmt::format(": {}{}", words_of(first.cause, true), words.when(first.since)) : "";
  return fmt::format(
      "The positions of {} cannot be trusted{}. Their targets {} Home them, set their positions, or go "
      "on just this once.",
      listed(names), why, may_lie_elsewhere);
}

}  // namespace

std::string DoubtWords::when(Instant since) const {
  return time_of_day ? fmt::format(" ({})", time_of_day(since)) : std::string();
}

std::string describe_doubtful(const Catalog& catalog, const Snapshot& now, const IntentBody& body,
                              std::uint32_t doubtful, const DoubtWords& words) {
  std::vector<AxisTarget> places = places_of(catalog, body);
  std::erase_if(places, [&](const AxisTarget& p) { return (doubtful >> p.axis.index & 1u) == 0; });
  const auto same_axis = [](const AxisTarget& a, const AxisTarget& b) { return a.axis == b.axis; };
  std::stable_sort(places.begin(), places.end(),
                   [](const AxisTarget& a, const AxisTarget& b) { return a.axis.index < b.axis.index; });
  places.erase(std::unique(places.begin(), places.end(), same_axis), places.end());
  if (places.empty()) return {};
  return places.size() == 1 ? describe_of_one(catalog, now.axes[places[0].axis.index].trust, places[0], words)
                            : describe_of_several(catalog, now, places, words);
}

void go_despite_doubt(IntentBody& body) {
  std::visit(
      [](auto& request) {
        if constexpr (requires { request.despite_doubt; }) request.despite_doubt = true;
      },
      body);
}

IntentBody stands_at(const Snapshot& now, AxisId axis, Steps place) {
  const AxisState& state = now.axes[axis.index];
  if (state.position_known && state.position == place && !now.axis_moves(axis.index))
    return intent::TrustPosition(axis);
  return intent::SetPosition(axis.index, place);
}

// ---- what is stored

std::uint8_t torn_bit(const Catalog& catalog, int n) {
  const int slot = catalog.program.threads > 0 ? 0 : n;  // they share one stored text
  return slot < 0 || slot >= max_slots ? 0 : static_cast<std::uint8_t>(1u << slot);
}

int torn_program(const Catalog& catalog, const Snapshot& now, const IntentBody& body) {
  int started = -1;
  if (const auto* run = std::get_if<intent::RunProgram>(&body); run && !run->as_it_is) started = run->slot;
  if (std::holds_alternative<intent::SingleStep>(body) && now.program.run == RunState::idle)
    started = now.program.slot;
  return (now.slots_torn & torn_bit(catalog, started)) != 0 ? started : -1;
}

std::string describe_torn(const Catalog& catalog, int slot) {
  return fmt::format(
      "{} {} in the controller differs from the text sent last: its transfer was broken off, or it reads "
      "back differently. Nothing was started. Load it again, read it, or run it once as it is.",
      catalog.program.slot_word, slot);
}

std::string describe_torn_is_left(const Catalog& catalog, const Snapshot& now) {
  if (now.slots_torn == 0) return {};
  if (catalog.program.threads > 0)
    return "Load the program again before you run it: the controller does not hold the text sent last.";
  std::string which;
  int count = 0;
  for (int n = 0; n < max_slots; ++n)
    if ((now.slots_torn >> n & 1) != 0) which += fmt::format("{}{}", count++ > 0 ? ", " : "", n);
  return fmt::format("{}{} {} in the controller {} not the text sent last. Load {} again before {} run.",
                     catalog.program.slot_word, count > 1 ? "s" : "", which, count > 1 ? "are" : "is",
                     count > 1 ? "them" : "it", count > 1 ? "they are" : "it is");
}

// ---- the current

bool powerless(const Catalog& catalog, const Snapshot& now, AxisId axis) {
  return catalog.axes[axis.index].switchable && !now.axes[axis.index].enabled;
}

}  // namespace hw
