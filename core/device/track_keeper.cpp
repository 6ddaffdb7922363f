#include "core/device/track_keeper.h"

#include "core/base/index.h"

namespace hw {
namespace {

constexpr std::size_t most_places = 200'000;

bool same_stand(const RehearsedPlace& a, const RehearsedPlace& b) {
  return a.position == b.position && a.outputs == b.outputs;
}

}  // namespace

void TrackKeeper::look(Instant now) {
  if (every_ == Duration{}) return;
  MachineTruth truth;
  emulator_.tell_truth(truth);
  BenchView view;
  emulator_.look(view);
  RehearsedPlace place;
  place.t = seconds(now.time_since_epoch());
  for (int i = 0; i < truth.axis_count; ++i) place.position[ix(i)] = truth.axes[ix(i)].position.value;
  place.outputs = view.outputs;
  // At an event nothing may have moved yet that begins with it: that is seen a little later.
  const bool by_itself = due_ == now, rests = !track_.empty() && same_stand(track_.back(), place);
  due_ = by_itself && rests && truth.moving() == 0 ? std::nullopt : std::optional(now + every_);
  // Of a rest its begin and its end are enough.
  const std::size_t size = track_.size();
  if (size >= 2 && same_stand(track_[size - 1], place) && same_stand(track_[size - 2], place))
    track_.back() = place;
  else
    track_.push_back(place);
  if (track_.size() > most_places) thin_out();
}

/// Every other one, and half as often from here on.
void TrackKeeper::thin_out() {
  std::size_t kept = 0;
  for (std::size_t i = 0; i < track_.size(); i += 2) track_[kept++] = track_[i];
  track_.resize(kept);
  every_ *= 2;
}

}  // namespace hw
