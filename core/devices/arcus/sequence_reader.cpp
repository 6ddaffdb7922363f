#include "core/devices/arcus/sequence_reader.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "core/base/index.h"
#include "core/device/sequence_draft.h"
#include "core/device/text_remarks.h"
#include "core/devices/arcus/language/compiler.h"
#include "core/devices/arcus/language/listing.h"
#include "core/devices/arcus/sequence_statements.h"
#include "core/devices/arcus/sequence_writer.h"
#include "core/sequence/sequence_file.h"

namespace hw::arcus {
namespace {

namespace seq = sequence;  // its names are also command names
using language::Instruction;
using language::Opcode;
using language::Operand;
using language::Quantity;

class BlockReader {
 public:
  BlockReader(std::string_view source, const seq::Sequence& frame, const Catalog& catalog,
              const language::Dialect& dialect, const language::Compilation& compiled)
      : source_(source),
        catalog_(catalog),
        dialect_(dialect),
        text_(source, dialect),
        out_(frame, catalog),
        remarks_(source) {
    const bool alike = std::all_of(out_.axes.begin(), out_.axes.end(), [this](const seq::Axis& axis) {
      return axis.per_unit == out_.axes[0].per_unit;
    });
    if (!alike) {  // the speeds of the language apply to all axes
      out_.unit = catalog.step_word;
      for (seq::Axis& axis : out_.axes) axis.per_unit = 1;
      out_.remarks.push_back(fmt::format(
          "Speeds apply to all axes, and the units of these axes differ: speeds are in {}.", out_.unit));
    }
    add_remarks(text_, compiled, remarks_);
  }

  Result<ReadText> run() {
    if (auto called = find_routines(); !called) return fail(called.error());
    const std::size_t begin = !text_.statements.empty() && text_.at(0).op == Opcode::prg ? 1 : 0;
    std::size_t end = begin;
    while (end < text_.statements.size() && text_.at(end).op != Opcode::end) ++end;
    read(begin, end, out_.steps);
    for (const bool down : {false, true}) {
      mode_ = Mode::unclear, at_ = {};
      read(routines_[down].first, routines_[down].second, down ? out_.pen_down : out_.pen_up);
    }
    remarks_.finish(out_);
    return std::move(out_);
  }

 private:
  enum class Mode : std::uint8_t { as_it_is, abs, inc, unclear };

  /// Finds the tool's routines, which are named in a comment after their heads. Other subroutines become no
  /// blocks.
  Result<> find_routines() {
    for (std::size_t i = 0; i < text_.statements.size(); ++i) {
      if (text_.at(i).op == Opcode::prg && (i > 0 || text_.at(i).values[0].number != 0))
        return no_block_for(
            source_, text_.stretch(i).begin,
            i > 0 ? "a program beside the first. Blocks are one program." : "blocks are program 0.");
      if (text_.at(i).op != Opcode::sub) continue;
      const int number = text_.at(i).values[0].number;
      const Stretch at = text_.stretch(i);
      const std::string_view head = source_.substr(at.begin, at.end - at.begin);
      const bool known = (number == pen_up_sub || number == pen_down_sub) &&
                         head.ends_with(routine_name(number == pen_down_sub));
      if (!known)
        return no_block_for(source_, at.begin, "a subroutine. Blocks have none but those of the tool.");
      std::size_t end = i + 1;
      while (end < text_.statements.size() && text_.at(end).op != Opcode::endsub) ++end;
      routines_[number == pen_down_sub] = {i + 1, end};
    }
    return {};
  }

  [[nodiscard]] int place_of(int axis) const { return out_.place_of(catalog_, axis); }

