// The laws of what is shown and told: end, true.
#include <algorithm>
#include <sstream>
#include <utility>

#include <fmt/core.h>

#include "core/base/index.h"
#include "tests/simulation/judge.h"

namespace hw::simulation {

// What is done was received by the controller as it was typed.
void Judge::judge_text(int device, const Intended& typed, IntentState outcome) {
  const DeviceCase& d = at(device);
  if (typed.text.empty() || outcome != IntentState::done || typed.received < d.forgotten) return;
  if (faults_.out.hurt() >= typed.at || faults_.carries_since(scheduler_.now()) > typed.at) return;
  // Word by word: where a driver puts something of its own between them the order stays.
  std::size_t place = typed.received - d.forgotten;
  std::istringstream words(typed.text);
  for (std::string word; place != d.received.npos && words >> word;) place = d.received.find(word, place);
  if (place == d.received.npos)
    accuse("kept", fmt::format("Device {}: \"{}\" was typed and is told to be done, and it was not received.",
                               device, typed.text));
}

void Judge::judge_outcomes(int device) {
  DeviceCase& d = at(device);
  const Snapshot& shown = d.session->known();
  const Instant now = scheduler_.now();
  std::erase_if(d.intents, [&](const Intended& i) {
    const IntentOutcome* outcome = shown.outcome_of(i.id);
    if (!outcome) return shown.forgotten(i.id);
    if (outcome->state == IntentState::pending) return false;
    if (trace_ != nullptr && outcome->state != IntentState::done)
      remark(fmt::format("device {}: {}: {}", device,
                         outcome->state == IntentState::refused ? "refused" : "failed",
                         outcome->sentence.view()));
    if (outcome->state == IntentState::failed) d.reported += outcome->sentence.view();
    for (const auto& [id, of_tool] : d.tool.loading)
      if (id == i.id && outcome->state == IntentState::done)
        d.tool.guarded = of_tool, d.tool.half_loaded = false;
      else if (id == i.id)
        d.tool.half_loaded = d.tool.half_loaded || of_tool;
    std::erase_if(d.tool.loading, [&](const auto& load) { return load.first == i.id; });
    judge_text(device, i, outcome->state);
    for (std::size_t a = 0; outcome->state == IntentState::done && a < d.axes.size(); ++a)
      if ((i.counts_anew >> a & 1u) != 0) d.axes[a].restarted.reset();
    return true;
  });
  if (d.intents.empty()) return;
  judge_open_stops(device);
  const Intended& oldest = d.intents.front();
  const Instant since = std::max(oldest.at, std::max(faults_.carries_since(now), faults_.in.hurt()));
  if (now > since + longest_outcome + 5 * lateness())
    accuse("end", fmt::format("Device {}: intent {} has had no outcome for {:.1f} s.", device, oldest.id,
                              seconds(now - oldest.at)));
}

// Bytes that were spoilt may look like anything; those of another question may not.
void Judge::answered(std::string_view question, std::string_view answer) {
  const Instant spoilt = std::max(faults_.in.spoilt(), faults_.out.spoilt());
  if (question != facts_.question || answer.find(facts_.answer) != answer.npos) return;
  if (spoilt != Instant{} && scheduler_.now() < spoilt + line_is_cleaned) return;
  accuse("true", fmt::format("{} was answered by \"{}\".", question, answer));
}

void Judge::judge_open_stops(int device) {
  DeviceCase& d = at(device);
  const Instant now = scheduler_.now();
  const Instant clean = std::max(faults_.carries_since(now), faults_.in.hurt()) + line_is_cleaned;
  const bool stands = d.truth.moving() == 0 && !d.truth.program && d.session->known().link.connected();
  for (Intended& i : d.intents) {
    if (!i.stands_since) continue;
    i.stands_since = stands ? std::max(*i.stands_since, clean) : now;
    const Duration over = stop_is_over + (d.subroutine_called ? subroutine_rests : Duration{});
    if (now > *i.stands_since + over + questions_between_motions * lateness())
      accuse("end", fmt::format("Device {}: the stop {} is not over {:.1f} s after all stands.", device, i.id,
                                seconds(now - *i.stands_since)));
  }
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
    const Steps reported = s.commanded();
    if (reported < low || reported > high)
      accuse("true",
             fmt::format("Device {}: axis {} is shown at {} (seen {:.3f} s ago); it was between {} and {}.",
                         device, a, reported.value, seconds(now - s.seen_at), low.value, high.value));
  }
}

/// The latest word that was spoilt before it: those that follow explain nothing.
void Judge::note_doubts(int device) {
  DeviceCase& d = at(device);
  const Snapshot& shown = d.session->known();
  for (int a = 0; a < shown.axis_count && ix(a) < d.axes.size(); ++a) {
    const PositionTrust& trust = shown.axes[ix(a)].trust;
    AxisCase::Doubted& doubted = d.axes[ix(a)].doubted;
    if (trust.doubtful() && doubted.since != trust.since) doubted = {trust.since, faults_.out.spoilt()};
  }
}

