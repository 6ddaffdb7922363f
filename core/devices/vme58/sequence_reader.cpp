#include "core/devices/vme58/sequence_reader.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "core/base/index.h"
#include "core/device/text_remarks.h"
#include "core/devices/vme58/catalog.h"
#include "core/devices/vme58/contour_reading.h"
#include "core/devices/vme58/one_axis_text.h"
#include "core/devices/vme58/program_check.h"
#include "core/devices/vme58/sequence_commands.h"
#include "core/devices/vme58/sequence_writer.h"
#include "core/sequence/sequence_file.h"
#include "core/sequence/speed_stairs.h"

namespace hw::vme58 {
namespace {

namespace seq = sequence;  // its names are also those of commands

class BlockReader {
 public:
  BlockReader(std::string_view source, const seq::Sequence& frame, const Catalog& catalog)
      : plain_(without_comments(source)), catalog_(catalog), remarks_(source), out_(frame, catalog) {
    Context context;
    commands_ = read_commands(plain_, context);
    find_ends();
    find_remarks(source);
  }

  ReadText run() {
    read(0, commands_.size(), out_.steps);
    remarks_.finish(out_);
    return std::move(out_);
  }

 private:
  void find_ends() {
    std::vector<std::size_t> open;
    end_of_.resize(commands_.size());
    for (std::size_t i = 0; i < commands_.size(); ++i) {
      end_of_[i] = i;
      if (is(i, Op::LS) || is(i, Op::WH) || is(i, Op::WS)) open.push_back(i);
      if ((is(i, Op::LE) || is(i, Op::WG) || is(i, Op::WD)) && !open.empty())
        end_of_[open.back()] = i, open.pop_back();
    }
  }
  void find_remarks(std::string_view source) {
    for (std::size_t at = source.find('#'); at != source.npos; at = source.find('#', at)) {
      const std::size_t end = std::min(source.find('\n', at), source.size());
      const std::size_t line = source.find_last_of('\n', at) + 1;  // npos + 1 is 0
      remarks_.add({at, end}, source.substr(line, at - line).find_first_not_of(" \t") != source.npos);
      at = end;
    }
  }

  // ---- commands

  [[nodiscard]] bool is(std::size_t i, Op op) const { return i < commands_.size() && commands_[i].is(op); }
  [[nodiscard]] Stretch stretch(std::size_t from, std::size_t behind) const {
    const TextCommand& last = commands_[behind - 1];
    return {commands_[from].begin, last.begin + last.length};
  }
  void read(std::size_t from, std::size_t to, ReadSteps& list) {
    for (std::size_t i = from; i < to;) {
      remarks_.read_before(commands_[i].begin, list);
      i = read_one(i, to, list);
    }
  }
  /// Adds a step. Returns the index of the next command.
  std::size_t put(seq::Step::Body body, std::size_t from, std::size_t behind, ReadSteps& list) {
    list.push_back({std::move(body), stretch(from, behind)});
    remarks_.pass(list.back());
    return behind;
  }
  std::size_t leave(std::string_view why, std::size_t from, std::size_t behind, ReadSteps& list) {
    return put(seq::Custom{std::string(why), {}}, from, behind, list);
  }
  std::size_t read_one(std::size_t i, std::size_t to, ReadSteps& list) {
    const TextCommand& c = commands_[i];
    if (c.is(Op::AA)) return i + 1;
    if (c.context.mode != where::all || selects(c)) {
      std::size_t end = i + 1;
      while (end < to && !is(end, Op::AA)) ++end;
      return leave(why_not_single_, i, end, list);
    }
    switch (c.fact->op) {
      case Op::VL:
      case Op::VB:
      case Op::AC: return read_speeds(i, list);
      case Op::MA:
      case Op::MR:
      case Op::MT:
      case Op::ML: return read_move(i, list);
      case Op::JG:
      case Op::HM:
      case Op::HR: return read_axis(i, list);
      case Op::WA: return read_wait(i, list);
      case Op::WT: return put(seq::Delay{*c.numbers[0]}, i, i + 1, list);
      case Op::SW: return put(seq::WaitInput{static_cast<int>(*c.numbers[0]), false}, i, i + 1, list);
      case Op::BL:
      case Op::BH: return put(seq::Output{static_cast<int>(*c.numbers[0]), c.is(Op::BL), 0}, i, i + 1, list);
      case Op::LS:
      case Op::WH: return read_loop(i, list);
      case Op::WS: return leave("no loop of blocks tests an input", i, end_of_[i] + 1, list);
      case Op::CV:
      case Op::CD: return read_recording(i, i, list);
      default: return leave(why::no_block, i, i + 1, list);
    }
  }

