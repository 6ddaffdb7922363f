#include "core/devices/vxm/sequence_reader.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "core/base/index.h"
#include "core/device/sequence_draft.h"
#include "core/devices/vxm/facts.h"
#include "core/devices/vxm/sequence_commands.h"
#include "core/devices/vxm/sequence_writer.h"
#include "core/sequence/sequence_file.h"

namespace hw::vxm {
namespace {

namespace seq = sequence;  // its names are also those of commands
using Commands = std::vector<PlacedCommand>;

constexpr std::string_view motor_left_out = "a motor that the blocks do not have";

/// Whether a loop command goes back, unlike a marker.
bool goes_back(Op op) { return op >= Op::loop && op <= Op::loop_endless; }

/// U11 to U22 skip the next command unless the input has the given state.
bool skips(const Command& c) {
  return c.op == Op::user && (c.value == 11 || c.value == 12 || c.value == 21 || c.value == 22);
}

class BlockReader {
 public:
  BlockReader(std::string_view source, CommandText text, const seq::Sequence& frame, const Catalog& catalog)
      : source_(source), text_(std::move(text)), catalog_(catalog), out_(frame, catalog) {}

  Result<ReadText> run() {
    if (!text_.programs[0]) {
      for (const auto& program : text_.programs)
        if (program)
          return no_block_for(source_, program->at.begin, "blocks are program 0, and it has none.");
      return fail(FaultKind::text, "The text contains no command.", blocks_unchanged);
    }
    read(*text_.programs[0], 0, text_.programs[0]->commands.size(), out_.steps);
    if (fault_) return fail(*fault_);
    for (std::size_t n = 1; n < text_.programs.size(); ++n)
      if (text_.programs[n] && !used_[n])
        return no_block_for(source_, text_.programs[n]->at.begin,
                            fmt::format("no block runs program {}.", n));
    text_.remarks.finish(out_);
    return std::move(out_);
  }

 private:
  [[nodiscard]] int place_of(const Command& c) const { return out_.place_of(catalog_, c.motor - 1); }
  void refuse(const PlacedCommand& c, std::string_view why) {
    if (!fault_) fault_ = no_block_for(source_, c.at.begin, why).value();
  }

  // ---- commands

  void read(const PlacedProgram& program, std::size_t from, std::size_t to, ReadSteps& list) {
    for (std::size_t i = from; i < to && !fault_;) {
      text_.remarks.read_before(program.commands[i].at.begin, list);
      i = read_one(program, i, to, list);
    }
    if (to == program.commands.size()) text_.remarks.read_before(program.at.end, list);
  }
  /// Returns the place of the next command.
  std::size_t put(seq::Step::Body body, const Commands& all, std::size_t from, std::size_t behind,
                  ReadSteps& list) {
    list.push_back({std::move(body), {all[from].at.begin, all[behind - 1].at.end}});
    text_.remarks.pass(list.back());
    return behind;
  }
  std::size_t leave(std::string_view why, const Commands& all, std::size_t from, std::size_t behind,
                    ReadSteps& list) {
    for (std::size_t i = from; i < behind; ++i)
      if (const Op op = all[i].command.op; op == Op::call || op == Op::call_pick || op == Op::jump)
        refuse(all[i], "no block goes to another program in this way.");
    return put(seq::Custom{std::string(why), {}}, all, from, behind, list);
  }
  std::size_t read_one(const PlacedProgram& program, std::size_t i, std::size_t to, ReadSteps& list) {
    const Commands& all = program.commands;
    const Command& c = all[i].command;
    const auto next_is = [&](Op op) {
      return i + 1 < to && all[i + 1].command.op == op && all[i + 1].command.motor == c.motor;
    };
    if (goes_back(c.op)) return leave_back(all, i, list);
    switch (c.op) {
      case Op::index:
      case Op::index_to: {
        const int place = place_of(c);
        if (place < 0) return leave(motor_left_out, all, i, i + 1, list);
        seq::Move move;
        move.relative = c.op == Op::index;
        move.to[ix(place)] = out_.units(place, c.value);
        return put(move, all, i, i + 1, list);
      }
      case Op::home:
        if (!next_is(Op::set_zero))
          return leave("to a limit switch, without zero there", all, i, i + 1, list);
        if (const int place = place_of(c); place >= 0)
          return put(seq::Home{place, c.value < 0 ? Sign::minus : Sign::plus, {}}, all, i, i + 2, list);
        return leave(motor_left_out, all, i, i + 2, list);
      case Op::set_zero: return leave("no block sets zero here", all, i, i + 1, list);
      case Op::speed:
      case Op::accel: return read_speeds(all, i, to, list);
      case Op::pause: return put(seq::Delay{c.value * 100.0}, all, i, i + 1, list);
      case Op::pause_fine: return put(seq::Delay{c.value / 10.0}, all, i, i + 1, list);
      case Op::marker: return read_loop(program, i, to, list);
      case Op::call: return read_call(all, i, list);
      case Op::user: return read_user(all, i, to, list);
      case Op::group: return leave("motors that start together", all, i, i + 1, list);
      default: return leave(why::no_block, all, i, i + 1, list);
    }
  }
  std::size_t read_user(const Commands& all, std::size_t i, std::size_t to, ReadSteps& list) {
    const Command& c = all[i].command;
    if (c.value == 0) return put(seq::WaitInput{1, true}, all, i, i + 1, list);
    for (std::size_t o = 0; o < output_on.size(); ++o)
      if (c.value == output_on[o] || c.value == output_off[o])
        return put(seq::Output{catalog_.output_number(o), c.value == output_on[o], 0}, all, i, i + 1, list);
    if (skips(c) && i + 1 < to) return read_condition(all, i, list);
    return leave(why::no_block, all, i, i + 1, list);
  }
  std::size_t read_condition(const Commands& all, std::size_t i, ReadSteps& list) {
    const Command &skip = all[i].command, &motion = all[i + 1].command;
    seq::MoveOnInput on_input;
    on_input.input = skip.value % 10, on_input.on = skip.value / 10 == 1;
    on_input.axis = place_of(motion);
    if (on_input.axis >= 0 && motion.op == Op::index_to) {
      on_input.to = out_.units(on_input.axis, motion.value);
      return put(on_input, all, i, i + 2, list);
    }
    const Command* home = motion.op == Op::call ? homing_of(motion.value) : nullptr;
    if (!home) return leave(why::no_test, all, i, i + 2, list);
    used_[ix(motion.value)] = true;
    on_input.kind = seq::MoveOnInput::Kind::home, on_input.axis = place_of(*home);
    on_input.direction = home->value < 0 ? Sign::minus : Sign::plus;
    return put(on_input, all, i, i + 2, list);
  }
  /// The home command of a program that does nothing but home a motor; null: it does something else.
  [[nodiscard]] const Command* homing_of(std::int64_t number) const {
    if (number <= 0 || ix(number) >= text_.programs.size() || !text_.programs[ix(number)]) return nullptr;
    const Commands& body = text_.programs[ix(number)]->commands;
    const bool homes = body.size() == 2 && body[0].command.op == Op::home && place_of(body[0].command) >= 0 &&
                       body[1].command.op == Op::set_zero && body[1].command.motor == body[0].command.motor;
    return homes ? &body[0].command : nullptr;
  }

