#include "core/sequence/rest.h"

#include <algorithm>
#include <array>
#include <map>
#include <set>

#include <fmt/format.h>

#include "core/base/index.h"
#include "core/sequence/arc_shape.h"
#include "core/sequence/places_before.h"
#include "core/sequence/steps_in.h"
#include "core/sequence/words.h"

namespace hw::sequence {
namespace {

constexpr int most_rounds = 100'000;  // passes times steps: beyond, relatively moved axes are unknown

/// State after some steps.
struct Standing {
  struct Axis {
    bool moved = false, by_routine = false;
    std::optional<double> at;  ///< none: not known
    int lost_by = -1;          ///< index of the step after which it is unknown
  };
  std::array<Axis, max_axes> axes;
  Speeds speeds;
  StepList settings;    ///< custom text that changes settings, and the speeds around it, in their order
  OwnSpeeds of_travel;  ///< of the latest motion with the tool up
  std::vector<Output> outputs;   ///< in switching order
  std::size_t with_tool_up = 0;  ///< number switched before the tool was lowered
  std::map<int, bool> power;     ///< of motors, by axis
  bool tool_down = false;
};

Speeds over(Speeds below, const Speeds& above) {
  if (above.high != 0) below.high = above.high;
  if (above.low != 0) below.low = above.low;
  if (above.ramp_ms != 0) below.ramp_ms = above.ramp_ms;
  return below;
}

/// Goes through steps and keeps the state.
class Pass {
 public:
  /// Axes moved by the tool are not sent to their positions at the beginning.
  explicit Pass(const Sequence& sequence, const Places& begin = {}, Rehearsed rehearsed = Rehearsed::no)
      : of_(sequence), rehearsed_(rehearsed) {
    for (int a = 0; a < max_axes; ++a)
      if (begin[ix(a)] && !is_moved_by_tool(sequence, a))
        standing.axes[ix(a)].moved = true, standing.axes[ix(a)].at = begin[ix(a)];
  }

  void list(const StepList& steps) {
    for (const Step& step : steps)
      if (!step.skipped) std::visit([this](const auto& body) { take(body); }, step.body);
  }
  void step(const Step& step, int place) {
    place_ = place;
    if (!step.skipped) std::visit([this](const auto& body) { take(body); }, step.body);
  }
  void keep(const Custom& settings) {
    if (standing.settings.empty() && standing.speeds != Speeds{}) keep_setting({Speed{standing.speeds}});
    keep_setting({settings});
  }
  Standing standing;

