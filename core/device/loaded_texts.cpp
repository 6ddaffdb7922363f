#include "core/device/loaded_texts.h"

#include <algorithm>

#include "core/base/index.h"
#include "core/device/sequence_travel.h"

namespace hw {
namespace {

sequence::Sequence frame_in_steps(const Catalog& catalog) {
  sequence::Sequence frame;
  for (const AxisInfo& axis : catalog.axes) frame.axes.push_back({axis.name, 1});
  return frame;
}

bool some_count_is_doubtful(const Snapshot& now) {
  return std::any_of(now.axes.begin(), now.axes.begin() + now.axis_count,
                     [](const AxisState& axis) { return axis.trust.doubtful(); });
}

}  // namespace

void LoadedTexts::loaded(const intent::LoadProgram& load) {
  if (const int slot = place_of(load.slot); keeps(slot)) texts_[ix(slot)] = load.text;
}

void LoadedTexts::forget(const IntentBody& body) {
  int slot = -1;
  if (const auto* load = std::get_if<intent::LoadProgram>(&body)) slot = place_of(load->slot);
  if (const auto* clear = std::get_if<intent::ClearProgram>(&body)) slot = place_of(clear->slot);
  if (keeps(slot))
    texts_[ix(slot)].clear();
  else
    forget();
}

std::vector<AxisTarget> LoadedTexts::places_in_doubt(int slot, const Snapshot& now) const {
  slot = place_of(slot);
  if (!language_ || !keeps(slot) || texts_[ix(slot)].empty()) return {};
  if (!some_count_is_doubtful(now)) return {};
  const auto read = language_->read(texts_[ix(slot)], frame_in_steps(catalog_), catalog_);
  if (!read) return {};
  std::vector<AxisTarget> places = places_of_run(read->sequence, catalog_, now);
  std::erase_if(places,
                [&now](const AxisTarget& place) { return !now.axes[place.axis.index].trust.doubtful(); });
  return places;
}

}  // namespace hw
