// The laws of motion: stop, asked, once.
#include <algorithm>
#include <utility>

#include <fmt/core.h>

#include "core/base/index.h"
#include "tests/simulation/judge.h"

namespace hw::simulation {
namespace {
constexpr Duration remembered = std::chrono::seconds(15);
}

void Judge::machine_is(int device, const MachineTruth& truth) {
  if (devices_.size() <= static_cast<std::size_t>(device))
    devices_.resize(static_cast<std::size_t>(device) + 1);
  DeviceCase& d = at(device);
  if (truth.program || truth.moving() != 0) d.moved_last = scheduler_.now();
  d.truth = truth;
  if (!truth.program) d.stands_unseen = false, d.goes_on_unseen = {};
  for (int a = 0; a < truth.axis_count; ++a) {
    AxisCase& axis = d.axes[ix(a)];
    const AxisTruth was = axis.truth;
    axis.truth = truth.axes[ix(a)];
    if (axis.stopped && axis.truth.ramp > axis.stopped->ramp &&
        scheduler_.now() <= axis.stopped->at + stop_after_hurt)
      axis.stopped->ramp = axis.truth.ramp;
    if (axis.truth.position != was.position || axis.stands.empty()) remember(axis, axis.truth.position);
    if (axis.truth.moving && !was.moving) {
      axis.began_at = was.position;
      axis.began_moving = scheduler_.now();
      axis.whole.reset();
      if (trace_ != nullptr)
        remark(fmt::format("device {}: axis {} begins at {}", device, a, was.position.value));
      began(device, a);
    } else if (!axis.truth.moving && was.moving) {
      rested(device, a);
    }
  }
}

void Judge::remember(AxisCase& axis, Steps position) const {
  const Instant now = scheduler_.now();
  while (axis.stands.size() > 1 && axis.stands[1].at < now - remembered) axis.stands.pop_front();
  if (!axis.stands.empty() && axis.stands.back().at == now)
    axis.stands.back().position = position;
  else
    axis.stands.push_back({now, position});
}

void Judge::keep_excuses(DeviceCase& d) const {
  const Instant now = scheduler_.now();
  std::erase_if(d.excuses, [&](Excuse& e) {
    const IntentOutcome* outcome = d.session && e.id != 0 ? d.session->known().outcome_of(e.id) : nullptr;
    if (outcome != nullptr && outcome->state == IntentState::refused) return true;  // nothing was sent
    const bool waits =
        e.id != 0 && d.session &&
        (outcome ? outcome->state == IntentState::pending : !d.session->known().forgotten(e.id));
    const bool in_pieces = d.session && d.session->known().pieces.running && e.axes == all_axes;
    if (waits || in_pieces || (d.truth.moving() & e.axes) != 0 || d.truth.program) e.alive = now;
    const Instant hurt = std::max(faults_.out.hurt(), faults_.in.hurt());
    if (hurt != Instant{}) e.alive = std::max(e.alive, std::min(now, hurt + line_is_cleaned));
    return now - e.alive > excuse_lasts + questions_between_motions * lateness();
  });
}

bool Judge::excused(const DeviceCase& d, int axis) const {
  return std::any_of(d.excuses.begin(), d.excuses.end(),
                     [axis](const Excuse& e) { return (e.axes >> axis & 1u) != 0; });
}

void Judge::began(int device, int a) {
  DeviceCase& d = at(device);
  if (!d.session || excused(d, a)) return;
  const AxisCase& axis = d.axes[ix(a)];
  const Instant now = scheduler_.now();
  // What was to hold it may let it go on, from one command to the next, until it is killed.
  constexpr Duration longest_unseen = std::chrono::seconds(8);
  if (d.stands_unseen && d.goes_on_unseen == Instant{}) d.goes_on_unseen = now;
  if (d.stands_unseen && now < d.goes_on_unseen + longest_unseen) {
    for (AxisCase& each : d.axes)
      if (each.stopped) each.stopped->at = now;
    return;
  }
  if (!axis.stopped)
    return accuse("asked",
                  fmt::format("Device {}: axis {} begins to move, and nobody has asked for it.", device, a));
  if (now > latest_stop(device, axis) + lateness())
    accuse("stop", fmt::format("Device {}: axis {} begins to move {:.3f} s after it was stopped.", device, a,
                               seconds(now - axis.stopped->at)));
}

void Judge::rested(int device, int a) {
  DeviceCase& d = at(device);
  if (trace_ != nullptr)
    remark(fmt::format("device {}: axis {} rests at {}", device, a, d.axes[ix(a)].truth.position.value));
  const std::int64_t made = (d.axes[ix(a)].truth.position - d.axes[ix(a)].began_at).value;
  d.axes[ix(a)].whole = was_whole(d, a, made);
  d.axes[ix(a)].ended_motion_began = d.axes[ix(a)].began_moving;
  if (made == 0) return;
  const auto is_program = [](const Excuse& e) { return e.axes == all_axes; };  // its ways are its own
  if (std::any_of(d.excuses.begin(), d.excuses.end(), is_program)) return;
  const Instant began = d.axes[ix(a)].began_moving;
  for (const Excuse& e : d.excuses)
    if ((e.axes >> a & 1u) != 0 && e.distance.value == made && e.asked <= began && ++d.made[made] > 1 &&
        faults_.out.hurt() < e.asked)
      accuse("once", fmt::format("Device {}: axis {} makes a way of {} twice, which was asked for once.",
                                 device, a, made));
}

/// None: that may be anybody's motion.
std::optional<bool> Judge::was_whole(const DeviceCase& d, int a, std::int64_t made) const {
  const Excuse* only = nullptr;
  const Instant may_be_set =
      d.axes[ix(a)].counts_anew + excuse_lasts + questions_between_motions * lateness();
  if (may_be_set >= d.axes[ix(a)].began_moving) return std::nullopt;
  for (const Excuse& e : d.excuses) {
    if (e.axes == all_axes || e.homes) return std::nullopt;
    if ((e.axes >> a & 1u) == 0) continue;
    if (only) return std::nullopt;
    only = &e;
  }
  if (!only || only->distance.value == 0 || only->asked > d.axes[ix(a)].began_moving) return std::nullopt;
  return made == only->distance.value;
}

// What ends a stored program takes steps (hold, ramp, end), each behind what was seen of the one before.
Instant Judge::carries_a_stop(const Stopped& stopped) const {
  const Instant out = faults_.carries_since(scheduler_.now());
  return stopped.of_program ? std::max(out, faults_.in.hurt()) : out;
}

void Judge::judge_stops(int device) {
  const DeviceCase& d = at(device);
  const Instant now = scheduler_.now();
  for (int a = 0; a < d.truth.axis_count; ++a) {
    const AxisCase& axis = d.axes[ix(a)];
    if (!axis.stopped || !axis.truth.moving || excused(d, a)) continue;
    if (now <= latest_stop(device, axis) + axis.stopped->ramp) continue;
    const Instant carries = carries_a_stop(*axis.stopped);
    const bool hurt = carries >= axis.stopped->at;
    accuse("stop",
           fmt::format(
               "Device {}: axis {} still moves {:.3f} s after it was stopped{}.", device, a,
               seconds(now - axis.stopped->at),
               hurt ? fmt::format(", {:.3f} s after the wire could carry it", seconds(now - carries)) : ""));
  }
}

/// When the stop of that axis has taken effect, but for its ramp.
Instant Judge::latest_stop(int device, const AxisCase& axis) const {
  const Duration others = other_device_stops * (devices_.size() - 1);
  const bool doubtful = axis.stopped->doubtful || !prompt();
  const Duration bound = (doubtful ? stop_on_doubtful_wire : stop_when_prompt_) + others;
  const std::optional<Instant>& seen = at(device).first_connected;
  const Duration after_hurt = seen && *seen < axis.stopped->at ? stop_after_hurt : stop_of_the_unseen;
  return std::max(axis.stopped->at + bound, carries_a_stop(*axis.stopped) + after_hurt);
}

/// Nothing has been wrong with the wire for a while.
bool Judge::prompt() const {
  const Instant now = scheduler_.now();
  return lateness() == Duration{} &&
         now > std::max(faults_.carries_since(now), faults_.in.hurt()) + wire_is_prompt_again;
}

// A stop kills only when it was asked for twice, or at once: the console repeats it in the same form.
void Judge::judge_kill(int device) {
  DeviceCase& d = at(device);
  if (!d.session || facts_.kill.empty() || !d.received.ends_with(facts_.kill)) return;
  if (const std::string id = d.session->catalog().id(); !id.empty()) {  // everybody on the line receives it
    const std::string_view addressed(d.received.data(), d.received.size() - facts_.kill.size());
    if (!addressed.ends_with("@" + id) && !addressed.ends_with("@00")) return;
  }
  const bool fast = std::any_of(d.axes.begin(), d.axes.end(), [](const AxisCase& axis) {
    return axis.stopped && axis.truth.moving && axis.truth.ramp > Millis(50);
  });
  if (!fast) return;
  for (std::size_t i = 0; i < d.stops.size(); ++i) {
    if (d.stops[i].at_once) return;
    for (std::size_t k = 0; k < i; ++k)
      if (d.stops[k].axes == d.stops[i].axes) return;
  }
  accuse("stop", fmt::format("Device {} is stopped without a ramp, and nobody has asked for that.", device));
}

/// How late what is on a slow wire may be.
Duration Judge::lateness() const {
  const Instant now = scheduler_.now();
  const auto of = [now](const WayFaults& way) {
    constexpr int longest_answer = 20;  // bytes
    const Duration slow =
        std::max(now < way.slow_until + 3 * way.delay ? way.delay : Duration{}, way.late_by(now));
    return slow +
           (now < way.gaps_until + 3 * longest_answer * way.gap ? longest_answer * way.gap : Duration{});
  };
  Duration late = of(faults_.in) + of(faults_.out);
  if (now < faults_.slow_until + faults_.slow_by) late += faults_.slow_by;
  return late;
}

}  // namespace hw::simulation
