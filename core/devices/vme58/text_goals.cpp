#include "core/devices/vme58/text_goals.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/base/index.h"
#include "core/base/rounded_steps.h"
#include "core/device/sequence_travel.h"
#include "core/devices/vme58/text_meaning.h"
#include "core/sequence/arc_shape.h"

namespace hw::vme58 {
namespace {

/// `f(axis, number)` for each number that belongs to an axis.
template <class F>
void each_number(const TextCommand& command, F f) {
  if (command.context.mode == where::single) {
    if (!command.numbers.empty() && command.numbers[0]) f(ix(command.context.axis), *command.numbers[0]);
    return;
  }
  for (std::size_t axis = 0; axis < std::min<std::size_t>(command.numbers.size(), most_axes); ++axis)
    if (command.numbers[axis]) f(axis, *command.numbers[axis]);
}

double in_counts(const UserUnits& units, std::size_t axis, double number) {
  return units[axis] == 0 ? number : std::round(number * units[axis]);
}

bool prepares(Op op) { return op == Op::MA || op == Op::MR || op == Op::MT || op == Op::ML; }

}  // namespace

std::size_t PreparedMoves::queue_of(const Context& context) {
  if (context.mode == where::all) return most_axes;
  return context.mode == where::single ? ix(context.axis) : most_axes + 1;
}

void PreparedMoves::note(const TextCommand& command, const UserUnits& units) {
  if (!command.fact || command.context.recording) return;
  const Op op = command.fact->op;
  Moves& moves = queues_[queue_of(command.context)];
  if (op == Op::GO || op == Op::GD || op == Op::ST || op == Op::FL) moves = {};
  if (op == Op::RS || op == Op::SA || op == Op::SD || op == Op::KL) forget();
  if (prepares(op))
    each_number(command, [&](std::size_t axis, double number) {
      moves[axis] = Move{in_counts(units, axis, number), op == Op::MR || op == Op::ML};
    });
}

void PreparedMoves::doubt(const TextCommand& command) {
  note(command, {});
  if (command.fact && !command.context.recording && prepares(command.fact->op))
    queues_[queue_of(command.context)] = {};
}

void PreparedMoves::forget(unsigned axes, bool groups) {
  for (std::size_t axis = 0; axis < most_axes; ++axis)
    if ((axes >> axis & 1u) != 0) queues_[axis] = {};
  if (groups) queues_[most_axes] = queues_[most_axes + 1] = {};
}

namespace {

class Walk {
 public:
  Walk(const std::vector<TextCommand>& commands, const UserUnits& units, const PreparedMoves& prepared,
       const Snapshot& now)
      : commands_(commands), units_(units), prepared_(prepared), axes_(ix(now.axis_count)) {
    for (std::size_t i = 0; i < axes_; ++i)
      if (now.axes[i].position_known) at_[i] = static_cast<double>(now.axes[i].goal().value);
  }

  std::vector<AxisTarget> run() && {
    for (std::size_t next = 0; next < commands_.size() && left_-- > 0;) {
      const TextCommand& command = commands_[next++];
      if (!command.fact || !command.flaw.empty()) break;  // nothing behind it is sent
      if (begins_block(command.fact->op))
        begin_loop(command, next);
      else if (const auto begin = block_begin_of(command.fact->op))
        next = end_pass(*begin, next);
      else
        carry_out(command);
    }
    if (left_ < 0) go_on();
    for (const auto& [axis, place] : jogs_) put(axis, place);
    return std::move(places_);
  }

 private:
  using Counts = std::array<std::optional<double>, most_axes>;
  struct Loop {
    Op kind;
    std::size_t begin;
    double passes;  ///< still to come; of WH and WS: until they are known
    Counts before;  ///< at the end of its last pass
    std::array<double, most_axes> grew_by{};
    bool passed = false;
  };
  struct Contour {
    std::vector<AxisTarget> reaches;
    Counts end;
  };

