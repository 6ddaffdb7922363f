#include "core/devices/arcus/language/vm_statement.h"

#include "core/devices/arcus/language/arithmetic.h"

namespace hw::arcus::language {

bool can_go_on(AxisSet axes, const VmHost& host) {
  bool at_rest = true;
  for (int axis = 0; axis < max_axes; ++axis) {
    if (!axes.has(axis)) continue;
    if (host.in_error(axis)) return true;
    if (host.moving(axis)) at_rest = false;
  }
  return at_rest;
}

Vm::Next Vm::Statement::run() {
  const auto& code = vm_.program_->code;
  if (thread_.line >= code.size()) return fail(Trouble::bad_line);
  i_ = &code[thread_.line];
  switch (i_->op) {  // statements that change nothing; the others follow below
    case Opcode::empty:
    case Opcode::continued:
    case Opcode::bad: return fail(Trouble::bad_line);
    case Opcode::prg:
    case Opcode::sub:
    case Opcode::endif: return go_on();
    case Opcode::if_:
    case Opcode::while_: return test(*i_, thread_.line + 2);
    case Opcode::test: return test(code[thread_.line - 1], thread_.line + 1);
    case Opcode::elseif:
    case Opcode::else_: return go_to(i_->link);  // the branch above has run
    case Opcode::endwhile: return go_round();
    case Opcode::set: return set();
    case Opcode::compute: return compute_value();
    case Opcode::delay: return delay();
    default: thread_.loop.has_changed_something(); return run_effect();
  }
}

Vm::Next Vm::Statement::run_effect() {
  const int axis = i_->axes.first();
  switch (i_->op) {
    case Opcode::end: return end();
    case Opcode::gosub: return call();
    case Opcode::endsub: return return_from_sub();
    case Opcode::run: return control();
    case Opcode::wait: return wait();
    case Opcode::move: return move();
    case Opcode::arc_clockwise:
    case Opcode::arc_counterclockwise:
    case Opcode::circle_clockwise:
    case Opcode::circle_counterclockwise: return arc();
    case Opcode::home_switch: return home(HomeMode::switch_only);
    case Opcode::home_limit: return home(HomeMode::limit);
    case Opcode::home_switch_index: return home(HomeMode::switch_and_index);
    case Opcode::home_index: return home(HomeMode::index_only);
    case Opcode::home_switch_slow: return home(HomeMode::switch_slow);
    case Opcode::jog: return jog();
    case Opcode::stop: host_.stop(i_->axes); return go_on();
    case Opcode::abort: host_.abort(i_->axes); return go_on();
    case Opcode::absolute: host_.set_absolute(true); return go_on();
    case Opcode::incremental: host_.set_absolute(false); return go_on();
    case Opcode::clear_error: host_.clear_error(axis); return go_on();
    case Opcode::sync_on: host_.arm_sync(axis, true); return go_on();
    case Opcode::sync_off: host_.arm_sync(axis, false); return go_on();
    case Opcode::store: host_.store(); return go_on();
    default: return fail(Trouble::bad_line);
  }
}

std::int32_t Vm::Statement::value(const Operand& operand) {
  const std::int32_t value = vm_.value_of(operand, host_);
  thread_.loop.has_read(operand, value);
  return value;
}

void Vm::Statement::put(int variable, std::int32_t value) {
  std::int32_t& kept = vm_.variables_[static_cast<std::size_t>(variable)];
  if (kept != value) thread_.loop.has_changed_something();
  kept = value;
  thread_.loop.has_read(variable_operand(variable), value);  // a write by another wakes the loop
}

Vm::Next Vm::Statement::outcome(Outcome outcome, AxisSet axes) {
  if (outcome == Outcome::busy) return wait_for(axes);
  return outcome == Outcome::done ? go_on() : fail(Trouble::refused);
}

std::optional<Vm::Next> Vm::Statement::obstacle(AxisSet axes) const {
  bool moving = false;
  for (int axis = 0; axis < max_axes; ++axis) {
    if (!axes.has(axis)) continue;
    if (host_.in_error(axis)) return fail(Trouble::axis_in_error);
    moving |= host_.moving(axis);
  }
  if (moving) return wait_for(axes);
  return std::nullopt;
}

Vm::Next Vm::Statement::end() {
  thread_.state = ThreadState::stopped;
  return {Kind::leave, 0, {}, {}};
}

Vm::Next Vm::Statement::call() {
  const int number = i_->values[0].number;
  const auto sub = vm_.program_->subs[static_cast<std::size_t>(number)];
  if (!sub) return fail(Trouble::undefined_sub);
  const int base = &thread_ == &vm_.threads_[gs_thread] ? 1 : 0;
  if (thread_.depth - base >= max_call_depth) return fail(Trouble::too_deep);
  const auto back = static_cast<std::uint16_t>(thread_.line + 1);
  thread_.frames[thread_.depth++] = {back, static_cast<std::uint8_t>(number), false};
  return go_to(*sub);
}

Vm::Next Vm::Statement::return_from_sub() {
  if (thread_.depth == 0) return fail(Trouble::bad_line);
  const Frame frame = thread_.frames[--thread_.depth];
  const bool gs = &thread_ == &vm_.threads_[gs_thread];
  if (gs && thread_.depth == 0) return end();
  if (!frame.after_error || !host_.error_returns_to_start()) return go_to(frame.return_line);
  thread_.depth = gs ? 1 : 0;
  return go_to(thread_.first_line);
}

Vm::Next Vm::Statement::control() {
  thread_.line = static_cast<std::uint16_t>(thread_.line + 1);  // first: it may be this very thread
  vm_.control(i_->values[0].number, i_->values[1].number, Instant(std::chrono::milliseconds(turn_)));
  return {Kind::leave, 0, {}, {}};
}

Vm::Next Vm::Statement::test(const Instruction& condition, int if_true) {
  const std::int32_t a = value(condition.values[0]), b = value(condition.values[1]);
  return go_to(holds(condition.comparison, a, b) ? if_true : condition.if_false);
}

Vm::Next Vm::Statement::go_round() {
  thread_.loop.goes_round(i_->link, turn_ + 1);
  return go_to(i_->link);
}

Vm::Next Vm::Statement::set() {
  const std::int32_t wanted = value(i_->values[0]);
  const Operand& target = i_->target;
  if (target.kind == Operand::Kind::variable) {
    put(target.number, wanted);
    return go_on();
  }
  thread_.loop.has_changed_something();
  const AxisSet axes = has_axis(target.quantity) ? one_axis(target.index) : AxisSet{};
  return outcome(host_.write(target.quantity, target.index, wanted), axes);
}

Vm::Next Vm::Statement::compute_value() {
  const std::int32_t a = value(i_->values[0]), b = value(i_->values[1]);
  const auto result = compute(i_->operation, a, b);
  if (!result) return fail(Trouble::division_by_zero);
  put(i_->target.number, *result);
  return go_on();
}

Vm::Next Vm::Statement::wait() {
  // For an interpolated move WAIT may name any of its axes, and an error of any of them counts (AMB-114); SUB
  // 31 heeds only the axis it waits for.
  const AxisSet together = thread_.handles_error() ? AxisSet() : host_.moved_with(i_->axes.first());
  for (int axis = 0; axis < max_axes; ++axis)
    if (together.has(axis) && host_.in_error(axis)) return fail(Trouble::axis_in_error);
  const auto stands_still = obstacle(i_->axes);
  return stands_still ? *stands_still : go_on();
}

Vm::Next Vm::Statement::delay() {
  thread_.due = turn_ + i_->values[0].number;
  thread_.delay_at = thread_.line;
  return go_on();
}

Vm::Next Vm::Statement::move() {
  if (const auto in_the_way = obstacle(i_->axes)) return *in_the_way;
  Move move;
  move.axes = i_->axes;
  for (std::size_t axis = 0; axis < max_axes; ++axis)
    if (i_->axes.has(static_cast<int>(axis))) move.target[axis] = value(i_->values[axis]);
  return outcome(host_.move(move), i_->axes);
}

Vm::Next Vm::Statement::arc() {
  constexpr AxisSet xy{0b11};
  if (const auto in_the_way = obstacle(xy)) return *in_the_way;
  Arc arc;
  arc.clockwise = i_->op == Opcode::arc_clockwise || i_->op == Opcode::circle_clockwise;
  arc.full_circle = shape_of(i_->op) == Shape::centre;
  arc.centre_x = i_->values[0].number;
  arc.centre_y = i_->values[1].number;
  arc.end_angle = i_->values[2].number;
  arc.swept_angle = i_->values[3].number;
  return outcome(host_.arc(arc), xy);
}

Vm::Next Vm::Statement::home(HomeMode mode) {
  if (const auto in_the_way = obstacle(i_->axes)) return *in_the_way;
  return outcome(host_.home(i_->axes.first(), mode, i_->sign), i_->axes);
}

Vm::Next Vm::Statement::jog() {
  if (const auto in_the_way = obstacle(i_->axes)) return *in_the_way;
  return outcome(host_.jog(i_->axes.first(), i_->sign), i_->axes);
}

}  // namespace hw::arcus::language