  void read(std::size_t from, std::size_t to, ReadSteps& list) {
    for (std::size_t i = from; i < to;) {
      remarks_.read_before(text_.stretch(i).begin, list);
      i = read_one(i, list);
    }
    if (to < text_.statements.size()) remarks_.read_before(text_.stretch(to).begin, list);
  }
  /// Returns where the next step begins.
  std::size_t put(seq::Step::Body body, std::size_t from, std::size_t behind, ReadSteps& list) {
    list.push_back({std::move(body), {text_.stretch(from).begin, text_.stretch(behind - 1).end}});
    remarks_.pass(list.back());
    return behind;
  }
  std::size_t leave(std::string_view why, std::size_t from, std::size_t behind, ReadSteps& list) {
    for (std::size_t i = from; i < behind; ++i) {
      if (text_.at(i).op >= Opcode::move && text_.at(i).op <= Opcode::abort) at_ = {};
      if (goes_by_mode(text_.at(i).op) && mode_ == Mode::as_it_is) mode_ = Mode::unclear;
    }
    return put(seq::Custom{std::string(why), {}}, from, behind, list);
  }
  std::size_t read_one(std::size_t i, ReadSteps& list) {
    const Instruction& s = text_.at(i);
    switch (s.op) {
      case Opcode::absolute:
      case Opcode::incremental: mode_ = s.op == Opcode::absolute ? Mode::abs : Mode::inc; return i + 1;
      case Opcode::set: return text_.counted[i] ? read_loop(i, list) : read_set(i, list);
      case Opcode::compute: return leave("blocks have no variables", i, i + 1, list);
      case Opcode::delay: return put(seq::Delay{static_cast<double>(s.values[0].number)}, i, i + 1, list);
      case Opcode::wait: return read_wait(i, list);
      case Opcode::move: return read_move(i, list);
      case Opcode::home_switch:
      case Opcode::jog: {
        const int place = place_of(s.axes.first());
        if (place < 0) return leave(why::no_such_axis, i, i + 1, list);
        forget(place);
        if (s.op == Opcode::home_switch) return put(seq::Home{place, s.sign, {}}, i, i + 1, list);
        return put(seq::Jog{place, s.sign, {}}, i, i + 1, list);
      }
      case Opcode::stop:
      case Opcode::abort: {
        const int place = s.axes.count() == 1 ? place_of(s.axes.first()) : -1;
        if (s.axes.count() == 1 && place < 0) return leave(why::no_such_axis, i, i + 1, list);
        at_ = {};
        return put(seq::Stop{place, s.op == Opcode::abort}, i, i + 1, list);
      }
      case Opcode::if_: return read_condition(i, list);
      case Opcode::while_: return read_loop(i, list);
      case Opcode::gosub: {  // every call is to a routine of the tool
        const bool down = s.values[0].number == pen_down_sub;
        mode_ = mode_behind(routines_[down].first, routines_[down].second);
        at_ = {};
        return put(seq::Pen{down}, i, i + 1, list);
      }
      default: return goes_by_mode(s.op) ? read_arc(i, list) : leave(why::no_block, i, i + 1, list);
    }
  }

