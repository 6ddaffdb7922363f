// Threads and turns. vm_statement.cpp runs single statements.
#include "core/devices/arcus/language/vm.h"

#include <algorithm>
#include <utility>

#include "core/devices/arcus/language/vm_statement.h"

namespace hw::arcus::language {
namespace {

constexpr Duration turn_length = std::chrono::milliseconds(1);

Turn turn_at_or_before(Instant t) {
  const auto ns = t.time_since_epoch().count(), length = turn_length.count();
  return ns >= 0 ? ns / length : -((-ns + length - 1) / length);
}
Turn turn_at_or_after(Instant t) { return turn_at_or_before(t + turn_length - Duration(1)); }
Instant instant_of(Turn turn) { return Instant(turn * turn_length); }

}  // namespace

void Vm::load(std::shared_ptr<const Program> program) {
  program_ = std::move(program);
  for (Thread& thread : threads_) thread = {};
  for (int n = 0; n < max_programs; ++n)
    threads_[n].line = threads_[n].first_line = program_->programs[n].value_or(0);
}

void Vm::stop_all() {
  for (Thread& thread : threads_) thread.state = ThreadState::stopped;
}

Turn Vm::first_turn(Instant now) const { return std::max(turn_at_or_after(now), last_turn_ + 1); }

void Vm::start(Thread& thread, std::uint16_t line, Turn turn) {
  thread = {};
  thread.state = ThreadState::running;
  const bool headed = program_->code[line].op == Opcode::prg;  // a heading costs no turn (AMB-127)
  thread.line = thread.first_line = static_cast<std::uint16_t>(headed ? line + 1 : line);
  thread.due = turn;
}

bool Vm::control(int program, int command, Instant now) {
  if (program < 0 || program >= max_programs || command < 0 || command > 3) return false;
  Thread& thread = threads_[program];
  const bool leaves = command == 0 || command == 2;
  if (leaves && thread.state == ThreadState::running && thread.loop.idle()) catch_up(thread, first_turn(now));
  switch (command) {
    case 0: thread.state = ThreadState::stopped; break;
    case 1:
      if (thread.state != ThreadState::running && program_->programs[program])
        start(thread, *program_->programs[program], first_turn(now));
      break;
    case 2:
      if (thread.state == ThreadState::running) thread.state = ThreadState::paused;
      break;
    default:
      if (thread.state != ThreadState::paused) break;
      thread.state = ThreadState::running;
      thread.loop = {};
      thread.due = std::max(thread.due, first_turn(now));
  }
  return true;
}

Vm::Call Vm::call(int sub, Instant now) {
  if (sub < 0 || sub >= subroutines || !program_->subs[sub]) return Call::undefined;
  Thread& thread = threads_[gs_thread];
  if (thread.state == ThreadState::running) return Call::busy;
  start(thread, *program_->subs[sub], first_turn(now));
  thread.frames[thread.depth++] = {0, static_cast<std::uint8_t>(sub), false};
  return Call::started;
}

bool Vm::idles(const Thread& thread, const VmHost& host) const {
  return thread.loop.idle() && thread.loop.unchanged([&](const Operand& o) { return value_of(o, host); });
}

std::optional<Instant> Vm::next_turn(Instant now, const VmHost& host) const {
  std::optional<Turn> next;
  for (const Thread& thread : threads_) {
    if (thread.state != ThreadState::running) continue;
    const Turn first = first_turn(now);
    Turn turn = thread.due;
    if (!thread.waits_for.empty()) {
      if (!can_go_on(thread.waits_for, host)) continue;
      turn = std::max(turn, first);
    } else if (thread.loop.idle()) {
      if (idles(thread, host)) continue;
      turn = thread.loop.place_at(first).turn;
    }
    if (!next || turn < *next) next = turn;
  }
  if (!next) return std::nullopt;
  return instant_of(*next);
}

void Vm::run_turn(Instant now, VmHost& host) {
  const Turn turn = turn_at_or_before(now);
  if (turn <= last_turn_) return;
  last_turn_ = turn;
  for (Thread& thread : threads_)
    if (thread.state == ThreadState::running) run_thread(thread, turn, host);
}

void Vm::run_thread(Thread& thread, Turn turn, VmHost& host) {
  if (thread.loop.idle()) {
    if (idles(thread, host)) return;
    catch_up(thread, turn);
  }
  if (thread.due > turn) return;
  thread.delay_at.reset();
  thread.loop.runs(thread.line, turn);
  thread.waits_for = {};
  thread.due = turn + 1;
  line_at_work_ = thread.line;
  const Next next = Statement(*this, thread, turn, host).run();
  line_at_work_ = -1;
  switch (next.kind) {
    case Next::Kind::go: thread.line = next.line; break;
    case Next::Kind::wait: thread.waits_for = next.axes; break;
    case Next::Kind::fail: fail(thread, next.trouble, turn); break;
    case Next::Kind::leave: break;
  }
}

void Vm::catch_up(Thread& thread, Turn turn) const {
  const auto last = thread.loop.ran_last(turn - 1);
  const LoopWatch::Place next = thread.loop.place_at(turn);
  thread.delay_at.reset();
  if (last && program_->code[*last].op == Opcode::delay) thread.delay_at = last;
  thread.line = next.line;
  thread.due = next.turn;
  thread.loop = {};
}

int Vm::line(int program, Instant now) const {
  const Thread& thread = threads_[program];
  if (thread.state != ThreadState::running || !thread.loop.idle())
    return thread.delay_at.value_or(thread.line);
  Thread by_now = thread;
  catch_up(by_now, first_turn(now));
  return by_now.delay_at.value_or(by_now.line);
}

bool Vm::Thread::handles_error() const {
  return std::any_of(frames.begin(), frames.begin() + depth,
                     [](const Frame& f) { return f.sub == error_subroutine; });
}

void Vm::fail(Thread& thread, Trouble trouble, Turn turn) {
  thread.trouble = trouble;
  thread.loop = {};
  const auto handler = program_->subs[error_subroutine];
  if (thread.handles_error() || !handler) {
    thread.state = ThreadState::error;
    return;
  }
  thread.frames[thread.depth++] = {thread.line, error_subroutine, true};
  thread.line = *handler;
  thread.due = turn + 1;
}

std::int32_t Vm::value_of(const Operand& operand, const VmHost& host) const {
  switch (operand.kind) {
    case Operand::Kind::number: return operand.number;
    case Operand::Kind::variable: return variables_[operand.number];
    case Operand::Kind::quantity: return host.read(operand.quantity, operand.index);
  }
  return 0;
}

}  // namespace hw::arcus::language