 private:
  template <class Other>
  void take(const Other&) {}  // waits and comments change nothing; custom text occurs in tool routines only
  void take(const Speed& s) {
    if (in_routine_) return;
    standing.speeds = over(standing.speeds, s.speeds);
    if (!standing.settings.empty()) keep_setting({s});
  }
  void keep_setting(Step setting) {
    std::erase(standing.settings, setting);
    standing.settings.push_back(std::move(setting));
  }
  void take(const Move& m) {
    for (int a = 0; a < axis_count(); ++a) {
      if (!m.to[ix(a)]) continue;
      const auto& from = axis(a).at;
      set(a, !m.relative ? m.to[ix(a)] : from ? std::optional(*from + *m.to[ix(a)]) : std::nullopt);
    }
    if (!standing.tool_down && !in_routine_) standing.of_travel = m.own;
  }
  void take(const Arc& arc) {
    const auto [right, up] = arc.plane;
    const auto x = axis(right).at, y = axis(up).at;
    if (!x || !y) return lose(right), lose(up);
    const auto [end_x, end_y] = end_of(arc, *x, *y);
    set(right, end_x), set(up, end_y);
  }
  void take(const Contour& c) {
    set(c.plane.right, c.x), set(c.plane.up, c.y);
    for (const Step& step : c.steps) {
      if (step.skipped) continue;
      if (const auto* move = std::get_if<Move>(&step.body)) take(*move);
      if (const auto* arc = std::get_if<Arc>(&step.body)) take(*arc);
      if (const auto* output = std::get_if<Output>(&step.body)) take(*output);
    }
    if (!c.ends_ramped) return;
    const auto end = end_of(c);
    const auto by = rehearsed_ == Rehearsed::yes ? runs_on_by(c, standing.speeds) : std::nullopt;
    std::optional<double> x, y;
    if (end && by) x = end->x + end->dx * *by, y = end->y + end->dy * *by;
    set(c.plane.right, x), set(c.plane.up, y);
  }
  void take(const SpeedStairs& s) { set(s.axis, s.stop_at); }
  void take(const Jog& j) { lose(j.axis); }
  void take(const Home& h) { lose(h.axis); }
  void take(const MoveOnInput& m) { lose(m.axis); }
  void take(const Stop& s) {
    for (int a = 0; a < axis_count(); ++a)
      if ((s.axis < 0 || s.axis == a) && axis(a).moved) lose(a);
  }
  void take(const Output& o) {
    if (in_routine_) return;  // an output of the tool's routine is switched with the tool
    auto& all = standing.outputs;
    const auto again = [&o](const Output& before) { return o.output < 0 || before.output == o.output; };
    const auto first = all.begin(), lowered = first + static_cast<std::ptrdiff_t>(standing.with_tool_up);
    standing.with_tool_up -= static_cast<std::size_t>(std::count_if(first, lowered, again));
    std::erase_if(all, again);
    all.push_back(o);
    if (!standing.tool_down) standing.with_tool_up = all.size();
  }
  void take(const Enable& e) { standing.power[e.axis] = e.on; }
  void take(const Pen& p) {
    if (!standing.tool_down || !p.down) standing.with_tool_up = standing.outputs.size();
    standing.tool_down = p.down;
    if (in_routine_) return;
    in_routine_ = true;
    list(p.down ? of_.pen_down : of_.pen_up);
    in_routine_ = false;
  }
  void take(const Repeat& loop) {
    if (static_cast<double>(loop.times) * count_steps(loop.steps) <= most_rounds) {
      for (int n = 0; n < loop.times; ++n) list(loop.steps);
      return;
    }
    list(loop.steps);
    for (int a = 0; a < axis_count(); ++a)
      if (axis(a).moved) lose(a);
    list(loop.steps);  // axes sent to a place are there after any pass
  }

  [[nodiscard]] int axis_count() const { return static_cast<int>(of_.axes.size()); }
  Standing::Axis& axis(int a) { return standing.axes[ix(a)]; }
  void set(int a, std::optional<double> at) {
    Standing::Axis& axis = this->axis(a);
    axis.moved = true, axis.by_routine = axis.by_routine || in_routine_;
    axis.at = at;
    if (!at && axis.lost_by < 0) axis.lost_by = place_;
    if (at) axis.lost_by = -1;
  }
  void lose(int a) { set(a, std::nullopt); }

  const Sequence& of_;
  const Rehearsed rehearsed_;
  bool in_routine_ = false;
  int place_ = -1;
};

template <class Body>
bool has(const StepList& steps) {
  return std::any_of(steps.begin(), steps.end(), [](const Step& step) {
    const StepList* inner = steps_in(step);
    return !step.skipped && (std::holds_alternative<Body>(step.body) || (inner && has<Body>(*inner)));
  });
}

bool looks_for_home(const StepList& steps) {
  return std::any_of(steps.begin(), steps.end(), [](const Step& step) {
    const StepList* inner = steps_in(step);
    const auto* some = std::get_if<MoveOnInput>(&step.body);
    return !step.skipped && (std::holds_alternative<Home>(step.body) || (inner && looks_for_home(*inner)) ||
                             (some && some->kind == MoveOnInput::Kind::home));
  });
}

bool switches_on(const Output& o) { return o.output < 0 ? o.value != 0 : o.on; }

/// Collects the outputs that the steps switch on; -1: all at once.
void collect_outputs(const StepList& steps, std::set<int>& found) {
  for (const Step& step : steps) {
    const auto* output = std::get_if<Output>(&step.body);
    if (output && !step.skipped && switches_on(*output)) found.insert(std::max(output->output, -1));
    if (const StepList* inner = steps_in(step)) collect_outputs(*inner, found);
  }
}

/// Writes the leading steps: outputs off, motors on, tool up, moves; the wanted state is restored only there.
class Leading {
 public:
  Leading(const Sequence& whole, const Standing& wanted, Sequence& into)
      : whole_(whole), wanted_(wanted), into_(into), has_tool_(has<Pen>(whole.steps)) {}