  std::size_t read_set(std::size_t i, ReadSteps& list) {
    const Instruction& s = text_.at(i);
    if (s.target.kind == Operand::Kind::variable || !is_number(s.values[0]))
      return leave("blocks have no variables", i, i + 1, list);
    const std::int32_t value = s.values[0].number;
    switch (s.target.quantity) {
      case Quantity::high_speed:
      case Quantity::low_speed:
      case Quantity::acceleration: return read_speed(i, list);
      case Quantity::output: return put(seq::Output{s.target.index, value != 0, 0}, i, i + 1, list);
      case Quantity::outputs:
        return put(seq::Output{-1, true, static_cast<std::uint32_t>(value)}, i, i + 1, list);
      case Quantity::enable:
        if (const int place = place_of(s.target.index - 1); place >= 0)
          return put(seq::Enable{place, value != 0}, i, i + 1, list);
        return leave(why::no_such_axis, i, i + 1, list);
      case Quantity::enables: return read_power_of_all(static_cast<std::uint32_t>(value), i, list);
      case Quantity::pulse_position:
      case Quantity::encoder_position: at_ = {}; [[fallthrough]];
      default: return leave("no block sets this", i, i + 1, list);
    }
  }
  /// A step for each axis, as operations_of() counts it.
  std::size_t read_power_of_all(std::uint32_t value, std::size_t i, ReadSteps& list) {
    const int count = static_cast<int>(dialect_.axes.size());
    for (int axis = 0; axis < count; ++axis)
      if (place_of(axis) < 0) return leave(why::no_such_axis, i, i + 1, list);
    for (int axis = 0; axis < count; ++axis)
      put(seq::Enable{place_of(axis), ((value >> axis) & 1) != 0}, i, i + 1, list);
    return i + 1;
  }
  /// HSPD, LSPD and ACC in this order are one step.
  std::size_t read_speed(std::size_t i, ReadSteps& list) {
    const Instruction& s = text_.at(i);
    const double value = s.values[0].number;
    if (value == 0) return leave("no block sets this to 0", i, i + 1, list);
    auto* before = list.empty() ? nullptr : std::get_if<seq::Speed>(&list.back().body);
    seq::Speed speed = before ? *before : seq::Speed();
    seq::Speeds& all = speed.speeds;
    const bool new_one = all.ramp_ms != 0 || (all.low != 0 && s.target.quantity != Quantity::acceleration) ||
                         (all.high != 0 && s.target.quantity == Quantity::high_speed);
    if (new_one) all = {};
    if (s.target.quantity == Quantity::high_speed) all.high = out_.units(0, s.values[0].number);
    if (s.target.quantity == Quantity::low_speed) all.low = out_.units(0, s.values[0].number);
    if (s.target.quantity == Quantity::acceleration) all.ramp_ms = value;
    if (!before || new_one) return put(speed, i, i + 1, list);
    list.back().body = speed;
    list.back().at.end = text_.stretch(i).end;
    remarks_.pass(list.back());
    return i + 1;
  }
  /// WAITs for all axes in their order are one step: wait until all stand still.
  std::size_t read_wait(std::size_t i, ReadSteps& list) {
    std::size_t behind = i;
    for (std::size_t a = 0; a < out_.axes.size() && behind < text_.statements.size(); ++a, ++behind)
      if (text_.at(behind).op != Opcode::wait ||
          place_of(text_.at(behind).axes.first()) != static_cast<int>(a))
        break;
    if (behind == i + out_.axes.size()) return put(seq::WaitMotion{}, i, behind, list);
    const int place = place_of(text_.at(i).axes.first());
    if (place < 0) return leave(why::no_such_axis, i, i + 1, list);
    return put(seq::WaitMotion{place}, i, i + 1, list);
  }

  // ---- motion

