#include "core/devices/vme58/motions.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <utility>

#include <fmt/core.h>

#include "core/base/index.h"
#include "core/device/axis_motion.h"
#include "core/devices/vme58/text_meaning.h"

namespace hw::vme58 {
namespace {

constexpr Duration rest_time = Millis(400);  // after this rest without a done flag, a motion may have ended

/// Whether the count was set: no motion could have changed it this far since the last reading.
bool is_no_motion(const AxisState& axis, Steps change, Instant when) {
  constexpr double and_more = 1.5, at_least = 50;
  if (axis.own_speed.value <= 0) return false;
  return std::abs(static_cast<double>(change.value)) >
         at_least + and_more * axis.own_speed.value * seconds(when - axis.seen_at);
}

}  // namespace

// ---- readings

void Motions::show(int i, Instant when) {
  AxisState& axis = snapshot_.axes[i];
  Axis& own = at(i);
  const Steps command(readings_.value(i, AxisValue::command_position));
  const Steps change = command - axis.command;
  const bool crept = axis.position_known && readings_.seen() && change.value != 0 && !own.counted &&
                     !is_no_motion(axis, change, when);
  if (crept) own.way = change.value > 0 ? 1 : -1;
  own.counted = false;
  const double speed = std::abs(static_cast<double>(readings_.value(i, AxisValue::command_velocity)));
  axis.command = command;
  axis.encoder = Steps(readings_.value(i, AxisValue::encoder_position));
  axis.position = loops_.is_servo(i) ? axis.encoder : command;
  axis.seen_at = when;
  axis.position_known = true;
  axis.speed = Pps(speed);
  if (crept && own.jog_gap > Duration::zero()) own.creeps_until = when + own.jog_gap;
  const bool turns = speed > 0 || crept || when < own.creeps_until;
  axis.direction = turns ? own.way : std::int8_t{0};
  loops_.look(i, when, turns);
  if (crept) limits_.crept(i, own.way);
  limits_.show(i);
  if (!turns) {
    if (!own.ours && !own.stopping && !own.by_text) limits_.rests(i);
    return show_still(i, when);
  }
  if (speed > 0 || crept) {
    limits_.turns(i);
    own.still_since = when;
    own.asks_queue = false;
  }
  axis.activity = own.stopping ? Activity::stopping : own.ours ? own.wanted : Activity::moving;
}

void Motions::show_still(int i, Instant when) {
  AxisState& axis = snapshot_.axes[i];
  Axis& own = at(i);
  if (own.stopping) return end(i, own.ended_by);
  if (loops_.settles(i)) {  // the command has ended, the axis has not arrived yet
    own.still_since = when;
    axis.activity = own.ours ? own.wanted : Activity::moving;
    return;
  }
  if (!own.ours) {
    if (axis.activity != Activity::idle) axis.activity = Activity::idle;
    if (loops_.judged(i, EndedBy::target) == EndedBy::not_in_place) axis.ended_by = EndedBy::not_in_place;
    if (own.by_text && limits_.has_turned(i) && limits_.met(i)) axis.ended_by = EndedBy::limit;
    return;
  }
  const bool there = axis.has_target && axis.command == axis.target;
  const bool limited = limits_.met(i);
  // A done flag alone proves nothing: the board carries out the ID behind a move that a switch has cut short,
  // and the flag of an earlier motion stays until the move's GD is carried out.
  const bool believed = limits_.has_turned(i) || there || limited || own.wanted == Activity::homing;
  if (own.done && believed && !jogs(i)) return end(i, limited && !there ? EndedBy::limit : EndedBy::target);
  if (limited) return end(i, EndedBy::limit);
  // On a straight line the axis with the shortest way may show no motion for long: the axes of a group rest
  // together.
  for (int other = 0; other < count(); ++other)
    if ((own.group >> other & 1) != 0 && moving(other)) own.still_since = when;
  axis.activity = own.wanted;
  if (when - own.still_since < rest_patience(i)) return;
  if (selection_.recording()) return end(i, there ? EndedBy::target : EndedBy::elsewhere);
  own.asks_queue = true;
}

void Motions::take_done(unsigned axes) {
  for (int i = 0; i < count(); ++i) {
    Axis& own = at(i);
    if (!bit(axes, i) || !own.ours || own.stopping) continue;
    own.done = true;
    if (!moving(i)) show_still(i, wire_.now());
  }
}

bool Motions::waits_for_done() const {
  for (int i = 0; i < count(); ++i) {
    const Axis& own = at(i);
    if (own.ours && !own.stopping && !moving(i) && !loops_.settles(i) && !jogs(i)) return true;
  }
  return false;
}

/// Once the queues are empty, a queued motion has begun; a queued jog may show only a little later.
void Motions::take_queues(unsigned has_room, bool were_empty, bool empty) {
  const unsigned groups = 3u << count();
  for (int i = 0; i < count(); ++i) {
    Axis& own = at(i);
    if (!were_empty && empty && own.jog_gap > Duration::zero()) {
      creeps(i, own.jog_gap);
      if (snapshot_.axes[i].activity == Activity::idle) snapshot_.axes[i].activity = Activity::moving;
    }
    if ((has_room & groups) == groups) own.in_group = false;
    if (!std::exchange(own.asks_queue, false) || !own.ours) continue;
    const unsigned its = own.group != 0 ? groups : 1u << i;
    const AxisState& axis = snapshot_.axes[i];
    if ((has_room & its) != its)
      own.still_since = wire_.now();  // still queued: the motion is under way, or has not begun
    else
      end(i, axis.has_target && axis.command == axis.target ? EndedBy::target : EndedBy::elsewhere);
  }
}

void Motions::queues_emptied() {
  for (int i = 0; i < count(); ++i) {
    Axis& own = at(i);
    own.by_text = false;
    if (own.ours) continue;
    if (snapshot_.axes[i].ended_by == EndedBy::nothing) comes_home(i);
    own.at_home = AtHome::nothing;
  }
}

// ---- motions of the console

Motions::Before Motions::begin(const Way& way) {
  Before before{};
  for (int i = 0; i < count(); ++i) {
    if ((way.axes >> i & 1) == 0) continue;
    Axis& own = at(i);
    before[ix(i)] = {own.wanted, own.group, own.ours, own.by_text};
    own.wanted = way.activity;
    own.ours = true;
    own.at_home = way.at_home;
    own.group = (way.axes & (way.axes - 1)) != 0 ? way.axes : 0;
    own.done = own.stopping = own.by_text = own.asks_queue = false;
    AxisState& axis = snapshot_.axes[i];
    begin_motion(axis, way.activity);
    axis.has_target = way.has_targets;
    axis.target = way.targets[ix(i)];
    if (!jogs(i)) creeps(i, {});
    limits_.begins(i, !moving(i));
    own.still_since = wire_.now();
    loops_.begins(i, !jogs(i));
  }
  return before;
}

void Motions::did_not_begin(const Way& way, const Before& before, bool may_begin) {
  for (int i = 0; i < count(); ++i) {
    if ((way.axes >> i & 1) == 0) continue;
    Axis& own = at(i);
    const Earlier& earlier = before[ix(i)];  // an axis still moving continues its earlier motion
    own.wanted = earlier.wanted;
    own.group = earlier.group;
    own.ours = moving(i) && earlier.ours;
    own.by_text = may_begin || (moving(i) && earlier.by_text);
    own.at_home = AtHome::nothing;
    snapshot_.axes[i].has_target = false;
    show_still(i, wire_.now());
  }
  if (may_begin) next_.awaits_queues();
}

void Motions::end(int i, EndedBy ended_by) {
  AxisState& axis = snapshot_.axes[i];
  Axis& own = at(i);
  // The switch ended the motion before the stop. If the axis stood on that switch at its start, it must have
  // turned since.
  if (ended_by == EndedBy::stop && limits_.has_turned(i) && limits_.met(i)) ended_by = EndedBy::limit;
  ended_by = loops_.judged(i, ended_by);
  if (ended_by == EndedBy::target) comes_home(i);
  own.at_home = AtHome::nothing;
  end_motion(axis, ended_by);
  own.ours = own.stopping = own.done = own.by_text = own.asks_queue = false;
  own.group = 0;
  own.wanted = Activity::idle;
  creeps(i, {});
  limits_.rests(i);
  if (ended_by != EndedBy::limit) return;
  limits_.ended_there(i);
  next_.asks_flags();
}

/// A motion to the home switch has ended there. KM and KR stop from VL without a ramp.
void Motions::comes_home(int i) {
  const AtHome how = std::exchange(at(i).at_home, AtHome::nothing);
  if (how == AtHome::sets_counter) trust(i, Trust::homed);
  if (how == AtHome::stops_dead)
    doubt_killed_position(i, static_cast<double>(readings_.value(i, AxisValue::maximum_velocity)));
}

void Motions::trust(int axis, Trust how) { snapshot_.axes[axis].trust.settle(how, wire_.now()); }

/// The axis is driven to its command, or its command set to the axis: the reported end of its last motion no
/// longer holds.
void Motions::begins_to_settle(int i) {
  if (moving(i)) return;
  loops_.begins_to_settle(i);
  show_still(i, wire_.now());
}

void Motions::stopping(int axis, bool at_once) {
  for (int i = 0; i < count(); ++i) {
    if (axis >= 0 && i != axis) continue;
    Axis& own = at(i);
    creeps(i, {});
    own.at_home = AtHome::nothing;  // a queued homing is dropped by the stop
    loops_.begins(i, false);
    if (at_rest(i)) continue;
    own.ended_by = ended_by_stop(own.stopping ? own.ended_by : EndedBy::nothing, at_once);
    own.stopping = true;
    snapshot_.axes[i].activity = Activity::stopping;
  }
}

// The stop is over: its axes are shown as they are again.
void Motions::stands(int axis) {
  for (int i = 0; i < count(); ++i) {
    if (axis >= 0 && i != axis) continue;
    if (!at(i).stopping) continue;
    if (moving(i))
      at(i).stopping = false;
    else
      end(i, at(i).ended_by);
  }
}

void Motions::moved_by_others(int axis) {
  Axis& own = at(axis);
  own.ours = own.stopping = false;
  own.by_text = true;
  own.wanted = Activity::idle;
}

// ---- motions of texts and programs

/// Clears the reported end of each axis concerned, which belongs to an earlier motion. A jog leaves its queue
/// at once, and may be so slow that the axis seems to rest.
void Motions::note(const TextCommand& command) {
  const Op op = command.fact->op;
  const bool jogs = op == Op::JG || op == Op::JF;
  if (!jogs && !stops_motion(op) && !moves_in_queue(op)) return;
  if (!stops_motion(op)) snapshot_.program.ended_by = EndedBy::nothing;
  const bool one = command.context.mode == where::single && (jogs || op == Op::ST || moves_in_queue(op));
  for (int i = 0; i < count(); ++i)
    if (!one || i == command.context.axis) note_of_axis(i, command, one);
}

void Motions::note_of_axis(int i, const TextCommand& command, bool one) {
  const Op op = command.fact->op;
  const bool jogs = op == Op::JG || op == Op::JF, stops = stops_motion(op);
  const std::size_t place = one ? 0 : ix(i);
  const bool meant = place < command.numbers.size() && command.numbers[place].has_value();
  if (jogs && !meant) return;
  Axis& own = at(i);
  if (!own.ours && !stops && !std::exchange(own.by_text, true)) {
    limits_.begins(i, !moving(i));
    snapshot_.axes[i].ended_by = EndedBy::nothing;
  }
  loops_.goes_to_place(i, !jogs && !stops);
  if (op == Op::HM || op == Op::HR)
    own.at_home = one ? AtHome::sets_counter : AtHome::nothing;
  else if (op == Op::KM || op == Op::KR)
    own.at_home = AtHome::stops_dead;
  else if (jogs || stops)
    own.at_home = AtHome::nothing;
  const double speed = jogs ? std::abs(*command.numbers[place]) : 0;
  if (jogs) will_jog(i, speed);
  creeps(i, speed > 0 ? jog_gap(i, speed) : Duration::zero());
}

void Motions::note_group(const TextCommand& command) {
  if (!command.fact || command.fact->when != When::queued || command.context.mode == where::single) return;
  const bool contour = command.is(Op::CX), begins = command.is(Op::GO) || command.is(Op::GD);
  const bool all = command.is(Op::KM) || command.is(Op::KR) || (contour && command.context.contour_axes == 0);
  for (int i = 0; i < count(); ++i) {
    Axis& own = at(i);
    const bool named = ix(i) < command.numbers.size() && command.numbers[ix(i)].has_value();
    const bool listed = command.fact->shape == Shape::list && named;
    const bool drawn = contour && (command.context.contour_axes >> i & 1) != 0;
    own.listed = own.listed || listed;
    if (all || drawn || listed || (begins && own.listed)) own.in_group = true;
  }
}

void Motions::others_may_move_all() {
  for (Axis& own : axes_) own.in_group = own.listed = true;
}

void Motions::program_begins() {
  for (int i = 0; i < count(); ++i) {
    limits_.begins(i, true);
    at(i).by_text = false;
    snapshot_.axes[i].ended_by = EndedBy::nothing;
  }
}

void Motions::program_ends() {
  for (Axis& own : axes_) own.by_text = own.in_group = false, own.at_home = AtHome::nothing;
}

bool Motions::met_limit() const {
  for (int i = 0; i < count(); ++i)
    if (limits_.has_turned(i) && limits_.met(i)) return true;
  return false;
}

void Motions::come_home() {
  for (int i = 0; i < count(); ++i) comes_home(i);
}

void Motions::queued_was_rejected() {
  for (Axis& own : axes_)
    if (!own.ours) own.at_home = AtHome::nothing;
}

// ---- how long a motion may be invisible

/// How long a turning axis may show neither velocity nor count, on a very gentle ramp. The axis' own queue
/// shows its motion only when it moves alone.
Duration Motions::rest_patience(int i) const {
  const Axis& own = at(i);
  if (own.group == 0 && !jogs(i)) return rest_time;
  return std::max(jog_gap(i, 1), own.jog_gap);
}

Duration Motions::jog_gap(int i, double speed) const {
  const auto acceleration =
      static_cast<double>(std::max<std::int64_t>(1, readings_.value(i, AxisValue::acceleration)));
  const double ramp_s = 2 * std::sqrt(2 / acceleration);
  const double count_s = speed > 0 && speed < 1 ? 1.5 / speed : 0;
  return rest_time + from_seconds(ramp_s + count_s);
}

void Motions::will_jog(int axis, double speed) { at(axis).jog_gap = jog_gap(axis, speed); }

void Motions::creeps(int i, Duration gap) {
  at(i).jog_gap = gap;
  at(i).creeps_until = gap > Duration::zero() ? wire_.now() + gap : Instant{};
}

void Motions::met_switches(unsigned axes) {
  for (int i = 0; i < count(); ++i)
    if (bit(axes, i)) creeps(i, {});
}

void Motions::doubt_killed_position(int i, double speed) {
  const std::int64_t safe = readings_.value(i, AxisValue::base_velocity);
  if (catalog_.axes[ix(i)].switchable) return;
  const Kill kill{.axis = "Axis " + catalog_.axes[ix(i)].name,
                  .speed = speed,
                  .safe = static_cast<double>(safe),
                  .unit = "counts/s",
                  .safe_word = fmt::format("{} (VB)", safe)};
  std::string doubt = doubt_killed(snapshot_.axes[i], kill, wire_.now());
  if (!doubt.empty()) wire_.report(Notice::Kind::warning, std::move(doubt));
}

void Motions::lose(bool program_runs) {
  for (int i = 0; i < count(); ++i) {
    const bool waits = at(i).by_text && (snapshot_.working || program_runs);
    if (!at_rest(i) || waits) snapshot_.axes[i].ended_by = EndedBy::lost;
  }
}

void Motions::forget() {
  axes_ = {};
  for (int i = 0; i < count(); ++i) {
    AxisState& axis = snapshot_.axes[i];
    axis.limits_known = false;
    axis.activity = Activity::unknown;
    axis.speed = axis.own_speed = {};
    axis.direction = 0;
  }
}

}  // namespace hw::vme58
