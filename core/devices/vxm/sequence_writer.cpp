#include "core/devices/vxm/sequence_writer.h"

#include <cmath>
#include <map>
#include <utility>

#include <fmt/format.h>

#include "core/device/sequence_draft.h"
#include "core/device/written_speeds.h"
#include "core/devices/vxm/facts.h"
#include "core/devices/vxm/sequence_commands.h"

namespace hw::vxm {
namespace {

namespace seq = sequence;  // its names are also those of commands

constexpr std::string_view limits_are_reported =
    "Set limit switches (O) to 1 or 3 to have a brief limit hit reported.";
constexpr double longest_delay_ms = 24.0 * 3600 * 1000;

class Writer {
 public:
  Writer(const seq::Sequence& sequence, const Catalog& catalog) : draft_(sequence, catalog) {}

  Result<SequenceText> run(std::vector<RefusedStep>* refused) {
    draft_.collect_refused(refused, "; ");
    if (auto found = draft_.find_axes(); !found) return fail(found.error());
    draft_.change_part(heading_part);
    if (auto done = draft_.tool_line("; ", limits_are_reported); !done) return fail(done.error());
    draft_.change_part(main_part);
    if (auto written = write_steps(*this, draft_, draft_.sequence.steps); !written)
      return fail(written.error());
    if (programs_ > 0) {
      draft_.change_part(heading_part);
      draft_.line("PM-0");
    }
    return std::move(draft_).finish();
  }

  Result<> write(const seq::Speed& s) {
    draft_.set_speeds(s.speeds);
    for (int a = 0; a < draft_.axis_count(); ++a)
      if (auto done = write_speeds(a, {}); !done) return done;
    return {};
  }
  Result<> write(const seq::Move& m) {
    remark_on_two_controllers();
    int moved = 0;
    for (int a = 0; a < draft_.axis_count(); ++a) {
      if (!m.to[ix(a)]) continue;
      if (auto written = move(a, *m.to[ix(a)], m.relative, m.own); !written) return written;
      ++moved;
    }
    if (moved == 0) return draft_.refuse_no_axis();
    if (moved > 1) draft_.remark("its motors move one after the other, not on a straight line.");
    return {};
  }
  Result<> write(const seq::Arc&) {
    return draft_.refuse("a VXM moves one motor at a time and draws no arcs.");
  }
  Result<> write(const seq::Jog&) {
    return draft_.refuse("a stored program of a VXM has no jog. A home step goes to the limit switch.");
  }
  /// Moves to the limit switch and sets zero there.
  Result<> write(const seq::Home& h) {
    if (auto done = write_speeds(h.axis, h.own); !done) return done;
    for (const std::string& command : homing(h.axis, h.direction)) draft_.line(command);
    return {};
  }
  Result<> write(const seq::Stop&) {
    return draft_.refuse("a VXM ends each motion before the next step, so there is nothing to stop.");
  }
  Result<> write(const seq::WaitMotion&) { return {}; }  // each motion ends before the next step
  Result<> write(const seq::Delay& d) {
    if (!(d.ms <= longest_delay_ms)) return draft_.refuse("a delay can be one day at most.");
    std::int64_t left = std::llround(d.ms * 10);  // in tenths of a millisecond
    for (; left > max_pause; left -= 1000 * std::min<std::int64_t>(left / 1000, max_pause))
      draft_.line(fmt::format("P{}", std::min<std::int64_t>(left / 1000, max_pause)));
    if (left > 0) draft_.line(left % 1000 == 0 ? fmt::format("P{}", left / 1000) : fmt::format("P-{}", left));
    return {};
  }
  Result<> write(const seq::WaitInput& w);
  Result<> write(const seq::MoveOnInput& m);
  Result<> write(const seq::Output& o) {
    if (o.output >= 0) {
      const auto place = draft_.output(o.output);
      if (!place) return fail(place.error());
      switch_output(*place, o.on);
      return {};
    }
    if (o.value >> output_on.size() != 0) return draft_.refuse_outputs(output_on.size(), o.value);
    for (std::size_t i = 0; i < output_on.size(); ++i)
      switch_output(static_cast<int>(i), (o.value >> i & 1) != 0);
    return {};
  }
  Result<> write(const seq::Enable&) {
    return draft_.refuse("the motor power of a VXM cannot be switched by a program.");
  }
  Result<> write(const seq::Pen& p);
  Result<> write(const seq::Comment& c) { return draft_.lines(c.text, "; "), Result<>(); }
  Result<> write(const seq::Repeat& l);
  Result<> write(const seq::Custom& c) {
    draft_.lines(c.text);
    if (may_set_speeds(c.text))
      for (WrittenSpeeds& before : written_) before.doubt();
    return {};
  }
  Result<> write(const seq::Contour& c);
  Result<> write(const seq::SpeedStairs&) {
    return draft_.refuse(
        "no block changes the speed of a VXM on the way. Put its continuous index (U7 to U9) into an Own "
        "text block.");
  }

