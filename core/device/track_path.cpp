#include "core/device/track_path.h"

#include "core/base/index.h"

namespace hw {
namespace {

/// Which line of the text the program is at, while time goes on.
class LineAtTime {
 public:
  LineAtTime(const Rehearsal& rehearsal, int slot, std::span<const int> lines)
      : events_(rehearsal.events), slot_(slot), lines_(lines) {}
  /// Of what moves up to `t`: its command was begun before.
  int before(double t) {
    for (; next_ < events_.size() && events_[next_].t < t; ++next_) {
      const RehearsedEvent& e = events_[next_];
      if (e.slot == slot_ && e.command >= 0 && ix(e.command) < lines_.size()) line_ = lines_[ix(e.command)];
    }
    return line_;
  }

 private:
  std::span<const RehearsedEvent> events_;
  int slot_;
  std::span<const int> lines_;
  std::size_t next_ = 0;
  int line_ = -1;
};

drawing::Point3 point_of(const RehearsedPlace& place, const TrackAxes& axes) {
  const auto at = [&place](const TrackAxes::Axis& axis) {
    return static_cast<double>(place.position[ix(axis.place)]) * axis.units_per_step;
  };
  return {at(axes.right), at(axes.up), axes.third ? at(*axes.third) : 0};
}

}  // namespace

drawing::ToolPath track_path(const Rehearsal& rehearsal, const TrackAxes& axes, int slot,
                             std::span<const int> line_of_command) {
  drawing::ToolPath path;
  LineAtTime lines(rehearsal, slot, line_of_command);
  const auto tool_on = [&axes](const RehearsedPlace& place) {
    return axes.tool_output < 0 || (place.outputs >> axes.tool_output & 1u) != 0;
  };
  for (std::size_t i = 1; i < rehearsal.track.size(); ++i) {
    const RehearsedPlace &from = rehearsal.track[i - 1], &to = rehearsal.track[i];
    const drawing::Point3 a = point_of(from, axes), b = point_of(to, axes);
    if (a == b) continue;
    path.go(a, b, tool_on(from), lines.before(to.t));
  }
  return path;
}

std::vector<int> lines_of_commands(const ProgramReport& report, int slot) {
  std::vector<int> lines;
  for (std::size_t line = 0; line < report.lines.size(); ++line) {
    const LineReport& l = report.lines[line];
    if (l.first_command < 0 || l.command_count <= 0 || (l.slot >= 0 && l.slot != slot)) continue;
    const std::size_t end = ix(l.first_command + l.command_count);
    if (lines.size() < end) lines.resize(end, -1);
    for (std::size_t c = ix(l.first_command); c < end; ++c) lines[c] = static_cast<int>(line);
  }
  return lines;
}

}  // namespace hw