  // ---- speeds

  /// Reads the speeds of all axes in the order of the writer as one step.
  std::size_t read_speeds(const Commands& all, std::size_t i, std::size_t to, ReadSteps& list) {
    std::size_t behind = i;
    for (std::size_t a = 0; a < out_.axes.size(); ++a) {
      const auto is = [&](Op op) {
        return behind < to && all[behind].command.op == op &&
               place_of(all[behind].command) == static_cast<int>(a);
      };
      given_[a].new_high = is(Op::speed);
      if (is(Op::speed)) given_[a].high = all[behind++].command.value;
      given_[a].accel = is(Op::accel) ? all[behind++].command.value : 0;
    }
    seq::Speed speed;
    if (behind > i && speed_of_all(speed.speeds)) return put(speed, all, i, behind, list);
    given_ = {}, ramp_ms_ = 0;
    for (behind = i;
         behind < to && (all[behind].command.op == Op::speed || all[behind].command.op == Op::accel);)
      ++behind;
    return leave(why::unlike_speeds, all, i, behind, list);
  }
  bool speed_of_all(seq::Speeds& speeds) {
    const Given& first = given_[0];
    const double high = out_.units(0, first.high);
    for (std::size_t a = 0; a < out_.axes.size(); ++a)
      if (given_[a].new_high != first.new_high || (given_[a].accel != 0) != (first.accel != 0) ||
          std::llround(high * out_.axes[a].per_unit) != given_[a].high)
        return false;
    if (first.high == 0) return false;
    if (first.new_high) speeds.high = high;
    if (first.accel == 0) return true;
    const double exact =
        static_cast<double>(first.high) / (static_cast<double>(first.accel) * accel_unit) * 1000;
    for (const double ramp : {ramp_ms_, std::round(exact), exact}) {
      if (ramp == 0 || !has_ramp(ramp)) continue;
      speeds.ramp_ms = ramp_ms_ = ramp;
      return true;
    }
    return false;
  }
  /// Whether the writer would write this ramp.
  [[nodiscard]] bool has_ramp(double ms) const {
    for (std::size_t a = 0; a < out_.axes.size(); ++a)
      if (std::llround(static_cast<double>(given_[a].high) / (ms / 1000) / accel_unit) != given_[a].accel)
        return false;
    return true;
  }

