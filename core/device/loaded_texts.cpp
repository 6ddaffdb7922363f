#include "core/device/loaded_texts.h"

#include <algorithm>
#include <exception>
#include <utility>

#include "core/base/index.h"
#include "core/device/decision_log.h"
#include "core/device/places_in_text.h"
#include "core/device/sequence_travel.h"
#include "core/device/travel_check.h"
#include "core/sequence/steps_in.h"

namespace hw {
namespace {

/// What is read while the controller waits for its next command.
constexpr std::size_t longest_text = 8 * 1024;
constexpr std::ptrdiff_t most_lines = 200;
/// It is read before it is sent, while all else waits.
constexpr std::size_t longest_typed_text = 256;

sequence::Sequence frame_in_steps(const Catalog& catalog) {
  sequence::Sequence frame;
  for (const AxisInfo& axis : catalog.axes) frame.axes.push_back({axis.name, 1});
  return frame;
}

bool some_count_is_doubtful(const Snapshot& now) {
  return std::any_of(now.axes.begin(), now.axes.begin() + now.axis_count,
                     [](const AxisState& axis) { return axis.trust.doubtful(); });
}

/// Drops what comes behind the first step that no block describes: it may set a count. False: there was one.
bool keep_known(sequence::StepList& steps, const sequence::Sequence& of) {
  for (auto step = steps.begin(); step != steps.end(); ++step) {
    bool known = !std::holds_alternative<sequence::Custom>(step->body);
    if (const auto* pen = std::get_if<sequence::Pen>(&step->body)) {
      sequence::StepList routine = pen->down ? of.pen_down : of.pen_up;
      known = keep_known(routine, {});
    } else if (sequence::StepList* inner = sequence::steps_in(*step)) {
      known = keep_known(*inner, of);
      if (!known) ++step;  // its own begin is known
    }
    if (known) continue;
    steps.erase(step, steps.end());
    return false;
  }
  return true;
}

bool only_distances(const sequence::StepList& steps) {
  return std::all_of(steps.begin(), steps.end(), [](const sequence::Step& step) {
    const auto* move = std::get_if<sequence::Move>(&step.body);
    return move && move->relative;
  });
}

/// Adds what the text names beside its known steps, as moves of their own.
void add_places(sequence::Sequence& to, const Language& language, std::string_view text, int start) {
  const auto* tells = dynamic_cast<const PlacesInText*>(&language);
  if (!tells) return;
  for (const AxisTarget& place : tells->places_in(text, start)) {
    if (place.axis.index >= to.axes.size()) continue;
    sequence::Move move;
    move.to[place.axis.index] = static_cast<double>(place.value.value);
    to.steps.push_back({move});
  }
}

}  // namespace

void LoadedTexts::loaded(const intent::LoadProgram& load) {
  const int slot = place_of(load.slot);
  if (!keeps(slot)) return;
  const bool is_long =
      load.text.size() > longest_text || std::count(load.text.begin(), load.text.end(), '\n') > most_lines;
  loads_[ix(slot)] = {is_long ? std::string() : load.text, {}};
}

void LoadedTexts::forget(const IntentBody& body) {
  int slot = -1;
  if (const auto* load = std::get_if<intent::LoadProgram>(&body)) slot = place_of(load->slot);
  if (const auto* clear = std::get_if<intent::ClearProgram>(&body)) slot = place_of(clear->slot);
  if (keeps(slot))
    loads_[ix(slot)] = {};
  else
    forget();
}

/// Blocks are program 0 where one text holds them all.
std::optional<sequence::Sequence> LoadedTexts::read(const std::string& text, int start) const {
  try {
    sequence::Sequence known = frame_in_steps(catalog_);
    bool whole = false;
    if (catalog_.program.threads == 0 || start == 0) {
      auto read = language_->read(text, known, catalog_);
      if (read) known = std::move(read->sequence);
      whole = read && keep_known(known.steps, known);
    }
    if (!whole) add_places(known, *language_, text, start);
    return known;
  } catch (const std::exception& defect) {  // from a library: nothing is known of it then
    pump_log().debug("a loaded program could not be read: {}", defect.what());
    return {};
  }
}

std::optional<PastTravel> LoadedTexts::past_travel_of(const std::string& text, const Snapshot& now) const {
  const auto end = now.axes.begin() + now.axis_count;
  const bool some = std::any_of(now.axes.begin(), end, [](const AxisState& a) { return a.travel_holds(); });
  if (!language_ || !some || text.size() > longest_typed_text) return {};
  try {
    auto read = language_->read(text, frame_in_steps(catalog_), catalog_);
    if (!read) return {};
    keep_known(read->sequence.steps, read->sequence);
    // A remark says that part of it was assumed: perhaps that places are absolute.
    if (!read->remarks.empty() && !only_distances(read->sequence.steps)) return {};
    auto past = past_travel(catalog_, now, intent::MoveTo(places_of_run(read->sequence, catalog_, now)));
    if (past) past->of = PastTravel::Of::text;
    return past;
  } catch (const std::exception& defect) {  // from a library
    pump_log().debug("a text could not be read: {}", defect.what());
    return {};
  }
}

std::vector<AxisTarget> LoadedTexts::places_in_doubt(int slot, const Snapshot& now) {
  if (!language_ || !keeps(place_of(slot)) || !some_count_is_doubtful(now)) return {};
  Load& load = loads_[ix(place_of(slot))];
  if (load.text.empty()) return {};
  auto known = load.known.find(slot);
  if (known == load.known.end()) known = load.known.emplace(slot, read(load.text, slot)).first;
  if (!known->second) return {};
  std::vector<AxisTarget> places = places_of_run(*known->second, catalog_, now);
  std::erase_if(places,
                [&now](const AxisTarget& place) { return !now.axes[place.axis.index].trust.doubtful(); });
  return places;
}

}  // namespace hw