  void forget(int place) { at_[ix(place)] = std::nullopt; }
  /// False: unknown whether a move goes to a place or by a distance.
  bool choose_mode(std::size_t i) {
    if (mode_ == Mode::as_it_is) {
      out_.remarks.push_back(
          fmt::format("Line {} moves to a place or by a distance, depending on an earlier setting. Blocks "
                      "move to a place, and their text contains ABS.",
                      text_.statements[i].line + 1));
      out_.assumed["mode"] = "ABS";
      mode_ = Mode::abs;
    }
    return mode_ != Mode::unclear;
  }
  std::size_t read_move(std::size_t i, ReadSteps& list) {
    const Instruction& s = text_.at(i);
    seq::Move move;
    for (int axis = 0; axis < language::max_axes; ++axis) {
      if (!s.axes.has(axis)) continue;
      const int place = place_of(axis);
      if (place < 0) return leave(why::no_such_axis, i, i + 1, list);
      if (!is_number(s.values[ix(axis)])) return leave("blocks have no variables", i, i + 1, list);
      move.to[ix(place)] = out_.units(place, s.values[ix(axis)].number);
    }
    if (!choose_mode(i))
      return leave("to a place or by a distance, depending on an earlier setting", i, i + 1, list);
    move.relative = mode_ == Mode::inc;
    for (std::size_t a = 0; a < out_.axes.size(); ++a)
      if (move.to[a]) at_[a] = move.relative ? std::nullopt : move.to[a];
    return put(move, i, i + 1, list);
  }
  std::size_t read_arc(std::size_t i, ReadSteps& list) {
    const Instruction& s = text_.at(i);
    if (!choose_mode(i) || mode_ == Mode::inc) return leave("an arc by distances", i, i + 1, list);
    const bool circle = s.op == Opcode::circle_clockwise || s.op == Opcode::circle_counterclockwise;
    const bool back = s.op == Opcode::circle_clockwise || s.op == Opcode::arc_clockwise;
    const seq::Plane plane{place_of(0), place_of(1)};
    if (plane.right < 0 || plane.up < 0) return leave(why::no_such_axis, i, i + 1, list);
    seq::Arc arc{out_.units(plane.right, s.values[0].number),
                 out_.units(plane.up, s.values[1].number),
                 360,
                 {},
                 plane};
    if (!circle) arc.degrees = s.values[3].number / 1000.0;
    std::size_t behind = i + 1;
    if (!circle && correct(arc, i, back)) ++behind;
    if (back) arc.degrees = -arc.degrees;
    if (!circle && behind == i + 1) forget(plane.right), forget(plane.up);
    return put(arc, i, behind, list);
  }
  /// A large arc is followed by a short move to its exact end.
  bool correct(seq::Arc& arc, std::size_t i, bool back) {
    const auto [right, up] = arc.plane;
    auto &at_x = at_[ix(right)], &at_y = at_[ix(up)];
    if (i + 1 >= text_.statements.size() || !at_x || !at_y) return false;
    const Instruction& next = text_.at(i + 1);
    if (next.op != Opcode::move || next.axes != language::AxisSet{3} || !is_number(next.values[0]) ||
        !is_number(next.values[1]))
      return false;
    const double x = out_.units(right, next.values[0].number), y = out_.units(up, next.values[1].number);
    const double from = std::atan2(*at_y - arc.y, *at_x - arc.x), to = std::atan2(y - arc.y, x - arc.x);
    double degrees = (back ? from - to : to - from) / std::numbers::pi * 180;
    if (degrees <= 0) degrees += 360;
    if (std::fabs(degrees - arc.degrees) > 0.001) return false;
    // The fewest digits that give the same arc.
    arc.degrees = std::round(degrees * 1e6) / 1e6;
    at_x = x, at_y = y;
    return true;
  }

  // ---- blocks

