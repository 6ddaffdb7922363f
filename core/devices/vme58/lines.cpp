#include "core/devices/vme58/lines.h"

#include <algorithm>
#include <utility>

#include <fmt/core.h>

#include "core/base/index.h"
#include "core/devices/vme58/catalog.h"

namespace hw::vme58 {

void Lines::take_directions(unsigned outputs) {
  directions_ = outputs;
  const bool same = std::all_of(catalog_.inputs.begin(), catalog_.inputs.end(), [&](const InputInfo& line) {
    return line.of_output == bit(directions_, line.number);
  });
  if (same) return;
  std::string jumpers;
  for (int line = 0; line < first_fixed_output; line += lines_of_a_group)
    jumpers += bit(directions_, line) ? 'O' : 'I';
  wire_.report(Notice::Kind::warning, fmt::format("Open the board with jumpers={} in its address: its "
                                                  "general lines do not have the directions shown here.",
                                                  jumpers));
}

void Lines::take(std::uint16_t levels) {
  snapshot_.inputs = levels;
  snapshot_.inputs_known = (1u << io_lines) - 1;
  for (std::size_t place = 0; place < catalog_.outputs.size(); ++place) {
    const int line = catalog_.outputs[place].number;
    if (line >= io_lines) continue;  // auxiliary
    const std::uint32_t mask = 1u << place;
    snapshot_.outputs_known =
        bit(directions_, line) ? snapshot_.outputs_known | mask : snapshot_.outputs_known & ~mask;
    snapshot_.outputs =
        bit(levels, line) ? snapshot_.outputs & ~mask : snapshot_.outputs | mask;  // low is on
  }
  snapshot_.io_seen_at = wire_.now();
}

Task<Result<>> Lines::set(intent::SetOutput request) {
  if (auto may = commands_.may_talk(); !may) co_return may;
  const int place = catalog_.find_output(request.number);
  if (place < 0)
    co_return fail(FaultKind::refused, fmt::format("There is no output {} on this board.", request.number),
                   "Nothing was sent.");
  const int auxiliary = request.number - first_auxiliary;
  if (auxiliary >= 0) co_return co_await set_auxiliary(auxiliary, request.on, 1u << place);
  co_return co_await set_line(request.number, request.on, 1u << place);
}

Task<Result<>> Lines::set_auxiliary(int axis, bool on, std::uint32_t mask) {
  std::string text = selection_.addressed(axis, on ? "AN" : "AF");
  auto sent = co_await commands_.transmit(std::move(text), Priority::intent);
  if (sent) know_auxiliary(axis, on);
  if (!sent && wire_.perhaps_done(sent.error())) snapshot_.outputs_known &= ~mask;
  co_return sent;
}

Task<Result<>> Lines::set_line(int line, bool on, std::uint32_t mask) {
  std::string text = fmt::format("{}{}\n", on ? "BL" : "BH", line);
  auto sent = co_await commands_.transmit(std::move(text), Priority::intent);
  if (!sent) co_return sent;
  auto looked = co_await readings_.look_at_registers(Priority::intent);
  if (!looked) co_return looked;
  if ((snapshot_.outputs_known & mask) == 0 || ((snapshot_.outputs & mask) != 0) == on) co_return Result<>();
  co_return fail(FaultKind::controller,
                 fmt::format("Output {} was switched {}, but its line still reads {}.", line,
                             on ? "on (low)" : "off (high)", on ? "high" : "low"),
                 "It was sent once.",
                 "Check whether a command queue is busy (the command then waits there), and whether the line "
                 "is jumpered as an input.");
}

Task<Result<>> Lines::switch_tool_off(ToolOff tool) {
  if (auto may = commands_.may_talk(); !may) co_return may;
  std::string lines, text;
  for (const ToolOutput& o : tool) {
    const int auxiliary = o.number - first_auxiliary;
    if (auxiliary >= 0)
      text += selection_.addressed(auxiliary, o.on ? "AN" : "AF");
    else
      lines += fmt::format("{}{}{}", lines.empty() ? "" : " ", o.on ? "BL" : "BH", o.number);
  }
  if (!lines.empty()) text += through_free_queue(std::move(lines));
  auto sent = co_await commands_.transmit(std::move(text), Priority::stop);
  if (!sent) co_return sent;
  for (const ToolOutput& o : tool)
    if (o.number >= first_auxiliary) know_auxiliary(o.number - first_auxiliary, o.on);
  co_return sent;
}

std::string Lines::through_free_queue(std::string text) const {
  const auto rests = [this](int axis) { return snapshot_.axes[ix(axis)].activity == Activity::idle; };
  const Context& context = selection_.context();
  const bool selected_rests =
      context.mode == where::single ? rests(context.axis) : !snapshot_.any_axis_moving();
  int axis = 0;
  while (axis < snapshot_.axis_count && !rests(axis)) ++axis;
  if (selected_rests || axis == snapshot_.axis_count) return text + "\n";
  return selection_.addressed(axis, text);
}

void Lines::know_auxiliary(int axis, bool on) {
  queued_.erase(axis);
  const int place = catalog_.find_output(first_auxiliary + axis);
  if (place < 0) return;
  const std::uint32_t mask = 1u << place;
  snapshot_.outputs = on ? snapshot_.outputs | mask : snapshot_.outputs & ~mask;
  snapshot_.outputs_known |= mask;
}

void Lines::doubt_auxiliary(int axis) {
  queued_.erase(axis);
  if (const int place = catalog_.find_output(first_auxiliary + axis); place >= 0)
    snapshot_.outputs_known &= ~(1u << place);
}

void Lines::queue_auxiliary(int axis, bool on) {
  doubt_auxiliary(axis);
  queued_[axis] = on;
}

void Lines::program_ended(bool whole) {
  for (const auto& [axis, on] : std::exchange(queued_, {}))
    if (whole) know_auxiliary(axis, on);
}

void Lines::as_from_factory() {
  queued_.clear();
  for (int i = 0; i < static_cast<int>(catalog_.axes.size()); ++i)
    know_auxiliary(i, true);  // decision M37: the output is high: its transistor is off
}

}  // namespace hw::vme58
