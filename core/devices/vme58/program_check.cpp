#include "core/devices/vme58/program_check.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <optional>
#include <tuple>

#include <fmt/format.h>

#include "core/devices/vme58/command_text.h"
#include "core/devices/vme58/facts.h"

namespace hw::vme58 {
namespace {

TokenKind kind_of(const TextCommand& command) {
  if (!command.fact || !command.flaw.empty()) return TokenKind::bad;
  if (begins_motion(command.fact->op)) return TokenKind::moves;
  switch (command.fact->op) {
    case Op::CX:
    case Op::MV:
    case Op::SP:
    case Op::FP:
    case Op::ET: return TokenKind::moves;
    case Op::LS:
    case Op::LE:
    case Op::WS:
    case Op::WD:
    case Op::WH:
    case Op::WG:
    case Op::CW:
    case Op::WA:
    case Op::WQ:
    case Op::SW:
    case Op::WT:
    case Op::CD:
    case Op::CE:
    case Op::CK: return TokenKind::flow;
    default: return TokenKind::plain;
  }
}

std::string mode_words(unsigned where, bool recording) {
  if (recording) return "not while a contour is recorded: CE or CK ends it";
  if (where == where::contour) return "only between CD and CE or CK";
  if (where == where::all) return "only after AA";
  if ((where & where::single) == 0) return "only after AA or AM";
  return "only while one axis is addressed (AX to AS)";
}

class Check {
 public:
  explicit Check(std::string_view text) : text_(text), plain_(without_comments(text)) {}

  ProgramReport report() {
    split_lines();
    mark_comments();
    const Context context = look_at_all();
    if (context.recording)
      problem(recording_began_, 2, "The contour that begins here has no end: CE or CK is missing.", true);
    for (const Queue& queue : queues_)
      for (const auto& open : queue.loops)
        problem(open.second, 2, "The loop that begins here has no end.", true);
    report_.cost[0] = static_cast<int>(text_.size());
    for (LineReport& line : report_.lines) {
      line.slot = 0;
      std::sort(line.tokens.begin(), line.tokens.end(),
                [](const Token& a, const Token& b) { return a.begin < b.begin; });
    }
    std::sort(report_.problems.begin(), report_.problems.end(), [](const Problem& a, const Problem& b) {
      return a.line != b.line ? a.line < b.line : a.column < b.column;
    });
    return std::move(report_);
  }

 private:
  /// A queue of the board: one for each axis, one for AA, one for AM.
  struct Queue {
    std::vector<std::pair<Op, std::size_t>> loops;  ///< open loops and where they begin
    bool prepared = false;                          ///< a move waits for GO
  };
  Queue& queue_of(const TextCommand& command) {
    const Context& c = command.context;
    const int axis = c.mode == where::all ? most_axes : c.mode == where::tasks ? most_axes + 1 : c.axis;
    return queues_[static_cast<std::size_t>(axis)];
  }

  void split_lines() {
    begins_.push_back(0);
    for (std::size_t i = 0; i < text_.size(); ++i)
      if (text_[i] == '\n') begins_.push_back(i + 1);
    report_.lines.resize(begins_.size());
  }
  [[nodiscard]] std::pair<int, int> place(std::size_t at) const {
    const auto behind = std::upper_bound(begins_.begin(), begins_.end(), at);
    const auto line = static_cast<std::size_t>(behind - begins_.begin()) - 1;
    return {static_cast<int>(line), static_cast<int>(at - begins_[line])};
  }
  void mark_comments() {
    for (std::size_t line = 0; line < begins_.size(); ++line) {
      const std::size_t end = line + 1 < begins_.size() ? begins_[line + 1] - 1 : text_.size();
      const auto hash = text_.substr(0, end).find('#', begins_[line]);
      if (hash == text_.npos) continue;
      report_.lines[line].tokens.push_back({static_cast<int>(hash - begins_[line]),
                                            static_cast<int>(end - begins_[line]), TokenKind::comment});
    }
  }
  void problem(std::size_t at, std::size_t length, std::string sentence, bool error) {
    Problem p;
    p.error = error;
    std::tie(p.line, p.column) = place(at);
    p.length = static_cast<int>(length);
    p.sentence = std::move(sentence);
    report_.problems.push_back(std::move(p));
  }
  void error(const TextCommand& command, std::string sentence) {
    problem(command.begin, command.length, std::move(sentence), true);
  }

