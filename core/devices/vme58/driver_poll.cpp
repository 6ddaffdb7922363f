// The round of status: registers, then the data area. Reading the done and slip registers clears them, for
// everybody: while the board takes questions it is asked instead, which leaves the flags to whoever wants
// them (decisions M31, M32). Reading the limit register clears only a hit that is over, and is remembered.
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iterator>
#include <utility>

#include <fmt/format.h>

#include "core/base/index.h"
#include "core/devices/vme58/driver.h"

namespace hw::vme58 {
namespace {

constexpr Duration sample_pause = std::chrono::microseconds(50);  // between two rounds of a recording

}  // namespace

// A recording wants each copy that the board makes: one a millisecond.
Duration Vme58Driver::moving_period() const { return sampling() ? sample_pause : Duration(Millis(20)); }
Duration Vme58Driver::idle_period() const {
  if (draft_.working) return moving_period();
  return sampling() ? sample_pause : Duration(Millis(200));
}

Task<Result<>> Vme58Driver::poll(Round round) {
  readings_.look_after(sampling() ? Readings::copy_time - sample_pause : Readings::copy_time);
  const Priority priority = round == Round::stopping ? Priority::stop : Priority::poll;
  const Instant began = now();
  const auto registers = co_await readings_.read_registers(priority, true);
  if (!registers) co_return fail(registers.error());
  if ((registers->status & status::initialized) == 0) {
    wire_.count_miss();
    co_return fail(FaultKind::garbled, "The board is starting: it has been reset.",
                   "Nothing is known of it yet.");
  }
  readings_.take(*registers);
  if (registers->mark == 0) {
    auto told = co_await found_reset(Doubt::restarted);
    if (!told) co_return told;
    co_return co_await read_state();
  }
  auto read = co_await readings_.read_axes(priority, Readings::Copy::is_asked_for);
  if (!read) co_return read;
  wire_.count_answer(began, true);
  record_round();
  if (round == Round::stopping) co_return co_await look_at_queues_after_stop();
  co_return co_await read_more(*registers);
}

/// What else a round tells: replies that nobody waits for, and what the board answers to.
Task<Result<>> Vme58Driver::read_more(Registers registers) {
  ++round_;
  auto heard = co_await conversation_.hear(registers.input_put, Priority::poll);
  if (!heard) co_return heard;
  if (mark_due_) {
    auto marked = co_await leave_mark();
    if (!marked) co_return marked;
  }
  draft_.window.rings_known = bit(watched_, memory_group);
  if (draft_.window.rings_known) {
    auto rings = co_await readings_.read_rings(Priority::poll);
    if (!rings) co_return rings;
  }
  // Text that the board has not come to holds questions back too, and is nobody's to take away.
  if (conversation_.is_taken_up_to(registers.output_get)) {
    auto asked = co_await ask_in_turn();
    if (!asked) co_return asked;
  } else {
    show_full_queue();
    // No question comes through, and a motion of ours may have ended.
    if (wants_done()) {
      auto looked = co_await read_done();
      if (!looked) co_return looked;
    }
  }
  auto watched = co_await watch_program();
  show_worst();
  co_return watched;
}

// ---- registers

void Vme58Driver::registers_read(const Registers& r) {
  if ((r.status & status::slip) == 0) slips_ = 0;
  draft_.window.put(reg::slip, 1, slips_);
  const std::uint8_t before = limits_;
  limits_ = r.limit;
  homes_ = r.home;
  if (limits_ != before) flags_wanted_ = true;
  for (int i = 0; i < axis_count(); ++i) {
    AxisMind& mind = minds_[ix(i)];
    if (bit(r.limit, i)) {
      mind.limit_hit = true;
      if (!bit(before, i)) mind.jog_gap = {}, mind.creeps_until = {};
    } else {
      if (std::exchange(mind.from_limit, false)) mind.limit_hit = false;
      mind.limit_end = 0;
    }
    AxisState& axis = draft_.axes[i];
    axis.home = bit(r.home, i);
    axis.slipped = bit(slips_, i);
    const int place = catalog_.find_readout(fmt::format("SLIP{}", axis_name(i)));
    if (place >= 0) {
      draft_.readouts_known.set(ix(place));
      draft_.readouts_seen_at[ix(place)] = now();
    }
  }
  draft_.inputs = r.io;
  draft_.inputs_known = (1u << io_lines) - 1;
  for (std::size_t place = 0; place < catalog_.outputs.size(); ++place) {
    const int line = catalog_.outputs[place].number;
    if (line >= io_lines) continue;  // auxiliary: nothing in the window tells
    const std::uint32_t mask = 1u << place;
    const bool is_output = bit(static_cast<std::uint32_t>(outputs_direction_), line);
    draft_.outputs_known = is_output ? draft_.outputs_known | mask : draft_.outputs_known & ~mask;
    draft_.outputs = bit(r.io, line) ? draft_.outputs & ~mask : draft_.outputs | mask;  // low is on
  }
  draft_.io_seen_at = now();
}

// ---- data area

void Vme58Driver::axes_read(int whole, Instant at) {
  take_parameters(whole);
  for (int i = 0; i < axis_count(); ++i) show_axis(i, at);
  sample(at);
}

void Vme58Driver::show_axis(int i, Instant at) {
  AxisState& axis = draft_.axes[i];
  AxisMind& mind = minds_[ix(i)];
  const Steps command(value(i, AxisValue::command_position));
  const Steps change = command - axis.command;
  const bool fresh = axis.position_known && readings_.seen(i);
  if (fresh && change.value != 0 && !mind.counted) mind.way = change.value > 0 ? 1 : -1;
  const bool crept = fresh && change.value != 0 && !mind.counted;
  mind.counted = false;
  readings_.see(i);
  const double speed = std::abs(static_cast<double>(value(i, AxisValue::command_velocity)));
  axis.command = command;
  axis.encoder = Steps(value(i, AxisValue::encoder_position));
  axis.position = catalog_.axes[ix(i)].servo ? axis.encoder : command;
  axis.seen_at = at;
  axis.position_known = true;
  axis.speed = Pps(speed);
  axis.own_speed = Pps(static_cast<double>(own_velocity_of(i)));
  if (crept && mind.jog_gap > Duration::zero()) mind.creeps_until = at + mind.jog_gap;
  const bool turns = speed > 0 || crept || at < mind.creeps_until;
  axis.direction = turns ? mind.way : std::int8_t{0};
  show_place(i, at, turns);
  // What has turned on a switch that it stood on has come away from it, whatever the direction letter says.
  if (crept && mind.from_limit && bit(limits_, i)) {
    mind.limit_end = static_cast<std::int8_t>(-mind.way);
    mind.letter = mind.way;
  }
  show_limits(i);
  if (!turns) {
    if (!mind.ours && !mind.stopping && !mind.by_text) mind.from_limit = bit(limits_, i);
    return show_still(i, at);
  }
  if (speed > 0 || crept) {
    mind.turned = true;
    mind.still_since = at;
    mind.asks_queue = false;
  }
  axis.activity = mind.stopping ? Activity::stopping : mind.ours ? mind.wanted : Activity::moving;
}

void Vme58Driver::show_limits(int i) {
  AxisState& axis = draft_.axes[i];
  const std::int8_t end = minds_[ix(i)].limit_end;
  axis.limits_known = !bit(limits_, i) || end != 0;
  axis.limit_minus = bit(limits_, i) && end < 0;
  axis.limit_plus = bit(limits_, i) && end > 0;
}

/// A switch that it stood on when it began has ended a motion only if it did not come away from there.
bool Vme58Driver::met_limit(const AxisMind& mind) {
  return mind.limit_hit && !(mind.from_limit && mind.turned);
}

void Vme58Driver::show_still(int i, Instant at) {
  AxisState& axis = draft_.axes[i];
  AxisMind& mind = minds_[ix(i)];
  if (mind.stopping) return end_motion(i, mind.ended_by);
  if (settles(i)) {  // its command has ended, the axis has not yet
    mind.still_since = at;
    axis.activity = mind.ours ? mind.wanted : Activity::moving;
    return;
  }
  if (!mind.ours) {
    if (axis.activity != Activity::idle) axis.activity = Activity::idle;
    if (judged(i, EndedBy::target) == EndedBy::not_in_place) axis.ended_by = EndedBy::not_in_place;
    if (mind.by_text && mind.turned && met_limit(mind)) axis.ended_by = EndedBy::limit;
    return;
  }
  const bool there = axis.has_target && axis.command == axis.target;
  const bool limited = met_limit(mind);
  // The board goes on with the ID behind a move that a switch has cut short. And a done flag of a motion
  // before stays until the move's GD is carried out.
  const bool believed = mind.turned || there || limited || mind.wanted == Activity::homing;
  if (mind.done && believed && mind.wanted != Activity::jogging)
    return end_motion(i, limited && !there ? EndedBy::limit : EndedBy::target);
  if (limited) return end_motion(i, EndedBy::limit);
  // On a straight line the shortest way shows nothing for long: the axes of a group rest together.
  for (int other = 0; other < axis_count(); ++other)
    if ((mind.group >> other & 1) != 0 && moving(other)) mind.still_since = at;
  axis.activity = mind.wanted;
  if (at - mind.still_since < rest_patience(i)) return;
  if (selection_.recording()) return end_motion(i, there ? EndedBy::target : EndedBy::elsewhere);
  mind.asks_queue = true;
}

void Vme58Driver::end_motion(int i, EndedBy ended_by) {
  AxisState& axis = draft_.axes[i];
  AxisMind& mind = minds_[ix(i)];
  ended_by = judged(i, ended_by);
  if (ended_by == EndedBy::target) comes_home(i);
  mind.at_home = AtHome::nothing;
  axis.activity = Activity::idle;
  axis.ended_by = ended_by;
  axis.has_target = false;
  axis.direction = 0;
  mind.ours = mind.stopping = mind.done = mind.by_text = mind.asks_queue = false;
  mind.group = 0;
  mind.wanted = Activity::idle;
  begins_to_creep(i, {});
  mind.from_limit = bit(limits_, i);
  if (ended_by != EndedBy::limit) return;
  mind.limit_end = 0;  // the direction letter tells which (decision M33), now that it is of this motion
  flags_wanted_ = true;
}

/// Its motion to the home switch has come there. KM and KR stop dead, from VL.
void Vme58Driver::comes_home(int i) {
  const AtHome how = std::exchange(minds_[ix(i)].at_home, AtHome::nothing);
  if (how == AtHome::sets_counter) trusted(i, Trust::homed);
  if (how == AtHome::stops_dead)
    doubt_killed_position(i, static_cast<double>(value(i, AxisValue::maximum_velocity)));
}

// ---- what is told

void Vme58Driver::record_round() {
  round_text_.clear();
  for (int i = 0; i < axis_count(); ++i)
    fmt::format_to(std::back_inserter(round_text_), "{}{}", i == 0 ? "" : " ", draft_.axes[i].position.value);
  wire_.record(Way::sent, Priority::poll, "data area");
  wire_.record(Way::received, Priority::poll, round_text_);
}

void Vme58Driver::show_worst() {
  draft_.notice.clear();
  commands_.show_late_if_any();
  if (draft_.program.run == RunState::error) draft_.notice = rejection_;
  if (selection_.recording())
    draft_.notice = "A contour is being recorded: moves and set-up wait for its end (CE or CK).";
}

}  // namespace hw::vme58
