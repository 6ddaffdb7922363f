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

constexpr Duration copy_time = std::chrono::microseconds(1000);   // decision M26: about 1 ms
constexpr Duration sample_pause = std::chrono::microseconds(50);  // between two rounds of a recording
constexpr Duration copy_look = std::chrono::microseconds(300);
constexpr Duration update_patience = Millis(50);
constexpr int live_values = 3;  // encoder, position, velocity stand first

}  // namespace

// A recording wants each copy that the board makes: one a millisecond.
Duration Vme58Driver::moving_period() const { return sampling() ? sample_pause : Duration(Millis(20)); }
Duration Vme58Driver::idle_period() const {
  if (draft_.working) return moving_period();
  return sampling() ? sample_pause : Duration(Millis(200));
}

std::int64_t Vme58Driver::value(int axis, AxisValue v) const { return data_[ix(axis)][v]; }
bool Vme58Driver::moving(int axis) const {
  return seen_[ix(axis)] && value(axis, AxisValue::command_velocity) != 0;
}

Task<Result<>> Vme58Driver::poll(Round round) {
  const Priority priority = round == Round::stopping ? Priority::stop : Priority::poll;
  const Instant began = scheduler_.now();
  const auto registers = co_await read_registers(priority, true);
  if (!registers) co_return fail(registers.error());
  if ((registers->status & status::initialized) == 0) {
    station_->count_miss();
    co_return fail(FaultKind::garbled, "The board is starting: it has been reset.",
                   "Nothing is known of it yet.");
  }
  take_registers(*registers);
  if (registers->mark == 0) {
    auto told = co_await found_reset(Doubt::restarted);
    if (!told) co_return told;
    co_return co_await read_state();
  }
  auto read = co_await read_axes(priority, Copy::is_asked_for);
  if (!read) co_return read;
  station_->count_answer(scheduler_.now() - began, true, scheduler_.now());
  record_round();
  if (round == Round::stopping) co_return co_await look_at_queues_after_stop();
  co_return co_await read_more(*registers);
}

