#include "core/device/pieces.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

#include <fmt/format.h>

#include "core/base/index.h"
#include "core/device/act_writer.h"
#include "core/device/language.h"
#include "core/device/sequence_travel.h"
#include "core/device/snapshot.h"
#include "core/device/written_speeds.h"
#include "core/sequence/arc_shape.h"
#include "core/sequence/places_before.h"
#include "core/sequence/steps_in.h"

namespace hw {
namespace {

namespace seq = sequence;  // its names are those of commands too

/// The state that the steps so far leave.
struct Standing {
  seq::Speeds speeds;
  bool tool_down = false;
  seq::Places at;  ///< of absolute places

  void behind(const seq::Step& step) {
    if (step.skipped) return;
    if (const auto* s = std::get_if<seq::Speed>(&step.body)) {
      if (s->speeds.high != 0) speeds.high = s->speeds.high;
      if (s->speeds.low != 0) speeds.low = s->speeds.low;
      if (s->speeds.ramp_ms != 0) speeds.ramp_ms = s->speeds.ramp_ms;
    } else if (const auto* pen = std::get_if<seq::Pen>(&step.body)) {
      tool_down = pen->down;
    } else if (const auto* move = std::get_if<seq::Move>(&step.body)) {
      for (std::size_t a = 0; a < at.size(); ++a) {
        if (!move->to[a]) continue;
        at[a] = move->relative ? std::nullopt : move->to[a];  // each distance is rounded separately
      }
    } else if (const auto* arc = std::get_if<seq::Arc>(&step.body)) {
      behind_arc(*arc);
    } else if (const auto* stairs = std::get_if<seq::SpeedStairs>(&step.body)) {
      at[ix(stairs->axis)] = stairs->stop_at;
    } else if (moves_elsewhere(step)) {
      at = {};
    }
  }
  [[nodiscard]] bool knows_place() const {
    return std::any_of(at.begin(), at.end(), [](const auto& place) { return place.has_value(); });
  }

 private:
  void behind_arc(const seq::Arc& arc) {
    auto &x = at[ix(arc.plane.right)], &y = at[ix(arc.plane.up)];
    if (x && y)
      std::tie(x, y) = seq::end_of(arc, *x, *y);
    else
      x = y = std::nullopt;
  }
  static bool moves_elsewhere(const seq::Step& step) {
    const auto is = [&step](auto kind) { return std::holds_alternative<decltype(kind)>(step.body); };
    return is(seq::Jog{}) || is(seq::Home{}) || is(seq::Stop{}) || is(seq::MoveOnInput{}) ||
           is(seq::Repeat{}) || is(seq::Custom{}) || is(seq::Contour{});
  }
};

/// Scales the speeds of the steps, as far as the controller's bounds allow.
class Faster {
 public:
  Faster(const seq::Sequence& sequence, const Catalog& catalog, int percent) : share_(percent / 100.0) {
    for (const seq::Axis& axis : sequence.axes) {
      most_ = std::min(most_, catalog.jog_speed_max.value / axis.per_unit);
      least_ = std::max(least_, 1 / axis.per_unit);
    }
  }
  void steps(seq::StepList& list) const {
    for (seq::Step& step : list) {
      std::visit([this](auto& body) { change(body); }, step.body);
      if (seq::StepList* inner = seq::steps_in(step)) steps(*inner);
    }
  }

 private:
  template <class Body>
  void change(Body& body) const {
    if constexpr (std::is_same_v<Body, seq::Speed>) change(body.speeds);
    if constexpr (std::is_same_v<Body, seq::SpeedStairs>)
      for (seq::SpeedStairs::Stair& stair : body.stairs) stair.speed = share_of(stair.speed);
    if constexpr (requires { body.own; }) {
      if (!body.own) return;
      const double before = body.own->high;
      change(*body.own);
      if constexpr (requires { body.lead_in; })  // the ramp takes as long as before
        if (before != 0) body.lead_in *= body.own->high / before;
    }
  }
  /// A speed beyond the bounds stays there: the writer decides whether it is possible.
  [[nodiscard]] double share_of(double speed) const {
    return std::clamp(speed * share_, std::min(least_, speed), std::max(most_, speed));
  }
  void change(seq::Speeds& speeds) const {
    if (speeds.high == 0) return;
    speeds.high = share_of(speeds.high);
    speeds.low = std::min(speeds.low, speeds.high);
  }

