#include "core/session/snapshot_look.h"

#include <algorithm>
#include <cmath>

namespace hw {

// The rate is counted every two seconds, and counts of an equal rate differ a little.
static bool same_rate(const LinkHealth& a, const LinkHealth& b) {
  const float x = a.polls_per_second, y = b.polls_per_second;
  return std::abs(x - y) <= 0.15f * std::max(x, y);
}

// All fields are named here and below, so that code with a new field compiles only once it is decided whether
// the user sees it. The motion under way at a loss, and its time, change only with the link's state; the
// counts change with the rate.
static bool same_link(const LinkHealth& a, const LinkHealth& b) {
  const auto& [state, round_trip, polls_per_second, misses_in_a_row, timeouts, unparsed_bytes, lost_at,
               next_attempt, attempts, sentence, when_lost, jog_ends] = a;
  return state == b.state && sentence == b.sentence && next_attempt == b.next_attempt &&
         jog_ends == b.jog_ends && same_rate(a, b);
}

static bool same_axes(const Snapshot& a, const Snapshot& b) {
  for (int i = 0; i < a.axis_count; ++i) {
    AxisState x = a.axes[i], y = b.axes[i];
    x.seen_at = y.seen_at = Instant{};
    if (!(x == y)) return false;
  }
  return a.axis_count == b.axis_count;
}

bool looks_same(const Snapshot& a, const Snapshot& b) {
  const auto& [sequence, at, link, identity, axis_count, axes, inputs, inputs_known, outputs, outputs_known,
               io_seen_at, inputs_asked_at, analog, analog_known, analog_seen_at, program, threads,
               queue_free, queue_known, window, feed, pieces, transfer, jog_guard, readouts, readouts_known,
               readouts_seen_at, variables, variables_known, slot_bytes_used, slots_torn, params,
               unsaved_setup, unsaved_programs, working, restarts, store_count, program_changes,
               program_changed_by, poll_period, outcomes, notice] = a;
  const bool no_rings = !window.rings_known && !b.window.rings_known;
  return same_axes(a, b) && same_link(link, b.link) && identity == b.identity && inputs == b.inputs &&
         inputs_known == b.inputs_known && outputs == b.outputs && outputs_known == b.outputs_known &&
         analog == b.analog && analog_known == b.analog_known && program == b.program &&
         threads == b.threads && queue_free == b.queue_free && queue_known == b.queue_known &&
         (no_rings || window == b.window) && feed == b.feed && pieces == b.pieces && transfer == b.transfer &&
         jog_guard == b.jog_guard && readouts == b.readouts && readouts_known == b.readouts_known &&
         variables == b.variables && variables_known == b.variables_known &&
         slot_bytes_used == b.slot_bytes_used && slots_torn == b.slots_torn && params == b.params &&
         unsaved_setup == b.unsaved_setup && unsaved_programs == b.unsaved_programs && working == b.working &&
         restarts == b.restarts && store_count == b.store_count && program_changes == b.program_changes &&
         outcomes == b.outcomes && notice == b.notice;
}

}  // namespace hw
