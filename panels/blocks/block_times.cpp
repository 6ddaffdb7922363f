#include "panels/blocks/block_times.h"

#include <algorithm>

#include <fmt/format.h>

#include "core/base/index.h"
#include "core/device/step_times.h"
#include "core/sequence/steps_in.h"
#include "gui/model/units_format.h"

namespace hw::panels {

namespace seq = sequence;
namespace {

/// A motion of this length continues when the rehearsal ends before it.
constexpr double long_s = 60;

/// First and last start of a step, and the number of starts.
struct Begun {
  int times = 0;
  double first = 0, last = 0;
};

std::vector<Begun> begun_of(const Rehearsal& r, std::span<const int> step_of_command, std::size_t count,
                            int& at) {
  std::vector<Begun> all(count);
  for (const RehearsedTurn& turn : r.turns) {
    const int next = ix(turn.command) < step_of_command.size() ? step_of_command[ix(turn.command)] : -1;
    if (next < 0 || next == at || ix(next) >= count) continue;
    at = next;
    Begun& b = all[ix(next)];
    if (b.times++ == 0) b.first = turn.t;
    b.last = turn.t;
  }
  return all;
}

class Times {
 public:
  Times(const Rehearsal& r, std::span<const int> step_of_command, int count)
      : r_(r),
        seconds_(seconds_of_parts(r, step_of_command)),
        begun_(begun_of(r, step_of_command, ix(count), last_)) {
    seconds_.resize(ix(count), 0);
    made_.of_step.resize(ix(count));
  }
  BlockTimes take(const seq::StepList& steps) && {
    for (const seq::Step& step : steps) made_.at_least_s += add_duration(step, true);
    made_.at_least_s = std::max(made_.at_least_s, r_.duration_s);
    made_.goes_on = !r_.finished && !r_.endless && goes_on_;
    return std::move(made_);
  }

 private:
  /// The known duration of a step and of all steps inside it.
  double add_duration(const seq::Step& step, bool outermost) {
    const int row = next_++;
    if (row == last_ && std::holds_alternative<seq::Delay>(step.body)) goes_on_ = true;
    const seq::StepList* inner = steps_in(step);
    double all = seconds_[ix(row)];
    if (row == last_ && !r_.finished && std::holds_alternative<seq::WaitInput>(step.body)) {
      made_.of_step[ix(row)] = "waits on";  // waits for events that no rehearsal can predict
      return all;
    }
    if (inner)
      for (const seq::Step& below : *inner) all += add_duration(below, false);
    const auto* loop = std::get_if<seq::Repeat>(&step.body);
    if (row == last_ && !r_.finished && !r_.endless && !inner && seconds_[ix(row)] >= long_s) {
      made_.of_step[ix(row)] = fmt::format("over {}", gui::format_duration(all).view());
      return all;
    }
    if (!loop || loop->times == 1) return note_duration(row, all);
    const double pass = pass_of(row, *loop, all, outermost);
    if (pass <= 0) return note_duration(row, all);
    made_.of_step[ix(row)] = loop->times == 0 ? fmt::format("{:.1f} s a pass", pass)
                                              : fmt::format("{} \u00d7 {:.1f} s", loop->times, pass);
    const bool cut_off = outermost && !r_.finished && begun_in(row).last + pass >= r_.duration_s;
    if (!cut_off || loop->times == 0) return all;
    goes_on_ = true;
    return std::max(all, pass * loop->times);
  }
  double note_duration(int row, double seconds) {
    if (seconds > 0) made_.of_step[ix(row)] = fmt::format("{:.1f} s", seconds);
    return seconds;
  }
  /// The step of the loop at `row` that is executed first.
  [[nodiscard]] Begun begun_in(int row) const {
    for (int r = row + 1; r < next_; ++r)
      if (begun_[ix(r)].times > 0) return begun_[ix(r)];
    return {};
  }
  /// Duration of one pass; 0: unknown. For a nested loop, the average.
  [[nodiscard]] double pass_of(int row, const seq::Repeat& loop, double all, bool outermost) const {
    const Begun begun = begun_in(row);
    if (outermost && r_.finished) return all / std::max(loop.times, 1);
    if (outermost && begun.times > 1) return (begun.last - begun.first) / (begun.times - 1);
    return begun.times > 1 ? all / begun.times : 0;
  }

  const Rehearsal& r_;
  int last_ = -1;         ///< step executed at the end of the rehearsal
  bool goes_on_ = false;  ///< that step comes to its end later
  std::vector<double> seconds_;
  std::vector<Begun> begun_;
  BlockTimes made_;
  int next_ = 0;
};

}  // namespace

BlockTimes block_times(const seq::StepList& steps, const Rehearsal& rehearsal,
                       std::span<const int> step_of_command) {
  return Times(rehearsal, step_of_command, count_steps(steps)).take(steps);
}

}  // namespace hw::panels
