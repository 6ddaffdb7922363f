#include "core/session/track_together.h"

#include <algorithm>
#include <utility>

#include "core/base/index.h"
#include "core/emulation/emulator.h"

namespace hw {

TrackTogether::TrackTogether(Scheduler& scheduler, Benches benches, std::size_t with_tool)
    : scheduler_(scheduler),
      benches_(std::move(benches)),
      with_tool_(with_tool),
      zero_(scheduler.now()),
      due_(scheduler, [this] { look(); }) {
  look();
}

void TrackTogether::look() {
  RehearsedPlace place;
  std::uint32_t moving = 0;
  for (std::size_t a = 0; a < std::min(benches_.size(), ix(max_axes)); ++a) {
    if (!benches_[a]) continue;
    MachineTruth truth;
    benches_[a]->emulator().report_truth(truth);
    place.position[a] = truth.axes[0].position.value;
    moving |= (truth.moving() & 1u) << a;
  }
  place.t = seconds(scheduler_.now() - zero_);
  const std::uint32_t moved = std::exchange(moving_, moving);
  if (moved == 0 && moving != 0) moves_since_ = place.t;
  if (due_.armed() && moved == moving) return;
  BenchView view;
  if (with_tool_ < benches_.size() && benches_[with_tool_]) benches_[with_tool_]->emulator().look(view);
  place.outputs = view.outputs;
  due_.arm(scheduler_.now() + from_seconds(track_seen_every_s) * track_.every());
  track_.add(place);
}

}  // namespace hw
