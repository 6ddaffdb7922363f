// Bench commands of an Arcus controller, and their view.
#include <algorithm>
#include <cmath>

#include "core/base/rounded_steps.h"
#include "core/devices/arcus/emulator_arcus.h"
#include "core/emulation/bench_on_controller.h"
#include "core/emulation/plant_bench.h"

namespace hw::arcus {
namespace {

std::string spelled(const std::string& of, int count) {
  return count == 0 ? "This controller has no " + of + "."
                    : "This controller has " + of + " 1 to " + std::to_string(count) + ".";
}

tl::unexpected<Fault> nothing_changed(std::string what, std::string advice = {}) {
  return fail(FaultKind::refused, std::move(what), "Nothing was changed.", std::move(advice));
}

}  // namespace

Result<> ArcusEmulator::check_axis(AxisId axis) const {
  if (axis.index < controller_.axes()) return {};
  return nothing_changed("This controller has no axis number " + std::to_string(axis.index + 1) + ".",
                         "Its axes are " + std::string(controller_.model().axis_letters) + ".");
}

template <>
Result<> ArcusEmulator::act(const bench::Input& c) {
  const int count = controller_.model().inputs;
  if (c.number < 1 || c.number > count)
    return nothing_changed("There is no input " + std::to_string(c.number) + ".", spelled("inputs", count));
  controller_.operate_input(c.number, c.active);
  return {};
}

template <>
Result<> ArcusEmulator::act(const bench::Analog& c) {
  constexpr std::int32_t full_scale_mv = 5000;
  const int count = controller_.model().analog_inputs;
  if (c.number < 1 || c.number > count)
    return nothing_changed("There is no analog input " + std::to_string(c.number) + ".",
                           spelled("analog inputs", count));
  if (c.value < 0 || c.value > full_scale_mv)
    return nothing_changed(std::to_string(c.value) + " mV is not a voltage of an analog input.",
                           "It takes 0 to 5000 mV.");
  controller_.operate_analog(c.number, c.value);
  return {};
}

template <>
Result<> ArcusEmulator::act(const bench::Button& c) {
  return nothing_changed("This controller has no button \"" + c.name + "\": it has no front panel.");
}

template <>
Result<> ArcusEmulator::act(const bench::Jam& c) {
  if (auto bad = check_axis(c.axis); !bad) return bad;
  controller_.jam(c.axis.index, c.on);
  return {};
}

/// In encoder counts: so many are missing or too many afterwards.
template <>
Result<> ArcusEmulator::act(const bench::Slip& c) {
  if (auto bad = check_axis(c.axis); !bad) return bad;
  Axis& axis = controller_.axis(c.axis.index);
  const double pulses =
      axis.counts_per_pulse == 0 ? 0 : static_cast<double>(c.by.value) / axis.counts_per_pulse;
  axis.plant.slip(rounded_steps(pulses));
  controller_.bench_changed(c.axis.index);
  return {};
}

template <>
Result<> ArcusEmulator::act(const bench::Alarm& c) {
  if (auto bad = check_axis(c.axis); !bad) return bad;
  if (controller_.model().status.alarm == no_bit)
    return nothing_changed("This controller has no alarm inputs.");
  controller_.operate_alarm(c.axis.index, c.on);
  return {};
}

/// Values that the place does not give stay as the bench was built: encoder and index.
template <>
Result<> ArcusEmulator::act(const bench::Place& c) {
  if (auto bad = check_axis(c.axis); !bad) return bad;
  if (auto bad = check_place(c.place, false); !bad) return bad;
  constexpr double most_counts = 1e6;
  const double counts = c.place.counts_per_step.value_or(0);
  if (!std::isfinite(counts) || std::abs(counts) > most_counts)
    return nothing_changed("counts_per_step is too large.");
  Axis& axis = controller_.axis(c.axis.index);
  axis.plant.set_place(c.place);
  if (c.place.counts_per_step) {
    const std::int64_t before = axis.encoder();
    axis.counts_per_pulse = *c.place.counts_per_step;
    axis.set_encoder(before);
  }
  if (c.place.index_every) {
    axis.index_every = std::max<std::int64_t>(c.place.index_every->value, 0);
    axis.index_first = 0;
  }
  controller_.bench_changed(c.axis.index);
  return {};
}

template <>
Result<> ArcusEmulator::act(const bench::Breaker&) {
  return nothing_changed("This controller has no circuit breaker.");
}

template <>
Result<> ArcusEmulator::act(const bench::Power& c) {
  if (c.on == controller_.powered()) return {};
  line_.clear();
  if (c.on)
    controller_.power_up();
  else
    controller_.power_down();
  return {};
}

template <>
Result<> ArcusEmulator::act(const bench::PowerCycle&) {
  (void)act(bench::Power(false));
  return act(bench::Power(true));
}

Result<> ArcusEmulator::operate(const BenchCommand& command) {
  const auto act_on_any = [this]<class Operation>(const Operation& operation) -> Result<> {
    constexpr bool is_switch =
        std::is_same_v<Operation, bench::Limit> || std::is_same_v<Operation, bench::HomeSwitch>;
    if constexpr (is_switch) {
      if (auto bad = check_axis(operation.axis); !bad) return bad;
      (void)act_on(controller_.axis(operation.axis.index).plant, operation);
      controller_.bench_changed(operation.axis.index);
      return {};
    } else {
      return act(operation);
    }
  };
  auto result = on_controller(command, act_on_any);
  after();
  return result;
}

void ArcusEmulator::report_truth(MachineTruth& truth) const {
  truth = MachineTruth();
  truth.powered = controller_.powered();
  truth.axis_count = controller_.axes();
  for (int n = 0; n < controller_.model().programs; ++n) {
    const auto state = static_cast<language::ThreadState>(controller_.program_state(n));
    truth.program |= state == language::ThreadState::running || state == language::ThreadState::paused;
  }
  truth.program |=
      controller_.vm().call_state() == language::ThreadState::running || controller_.buffer().running;
  for (int a = 0; a < controller_.axes(); ++a)
    truth.axes[ix(a)] = {Steps(controller_.position(a)), controller_.moving(a), controller_.ramp_to_rest(a)};
}

void ArcusEmulator::look(BenchView& view) const {
  view = BenchView();
  view.present = true;
  view.powered = controller_.powered();
  if (!view.powered) view.switches_on = 0;
  view.inputs_operated = controller_.inputs_operated();
  view.outputs = controller_.output_levels();
  for (int n = 1; n <= controller_.model().analog_inputs; ++n)
    view.analog[static_cast<std::size_t>(n - 1)] = static_cast<std::int32_t>(controller_.analog(n));
  for (int a = 0; a < controller_.axes(); ++a) {
    const motion::Plant& plant = controller_.axis(a).plant;
    const std::uint32_t bit = 1u << a;
    show_plant(view, a, SeenPlant(plant));
    view.jammed &= ~bit;  // a load without motor power does not move either
    if (plant.home_operated()) view.homes |= bit;
    if (controller_.axis(a).alarm_operated) view.alarms |= bit;
    if (controller_.axis(a).jammed_by_hand) view.jammed |= bit;
  }
}

}  // namespace hw::arcus
