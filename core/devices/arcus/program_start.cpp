#include "core/devices/arcus/program_start.h"

#include <algorithm>
#include <bitset>
#include <cmath>

#include "core/base/index.h"
#include "core/devices/arcus/catalog.h"

namespace hw::arcus {
namespace {

/// Communication settings affect no program.
bool acts_on_programs(const ParamInfo& info) {
  return info.group != "Communication" || info.mnemonic == "TOC";
}

/// The parameters of the catalog are the settings of the model, in their order.
template <class Visit>
void each_setting(const Model& model, Visit visit) {
  std::size_t param = 0;
  for (const SettingFact& fact : model.settings)
    for (int place = 0; place < fact.count; ++place) visit(fact.id, place, param++);
}

/// Loops come last, when the units that they count in are set up.
void set_up(Controller& controller, const ControllerState& state, const Catalog& catalog) {
  for (const bool loops : {false, true})
    each_setting(controller.model(), [&](Setting id, int place, std::size_t param) {
      const auto value = state.param(param);
      if (value && loops == (id == Setting::loop) && acts_on_programs(catalog.params[param]))
        (void)controller.write_setting(id, *value, place);
    });
}

void set_errors(Axis& axis, bool closed, AxisError error) {
  axis.minus_error = error == AxisError::limit_minus;
  axis.plus_error = error == AxisError::limit_plus;
  axis.alarm_error = error == AxisError::alarm;
  if (!closed) return;
  switch (error) {
    case AxisError::none: return;
    case AxisError::stalled: axis.loop_error = LoopState::stall_error; return;
    case AxisError::too_far: axis.loop_error = LoopState::range_error; return;
    case AxisError::not_corrected: axis.loop_error = LoopState::attempt_error; return;
    default: axis.loop_error = LoopState::limit_error;
  }
}

void stand(Controller& controller, int i, const AxisState& now) {
  Axis& axis = controller.axis(i);
  const bool closed = controller.settings().on(Setting::loop, i);
  if (now.position_known) {
    axis.pulses = now.position.value;
    if (now.has_encoder) axis.set_encoder(now.encoder.value);
    if (closed) {
      axis.target = now.position.value;
      axis.pulses = std::llround(static_cast<double>(now.encoder.value) * controller.pulses_per_unit(i));
    }
  }
  set_errors(axis, closed, now.error);
  controller.bench_changed(i);
  const int alarm = controller.model().status.alarm;
  if (alarm != no_bit && ((controller.status(i) >> alarm & 1) != 0) != now.alarm)
    controller.operate_alarm(i, !axis.alarm_operated);
}

/// Operates the inputs until the emulator's DI shows the known levels, which depend on the polarity.
void hold_inputs(Controller& controller, const Snapshot& now) {
  for (int n = 1; n <= controller.model().inputs; ++n) {
    const std::uint32_t bit = 1u << (n - 1);
    if ((now.inputs_known & bit) == 0) continue;
    const auto shown = static_cast<std::uint32_t>(controller.inputs()) & bit;
    if (shown != (now.inputs & bit)) controller.operate_input(n, (controller.inputs_operated() & bit) == 0);
  }
  for (int n = 1; n <= controller.model().analog_inputs; ++n)
    if (now.analog_known >> (n - 1) & 1u) controller.operate_analog(n, now.analog[ix(n - 1)]);
}

bool incremental(const ControllerState& state, const Catalog& catalog) {
  const int mode = catalog.find_readout("MM");
  return mode >= 0 && state.now.readouts_known.test(ix(mode)) && state.now.readouts[ix(mode)] != 0;
}

/// The value of one axis's readout, by the last letter of its name: S its state, P and E its positions.
std::optional<std::int64_t> setting(const ControllerState& state, const Catalog& catalog, Group group,
                                    int axis, char what) {
  for (std::size_t i = 0; i < catalog.readouts.size(); ++i) {
    const ReadoutInfo& info = catalog.readouts[i];
    if (info.group == group && info.axis == axis && info.id.back() == what &&
        state.now.readouts_known.test(i))
      return state.now.readouts[i];
  }
  return std::nullopt;
}

/// Outputs (bits) that the controller itself drives: In Position, Alarm, sync. DO does not show the value
/// written to them.
std::int64_t hidden_outputs(const Controller& controller, const ControllerState& state,
                            const Catalog& catalog) {
  const Model& model = controller.model();
  const auto bit = [](int output) { return output > 0 ? std::int64_t{1} << (output - 1) : 0; };
  std::int64_t hidden = 0;
  if (controller.loop_has_outputs()) hidden |= bit(model.in_position_output) | bit(model.alarm_output);
  for (int i = 0; i < controller.axes(); ++i)
    if (setting(state, catalog, sync_outputs, i, 'S').value_or(0) != 0)
      hidden |= bit(model.sync_outputs[ix(i)]);
  return hidden;
}

/// Hidden outputs are taken as power-up leaves them.
void put_outputs(Controller& controller, const ControllerState& state, const Catalog& catalog) {
  const std::int64_t hidden = hidden_outputs(controller, state, catalog);
  const std::int64_t shown = state.now.outputs & state.now.outputs_known;
  controller.set_outputs((shown & ~hidden) | (controller.settings().get(Setting::boot_outputs) & hidden));
}

/// Call when the inputs are set: none of their edges must be caught.
void arm(Controller& controller, const ControllerState& state, const Catalog& catalog) {
  for (int i = 0; i < controller.axes(); ++i) {
    if (const auto latch = setting(state, catalog, latches, i, 'S'))
      controller.axis(i).latch = {static_cast<int>(*latch),
                                  setting(state, catalog, latches, i, 'P').value_or(0),
                                  setting(state, catalog, latches, i, 'E').value_or(0)};
    const auto sync = setting(state, catalog, sync_outputs, i, 'S');
    if (sync == 1) controller.sync_on(i);
    if (sync == 2) controller.axis(i).sync.state = 2;
  }
}

bool looks_at_latch(language::Quantity q) {
  using enum language::Quantity;
  return q == latch_state || q == latch_pulse || q == latch_encoder;
}

/// Axes (bits) whose latch or sync output is read before the program has armed it or switched it off.
struct UnarmedReads {
  std::uint32_t at_latch = 0, at_sync = 0;
};
UnarmedReads unarmed_reads(const language::Program& program) {
  UnarmedReads first;
  std::uint32_t latch_is_set = 0, sync_is_set = 0;
  for (const language::Instruction& i : program.code) {
    for (const language::Operand& value : i.values) {
      if (value.kind != language::Operand::Kind::quantity) continue;
      const std::uint32_t axis = 1u << value.index;
      if (looks_at_latch(value.quantity)) first.at_latch |= axis & ~latch_is_set;
      if (value.quantity == language::Quantity::sync_state) first.at_sync |= axis & ~sync_is_set;
    }
    const bool sets = i.op == language::Opcode::set && i.target.kind == language::Operand::Kind::quantity;
    if (sets && i.target.quantity == language::Quantity::latch_enable) latch_is_set |= 1u << i.target.index;
    if (i.op == language::Opcode::sync_on || i.op == language::Opcode::sync_off) sync_is_set = ~0u;
  }
  return first;
}

void name_unarmed(std::vector<RehearsedAssumption>& all, const ControllerState& state, const Catalog& catalog,
                  const language::Program& program) {
  const UnarmedReads first = unarmed_reads(program);
  for (const ReadoutInfo& info : catalog.readouts) {
    const bool latch = info.group == latches, sync = info.group == sync_outputs;
    if ((!latch && !sync) || info.axis < 0 || info.id.back() != 'S') continue;
    const bool matters = ((latch ? first.at_latch : first.at_sync) >> info.axis & 1u) != 0;
    if (matters && !setting(state, catalog, latch ? latches : sync_outputs, info.axis, 'S'))
      all.push_back({info.id, "off"});
  }
}

bool on_duty(const OutputDuty& duty, const ControllerState& state, const Catalog& catalog) {
  return !duty.name.empty() &&
         std::all_of(duty.while_not_zero.begin(), duty.while_not_zero.end(), [&](const std::string& name) {
           const int param = catalog.find_param(name);
           if (param >= 0) return state.param(ix(param)).value_or(catalog.params[ix(param)].fallback) != 0;
           const int place = catalog.find_readout(name);
           return place >= 0 && state.now.readouts_known.test(ix(place)) &&
                  state.now.readouts[ix(place)] != 0;
         });
}

/// Names the values written to hidden outputs: a program that ends the duty of an output exposes that value.
void name_hidden(std::vector<RehearsedAssumption>& all, const ControllerState& state, const Catalog& catalog,
                 const language::Program& program) {
  const bool ends_duties =
      std::any_of(program.code.begin(), program.code.end(), [](const language::Instruction& i) {
        const bool sets = i.op == language::Opcode::set && i.target.kind == language::Operand::Kind::quantity;
        return i.op == language::Opcode::sync_off ||
               (sets && i.target.quantity == language::Quantity::loop_enable);
      });
  for (const OutputInfo& output : catalog.outputs)
    if (ends_duties && on_duty(output.duty, state, catalog))
      all.push_back({"last value written to " + output.name, "as at power-up"});
}

/// Variables whose first use is a read.
std::bitset<language::variables> read_first(const language::Program& program) {
  std::bitset<language::variables> looked_at, written;
  const auto look = [&](const language::Operand& o) {
    if (o.kind == language::Operand::Kind::variable && !written.test(ix(o.number)))
      looked_at.set(ix(o.number));
  };
  for (const language::Instruction& i : program.code) {
    for (const language::Operand& value : i.values) look(value);
    const bool puts = i.op == language::Opcode::set || i.op == language::Opcode::compute;
    if (puts && i.target.kind == language::Operand::Kind::variable) written.set(ix(i.target.number));
  }
  return looked_at;
}

}  // namespace

void ArcusEmulator::begin_like(const ControllerState& state, const Catalog& catalog) {
  arcus::begin_like(*this, state, catalog);
}

void begin_like(ArcusEmulator& emulator, const ControllerState& state, const Catalog& catalog) {
  Controller& controller = emulator.controller();
  const Snapshot& now = state.now;
  controller.host_talks = true;  // the console talks to it
  set_up(controller, state, catalog);
  controller.set_incremental(incremental(state, catalog));
  for (int n = 0; n < variables; ++n)
    if (now.variables_known.test(ix(n))) controller.set_variable(n, now.variables[ix(n)]);
  std::int64_t enables = 0;
  for (int i = 0; i < std::min(controller.axes(), now.axis_count); ++i) {
    enables |= std::int64_t{now.axes[ix(i)].enabled} << i;
    stand(controller, i, now.axes[ix(i)]);
  }
  if (now.outputs_known != 0) {  // both are read together
    controller.set_enables(enables);
    put_outputs(controller, state, catalog);
  }
  hold_inputs(controller, now);
  arm(controller, state, catalog);
}

std::vector<RehearsedAssumption> assumptions(const ControllerState& state, const Catalog& catalog,
                                             std::uint32_t moved, const language::Program& program) {
  std::vector<RehearsedAssumption> all = unknown_params(state, catalog, moved, acts_on_programs);
  for (RehearsedAssumption& a : unknown_surroundings(state, catalog, moved)) all.push_back(std::move(a));
  const int mode = catalog.find_readout("MM");
  if (mode >= 0 && !state.now.readouts_known.test(ix(mode))) all.push_back({"MM", "absolute"});
  const auto looked_at = read_first(program);
  for (int n = 0; n < language::variables; ++n)
    if (looked_at.test(ix(n)) && !state.now.variables_known.test(ix(n)))
      all.push_back({"V" + std::to_string(n), "0"});
  name_unarmed(all, state, catalog, program);
  name_hidden(all, state, catalog, program);
  if (state.now.feed.running)
    all.push_back({"moves that wait in the buffer", "none, since the controller reports only their number"});
  return all;
}

}  // namespace hw::arcus