void Judge::judge_trust(int device) {
  note_doubts(device);
  const DeviceCase& d = at(device);
  const Snapshot& shown = d.session->known();
  const Instant now = scheduler_.now();
  if (!shown.link.connected()) return;
  const Instant quiet = std::max(faults_.carries_since(now), faults_.in.hurt());
  for (int a = 0; a < std::min(shown.axis_count, d.truth.axis_count); ++a) {
    const AxisCase& axis = d.axes[ix(a)];
    const PositionTrust& trust = shown.axes[ix(a)].trust;
    // A letter that comes as another one may restart it: T where there is no second controller.
    const bool spoilt = trust.since <= faults_.in.spoilt() + spoilt_number_shows ||
                        trust.since <= faults_.out.spoilt() + restart_shows;
    if (!d.ever_restarted && !spoilt && (trust.cause == Doubt::power_cut || trust.cause == Doubt::restarted))
      accuse("true",
             fmt::format("Device {} is said to have been switched off and on, and it was not.", device));
    // A word of the console's own that was spoilt on its way may set a count.
    const AxisCase::Doubted& doubted = axis.doubted;
    const bool misread = trust.since <= doubted.spoilt + restart_shows;
    if (!d.ever_restarted && !misread && trust.cause == Doubt::another)
      accuse("true", fmt::format("Device {}: the count of axis {} is said to have been set, and it was not.",
                                 device, a));
    if (!axis.restarted || !d.first_connected || *axis.restarted < *d.first_connected) continue;
    if (now < std::max(quiet, *axis.restarted) + restart_shows) continue;
    // The one answer that tells it may be lost where a stop must not wait for another one.
    const bool hidden = axis.stopped && axis.stopped->at > *axis.restarted;
    if (hidden && faults_.in.spoilt() > *axis.restarted) continue;
    const AxisState& s = shown.axes[ix(a)];
    if (s.seen_at < *axis.restarted)
      continue;  // shown with its age: a set-up is being stored, which takes 10 s
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
  bench_is(device, view);
  judge_lines(device);
  const std::uint32_t operated = view.limits_minus | view.limits_plus;
  constexpr Duration two_rounds = std::chrono::seconds(1);  // in which it shows that the tool is on
  if (operated != 0 && (d.tool.guarded || d.tool.half_loaded))
    d.stop_drawn = now + two_rounds;  // then the console stops all
  for (int a = 0; a < std::min(shown.axis_count, d.truth.axis_count); ++a) {
    AxisCase& axis = d.axes[ix(a)];
    if ((view.jammed >> a & 1u) != 0) axis.jammed = now;
    const AxisState& s = shown.axes[ix(a)];
    if (!shown.link.connected() || !s.limits_known || !(s.limit_minus || s.limit_plus)) continue;
    if (is_stale(s.seen_at, now, shown.poll_period)) continue;  // it is shown as old
    const Instant since = std::max({axis.limit_operated, faults_.in.spoilt(), faults_.out.spoilt()});
    if (now > since + line_shows + questions_between_rounds * lateness())
      accuse("true", fmt::format("Device {}: axis {} is shown at a limit that nothing operates.", device, a));
  }
}

void Judge::bench_is(int device, const BenchView& view) {
  if (ix(device) >= devices_.size()) return;  // nobody has opened it yet
  DeviceCase& d = at(device);
  const Instant now = scheduler_.now();
  const DeviceCase::Bench stand{view.inputs_operated | view.buttons << 16, view.outputs};
  if (d.benches.empty() || d.benches.back().second != stand) d.benches.emplace_back(now, stand);
  const std::uint32_t operated = view.limits_minus | view.limits_plus;
  for (std::size_t a = 0; a < d.axes.size(); ++a)
    if (((operated | d.limits) >> a & 1u) != 0) d.axes[a].limit_operated = now;  // or until now
  d.limits = operated;
  while (d.benches.size() > 1 && d.benches[1].first < now - line_shows - 2 * lateness())
    d.benches.pop_front();
}

// What appears of inputs and outputs is how the bench stood lately.
void Judge::judge_lines(int device) {
  DeviceCase& d = at(device);
  const Snapshot& shown = d.session->known();
  const Instant now = scheduler_.now();
  if (d.benches.empty()) return;
  if (!shown.link.connected() || !d.truth.powered) return;
  const std::array<DeviceCase::Lines, 2> lines{
      {{shown.inputs, shown.inputs_known}, {shown.outputs, shown.outputs_known}}};
  const bool spoilt =
      now < std::max(faults_.in.spoilt(), faults_.out.spoilt()) + spoilt_number_shows + lateness();
  for (std::size_t kind = 0; kind < lines.size(); ++kind) {
    const auto differs = [&](const DeviceCase::Lines& a, const DeviceCase::Lines& b) {
      return ((a.values ^ b.values) & a.known & b.known) != 0;
    };
    if (spoilt || !differs(lines[kind], d.lines[kind])) continue;
    const bool possible = std::any_of(d.benches.begin(), d.benches.end(), [&](const auto& past) {
      const auto look = d.looks.find(past.second);
      return look == d.looks.end() || !differs(lines[kind], look->second[kind]);
    });
    if (!possible)
      accuse("true",
             fmt::format("Device {}: {} are shown as {:X} (of {:X}), and they are not and were not so.",
                         device, kind == 0 ? "inputs" : "outputs", lines[kind].values, lines[kind].known));
  }
  d.lines = lines;
  // Each of them has its own question; all have been asked when one has been for a while.
  if (now - shown.io_seen_at > line_shows) d.lines_unread = now;
  const bool read_since = shown.io_seen_at > std::max(d.benches.back().first, d.lines_unread) + line_shows;
  if (d.benches.size() == 1 && read_since && prompt() && !d.looks.contains(d.benches.back().second))
    d.looks[d.benches.back().second] = lines;
}

// The reason told is one that was drawn.
void Judge::judge_reasons(int device) {
  DeviceCase& d = at(device);
  const Snapshot& shown = d.session->known();
  const Instant now = scheduler_.now();
  constexpr Instant never{};
  const Instant hurt = std::max({faults_.in.hurt(), faults_.out.hurt(), faults_.carries_since(now)});
  const Instant spoilt = std::max(faults_.in.spoilt(), faults_.out.spoilt());
  for (int a = 0; a < std::min(shown.axis_count, d.truth.axis_count); ++a) {
    AxisCase& axis = d.axes[ix(a)];
    const EndedBy why = shown.axes[ix(a)].ended_by;
    if (std::exchange(axis.reported, why) == why || why == EndedBy::nothing) continue;
    const Instant drawn = std::max({d.stop_drawn, hurt, d.ever_restarted ? now : never});
    const bool stop = why == EndedBy::stop || why == EndedBy::abort;
    const char* what = nullptr;
    if (stop && drawn + excuse_lasts + lateness() < axis.ended_motion_began) what = "a stop";
    if (why == EndedBy::limit && axis.limit_operated == never && spoilt == never) what = "a limit";
    if (why == EndedBy::lost && hurt == never && lateness() == Duration{} && !faults_.in.swallows() &&
        !d.ever_restarted)
      what = "a lost connection";
    if (why == EndedBy::target && axis.whole == false && spoilt == never && !d.ever_restarted)
      what = "its target";
    if (why == EndedBy::elsewhere && axis.whole == true && spoilt == never && !d.ever_restarted)
      what = "somebody else";
    const bool turns = shown.axes[ix(a)].enabled;
    if (why == EndedBy::error && turns && !d.ever_restarted && axis.jammed == never &&
        axis.limit_operated == never && spoilt == never)
      what = "an error";
    if (what != nullptr)
      accuse("end", fmt::format("Device {}: axis {} is said to have ended by {}, and it was not so.", device,
                                a, what));
  }
}

// What a program of its own has switched on is off when nothing runs.
void Judge::judge_tool(int device) {
  DeviceCase& d = at(device);
  DeviceCase::Tool& tool = d.tool;
  const Instant now = scheduler_.now();
  const bool on = !d.benches.empty() && (d.benches.back().second.second >> facts_.tool_output & 1u) != 0;
  const bool rests = !d.truth.program && d.truth.moving() == 0;
  const Snapshot& shown = d.session->known();
  const bool begun = shown.pieces.running && shown.pieces.step >= 0;  // the first has got there
  const bool in_pieces =
      begun && (d.truth.program || shown.feed.running || (tool.draws && shown.pieces.draws));
  if (in_pieces) tool.guarded = true;
  if (in_pieces || (d.truth.program && tool.guarded && tool.run_asked)) tool.by_hand = false;
  if (!d.truth.powered) tool.by_hand = true;
  const Instant carries = std::max({faults_.carries_since(now), faults_.in.hurt(), faults_.out.hurt()});
  if (!on || !rests || !d.session->known().link.connected()) tool.rests_since = now;
  if (!tool.guarded || tool.clouded || tool.by_hand) return;
  const Duration bound = tool_is_off + line_is_cleaned * (carries == Instant{} ? 0 : 1);
  if (now > std::max(tool.rests_since, carries) + bound + questions_between_rounds * lateness())
    accuse("tool", fmt::format("Device {}: nothing runs, and its tool is on for {:.1f} s.", device,
                               seconds(now - tool.rests_since)));
}

// Where the wire carries and the controller has power, there is a connection.
void Judge::judge_link(int device) {
  DeviceCase& d = at(device);
  const Instant now = scheduler_.now();
  const bool connected = d.session->known().link.connected();
  if (connected && !d.first_connected) d.first_connected = now;
  if (connected || !d.truth.powered) d.unconnected_since = now;
  const Instant since = std::max({d.unconnected_since, faults_.carries_since(now), faults_.in.hurt()});
  if (now > since + longest_connect + 5 * lateness())
    accuse("end", fmt::format("Device {}: no connection {:.0f} s after the wire was good.", device,
                              seconds(now - since)));
}

}  // namespace hw::simulation