  /// The numbers of a command by place of the axes; none: one belongs to an axis not among them.
  [[nodiscard]] std::optional<std::array<std::optional<double>, max_axes>> numbers_of(
      const TextCommand& c) const {
    std::array<std::optional<double>, max_axes> all{};
    for (std::size_t n = 0; n < c.numbers.size(); ++n) {
      if (!c.numbers[n]) continue;
      const int place = out_.place_of(catalog_, static_cast<int>(n));
      if (place < 0) return std::nullopt;
      all[ix(place)] = c.numbers[n];
    }
    return all;
  }
  [[nodiscard]] double units(std::size_t place, double counts) const {
    return counts / out_.axes[place].per_unit;
  }

  std::size_t read_move(std::size_t i, ReadSteps& list) {
    const TextCommand& c = commands_[i];
    if (!is(i + 1, Op::GO)) return leave("a move that does not start at once", i, i + 1, list);
    const bool line = c.is(Op::MT) || c.is(Op::ML);
    const auto numbers = numbers_of(c);
    if (!numbers || line != (c.given() > 1))
      return leave(numbers ? "axes that move independently" : why::no_such_axis, i, i + 2, list);
    seq::Move move;
    move.relative = c.is(Op::MR) || c.is(Op::ML);
    for (std::size_t a = 0; a < out_.axes.size(); ++a)
      if ((*numbers)[a]) move.to[a] = units(a, *(*numbers)[a]);
    return put(move, i, i + 2, list);
  }
  std::size_t read_axis(std::size_t i, ReadSteps& list) {
    const TextCommand& c = commands_[i];
    const auto numbers = numbers_of(c);
    if (!numbers || c.given() != 1) return leave("one block moves one axis", i, i + 1, list);
    int place = 0;
    while (!(*numbers)[ix(place)]) ++place;
    const double value = *(*numbers)[ix(place)];
    if (c.is(Op::JG)) {
      if (value == 0) return leave("no block stops by a jog", i, i + 1, list);
      return put(seq::Jog{place, value > 0 ? Sign::plus : Sign::minus,
                          seq::Speeds{units(ix(place), std::fabs(value))}},
                 i, i + 1, list);
    }
    if (value != 0) return leave("a block homes to 0", i, i + 1, list);
    return put(seq::Home{place, c.is(Op::HM) ? Sign::plus : Sign::minus, {}}, i, i + 1, list);
  }
  /// Reads a WA by itself, or one before commands that need an empty queue.
  std::size_t read_wait(std::size_t i, ReadSteps& list) {
    if (is(i + 1, Op::WQ) && is(i + 2, Op::CV)) return read_recording(i, i + 2, list);
    if (const std::size_t end = end_of_stairs(i)) return read_stairs(i, end, list);
    const bool switches = is(i + 1, Op::WQ) && i + 4 < commands_.size() && selects(commands_[i + 2]) &&
                          (is(i + 3, Op::AN) || is(i + 3, Op::AF)) && is(i + 4, Op::AA) &&
                          commands_[i + 3].context.mode == where::single;
    if (!switches) return put(seq::WaitMotion{}, i, i + 1, list);
    return put(seq::Output{first_auxiliary + commands_[i + 3].context.axis, is(i + 3, Op::AN), 0}, i, i + 5,
               list);
  }
  /// The index after "WA WQ AX MP MV... SP WQ AA WA"; 0: the commands are others.
  [[nodiscard]] std::size_t end_of_stairs(std::size_t i) const {
    std::size_t at = i + 1;
    const auto next = [&](Op op) { return is(at, op) && commands_[at].flaw.empty() && ++at; };
    if (!next(Op::WQ) || at >= commands_.size() || !selects(commands_[at++]) || is(at - 1, Op::AM)) return 0;
    const std::size_t head = at;
    if (!next(Op::MP) && !next(Op::MM)) return 0;
    while (next(Op::MV)) continue;
    const bool all = at > head + 1 && next(Op::SP) && next(Op::WQ) && next(Op::AA) && next(Op::WA);
    return all ? at : 0;
  }
  std::size_t read_stairs(std::size_t from, std::size_t end, ReadSteps& list) {
    constexpr std::size_t head = 3, tail = 4;  // before the first MV, from SP on
    const int place = out_.place_of(catalog_, commands_[from + head].context.axis);
    if (place < 0) return leave(why::no_such_axis, from, end, list);
    seq::SpeedStairs s;
    s.axis = place;
    for (std::size_t i = from + head + 1; i < end - tail; ++i)
      s.stairs.push_back(
          {units(ix(place), *commands_[i].numbers[0]), units(ix(place), *commands_[i].numbers[1])});
    s.stop_at = units(ix(place), *commands_[end - tail].numbers[0]);
    if (seq::direction_of(s) != (is(from + head, Op::MP) ? Sign::plus : Sign::minus))
      return leave("its staircase runs the other way", from, end, list);
    return put(std::move(s), from, end, list);
  }
  std::size_t read_recording(std::size_t from, std::size_t i, ReadSteps& list) {
    if (depth_ == 0)
      if (auto read = read_contour(std::span(commands_).subspan(i), out_, catalog_))
        return put(std::move(read->contour), from, i + read->length, list);
    std::size_t end = i + 1;
    if (is(i, Op::CV) && is(end, Op::CD)) ++end;
    while (end < commands_.size() && commands_[end].context.recording) ++end;
    return leave("a contour that is not recorded as blocks do it", from, end, list);
  }
  std::size_t read_loop(std::size_t i, ReadSteps& list) {
    const std::size_t end = end_of_[i];
    if (depth_ + 2 > seq::deepest_loop) return leave(why::too_deep, i, end + 1, list);
    seq::Repeat repeat;
    repeat.times = is(i, Op::LS) ? static_cast<int>(*commands_[i].numbers[0]) : 0;
    const Stretch head = stretch(i, i + 1), last = stretch(end, end + 1);
    ReadStep loop{std::move(repeat), {head.begin, last.end}, {}, {head.end, last.begin}};
    ++depth_;
    read(i + 1, end, loop.inner);
    --depth_;
    remarks_.read_before(last.begin, loop.inner);
    list.push_back(std::move(loop));
    return end + 1;
  }

