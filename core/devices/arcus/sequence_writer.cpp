#include "core/devices/arcus/sequence_writer.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "core/device/sequence_draft.h"
#include "core/device/written_speeds.h"
#include "core/devices/arcus/facts.h"
#include "core/devices/arcus/sequence_statements.h"

namespace hw::arcus {
namespace {

namespace seq = sequence;  // its names are also command names

constexpr int indent = 2;

/// Whether these steps may contain ABS or INC.
bool chooses_mode(const seq::StepList& steps) {
  return std::any_of(steps.begin(), steps.end(), [](const seq::Step& step) {
    const seq::StepList* inner = steps_in(step);
    return !step.skipped &&
           (std::holds_alternative<seq::Move>(step.body) || std::holds_alternative<seq::Arc>(step.body) ||
            std::holds_alternative<seq::MoveOnInput>(step.body) ||
            std::holds_alternative<seq::Custom>(step.body) || (inner && chooses_mode(*inner)));
  });
}

class Writer {
 public:
  Writer(const seq::Sequence& sequence, const Catalog& catalog, const language::Dialect& dialect)
      : draft_(sequence, catalog), dialect_(dialect) {}

  Result<SequenceText> run(std::vector<RefusedStep>* refused) {
    draft_.collect_refused(refused, "; ");
    if (auto found = draft_.find_axes(); !found) return fail(found.error());
    if (auto done = draft_.tool_line("; "); !done) return fail(done.error());
    if (auto written = write_steps(*this, draft_, draft_.sequence.steps); !written)
      return fail(written.error());
    draft_.line("END");
    for (const bool down : {false, true})
      if (auto written = write_routine(down); !written) return fail(written.error());
    return std::move(draft_).finish();
  }