  void carry_out(const TextCommand& command) {
    const Op op = command.fact->op;
    if (command.context.recording) return record(command);
    if (op == Op::GO || op == Op::GD) go(command.context);
    prepared_.note(command, units_);
    if (op == Op::ST && command.context.mode == where::single)
      stop(ix(command.context.axis));
    else if (stops_motion(op))
      stop();
    switch (op) {
      case Op::RS: reset(); break;
      case Op::CD: begin_contour(command); break;
      case Op::CX: play(); break;
      case Op::JG:
      case Op::JF: jog(command); break;
      case Op::MP:
      case Op::MM: way_[ix(command.context.axis)] = op == Op::MP ? 1 : -1; break;
      case Op::MV: pass(command); break;
      case Op::SP:
      case Op::FP:
        end_jog(ix(command.context.axis));
        if (command.numbers[0]) go_to(ix(command.context.axis), counts(command.context.axis, command));
        break;
      case Op::LP:
        each_number(command, [this](std::size_t axis, double n) { at_[axis] = in_counts(units_, axis, n); });
        break;
      case Op::UU:
      case Op::UF: set_units(command); break;
      case Op::HM:
      case Op::HR:
      case Op::KM:
      case Op::KR:
      case Op::RM: lose_place(command.context); break;
      default: break;
    }
  }
  [[nodiscard]] double counts(int axis, const TextCommand& command) const {
    return in_counts(units_, ix(axis), *command.numbers[0]);
  }
  void put(std::size_t axis, Steps place) {
    places_.push_back({AxisId{static_cast<std::uint8_t>(axis)}, place});
  }
  void go_to(std::size_t axis, double place) {
    if (axis >= axes_ || !std::isfinite(place)) return;
    at_[axis] = place;
    put(axis, rounded_steps(place));
  }
  void go(const Context& context) {
    const PreparedMoves::Moves moves = prepared_.of(context);
    for (std::size_t axis = 0; axis < axes_; ++axis) {
      if (!moves[axis]) continue;
      if (!moves[axis]->relative)
        go_to(axis, moves[axis]->counts);
      else if (at_[axis])
        go_to(axis, *at_[axis] + moves[axis]->counts);
    }
  }
  /// A jog: within the text, only time or a stop ends it.
  void jog(const TextCommand& command) {
    each_number(command, [&](std::size_t axis, double velocity) {
      const double way = units_[axis] < 0 ? -velocity : velocity;
      end_jog(axis);
      at_[axis].reset();
      if (way != 0 && axis < axes_) jogs_.emplace_back(axis, endless(way));
    });
  }
  static Steps endless(double way) { return way > 0 ? hw::without_end : Steps(0) - hw::without_end; }
  void end_jog(std::size_t axis) {
    std::erase_if(jogs_, [axis](const auto& jog) { return jog.first == axis; });
  }
  /// MV holds the queue up to its place and runs on (decision M84).
  void pass(const TextCommand& command) {
    const std::size_t axis = ix(command.context.axis);
    if (!command.numbers[0] || axis >= axes_) return;
    const double place = counts(command.context.axis, command);
    const double way = at_[axis] ? place - *at_[axis] : way_[axis];
    go_to(axis, place);
    at_[axis].reset();
    end_jog(axis);
    way_[axis] = way;
    if (way != 0) jogs_.emplace_back(axis, endless(way));
  }
  /// A stop: it may cut short every motion begun before it.
  void stop() {
    places_.clear(), jogs_.clear();
    at_ = {};
  }
  void stop(std::size_t axis) {
    std::erase_if(places_, [axis](const AxisTarget& place) { return place.axis.index == axis; });
    end_jog(axis);
    at_[axis].reset();
  }
  void reset() {
    stop();
    contour_.reset(), loops_.clear();
    units_ = {}, way_ = {};
  }

  // ---- loops

