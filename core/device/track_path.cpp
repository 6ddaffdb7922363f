#include "core/device/track_path.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/index.h"

namespace hw {
namespace {

/// The line of the text under way as time advances, and how often it was begun before.
class LineAtTime {
 public:
  LineAtTime(const Rehearsal& rehearsal, int slot, std::span<const int> lines)
      : events_(rehearsal.events), turns_(rehearsal.turns), slot_(slot), lines_(lines) {}
  /// Includes commands begun before `t`.
  void go_on(double t) {
    for (; next_event_ < events_.size() && events_[next_event_].t < t; ++next_event_) {
      const RehearsedEvent& e = events_[next_event_];
      if (e.slot == slot_ && line_of(e.command) != nowhere) line_ = line_of(e.command);
    }
    for (; next_turn_ < turns_.size() && turns_[next_turn_].t < t; ++next_turn_) {
      const RehearsedTurn& turn = turns_[next_turn_];
      const int line = line_of(turn.command);
      if (line < 0) continue;
      if (line != turn_line_ || turn.command <= turn_command_) ++begun_[ix(line)];
      turn_line_ = line, turn_command_ = turn.command;
    }
  }
  [[nodiscard]] int line() const { return line_; }
  [[nodiscard]] int pass() const {
    return line_ < 0 || ix(line_) >= begun_.size() ? 0 : std::max(0, begun_[ix(line_)] - 1);
  }

 private:
  static constexpr int nowhere = -2;
  [[nodiscard]] int line_of(int command) {
    if (command < 0 || ix(command) >= lines_.size()) return nowhere;
    const int line = lines_[ix(command)];
    if (line >= 0 && begun_.size() <= ix(line)) begun_.resize(ix(line) + 1);
    return line;
  }

  std::span<const RehearsedEvent> events_;
  std::span<const RehearsedTurn> turns_;
  int slot_;
  std::span<const int> lines_;
  std::size_t next_event_ = 0, next_turn_ = 0;
  int line_ = -1, turn_line_ = -1, turn_command_ = -1;
  std::vector<int> begun_;  ///< by line
};

/// The position of one controller as time advances.
class TrackCursor {
 public:
  explicit TrackCursor(const std::vector<RehearsedPlace>& track) : track_(&track) {}
  [[nodiscard]] const RehearsedPlace* now() const { return track_->empty() ? nullptr : &(*track_)[at_]; }
  [[nodiscard]] const RehearsedPlace* next() const {
    return at_ + 1 < track_->size() ? &(*track_)[at_ + 1] : nullptr;
  }
  void go_on() { ++at_; }
  /// `t` lies between now() and next().
  [[nodiscard]] double position(int axis, double t) const {
    if (!now()) return 0;
    const auto a = static_cast<double>(now()->position[ix(axis)]);
    if (!next() || t <= now()->t) return a;
    const auto b = static_cast<double>(next()->position[ix(axis)]);
    return a + (b - a) * std::min(1.0, (t - now()->t) / (next()->t - now()->t));
  }

 private:
  const std::vector<RehearsedPlace>* track_;
  std::size_t at_ = 0;
};

bool tool_on(const RehearsedPlace& place, const TrackAxes& axes) {
  if (axes.tool_output >= 0)
    return (place.outputs >> axes.tool_output & 1u) == (axes.tool_is_on_when ? 1 : 0);
  if (!axes.lowers) return true;
  const std::int64_t beyond = place.position[ix(axes.lowers->place)] - axes.lowers->half_way;
  return axes.lowers->down_is_plus ? beyond > 0 : beyond < 0;
}

/// Walks all tracks at once, place by place in the order of time.
class Walk {
 public:
  Walk(std::span<const Rehearsal> all, const TrackAxes& axes) : axes_(axes) {
    for (const Rehearsal& one : all) standing_.emplace_back(one.track);
  }
  /// Advances to the next place of any track; false: there is none.
  bool go_on() {
    TrackCursor* soonest = nullptr;
    for (TrackCursor& s : standing_)
      if (s.next() && (!soonest || s.next()->t < soonest->next()->t)) soonest = &s;
    if (!soonest) return false;
    from_ = point();
    const RehearsedPlace* first = standing_.front().now();
    tool_on_ = !first || tool_on(*first, axes_);
    t_ = soonest->next()->t;
    soonest->go_on();
    return true;
  }
  [[nodiscard]] double t() const { return t_; }
  [[nodiscard]] bool with_tool() const { return tool_on_; }
  [[nodiscard]] drawing::Point3 from() const { return from_; }
  [[nodiscard]] drawing::Point3 point() const {
    const auto at = [this](const TrackAxes::Axis& axis) {
      return standing_[ix(axis.track)].position(axis.place, t_) * axis.units_per_step;
    };
    return {axes_.over_time ? t_ : at(axes_.right), at(axes_.up), axes_.third ? at(*axes_.third) : 0};
  }

 private:
  const TrackAxes& axes_;
  std::vector<TrackCursor> standing_;
  double t_ = 0;
  bool tool_on_ = true;
  drawing::Point3 from_;
};

/// The output, or the axis with its place, that a tool routine sets last.
struct Routine {
  std::optional<sequence::Output> output;
  std::array<std::optional<double>, max_axes> places{};
};
Routine routine_of(const sequence::StepList& steps) {
  Routine r;
  for (const sequence::Step& step : steps) {
    if (step.skipped) continue;
    if (const auto* output = std::get_if<sequence::Output>(&step.body); output && output->output >= 0)
      r.output = *output;
    if (const auto* move = std::get_if<sequence::Move>(&step.body); move && !move->relative)
      for (std::size_t a = 0; a < r.places.size(); ++a)
        if (move->to[a]) r.places[a] = move->to[a];
  }
  return r;
}

}  // namespace

bool take_tool_of(const sequence::Sequence& sequence, const Catalog& catalog, TrackAxes& axes) {
  const Routine down = routine_of(sequence.pen_down), up = routine_of(sequence.pen_up);
  if (down.output) {
    const int place = catalog.find_output(down.output->output);
    if (place < 0) return false;
    axes.tool_output = place, axes.tool_is_on_when = down.output->on;
    return true;
  }
  for (std::size_t a = 0; a < sequence.axes.size(); ++a) {
    const int place = catalog.find_axis(sequence.axes[a].name);
    if (!down.places[a] || !up.places[a] || down.places[a] == up.places[a] || place < 0) continue;
    const double half_way = (*down.places[a] + *up.places[a]) / 2 * sequence.axes[a].per_unit;
    const bool plus = (*down.places[a] > *up.places[a]) == (sequence.axes[a].per_unit > 0);
    axes.lowers = TrackAxes::Lowering{place, std::llround(half_way), plus};
    return true;
  }
  return false;
}

drawing::ToolPath track_path(const Rehearsal& rehearsal, const TrackAxes& axes, int slot,
                             std::span<const int> line_of_command) {
  drawing::ToolPath path;
  LineAtTime lines(rehearsal, slot, line_of_command);
  Walk walk(std::span(&rehearsal, 1), axes);
  while (walk.go_on()) {
    if (walk.point() == walk.from()) continue;
    lines.go_on(walk.t());
    path.go(walk.from(), walk.point(), walk.with_tool(), lines.line(), lines.pass());
  }
  return path;
}

drawing::ToolPath track_path_together(std::span<const Rehearsal> all, const TrackAxes& axes) {
  drawing::ToolPath path;
  if (all.empty()) return path;
  Walk walk(all, axes);
  while (walk.go_on())
    if (walk.point() != walk.from()) path.go(walk.from(), walk.point(), walk.with_tool(), -1);
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