  /// The move mode after statements of which any may have been executed.
  [[nodiscard]] Mode mode_behind(std::size_t from, std::size_t to) const {
    Mode mode = mode_;
    for (std::size_t i = from; i < to; ++i) {
      const Opcode op = text_.at(i).op;
      if ((op == Opcode::absolute && mode_ != Mode::abs && mode_ != Mode::as_it_is) ||
          (op == Opcode::incremental && mode_ != Mode::inc))
        mode = Mode::unclear;
    }
    return mode;
  }
  std::size_t leave_block(std::string_view why, std::size_t from, std::size_t end, ReadSteps& list) {
    mode_ = mode_behind(from, end);
    return leave(why, from, end + 1, list);
  }
  std::size_t read_condition(std::size_t i, ReadSteps& list) {
    const std::size_t end = text_.end_of[i];
    const Instruction& test = text_.at(i);
    if (!asks_input(test) || end < i + 2) return leave_block(why::no_test, i, end, list);
    seq::MoveOnInput on_input;
    on_input.input = test.values[0].index, on_input.on = test.values[1].number != 0;
    std::size_t at = i + 1;
    if (text_.at(at).op == Opcode::stop && text_.at(at).axes.count() == 1 && at + 2 < end &&
        text_.at(at + 1).op == Opcode::wait && text_.at(at + 1).axes == text_.at(at).axes)
      on_input.stops_first = true, at += 2;
    const Instruction& motion = text_.at(at);
    const bool moves = motion.op == Opcode::move && motion.axes.count() == 1 &&
                       is_number(motion.values[ix(motion.axes.first())]);
    const bool known = moves || motion.op == Opcode::jog || motion.op == Opcode::home_switch;
    if (!known || at + 1 != end || (on_input.stops_first && text_.at(i + 1).axes != motion.axes))
      return leave_block(why::no_test, i, end, list);
    on_input.axis = place_of(motion.axes.first());
    if (on_input.axis < 0) return leave_block(why::no_such_axis, i, end, list);
    if (moves && (!choose_mode(at) || mode_ != Mode::abs))
      return leave_block("no block decides whether to go by a distance", i, end, list);
    using Kind = seq::MoveOnInput::Kind;
    on_input.kind = moves ? Kind::move : motion.op == Opcode::jog ? Kind::jog : Kind::home;
    on_input.direction = motion.sign;
    if (moves) on_input.to = out_.units(on_input.axis, motion.values[ix(motion.axes.first())].number);
    forget(on_input.axis);
    return put(on_input, i, end + 1, list);
  }
  std::size_t read_loop(std::size_t i, ReadSteps& list) {
    const auto& counted = text_.counted[i];
    const std::size_t head = counted ? counted->head : i, end = text_.end_of[head];
    const Instruction& test = text_.at(head);
    if (asks_input(test) && end == head + 1)
      return put(seq::WaitInput{test.values[0].index, test.values[1].number == 0}, head, end + 1, list);
    const bool endless = is_number(test.values[0], 1) && is_number(test.values[1], 1) &&
                         test.comparison == language::Comparison::equal;
    if (!counted && !endless) return leave_block(why::no_such_loop, i, end, list);
    if (depth_ + 2 > seq::deepest_loop) return leave_block(why::too_deep, i, end, list);
    if (counted && counted->variable != first_counter - depth_)
      out_.remarks.push_back(
          fmt::format("The loop of line {} now counts in V{}, as blocks do, instead of V{}.",
                      text_.statements[head].line + 1, first_counter - depth_, counted->variable));
    const std::size_t last = counted ? counted->count : end;
    mode_ = mode_behind(head + 1, last);
    at_ = {};
    ReadStep loop;
    seq::Repeat repeat;
    repeat.times = counted ? counted->times : 0;
    loop.body = std::move(repeat);
    loop.at = {text_.stretch(i).begin, text_.stretch(end).end};
    loop.inside = {text_.stretch(head).end, text_.stretch(last).begin};
    remarks_.read_before(loop.inside.begin, list);
    const Mode before = mode_;
    ++depth_;
    read(head + 1, last, loop.inner);
    --depth_;
    mode_ = before == Mode::as_it_is ? mode_ : before;
    remarks_.read_before(loop.at.end, loop.inner);
    list.push_back(std::move(loop));
    at_ = {};
    return end + 1;
  }

  const std::string_view source_;
  const Catalog& catalog_;
  const language::Dialect& dialect_;
  const StatementText text_;
  ReadText out_;
  TextRemarks remarks_;
  std::array<std::pair<std::size_t, std::size_t>, 2> routines_{};  ///< by down: between its head and its end
  int depth_ = 0;
  Mode mode_ = Mode::as_it_is;
  seq::Places at_{};
};

}  // namespace

Result<SequenceRead> read_sequence(std::string_view text, const seq::Sequence& frame, const Catalog& catalog,
                                   const language::Dialect& dialect) {
  if (language::is_listing(text))
    return no_block_for(text, 0, "a listing of low-level lines. Blocks are made of program texts.");
  const language::Compilation compiled = language::compile(text, dialect);
  for (const Problem& p : compiled.problems)
    if (p.error)
      return fail(FaultKind::text, fmt::format("Line {}: {}", p.line + 1, p.sentence), blocks_unchanged);
  auto read = BlockReader(text, frame, catalog, dialect, compiled).run();
  if (!read) return fail(read.error());
  ReadingLanguage language;
  language.write = [&](const seq::Sequence& made) { return write_sequence(made, catalog, dialect); };
  language.operations = [&](std::string_view of) { return operations_of(of, dialect); };
  return prove(std::move(*read), text, language);
}

}  // namespace hw::arcus