  /// Reports a missing AA or AM once, and reads the text from there on as if it were present. Returns the
  /// context at the end.
  Context look_at_all() {
    Context context;
    auto commands = read_commands(plain_, context);
    for (std::size_t i = 0; i < commands.size(); ++i) {
      if (selects(commands[i])) assumed_ = false;
      if (!assumed_ && modes_missed_ < most_modes_missed && lacks_mode(commands[i])) {
        ++modes_missed_;
        const std::size_t begin = commands[i].begin;
        const bool all = (commands[i].fact->where & where::all) != 0;
        error(commands[i],
              fmt::format("{} is accepted {}. The text after it is read as if {} came before it.",
                          commands[i].fact->letters, mode_words(commands[i].fact->where, false),
                          all ? "AA" : "AM"));
        assumed_ = reported_ = true;
        read_as_if_ = std::string(begin, ' ') + plain_.substr(begin);
        context = Context{all ? where::all : where::tasks};
        commands = read_commands(read_as_if_, context);
        i = 0;
      }
      look_at(commands[i]);
    }
    return context;
  }
  /// Whether the command is only for lists, and a single axis is addressed.
  static bool lacks_mode(const TextCommand& command) {
    return command.fact && !command.context.recording && command.context.mode == where::single &&
           (command.fact->where & where::single) == 0 && (command.fact->where & where::lists) != 0;
  }
  [[nodiscard]] unsigned modes_of(const TextCommand& command) const {
    const unsigned modes = command.context.modes();
    return assumed_ && !command.context.recording ? modes | where::single : modes;
  }

  void look_at(const TextCommand& command) {
    const auto [line, column] = place(command.begin);
    LineReport& row = report_.lines[static_cast<std::size_t>(line)];
    if (row.first_command < 0) row.first_command = static_cast<int>(report_.listing[0].size());
    ++row.command_count;
    row.cost += static_cast<int>(command.length);
    report_.listing[0].emplace_back(command.text);
    const std::size_t problems = report_.problems.size();
    if (!command.flaw.empty())
      problem(command.flaw_begin, command.flaw_length, command.flaw, true);
    else if ((command.fact->where & modes_of(command)) == 0)
      error(command, fmt::format("{} is taken {}.", command.fact->letters,
                                 mode_words(command.fact->where, command.context.recording)));
    else
      look_closer(command);
    const bool bad = std::exchange(reported_, false) ||
                     (report_.problems.size() > problems && report_.problems.back().error);
    row.tokens.push_back(
        {column, column + static_cast<int>(command.length), bad ? TokenKind::bad : kind_of(command)});
  }

  void look_closer(const TextCommand& command) {
    check_ranges(command);
    switch (command.fact->op) {
      case Op::UU:
        scaled_ = true;
        if (has_zero(command)) error(command, "UU cannot multiply by 0.");
        break;
      case Op::UF: scaled_ = false; break;
      case Op::MA:
      case Op::MR:
      case Op::MT:
      case Op::ML: queue_of(command).prepared = true; break;
      case Op::GO:
      case Op::GD:
        if (!std::exchange(queue_of(command).prepared, false) && queue_of(command).loops.empty())
          problem(command.begin, command.length, "No move has been prepared, so this starts nothing.", false);
        break;
      case Op::RM:
        if (has_zero(command)) error(command, "RM cannot divide by 0.");
        break;
      case Op::BL:
      case Op::BH: check_direction(command); break;
      case Op::contour_MT: check_contour_places(command); break;
      case Op::CD:
        recording_began_ = command.begin;
        recorded_ = true;
        break;
      case Op::CV: velocity_given_ = true; break;
      case Op::CX:
        if (!recorded_)
          problem(command.begin, command.length, "No contour has been recorded before this CX.", false);
        if (!velocity_given_)
          problem(command.begin, command.length, "Put CV before CX: the contour has no speed yet.", false);
        break;
      case Op::LS:
      case Op::WS:
      case Op::WH: open_loop(command); break;
      case Op::LE: close_loop(command, Op::LS); break;
      case Op::WD: close_loop(command, Op::WS); break;
      case Op::WG: close_loop(command, Op::WH); break;
      case Op::ST:
      case Op::FL:
      case Op::FP: queue_of(command) = Queue(); break;
      case Op::SA:
      case Op::SD:
      case Op::KL:
      case Op::RS: queues_ = {}; break;
      default: break;
    }
  }

