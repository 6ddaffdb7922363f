#include "core/devices/arcus/language/structure.h"

#include <algorithm>
#include <array>
#include <string>

namespace hw::arcus::language {
namespace {

std::string in_line(const Statement& s) { return " in line " + std::to_string(s.line + 1); }
std::string number_of(const Statement& s) { return std::to_string(s.instruction.values[0].number); }

Problem problem_at(const Statement& s, std::string sentence) {
  Problem problem;
  problem.line = s.line;
  problem.column = s.column;
  problem.length = s.length;
  problem.sentence = std::move(sentence);
  return problem;
}

class StructureCheck {
 public:
  StructureCheck(const std::vector<Statement>& statements, std::vector<Problem>& problems)
      : statements_(statements), problems_(problems) {}

  void run() {
    for (const Statement& s : statements_) see(s);
    finish();
  }

 private:
  enum class Place { outside, program, sub };
  struct Block {
    const Statement* head;
    bool loop, has_else;
  };

  void report(const Statement& s, std::string sentence) {
    problems_.push_back(problem_at(s, std::move(sentence)));
  }

  void see(const Statement& s) {
    switch (s.instruction.op) {
      case Opcode::prg: return begin_program(s);
      case Opcode::sub: return begin_sub(s);
      case Opcode::end: return end_program(s);
      case Opcode::endsub: return end_sub(s);
      default: break;
    }
    if (place_ == Place::outside) enter_text_before_headings(s);
    if (place_ != Place::outside) see_block(s);  // an unexpected line is reported once
  }

  void begin_program(const Statement& s) {
    leave_unfinished(s);
    place_ = Place::program;
    opened_by_ = &s;
    unexpected_ = false;
    note(programs_, s, "PRG ");
  }

  void begin_sub(const Statement& s) {
    leave_unfinished(s);
    place_ = Place::sub;
    opened_by_ = &s;
    unexpected_ = false;
    note(subs_, s, "SUB ");
  }

  template <class Heads>
  void note(Heads& heads, const Statement& s, const char* word) {
    if (!s.sound) return;
    const Statement*& known = heads[static_cast<std::size_t>(s.instruction.values[0].number)];
    if (known)
      report(s, word + number_of(s) + " appears twice; the first is" + in_line(*known) + ".");
    else
      known = &s;
  }

  /// Text without PRG is program 0; after that a statement must be in a program or subroutine.
  void enter_text_before_headings(const Statement& s) {
    if (!opened_by_) {
      place_ = Place::program;
      opened_by_ = programs_[0] = &s;
      return;
    }
    if (!unexpected_)
      report(s, "Put this before END or ENDSUB, or under a PRG or SUB: here it is outside any program.");
    unexpected_ = true;  // reported once for several such lines in a row
  }

  void end_program(const Statement& s) {
    close_blocks();
    if (place_ == Place::sub) report(s, "A subroutine ends with ENDSUB, not with END.");
    if (place_ == Place::outside && opened_by_) report(s, "There is no program above this END.");
    if (!opened_by_) opened_by_ = programs_[0] = &s;  // an empty program
    place_ = Place::outside;
  }

  void end_sub(const Statement& s) {
    close_blocks();
    if (place_ == Place::program) report(s, "A program ends with END; ENDSUB ends a subroutine.");
    if (place_ == Place::outside) report(s, "There is no SUB above this ENDSUB.");
    if (!opened_by_) opened_by_ = &s;
    place_ = Place::outside;
  }

  /// A new heading while a program or subroutine is still open.
  void leave_unfinished(const Statement& next) {
    close_blocks();
    if (place_ == Place::outside) return;
    const bool program = place_ == Place::program;
    report(next, std::string(program ? "END" : "ENDSUB") + " is missing above: the " +
                     (program ? "program" : "subroutine") + " that begins" + in_line(*opened_by_) +
                     " is not ended.");
    Problem& problem = problems_.back();
    problem.fix_text = program ? "END\n" : "ENDSUB\n";
    problem.fix_label = program ? "Add END" : "Add ENDSUB";
    problem.length = 0;
  }

  void see_block(const Statement& s) {
    switch (s.instruction.op) {
      case Opcode::if_: blocks_.push_back({&s, false, false}); break;
      case Opcode::while_: blocks_.push_back({&s, true, false}); break;
      case Opcode::elseif:
      case Opcode::else_: branch(s); break;
      case Opcode::endif: close(s, false); break;
      case Opcode::endwhile: close(s, true); break;
      default: break;
    }
  }

  /// Blocks opened after the innermost one of this kind lack their end. False: there is none of this kind.
  bool unwind_to(bool loop) {
    const auto found =
        std::find_if(blocks_.rbegin(), blocks_.rend(), [&](const Block& b) { return b.loop == loop; });
    if (found == blocks_.rend()) return false;
    while (blocks_.back().loop != loop) {
      complain_open(blocks_.back());
      blocks_.pop_back();
    }
    return true;
  }

