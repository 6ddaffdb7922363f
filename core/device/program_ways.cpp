#include "core/device/program_ways.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <type_traits>

#include "core/base/index.h"
#include "core/base/rounded_steps.h"
#include "core/sequence/steps_in.h"

namespace hw {
namespace {

class WayReader {
 public:
  WayReader(const sequence::Sequence& sequence, const Catalog& catalog)
      : sequence_(sequence), catalog_(catalog) {
    for (AxisWays& axis : ways_) axis.known = true;
  }
  void read(const sequence::StepList& steps) {
    for (const sequence::Step& step : steps)
      if (!step.skipped)
        std::visit([this](const auto& kind) { take(kind); },
                   static_cast<const sequence::Step::Any&>(step.body));
  }
  [[nodiscard]] ProgramWays ways() && { return std::move(ways_); }

 private:
  void take(const sequence::Move& move) {
    for (std::size_t axis = 0; axis < sequence_.axes.size(); ++axis)
      if (move.to[axis]) goes(axis, *move.to[axis], move.relative);
  }
  void take(const sequence::Repeat& loop) { read(loop.steps); }
  void take(const sequence::Pen& pen) { read(pen.down ? sequence_.pen_down : sequence_.pen_up); }
  void take(const sequence::Jog& jog) { rests_anywhere(jog.axis); }
  void take(const sequence::Home& home) { rests_anywhere(home.axis); }
  void take(const sequence::MoveOnInput& move) { rests_anywhere(move.axis); }
  void take(const sequence::SpeedStairs& stairs) { rests_anywhere(stairs.axis); }
  void take(const sequence::Enable& power) {
    if (!power.on) rests_anywhere(power.axis);
  }
  /// Steps that move both axes of a plane, stop them, or are not known.
  template <class Kind>
  void take(const Kind&) {
    using namespace sequence;
    constexpr bool moves_nothing = std::is_same_v<Kind, Speed> || std::is_same_v<Kind, WaitMotion> ||
                                   std::is_same_v<Kind, Delay> || std::is_same_v<Kind, WaitInput> ||
                                   std::is_same_v<Kind, Output> || std::is_same_v<Kind, Comment>;
    if (!moves_nothing)
      for (AxisWays& axis : ways_) axis.known = false;
  }

  [[nodiscard]] int place_of(std::size_t axis) const { return catalog_.find_axis(sequence_.axes[axis].name); }
  void rests_anywhere(int axis) {
    if (axis < 0 || ix(axis) >= sequence_.axes.size()) return;
    if (const int at = place_of(ix(axis)); at >= 0 && at < max_axes) ways_[ix(at)].known = false;
  }
  void goes(std::size_t axis, double to, bool relative) {
    const int at = place_of(axis);
    if (at < 0 || at >= max_axes) return;
    AxisWays& way = ways_[ix(at)];
    const Steps steps = rounded_steps(to * sequence_.axes[axis].per_unit);
    if (!relative) {
      way.places.push_back(steps);
      return;
    }
    if (steps == Steps(0)) return;
    Steps& shortest = steps > Steps(0) ? way.shortest_plus : way.shortest_minus;
    const Steps length(std::abs(steps.value));
    shortest = shortest == Steps(0) ? length : std::min(shortest, length);
  }

  const sequence::Sequence& sequence_;
  const Catalog& catalog_;
  ProgramWays ways_{};
};

}  // namespace

ProgramWays ways_of(const sequence::Sequence& sequence, const Catalog& catalog) {
  WayReader reader(sequence, catalog);
  reader.read(sequence.steps);
  return std::move(reader).ways();
}

bool was_cut_short(const AxisWays& ways, Steps from, Steps at) {
  const bool minus = ways.shortest_minus != Steps(0), plus = ways.shortest_plus != Steps(0);
  const bool places = !ways.places.empty();
  if (!ways.known || int{minus} + int{plus} + int{places} != 1) return false;
  if (places) return std::find(ways.places.begin(), ways.places.end(), at) == ways.places.end();
  const Steps way = plus ? at - from : from - at;
  return way > Steps(0) && way < (plus ? ways.shortest_plus : ways.shortest_minus);
}

}  // namespace hw
