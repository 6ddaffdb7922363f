#include "core/device/act_writer.h"

#include <algorithm>
#include <cmath>

#include "core/sequence/chords.h"

namespace hw {

namespace seq = sequence;  // its names are those of commands too

std::size_t last_tool_up(const seq::StepList& steps, std::size_t from) {
  std::size_t up = 0;
  bool down = false;
  for (std::size_t i = 0; i < from; ++i) {
    if (const auto* pen = std::get_if<seq::Pen>(&steps[i].body); pen && !steps[i].skipped) down = pen->down;
    if (!down) up = i + 1;
  }
  return up;
}

Result<> ActWriter::write_all() {
  if (auto found = draft_.find_axes(); !found) return found;
  const seq::StepList& steps = draft_.sequence.steps;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    place_ = static_cast<int>(i);
    if (auto written = write(steps[i], i); !written) return written;
  }
  flush();
  end_piece();
  return {};
}

Result<> ActWriter::write(const seq::Step& step, std::size_t place) {
  draft_.enter(step, place);
  Result<> written;
  if (!draft_.in_routine() && place == from_ && from_ > 0) written = begin_here();
  if (written && !step.skipped)
    written = std::visit([this](const auto& body) { return write(body); }, step.body);
  if (written) draft_.leave();
  return written;
}

Result<> ActWriter::write(const seq::Speed& step) {
  draft_.set_speeds(step.speeds);
  return speeds(step.speeds);
}

Result<> ActWriter::write(const seq::Move& step) {
  for (int a = 0; a < draft_.axis_count(); ++a) {
    if (!step.to[ix(a)]) continue;
    if (!can_move(a) || (step.relative && !draft_.at(a))) return unfit();
    const auto to = step.relative ? draft_.distance(a, *step.to[ix(a)]) : draft_.position(a, *step.to[ix(a)]);
    if (!to) return fail(to.error());
    draft_.stands(a, step.relative ? *draft_.at(a) + *to : *to);
  }
  drew_ = drew_ || (cuts() && emits());
  return go(step.own);
}

/// Tolerance of a chord, in steps of the plane.
double ActWriter::tolerance(const seq::Plane& plane) const {
  constexpr double half_a_step = 0.5;
  const seq::Sequence& s = draft_.sequence;
  return std::max(half_a_step, s.tolerance * s.axes[ix(plane.right)].per_unit);
}

Result<> ActWriter::write(const seq::Arc& step) {
  const auto [right, up] = step.plane;
  const bool goes = draft_.has(step.plane) && can_move(right) && can_move(up) && draft_.alike(step.plane);
  const auto x = draft_.at(right), y = draft_.at(up);
  if (!goes || !x || !y) return unfit();
  const auto cx = draft_.position(right, step.x), cy = draft_.position(up, step.y);
  if (!cx || !cy) return fail(!cx ? cx.error() : cy.error());
  const seq::Chords chords(static_cast<double>(*x - *cx), static_cast<double>(*y - *cy), step.degrees,
                           tolerance(step.plane));
  for (int n = 1; n <= chords.count(); ++n) {
    const auto [dx, dy] = chords.end(n);
    draft_.stands(right, *cx + std::llround(dx));
    draft_.stands(up, *cy + std::llround(dy));
    if (auto gone = go(step.own); !gone) return gone;
  }
  drew_ = drew_ || (cuts() && emits());
  return {};
}

Result<> ActWriter::write(const seq::Output& step) {
  if (step.output < 0) return unfit();
  if (auto known = draft_.output(step.output); !known) return fail(known.error());
  flush();
  if (emits()) act(intent::SetOutput(step.output, step.on));
  return {};
}

Result<> ActWriter::write(const seq::Delay& step) {
  flush();
  return emits() ? pause(Duration(std::llround(step.ms * 1e6))) : Result<>();
}

Result<> ActWriter::write(const seq::Pen& step) {
  if (draft_.in_routine()) return draft_.refuse_tool();
  flush();
  if (auto switched = routine(step.down); !switched) return switched;
  tool_down_ = step.down;
  if (!step.down && std::exchange(drew_, false)) end_piece();
  return {};
}

Result<> ActWriter::routine(bool down) {
  if (auto begun = draft_.begin_routine(routine_name(down)); !begun) return begun;
  const seq::StepList& steps = down ? draft_.sequence.pen_down : draft_.sequence.pen_up;
  for (std::size_t i = 0; i < steps.size(); ++i)
    if (auto written = write(steps[i], i); !written) return written;
  flush();
  draft_.end_routine();
  return {};
}

/// Begins with the tool up, from the present places of the axes.
Result<> ActWriter::begin_here() {
  tool_down_ = false;
  if (auto up = routine(false); !up) return up;
  return draft_.at(0) ? go({}) : Result<>();
}

std::vector<AxisTarget> ActWriter::stands() const {
  std::vector<AxisTarget> all;
  for (int a = 0; a < draft_.axis_count(); ++a)
    if (const auto at = draft_.at(a)) all.push_back({draft_.axis(a), Steps(*at)});
  return all;
}

}  // namespace hw
