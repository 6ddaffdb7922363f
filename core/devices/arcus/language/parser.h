#pragma once
// Parses one line of a program text into a statement or a problem in words. Each line is parsed alone;
// structure.h checks how lines belong together.
#include <optional>
#include <string>
#include <vector>

#include "core/device/language.h"
#include "core/devices/arcus/language/dialect.h"
#include "core/devices/arcus/language/lexer.h"
#include "core/devices/arcus/language/program.h"

namespace hw::arcus::language {

struct Statement {
  Instruction instruction;
  int line = 0, column = 0, length = 0;  ///< where it stands, from 0
  bool sound = true;  ///< false: a problem was reported; it still opens or closes its block
};

class LineParser {
 public:
  LineParser(const Dialect& dialect, std::vector<Problem>& problems)
      : dialect_(dialect), problems_(problems) {}

  /// Nothing: a blank line, a comment, or a line that is not understood at all.
  std::optional<Statement> parse(const LexedLine& lexed, int line);

 private:
  using Kind = Lexeme::Kind;

  // The lexeme at the present place
  [[nodiscard]] const Lexeme& here() const { return (*lexemes_)[at_]; }
  [[nodiscard]] const Lexeme& ahead() const {
    return (*lexemes_)[at_ + 1 < lexemes_->size() ? at_ + 1 : at_];
  }
  [[nodiscard]] bool at_end() const { return here().is(Kind::end); }
  void advance() { at_ += at_ + 1 < lexemes_->size(); }
  bool take(std::string_view sign);

  // Complaints. Each returns false, so that a reader can `return complain(...)`.
  bool complain(int begin, int end, std::string sentence, std::string fix = {});
  bool complain(const Lexeme& at, std::string sentence, std::string fix = {}) {
    return complain(at.begin, at.end, std::move(sentence), std::move(fix));
  }
  void warn(int begin, int end, std::string sentence, std::string fix);
  bool complain_about_word(std::size_t at);
  bool complain_about_rest();
  Problem& report(int begin, int end, std::string sentence, std::string fix);

  // Statements. False: the problem was reported.
  bool check_characters();
  bool check_axis_letter(const Lexeme& word, const Lexeme& behind);
  bool parse_statement();
  bool parse_keyword(Opcode op);
  bool parse_alone();
  bool parse_numbered(int limit, std::string_view what);
  bool parse_condition();
  bool parse_delay();
  bool parse_control();
  bool parse_arc();
  bool parse_axis_word(Opcode op, AxisSet axes);
  bool parse_moves();
  bool parse_one_move();
  bool parse_variable_assignment();
  bool parse_assignment();
  bool parse_written_value(const NameRow& row, const std::string& name);

  // Parts of statements
  bool number(std::int32_t& value);
  bool bounded_number(std::int64_t minimum, std::int64_t maximum, const std::string& sentence,
                      std::int32_t& value);
  bool operand(Operand& value);
  bool variable(Operand& value);
  bool named(Operand& value, const NameRow*& row, std::string& name);
  bool expect_equals(const std::string& what);
  bool expect_end();
  bool end_of_arc_word(std::size_t letters);

  const Dialect& dialect_;
  std::vector<Problem>& problems_;
  const LexedLine* lexed_ = nullptr;
  const std::vector<Lexeme>* lexemes_ = nullptr;
  std::size_t at_ = 0;
  int line_ = 0;
  bool too_large_ = false;  ///< the number read last exceeds 32 bits
  Instruction i_;
};

}  // namespace hw::arcus::language
