#include "core/device/tool_guard.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

namespace hw {
namespace {

constexpr int attempts = 5;
constexpr int place_of_pieces = -2;

bool program_goes_on(const ProgramState& program) {
  return program.owned && (program.run == RunState::running || program.run == RunState::waiting);
}

/// A bit for each sign of a limit: an active switch, a motion ended by a limit, a program that reports one.
std::uint32_t limits_shown(const Snapshot& now) {
  std::uint32_t bits = now.program.ended_by == EndedBy::limit ? 1u << 3 * max_axes : 0;
  for (int i = 0; i < now.axis_count; ++i) {
    const AxisState& axis = now.axes[static_cast<std::size_t>(i)];
    if (axis.limits_known && axis.limit_minus) bits |= 1u << 3 * i;
    if (axis.limits_known && axis.limit_plus) bits |= 2u << 3 * i;
    if (axis.ended_by == EndedBy::limit) bits |= 4u << 3 * i;
  }
  return bits;
}

}  // namespace

/// Limits met earlier do not concern a run that begins now; those of a run under way do.
void ToolGuard::goes_to_work(const Snapshot& now) {
  if (!std::exchange(at_work_, true)) limits_ = limits_shown(now);
}

void ToolGuard::program_may_run(const Snapshot& now) {
  if (!all_.empty()) goes_to_work(now);
}

Result<> ToolGuard::begin(const IntentBody& intent, const Snapshot& now) {
  if (const auto* load = std::get_if<intent::LoadProgram>(&intent)) {
    auto tool = tool_off_in(load->text);
    if (!tool) {
      tool.error().kind = FaultKind::refused;
      return fail(tool.error());
    }
    for (const ToolOutput& o : *tool)
      if (catalog_.find_output(o.number) < 0)
        return fail(FaultKind::refused,
                    fmt::format("The tool of this program is switched off by output {}, which a {} does not "
                                "have.",
                                o.number, catalog_.short_name),
                    "The program was not loaded.");
    loading_ = std::move(*tool);
    gather();
  } else if (!all_.empty() && !catalog_.can.outputs_while_held &&
             is_any_of<intent::Pause, intent::SingleStep>(intent)) {
    return fail(FaultKind::refused,
                fmt::format("A {} cannot switch its outputs while a program is held, so the tool ({}) would "
                            "stay on.",
                            catalog_.short_name, tool_outputs_words(all_)),
                "Nothing was sent.", "Stop ends the run with the tool off.");
  } else if (!all_.empty() && is_any_of<intent::RunProgram, intent::Resume, intent::SingleStep>(intent)) {
    goes_to_work(now);
    if (std::holds_alternative<intent::RunProgram>(intent)) forget_hold();
  }
  return {};
}

bool ToolGuard::is_seen_before(const IntentBody& intent) const {
  return at_work_ &&
         is_any_of<intent::LoadProgram, intent::UploadProgram, intent::ClearProgram, intent::Store,
                   intent::ReadParams, intent::ReadAgain, intent::RunInPieces>(intent);
}

void ToolGuard::done(const IntentBody& intent) {
  if (const auto* load = std::get_if<intent::LoadProgram>(&intent)) {
    if (load->slot < 0) by_place_.clear();
    by_place_[place_of(load->slot)] = std::exchange(loading_, {}).value_or(ToolOff());
  } else if (const auto* clear = std::get_if<intent::ClearProgram>(&intent)) {
    by_place_.erase(place_of(clear->slot));
  } else {
    return;
  }
  gather();
}

void ToolGuard::refused(const IntentBody& intent) {
  if (!std::holds_alternative<intent::LoadProgram>(intent)) return;
  loading_.reset();
  gather();
}

/// A text that was loaded in part may have left parts of the one before.
void ToolGuard::gather() {
  all_.clear();
  const auto add = [this](const ToolOff& tool) {
    for (const ToolOutput& o : tool)
      if (std::find(all_.begin(), all_.end(), o) == all_.end()) all_.push_back(o);
  };
  for (const auto& [place, tool] : by_place_) add(tool);
  if (loading_) add(*loading_);
}

std::optional<bool> ToolGuard::is_on(int number, const Snapshot& now) const {
  const int place = catalog_.find_output(number);
  if (place < 0 || (now.outputs_known >> place & 1u) == 0) return std::nullopt;
  return (now.outputs >> place & 1u) != 0;
}

bool ToolGuard::is_off(const Snapshot& now) const {
  return std::all_of(all_.begin(), all_.end(),
                     [&](const ToolOutput& o) { return is_on(o.number, now) == o.on; });
}

void ToolGuard::pieces_begin(const ToolOff& tool, const Snapshot& now) {
  by_place_[place_of_pieces] = tool;
  if (!tool.empty()) goes_to_work(now);
  forget_hold();
  gather();
}

/// During a hold the motion under way continues to its end, with the tool on.
ToolGuard::Cause ToolGuard::cause(const Snapshot& now) {
  const std::uint32_t limits = limits_shown(now), met = limits & ~std::exchange(limits_, limits);
  const bool acts_are_held = now.pieces.held && (now.feed.running || now.pieces.rests);
  if (program_goes_on(now.program) || (now.pieces.draws && !acts_are_held)) {
    const bool was_at_work = std::exchange(at_work_, true);
    return was_at_work && met != 0 ? Cause::limit : Cause::none;
  }
  const bool held = now.program.run == RunState::held || acts_are_held;
  const bool moves_on = held && (now.any_axis_moving() || now.working);
  return at_work_ && !moves_on ? Cause::rests : Cause::none;
}

ToolGuard::Request ToolGuard::watch(const Snapshot& now, std::uint64_t rounds) {
  if (all_.empty()) return Request::nothing;
  const Cause seen = cause(now);
  if (look_ == 0) {
    cause_ = seen;
    return seen == Cause::none ? Request::nothing : Request::look;
  }
  if (rounds < look_) return Request::nothing;
  if (now.io_seen_at < asked_at_) return Request::look;  // the outputs were not reported since
  look_ = 0;
  const Cause judged = std::exchange(cause_, Cause::none);
  if (judged == Cause::limit) return is_off(now) ? Request::nothing : Request::stop;
  if (seen != Cause::rests) return Request::nothing;  // the run continues
  if (!is_off(now)) return Request::switch_off;
  if (now.any_axis_moving()) return Request::nothing;  // a motion of the program may switch the tool on again
  at_work_ = false;
  if (!now.pieces.draws && by_place_.erase(place_of_pieces) > 0) gather();
  return Request::nothing;
}

StopProgress ToolGuard::progress(const StopOrder& order, const Snapshot& now) const {
  if (now.io_seen_at <= order.sent_at) return StopProgress::wait();
  for (const ToolOutput& o : order.tool) {
    const auto on = is_on(o.number, now);
    if (on == o.on || (!on && order.confirmed)) continue;  // not every controller reports its outputs
    if (order.times_sent < attempts) return StopProgress::again();
    return StopProgress::failed(
        Fault(FaultKind::controller,
              fmt::format("The tool is not off: output {} {}.", o.number,
                          on ? fmt::format("still reads {}", *on ? "on" : "off") : "cannot be read"),
              fmt::format("It was switched {} times.", order.times_sent), "Switch the tool off by hand."));
  }
  return StopProgress::stands();
}

void ToolGuard::give_up() {
  at_work_ = false;
  look_ = 0;
}

void ToolGuard::note_hold(const Snapshot& now) {
  for (const ToolOutput& o : all_)
    if (const ToolOutput used{o.number, !o.on};
        is_on(o.number, now) == used.on && std::find(held_.begin(), held_.end(), used) == held_.end())
      held_.push_back(used);
}

}  // namespace hw