  Result<> write(const seq::Speed& s) {
    draft_.set_speeds(s.speeds);
    if (!draft_.all_alike()) return {};  // written before each motion, in pulses of its axis
    return write_speeds(0, {});
  }
  Result<> write(const seq::Move& m) {
    int first = -1;
    std::string text;
    for (int a = 0; a < draft_.axis_count(); ++a) {
      if (!m.to[ix(a)]) continue;
      const auto to = m.relative ? draft_.distance(a, *m.to[ix(a)]) : draft_.position(a, *m.to[ix(a)]);
      if (!to) return fail(to.error());
      text += fmt::format("{}{}", draft_.name(a), *to);
      const auto at = draft_.at(a);
      draft_.stands(a, !m.relative ? std::optional(*to) : at ? std::optional(*at + *to) : at);
      if (first < 0) first = a;
    }
    if (first < 0) return draft_.refuse_no_axis();
    if (auto done = write_speeds(first, m.own); !done) return done;
    choose(m.relative ? Mode::inc : Mode::abs);
    draft_.line(text);
    return {};
  }
  Result<> write(const seq::Arc& a);
  Result<> write(const seq::Jog& j) {
    if (auto done = write_speeds(j.axis, j.own); !done) return done;
    draft_.line(fmt::format("JOG{}{}", draft_.name(j.axis), letter(j.direction)));
    draft_.stands(j.axis, std::nullopt);
    return {};
  }
  Result<> write(const seq::Home& h) {
    if (auto done = write_speeds(h.axis, h.own); !done) return done;
    draft_.line(fmt::format("HOME{}{}", draft_.name(h.axis), letter(h.direction)));
    draft_.stands(h.axis, std::nullopt);
    return {};
  }
  Result<> write(const seq::Stop& s) {
    const char* word = s.at_once ? "ABORT" : "STOP";
    if (s.axis < 0 && dialect_.axes.size() > 1)
      draft_.line(word);
    else
      draft_.line(fmt::format("{}{}", word, draft_.name(std::max(s.axis, 0))));
    draft_.nothing_known();
    return {};
  }
  Result<> write(const seq::WaitMotion& w) {
    for (int a = 0; a < draft_.axis_count(); ++a)
      if (w.axis < 0 || w.axis == a) draft_.line("WAIT" + draft_.name(a));
    return {};
  }
  Result<> write(const seq::Delay& d) {
    if (!(d.ms <= static_cast<double>(max_number)))
      return draft_.refuse(fmt::format("a delay is at most {} ms.", max_number));
    draft_.line(fmt::format("DELAY={}", std::max<std::int64_t>(std::llround(d.ms), 1)));
    return {};
  }
  Result<> write(const seq::WaitInput& w) {
    if (auto input = draft_.input(w.input); !input) return fail(input.error());
    draft_.line(fmt::format("WHILE DI{}={}", w.input, w.on ? 0 : 1));
    draft_.line("ENDWHILE");
    return {};
  }
  Result<> write(const seq::MoveOnInput& m);
  Result<> write(const seq::Output& o) {
    if (o.output < 0) {
      if (o.value >> draft_.catalog.outputs.size() != 0)
        return draft_.refuse_outputs(draft_.catalog.outputs.size(), o.value);
      draft_.line(fmt::format("DO={}", o.value));
      return {};
    }
    if (auto output = draft_.output(o.output); !output) return fail(output.error());
    draft_.line(fmt::format("DO{}={}", o.output, o.on ? 1 : 0));
    return {};
  }
  Result<> write(const seq::Enable& e) {
    const std::string number =
        dialect_.axes.size() > 1 ? std::to_string(draft_.axis(e.axis).index + 1) : std::string();
    draft_.line(fmt::format("EO{}={}", number, e.on ? 1 : 0));
    return {};
  }
  Result<> write(const seq::Pen& p) {
    const seq::StepList& steps = p.down ? draft_.sequence.pen_down : draft_.sequence.pen_up;
    if (steps.empty()) return {};
    if (draft_.in_routine()) return draft_.refuse_tool();
    draft_.line(fmt::format("GOSUB {}", p.down ? pen_down_sub : pen_up_sub));
    (p.down ? calls_down_ : calls_up_) = true;
    behind_foreign(steps);
    return {};
  }
  Result<> write(const seq::Comment& c) { return draft_.lines(c.text, "; "), Result<>(); }
  Result<> write(const seq::Repeat& l);
  Result<> write(const seq::Custom& c) {
    draft_.lines(c.text);
    const TextEffects does = effects_of(c.text, dialect_);
    if (does.moves) draft_.nothing_known();
    if (does.speeds) written_.doubt();
    if (does.mode) mode_ = Mode::unknown;
    return {};
  }
  Result<> write(const seq::Contour& c);
  Result<> write(const seq::SpeedStairs&) {
    return draft_.refuse(
        fmt::format("a {} cannot change its speed at a place on the way.", draft_.catalog.short_name));
  }

 private:
  enum class Mode : std::uint8_t { unknown, abs, inc };

  void choose(Mode mode) {
    if (std::exchange(mode_, mode) != mode) draft_.line(mode == Mode::abs ? "ABS" : "INC");
  }
  Result<> write_speeds(int axis, const seq::OwnSpeeds& own) {
    const auto wanted = draft_.speeds_of(axis, own);
    if (!wanted) return fail(wanted.error());
    const auto needed = written_.towards(*wanted);
    if (!needed) return draft_.refuse_own_speed();
    if (needed->high != 0) draft_.line(fmt::format("HSPD={}", needed->high));
    if (needed->low != 0) draft_.line(fmt::format("LSPD={}", needed->low));
    if (needed->ramp_ms != 0)
      draft_.line(fmt::format("ACC={}", std::max(std::llround(needed->ramp_ms), 1LL)));
    return {};
  }
  /// Call after steps that are written elsewhere or run more than once.
  void behind_foreign(const seq::StepList& steps) {
    draft_.forget_moved_axes(steps);
    if (sets_speeds(steps)) written_.begin_repeated();
    if (chooses_mode(steps)) mode_ = Mode::unknown;
  }
  Result<> write_routine(bool down) {
    if (!(down ? calls_down_ : calls_up_)) return {};
    if (auto begun = draft_.begin_routine(routine_name(down)); !begun) return begun;
    draft_.nothing_known();
    draft_.change_speeds({});
    written_ = {};
    mode_ = Mode::unknown;
    draft_.line(fmt::format("SUB {} ; {}", down ? pen_down_sub : pen_up_sub, routine_name(down)));
    const seq::StepList& steps = down ? draft_.sequence.pen_down : draft_.sequence.pen_up;
    auto written = write_steps(*this, draft_, steps);
    draft_.line("ENDSUB");
    draft_.end_routine();
    return written;
  }