  double share_, least_ = 0, most_ = std::numeric_limits<double>::infinity();
};

/// text_at() may be called while the pieces run: it changes nothing here.
class Cutter {
 public:
  Cutter(const Language& language, const seq::Sequence& sequence, const Catalog& catalog)
      : language_(language), sequence_(sequence), catalog_(catalog) {
    before_.reserve(sequence.steps.size() + 1);
    before_.emplace_back();
    for (const seq::Step& step : sequence.steps) {
      before_.push_back(before_.back());
      before_.back().behind(step);
    }
    frame_ = seq::frame_of(sequence);
  }

  Result<Pieces> run(std::size_t from) {
    // Writes the whole sequence, so that a fault names the step that the user sees.
    if (auto whole = language_.write(sequence_, catalog_); !whole) return fail(whole.error());
    for (std::size_t begin = last_tool_up(sequence_.steps, from); begin < size();) {
      const auto end = end_of_piece(begin);
      if (!end) return fail(end.error());
      auto text = language_.write(piece(begin, *end), catalog_);
      if (!text) return fail(text.error());
      add(begin, *end, std::move(*text));
      begin = *end;
    }
    find_reaches();
    return std::move(pieces_);
  }
  [[nodiscard]] Result<std::string> text_at(const Piece& made, int percent) const {
    seq::Sequence p = piece(ix(made.first_step), ix(made.end_step));
    Faster(p, catalog_, percent).steps(p.steps);
    auto text = language_.write(p, catalog_);
    if (!text) return fail(text.error());
    if (fits(text->text)) return std::move(text->text);
    return fail(
        FaultKind::refused,
        fmt::format("At {} percent of its speeds the next piece does not fit into the controller.", percent),
        "Nothing was sent.");
  }

 private:
  [[nodiscard]] std::size_t size() const { return sequence_.steps.size(); }

  [[nodiscard]] seq::Sequence piece(std::size_t begin, std::size_t end) const {
    seq::Sequence p = frame_;
    const Standing& standing = before_[begin];
    if (begin > 0) {
      p.steps.push_back({seq::Pen{false}});
      if (standing.speeds != seq::Speeds()) p.steps.push_back({seq::Speed{standing.speeds}});
      if (standing.knows_place()) p.steps.push_back({seq::Move{standing.at, false, {}}});
      if (standing.knows_place()) p.steps.push_back({seq::WaitMotion{}});
      if (standing.tool_down) p.steps.push_back({seq::Pen{true}});
    }
    p.steps.insert(p.steps.end(), sequence_.steps.begin() + static_cast<std::ptrdiff_t>(begin),
                   sequence_.steps.begin() + static_cast<std::ptrdiff_t>(end));
    if (end < size() && before_[end].tool_down) {
      p.steps.push_back({seq::WaitMotion{}});
      p.steps.push_back({seq::Pen{false}});
    }
    return p;
  }

  [[nodiscard]] bool fits(std::size_t begin, std::size_t end) const {
    const auto text = language_.write(piece(begin, end), catalog_);
    return text && fits(text->text);
  }
  [[nodiscard]] bool fits(const std::string& text) const {
    const ProgramReport report = language_.analyse(text, 0);
    const int capacity = catalog_.program.capacity;
    return !report.has_errors() &&
           (capacity == 0 || std::all_of(report.cost.begin(), report.cost.end(),
                                         [&](const auto& c) { return c.second <= capacity; }));
  }

