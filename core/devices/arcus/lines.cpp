#include "core/devices/arcus/lines.h"

#include <fmt/core.h>

#include "core/base/index.h"

namespace hw::arcus {

bool Lines::glance_is_due() const {
  constexpr Duration glance_every = Millis(10);
  const Instant now = console_.scheduler.now();
  return now < watched_until_ && now - glanced_at_ >= glance_every;
}

// A fault here is ignored: it also shows on the question that follows.
Task<> Lines::glance() {
  glanced_at_ = console_.scheduler.now();
  auto inputs = co_await conversation_.ask_number("DI", Priority::poll);
  if (inputs) show_to_watchers(*inputs);
}

// Inputs are shown without waiting for the outputs that are read next.
void Lines::show_to_watchers(std::int64_t inputs) {
  const bool watched = console_.scheduler.now() < watched_until_;
  if (!watched || !glance_look_.agrees(static_cast<std::uint64_t>(inputs), conversation_.times_cleaned()))
    return;
  show_inputs(inputs, conversation_.asked_at());
  console_.changed();
}

void Lines::show_inputs(std::int64_t inputs, Instant asked_at) {
  console_.snapshot.inputs = static_cast<std::uint32_t>(inputs);
  console_.snapshot.inputs_known = (1u << console_.model().inputs) - 1;
  console_.snapshot.inputs_asked_at = asked_at;
}

Task<Result<>> Lines::read(Priority priority) {
  for (const bool again : {false, true}) {
    glanced_at_ = console_.scheduler.now();  // no glance right after this reading
    auto inputs = co_await conversation_.ask_number("DI", priority);
    if (!inputs) co_return fail(inputs.error());
    const Instant inputs_asked_at = conversation_.asked_at();
    show_to_watchers(*inputs);
    auto outputs = co_await conversation_.ask_number("DO", priority);
    if (!outputs) co_return fail(outputs.error());
    auto enables = co_await conversation_.ask_number("EO", priority);
    if (!enables) co_return fail(enables.error());
    const std::uint64_t lines = static_cast<std::uint64_t>(*inputs) << 16 ^
                                static_cast<std::uint64_t>(*outputs) << 8 ^
                                static_cast<std::uint64_t>(*enables);
    if (!look_.agrees(lines, conversation_.times_cleaned())) {
      if (!again) continue;
      break;  // the values shown keep their age
    }
    if (inputs_asked_at >= console_.snapshot.inputs_asked_at) show_inputs(*inputs, inputs_asked_at);
    console_.snapshot.outputs = static_cast<std::uint32_t>(*outputs);
    console_.snapshot.outputs_known = (1u << console_.model().outputs) - 1;
    console_.snapshot.io_seen_at = console_.scheduler.now();
    for (int i = 0; i < console_.axes(); ++i) console_.snapshot.axes[i].enabled = (*enables >> i & 1) != 0;
    break;
  }
  co_return Result<>();
}

Task<Result<>> Lines::set_power(intent::SetPower request) {
  const int first = request.axis < 0 ? 0 : request.axis,
            last = request.axis < 0 ? console_.axes() - 1 : request.axis;
  for (int axis = first; axis <= last; ++axis) {
    if (auto may = console_.has_axis(axis); !may) co_return may;
    auto set = co_await conversation_.command(
        set_command(fill(console_.forms, console_.forms.power, axis, Sign::plus, axis + 1), request.on),
        Priority::intent);
    if (!set) co_return set;
  }
  co_return co_await read(Priority::intent);
}

Task<Result<>> Lines::set_output(intent::SetOutput request) {
  if (request.number < 1 || request.number > console_.model().outputs)
    co_return fail(FaultKind::refused,
                   fmt::format("There is no output {}: outputs are DO1 to DO{}.", request.number,
                               console_.model().outputs),
                   "Nothing was sent.");
  auto set = co_await conversation_.command(set_command(fmt::format("DO{}", request.number), request.on),
                                            Priority::intent);
  if (!set) co_return set;
  auto seen = co_await read(Priority::intent);
  if (!seen) co_return seen;
  const bool shows = (console_.snapshot.outputs >> (request.number - 1) & 1) != 0;
  if (shows == request.on) co_return Result<>();
  co_return fail(
      FaultKind::controller,
      fmt::format("DO{} stays {}: {}.", request.number, shows ? "on" : "off", holder_of(request.number)),
      fmt::format("The controller has accepted DO{}={} and remembers it.", request.number,
                  request.on ? 1 : 0),
      "It takes effect as soon as the output is free.");
}

Task<Result<>> Lines::switch_tool_off(ToolOff tool) {
  Result<> all;
  for (const ToolOutput& o : tool) {
    auto set =
        co_await conversation_.command(set_command(fmt::format("DO{}", o.number), o.on), Priority::stop);
    if (all && !set) all = std::move(set);
  }
  co_return all;
}

// Decisions AMB-087, AMB-091.
std::string Lines::holder_of(int output) const {
  constexpr int in_position_output = 1, alarm_output = 3;
  const bool shown_by_outputs =
      setup_.setting(Setting::status_outputs).value_or(0) != 0 && console_.snapshot.axes[0].in_counts;
  if (shown_by_outputs && output == in_position_output)
    return "it shows in-position while EDO=1 and StepNLoop is on";
  if (shown_by_outputs && output == alarm_output) return "it shows the alarm while EDO=1 and StepNLoop is on";
  return "the controller itself uses it now, as a sync output or to show its state";
}

}  // namespace hw::arcus
