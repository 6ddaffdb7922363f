#include "core/devices/vme58/sequence_writer.h"

#include <cmath>
#include <span>

#include <fmt/format.h>

#include "core/device/sequence_draft.h"
#include "core/device/written_speeds.h"
#include "core/devices/vme58/catalog.h"
#include "core/devices/vme58/contour_recording.h"
#include "core/devices/vme58/facts.h"
#include "core/devices/vme58/sequence_commands.h"

namespace hw::vme58 {
namespace {

namespace seq = sequence;  // its names are also those of commands

constexpr int deepest_levels = 4;  // data sheet, LS

class Writer {
 public:
  Writer(const seq::Sequence& sequence, const Catalog& catalog) : draft_(sequence, catalog) {}

  Result<SequenceText> run(std::vector<RefusedStep>* refused) {
    draft_.collect_refused(refused, "# ");
    if (auto found = draft_.find_axes(); !found) return fail(found.error());
    draft_.line("AA");
    if (auto done = draft_.tool_line("# "); !done) return fail(done.error());
    if (auto written = write_steps(*this, draft_, draft_.sequence.steps); !written)
      return fail(written.error());
    return std::move(draft_).finish();
  }

  Result<> write(const seq::Speed& s) {
    draft_.set_speeds(s.speeds);
    std::vector<int> all(ix(draft_.axis_count()));
    for (std::size_t i = 0; i < all.size(); ++i) all[i] = static_cast<int>(i);
    return write_speeds(all, {});
  }
  Result<> write(const seq::Move& m);
  /// A single arc: a contour of one piece.
  Result<> write(const seq::Arc& a) {
    const auto [right, up] = a.plane;
    if (!draft_.has(a.plane)) return draft_.refuse_single_axis("an arc");
    const auto x = draft_.at(right), y = draft_.at(up);
    if (!x || !y) return draft_.refuse_unknown_start();
    seq::Contour one;
    one.plane = a.plane;
    one.x = static_cast<double>(*x) / draft_.sequence.axes[ix(right)].per_unit;
    one.y = static_cast<double>(*y) / draft_.sequence.axes[ix(up)].per_unit;
    one.ends_ramped = false;
    one.own = a.own;
    one.steps = {{a}};
    return write(one);
  }
  Result<> write(const seq::Jog& j) {
    const auto speeds = draft_.speeds_of(j.axis, j.own);
    if (!speeds) return fail(speeds.error());
    if (speeds->high == 0) return draft_.refuse("put a speed step before the jog: it needs a speed.");
    draft_.line(list("JG", j.axis, speeds->high * factor(j.direction)));
    draft_.stands(j.axis, std::nullopt);
    return {};
  }
  Result<> write(const seq::Home& h) {
    if (auto done = write_speeds({{h.axis}}, h.own); !done) return done;
    draft_.line(list(h.direction == Sign::plus ? "HM" : "HR", h.axis, 0));
    draft_.stands(h.axis, std::nullopt);
    return {};
  }
  Result<> write(const seq::Stop&) {
    return draft_.refuse("a VME58 carries out a stop as soon as it reads it, not in sequence.");
  }
  Result<> write(const seq::WaitMotion&) { return draft_.line("WA"), Result<>(); }
  Result<> write(const seq::Delay& d) {
    if (!(d.ms <= static_cast<double>(wait_max_ms)))
      return draft_.refuse(fmt::format("a delay is at most {} ms.", wait_max_ms));
    draft_.line(fmt::format("WT{}", std::llround(d.ms)));
    return {};
  }
  Result<> write(const seq::WaitInput& w) {
    if (auto input = draft_.input(w.input); !input) return fail(input.error());
    if (w.on) return draft_.refuse("a VME58 waits until an input is off (high), not until one is on (low).");
    draft_.line(fmt::format("SW{}", w.input));
    return {};
  }
  Result<> write(const seq::MoveOnInput&) {
    return draft_.refuse("a VME58 cannot skip a command because of an input.");
  }
  Result<> write(const seq::Output& o);
  Result<> write(const seq::Enable&) {
    return draft_.refuse("the motor power of a VME58 cannot be switched by a command.");
  }
  Result<> write(const seq::Pen& p) {
    const seq::StepList& steps = p.down ? draft_.sequence.pen_down : draft_.sequence.pen_up;
    if (auto begun = draft_.begin_routine(routine_name(p.down)); !begun) return begun;
    auto written = write_steps(*this, draft_, steps);
    draft_.end_routine();
    return written;
  }
  Result<> write(const seq::Comment& c) { return draft_.lines(c.text, "# "), Result<>(); }
  Result<> write(const seq::Repeat& l);
  Result<> write(const seq::Custom& c) {
    draft_.lines(c.text);
    const TextEffects does = effects_of(c.text);
    if (does.addresses) draft_.line("AA");
    if (does.moves) draft_.nothing_known();
    if (does.records) ++recorded_;
    if (does.speeds)
      for (WrittenSpeeds& of_axis : written_) of_axis.doubt();
    return {};
  }
  Result<> write(const seq::Contour& c);
  Result<> write(const seq::SpeedStairs& s);

