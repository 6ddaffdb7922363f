// The statements of the language, one function for each form.
#include <algorithm>

#include "core/devices/arcus/language/complaints.h"
#include "core/devices/arcus/language/encoding.h"
#include "core/devices/arcus/language/parser.h"

namespace hw::arcus::language {
namespace {

struct Keyword {
  std::string_view text;
  Opcode op;
};
constexpr Keyword keywords[] = {
    {"IF", Opcode::if_},      {"ELSEIF", Opcode::elseif}, {"ELSE", Opcode::else_},
    {"ENDIF", Opcode::endif}, {"WHILE", Opcode::while_},  {"ENDWHILE", Opcode::endwhile},
    {"GOSUB", Opcode::gosub}, {"END", Opcode::end},       {"PRG", Opcode::prg},
    {"SUB", Opcode::sub},     {"ENDSUB", Opcode::endsub}, {"DELAY", Opcode::delay},
    {"SR", Opcode::run},      {"ABS", Opcode::absolute},  {"INC", Opcode::incremental},
    {"STORE", Opcode::store},
};
constexpr Keyword arcs[] = {
    {"ARCP", Opcode::arc_clockwise},
    {"ARCN", Opcode::arc_counterclockwise},
    {"CIRP", Opcode::circle_clockwise},
    {"CIRN", Opcode::circle_counterclockwise},
};

Opcode keyword(std::string_view word) {
  for (const Keyword& k : keywords)
    if (k.text == word) return k.op;
  return Opcode::bad;
}

/// ARCP, ARCN; also ARCNO, as printed listings have the letter O for the digit 0 (AMB-109).
Opcode arc_keyword(std::string_view word) {
  for (const Keyword& k : arcs)
    if (word.starts_with(k.text) && word.find_first_not_of('O', k.text.size()) == std::string_view::npos)
      return k.op;
  return Opcode::bad;
}

/// Whether the statement opens or closes a block. The block counts as opened or closed even if the line has a
/// mistake.
bool is_structure(Opcode op) { return op >= Opcode::prg && op <= Opcode::endwhile && op != Opcode::gosub; }

/// EN=1, EN1=1: the word, whatever was meant, is assigned a value.
bool is_given_value(const std::vector<Lexeme>& line) {
  const std::size_t behind = line.size() > 1 && line[1].is(Lexeme::Kind::number) ? 2 : 1;
  return line.size() > behind && line[behind].is(Lexeme::Kind::sign, "=");
}

/// A misspelt word opens or closes the same block as the word it is taken for. END resembles many other
/// words, and would end a program.
Opcode guessed_structure(const std::vector<Lexeme>& line, std::string_view fix) {
  const std::size_t blank = fix.find(' ');  // IFV1=1: IF V1
  if (blank == fix.npos && is_given_value(line)) return Opcode::bad;
  const Opcode op = keyword(fix.substr(0, blank));
  const bool far = op == Opcode::end && line.front().text.front() != fix.front();
  return is_structure(op) && !far ? op : Opcode::bad;
}

/// Two words that belong together: END IF.
std::string joined(const Lexeme& first, const Lexeme& second) {
  if (!second.is(Lexeme::Kind::word)) return {};
  const std::string both = std::string(first.text) + std::string(second.text);
  return keyword(both) == Opcode::bad ? std::string() : both;
}

}  // namespace

std::optional<Statement> LineParser::parse(const LexedLine& lexed, int line) {
  lexed_ = &lexed;
  lexemes_ = &lexed.lexemes();
  at_ = 0;
  line_ = line;
  i_ = {};
  if (at_end()) return std::nullopt;
  const int begin = here().begin, end = lexemes_->back().begin;
  i_.op = keyword(here().text);
  const std::size_t problems = problems_.size();
  const bool sound = check_characters() && parse_statement();
  if (!sound && !is_structure(i_.op)) i_.op = Opcode::bad;
  if (i_.op == Opcode::bad && problems_.size() > problems && problems_.back().column == begin)
    i_.op = guessed_structure(*lexemes_, problems_.back().fix_text);
  i_.lines = static_cast<std::uint8_t>(lines_of(i_.op) > 0 ? lines_of(i_.op) : i_.axes.count());
  return Statement{i_, line, begin, end - begin, sound};
}

bool LineParser::parse_statement() {
  const Lexeme& first = here();
  if (!first.is(Kind::word)) {
    if (first.is(Kind::number)) return complain(first, "A statement begins with a word, not with a number.");
    return complain(first, "A statement begins with a word.");
  }
  if (const Opcode op = keyword(first.text); op != Opcode::bad) {
    if (std::string both = joined(first, ahead()); !both.empty()) {
      i_.op = keyword(both);
      return complain(first.begin, ahead().end, "This is one word: " + both + ".", both);
    }
    return parse_keyword(op);
  }
  if (!check_axis_letter(first, ahead())) return false;
  if (first.is(Kind::word, "V")) return parse_variable_assignment();
  if (const Opcode op = arc_keyword(first.text); op != Opcode::bad && dialect_.arcs) {
    i_.op = op;
    return parse_arc();
  }
  if (const auto word = find_word(dialect_, first.text)) return parse_axis_word(word->op, word->axes);
  const bool axis = dialect_.axis_of(first.text.front()) >= 0;
  if (axis && (first.text.size() == 1 || first.text.substr(1) == "V")) return parse_moves();
  return parse_assignment();
}

/// WAIT X: the letter of the axis belongs to the word.
bool LineParser::check_axis_letter(const Lexeme& word, const Lexeme& behind) {
  if (!behind.is(Kind::word) || behind.text.size() != 1 || dialect_.axis_of(behind.text.front()) < 0)
    return true;
  const std::string both = std::string(word.text) + std::string(behind.text);
  if (!find_word(dialect_, both) && !find_name(dialect_, both, -1)) return true;
  return complain(word.begin, behind.end, "This is one word: " + both + ".", both);
}

bool LineParser::parse_keyword(Opcode op) {
  i_.op = op;
  advance();
  const std::string last_program = std::to_string(dialect_.programs - 1);
  switch (op) {
    case Opcode::if_:
    case Opcode::elseif:
    case Opcode::while_: return parse_condition();
    case Opcode::delay: return parse_delay();
    case Opcode::run: return parse_control();
    case Opcode::prg:
      return parse_numbered(dialect_.programs, "Programs are PRG 0 to PRG " + last_program + ".");
    case Opcode::sub:
    case Opcode::gosub: return parse_numbered(subroutines, "Subroutines are 0 to 31.");
    default: return parse_alone();
  }
}

bool LineParser::parse_alone() { return expect_end(); }

bool LineParser::parse_numbered(int limit, std::string_view what) {
  std::int32_t n = 0;
  if (!bounded_number(0, limit - 1, std::string(what), n)) return false;
  i_.values[0] = number_operand(n);
  return expect_end();
}

bool LineParser::parse_condition() {
  if (!operand(i_.values[0])) return false;
  const Lexeme& sign = here();
  const auto comparison = comparison_from_symbol(sign.text);
  if (!comparison) {
    static constexpr std::pair<std::string_view, const char*> slips[] = {
        {"==", "="}, {"<>", "!="}, {"=>", ">="}, {"=<", "<="}};
    for (const auto& [wrong, right] : slips)
      if (sign.text == wrong)
        return complain(sign, "This comparison is written " + std::string(right) + ".", right);
    if (operator_from_symbol(sign.text) && !sign.is(Kind::end)) return complain_about_rest();
    return complain(sign, "A comparison is missing here: =, !=, <, >, <= or >=.");
  }
  i_.comparison = *comparison;
  advance();
  return operand(i_.values[1]) && expect_end();
}

bool LineParser::parse_delay() {
  std::int32_t ms = 0;
  if (!expect_equals("DELAY")) return false;
  if (!bounded_number(1, max_number, "DELAY takes 1 to " + grouped(max_number) + " ms.", ms)) return false;
  i_.values[0] = number_operand(ms);
  return expect_end();
}

bool LineParser::parse_control() {
  const std::string programs = "Programs are SR0 to SR" + std::to_string(dialect_.programs - 1) + ".";
  std::int32_t program = 0, command = 0;
  if (!bounded_number(0, dialect_.programs - 1, programs, program) || !expect_equals("SR")) return false;
  if (!bounded_number(0, 3, "SR takes 0 to stop, 1 to run, 2 to pause, 3 to continue.", command))
    return false;
  i_.values[0] = number_operand(program);
  i_.values[1] = number_operand(command);
  return expect_end();
}

/// The letter O behind ARCN as the digit 0. False: no such letter.
bool LineParser::end_of_arc_word(std::size_t letters) {
  const Lexeme& word = here();
  if (word.text.size() == letters) return false;
  warn(word.begin + static_cast<int>(letters), word.end, "The letter O is taken as the digit 0.", "0");
  return true;
}

bool LineParser::parse_arc() {
  const bool circle = shape_of(i_.op) == Shape::centre;
  const std::string form = std::string(mnemonic_of(i_.op)) + (circle ? "1000:0" : "1000:0:90000:90000");
  const std::string needs =
      circle ? "A circle needs X and Y of its centre, with a colon between: "
             : "An arc needs X and Y of its centre, end angle and swept angle, with colons: ";
  const bool letter_o = end_of_arc_word(4);
  advance();
  for (std::size_t n = 0; n < (circle ? 2U : 4U); ++n) {
    if (n > 0 && !take(":")) return complain(here(), needs + form + ".");
    std::int32_t value = 0;
    if (!(n == 0 && letter_o) && !number(value)) return false;
    i_.values[n] = number_operand(value);
  }
  if (!circle && i_.values[3].number < 0)
    return complain((*lexemes_)[at_ - 2].begin, (*lexemes_)[at_ - 1].end,
                    "The swept angle is never negative: ARCP turns clockwise, ARCN counter-clockwise.");
  if (!circle && i_.values[3].number == 0)
    return complain((*lexemes_)[at_ - 1], "The swept angle must be more than 0, in thousandths of a degree.");
  return expect_end();
}

bool LineParser::parse_axis_word(Opcode op, AxisSet axes) {
  const Lexeme& word = here();
  i_.op = op;
  i_.axes = axes;
  advance();
  if (shape_of(op) != Shape::axis_and_sign) return expect_end();
  i_.sign = here().is(Kind::sign, "-") ? Sign::minus : Sign::plus;
  if (!take("+") && !take("-"))
    return complain(word, std::string(word.text) + " needs a direction: " + std::string(word.text) + "+ or " +
                              std::string(word.text) + "-.");
  return expect_end();
}

bool LineParser::parse_moves() {
  i_.op = Opcode::move;
  while (!at_end())
    if (!parse_one_move()) return false;
  return true;
}

bool LineParser::parse_one_move() {
  const Lexeme& word = here();
  const bool glued_v = word.text.size() == 2 && word.text[1] == 'V';
  if (!word.is(Kind::word) || (word.text.size() > 1 && !glued_v)) return complain_about_rest();
  if (word.is(Kind::word, "V"))
    return complain(word.begin, ahead().end, "The letter of the axis is missing before the variable.");
  const int axis = dialect_.axis_of(word.text.front());
  if (axis < 0) return complain_about_word(at_);
  if (i_.axes.has(axis))
    return complain(word, std::string(1, word.text.front()) + " appears twice in this move.");
  i_.axes.add(axis);
  Operand& target = i_.values[static_cast<std::size_t>(axis)];
  if (glued_v) return variable(target);
  advance();
  if (here().is(Kind::sign, "="))
    return complain(here(), "A move has no =. Write " + std::string(word.text) + "1000.");
  if (here().is(Kind::word, "V")) return variable(target);
  std::int32_t position = 0;
  if (!bounded_number(dialect_.min_position, dialect_.max_position, position_range(dialect_), position))
    return false;
  target = number_operand(position);
  return true;
}

bool LineParser::parse_variable_assignment() {
  i_.op = Opcode::set;
  if (!variable(i_.target) || !expect_equals("A variable")) return false;
  if (take("~")) {
    i_.op = Opcode::compute;
    i_.operation = Operator::complement;
    return operand(i_.values[0]) && expect_end();
  }
  if (!operand(i_.values[0])) return false;
  const auto operation = operator_from_symbol(here().text);
  if (operation && has_two_operands(*operation) && !at_end()) {
    i_.op = Opcode::compute;
    i_.operation = *operation;
    advance();
    const Lexeme& second = here();
    if (!operand(i_.values[1])) return false;
    const bool divides = *operation == Operator::divide || *operation == Operator::remainder;
    if (divides && i_.values[1] == number_operand(0))
      warn(second.begin, second.end, "A division by zero is an error of the program: it goes to SUB 31.", {});
  } else if (i_.values[0].kind == Operand::Kind::quantity) {
    i_.op = Opcode::compute;
    i_.operation = Operator::copy;
  }
  return expect_end();
}

bool LineParser::parse_assignment() {
  const Lexeme& word = here();
  const NameRow* row = nullptr;
  std::string name;
  i_.op = Opcode::set;
  if (!named(i_.target, row, name)) return false;
  const int end = (*lexemes_)[at_ - 1].end;
  if (row->writable == Writable::no)
    return complain(word.begin, end, name + " can only be read. Copy it to a variable: V1=" + name + ".");
  return expect_equals(name) && parse_written_value(*row, name) && expect_end();
}

bool LineParser::parse_written_value(const NameRow& row, const std::string& name) {
  const Lexeme& first = here();
  const bool number_only = row.writable == Writable::number;
  if (first.is(Kind::word)) {
    if (number_only) return complain(first.begin, lexemes_->back().begin, name + " takes only a number.");
    if (!first.is(Kind::word, "V"))
      return complain(first.begin, lexemes_->back().begin,
                      name + " takes a number or a variable. Put the value in a variable on the line above.");
    return variable(i_.values[0]);
  }
  std::int32_t value = 0;
  if (row.any_is_on) {
    if (!number(value)) return false;
    if (!row.accepts(value))
      warn(first.begin, (*lexemes_)[at_ - 1].end,
           "Any number but 0 switches " + name + " on. Write 1 to be clear.", "1");
  } else if (!(row.also_zero && first.is(Kind::number, "0"))) {
    if (!bounded_number(row.minimum, row.maximum, value_range(row, name), value)) return false;
  } else {
    advance();
  }
  i_.values[0] = number_operand(value);
  return true;
}

}  // namespace hw::arcus::language
