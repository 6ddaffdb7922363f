#include "core/devices/vxm/program_watch.h"

#include <algorithm>

#include "core/base/index.h"

namespace hw::vxm {
namespace {

constexpr std::size_t most_stops = 200;

/// U11, U12 and the like skip the next command by an input. U13 and U23 go on in another program by a button.
/// A loop with one of them inside may be left.
bool may_lead_off(const Command& c) {
  const int u = c.value % slave_u_offset;
  return c.op == Op::user && (u == 11 || u == 12 || u == 21 || u == 22 || u == 13 || u == 23);
}

/// The same for a program and the programs that it reaches. `seen`: bit per program already checked.
bool may_lead_off(const Box& box, int program, std::uint32_t seen = 0) {
  if ((seen >> program & 1u) != 0) return false;
  seen |= 1u << program;
  const auto& commands = box.program(program).commands();
  return std::any_of(commands.begin(), commands.end(), [&](const Command& c) {
    const bool goes = c.op == Op::jump || c.op == Op::call || c.op == Op::call_pick;
    return may_lead_off(c) || (goes && may_lead_off(box, c.value, seen));
  });
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

void ProgramWatch::observe(const Trace& trace, const Box& box) {
  if (trace.command >= 0) {
    program_ = trace.program, command_ = trace.command;
    const Program& program = box.program(program_);
    if (command_ < program.size()) note_command(program[command_]);
  }
  if (trace.limit == 0 || stops_.size() == most_stops) return;
  const std::string motor = std::to_string(trace.motor);
  RehearsedStop at_limit = stop(trace.at, "Motor " + motor + " runs into its " +
                                              (trace.limit > 0 ? "plus" : "minus") + " limit switch.");
  at_limit.axis = motor, at_limit.direction = trace.limit;
  stops_.push_back(std::move(at_limit));
}

void ProgramWatch::note_command(const Command& c) {
  switch (c.op) {
    case Op::loop_endless:
    case Op::jump:
      loop_program_ = program_, loop_at_ = command_;
      ++times_back_[{loop_program_, loop_at_}];
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

std::vector<ProgramWatch::Part> ProgramWatch::way_round(const Box& box) const {
  const Program& own = box.program(loop_program_);
  const bool jumps = own[loop_at_].op == Op::jump;
  int program = jumps ? own[loop_at_].value : loop_program_;
  int first = jumps ? 0 : own.loop_target(loop_at_);
  std::vector<Part> way;
  while (way.size() < ix(program_count)) {
    const Program& here = box.program(program);
    int at = first;
    for (; at < here.size() && here[at].op != Op::jump && here[at].op != Op::loop_endless; ++at) {
      const bool calls = here[at].op == Op::call || here[at].op == Op::call_pick;
      if (may_lead_off(here[at]) || (calls && may_lead_off(box, here[at].value))) return {};
    }
    if (at == here.size()) return {};
    way.push_back({program, first, at});
    if (program == loop_program_ && at == loop_at_) return way;
    if (here[at].op != Op::jump) return {};
    program = here[at].value, first = 0;
  }
  return {};
}

bool ProgramWatch::knows_loop(const Box& box) const {
  return loop_at_ >= 0 && loop_at_ < box.program(loop_program_).size();
}

bool ProgramWatch::endless(const Box& box) const { return knows_loop(box) && !way_round(box).empty(); }

std::string ProgramWatch::part_words(const Part& part) const {
  const int first = line_of(part.program, part.first), last = line_of(part.program, part.last);
  return first < 0 || last < 0 ? "program " + std::to_string(part.program)
                               : lines_words(std::min(first, last), last);
}

std::string ProgramWatch::loop_words(const Box& box) const {
  if (!knows_loop(box)) return {};
  const Program& program = box.program(loop_program_);
  const bool jumps = program[loop_at_].op == Op::jump;
  std::vector<Part> way = way_round(box);
  const bool closed = !way.empty();
  if (!closed) {
    if (jumps && times_back_.at({loop_program_, loop_at_}) < 2) return {};  // a jump forward, not a loop
    way.push_back({loop_program_, jumps ? 0 : program.loop_target(loop_at_), loop_at_});
  }
  std::sort(way.begin(), way.end(), [](const Part& a, const Part& b) { return a.program < b.program; });
  std::string where;
  for (const Part& part : way) where += (where.empty() ? "" : " and ") + part_words(part);
  return "the loop of " + where + " (" + listing_of(program[loop_at_]) + ") " +
         (closed ? "has no end" : "had not ended");
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
