#include "tests/contract/lies.h"

#include <algorithm>
#include <deque>
#include <iostream>
#include <string>

#include "core/emulation/emulator.h"
#include "tests/contract/lying_driver.h"

namespace hw {
namespace {

// ---- where a lie makes a difference

bool several_axes(const Catalog& c) { return c.axes.size() > 1; }
bool stored_programs(const Catalog& c) { return c.program.slots > 0; }
bool several_homings(const Catalog& c) { return c.homing_modes.size() > 1; }
bool can_store(const Catalog& c) { return c.can.store; }
bool inputs(const Catalog& c) { return !c.inputs.empty(); }
bool outputs(const Catalog& c) { return !c.outputs.empty(); }
bool analog(const Catalog& c) { return !c.analog.empty(); }
bool step_axes_with_encoder(const Catalog& c) { return c.axes[0].encoder && !c.axes[0].servo; }
bool home_inputs(const Catalog& c) { return c.axes[0].home_input; }
bool switchable(const Catalog& c) { return c.axes[0].switchable; }
bool without_servo(const Catalog& c) { return !c.axes[0].servo; }
bool several_jogs(const Catalog& c) { return several_axes(c) && !c.can.one_axis_at_a_time; }
bool pauses(const Catalog& c) { return c.can.single_step || c.program.threads > 0; }
bool variables(const Catalog& c) { return c.variables.count > 0; }
bool can_reset(const Catalog& c) { return c.can.reset; }

// ---- what is answered as done, and not sent

template <class... Asked>
bool any_of(LieMemory&, const IntentBody& asked) {
  return (std::holds_alternative<Asked>(asked) || ...);
}
/// Which axes are to move; 0: it moves none.
std::uint32_t axes_of(const IntentBody& asked) {
  std::uint32_t axes = 0;
  const auto add = [&](const std::vector<AxisTarget>& all) {
    for (const AxisTarget& one : all) axes |= 1u << one.axis.index;
  };
  if (const auto* go = std::get_if<intent::MoveTo>(&asked)) add(go->targets);
  if (const auto* go = std::get_if<intent::MoveBy>(&asked)) add(go->distances);
  if (const auto* jog = std::get_if<intent::JogStart>(&asked)) axes = 1u << jog->axis.index;
  if (const auto* home = std::get_if<intent::Home>(&asked)) axes = 1u << home->axis.index;
  return axes;
}
bool for_other_axes(LieMemory&, const IntentBody& asked) { return axes_of(asked) > 1; }
bool homes_other_axes(LieMemory&, const IntentBody& asked) {
  const auto* home = std::get_if<intent::Home>(&asked);
  return home && home->axis.index > 0;
}
bool answered_from_memory(LieMemory& memory, const IntentBody& asked) {
  const auto* upload = std::get_if<intent::UploadProgram>(&asked);
  if (!upload || !memory.texts.contains(upload->slot)) return false;
  Notice listing(Notice::Kind::program, Instant(), memory.texts[upload->slot]);
  listing.slot = upload->slot;
  memory.notify(std::move(listing));
  return true;
}

bool acceptable_param(LieMemory& memory, const IntentBody& asked) {
  const auto* set = std::get_if<intent::SetParam>(&asked);
  const int index = set ? memory.catalog.find_param(set->mnemonic) : -1;
  return index >= 0 && memory.catalog.params[static_cast<std::size_t>(index)].accepts(set->value);
}

// ---- what is sent in its place

Sign other(Sign sign) { return sign == Sign::plus ? Sign::minus : Sign::plus; }
void jog_back(LieMemory&, IntentBody& asked) {
  if (auto* jog = std::get_if<intent::JogStart>(&asked)) jog->sign = other(jog->sign);
}
void home_back(LieMemory&, IntentBody& asked) {
  if (auto* home = std::get_if<intent::Home>(&asked)) home->sign = other(home->sign);
}
void home_first_way(LieMemory&, IntentBody& asked) {
  if (auto* home = std::get_if<intent::Home>(&asked)) home->mode = 0;
}
void without_speed(LieMemory&, IntentBody& asked) {
  if (auto* go = std::get_if<intent::MoveTo>(&asked)) go->speed = Pps();
  if (auto* go = std::get_if<intent::MoveBy>(&asked)) go->speed = Pps();
  if (auto* jog = std::get_if<intent::JogStart>(&asked)) jog->speed = Pps();
}
void one_step_short(LieMemory&, IntentBody& asked) {
  if (auto* go = std::get_if<intent::MoveBy>(&asked))
    for (AxisTarget& d : go->distances) d.value = d.value - Steps(d.value.value > 0 ? 1 : -1);
}
void place_as_distance(LieMemory&, IntentBody& asked) {
  if (const auto* go = std::get_if<intent::MoveTo>(&asked)) {
    intent::MoveBy by(go->targets, go->speed);
    asked = std::move(by);
  }
}
void one_axis_of_several(LieMemory&, IntentBody& asked) {
  if (auto* go = std::get_if<intent::MoveTo>(&asked))
    go->targets.erase(go->targets.begin() + 1, go->targets.end());
  if (auto* go = std::get_if<intent::MoveBy>(&asked))
    go->distances.erase(go->distances.begin() + 1, go->distances.end());
}
void set_to_zero(LieMemory&, IntentBody& asked) {
  if (auto* set = std::get_if<intent::SetPosition>(&asked)) set->value = Steps(0);
}
void last_axis_for_first(LieMemory& memory, IntentBody& asked) {
  const auto last = static_cast<std::uint8_t>(memory.catalog.axes.size() - 1);
  const auto cross = [&](std::vector<AxisTarget>& all) {
    for (AxisTarget& one : all) one.axis.index = static_cast<std::uint8_t>(last - one.axis.index);
  };
  if (auto* go = std::get_if<intent::MoveTo>(&asked)) cross(go->targets);
  if (auto* go = std::get_if<intent::MoveBy>(&asked)) cross(go->distances);
}
void output_inverted(LieMemory&, IntentBody& asked) {
  if (auto* set = std::get_if<intent::SetOutput>(&asked)) set->on = !set->on;
}

// ---- what is shown in its place

void homed(LieMemory& memory, Snapshot& shown) {
  for (int i = 0; i < shown.axis_count; ++i)
    if (memory.homed >> i & 1u) {
      shown.axes[i].trust.kind = Trust::homed;
      shown.axes[i].ended_by = EndedBy::target;
    }
}
void position_as_set(LieMemory& memory, Snapshot& shown) {
  for (const auto& [axis, set] : memory.positions_set) {
    AxisState& a = shown.axes[axis];
    a.position = a.position + (set - memory.positions_read[axis]);
    a.trust.kind = Trust::set;
  }
}
void position_as_asked(LieMemory& memory, Snapshot& shown) {
  for (const auto& [axis, target] : memory.targets)
    if (!shown.axis_moves(axis)) shown.axes[axis].position = target;
}
void params_as_set(LieMemory& memory, Snapshot& shown) {
  for (const auto& [index, value] : memory.params)
    if (index >= 0) shown.params[static_cast<std::size_t>(index)] = ParamState{value, true, true};
}
void power_as_set(LieMemory& memory, Snapshot& shown) {
  for (const auto& [axis, on] : memory.power) shown.axes[axis].enabled = on;
}
void limits_swapped(LieMemory&, Snapshot& shown) {
  for (AxisState& a : shown.axes) std::swap(a.limit_minus, a.limit_plus);
}
void no_limits(LieMemory&, Snapshot& shown) {
  for (AxisState& a : shown.axes) a.limit_minus = a.limit_plus = false;
}
void no_home_switch(LieMemory&, Snapshot& shown) {
  for (AxisState& a : shown.axes) a.home = false;
}
void all_ended_well(LieMemory&, Snapshot& shown) {
  for (AxisState& a : shown.axes)
    if (a.ended_by != EndedBy::nothing) a.ended_by = EndedBy::target;
}
void at_rest(LieMemory&, Snapshot& shown) {
  for (AxisState& a : shown.axes)
    if (a.activity != Activity::unknown) a.activity = Activity::idle;
}
void encoder_as_position(LieMemory&, Snapshot& shown) {
  for (AxisState& a : shown.axes) a.encoder = a.position;
}
/// What `seen` shows of the first reading is shown for ever.
template <auto Snapshot::*values, auto Snapshot::*known>
void as_first_read(LieMemory& memory, Snapshot& shown) {
  if (!memory.has_first && shown.*known != 0) {
    memory.first = shown;
    memory.has_first = true;
  }
  if (memory.has_first) shown.*values = memory.first.*values;
}
void outputs_as_set(LieMemory& memory, Snapshot& shown) {
  for (const auto& [place, on] : memory.outputs)
    shown.outputs = (shown.outputs & ~(1u << place)) | static_cast<std::uint32_t>(on) << place;
}
bool is_about_power(const Notice& notice) {
  return notice.text.find("switched off and on") != notice.text.npos;
}
void never_restarted(LieMemory&, Snapshot& shown) {
  shown.restarts = 0;
  for (AxisState& a : shown.axes)
    if (a.trust.doubtful()) a.trust = PositionTrust();
}

void never_killed(LieMemory&, Snapshot& shown) {
  for (AxisState& a : shown.axes)
    if (a.trust.cause == Doubt::killed) a.trust = PositionTrust();
}

using What = StopOrder::What;
constexpr Lie lies[] = {
    {.name = "home-not-sent", .keeps_back = any_of<intent::Home>},
    {.name = "home-said-and-not-sent", .keeps_back = any_of<intent::Home>, .paints = homed},
    {.name = "home-in-the-other-direction", .bends = home_back},
    {.name = "home-in-the-first-way-only", .concerns = several_homings, .bends = home_first_way},
    {.name = "home-of-the-first-axis-only", .concerns = several_axes, .keeps_back = homes_other_axes},
    {.name = "position-set-to-zero-always", .bends = set_to_zero},
    {.name = "position-not-set", .keeps_back = any_of<intent::SetPosition>},
    {.name = "position-set-on-the-screen-only",
     .keeps_back = any_of<intent::SetPosition>,
     .paints = position_as_set},
    {.name = "position-is-what-was-asked", .paints = position_as_asked},
    {.name = "move-not-sent", .keeps_back = any_of<intent::MoveTo, intent::MoveBy>},
    {.name = "move-sent-twice", .moves_twice = true},
    {.name = "move-one-step-short", .bends = one_step_short},
    {.name = "place-taken-for-a-distance", .bends = place_as_distance},
    {.name = "one-axis-of-several-moves", .concerns = several_axes, .bends = one_axis_of_several},
    {.name = "speed-ignored", .bends = without_speed},
    {.name = "first-axis-moves-only", .concerns = several_axes, .keeps_back = for_other_axes},
    {.name = "axes-crossed", .concerns = several_axes, .bends = last_axis_for_first},
    {.name = "jog-in-the-other-direction", .bends = jog_back},
    {.name = "jog-goes-on-when-let-go", .orders = [](BentStop& o) { o.is_sent = o.order.what != What::jog; }},
    {.name = "letting-go-stops-all",
     .concerns = several_jogs,
     .orders = [](BentStop& o) { o.order.axis = o.order.what == What::jog ? -1 : o.order.axis; }},
    {.name = "stop-not-sent",
     .orders = [](BentStop& o) { o.is_sent = o.order.what != What::everything || o.order.at_once; }},
    {.name = "stop-aborts", .orders = [](BentStop& o) { o.order.at_once = true; }},
    {.name = "abort-ramps", .orders = [](BentStop& o) { o.order.at_once = false; }},
    {.name = "abort-not-doubted", .concerns = without_servo, .paints = never_killed},
    {.name = "stop-of-the-first-axis-only",
     .concerns = several_axes,
     .orders = [](BentStop& o) { o.is_sent = o.order.what != What::everything || o.order.axis <= 0; }},
    {.name = "stop-of-one-stops-all",
     .concerns = several_axes,
     .orders = [](BentStop& o) { o.order.axis = o.order.what == What::everything ? -1 : o.order.axis; }},
    {.name = "stop-of-all-stops-one",
     .concerns = several_axes,
     .orders =
         [](BentStop& o) {
           o.order.axis = o.order.what == What::everything ? std::max(o.order.axis, 0) : o.order.axis;
         }},
    {.name = "power-not-switched",
     .concerns = switchable,
     .keeps_back = any_of<intent::SetPower>,
     .paints = power_as_set},
    {.name = "parameter-not-sent", .keeps_back = any_of<intent::SetParam>},
    {.name = "parameter-read-from-memory", .keeps_back = acceptable_param, .paints = params_as_set},
    {.name = "variable-not-sent", .concerns = variables, .keeps_back = any_of<intent::SetVariable>},
    {.name = "reset-not-sent", .concerns = can_reset, .keeps_back = any_of<intent::Reset>},
    {.name = "set-up-not-stored", .concerns = can_store, .keeps_back = any_of<intent::Store>},
    {.name = "limits-swapped", .paints = limits_swapped},
    {.name = "limits-not-shown", .paints = no_limits},
    {.name = "home-switch-not-shown", .concerns = home_inputs, .paints = no_home_switch},
    {.name = "ended-by-target-always", .paints = all_ended_well},
    {.name = "at-rest-always", .paints = at_rest},
    {.name = "encoder-is-the-position", .concerns = step_axes_with_encoder, .paints = encoder_as_position},
    {.name = "inputs-as-first-read",
     .concerns = inputs,
     .paints = as_first_read<&Snapshot::inputs, &Snapshot::inputs_known>},
    {.name = "outputs-as-first-read",
     .concerns = outputs,
     .paints = as_first_read<&Snapshot::outputs, &Snapshot::outputs_known>},
    {.name = "analog-as-first-read",
     .concerns = analog,
     .paints = as_first_read<&Snapshot::analog, &Snapshot::analog_known>},
    {.name = "outputs-inverted", .concerns = outputs, .bends = output_inverted, .paints = outputs_as_set},
    {.name = "outputs-not-sent",
     .concerns = outputs,
     .keeps_back = any_of<intent::SetOutput>,
     .paints = outputs_as_set},
    {.name = "program-not-sent", .concerns = stored_programs, .keeps_back = any_of<intent::LoadProgram>},
    {.name = "program-shown-from-the-editor",
     .concerns = stored_programs,
     .keeps_back = answered_from_memory},
    {.name = "program-not-run", .concerns = stored_programs, .keeps_back = any_of<intent::RunProgram>},
    {.name = "program-not-halted",
     .concerns = stored_programs,
     .orders = [](BentStop& o) { o.is_sent = o.order.what != What::program; }},
    {.name = "program-not-paused", .concerns = pauses, .keeps_back = any_of<intent::Pause>},
    {.name = "program-not-cleared", .concerns = stored_programs, .keeps_back = any_of<intent::ClearProgram>},
    {.name = "reply-empty", .replies = [](LieMemory&, std::string& reply) { reply.clear(); }},
    {.name = "reply-of-the-question-before",
     .replies = [](LieMemory& memory, std::string& reply) { std::swap(reply, memory.reply_before); }},
    {.name = "stop-text-not-known", .knows_no_stop_text = true},
    {.name = "power-cycle-not-told", .paints = never_restarted, .withholds = is_about_power},
    {.name = "failures-said-done", .hides_failures = true},
    {.name = "any-device-believed", .believes_anything = true},
};
constexpr Lie honest{.name = "honest"};  // by comparison: the same way round, and nothing to notice

const Lie* chosen = nullptr;

std::unique_ptr<Driver> make_chosen(DriverContext context) {
  return make_lying_driver(*find_device_type(context.catalog.model), std::move(context), *chosen);
}

}  // namespace

bool choose_lie(std::string_view name) {
  const auto* found =
      std::find_if(std::begin(lies), std::end(lies), [&](const Lie& lie) { return lie.name == name; });
  chosen = name == honest.name ? &honest : found != std::end(lies) ? found : nullptr;
  return chosen != nullptr;
}

std::vector<const DeviceType*> types_under_test() {
  static std::deque<DeviceType> lying;
  std::vector<const DeviceType*> all;
  for (const DeviceType& type : device_types()) {
    if (!type.make_emulator) continue;
    all.push_back(&type);
    if (!chosen) continue;
    all.back() = &lying.emplace_back(type);
    lying.back().make_driver = make_chosen;
  }
  return all;
}

std::vector<const DeviceType*> types_with_a_language() {
  std::vector<const DeviceType*> all = types_under_test();
  std::erase_if(all, [](const DeviceType* type) { return !type->language; });
  return all;
}

void print_lies() {
  for (const Lie& lie : lies) {
    std::cout << lie.name;
    for (const DeviceType& type : device_types())
      if (const auto catalog = type.make_catalog({});
          type.make_emulator && catalog && (!lie.concerns || lie.concerns(*catalog)))
        std::cout << ' ' << type.model;
    std::cout << '\n';
  }
}

}  // namespace hw