 private:
  static constexpr int heading_part = 0, main_part = 1;  // programs 1 to 4 stand in the parts 2 to 5

  [[nodiscard]] int motor(int axis) const { return draft_.axis(axis).index + 1; }
  /// Added once, if the drawing axes are on two controllers.
  void remark_on_two_controllers() {
    if (std::exchange(looked_at_axes_, true) || draft_.axis_count() < 2) return;
    if ((motor(0) > motors_per_controller) == (motor(1) > motors_per_controller)) return;
    draft_.remark(
        "motors on Master and Slave could start together, but not on a straight line: they move one after "
        "the other.");
  }
  Result<> move(int axis, double units, bool relative, const seq::OwnSpeeds& own) {
    const auto to = relative ? draft_.distance(axis, units) : draft_.position(axis, units);
    if (!to) return fail(to.error());
    if (auto done = write_speeds(axis, own); !done) return done;
    if (relative && *to == 0) return {};  // I1M0 would go to the limit switch
    draft_.line(fmt::format("I{}{}M{}", relative ? "" : "A", motor(axis), *to));
    return {};
  }
  [[nodiscard]] std::vector<std::string> homing(int axis, Sign direction) const {
    return {fmt::format("I{}M{}0", motor(axis), direction == Sign::minus ? "-" : ""),
            fmt::format("IA{}M-0", motor(axis))};
  }
  Result<> call_homing(int axis, Sign direction);
  Result<> write_speeds(int axis, const seq::OwnSpeeds& own);
  void switch_output(int place, bool on) {
    draft_.line(fmt::format("U{}", (on ? output_on : output_off)[ix(place)]));
  }
  /// U11 to U22: skips the next command unless the input has the given state (low is on).
  Result<std::string> skip_unless(int input, bool on) {
    if (auto place = draft_.input(input); !place) return fail(place.error());
    if (input > 2) return draft_.refuse("programs of a VXM test only inputs 1 and 2.");
    return fmt::format("U{}{}", on ? 1 : 2, input);
  }
  /// Writes a program of its own and calls it. Returns its number.
  template <class Body>
  Result<int> call(std::string_view what, Body&& body);
  void repeated(const seq::StepList& steps) {
    if (!sets_speeds(steps)) return;
    for (WrittenSpeeds& before : written_) before.begin_repeated();
  }

