// The laws of what is shown and told: end, true.
#include <algorithm>

#include <fmt/core.h>

#include "core/base/index.h"
#include "tests/simulation/judge.h"

namespace hw::simulation {

void Judge::judge_fates(int device) {
  DeviceCase& d = at(device);
  const Snapshot& shown = d.session->known();
  const Instant now = scheduler_.now();
  std::erase_if(d.intents, [&](const Intended& i) {
    const IntentFate* fate = shown.fate_of(i.id);
    return fate ? fate->fate != Fate::pending : shown.forgotten(i.id);
  });
  if (d.intents.empty()) return;
  const Intended& oldest = d.intents.front();
  const Instant since = std::max(oldest.at, std::max(faults_.carries_since(now), faults_.in.hurt()));
  if (now > since + longest_fate + 5 * lateness())
    accuse("end", fmt::format("Device {}: intent {} has had no fate for {:.1f} s.", device, oldest.id,
                              seconds(now - oldest.at)));
}

// A position that is shown as live was the controller's at some moment of its age and of its way here.
void Judge::judge_positions(int device) {
  const DeviceCase& d = at(device);
  const Snapshot& shown = d.session->known();
  const Instant now = scheduler_.now();
  if (!shown.link.connected()) return;
  if (now < std::max(faults_.in.spoilt(), faults_.out.spoilt()) + spoilt_number_shows + lateness()) return;
  for (int a = 0; a < std::min(shown.axis_count, d.truth.axis_count); ++a) {
    const AxisState& s = shown.axes[ix(a)];
    const AxisCase& axis = d.axes[ix(a)];
    if (!s.position_known || s.in_counts || is_stale(s.seen_at, now, shown.poll_period)) continue;
    const Instant from = s.seen_at - answer_on_wire - lateness();
    Steps low = axis.truth.position, high = low;
    for (auto stand = axis.stands.rbegin(); stand != axis.stands.rend(); ++stand) {
      low = std::min(low, stand->position), high = std::max(high, stand->position);
      if (stand->at <= from) break;
    }
    const Steps told = s.commanded();
    if (told < low || told > high)
      accuse("true",
             fmt::format("Device {}: axis {} is shown at {} (seen {:.3f} s ago); it was between {} and {}.",
                         device, a, told.value, seconds(now - s.seen_at), low.value, high.value));
  }
}

void Judge::judge_trust(int device) {
  const DeviceCase& d = at(device);
  const Snapshot& shown = d.session->known();
  const Instant now = scheduler_.now();
  if (shown.link.state != LinkState::good) return;
  const Instant quiet = std::max(faults_.carries_since(now), faults_.in.hurt());
  for (int a = 0; a < std::min(shown.axis_count, d.truth.axis_count); ++a) {
    const AxisCase& axis = d.axes[ix(a)];
    if (!axis.restarted || now < std::max(quiet, *axis.restarted) + restart_shows) continue;
    const AxisState& s = shown.axes[ix(a)];
    if (s.position_known && !s.trust.doubtful() && s.trust.kind != Trust::homed)
      accuse("true", fmt::format("Device {}: the position of axis {} is trusted {:.1f} s after a restart.",
                                 device, a, seconds(now - *axis.restarted)));
  }
}

// A switch that nothing operates is not shown as hit.
void Judge::judge_limits(int device) {
  DeviceCase& d = at(device);
  const Snapshot& shown = d.session->known();
  const Instant now = scheduler_.now();
  if (!d.session->bench()) return;
  BenchView view;
  d.session->bench()->look(view);
  const std::uint32_t operated = view.limits_minus | view.limits_plus;
  for (int a = 0; a < std::min(shown.axis_count, d.truth.axis_count); ++a) {
    AxisCase& axis = d.axes[ix(a)];
    if ((operated >> a & 1u) != 0) axis.limit_operated = now;
    const AxisState& s = shown.axes[ix(a)];
    if (!shown.link.connected() || !s.limits_known || !(s.limit_minus || s.limit_plus)) continue;
    const Instant since = std::max({axis.limit_operated, faults_.in.spoilt(), faults_.out.spoilt()});
    if (now > since + limit_shows + lateness())
      accuse("true", fmt::format("Device {}: axis {} is shown at a limit that nothing operates.", device, a));
  }
}

// Where the wire carries and the controller has power, there is a connection.
void Judge::judge_link(int device) {
  DeviceCase& d = at(device);
  const Instant now = scheduler_.now();
  if (d.session->known().link.connected() || !d.truth.powered) d.unconnected_since = now;
  const Instant since = std::max({d.unconnected_since, faults_.carries_since(now), faults_.in.hurt()});
  if (now > since + longest_connect + 5 * lateness())
    accuse("end", fmt::format("Device {}: no connection {:.0f} s after the wire was good.", device,
                              seconds(now - since)));
}

}  // namespace hw::simulation