/// What else a round tells: replies that nobody waits for, and what the board answers to.
Task<Result<>> Vme58Driver::read_more(Registers registers) {
  ++round_;
  auto fetched = co_await fetch_replies(registers.input_put, Priority::poll);
  if (!fetched) co_return fetched;
  give_unsolicited();
  if (mark_due_) {
    auto marked = co_await leave_mark();
    if (!marked) co_return marked;
  }
  draft_.window.rings_known = bit(watched_, memory_group);
  if (draft_.window.rings_known) {
    auto rings = co_await read_rings(Priority::poll);
    if (!rings) co_return rings;
  }
  // Text that the board has not come to holds questions back too, and is nobody's to take away.
  if (registers.output_get == put_) {
    on_its_way_ = in_wq_ = false;
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

/// With `ask_for_data` the board is told to copy the axis data, in the same burst.
Task<Result<Vme58Driver::Registers>> Vme58Driver::read_registers(Priority priority, bool ask_for_data) {
  std::vector<BusCycle>& cycles = burst();
  if (ask_for_data) cycles.push_back(BusCycle::store(1, reg::control, control_ | control::update_data));
  const std::size_t first = cycles.size();
  for (const std::uint16_t offset :
       {reg::control, reg::status, reg::limit, reg::home, reg::io_low, reg::io_high, reg::vector})
    cycles.push_back(BusCycle::read(1, offset));
  for (const std::uint16_t offset :
       {at::reserved1, at::input_put_index, at::input_put_index, at::output_get_index, at::output_get_index})
    cycles.push_back(BusCycle::read(2, offset));
  auto done = co_await run(cycles, priority);
  if (!done) co_return fail(done.error());
  const auto byte = [&](std::size_t i) { return static_cast<std::uint8_t>(cycles[first + i].value); };
  const auto word = [&](std::size_t i) { return cycles[first + 7 + i].value; };
  const bool ones =
      std::all_of(cycles.begin() + static_cast<std::ptrdiff_t>(first), cycles.end(),
                  [](const BusCycle& c) { return c.value == (c.width == 1 ? 0xFFu : 0xFFFFu); });
  if (ones) {
    station_->count_miss();
    co_return fail(FaultKind::garbled, "No board answers any more: every byte of the window reads FF.",
                   "Nothing was repeated.", "Look at the crate's power and at the board.");
  }
  if (word(1) != word(2) || !is_index(word(1)) || word(3) != word(4) || !is_index(word(3)))
    co_return fail(FaultKind::garbled, "The indexes of the rings make no sense.", "They are read again.");
  Registers r;
  r.control = byte(0), r.status = byte(1), r.limit = byte(2), r.home = byte(3);
  r.io = static_cast<std::uint16_t>(byte(4) | (byte(5) & 0x3F) << 8);
  r.mark = static_cast<std::uint16_t>(word(0));
  r.input_put = static_cast<int>(word(1)), r.output_get = static_cast<int>(word(3));
  for (std::size_t i = first; i < cycles.size(); ++i)
    draft_.window.put(cycles[i].offset, cycles[i].width, cycles[i].value);
  draft_.window.known = true;
  co_return r;
}

void Vme58Driver::take_registers(const Registers& r) {
  if ((r.status & status::command_error) != 0) command_error_ = true;
  status_ = r.status;
  if ((status_ & status::slip) == 0) slips_ = 0;
  if ((status_ & status::done) == 0) draft_.window.put(reg::done, 1, 0);
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
      draft_.readouts_seen_at[ix(place)] = scheduler_.now();
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
  draft_.io_seen_at = scheduler_.now();
}

// ---- data area

/// Waits for the board's copy. Three values of each axis, and all of one axis in turn.
Task<Result<>> Vme58Driver::read_axes(Priority priority, Copy copy) {
  std::vector<BusCycle>& cycles = burst();
  if (copy == Copy::ask) {
    cycles.push_back(BusCycle::store(1, reg::control, control_ | control::update_data));
    auto asked = co_await run(cycles, priority);
    if (!asked) co_return asked;
  }
  const Instant give_up = scheduler_.now() + update_patience;
  const int whole = next_axis_;
  next_axis_ = (next_axis_ + 1) % axis_count();
  Duration look = sampling() ? copy_time - sample_pause : copy_time;
  for (;;) {
    auto paused = co_await pause(std::exchange(look, copy_look));
    if (!paused) co_return paused;
    cycles.clear();
    cycles.push_back(BusCycle::read(1, reg::control));
    for (int i = 0; i < axis_count(); ++i)
      append_axis_reads(cycles, i, i == whole ? axis_values : live_values);
    auto done = co_await run(cycles, priority);
    if (!done) co_return done;
    if ((cycles.front().value & control::update_data) == 0) break;
    if (scheduler_.now() > give_up) {
      station_->count_miss();
      co_return fail(FaultKind::no_answer,
                     "The board did not copy its axis data in time (control register, bit 0).",
                     "Positions are shown as last read.");
    }
  }
  take_cycles(cycles);
  const Instant now = scheduler_.now();
  take_parameters(whole);
  for (int i = 0; i < axis_count(); ++i) show_axis(i, now);
  sample(now);
  co_return Result<>();
}

Task<Result<>> Vme58Driver::read_all_values(Priority priority) {
  for (int i = 0; i < axis_count(); ++i) {
    auto read = co_await read_axes(priority);
    if (!read) co_return read;
  }
  co_return Result<>();
}

void Vme58Driver::take_cycles(const std::vector<BusCycle>& cycles) {
  for (const BusCycle& cycle : cycles) {
    draft_.window.put(cycle.offset, cycle.width, cycle.value);
    if (cycle.width != 4) continue;
    const int axis = (cycle.offset - at::axis_data) / axis_stride;
    const int place = (cycle.offset - at::axis_data) % axis_stride / 4;
    data_[ix(axis)].values[ix(place)] = static_cast<std::int32_t>(cycle.value);
  }
}

void Vme58Driver::show_axis(int i, Instant at) {
  AxisState& axis = draft_.axes[i];
  AxisMind& mind = minds_[ix(i)];
  const Steps command(value(i, AxisValue::command_position));
  const Steps change = command - axis.command;
  const bool fresh = axis.position_known && seen_[ix(i)];
  if (fresh && change.value != 0 && !mind.counted) mind.way = change.value > 0 ? 1 : -1;
  const bool crept = fresh && change.value != 0 && !mind.counted;
  mind.counted = false;
  seen_[ix(i)] = true;
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
  if (context_.recording) return end_motion(i, there ? EndedBy::target : EndedBy::elsewhere);
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

Task<Result<>> Vme58Driver::read_rings(Priority priority) {
  std::vector<BusCycle>& cycles = burst();
  for (const std::uint16_t index :
       {at::input_put_index, at::output_get_index, at::output_put_index, at::input_get_index})
    cycles.push_back(BusCycle::read(2, index));
  cycles.push_back(BusCycle::read(2, at::mailbox));
  cycles.push_back(BusCycle::read(2, at::mailbox + 2));
  for (const std::uint16_t buffer : {at::input_buffer, at::output_buffer})
    for (int i = 0; i < ring_cells; ++i)
      cycles.push_back(BusCycle::read(2, static_cast<std::uint16_t>(buffer + 2 * i)));
  auto done = co_await run(cycles, priority);
  if (!done) co_return done;
  for (const BusCycle& cycle : cycles) draft_.window.put(cycle.offset, cycle.width, cycle.value);
  co_return Result<>();
}

// ---- what is told

void Vme58Driver::record_round() {
  round_text_.clear();
  for (int i = 0; i < axis_count(); ++i)
    fmt::format_to(std::back_inserter(round_text_), "{}{}", i == 0 ? "" : " ", draft_.axes[i].position.value);
  record(Way::sent, Priority::poll, "data area");
  record(Way::received, Priority::poll, round_text_);
}

void Vme58Driver::show_worst() {
  draft_.notice.clear();
  if (std::exchange(command_error_, false)) show_late_rejection();
  if (draft_.program.run == RunState::error) draft_.notice = rejection_;
  if (context_.recording)
    draft_.notice = "A contour is being recorded: moves and set-up wait for its end (CE or CK).";
}

}  // namespace hw::vme58
