#pragma once
// Commands that close the loop of a servo axis or make it drive harder, with a question to the user while the
// axis is far off; and commands that set its position.
#include "core/device/intent.h"
#include "core/devices/vme58/commands.h"
#include "core/devices/vme58/motions.h"

namespace hw::vme58 {

class ServoDrive {
 public:
  ServoDrive(Readings& readings, const Selection& selection, Commands& commands,
             const ParameterValues& values, ServoLoops& loops, Motions& motions, NextRound& next,
             const Catalog& catalog, Snapshot& snapshot)
      : readings_(readings),
        selection_(selection),
        commands_(commands),
        values_(values),
        loops_(loops),
        motions_(motions),
        next_(next),
        catalog_(catalog),
        snapshot_(snapshot) {}

  /// HN closes the loop; HF opens it and leaves the motor free.
  Task<Result<>> switch_loop(int axis, bool on, intent::Closing answer);
  Task<Result<>> set_power(intent::SetPower request);
  /// Whether a gain may be set that makes a closed loop act on its error. A loop that follows its command, or
  /// settles, may be tuned.
  Task<Result<>> may_drive(const Parameter& parameter, std::int64_t value, intent::Closing answer);
  Task<Result<>> set_position(intent::SetPosition request);

 private:
  Task<Result<>> may_close(int axis, intent::Closing answer, std::string state, std::string consequence);
  Task<Result<>> take_place(int axis);
  Task<Result<>> load_positions(int axis, Steps wanted);
  [[nodiscard]] std::string load_text(int axis,
                                      const std::array<std::optional<std::int64_t>, most_axes>& to) const;
  [[nodiscard]] int axes() const { return static_cast<int>(catalog_.axes.size()); }
  [[nodiscard]] const std::string& name(int axis) const {
    return catalog_.axes[static_cast<std::size_t>(axis)].name;
  }

  Readings& readings_;
  const Selection& selection_;
  Commands& commands_;
  const ParameterValues& values_;
  ServoLoops& loops_;
  Motions& motions_;
  NextRound& next_;
  const Catalog& catalog_;
  Snapshot& snapshot_;
};

}  // namespace hw::vme58
