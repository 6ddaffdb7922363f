#include "fake_controller.h"

#include <algorithm>
#include <cstdlib>

#include <gtest/gtest.h>

namespace hw::arcus::language {
namespace {

constexpr std::int32_t far_away = 100'000'000;

std::pair<Quantity, int> key_of(const Dialect& dialect, std::string_view name) {
  const auto digits = name.find_first_of("0123456789");
  const int number = digits == std::string_view::npos ? -1 : std::atoi(name.data() + digits);
  const auto found = find_name(dialect, name.substr(0, digits), number);
  if (!found) {
    ADD_FAILURE() << "no name: " << name;
    return {};
  }
  return {found->row->quantity, found->index};
}

}  // namespace

void FakeController::set(std::string_view name, std::int32_t value) {
  values[key_of(dialect_, name)] = value;
}

std::int32_t FakeController::get(std::string_view name) const {
  const auto [quantity, index] = key_of(dialect_, name);
  return read(quantity, index);
}

std::int32_t FakeController::position(int axis) const {
  const Axis& a = axes_[axis];
  if (!a.moving || now >= a.ends) return a.to;
  const double part = seconds(now - a.began) / seconds(a.ends - a.began);
  return a.from + static_cast<std::int32_t>((a.to - a.from) * part);
}

std::optional<Instant> FakeController::next_rest() const {
  std::optional<Instant> next;
  for (const Axis& a : axes_)
    if (a.moving && !a.endless && (!next || a.ends < *next)) next = a.ends;
  return next;
}

void FakeController::settle() {
  for (Axis& a : axes_)
    if (a.moving && !a.endless && now >= a.ends) {
      a.moving = false;
      if (a.homing) a.to = 0;
      a.homing = false;
    }
}

std::int32_t FakeController::read(Quantity quantity, int index) const {
  if (quantity == Quantity::pulse_position) return position(index);
  const auto found = values.find({quantity, index});
  if (found != values.end()) return found->second;
  if (quantity == Quantity::motor_status) return axes_[index].moving ? 4 : 0;
  return quantity == Quantity::high_speed ? 1000 : 0;
}

Outcome FakeController::write(Quantity quantity, int index, std::int32_t value) {
  if (quantity == Quantity::high_speed && value <= 0) return Outcome::error;
  if (quantity == Quantity::pulse_position) {
    if (moving(index)) return Outcome::busy;
    axes_[index].to = value;
  }
  if (quantity == Quantity::comm_timeout) values.erase({Quantity::motor_status, 0});  // AMB-044
  values[{quantity, index}] = value;
  return Outcome::done;
}

void FakeController::begin(int axis, std::int32_t to) {
  Axis& a = axes_[axis];
  const std::int32_t from = position(axis);
  together(one_axis(axis));
  a = {true, std::abs(to) == far_away, false, from, to, now, now, one_axis(axis)};
  a.ends += from_seconds(std::abs(double(to) - from) / read(Quantity::high_speed, 0));
  if (a.ends == now) a.moving = false;
}

void FakeController::together(AxisSet axes) {
  for (int axis = 0; axis < max_axes; ++axis) {
    AxisSet& with = axes_[axis].with;
    with = axes.has(axis) ? axes : AxisSet{static_cast<std::uint8_t>(with.bits & ~axes.bits)};
  }
}

Outcome FakeController::move(const Move& move) {
  if (busy) return Outcome::busy;
  if (refuses_moves) return Outcome::error;
  std::string what = "move";
  for (int axis = 0; axis < max_axes; ++axis) {
    if (!move.axes.has(axis)) continue;
    what += " " + letter_of(axis) + std::to_string(move.target[axis]);
    begin(axis, (absolute_ ? 0 : position(axis)) + move.target[axis]);
  }
  together(move.axes);
  done.push_back(what);
  return Outcome::done;
}

Outcome FakeController::arc(const Arc& arc) {
  done.push_back(std::string(arc.full_circle ? "circle " : "arc ") + (arc.clockwise ? "cw " : "ccw ") +
                 std::to_string(arc.centre_x) + " " + std::to_string(arc.centre_y));
  if (!arc.full_circle)
    done.back() += " to " + std::to_string(arc.end_angle) + " by " + std::to_string(arc.swept_angle);
  begin(0, position(0) + 10), begin(1, position(1) + 10);
  together({0b11});
  return Outcome::done;
}

Outcome FakeController::home(int axis, HomeMode mode, Sign direction) {
  static constexpr const char* modes[] = {"switch", "limit", "switch and index", "index", "switch slow"};
  done.push_back("home " + letter_of(axis) + letter(direction) + " " + modes[static_cast<int>(mode)]);
  begin(axis, position(axis) + (direction == Sign::plus ? 50 : -50));
  axes_[axis].homing = true;
  return Outcome::done;
}

Outcome FakeController::jog(int axis, Sign direction) {
  done.push_back("jog " + letter_of(axis) + letter(direction));
  begin(axis, direction == Sign::plus ? far_away : -far_away);
  return Outcome::done;
}

void FakeController::halt(AxisSet axes, const char* word) {
  std::string what = word;
  for (int axis = 0; axis < max_axes; ++axis) {
    if (!axes.has(axis)) continue;
    what += " " + letter_of(axis);
    const std::int32_t here = position(axis);
    axes_[axis].moving = false;
    axes_[axis].to = here;
  }
  done.push_back(what);
}

void FakeController::stop(AxisSet axes) { halt(axes, "stop"); }
void FakeController::abort(AxisSet axes) { halt(axes, "abort"); }

void FakeController::set_absolute(bool absolute) {
  absolute_ = absolute;
  done.emplace_back(absolute ? "absolute" : "incremental");
}

void FakeController::clear_error(int axis) {
  error[axis] = false;
  done.push_back("clear " + letter_of(axis));
}

void FakeController::arm_sync(int axis, bool on) {
  done.push_back(std::string(on ? "sync on " : "sync off ") + letter_of(axis));
}

void Workbench::load(const std::string& text) {
  compiled = compile(text, dialect);
  for (const Problem& p : compiled.problems)
    if (p.error) ADD_FAILURE() << "line " << p.line + 1 << ": " << p.sentence << "\n" << text;
  // By way of the lines, as it reaches a controller.
  vm.load(std::make_shared<const Program>(decode(compiled.lines, dialect)));
}

void Workbench::run_for(Duration time) {
  const Instant until = now + time;
  for (;;) {
    const auto turn = vm.next_turn(now, host), rest = host.next_rest();
    const Instant next = std::min(turn.value_or(Instant::max()), rest.value_or(Instant::max()));
    if (next > until) break;
    now = host.now = std::max(now, next);
    host.settle();
    if (turn && *turn <= now) {
      vm.run_turn(now, host);
      ++turns;
    }
  }
  now = host.now = until;
  host.settle();
}

int Workbench::source_line(int program) const {
  const auto line = static_cast<std::size_t>(vm.line(program, now));
  return line < compiled.source_line.size() ? compiled.source_line[line] + 1 : 0;
}

}  // namespace hw::arcus::language
