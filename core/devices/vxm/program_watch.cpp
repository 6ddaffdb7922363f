#include "core/devices/vxm/program_watch.h"

#include <algorithm>

#include "core/base/index.h"

namespace hw::vxm {
namespace {

constexpr std::size_t most_stops = 200;

/// U11, U12 and the like leave out the next command when an input is low: with one of them inside, a loop
/// may be left.
bool may_skip(const Command& c) {
  return c.op == Op::user && (c.value == 11 || c.value == 12 || c.value == 21 || c.value == 22);
}

std::string lines_words(int first, int last) {
  if (first == last) return "line " + std::to_string(last + 1);
  return "lines " + std::to_string(first + 1) + " to " + std::to_string(last + 1);
}

}  // namespace

int ProgramWatch::line_of(int program, int command) const {
  const auto found = analysis_.programs.find(program);
  if (found == analysis_.programs.end() || command < 0) return -1;
  return ix(command) < found->second.size() ? found->second[ix(command)].place.line : -1;
}

std::string ProgramWatch::place_words() const {
  const int line = line_of(program_, command_);
  const std::string program = "Program " + std::to_string(std::max(0, program_));
  return line < 0 ? program : program + ", line " + std::to_string(line + 1);
}

RehearsedStop ProgramWatch::stop(Instant at, std::string reason) const {
  RehearsedStop stop;
  stop.t = seconds(at.time_since_epoch());
  stop.line = line_of(program_, command_);
  stop.reason = std::move(reason);
  return stop;
}

void ProgramWatch::hear(const Trace& trace, const Box& box) {
  if (trace.command >= 0) {
    program_ = trace.program, command_ = trace.command;
    const Program& program = box.program(program_);
    if (command_ < program.size()) hear_command(program[command_]);
  }
  if (trace.limit == 0 || stops_.size() == most_stops) return;
  const std::string motor = std::to_string(trace.motor);
  RehearsedStop at_limit = stop(trace.at, "Motor " + motor + " runs into its " +
                                              (trace.limit > 0 ? "plus" : "minus") + " limit switch.");
  at_limit.axis = motor, at_limit.direction = trace.limit;
  stops_.push_back(std::move(at_limit));
}

void ProgramWatch::hear_command(const Command& c) {
  switch (c.op) {
    case Op::loop_endless:
    case Op::jump:
      jumps_ = loop_program_ == program_ && loop_at_ == command_ ? jumps_ + 1 : 1;
      loop_program_ = program_, loop_at_ = command_;
      return;
    case Op::speed:
    case Op::speed_full:
    case Op::analog_speed:
    case Op::analog_speed_full: speed_set_[ix(c.motor - 1)] = true; return;
    case Op::accel: accel_set_[ix(c.motor - 1)] = true; return;
    case Op::group:
      for (const Command& part : c.parts) uses_speed(part);
      return;
    default: uses_speed(c);
  }
}

void ProgramWatch::uses_speed(const Command& c) {
  if (c.motor < 1 || c.motor > max_motors || c.op == Op::set_zero || !is_index(c.op)) return;
  const std::size_t motor = ix(c.motor - 1);
  speed_assumed_[motor] = speed_assumed_[motor] || !speed_set_[motor];
  accel_assumed_[motor] = accel_assumed_[motor] || !accel_set_[motor];
}

bool ProgramWatch::endless(const Box& box) const {
  if (loop_at_ < 0) return false;
  const Program& program = box.program(loop_program_);
  if (loop_at_ >= program.size()) return false;
  const bool jumps = program[loop_at_].op == Op::jump;
  if (jumps && jumps_ < 2) return false;
  const int first = jumps ? 0 : program.loop_target(loop_at_);
  return std::none_of(program.commands().begin() + first, program.commands().begin() + loop_at_, may_skip);
}

std::string ProgramWatch::loop_words(const Box& box) const {
  if (loop_at_ < 0) return {};
  const Program& program = box.program(loop_program_);
  if (loop_at_ >= program.size()) return {};
  const bool jumps = program[loop_at_].op == Op::jump;
  const int last = line_of(loop_program_, loop_at_);
  const int first = line_of(loop_program_, jumps ? 0 : program.loop_target(loop_at_));
  const std::string where = last < 0 || first < 0 ? "program " + std::to_string(loop_program_)
                                                  : lines_words(std::min(first, last), last);
  return "the loop of " + where + " (" + listing_of(program[loop_at_]) + ") " +
         (endless(box) ? "has no end" : "was going round");
}

std::vector<RehearsedAssumption> ProgramWatch::assumptions() const {
  std::vector<RehearsedAssumption> all;
  for (int m = 0; m < max_motors; ++m) {
    const std::string motor = std::to_string(m + 1) + "M";
    if (speed_assumed_[ix(m)])
      all.push_back({"S" + motor, std::to_string(default_speed) + " steps/s, as after power-up"});
    if (accel_assumed_[ix(m)])
      all.push_back({"A" + motor, std::to_string(default_accel) + ", as after power-up"});
  }
  return all;
}

}  // namespace hw::vxm
