#include "core/devices/arcus/move_stream.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "core/device/sequence_draft.h"
#include "core/sequence/chords.h"

namespace hw::arcus {
namespace {

namespace seq = sequence;  // its names are those of commands too

constexpr int buffer_axes = 3;

/// Where the tool was up last.
std::size_t begin_of(const seq::StepList& steps, std::size_t from) {
  std::size_t up = 0;
  bool down = false;
  for (std::size_t i = 0; i < from; ++i) {
    if (const auto* pen = std::get_if<seq::Pen>(&steps[i].body); pen && !steps[i].skipped) down = pen->down;
    if (!down) up = i + 1;
  }
  return up;
}

class Streamer {
 public:
  Streamer(const seq::Sequence& sequence, const Catalog& catalog, std::size_t from)
      : draft_(sequence, catalog), from_(from) {}

  Result<std::optional<Pieces>> run() {
    if (auto found = draft_.find_axes(); !found) return fail(found.error());
    pieces_.tool = tool_off_of(draft_.sequence, static_cast<int>(draft_.catalog.outputs.size()));
    pieces_.remark =
        "It goes through the controller's buffer. Lines so short that the next could not be sent in time go "
        "slower.";
    ramps_are_automatic();
    const seq::StepList& steps = draft_.sequence.steps;
    for (std::size_t i = 0; i < steps.size() && !unfit_; ++i) {
      if (i == from_) begin_here();
      place_ = static_cast<int>(i);
      draft_.enter(steps[i], i);
      if (!steps[i].skipped) {
        auto written = std::visit([this](const auto& body) { return write(body); }, steps[i].body);
        if (!written) return fail(written.error());
      }
      draft_.leave();
    }
    if (unfit_) return std::optional<Pieces>();
    end_piece();
    if (pieces_.all.empty()) return std::optional<Pieces>();
    pieces_.all.back().does.push_back({intent::SendText("BF")});
    return std::optional(std::move(pieces_));
  }

 private:
  using Row = std::vector<std::int64_t>;
  static constexpr std::int64_t as_it_is = intent::FeedMoves::as_it_is;

  /// Of a chord, in pulses of the plane.
  [[nodiscard]] double tolerance() const {
    constexpr double half_a_pulse = 0.5;
    const seq::Sequence& s = draft_.sequence;
    return std::max(half_a_pulse, s.tolerance * s.axes[0].per_unit);
  }
  [[nodiscard]] bool emits() const { return ix(place_) >= from_; }
  Result<> unfit() { return unfit_ = true, Result<>(); }
  template <class Other>
  Result<> write(const Other&) {
    return unfit();
  }
  Result<> write(const seq::Comment&) { return {}; }
  Result<> write(const seq::WaitMotion&) { return {}; }  // each act waits, and the moves of one go on
  Result<> write(const seq::Speed& s) {
    draft_.say_speeds(s.speeds);
    auto steps = draft_.speeds(0, s.speeds);
    if (!steps) return fail(steps.error());
    if (steps->low != 0) set("LSPD", steps->low);
    if (steps->ramp_ms != 0) set("ACC", std::max<std::int64_t>(std::llround(steps->ramp_ms), 1));
    return {};
  }
  Result<> write(const seq::Move& m) {
    Row row(buffer_axes + 1, as_it_is);
    for (int a = 0; a < draft_.axis_count(); ++a) {
      if (!m.to[ix(a)]) continue;
      const int column = draft_.axis(a).index;
      if (column >= buffer_axes || (m.relative && !draft_.at(a))) return unfit();
      const auto to = m.relative ? draft_.distance(a, *m.to[ix(a)]) : draft_.position(a, *m.to[ix(a)]);
      if (!to) return fail(to.error());
      draft_.stands(a, m.relative ? *draft_.at(a) + *to : *to);
    }
    return add_row(std::move(row), m.own);
  }
  Result<> write(const seq::Arc& a) {
    const bool plane = draft_.axis_count() >= 2 && draft_.axis(0).index < buffer_axes &&
                       draft_.axis(1).index < buffer_axes &&
                       draft_.sequence.axes[0].per_unit == draft_.sequence.axes[1].per_unit;
    const auto x = draft_.at(0), y = draft_.at(1);
    if (!plane || !x || !y) return unfit();
    const auto cx = draft_.position(0, a.x), cy = draft_.position(1, a.y);
    if (!cx || !cy) return fail(!cx ? cx.error() : cy.error());
    const auto dx = static_cast<double>(*x - *cx), dy = static_cast<double>(*y - *cy);
    const seq::Chords chords(dx, dy, a.degrees, tolerance());
    for (int n = 1; n <= chords.count(); ++n) {
      const auto [to_x, to_y] = chords.end(n);
      draft_.stands(0, *cx + std::llround(to_x));
      draft_.stands(1, *cy + std::llround(to_y));
      if (auto added = add_row(Row(buffer_axes + 1, as_it_is), a.own); !added) return added;
    }
    return {};
  }
  Result<> write(const seq::Output& o) {
    if (o.output < 0) return unfit();
    if (auto known = draft_.output(o.output); !known) return fail(known.error());
    act(intent::SetOutput(o.output, o.on));
    return {};
  }
  Result<> write(const seq::Delay& d) {
    flush();
    if (!emits()) return {};
    if (piece_.does.empty()) return unfit();
    piece_.does.back().then += Duration(std::llround(d.ms * 1e6));
    return {};
  }
  Result<> write(const seq::Pen& p) {
    if (draft_.in_routine()) return draft_.refuse_tool();
    flush();
    if (auto switched = routine(p.down); !switched) return switched;
    tool_down_ = p.down;
    if (!p.down && piece_.draws >= 0) end_piece();
    return {};
  }