 private:
  using Lists = std::array<std::optional<std::int64_t>, max_axes>;  // by place in the catalog

  /// "VL5000,,300;"
  static std::string list(std::string_view letters, const Lists& values) {
    std::string text(letters);
    std::size_t last = 0;
    for (std::size_t i = 0; i < values.size(); ++i)
      if (values[i]) last = i;
    for (std::size_t i = 0; i <= last; ++i)
      text += fmt::format("{}{}", i > 0 ? "," : "", values[i] ? std::to_string(*values[i]) : std::string());
    return text + ';';
  }
  [[nodiscard]] std::string list(std::string_view letters, int axis, std::int64_t value) const {
    Lists one;
    one[draft_.axis(axis).index] = value;
    return list(letters, one);
  }
  Result<> write_speeds(std::span<const int> axes, const seq::OwnSpeeds& own);
  Result<> switch_auxiliary(int axis, bool on);

  SequenceDraft draft_;
  std::array<WrittenSpeeds, max_axes> written_;
  int depth_ = 0, recorded_ = 0;
};

Result<> Writer::write_speeds(std::span<const int> axes, const seq::OwnSpeeds& own) {
  Lists high, low, rate;
  bool any_high = false, any_low = false, any_rate = false;
  for (const int a : axes) {
    const auto wanted = draft_.speeds_of(a, own);
    if (!wanted) return fail(wanted.error());
    if (wanted->ramp_ms != 0 && wanted->high == 0)
      return draft_.refuse("give a speed with the ramp time: a VME58 takes counts/s².");
    const auto needed = written_[ix(a)].towards(*wanted);
    if (!needed) return draft_.refuse_own_speed();
    const std::size_t place = draft_.axis(a).index;
    if (needed->high != 0) high[place] = needed->high, any_high = true;
    if (needed->low != 0) low[place] = needed->low, any_low = true;
    if (wanted->ramp_ms == 0 || (needed->high == 0 && needed->low == 0 && needed->ramp_ms == 0)) continue;
    const double per_s2 = static_cast<double>(wanted->high - wanted->low) / (wanted->ramp_ms / 1000);
    rate[place] = std::clamp<std::int64_t>(std::llround(per_s2), 1, acceleration_max);
    if (per_s2 > static_cast<double>(acceleration_max))
      draft_.remark(fmt::format("a ramp of {} ms is not possible: {} counts/s² is the steepest.",
                                wanted->ramp_ms, acceleration_max));
    any_rate = true;
  }
  if (any_high) draft_.line(list("VL", high));
  if (any_low) draft_.line(list("VB", low));
  if (any_rate) draft_.line(list("AC", rate));
  return {};
}

Result<> Writer::write(const seq::Move& m) {
  Lists to;
  std::vector<int> axes;
  for (int a = 0; a < draft_.axis_count(); ++a) {
    if (!m.to[ix(a)]) continue;
    const auto steps = m.relative ? draft_.distance(a, *m.to[ix(a)]) : draft_.position(a, *m.to[ix(a)]);
    if (!steps) return fail(steps.error());
    to[draft_.axis(a).index] = *steps;
    axes.push_back(a);
    const auto at = draft_.at(a);
    draft_.stands(a, !m.relative ? std::optional(*steps) : at ? std::optional(*at + *steps) : at);
  }
  if (axes.empty()) return draft_.refuse_no_axis();
  if (auto done = write_speeds(axes, m.own); !done) return done;
  const bool line = axes.size() > 1;
  draft_.line(list(m.relative ? (line ? "ML" : "MR") : line ? "MT" : "MA", to) + " GO");
  return {};
}

Result<> Writer::write(const seq::Output& o) {
  const auto& outputs = draft_.catalog.outputs;
  const auto put = [&](std::size_t place, bool on) -> Result<> {
    const int number = draft_.catalog.output_number(place);
    if (number >= first_auxiliary) return switch_auxiliary(number - first_auxiliary, on);
    draft_.line(fmt::format("{}{}", on ? "BL" : "BH", number));
    return {};
  };
  if (o.output >= 0) {
    const auto place = draft_.output(o.output);
    return place ? put(ix(*place), o.on) : Result<>(fail(place.error()));
  }
  std::size_t general = 0;
  while (general < outputs.size() && draft_.catalog.output_number(general) < first_auxiliary) ++general;
  if (o.value >> general != 0) return draft_.refuse_outputs(general, o.value, "general outputs");
  for (std::size_t i = 0; i < general; ++i)
    if (auto written = put(i, (o.value >> i & 1) != 0); !written) return written;
  return {};
}

// AN and AF go into the queue of one axis, which does not wait for that of AA. WA keeps the AA queue from
// running empty before its motion has ended, and WQ keeps the board from reading on until then.
Result<> Writer::switch_auxiliary(int axis, bool on) {
  if (depth_ > 0)
    return draft_.refuse(
        "auxiliary outputs are switched in the queue of their axis, which has no loop of all axes.");
  draft_.lines("WA\nWQ");
  draft_.line(fmt::format("A{} {} AA", axis_letters[ix(axis)], on ? "AN" : "AF"));
  return {};
}

Result<> Writer::write(const seq::Repeat& l) {
  if (l.times == 1) return write_steps(*this, draft_, l.steps);
  if (depth_ >= deepest_levels)
    return draft_.refuse(fmt::format("loops of a VME58 nest {} deep at most.", deepest_levels));
  draft_.forget_moved_axes(l.steps);
  if (sets_speeds(l.steps))
    for (WrittenSpeeds& of_axis : written_) of_axis.begin_repeated();
  draft_.line(l.times == 0 ? "WH" : fmt::format("LS{}", l.times));
  ++depth_;
  auto written = write_steps(*this, draft_, l.steps);
  --depth_;
  draft_.line(l.times == 0 ? "WG" : "LE");
  return written;
}

// The board has room for one recording. The next one must wait until the previous one has been played and its
// axes stand: WA keeps the queue from running empty until then, and WQ keeps the board from reading on.
Result<> Writer::write(const seq::Contour& c) {
  if (depth_ > 0)
    return draft_.refuse("a VME58 records a contour as soon as it reads it, so it cannot be inside a loop.");
  if (c.lead_in == 0 || !c.ends_ramped)
    draft_.remark(fmt::format("it {} at its full speed, without a ramp.", c.lead_in > 0 ? "ends"
                                                                          : c.ends_ramped
                                                                              ? "begins"
                                                                              : "begins and ends"));
  if (recorded_++ > 0) draft_.lines("WA\nWQ");
  const auto recording = record_contour(draft_, c);
  if (!recording) return fail(recording.error());
  if (auto there = write(recording->way_there); !there) return there;
  draft_.line("CX");
  const std::array<int, 2> axes{c.plane.right, c.plane.up};
  for (const std::size_t i : {0u, 1u})
    draft_.stands(axes[i], c.ends_ramped ? std::nullopt : std::optional(recording->end[i]));
  return {};
}

// MP and MM set the direction, MV runs at a speed up to a position, SP comes to rest (decision M84). They go
// into the queue of their axis: commands before and after them wait as for an auxiliary output.
Result<> Writer::write(const seq::SpeedStairs& s) {
  if (depth_ > 0)
    return draft_.refuse("a speed staircase is in the queue of its axis, which has no loop of all axes.");
  const auto stairs = draft_.stairs(s);
  if (!stairs) return fail(stairs.error());
  draft_.lines("WA\nWQ");
  draft_.line(fmt::format("A{} {}", axis_letters[draft_.axis(s.axis).index],
                          stairs->direction == Sign::plus ? "MP" : "MM"));
  for (const auto& [until, speed] : stairs->stairs) draft_.line(fmt::format("MV{},{};", until, speed));
  draft_.lines(fmt::format("SP{};\nWQ AA WA", stairs->stop_at));
  draft_.stands(s.axis, stairs->stop_at);
  return {};
}

}  // namespace

Result<SequenceText> write_sequence(const seq::Sequence& sequence, const Catalog& catalog,
                                    std::vector<RefusedStep>* refused) {
  return Writer(sequence, catalog).run(refused);
}

}  // namespace hw::vme58
