#include "gui/model/position_memory.h"

#include <algorithm>

namespace hw::gui {

static TwoClocks at(Instant clock) { return {clock, std::chrono::system_clock::now()}; }

Result<> PositionMemory::keep_under(KeptPositions store, std::string key, Instant clock) {
  store_ = std::move(store);
  key_ = std::move(key);
  auto kept = store_.load(key_, at(clock));
  if (!kept) return fail(kept.error());
  recalled_ = std::move(*kept);
  return {};
}

void PositionMemory::follow(const Snapshot& now, Instant clock, const Send& send, Worker& worker) {
  if (!store_.enabled() || !now.link.connected()) return;
  if (!recalled_.empty()) return recall(now, send);
  note(now, clock);
  if (due_in(clock) == 0) keep_now(clock, worker);
}

// Nothing is noted before this: it would be a bare count of unknown origin.
void PositionMemory::recall(const Snapshot& now, const Send& send) {
  const auto begin = now.axes.begin(), end = begin + now.axis_count;
  if (begin == end || !std::all_of(begin, end, [](const AxisState& a) { return a.position_known; })) return;
  send(intent::RecallPositions(std::exchange(recalled_, {})));
}

/// While axes move, the former place is kept: after a crash the different count shows that it is out of date.
void PositionMemory::note(const Snapshot& now, Instant clock) {
  axes_ = now.axis_count;
  for (int i = 0; i < axes_; ++i) {
    const AxisState& axis = now.axes[i];
    if (!axis.position_known || now.axis_moves(i)) continue;
    const KeptPosition stands{true, axis.commanded(), axis.trust};
    KeptPosition& noted = noted_[static_cast<std::size_t>(i)];
    if (noted == stands) continue;
    noted = stands;
    changed_at_ = clock;
  }
}

void PositionMemory::keep_now(Instant clock, Worker& worker) {
  if (!store_.enabled() || noted_ == saved_) return;
  saved_ = noted_;
  worker.run(
      [store = store_, key = key_, now = at(clock),
       axes = std::vector<KeptPosition>(noted_.begin(), noted_.begin() + axes_)] {
        return store.save(key, axes, now);  // a full disk is reported on save; here it would only nag
      },
      [](Result<>) {}, alive_);
}

double PositionMemory::due_in(Instant clock) const {
  if (noted_ == saved_) return -1;
  return std::max(0.0, seconds(kept_after - (clock - changed_at_)));
}

}  // namespace hw::gui