  void branch(const Statement& s) {
    const bool is_else = s.instruction.op == Opcode::else_;
    if (!unwind_to(false))
      return report(s, std::string(is_else ? "ELSE" : "ELSEIF") + " has no IF above it.");
    Block& block = blocks_.back();
    if (block.has_else)
      report(s, std::string(is_else ? "The IF" : "ELSEIF comes after ELSE: the IF") + in_line(*block.head) +
                    (is_else ? " has an ELSE already." : " has had its last branch."));
    block.has_else |= is_else;
  }

  void close(const Statement& s, bool loop) {
    if (!unwind_to(loop))
      return report(s, loop ? "ENDWHILE has no WHILE above it." : "ENDIF has no IF above it.");
    blocks_.pop_back();
  }

  void complain_open(const Block& block) {
    report(*block.head, block.loop ? "This WHILE has no ENDWHILE." : "This IF has no ENDIF.");
  }

  void close_blocks() {
    for (const Block& block : blocks_) complain_open(block);
    blocks_.clear();
  }

  void finish() {
    close_blocks();
    if (place_ == Place::outside) return;
    const bool program = place_ == Place::program;
    const Statement& last = statements_.back();
    report(last, std::string(program ? "END" : "ENDSUB") + " is missing below: the " +
                     (program ? "program" : "subroutine") + " that begins" + in_line(*opened_by_) +
                     " is not ended.");
    Problem& problem = problems_.back();
    problem.column = last.column + last.length;
    problem.length = 0;
    problem.fix_text = program ? "\nEND" : "\nENDSUB";
    problem.fix_label = program ? "Add END" : "Add ENDSUB";
  }

  const std::vector<Statement>& statements_;
  std::vector<Problem>& problems_;
  Place place_ = Place::outside;
  const Statement* opened_by_ = nullptr;  ///< the first statement of the part that is open, or was last
  bool unexpected_ = false;
  std::vector<Block> blocks_;
  std::array<const Statement*, max_programs> programs_{};
  std::array<const Statement*, subroutines> subs_{};
};

/// The calls between subroutines, as far as the text shows them.
class CallGraph {
 public:
  explicit CallGraph(const std::vector<Statement>& statements) {
    int inside = -1;
    for (const Statement& s : statements) {
      const auto number = static_cast<std::size_t>(s.instruction.values[0].number);
      unread_head_ |= !s.sound && s.instruction.op == Opcode::sub;
      if (!s.sound) continue;
      if (s.instruction.op == Opcode::sub) {
        inside = static_cast<int>(number);
        if (!heads_[number]) heads_[number] = &s;
      } else if (s.instruction.op == Opcode::endsub || s.instruction.op == Opcode::prg) {
        inside = -1;
      } else if (s.instruction.op == Opcode::gosub && inside >= 0) {
        calls_[static_cast<std::size_t>(inside)].push_back(number);
      }
    }
  }
  [[nodiscard]] const Statement* head(std::size_t sub) const { return heads_[sub]; }
  /// Whether the subroutine may exist: a SUB whose line has a mistake may be any subroutine.
  [[nodiscard]] bool may_be_there(std::size_t sub) const { return heads_[sub] || unread_head_; }

  /// Levels of calls from here, this subroutine included. If it calls itself: more than any program may have.
  int depth(std::size_t sub) {
    if (walking_[sub]) return endless;
    if (known_[sub] > 0) return known_[sub];
    walking_[sub] = true;
    int below = 0;
    for (const std::size_t callee : calls_[sub]) below = std::max(below, depth(callee));
    walking_[sub] = false;
    return known_[sub] = std::min(below + 1, endless);
  }
  static constexpr int endless = 1000;

 private:
  std::array<const Statement*, subroutines> heads_{};
  bool unread_head_ = false;
  std::array<std::vector<std::size_t>, subroutines> calls_;
  std::array<int, subroutines> known_{};
  std::array<bool, subroutines> walking_{};
};

}  // namespace

void check_structure(const std::vector<Statement>& statements, std::vector<Problem>& problems) {
  StructureCheck(statements, problems).run();
}

void check_calls(const std::vector<Statement>& statements, std::vector<Problem>& problems) {
  CallGraph graph(statements);
  bool in_sub = false;
  for (const Statement& s : statements) {
    if (s.instruction.op == Opcode::sub) in_sub = true;
    if (s.instruction.op == Opcode::endsub || s.instruction.op == Opcode::prg) in_sub = false;
    if (s.instruction.op != Opcode::gosub || !s.sound) continue;
    const auto sub = static_cast<std::size_t>(s.instruction.values[0].number);
    if (!graph.may_be_there(sub)) {
      problems.push_back(problem_at(s, "There is no SUB " + number_of(s) + " in this text."));
      continue;
    }
    const int depth = graph.depth(sub);
    if (in_sub || depth <= max_call_depth) continue;
    problems.push_back(problem_at(s, depth >= CallGraph::endless
                                         ? "The subroutines called from here call each other in a circle. "
                                           "Calls nest eight deep at most; the ninth is a program error."
                                         : "Calls from here nest " + std::to_string(depth) +
                                               " deep. Eight is the most; the ninth is a program error."));
    problems.back().error = false;
  }
}

}  // namespace hw::arcus::language