  Result<> routine(bool down) {
    if (auto begun = draft_.begin_routine(routine_name(down)); !begun) return begun;
    const seq::StepList& steps = down ? draft_.sequence.pen_down : draft_.sequence.pen_up;
    for (std::size_t i = 0; i < steps.size(); ++i) {
      draft_.enter(steps[i], i);
      Result<> written;
      if (!steps[i].skipped)
        written = std::visit([this](const auto& body) { return write(body); }, steps[i].body);
      if (!written) return written;
      draft_.leave();
    }
    flush();
    draft_.end_routine();
    return {};
  }

  /// To where the axes stand by now. One that nobody has moved stays.
  Result<> add_row(Row row, const seq::OwnSpeeds& own) {
    const auto speeds = draft_.speeds_of(0, own);
    if (!speeds) return fail(speeds.error());
    if (!emits()) return {};
    for (int a = 0; a < draft_.axis_count(); ++a)
      if (const auto at = draft_.at(a); at && draft_.axis(a).index < buffer_axes)
        row[ix(draft_.axis(a).index)] = *at;
    if (speeds->high != 0) row.back() = speeds->high;
    if (!rows_.empty() && std::equal(row.begin(), row.end() - 1, rows_.back().begin())) return {};
    rows_.push_back(std::move(row));
    steps_.push_back(place_);
    return {};
  }
  void flush() {
    if (rows_.empty()) return;
    if (tool_down_ && !draft_.in_routine()) {
      piece_.draws = static_cast<int>(piece_.does.size());
      piece_.step_of_row = steps_;
    }
    if (piece_.does.empty()) piece_.first_step = steps_.front();
    piece_.does.push_back({intent::FeedMoves(std::exchange(rows_, {}))});
    steps_.clear();
  }
  void act(IntentBody what) {
    flush();
    if (!emits()) return;
    if (piece_.does.empty()) piece_.first_step = place_;
    piece_.does.push_back({std::move(what)});
  }
  void set(const std::string& parameter, std::int64_t value) {
    if (draft_.catalog.find_param(parameter) < 0) return;
    flush();
    piece_.does.push_back({intent::SetParam(parameter, value, true)});  // also for what begins later
  }
  void ramps_are_automatic() { set("IACC", 1); }
  /// With the tool up, from where the axes stand by then.
  void begin_here() {
    if (from_ == 0) return;
    place_ = static_cast<int>(from_);
    tool_down_ = false;
    if (auto up = routine(false); !up) unfit_ = true;
    const bool known = draft_.at(0).has_value();
    if (known)
      if (auto there = add_row(Row(buffer_axes + 1, as_it_is), {}); !there) unfit_ = true;
  }
  void end_piece() {
    flush();
    if (piece_.does.empty()) return;
    for (int a = 0; a < draft_.axis_count(); ++a)
      if (const auto at = draft_.at(a)) piece_.ends_at.push_back({draft_.axis(a), Steps(*at)});
    pieces_.all.push_back(std::exchange(piece_, {}));
  }

  SequenceDraft draft_;
  const std::size_t from_;
  Pieces pieces_;
  Piece piece_;
  std::vector<Row> rows_;
  std::vector<int> steps_;  ///< of `rows_`
  int place_ = 0;           ///< of the step at hand, in the sequence's own list
  bool tool_down_ = false, unfit_ = false;
};

}  // namespace

Result<std::optional<Pieces>> stream_moves(const seq::Sequence& sequence, const Catalog& catalog,
                                           int from_step) {
  return Streamer(sequence, catalog, begin_of(sequence.steps, ix(from_step))).run();
}

}  // namespace hw::arcus
