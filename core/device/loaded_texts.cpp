#include "core/device/loaded_texts.h"

#include <algorithm>
#include <exception>
#include <utility>

#include "core/base/index.h"
#include "core/device/decision_log.h"
#include "core/device/places_in_text.h"
#include "core/device/scaled_numbers.h"
#include "core/device/sequence_travel.h"
#include "core/device/settings_in_text.h"
#include "core/sequence/steps_in.h"

namespace hw {
namespace {

/// In bytes: reading delays the controller's next command.
constexpr std::size_t longest_text = 8 * 1024;
constexpr std::ptrdiff_t most_lines = 200;

sequence::Sequence frame_in_steps(const Catalog& catalog) {
  sequence::Sequence frame;
  for (const AxisInfo& axis : catalog.axes) frame.axes.push_back({axis.name, 1});
  return frame;
}

bool some_count_is_doubtful(const Snapshot& now) {
  return std::any_of(now.axes.begin(), now.axes.begin() + now.axis_count,
                     [](const AxisState& axis) { return axis.trust.doubtful(); });
}

/// Drops the steps after the first that no block describes, which may set a count. False: there was one.
bool keep_known(sequence::StepList& steps, const sequence::Sequence& of) {
  for (auto step = steps.begin(); step != steps.end(); ++step) {
    bool known = !std::holds_alternative<sequence::Custom>(step->body);
    if (const auto* pen = std::get_if<sequence::Pen>(&step->body)) {
      sequence::StepList routine = pen->down ? of.pen_down : of.pen_up;
      known = keep_known(routine, {});
    } else if (sequence::StepList* inner = sequence::steps_in(*step)) {
      known = keep_known(*inner, of);
      if (!known) ++step;  // the places before it are known
    }
    if (known) continue;
    steps.erase(step, steps.end());
    return false;
  }
  return true;
}

/// Texts that only set speeds move nothing.
void drop_settings(sequence::StepList& steps, const Language& language) {
  const auto* settings = dynamic_cast<const SettingsInText*>(&language);
  if (!settings) return;
  std::erase_if(steps, [settings](const sequence::Step& step) {
    const auto* text = std::get_if<sequence::Custom>(&step.body);
    return text && settings->only_sets(text->text);
  });
  for (sequence::Step& step : steps)
    if (sequence::StepList* inner = sequence::steps_in(step)) drop_settings(*inner, language);
}

/// Adds the places that the text names beside its known steps, as separate moves.
void add_places(sequence::Sequence& to, const Language& language, std::string_view text, int start) {
  const auto* in_text = dynamic_cast<const PlacesInText*>(&language);
  if (!in_text) return;
  for (const AxisTarget& place : in_text->places_in(text, start)) {
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

/// Blocks are program 0 if one text holds all programs.
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
  } catch (const std::exception& defect) {  // from a library: the program is treated as unknown
    pump_log().debug("a loaded program could not be read: {}", defect.what());
    return {};
  }
}

std::vector<AxisTarget> LoadedTexts::places_of(int slot, const Snapshot& now) {
  if (!language_ || !keeps(place_of(slot))) return {};
  Load& load = loads_[ix(place_of(slot))];
  if (load.text.empty()) return {};
  auto known = load.known.find(slot);
  if (known == load.known.end()) known = load.known.emplace(slot, read(load.text, slot)).first;
  if (!known->second) return {};
  return places_of_run(*known->second, catalog_, now);
}

/// Only for a text that was read completely and needs no assumptions, such as a mode that an earlier program
/// may have set.
std::optional<ProgramWays> LoadedTexts::ways_of(int slot) const {
  if (!language_ || !keeps(place_of(slot)) || (catalog_.program.threads > 0 && slot != 0)) return {};
  const std::string& text = loads_[ix(place_of(slot))].text;
  if (text.empty() || dynamic_cast<const ScaledNumbers*>(language_)) return {};
  try {
    auto read = language_->read(text, frame_in_steps(catalog_), catalog_);
    if (!read || !read->remarks.empty()) return {};
    drop_settings(read->sequence.steps, *language_);
    return hw::ways_of(read->sequence, catalog_);
  } catch (const std::exception& defect) {  // from a library: nothing is known of it then
    pump_log().debug("a loaded program could not be read: {}", defect.what());
    return {};
  }
}

std::vector<AxisTarget> LoadedTexts::places_in_doubt(int slot, const Snapshot& now) {
  if (!some_count_is_doubtful(now)) return {};
  std::vector<AxisTarget> places = places_of(slot, now);
  std::erase_if(places,
                [&now](const AxisTarget& place) { return !now.axes[place.axis.index].trust.doubtful(); });
  return places;
}

}  // namespace hw
