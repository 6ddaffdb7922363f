#pragma once
// Moves, jogs and homing begun by the console.
#include <vector>

#include "core/device/intent.h"
#include "core/devices/vme58/catalog.h"
#include "core/devices/vme58/speeds.h"

namespace hw::vme58 {

class Moves {
 public:
  Moves(Wire& wire, Readings& readings, const Selection& selection, Conversation& conversation,
        Commands& commands, const ServoLoops& loops, Motions& motions, Speeds& speeds, const Catalog& catalog,
        Snapshot& snapshot)
      : wire_(wire),
        readings_(readings),
        selection_(selection),
        conversation_(conversation),
        commands_(commands),
        loops_(loops),
        motions_(motions),
        speeds_(speeds),
        catalog_(catalog),
        snapshot_(snapshot) {}

  /// Moves one axis by itself, or several on a straight line as a group of AM, beside which others may run.
  Task<Result<>> move(std::vector<AxisTarget> targets, intent::Pace pace, bool relative,
                      Activity shown_as = Activity::moving);
  Task<Result<>> jog(intent::JogStart request);
  /// Jogs by JF, in thousandths of a count per second; 0 ends the jog.
  Task<Result<>> jog_slowly(int axis, std::int64_t thousandths);
  Task<Result<>> home(intent::Home request);

 private:
  using Operands = std::array<std::optional<std::int64_t>, most_axes>;
  struct Request {
    Operands operands{};
    Motions::Way way;
  };
  [[nodiscard]] Result<> may_move(int axis) const;
  [[nodiscard]] Result<WholePace> checked(const intent::Pace& pace) const {
    return check_pace(catalog_, acceleration_unit, pace);
  }
  [[nodiscard]] Result<Request> checked(const std::vector<AxisTarget>& targets, bool relative) const;
  [[nodiscard]] std::string move_text(const Request& request, WholePace pace, bool relative) const;
  Task<Result<>> begin(std::string text, Motions::Way way);
  Task<Result<>> begin_jog(std::string text, int axis);
  [[nodiscard]] int axes() const { return static_cast<int>(catalog_.axes.size()); }
  [[nodiscard]] const std::string& name(int axis) const {
    return catalog_.axes[static_cast<std::size_t>(axis)].name;
  }

  Wire& wire_;
  Readings& readings_;
  const Selection& selection_;
  Conversation& conversation_;
  Commands& commands_;
  const ServoLoops& loops_;
  Motions& motions_;
  Speeds& speeds_;
  const Catalog& catalog_;
  Snapshot& snapshot_;
};

/// Clears the report on the latest rejected program, which stays until something else is done.
void forget_rejection(Snapshot& snapshot);

}  // namespace hw::vme58
