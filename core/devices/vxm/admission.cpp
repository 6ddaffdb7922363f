#include "core/devices/vxm/admission.h"

#include <utility>

#include <fmt/core.h>

#include "core/base/index.h"
#include "core/devices/vxm/codec.h"

namespace hw::vxm {

Result<> Admission::may_run() const {
  if (presence_.is_halted())
    return fail(FaultKind::refused, explain_error(presence_.error()).what, "Nothing was sent.",
                explain_error(presence_.error()).advice);
  const int slot = console_.snapshot.program.slot;
  if (under_way_.program_runs())
    return fail(
        FaultKind::refused,
        slot >= 0 ? fmt::format("Program {} is running.", slot) : std::string("A program is running."),
        "Nothing was sent.", "Wait until it ends, or stop it.");
  const Job& job = under_way_.job();
  if (job.active() && job.leg().axis >= 0)
    return fail(
        FaultKind::refused,
        fmt::format("Motor {} is still moving, and a VXM does one thing at a time.", job.leg().axis + 1),
        "Nothing was sent.", "Wait until it ends, or stop it.");
  if (job.active())
    return fail(FaultKind::refused, "The previous command is still under way.", "Nothing was sent.",
                "Try again.");
  const auto input_mode = parameters_.value("I");
  constexpr std::uint32_t in_4 = 1u << 3;
  const Snapshot& snapshot = console_.snapshot;
  if (input_mode && *input_mode & inputs_stop && snapshot.inputs_known & in_4 && !(snapshot.inputs & in_4))
    return fail(FaultKind::refused,
                "The Stop button is pressed or input 4 is low, so the controller starts nothing.",
                "Nothing was sent.", "Release it, then try again.");
  return {};
}

Result<> Admission::may_move(int axis) const {
  if (axis < 0 || axis >= console_.snapshot.axis_count)
    return fail(FaultKind::refused, fmt::format("There is no motor {}.", axis + 1), "Nothing was sent.");
  if (axis >= motors_per_controller && !identification_.has_slave())
    return fail(
        FaultKind::refused,
        fmt::format("Motor {} belongs to a second controller, and none answers on the VXM bus.", axis + 1),
        "Nothing was sent.", check_slave);
  return may_run();
}

Result<> Admission::may_change() const {
  if (presence_.is_halted())
    return fail(FaultKind::refused, explain_error(presence_.error()).what, "Nothing was sent.",
                explain_error(presence_.error()).advice);
  if (under_way_.busy())
    return fail(FaultKind::refused, "The controller is busy and accepts no program commands.",
                "Nothing was sent.", "Wait until it ends, or stop it.");
  return {};
}

void Admission::warn_of_motor_type(int axis) {
  if (std::exchange(type_warned_[ix(axis)], true) || parameters_.value(fmt::format("M{}M", axis + 1)) != 0)
    return;
  console_.report(
      Notice::Kind::warning,
      fmt::format(
          "Choose the type of motor {0} in Setup, Motors, if it does not turn: it is set to type 0, the "
          "factory value for the smallest motors, and a larger motor only buzzes. The move was sent.",
          axis + 1));
}

}  // namespace hw::vxm