  void write(std::size_t step) {
    add(Comment{fmt::format("From step {} on.", step + 1)});
    switch_outputs_off();
    for (const auto& [axis, on] : wanted_.power)
      if (on || goes(axis)) add(Enable{axis, true});
    if (has_tool_) add(Pen{false});
    if (wanted_.settings.empty() && wanted_.speeds != Speeds{}) add(Speed{wanted_.speeds});
    into_.steps.insert(into_.steps.end(), wanted_.settings.begin(), wanted_.settings.end());
    go();
    const std::size_t all = wanted_.outputs.size(), first = wanted_.tool_down ? wanted_.with_tool_up : all;
    switch_outputs_on(0, first);
    if (wanted_.tool_down) add(Pen{true});
    set_tool_axes();
    switch_outputs_on(first, all);
    for (const auto& [axis, on] : wanted_.power)
      if (!on) add(Enable{axis, false});
    add(Comment{std::string(rest_begins)});
  }

 private:
  void add(Step::Body body) { into_.steps.push_back({std::move(body)}); }
  /// Switches off the outputs of the tool's routines; if they have none, any output may be the tool. Others
  /// that are on may hold the workpiece and stay on.
  void switch_outputs_off() {
    std::set<int> off;
    if (has_tool_) collect_outputs(whole_.pen_down, off);
    if (off.empty()) collect_outputs(whole_.steps, off);
    for (const Output& output : wanted_.outputs)
      if (!switches_on(output)) off.insert(std::max(output.output, -1));
    if (off.contains(-1)) off = {-1};
    for (const int output : off)
      if (!goes_off_with_the_tool(output)) add(Output{output, false, 0});
  }
  /// Switches on the outputs that were switched on while the tool was down: after lowering it, not above the
  /// place.
  void switch_outputs_on(std::size_t from, std::size_t to) {
    for (std::size_t i = from; i < to; ++i) {
      const Output& output = wanted_.outputs[i];
      if (all_set_ || switches_on(output)) add(output);
      all_set_ = all_set_ || output.output < 0;
    }
  }
  [[nodiscard]] bool goes_off_with_the_tool(int output) const {
    return has_tool_ && std::any_of(whole_.pen_up.begin(), whole_.pen_up.end(), [output](const Step& step) {
             const auto* o = std::get_if<Output>(&step.body);
             return o && !step.skipped && (o->output < 0 ? o->value == 0 : o->output == output && !o->on);
           });
  }
  /// Whether the leading steps move the axis.
  [[nodiscard]] bool goes(int axis) const {
    return wanted_.axes[ix(axis)].at || (has_tool_ && is_moved_by_tool(whole_, axis));
  }
  void go() {
    Move move;
    move.own = wanted_.of_travel;
    for (std::size_t a = 0; a < whole_.axes.size(); ++a)
      if (!wanted_.axes[a].by_routine) move.to[a] = wanted_.axes[a].at;
    add_move(move);
  }
  void add_move(const Move& move) {
    if (std::none_of(move.to.begin(), move.to.end(), [](const auto& to) { return to.has_value(); })) return;
    add(move);
    add(WaitMotion{});
  }
  /// Axes of the tool's routines that other steps have moved too.
  void set_tool_axes() {
    Pass so_far(whole_);
    so_far.list(into_.steps);
    Move move;
    for (std::size_t a = 0; a < whole_.axes.size(); ++a) {
      const Standing::Axis& wanted = wanted_.axes[a];
      if (wanted.by_routine && wanted.at && wanted.at != so_far.standing.axes[a].at) move.to[a] = wanted.at;
    }
    add_move(move);
  }