  static bool draws_by_itself(const seq::Step& step) {
    const auto* contour = std::get_if<seq::Contour>(&step.body);
    return contour && !step.skipped &&
           std::any_of(contour->steps.begin(), contour->steps.end(), [](const seq::Step& each) {
             const auto* output = std::get_if<seq::Output>(&each.body);
             return output && output->on;
           });
  }
  /// The end of the first chain: text fed continuously can be held only there. None: no chain ends by `last`.
  [[nodiscard]] std::optional<std::size_t> end_of_chain(std::size_t begin, std::size_t last) const {
    for (std::size_t end = begin + 1; end <= last; ++end)
      if (!before_[end].tool_down &&
          (before_[end - 1].tool_down || draws_by_itself(sequence_.steps[end - 1])))
        return end;
    return std::nullopt;
  }

  /// As many steps as fit, back to the last with the tool up, if there is one.
  Result<std::size_t> end_of_piece(std::size_t begin) {
    const bool is_fed = catalog_.program.capacity == 0;
    const std::size_t last = is_fed ? std::min(size(), begin + longest_fed) : size();
    if (is_fed)
      if (const auto end = end_of_chain(begin, last); end && fits(begin, *end)) return *end;
    std::size_t good = begin, ahead = std::max<std::size_t>(latest_size_, 1);
    while (good + ahead < last && fits(begin, good + ahead)) good += ahead, ahead *= 2;
    if (good + ahead >= last && fits(begin, last)) good = last;
    for (ahead = std::min(ahead, last - good); ahead > 1;) {
      ahead = (ahead + 1) / 2;
      if (good + ahead < last && fits(begin, good + ahead)) good += ahead;
    }
    if (good == size()) return good;
    if (good == begin)
      return fail(FaultKind::text,
                  fmt::format("Step {} alone needs more than the {} {} of a {}.", begin + 1,
                              catalog_.program.capacity, catalog_.program.capacity_unit, catalog_.short_name),
                  "Nothing was written.");
    latest_size_ = good - begin;
    for (std::size_t end = good; end > begin; --end)
      if (!before_[end].tool_down) return end;
    ++pieces_.lifts;
    return good;
  }

  void add(std::size_t begin, std::size_t end, SequenceText text) {
    Piece made;
    made.first_step = static_cast<int>(begin), made.end_step = static_cast<int>(end);
    made.step_of_command = steps_of_commands(text, begin, end);
    made.does = {{intent::LoadProgram(0, std::move(text.text))}, {intent::RunProgram(0)}};
    put(made.ends_at, before_[end].at);
    pieces_.all.push_back(std::move(made));
  }
  /// Adds the known places.
  void put(std::vector<AxisTarget>& into, const seq::Places& places) const {
    for (std::size_t a = 0; a < sequence_.axes.size(); ++a)
      if (const int axis = catalog_.find_axis(sequence_.axes[a].name); places[a] && axis >= 0)
        into.push_back({AxisId{static_cast<std::uint8_t>(axis)},
                        Steps(std::llround(*places[a] * sequence_.axes[a].per_unit))});
  }
  void put_endless(std::vector<AxisTarget>& into, const std::array<bool, max_axes>& goes, Steps end) const {
    for (std::size_t a = 0; a < sequence_.axes.size(); ++a)
      if (const int axis = catalog_.find_axis(sequence_.axes[a].name); goes[a] && axis >= 0)
        into.push_back({AxisId{static_cast<std::uint8_t>(axis)}, end});
  }
  void find_reaches() {
    std::vector<std::size_t> bounds;
    for (const Piece& piece : pieces_.all) bounds.push_back(ix(piece.first_step));
    bounds.push_back(size());
    const std::vector<seq::Reach> reaches = seq::reaches_between(sequence_, bounds);
    for (std::size_t i = 0; i < reaches.size(); ++i) {
      put(pieces_.all[i].reaches, reaches[i].least);
      put(pieces_.all[i].reaches, reaches[i].greatest);
      put_endless(pieces_.all[i].reaches, reaches[i].endless_minus, Steps(0) - without_end);
      put_endless(pieces_.all[i].reaches, reaches[i].endless_plus, without_end);
    }
  }