  SequenceDraft draft_;
  const language::Dialect& dialect_;
  WrittenSpeeds written_;
  Mode mode_ = Mode::unknown;
  int depth_ = 0;
  bool calls_up_ = false, calls_down_ = false;
};

// 0 degrees lies on the minus side of X and angles grow clockwise (decision AMB-063); the end angle decides
// where the arc ends (AMB-066).
Result<> Writer::write(const seq::Arc& a) {
  if (!dialect_.arcs) return draft_.refuse(fmt::format("a {} draws no arcs.", draft_.catalog.short_name));
  const auto [right, up] = a.plane;
  if (!draft_.has(a.plane)) return draft_.refuse_single_axis("an arc");
  if (draft_.name(right) == "Y" && draft_.name(up) == "X")  // the same arc, seen from the other side
    return write(seq::Arc{a.y, a.x, -a.degrees, a.own, {up, right}});
  if (draft_.name(right) != "X" || draft_.name(up) != "Y")
    return draft_.refuse(fmt::format("a {} draws arcs only with X and Y, and this arc lies in {} and {}.",
                                     draft_.catalog.short_name, draft_.name(right), draft_.name(up)));
  if (!draft_.alike(a.plane))
    return draft_.refuse("X and Y differ in their pulses per unit: the arc would be an ellipse.");
  const auto x = draft_.at(right), y = draft_.at(up);
  if (!x || !y) return draft_.refuse_unknown_start();
  const auto cx = draft_.position(right, a.x), cy = draft_.position(up, a.y);
  if (!cx || !cy) return fail(!cx ? cx.error() : cy.error());
  const auto dx = static_cast<double>(*x - *cx), dy = static_cast<double>(*y - *cy);
  const double radius = std::hypot(dx, dy);
  if (radius == 0) return draft_.refuse("its centre is the point where it begins.");
  if (radius > static_cast<double>(max_radius))
    return draft_.refuse(
        fmt::format("its radius is {:.0f} pulses; {} is the largest. Fewer pulses per "
                    "unit make it smaller.",
                    radius, max_radius));
  if (!(std::fabs(a.degrees) > 0 && std::fabs(a.degrees) <= 360))
    return draft_.refuse("its angle must be more than 0 and at most 360 degrees.");
  if (auto done = write_speeds(right, a.own); !done) return done;
  choose(Mode::abs);
  const char way = a.degrees > 0 ? 'N' : 'P';
  if (std::fabs(a.degrees) == 360) {
    draft_.line(fmt::format("CIR{}{}:{}", way, *cx, *cy));
    return {};
  }
  const double end = std::atan2(dy, dx) + a.degrees / 180 * std::numbers::pi;
  const std::int64_t end_x = *cx + std::llround(radius * std::cos(end));
  const std::int64_t end_y = *cy + std::llround(radius * std::sin(end));
  const auto thousandths = [](double radians) {
    return std::llround(radians / std::numbers::pi * (full_turn / 2));
  };
  const std::int64_t angle = (thousandths(std::atan2(std::sin(end), -std::cos(end))) + full_turn) % full_turn;
  draft_.line(
      fmt::format("ARC{}{}:{}:{}:{}", way, *cx, *cy, angle, std::llround(std::fabs(a.degrees) * 1000)));
  // On a large arc a thousandth of a degree exceeds a pulse.
  const double angle_sent = static_cast<double>(angle) / (full_turn / 2) * std::numbers::pi;
  if (*cx + std::llround(-radius * std::cos(angle_sent)) != end_x ||
      *cy + std::llround(radius * std::sin(angle_sent)) != end_y)
    draft_.line(fmt::format("X{}Y{}", end_x, end_y));
  draft_.stands(right, end_x), draft_.stands(up, end_y);
  return {};
}

Result<> Writer::write(const seq::MoveOnInput& m) {
  if (auto input = draft_.input(m.input); !input) return fail(input.error());
  if (auto done = write_speeds(m.axis, m.own); !done) return done;
  const std::string& axis = draft_.name(m.axis);
  std::string motion;
  if (m.kind == seq::MoveOnInput::Kind::move) {
    const auto to = draft_.position(m.axis, m.to);
    if (!to) return fail(to.error());
    choose(Mode::abs);
    motion = fmt::format("{}{}", axis, *to);
  } else {
    motion = fmt::format("{}{}{}", m.kind == seq::MoveOnInput::Kind::jog ? "JOG" : "HOME", axis,
                         letter(m.direction));
  }
  draft_.line(fmt::format("IF DI{}={}", m.input, m.on ? 1 : 0));
  draft_.indent(indent);
  if (m.stops_first) draft_.lines(fmt::format("STOP{0}\nWAIT{0}", axis));
  draft_.line(motion);
  draft_.indent(-indent);
  draft_.line("ENDIF");
  draft_.stands(m.axis, std::nullopt);
  return {};
}

Result<> Writer::write(const seq::Repeat& l) {
  behind_foreign(l.steps);
  const int counter = first_counter - depth_;
  if (l.times == 0)
    draft_.line("WHILE 1=1");
  else
    draft_.lines(fmt::format("V{0}=0\nWHILE V{0}<{1}", counter, l.times));
  draft_.indent(indent);
  ++depth_;
  auto written = write_steps(*this, draft_, l.steps);
  --depth_;
  if (l.times != 0) draft_.line(fmt::format("V{0}=V{0}+1", counter));
  draft_.indent(-indent);
  draft_.line("ENDWHILE");
  return written;
}

// A motion waits for the one before it (decision AMB-113); an output does not.
Result<> Writer::write(const seq::Contour& c) {
  if (!draft_.has(c.plane)) return draft_.refuse_single_axis("a contour");
  seq::Move begin;
  begin.to[ix(c.plane.right)] = c.x, begin.to[ix(c.plane.up)] = c.y, begin.own = c.own;
  if (auto written = write(begin); !written) return written;
  if (c.steps.size() > 1) draft_.remark("it stops at each corner.");
  for (const seq::Step& step : c.steps) {
    if (step.skipped) continue;
    Result<> written = draft_.refuse_in_contour();
    if (const auto* move = std::get_if<seq::Move>(&step.body)) {
      seq::Move own = *move;
      own.own = c.own;
      written = write(own);
    } else if (const auto* arc = std::get_if<seq::Arc>(&step.body)) {
      seq::Arc own = *arc;
      own.own = c.own;
      written = write(own);
    } else if (const auto* output = std::get_if<seq::Output>(&step.body)) {
      draft_.line("WAIT" + draft_.name(c.plane.right));
      written = write(*output);
    }
    if (!written) return written;
  }
  return {};
}

}  // namespace

Result<SequenceText> write_sequence(const seq::Sequence& sequence, const Catalog& catalog,
                                    const language::Dialect& dialect, std::vector<RefusedStep>* refused) {
  return Writer(sequence, catalog, dialect).run(refused);
}

}  // namespace hw::arcus