  static bool has_zero(const TextCommand& command) {
    return std::find(command.numbers.begin(), command.numbers.end(), 0.0) != command.numbers.end();
  }

  // The board's jumpers decide the direction; a text does not know them.
  void check_direction(const TextCommand& command) {
    const std::optional<double> line = command.numbers.empty() ? std::nullopt : command.numbers[0];
    if (!line || *line < 0 || *line >= io_lines || (factory_outputs >> static_cast<int>(*line) & 1) != 0)
      return;
    problem(command.begin, command.length,
            fmt::format("Line {:.0f} is an input unless a jumper on the board makes it an output. The board "
                        "rejects this command for an input.",
                        std::trunc(*line)),
            false);
  }

  // Without user units the board cuts fractions off (decision M15).
  void check_fraction(const TextCommand& command, double value) {
    if (std::trunc(value) == value) return;
    problem(
        command.begin, command.length,
        fmt::format("{:.10g} is taken as {:.10g}: {} takes whole numbers{}.", value, std::trunc(value),
                    command.fact->letters, command.fact->number == Number::counts ? " unless UU is on" : ""),
        false);
  }

  void check_contour_places(const TextCommand& command) {
    const auto axes = static_cast<std::size_t>(std::popcount(command.context.contour_axes));
    if (command.numbers.size() > axes)
      error(command, fmt::format("This contour has {} axes, but {} numbers are given here.", axes,
                                 command.numbers.size()));
  }

  void check_ranges(const TextCommand& command) {
    const CommandFact& fact = *command.fact;
    if (scaled_ && fact.number == Number::counts) return;  // user units multiply it
    for (std::size_t i = 0; i < command.numbers.size(); ++i) {
      if (!command.numbers[i]) continue;
      const bool second = i > 0 && (fact.shape == Shape::pair);
      const bool third = fact.shape == Shape::triple && i == 2;
      const double low = second || third ? fact.second_min : fact.min,
                   high = second || third ? fact.second_max : fact.max;
      const bool whole = fact.number == Number::whole || fact.number == Number::counts;
      const double value = whole ? std::trunc(*command.numbers[i]) : *command.numbers[i];
      if (third) continue;
      if (value >= low && value <= high) {
        if (whole) check_fraction(command, *command.numbers[i]);
        continue;
      }
      return error(command, fmt::format("{:.10g} is out of range: {} takes {:.10g} to {:.10g}.",
                                        *command.numbers[i], fact.letters, low, high));
    }
  }

  // Loops belong to the queue of their mode.
  void open_loop(const TextCommand& command) {
    auto& loops = queue_of(command).loops;
    if (loops.size() == loop_levels)
      return error(command, fmt::format("Loops nest {} deep at most.", loop_levels));
    loops.emplace_back(command.fact->op, command.begin);
  }
  void close_loop(const TextCommand& command, Op begin) {
    auto& loops = queue_of(command).loops;
    if (loops.empty() || loops.back().first != begin)
      return error(command, fmt::format("{} has no {} before it.", command.fact->letters,
                                        begin == Op::LS   ? "LS"
                                        : begin == Op::WS ? "WS"
                                                          : "WH"));
    loops.pop_back();
  }

  std::string_view text_;
  std::string plain_;
  std::string read_as_if_;  ///< blanked up to the missing mode
  bool assumed_ = false, reported_ = false;
  static constexpr int most_modes_missed =
      20;  ///< for each, the rest is read again; later ones are single reports
  int modes_missed_ = 0;
  std::vector<std::size_t> begins_;
  ProgramReport report_;
  std::array<Queue, most_axes + 2> queues_{};
  std::size_t recording_began_ = 0;
  bool scaled_ = false, recorded_ = false, velocity_given_ = false;
};

}  // namespace

ProgramReport check_program(std::string_view text) { return Check(text).report(); }

}  // namespace hw::vme58
