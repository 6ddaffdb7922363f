// What is asked, and the book that is kept of it.
#include "tests/simulation/judge.h"

#include <algorithm>

#include <fmt/core.h>
#include <malloc.h>

namespace hw::simulation {
namespace {

constexpr Duration look_every = Millis(20);
constexpr int memory_every = 50;  // looks

std::size_t memory_in_use() {
  const auto heap = mallinfo2();
  return heap.uordblks + heap.hblkhd;
}

}  // namespace

Judge::Judge(Scheduler& scheduler, const WireFaults& faults, const ModelFacts& facts, bool obeys_mailbox)
    : scheduler_(scheduler),
      faults_(faults),
      facts_(facts),
      timer_(scheduler, [this] { tick(); }),
      stop_when_prompt_(obeys_mailbox ? stop_in_window : stop_on_prompt_wire),
      memory_at_start_(memory_in_use()) {
  timer_.arm(scheduler.now() + look_every);
}

void Judge::accuse(std::string law, std::string sentence) {
  if (finding_ || law == left_out_) return;
  finding_ = Finding{std::move(law), scheduler_.now(), std::move(sentence)};
}

void Judge::tick() {
  for (int device = 0; device < static_cast<int>(devices_.size()); ++device) {
    keep_excuses(at(device));
    judge_stops(device);
    if (!at(device).session) continue;
    judge_outcomes(device);
    judge_positions(device);
    judge_trust(device);
    judge_limits(device);
    judge_link(device);
    judge_reasons(device);
    judge_tool(device);
  }
  if (++ticks_ % memory_every == 0) judge_memory();
  for (const auto& [id, call] : calls_)
    if (scheduler_.now() > call.deadline)
      accuse("end", fmt::format("A call ({}) has not returned.", call.what));
  timer_.arm(scheduler_.now() + look_every);
}

void Judge::judge_memory() {
  const std::size_t now = memory_in_use();
  if (now > memory_at_start_ + most_memory * std::max<std::size_t>(1, devices_.size()))
    accuse("bounded", fmt::format("{} MB are in use.", (now - memory_at_start_) >> 20));
}

void Judge::opened(std::vector<std::shared_ptr<Session>> sessions) {
  if (devices_.size() < sessions.size()) devices_.resize(sessions.size());
  for (std::size_t i = 0; i < sessions.size(); ++i) {
    devices_[i].session = std::move(sessions[i]);
    devices_[i].unconnected_since = scheduler_.now();
    devices_[i].first_connected.reset();
    const MachineTruth& truth = devices_[i].truth;
    devices_[i].stands_unseen =
        truth.program && truth.moving() == 0 && truth.axis_count > facts_.axes_seen_at_work;
    devices_[i].goes_on_unseen = {};
    for (AxisCase& axis : devices_[i].axes) axis.restarted.reset();  // of what was before it knows nothing
  }
}

// What becomes of a motion after the tab has gone is what its user was asked then.
void Judge::closing() {
  for (int device = 0; device < static_cast<int>(devices_.size()); ++device) {
    DeviceCase& d = at(device);
    d.session.reset();
    d.intents.clear();
    d.tool.clouded = d.tool.clouded || d.tool.guarded || !d.tool.loading.empty();
    d.excuses.clear();
    for (AxisCase& axis : d.axes) axis.stopped.reset();
    motion_asked_elsewhere(device);
  }
}

void Judge::ended() {
  for (const auto& [id, call] : calls_)
    accuse("end", fmt::format("A call ({}) has not returned when all was closed.", call.what));
}

void Judge::intent_sent(int device, IntentId id) { text_typed(device, id, {}); }

void Judge::stop_sent(int device, IntentId id) {
  intent_sent(device, id);
  at(device).intents.back().stands_since = scheduler_.now();
}

void Judge::text_typed(int device, IntentId id, std::string text) {
  DeviceCase& d = at(device);
  if (!text.empty()) d.stop_drawn = scheduler_.now();
  d.intents.push_back({id, scheduler_.now(), std::move(text), d.forgotten + d.received.size()});
}

void Judge::motion_asked(int device, std::uint32_t axes, IntentId id, Steps distance, bool homes) {
  const Instant now = scheduler_.now();
  at(device).excuses.push_back({id, axes, now, now, distance, homes});
  for (std::size_t a = 0; a < at(device).axes.size(); ++a)
    if ((axes >> a & 1u) != 0) at(device).axes[a].whole.reset();
  if (axes == all_axes) at(device).stop_drawn = now;  // a program, or a text of the user's
}

void Judge::count_stop(int device, std::uint32_t axes, bool at_once) {
  DeviceCase& d = at(device);
  d.stop_drawn = scheduler_.now();
  if (d.truth.moving() == 0 && !d.truth.program && d.excuses.empty() && d.intents.empty() && prompt())
    d.stops.clear();
  d.stops.push_back({axes & ((1u << std::max(1, d.truth.axis_count)) - 1), at_once});
}

void Judge::stop_asked(int device, std::uint32_t axes, StopKind kind, bool by_hand) {
  DeviceCase& d = at(device);
  d.stop_drawn = scheduler_.now();
  if (!by_hand) count_stop(device, axes, kind != StopKind::ramp);
  // Beside a stored program a stop of one axis, or the maker's own word, may end one motion only; and the
  // maker's word for one axis may leave it in a motion that others make too.
  bool program = false, together = false;
  for (const Excuse& e : d.excuses) {
    program |= e.axes == all_axes;
    together |= (e.axes & axes) != 0 && (e.axes & ~axes) != 0;
  }
  const bool typed = kind == StopKind::typed;
  if (program && typed && !facts_.typed_stop_ends_programs) return;
  if (program && axes != all_axes && !facts_.axis_stop_ends_programs) return;
  if (together && typed && axes != all_axes) return;
  for (Excuse& excuse : d.excuses) excuse.axes &= ~axes;
  for (int a = 0; a < max_axes; ++a) {
    if ((axes >> a & 1u) == 0) continue;
    AxisCase& axis = d.axes[static_cast<std::size_t>(a)];
    axis.stopped = Stopped{scheduler_.now(), axis.truth.ramp, !prompt(), d.truth.program};
  }
}

void Judge::stop_asked_closing(int device) {
  if (at(device).session) return;
  stop_asked(device, all_axes, StopKind::typed);
}

void Judge::jog_let_go(int device, AxisId axis, IntentId jog, Duration after) {
  DeviceCase& d = at(device);
  d.stop_drawn = scheduler_.now() + after;
  const std::uint32_t bit = 1u << axis.index;
  bool alone = false;
  for (const Excuse& excuse : d.excuses) {
    if ((excuse.axes & bit) == 0) continue;
    alone = excuse.id == jog;
    if (!alone) return;  // a motion that was asked for beside the jog is none of the hand's business
  }
  if (!alone) return;  // it was refused
  stop_asked(device, bit, StopKind::ramp, true);
  d.axes[axis.index].stopped->at += after;
}

void Judge::position_set(int device, std::uint32_t axes, IntentId id) {
  for (Intended& asked : at(device).intents)
    if (asked.id == id) asked.counts_anew = axes;
  for (int a = 0; a < max_axes; ++a) {
    if ((axes >> a & 1u) == 0) continue;
    AxisCase& axis = at(device).axes[static_cast<std::size_t>(a)];
    axis.restarted.reset();
    axis.counts_anew = scheduler_.now();
  }
}

void Judge::restarted(int device) {
  if (device >= static_cast<int>(devices_.size())) return;
  DeviceCase& d = at(device);
  d.ever_restarted = true;
  // Homing may end at any moment, at 0 and at rest, as a power-up leaves the counters.
  std::uint32_t homing = 0;
  for (const Excuse& e : d.excuses)
    if (e.homes && !facts_.restart_always_shows) homing |= e.axes;
  homing &= d.truth.moving();
  // So may a program, where a round of status takes longer than the motions in it.
  const auto is_program = [](const Excuse& e) { return e.axes == all_axes; };
  if (!facts_.restart_always_shows && lateness() > Duration{} &&
      std::any_of(d.excuses.begin(), d.excuses.end(), is_program))
    homing = all_axes;
  // One whose counters stood at 0 may look as it did before.
  for (std::size_t a = 0; a < d.axes.size(); ++a)
    if (facts_.restart_always_shows || (d.axes[a].truth.position.value != 0 && (homing >> a & 1u) == 0))
      d.axes[a].restarted = scheduler_.now();
  if ((d.truth.moving() & ~homing) != 0 || d.truth.program) d.cut_off = scheduler_.now();
}

/// And may have set whatever it likes.
void Judge::others_talk(int device) {
  motion_asked_elsewhere(device);
  for (AxisCase& axis : at(device).axes) axis.restarted.reset();
}

int Judge::call_begun(std::string what, Duration longest) {
  calls_[next_call_] = Call{std::move(what), scheduler_.now() + longest};
  return next_call_++;
}

void Judge::call_ended(int call) { calls_.erase(call); }

void Judge::reported_idle(int device, Instant begun) {
  const DeviceCase& d = at(device);
  // Where a restart may be in doubt, what has been made since is what the wait is about.
  const bool made_since = !facts_.restart_always_shows && d.moved_last > d.cut_off;
  // A tab that saw the controller for the first time after its restart cannot know of it.
  const bool seen_before = d.first_connected && *d.first_connected < d.cut_off;
  if (d.cut_off > begun && !made_since && seen_before)
    accuse("end", "A wait has said that all is well, and the controller was switched off and on.");
  if (d.truth.moving() != 0 && d.moved_last > begun && excused(d, 0)) return;  // begun again since
  if (d.truth.moving() != 0) accuse("true", "A wait has said that nothing moves, and an axis moves.");
}

void Judge::left_behind(int device, std::string_view question, std::string_view word) {
  if (at(device).reported.find(word) != std::string::npos) return;
  accuse("clean", fmt::format("Device {}: {} is left in it as an answer to {}, and nobody was told.", device,
                              word, question.substr(0, question.find('\r'))));
}

void Judge::note(int device, char way, std::string_view bytes) {
  if (trace_ != nullptr) trace_->bytes(scheduler_.now(), device, way, bytes);
  const auto mix = [this](std::uint64_t value) { fingerprint_ = (fingerprint_ ^ value) * 1099511628211u; };
  mix(static_cast<std::uint64_t>(scheduler_.now().time_since_epoch().count()));
  mix(static_cast<std::uint64_t>(device) << 8 | static_cast<unsigned char>(way));
  for (const char c : bytes) mix(static_cast<unsigned char>(c));
}

void Judge::controller_received(int device, std::string_view bytes) {
  note(device, '>', bytes);
  std::string& received = at(device).received;
  received += bytes;
  constexpr std::string_view call = "GS";  // with the byte before, should it have come by itself
  const std::size_t news = std::min(received.size(), bytes.size() + 1);
  at(device).subroutine_called |=
      std::string_view(received).substr(received.size() - news).find(call) != received.npos;
  constexpr std::size_t kept = 4096;
  if (received.size() > 2 * kept) {
    at(device).forgotten += received.size() - kept;
    received.erase(0, received.size() - kept);
  }
  judge_kill(device);
}
void Judge::controller_sent(int device, std::string_view bytes) { note(device, '<', bytes); }
void Judge::register_written(int device, std::uint16_t offset, std::uint16_t value) {
  const char word[] = {static_cast<char>(offset >> 8), static_cast<char>(offset),
                       static_cast<char>(value >> 8), static_cast<char>(value)};
  note(device, 'w', {word, sizeof word});
}

}  // namespace hw::simulation
