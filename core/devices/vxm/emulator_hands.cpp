// Routes bench commands to the controller that they concern.
#include <algorithm>

#include "core/base/index.h"
#include "core/devices/vxm/emulator_vxm.h"
#include "core/emulation/bench_on_controller.h"
#include "core/emulation/plant_bench.h"

namespace hw::vxm {

Result<> VxmEmulator::check_axis(AxisId axis) const {
  if (axis.index < options_.motors) return {};
  return fail(FaultKind::refused,
              "This bench has " + std::to_string(options_.motors) + " motors and no motor " +
                  std::to_string(axis.index + 1) + ".",
              "Nothing was changed.");
}

template <>
Result<> VxmEmulator::act(const bench::Input& c) {
  const int count = boxes() * lines_per_controller;
  if (c.number < 1 || c.number > count)
    return fail(
        FaultKind::refused,
        "There is no input " + std::to_string(c.number) + ": inputs are 1 to " + std::to_string(count) + ".",
        "Nothing was changed.");
  const std::uint32_t bit = 1u << (c.number - 1);
  inputs_ = c.active ? inputs_ | bit : inputs_ & ~bit;
  const int box = (c.number - 1) / lines_per_controller, input = (c.number - 1) % lines_per_controller;
  drive_line(box,
             input < inputs_per_controller ? line_in_1 + input : line_jog + input - inputs_per_controller);
  return {};
}

template <>
Result<> VxmEmulator::act(const bench::Button& c) {
  const auto found = std::find(panel_buttons.begin(), panel_buttons.end(), c.name);
  const int button = static_cast<int>(found - panel_buttons.begin());
  if (found == panel_buttons.end() || (button >= buttons_per_controller && boxes() < 2)) {
    std::string all;
    for (int i = 0; i < boxes() * buttons_per_controller; ++i)
      all += (i ? ", " : "") + std::string(panel_buttons[ix(i)]);
    return fail(FaultKind::refused, "The front panel has no button \"" + c.name + "\".",
                "Nothing was changed.", "Its buttons are " + all + ".");
  }
  press(button, c.pressed);
  return {};
}

void VxmEmulator::press(int button, bool on) {
  const std::uint32_t bit = 1u << button;
  buttons_ = on ? buttons_ | bit : buttons_ & ~bit;
  // Master: 1- 1+ 2- 2+ Run Stop; Slave: 3- 3+ 4- 4+ Run Stop. Stop is wired to input 4.
  const int local = button % buttons_per_controller;
  const int line = local < line_run ? line_jog + local : local == line_run ? line_run : line_in_4;
  drive_line(button / buttons_per_controller, line);
}

/// A line is low while a button of the front panel or its pin of the connector is.
void VxmEmulator::drive_line(int box, int line) {
  const int button = line == line_in_4 ? line_run + 1 : line <= line_run ? line : -1;
  const int input = line >= line_in_1 ? line - line_in_1
                    : line < line_run ? line - line_jog + inputs_per_controller
                                      : -1;
  const bool pressed = button >= 0 && (buttons_ >> (box * buttons_per_controller + button) & 1u) != 0;
  const bool pulled = input >= 0 && (inputs_ >> (box * lines_per_controller + input) & 1u) != 0;
  (box == 0 ? box_ : *box_.slave()).set_line(line, pressed || pulled);
}

template <>
Result<> VxmEmulator::act(const bench::Analog& c) {
  if (c.number < 1 || c.number > boxes())
    return fail(FaultKind::refused, "There is no analog input " + std::to_string(c.number) + ".",
                "Nothing was changed.");
  if (c.value < analog_min || c.value > analog_max)
    return fail(FaultKind::refused, std::to_string(c.value) + " is not a reading of the analog input.",
                "Nothing was changed.", "It gives 0 to 1024.");
  (c.number == 1 ? box_ : *box_.slave()).set_analog(c.value);
  return {};
}

Result<> VxmEmulator::check_supply(int supply) const {
  if (supply >= 0 && supply < boxes()) return {};
  return fail(FaultKind::refused,
              boxes() > 1 ? "This bench has the supplies of a controller and its Slave, no other."
                          : "This bench has one supply, no other.",
              "Nothing was changed.");
}

void VxmEmulator::supply_power(int box) {
  const bool on = supplies_[ix(box)].gives_power();
  if (box > 0) return box_.power_slave(on, now_);
  box_.power(on, now_);
  if (!on) held_back_.clear();
  answering_until_ = now_;
}

template <>
Result<> VxmEmulator::act(const bench::Power& c) {
  if (c.supply >= 0)
    if (auto bad = check_supply(c.supply); !bad) return bad;
  // A Slave comes up before its Master looks for it, and goes down after it.
  for (int i = 0; i < boxes(); ++i) {
    const int box = c.on ? boxes() - 1 - i : i;
    if (c.supply >= 0 && c.supply != box) continue;
    supplies_[ix(box)].switched_on = c.on;
    supply_power(box);
  }
  return {};
}

template <>
Result<> VxmEmulator::act(const bench::Breaker& c) {
  if (auto bad = check_supply(c.supply); !bad) return bad;
  supplies_[ix(c.supply)].breaker_out = c.out;
  supply_power(c.supply);
  return {};
}

template <>
Result<> VxmEmulator::act(const bench::PowerCycle&) {
  (void)act(bench::Power(false));
  return act(bench::Power(true));
}

template <>
Result<> VxmEmulator::act(const bench::Alarm&) {
  return fail(FaultKind::refused, "A VXM has no alarm inputs.", "Nothing was changed.");
}

Result<> VxmEmulator::operate(const BenchCommand& command) {
  const auto act_on_any = [this]<class Operation>(const Operation& operation) -> Result<> {
    if constexpr (ActsOnPlant<Operation>) {
      if (auto bad = check_axis(operation.axis); !bad) return bad;
      const int axis = operation.axis.index, local = axis % motors_per_controller;
      if (auto done = act_on(box_of(axis).plant(local), operation); !done) return done;
      box_of(axis).plant_changed(local);
      return {};
    } else {
      return act(operation);
    }
  };
  auto result = on_controller(command, act_on_any);
  box_.settle();
  after();
  return result;
}

void VxmEmulator::report_truth(MachineTruth& truth) const {
  truth = MachineTruth();
  truth.powered = box_.powered();
  truth.program = box_.running();
  truth.axis_count = options_.motors;
  for (int a = 0; a < options_.motors; ++a) {
    const Box& box = box_of(a);
    const int local = a % motors_per_controller;
    truth.axes[ix(a)] = {Steps(box.axis(local).counter), box.turning(local), box.ramp_to_rest(local)};
  }
}

void VxmEmulator::look(BenchView& view) const {
  view = BenchView();
  view.present = true;
  view.powered = box_.powered();
  view.stores = static_cast<std::int64_t>(box_.stores);
  view.buttons = buttons_;
  view.inputs_operated = inputs_;
  for (int i = 0; i < boxes(); ++i) {
    const Box& box = i == 0 ? box_ : *box_.slave();
    const Box::Lamps lamps = box.lamps();
    const std::uint32_t power = 1u << (i * lamps_per_controller), online = power << 1;
    if (!supplies_[ix(i)].switched_on) view.switches_on &= ~(1u << i);
    if (supplies_[ix(i)].breaker_out) view.breakers_out |= 1u << i;
    view.lamps |= (lamps.power ? power : 0) | (lamps.online ? online : 0);
    view.lamps_blink |= (lamps.power_blinks ? power : 0) | (lamps.online_blinks ? online : 0);
    view.outputs |= static_cast<std::uint32_t>(box.outputs()) << (i * outputs_per_controller);
    view.analog[ix(i)] = box.analog();
  }
  for (int axis = 0; axis < options_.motors; ++axis) {
    const int local = axis % motors_per_controller;
    const Box& box = box_of(axis);
    show_plant(view, axis,
               {box.axis(local).plant, box.switch_operated(local, Sign::minus),
                box.switch_operated(local, Sign::plus)});
  }
}

}  // namespace hw::vxm