  // ---- loops and other programs

  std::size_t read_loop(const PlacedProgram& program, std::size_t i, std::size_t to, ReadSteps& list) {
    const Commands& all = program.commands;
    std::size_t end = i + 1;
    while (end < to && !is_loop(all[end].command.op)) ++end;
    if (end == to || !goes_back(all[end].command.op))
      return leave("a mark that no loop of blocks can have", all, i, i + 1, list);
    std::size_t again = end + 1;  // a second loop that goes back to the same mark
    while (again < to && !is_loop(all[again].command.op)) ++again;
    if (again < to && goes_back(all[again].command.op))
      return leave("loops that share a mark", all, i, end + 1, list);
    return put_loop(program, i + 1, end, {all[i].at.begin, all[end].at.end}, list)
               ? end + 1
               : leave(why::no_such_loop, all, i, end + 1, list);
  }
  bool put_loop(const PlacedProgram& program, std::size_t from, std::size_t end, Stretch at,
                ReadSteps& list) {
    const Command& back = program.commands[end].command;
    if (back.op != Op::loop_always && back.op != Op::loop_endless) return false;
    if (depth_ + 2 > seq::deepest_loop) return false;
    seq::Repeat repeat;
    repeat.times = back.op == Op::loop_endless ? 0 : back.value;
    const Stretch inside{from < end ? program.commands[from].at.begin : program.commands[end].at.begin,
                         program.commands[end].at.begin};
    ReadStep loop{std::move(repeat), at, {}, inside};
    ++depth_;
    read(program, from, end, loop.inner);
    --depth_;
    text_.remarks.read_before(inside.end, loop.inner);
    list.push_back(std::move(loop));
    return true;
  }
  /// A loop back to the mark of another loop, or to the beginning of the program.
  std::size_t leave_back(const Commands& all, std::size_t i, ReadSteps& list) {
    std::size_t from = i;
    while (from > 0 && all[from].command.op != Op::marker) --from;
    while (!list.empty() && list.back().at.begin >= all[from].at.begin) list.pop_back();
    return leave("a loop without a mark of its own", all, from, i + 1, list);
  }
  std::size_t read_call(const Commands& all, std::size_t i, ReadSteps& list) {
    const auto number = ix(all[i].command.value);
    if (number == 0 || number >= text_.programs.size() || !text_.programs[number] ||
        depth_ + 2 > seq::deepest_loop) {
      refuse(all[i], "no block goes to another program in this way.");
      return i + 1;
    }
    const PlacedProgram& program = *text_.programs[number];
    const Commands& body = program.commands;
    const std::size_t back_here = text_.remarks.go_to(program.at.begin);
    bool known = true;
    for (const bool down : {false, true})
      if (program.name.ends_with(routine_name(down))) {
        if (!std::exchange(used_[number], true)) {
          ++depth_;
          read(program, 0, body.size(), down ? out_.pen_down : out_.pen_up);
          --depth_;
        }
        text_.remarks.go_to(back_here);
        return put(seq::Pen{down}, all, i, i + 1, list);
      }
    const bool waits = body.size() == 3 && body[0].command == Command(Op::pause_fine, 0, 10) &&
                       skips(body[1].command) && body[2].command.op == Op::loop_endless;
    if (waits)
      put(seq::WaitInput{body[1].command.value % 10, body[1].command.value / 10 == 2}, all, i, i + 1, list);
    else
      known = !body.empty() && std::none_of(body.begin(), body.end() - 1, [](const PlacedCommand& c) {
        return is_loop(c.command.op);
      }) && put_loop(program, 0, body.size() - 1, all[i].at, list);
    text_.remarks.go_to(back_here);
    used_[number] = true;
    if (!known)
      refuse(all[i],
             fmt::format("program {} is more than a loop or a wait. Blocks have no other programs.", number));
    return i + 1;
  }

  struct Given {
    std::int64_t high = 0, accel = 0;
    bool new_high = false;
  };
  const std::string_view source_;
  CommandText text_;
  const Catalog& catalog_;
  ReadText out_;
  std::array<Given, max_axes> given_{};
  double ramp_ms_ = 0;
  std::array<bool, program_count> used_{};
  int depth_ = 0;
  std::optional<Fault> fault_;
};

}  // namespace

Result<SequenceRead> read_sequence(std::string_view text, const seq::Sequence& frame,
                                   const Catalog& catalog) {
  auto commands = CommandText::read(text);
  if (!commands) return fail(commands.error());
  auto read = BlockReader(text, std::move(*commands), frame, catalog).run();
  if (!read) return fail(read.error());
  ReadingLanguage language;
  language.write = [&](const seq::Sequence& made) { return write_sequence(made, catalog); };
  language.operations = operations_of;
  return prove(std::move(*read), text, language);
}

}  // namespace hw::vxm
