#include "core/emulation/track_keeper.h"

#include "core/base/index.h"

namespace hw {

void TrackKeeper::look(Instant now) {
  if (every_ == Duration{}) return;
  MachineTruth truth;
  emulator_.report_truth(truth);
  BenchView view;
  emulator_.look(view);
  RehearsedPlace place;
  place.t = seconds(now.time_since_epoch());
  for (int i = 0; i < truth.axis_count; ++i) place.position[ix(i)] = truth.axes[ix(i)].position.value;
  place.outputs = view.outputs;
  // At an event nothing may have moved yet that begins with it: that is seen a little later.
  const bool rests = due_ == now && track_.rests(place) && truth.moving() == 0;
  due_ = rests ? std::nullopt : std::optional(now + every_ * track_.every());
  track_.add(place);
}

}  // namespace hw