  /// Converts the count of steps in the text to indexes in the whole list.
  [[nodiscard]] std::vector<int> steps_of_commands(const SequenceText& text, std::size_t begin,
                                                   std::size_t end) const {
    const seq::Sequence p = piece(begin, end);
    std::vector<int> place_of;  // by how SequenceText counts
    const std::size_t ahead = lead_in(begin);
    for (std::size_t i = 0; i < p.steps.size(); ++i) {
      const bool own = i >= ahead && i < ahead + (end - begin);
      const seq::StepList* inner = seq::steps_in(p.steps[i]);
      place_of.insert(place_of.end(), 1 + (inner ? seq::count_steps(*inner) : 0),
                      own ? static_cast<int>(begin + i - ahead) : -1);
    }
    const ProgramReport report = language_.analyse(text.text, 0);
    std::vector<int> steps;
    for (std::size_t n = 0; n < std::min(report.lines.size(), text.step_of_line.size()); ++n) {
      const LineReport& line = report.lines[n];
      const int step = text.step_of_line[n];
      if (line.slot > 0 || line.first_command < 0 || line.command_count == 0) continue;
      steps.resize(std::max(steps.size(), ix(line.first_command + line.command_count)), -1);
      if (step >= 0 && ix(step) < place_of.size())
        std::fill_n(steps.begin() + line.first_command, line.command_count, place_of[ix(step)]);
    }
    return steps;
  }
  /// Number of steps of piece() before those of the sequence.
  [[nodiscard]] std::size_t lead_in(std::size_t begin) const {
    if (begin == 0) return 0;
    const Standing& standing = before_[begin];
    return 1u + (standing.speeds != seq::Speeds()) + (standing.knows_place() ? 2u : 0u) + standing.tool_down;
  }

  static constexpr std::size_t longest_fed = 250;  ///< steps: a stop loses at most these
  const Language& language_;
  const seq::Sequence sequence_;
  const Catalog catalog_;
  std::vector<Standing> before_;  ///< before each step, and after the last
  seq::Sequence frame_;           ///< without steps
  std::size_t latest_size_ = 0;
  Pieces pieces_;
};

}  // namespace

std::uint32_t loops_in_the_way(const Pieces& pieces, const Snapshot& now) {
  std::uint32_t closed = 0;
  for (const OpenLoop& loop : pieces.open_loops)
    if (now.axes[loop.axis.index].in_counts) closed |= 1u << loop.axis.index;
  return closed;
}

std::string why_not_begun(const Pieces& pieces, const Catalog& catalog, const Snapshot& now) {
  const std::uint32_t closed = loops_in_the_way(pieces, now);
  if (closed == 0) return {};
  std::string which;
  int count = 0;
  for (const OpenLoop& loop : pieces.open_loops) {
    if ((closed >> loop.axis.index & 1u) == 0) continue;
    const int param = catalog.find_param(loop.parameter);
    if (count++ > 0) which += ", ";
    which += param >= 0 ? catalog.params[ix(param)].label : loop.parameter;
  }
  return fmt::format("{} {} on, so the controller's buffer accepts no moves.", which,
                     count == 1 ? "is" : "are");
}

Result<> has_step(const seq::Sequence& sequence, int step) {
  if (sequence.steps.empty())
    return fail(FaultKind::text, "The sequence has no steps.", "Nothing was written.");
  if (step >= 0 && ix(step) < sequence.steps.size()) return {};
  return fail(FaultKind::text,
              fmt::format("There is no step {}: the sequence has {}.", step + 1, sequence.steps.size()),
              "Nothing was written.");
}

Result<Pieces> cut_by_text(const Language& language, const seq::Sequence& sequence, const Catalog& catalog,
                           int from_step) {
  if (auto has = has_step(sequence, from_step); !has) return fail(has.error());
  const auto cutter = std::make_shared<Cutter>(language, sequence, catalog);
  auto pieces = cutter->run(ix(from_step));
  if (pieces && sets_speeds(sequence.steps))
    pieces->text_at = [cutter](const Piece& piece, int percent) { return cutter->text_at(piece, percent); };
  return pieces;
}

Result<Pieces> Language::in_pieces(const seq::Sequence& sequence, const Catalog& catalog,
                                   int from_step) const {
  return cut_by_text(*this, sequence, catalog, from_step);
}

}  // namespace hw
