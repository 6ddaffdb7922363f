#include "core/device/track.h"

#include <algorithm>
#include <cmath>

#include "core/base/index.h"

namespace hw {
namespace {

bool same_stand(const RehearsedPlace& a, const RehearsedPlace& b) {
  return a.position == b.position && a.outputs == b.outputs;
}

}  // namespace

bool Track::rests(const RehearsedPlace& place) const {
  return !places_.empty() && same_stand(places_.back(), place);
}

void Track::add(const RehearsedPlace& place) {
  const std::size_t size = places_.size();
  if (size >= 2 && same_stand(places_[size - 1], place) && same_stand(places_[size - 2], place))
    places_.back() = place;
  else
    places_.push_back(place);
  if (places_.size() > most_places) thin_out();
}

/// Drops every other place, and halves the rate from here on. Places at rest and at switched outputs are
/// kept, as far as there is room.
void Track::thin_out() {
  const auto stays = [this](std::size_t i) {
    if (i == 0 || i + 1 == places_.size()) return true;
    const RehearsedPlace &before = places_[i - 1], &here = places_[i], &after = places_[i + 1];
    return here.position == before.position || here.position == after.position ||
           here.outputs != before.outputs;
  };
  std::vector<RehearsedPlace> kept;
  kept.reserve(most_places + 1);
  for (std::size_t i = 0; i < places_.size(); ++i)
    if (i % 2 == 0 || stays(i)) kept.push_back(places_[i]);
  every_ *= 2;
  if (kept.size() * 4 > most_places * 3) {  // thinning would hardly help
    std::size_t n = 0;
    for (std::size_t i = 0; i < kept.size(); i += 2) kept[n++] = kept[i];
    kept.resize(n);
  }
  places_ = std::move(kept);
}

int thinned_to(std::span<const RehearsedPlace> track, double every_s) {
  double longest = 0;
  for (std::size_t i = 1; i < track.size(); ++i)
    if (track[i].position != track[i - 1].position) longest = std::max(longest, track[i].t - track[i - 1].t);
  return every_s > 0 ? std::max(1, static_cast<int>(std::lround(longest / every_s))) : 1;
}

}  // namespace hw
