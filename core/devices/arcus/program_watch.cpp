#include "core/devices/arcus/program_watch.h"

#include <algorithm>

#include <fmt/format.h>

#include "core/base/index.h"
#include "core/devices/arcus/language/arithmetic.h"

namespace hw::arcus {
namespace {

constexpr std::size_t most_stops = 200;

std::string why_a_value_fails(const language::Instruction& i, const language::Dialect& dialect) {
  const std::string name = spell(dialect, i.target), value = spell(dialect, i.values[0]);
  return name + " cannot be set to " + (value.front() == 'V' ? "the value of " + value : value) + " here.";
}

std::string why_an_axis_fails(Refusal held_by) {
  switch (held_by) {
    case Refusal::limit_error:
      return "a limit switch has stopped one of its axes, and nothing has cleared the error.";
    case Refusal::alarm: return "one of its axes has an alarm.";
    case Refusal::loop_error: return "one of its axes has a StepNLoop error.";
    default: return "the controller refuses this motion.";
  }
}

/// `held_by`: what holds an axis of the statement.
std::string why_it_fails(const language::Instruction& i, const language::Program& program, Refusal held_by,
                         const language::Dialect& dialect) {
  using language::Opcode;
  switch (i.op) {
    case Opcode::compute: return "a division by zero.";
    case Opcode::set: return why_a_value_fails(i, dialect);
    case Opcode::gosub:
      return program.subs[ix(i.values[0].number)] ? "its calls nest more than eight deep."
                                                  : "there is no such subroutine.";
    case Opcode::endsub: return "nothing has called this subroutine.";
    case Opcode::empty:
    case Opcode::continued:
    case Opcode::bad: return "there is no program here.";
    default: return why_an_axis_fails(held_by);
  }
}

bool is_constant(const language::Instruction& test) {
  return test.values[0].kind == language::Operand::Kind::number &&
         test.values[1].kind == language::Operand::Kind::number;
}
bool holds_for_ever(const language::Instruction& test) {
  return is_constant(test) && holds(test.comparison, test.values[0].number, test.values[1].number);
}

}  // namespace

int ProgramWatch::source_line(int line) const {
  return line >= 0 && ix(line) < made_.source_line.size() ? made_.source_line[ix(line)] : -1;
}

/// "Program 0, line 7,"
std::string ProgramWatch::place_of(int program) const {
  const int line = source_line(controller_.program_place(program));
  const std::string name = "Program " + std::to_string(program);
  return line < 0 ? name : name + ", line " + std::to_string(line + 1) + ",";
}

/// Why the statement that stopped the program cannot be executed.
std::string ProgramWatch::reason_of(int program) const {
  const auto line = ix(controller_.program_place(program));
  if (line >= made_.program.code.size()) return "the code ends here.";
  const language::Instruction& i = made_.program.code[line];
  if (has_mixed_loops(i)) return "StepNLoop is on for some of its axes and off for others.";
  return why_it_fails(i, made_.program, error_among(i), dialect_);
}

/// Axes that count pulses and axes that count their encoders do not move together (decision AMB-101).
bool ProgramWatch::has_mixed_loops(const language::Instruction& i) const {
  int with = 0, without = 0;
  for (int axis = 0; axis < controller_.axes(); ++axis)
    if (i.axes.has(axis)) ++(controller_.settings().on(Setting::loop, axis) ? with : without);
  return with > 0 && without > 0;
}

/// The error that holds one of the axes the statement needs.
Refusal ProgramWatch::error_among(const language::Instruction& i) const {
  const bool arc = shape_of(i.op) == language::Shape::centre || shape_of(i.op) == language::Shape::arc;
  for (int axis = 0; axis < controller_.axes(); ++axis) {
    if (!(arc ? axis < 2 : i.axes.has(axis) || i.op == language::Opcode::wait)) continue;
    const Refusal r = controller_.refuses_motion(1U << static_cast<unsigned>(axis));
    if (r == Refusal::limit_error || r == Refusal::alarm || r == Refusal::loop_error) return r;
  }
  return Refusal::none;
}

bool ProgramWatch::is_in(int program, language::ThreadState state) const {
  return controller_.program_state(program) == static_cast<int>(state);
}

void ProgramWatch::stopped(int line, std::string reason, std::string axis, int direction) {
  if (stops_.size() == most_stops) return;
  stops_.push_back({seconds(controller_.now().time_since_epoch()), source_line(line), std::move(axis),
                    direction, std::move(reason)});
}

bool ProgramWatch::observe(const Controller::Trace& t) {
  if (t.reads) {
    std::string& before = last_read_[t.line];
    if (before == t.what) return false;
    before = t.what;
  }
  for (int a = 0; a < controller_.axes(); ++a) {
    if ((t.axes >> a & 1u) == 0) continue;
    if (t.limit == 0) {
      sent_by_[ix(a)] = t.line;
      continue;
    }
    const std::string axis(1, controller_.model().axis_letters[ix(a)]);
    const char* side = t.limit > 0 ? "plus" : "minus";
    stopped(sent_by_[ix(a)], "Axis " + axis + " runs into its " + side + " limit switch.", axis, t.limit);
    stops_.back().t = seconds(t.at.time_since_epoch());
  }
  return true;
}

void ProgramWatch::look_at_programs() {
  for (int n = 0; n < controller_.model().programs; ++n) {
    const bool failed = is_in(n, language::ThreadState::error);
    if (failed && !failed_[ix(n)])
      stopped(controller_.program_place(n), place_of(n) + " stopped with an error: " + reason_of(n));
    failed_[ix(n)] = failed;
  }
}

std::string ProgramWatch::errors() const {
  std::string all;
  for (const RehearsedStop& stop : stops_)
    if (stop.direction == 0) all += (all.empty() ? "" : " ") + stop.reason;
  return std::any_of(failed_.begin(), failed_.end(), [](bool failed) { return failed; }) ? all
                                                                                         : std::string();
}

/// The innermost WHILE around a line; in a subroutine, around a GOSUB to it.
ProgramWatch::Loop ProgramWatch::loop_around(int line) const {
  const auto& code = made_.program.code;
  for (int level = 0; level <= language::max_call_depth && line >= 0; ++level) {
    Loop found;
    for (int head = 0; head <= line && ix(head) < code.size(); ++head)
      if (code[ix(head)].op == language::Opcode::while_ && code[ix(head)].link >= line)
        found = {head, code[ix(head)].link};
    if (found.head >= 0) return found;
    int sub = -1;
    for (int at = line; at >= 0 && sub < 0; --at)
      if (ix(at) < code.size() && code[ix(at)].op == language::Opcode::sub)
        sub = code[ix(at)].values[0].number;
    line = -1;
    for (std::size_t at = 0; sub >= 0 && at < code.size(); ++at)
      if (code[at].op == language::Opcode::gosub && code[at].values[0].number == sub)
        line = static_cast<int>(at);
  }
  return {};
}

ProgramWatch::Unfinished ProgramWatch::still_running(int program, bool nothing_comes) const {
  Unfinished result;
  result.sentence = place_of(program) + " was still running when the rehearsal ended";
  const Loop loop = loop_around(controller_.program_place(program));
  const int first = source_line(loop.head), last = source_line(loop.end);
  if (first >= 0 && last >= 0) {
    const bool for_ever = holds_for_ever(made_.program.code[ix(loop.head)]);
    result.endless = for_ever || nothing_comes;
    result.sentence += ": the loop of lines " + std::to_string(first + 1) + " to " + std::to_string(last + 1);
    result.sentence += for_ever        ? " has no end"
                       : nothing_comes ? " waits for a value that nothing changes"
                                       : " had not ended";
  }
  result.sentence += ".";
  return result;
}

/// The first axis that still moves after all programs have ended.
ProgramWatch::Unfinished ProgramWatch::still_moving(bool nothing_comes) {
  Unfinished result{"An axis was still moving when the rehearsal ended.", nothing_comes};
  int line = -1;
  for (int a = controller_.axes(); a-- > 0;)
    if (controller_.moving(a)) {
      line = sent_by_[ix(a)];
      result.sentence = fmt::format("Axis {} was still moving when the rehearsal ended",
                                    controller_.model().axis_letters[ix(a)]);
      if (const int by = source_line(line); by >= 0)
        result.sentence += "; line " + std::to_string(by + 1) + " started the move";
      result.sentence += ".";
    }
  stopped(line, result.sentence);
  return result;
}

ProgramWatch::Unfinished ProgramWatch::unfinished(bool nothing_comes) {
  Unfinished all;
  for (int n = 0; n < controller_.model().programs; ++n) {
    if (!is_in(n, language::ThreadState::running)) continue;
    const Unfinished one = still_running(n, nothing_comes);
    stopped(controller_.program_place(n), one.sentence);
    all.sentence += (all.sentence.empty() ? "" : " ") + one.sentence;
    all.endless = all.endless || one.endless;
  }
  return all.sentence.empty() ? still_moving(nothing_comes) : all;
}

}  // namespace hw::arcus
