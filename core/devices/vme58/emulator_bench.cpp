// Actions on the bench of a VME58, and its view.
#include <algorithm>
#include <string>
#include <utility>

#include "core/devices/vme58/emulator_vme58.h"
#include "core/emulation/bench_on_controller.h"

namespace hw::vme58 {
namespace {

tl::unexpected<Fault> left_as_it_was(std::string what, std::string advice = {}) {
  return fail(FaultKind::refused, std::move(what), "Nothing was changed.", std::move(advice));
}

}  // namespace

Result<> Vme58Emulator::check_axis(AxisId axis) const {
  const int axes = board_.variant().axes();
  if (axis.index < axes) return {};
  return left_as_it_was("This board has no axis number " + std::to_string(axis.index + 1) + ".",
                        "Its axes are " + std::string(axis_letters.substr(0, ix(axes))) + ".");
}

template <>
Result<> Vme58Emulator::act(const bench::Input& c) {
  const int line = c.number - 1;
  if (line < 0 || line >= io_lines)
    return left_as_it_was("There is no line " + std::to_string(line) + ".", "The lines are 0 to 13.");
  if (board_.io().is_output(line))
    return left_as_it_was("Line " + std::to_string(line) + " is an output.",
                          "Change the jumpers of its group.");
  board_.pull_line(line, c.active);
  return {};
}

template <>
Result<> Vme58Emulator::act(const bench::Limit& c) {
  if (auto bad = check_axis(c.axis); !bad) return bad;
  board_.motion().operate_limit(c.axis.index, c.sign, c.operated);
  return {};
}

template <>
Result<> Vme58Emulator::act(const bench::HomeSwitch& c) {
  if (auto bad = check_axis(c.axis); !bad) return bad;
  board_.motion().operate_home(c.axis.index, c.operated);
  return {};
}

template <>
Result<> Vme58Emulator::act(const bench::Analog&) {
  return left_as_it_was("A VME58 has no analog inputs.");
}

template <>
Result<> Vme58Emulator::act(const bench::Button& c) {
  return left_as_it_was("This board has no button \"" + c.name + "\".");
}

template <>
Result<> Vme58Emulator::act(const bench::Jam& c) {
  if (auto bad = check_axis(c.axis); !bad) return bad;
  board_.motion().jam(c.axis.index, c.on);
  return {};
}

template <>
Result<> Vme58Emulator::act(const bench::Slip& c) {
  if (auto bad = check_axis(c.axis); !bad) return bad;
  board_.motion().slip(c.axis.index, c.by.value);
  return {};
}

template <>
Result<> Vme58Emulator::act(const bench::Alarm&) {
  return left_as_it_was("A VME58 has no alarm inputs.");
}

template <>
Result<> Vme58Emulator::act(const bench::Place& c) {
  if (auto bad = check_axis(c.axis); !bad) return bad;
  return board_.motion().place(c.axis.index, c.place);
}

template <>
Result<> Vme58Emulator::act(const bench::Power& c) {
  board_.power(c.on);
  return {};
}

template <>
Result<> Vme58Emulator::act(const bench::PowerCycle&) {
  board_.power(false);
  board_.power(true);
  return {};
}

template <>
Result<> Vme58Emulator::act(const bench::Breaker&) {
  return left_as_it_was("A VME58 has no circuit breaker.");
}

Result<> Vme58Emulator::operate(const BenchCommand& command) {
  auto result = on_controller(command, [this](const auto& operation) { return act(operation); });
  board_.settle();
  advance_to(board_.now());
  return result;
}

/// Outputs: the output lines in order, then the auxiliary outputs. A line is on while low, an auxiliary
/// output while high.
void Vme58Emulator::report_truth(MachineTruth& truth) const {
  const Motion& motion = board_.motion();
  truth = MachineTruth();
  truth.powered = board_.powered() && !board_.booting();
  truth.program = !board_.idle();
  truth.axis_count = board_.variant().axes();
  Duration longest{};  // axes of one move all take as long as the slowest
  for (int a = 0; a < truth.axis_count; ++a) {
    const double speed = motion.velocity(a);
    truth.axes[ix(a)] = {Steps(motion.position(a)), motion.moving(a), Duration{}};
    // A curved ramp is steepest in its middle, so it takes up to twice as long in total. It ends on a whole
    // count; below one count per second there is no ramp.
    if (speed >= 1)
      longest = std::max(longest, from_seconds(2 * speed / motion.settings(a).acceleration + 1 / speed));
  }
  for (int a = 0; a < truth.axis_count; ++a)
    if (truth.axes[ix(a)].moving) truth.axes[ix(a)].ramp = longest;
}

void Vme58Emulator::look(BenchView& view) const {
  view = BenchView();
  board_.motion().look(view);
  view.present = true;
  view.powered = board_.powered();
  if (!view.powered) view.switches_on = 0;
  const UserIo& io = board_.io();
  view.inputs_operated = io.pulled();
  int bit = 0;
  for (int line = 0; line < io_lines; ++line)
    if (io.is_output(line)) view.outputs |= std::uint32_t{io.is_true(line)} << bit++;
  for (int a = 0; a < board_.variant().axes(); ++a) view.outputs |= (io.aux_high() >> a & 1u) << bit++;
}

}  // namespace hw::vme58