  SequenceDraft draft_;
  std::array<WrittenSpeeds, max_axes> written_;
  int programs_ = 0;  ///< written beside the main one
  bool looked_at_axes_ = false;
  bool in_loop_ = false;                 ///< the current program has an open loop
  std::map<std::string, int> callable_;  ///< program numbers by purpose
};

Result<> Writer::write_speeds(int axis, const seq::OwnSpeeds& own) {
  const auto wanted = draft_.speeds_of(axis, own);
  if (!wanted) return fail(wanted.error());
  if (wanted->low != 0) return draft_.refuse("a VXM has no low speed: its ramps begin at rest.");
  if (wanted->ramp_ms != 0 && wanted->high == 0)
    return draft_.refuse("give a speed with the ramp time: a VXM takes steps/s².");
  const auto needed = written_[ix(axis)].towards(*wanted);
  if (!needed) return draft_.refuse_own_speed();
  if (needed->high != 0) draft_.line(fmt::format("S{}M{}", motor(axis), needed->high));
  if (wanted->ramp_ms == 0 || (needed->ramp_ms == 0 && needed->high == 0)) return {};
  const double rate = static_cast<double>(wanted->high) / (wanted->ramp_ms / 1000) / accel_unit;
  const auto a = std::clamp<std::int64_t>(std::llround(rate), min_accel, max_accel);
  if (rate < 0.5 || rate > max_accel + 0.5)
    draft_.remark(
        fmt::format("a ramp of {} ms is not possible: it takes {:.0f} ms.", wanted->ramp_ms,
                    static_cast<double>(wanted->high) / (static_cast<double>(a) * accel_unit) * 1000));
  draft_.line(fmt::format("A{}M{}", motor(axis), a));
  return {};
}

template <class Body>
Result<int> Writer::call(std::string_view what, Body&& body) {
  if (programs_ + 1 >= program_count)
    return draft_.refuse(fmt::format("all {} programs that a VXM can call are taken.", program_count - 1));
  const int number = ++programs_;
  draft_.line(fmt::format("JM{}", number));
  const int part = draft_.change_part(main_part + number);
  const bool in_loop = std::exchange(in_loop_, false);
  draft_.line(fmt::format("PM-{} ; {}", number, what));
  auto written = body();
  draft_.change_part(part);
  in_loop_ = in_loop;
  if (!written) return fail(written.error());
  return number;
}

Result<> Writer::write(const seq::WaitInput& w) {
  if (w.input == 1 && w.on) return draft_.line("U0"), Result<>();
  const auto skip = skip_unless(w.input, !w.on);
  if (!skip) return fail(skip.error());
  const auto known = callable_.find(*skip);
  if (known != callable_.end()) return draft_.line(fmt::format("JM{}", known->second)), Result<>();
  auto called = call(fmt::format("waits until input {} is {}", w.input, w.on ? "on" : "off"), [&] {
    draft_.line("P-10");
    draft_.line(*skip);
    draft_.line("L0");
    return Result<>();
  });
  if (!called) return fail(called.error());
  callable_[*skip] = *called;
  return {};
}

Result<> Writer::write(const seq::MoveOnInput& m) {
  const auto skip = skip_unless(m.input, m.on);
  if (!skip) return fail(skip.error());
  if (m.kind == seq::MoveOnInput::Kind::jog)
    return draft_.refuse("a stored program of a VXM has no jog. A home step goes to the limit switch.");
  if (auto done = write_speeds(m.axis, m.own); !done) return done;
  if (m.kind == seq::MoveOnInput::Kind::move) {
    draft_.line(*skip);
    return move(m.axis, m.to, false, m.own);
  }
  draft_.line(*skip);
  return call_homing(m.axis, m.direction);
}

/// One call, because a skip skips one command: an input may change between two questions.
Result<> Writer::call_homing(int axis, Sign direction) {
  const std::vector<std::string> commands = homing(axis, direction);
  const std::string& key = commands.front();
  if (const auto known = callable_.find(key); known != callable_.end())
    return draft_.line(fmt::format("JM{}", known->second)), Result<>();
  const auto called = call(fmt::format("motor {} to its limit switch", motor(axis)), [&] {
    for (const std::string& command : commands) draft_.line(command);
    return Result<>();
  });
  if (!called) return fail(called.error());
  callable_[key] = *called;
  return {};
}

Result<> Writer::write(const seq::Pen& p) {
  const seq::StepList& steps = p.down ? draft_.sequence.pen_down : draft_.sequence.pen_up;
  const std::string name(routine_name(p.down));
  const auto write_them = [&] {
    if (auto begun = draft_.begin_routine(name); !begun) return begun;
    auto written = write_steps(*this, draft_, steps);
    draft_.end_routine();
    return written;
  };
  if (steps.empty()) return {};
  if (steps.size() == 1) return write_them();
  if (const auto known = callable_.find(name); known != callable_.end()) {
    draft_.line(fmt::format("JM{}", known->second));
    repeated(steps);
    return {};
  }
  const auto speeds = draft_.change_speeds({});
  const auto before = std::exchange(written_, {});
  auto called = call(name, write_them);
  if (called) callable_[name] = *called;
  draft_.change_speeds(speeds);
  written_ = before;
  repeated(steps);
  if (!called) return fail(called.error());
  return {};
}

// A loop goes back to the nearest marker above it (decision V45), so a nested loop needs a program of its
// own.
Result<> Writer::write(const seq::Repeat& l) {
  if (l.times > max_loop) return draft_.refuse(fmt::format("a VXM loops {} times at most.", max_loop));
  if (l.times == 1) return write_steps(*this, draft_, l.steps);
  repeated(l.steps);
  const auto body = [&] {
    auto written = write_steps(*this, draft_, l.steps);
    if (written) draft_.line(l.times == 0 ? "L0" : fmt::format("LA{}", l.times));
    return written;
  };
  if (in_loop_ || draft_.part() != main_part) {
    const auto called = call("a loop", body);
    return called ? Result<>() : Result<>(fail(called.error()));
  }
  in_loop_ = true;
  draft_.line("LM0");
  auto written = body();
  in_loop_ = false;
  return written;
}

Result<> Writer::write(const seq::Contour& c) {
  seq::Move begin;
  if (!draft_.has(c.plane)) return draft_.refuse_single_axis("a contour");
  begin.to[ix(c.plane.right)] = c.x, begin.to[ix(c.plane.up)] = c.y, begin.own = c.own;
  if (auto written = write(begin); !written) return written;
  for (const seq::Step& step : c.steps) {
    if (step.skipped) continue;
    Result<> written = draft_.refuse("a contour can hold only moves and outputs: a VXM draws no arcs.");
    if (const auto* move = std::get_if<seq::Move>(&step.body)) {
      seq::Move own = *move;
      own.own = c.own;
      written = write(own);
    } else if (const auto* output = std::get_if<seq::Output>(&step.body)) {
      written = write(*output);
    }
    if (!written) return written;
  }
  return {};
}

}  // namespace

Result<SequenceText> write_sequence(const seq::Sequence& sequence, const Catalog& catalog,
                                    std::vector<RefusedStep>* refused) {
  return Writer(sequence, catalog).run(refused);
}

}  // namespace hw::vxm