  // ---- speeds

  /// Reads a speed step of all axes, in the writer's order.
  std::size_t read_speeds(std::size_t i, ReadSteps& list) {
    std::size_t behind = i;
    std::array<bool, 3> speeds_given{};
    bool alike = true;
    constexpr std::array<Op, 3> ops{Op::VL, Op::VB, Op::AC};
    for (std::size_t k = 0; k < ops.size(); ++k) {
      speeds_given[k] = is(behind, ops[k]);
      if (!speeds_given[k]) continue;
      const auto numbers = numbers_of(commands_[behind]);
      alike = alike && numbers && commands_[behind].given() == out_.axes.size();
      for (std::size_t a = 0; alike && a < out_.axes.size(); ++a)
        (k == 0 ? given_[a].high : k == 1 ? given_[a].low : given_[a].rate) = *(*numbers)[a];
      ++behind;
    }
    seq::Speed speed;
    if (alike && speed_of_all(speeds_given, speed.speeds)) return put(speed, i, behind, list);
    given_ = {}, ramp_ms_ = 0;
    while (is(behind, Op::VL) || is(behind, Op::VB) || is(behind, Op::AC)) ++behind;
    return leave(why::unlike_speeds, i, behind, list);
  }
  bool speed_of_all(const std::array<bool, 3>& speeds_given, seq::Speeds& speeds) {
    const double high = units(0, given_[0].high), low = units(0, given_[0].low);
    for (std::size_t a = 0; a < out_.axes.size(); ++a)
      if (std::round(high * out_.axes[a].per_unit) != given_[a].high ||
          std::round(low * out_.axes[a].per_unit) != given_[a].low)
        return false;
    if (speeds_given[0]) speeds.high = high;
    if (speeds_given[1]) speeds.low = low;
    if (!speeds_given[2]) return true;
    if (given_[0].high == 0 || given_[0].rate == 0) return false;
    const double exact = (given_[0].high - given_[0].low) / given_[0].rate * 1000;
    for (const double ramp : {ramp_ms_, std::round(exact), exact}) {
      if (ramp == 0 || !has_ramp(ramp)) continue;
      speeds.ramp_ms = ramp_ms_ = ramp;
      return true;
    }
    return false;
  }
  /// Whether a ramp of `ms` gives the rates as the writer computes them.
  [[nodiscard]] bool has_ramp(double ms) const {
    for (std::size_t a = 0; a < out_.axes.size(); ++a)
      if (std::round((given_[a].high - given_[a].low) / (ms / 1000)) != given_[a].rate) return false;
    return true;
  }

  struct Given {
    double high = 0, low = 0, rate = 0;  ///< in counts; 0: not set
  };
  static constexpr std::string_view why_not_single_ =
      "a single axis (AX, AY ...) has a queue of its own, beside the one of all axes (AA) that blocks use";
  const std::string plain_;  ///< TextCommand::text points into it
  const Catalog& catalog_;
  std::vector<TextCommand> commands_;
  std::vector<std::size_t> end_of_;  ///< end of the loop with this head
  TextRemarks remarks_;
  ReadText out_;
  std::array<Given, max_axes> given_{};
  double ramp_ms_ = 0;
  int depth_ = 0;
};

}  // namespace

Result<SequenceRead> read_sequence(std::string_view text, const seq::Sequence& frame,
                                   const Catalog& catalog) {
  for (const Problem& p : check_program(text).problems)
    if (p.error)
      return fail(FaultKind::text, fmt::format("Line {}: {}", p.line + 1, p.sentence), blocks_unchanged);
  ReadingLanguage language;
  language.write = [&](const seq::Sequence& made) { return write_sequence(made, catalog); };
  language.operations = operations_of;
  language.comment_mark = '#';
  const auto lists = in_lists(text);
  const std::string_view alike = lists ? *lists : text;
  return prove(BlockReader(alike, frame, catalog).run(), alike, language);
}

}  // namespace hw::vme58