  /// WH and WS repeat until CW or an input: two passes show which axes move further with each pass.
  void begin_loop(const TextCommand& command, std::size_t next) {
    const Op kind = command.fact->op;
    loops_.push_back({kind, next, kind == Op::LS ? command.numbers[0].value_or(1) : 2, at_});
  }
  std::size_t end_pass(Op begin, std::size_t next) {
    if (loops_.empty() || loops_.back().kind != begin) return next;
    Loop& loop = loops_.back();
    for (std::size_t axis = 0; axis < axes_; ++axis)
      loop.grew_by[axis] = at_[axis] && loop.before[axis] ? *at_[axis] - *loop.before[axis] : 0;
    loop.before = at_;
    loop.passed = true;
    if (--loop.passes > 0) return loop.begin;
    if (loop.kind != Op::LS) go_on(loop);
    loops_.pop_back();
    return next;
  }
  void go_on(const Loop& loop) {
    for (std::size_t axis = 0; axis < axes_; ++axis) {
      const double by = loop.grew_by[axis];
      if (by == 0) continue;
      if (loop.kind == Op::LS)
        put(axis, rounded_steps(*loop.before[axis] + by * loop.passes));
      else
        put(axis, endless(by));
      at_[axis].reset();
    }
  }
  /// The commands have run out inside a loop: the other passes move the axes as the last pass did.
  void go_on() {
    const auto outermost =
        std::find_if(loops_.begin(), loops_.end(), [](const Loop& loop) { return loop.passed; });
    if (outermost != loops_.end()) go_on(*outermost);
  }
  void lose_place(const Context& context) {
    if (context.mode == where::single)
      at_[ix(context.axis)].reset();
    else
      at_ = {};
  }
  void set_units(const TextCommand& command) {
    if (command.is(Op::UF) && command.context.mode != where::single) units_ = {};
    if (command.is(Op::UF) && command.context.mode == where::single) units_[ix(command.context.axis)] = 0;
    each_number(command, [this](std::size_t axis, double n) { units_[axis] = n; });
  }

  // ---- contours

  void begin_contour(const TextCommand& command) {
    contour_.emplace();
    each_number(command, [this](std::size_t axis, double n) { reach(axis, in_counts(units_, axis, n)); });
  }
  void reach(std::size_t axis, double place) {
    if (!std::isfinite(place)) return;
    contour_->end[axis] = place;
    if (axis < axes_)
      contour_->reaches.push_back({AxisId{static_cast<std::uint8_t>(axis)}, rounded_steps(place)});
  }
  /// Records a command of a contour: its numbers belong to the axes of the contour, in their order.
  void record(const TextCommand& command) {
    if (!contour_) return;
    std::vector<std::size_t> axes;
    for (std::size_t axis = 0; axis < most_axes; ++axis)
      if ((command.context.contour_axes >> axis & 1u) != 0) axes.push_back(axis);
    if (command.is(Op::CR) && axes.size() == 2) return arc(command, axes[0], axes[1]);
    for (std::size_t n = 0; command.is(Op::contour_MT) && n < std::min(axes.size(), command.numbers.size());
         ++n)
      if (command.numbers[n]) reach(axes[n], in_counts(units_, axes[n], *command.numbers[n]));
  }
  void arc(const TextCommand& command, std::size_t right, std::size_t up) {
    auto &x = contour_->end[right], &y = contour_->end[up];
    const auto& numbers = command.numbers;
    if (!x || !y || !numbers[0] || !numbers[1] || !numbers[2]) return contour_.reset();
    const sequence::Arc shape{in_counts(units_, right, *numbers[0]), in_counts(units_, up, *numbers[1]),
                              *numbers[2] / std::numbers::pi * 180};
    const sequence::ArcReach extent = sequence::reach_of(shape, *x, *y);
    const auto end = sequence::end_of(shape, *x, *y);
    for (const double place : {extent.left, extent.right, end.first}) reach(right, place);
    for (const double place : {extent.below, extent.above, end.second}) reach(up, place);
  }
  /// A contour recorded by an earlier text is not known.
  void play() {
    if (!contour_) {
      at_ = {};
      return;
    }
    left_ -= static_cast<int>(contour_->reaches.size());  // a place costs as much as a command
    places_.insert(places_.end(), contour_->reaches.begin(), contour_->reaches.end());
    for (std::size_t axis = 0; axis < most_axes; ++axis)
      if (contour_->end[axis]) at_[axis] = contour_->end[axis];
  }

  const std::vector<TextCommand>& commands_;
  UserUnits units_;
  PreparedMoves prepared_;
  const std::size_t axes_;
  Counts at_{};
  std::vector<AxisTarget> places_;
  std::vector<std::pair<std::size_t, Steps>> jogs_;  ///< that no command has ended so far
  std::vector<Loop> loops_;
  std::optional<Contour> contour_;
  std::array<double, most_axes> way_{};  ///< of MV; 0: not known
  int left_ = most_goal_commands;
};

}  // namespace

TextGoals goals_of(std::string_view text, Context context, const UserUnits& units,
                   const PreparedMoves& prepared, const Snapshot& now) {
  const std::vector<TextCommand> commands = read_commands(text, context);
  TextGoals goals;
  goals.places = Walk(commands, units, prepared, now).run();
  return goals;
}

}  // namespace hw::vme58