  const Sequence& whole_;
  const Standing& wanted_;
  Sequence& into_;
  const bool has_tool_;
  bool all_set_ = false;  ///< all outputs were set at once: later ones that are off must be written too
};

tl::unexpected<Fault> cannot(std::string what, std::string advice) {
  return fail(FaultKind::refused, std::move(what), "Nothing was started.", std::move(advice));
}

/// Why the tool cannot be lifted from an unknown height; empty: it can.
std::string_view why_no_lift(const Sequence& sequence) {
  if (!has<Pen>(sequence.steps)) return {};
  for (const StepList* routine : {&sequence.pen_up, &sequence.pen_down})
    for (const Step& step : *routine)
      if (const auto* move = std::get_if<Move>(&step.body); move && move->relative && !step.skipped)
        return "The tool is lifted by a distance, not to a place, so it may not be up.";
  return {};
}

}  // namespace

Result<Rest> rest_from(const Sequence& sequence, std::size_t step, const Places& begin, Rehearsed rehearsed,
                       const OnlySets& only_sets) {
  if (const std::string_view why = why_no_lift(sequence); !why.empty())
    return cannot(std::string(why), "Move the tool to a place, up and down.");
  Pass before(sequence, begin, rehearsed);
  for (std::size_t i = 0; i < step; ++i) {
    const Step& passed = sequence.steps[i];
    const auto* loop = std::get_if<Repeat>(&passed.body);
    if (loop && loop->times == 0 && !passed.skipped)
      return cannot(fmt::format("Step {} repeats forever: step {} is never reached.", i + 1, step + 1), "");
    const auto* own = std::get_if<Custom>(&passed.body);
    if (own && !passed.skipped && only_sets && only_sets(*own)) {
      before.keep(*own);
      continue;
    }
    if (has<Custom>({passed}))
      return cannot(fmt::format("The state after step {} ({} {}) is unknown.", i + 1, title_of(passed.body),
                                summary_of(passed.body, sequence)),
                    fmt::format("Begin at step {}, or before it.", i + 1));
    before.step(passed, static_cast<int>(i));
  }
  const Standing& standing = before.standing;
  Rest rest;
  for (std::size_t a = 0; a < sequence.axes.size(); ++a) {
    const Standing::Axis& axis = standing.axes[a];
    rest.start[a] = axis.at;
    if (!axis.moved || axis.at || axis.by_routine) continue;
    const Step::Body& lost = sequence.steps[ix(axis.lost_by)].body;
    return cannot(
        fmt::format(
            "The position of {} before step {} is unknown: the machine decides where step {} ({} {}) ends.",
            sequence.axes[a].name, step + 1, axis.lost_by + 1, title_of(lost), summary_of(lost, sequence)),
        fmt::format("Begin at step {}, or after a step that sends {} to a place.", axis.lost_by + 1,
                    sequence.axes[a].name));
  }
  rest.sequence = frame_of(sequence);
  Leading(sequence, standing, rest.sequence).write(step);
  rest.leading = rest.sequence.steps.size();
  const auto first = sequence.steps.begin(), from = first + static_cast<std::ptrdiff_t>(step);
  rest.leaves_homing_out = looks_for_home(StepList(first, from));
  rest.sequence.steps.insert(rest.sequence.steps.end(), from, sequence.steps.end());
  return rest;
}

Result<std::size_t> step_to_begin_at(const Sequence& sequence, int counted) {
  int first = 0;
  for (std::size_t i = 0; i < sequence.steps.size(); ++i) {
    const Step& step = sequence.steps[i];
    const StepList* inner = steps_in(step);
    const int size = 1 + (inner ? count_steps(*inner) : 0);
    if (counted >= first + size || counted < first) {
      first += size;
      continue;
    }
    if (counted > first && std::holds_alternative<Repeat>(step.body))
      return cannot(
          fmt::format("The line lies within the loop of step {}: the number of passes made is unknown.",
                      i + 1),
          "Begin before the loop or after it.");
    return i;
  }
  return cannot("No step draws this line.", "Click a line that is drawn by a step.");
}

std::string words_of_leading(const Rest& rest) {
  std::string all;
  for (std::size_t i = 0; i < rest.leading; ++i) {
    const Step::Body& body = rest.sequence.steps[i].body;
    if (std::holds_alternative<Comment>(body) || std::holds_alternative<WaitMotion>(body)) continue;
    if (const auto* own = std::get_if<Custom>(&body)) {
      std::string text = own->text;
      text.erase(text.find_last_not_of(" \r\n,") + 1);
      std::replace(text.begin(), text.end(), '\n', ' ');
      all += fmt::format("{}{}.", all.empty() ? "" : " ", text);
      continue;
    }
    const bool places = std::holds_alternative<Move>(body) && rest.sequence.unit != "steps";
    all += fmt::format("{}{} {}{}{}.", all.empty() ? "" : " ", title_of(body),
                       summary_of(body, rest.sequence), places ? " " : "", places ? rest.sequence.unit : "");
  }
  return all;
}

}  // namespace hw::sequence
