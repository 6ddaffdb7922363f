// The parts of statements, and the messages when they do not fit. The statements themselves:
// parser_statements.cpp.
#include "core/devices/arcus/language/parser.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "core/base/number_text.h"
#include "core/devices/arcus/language/complaints.h"
#include "core/devices/arcus/language/encoding.h"

namespace hw::arcus::language {
namespace {

constexpr std::int64_t lowest = std::numeric_limits<std::int32_t>::min();
constexpr std::int64_t highest = std::numeric_limits<std::int32_t>::max();

bool is_minus_lookalike(std::string_view text) {
  return text == "\u2212" || text == "\u2013" || text == "\u2014";
}

}  // namespace

Problem& LineParser::report(int begin, int end, std::string sentence, std::string fix) {
  Problem& problem = problems_.emplace_back();
  problem.line = line_;
  problem.column = begin;
  problem.length = end - begin;
  problem.sentence = std::move(sentence);
  if (!fix.empty()) problem.fix_label = "Use " + fix;
  problem.fix_text = std::move(fix);
  return problem;
}

bool LineParser::complain(int begin, int end, std::string sentence, std::string fix) {
  report(begin, end, std::move(sentence), std::move(fix));
  return false;
}

void LineParser::warn(int begin, int end, std::string sentence, std::string fix) {
  report(begin, end, std::move(sentence), std::move(fix)).error = false;
}

/// Reports that the word at `at`, with the adjoining number, is unknown.
bool LineParser::complain_about_word(std::size_t at) {
  const Lexeme& word = (*lexemes_)[at];
  const Lexeme& behind = (*lexemes_)[std::min(at + 1, lexemes_->size() - 1)];
  const bool with_number = behind.is(Kind::number) && behind.begin == word.end;
  std::string text(word.text);
  if (with_number) text += behind.text;
  Complaint about = unknown_word(dialect_, text);
  return complain(word.begin, with_number ? behind.end : word.end, std::move(about.sentence),
                  std::move(about.fix));
}

bool LineParser::check_characters() {
  for (const Lexeme& l : *lexemes_) {
    if (!l.is(Kind::unknown)) continue;
    if (is_minus_lookalike(l.text)) return complain(l, "This dash is not a minus sign.", "-");
    return complain(l, "This character has no meaning in a program.");
  }
  return true;
}

bool LineParser::take(std::string_view sign) {
  if (!here().is(Kind::sign, sign)) return false;
  advance();
  return true;
}

bool LineParser::expect_end() { return at_end() || complain_about_rest(); }

bool LineParser::complain_about_rest() {
  const Lexeme& l = here();
  const int end = lexemes_->back().begin;
  if (l.is(Kind::word, "AND") || l.is(Kind::word, "OR") || l.is(Kind::sign, "&&") || l.is(Kind::sign, "||"))
    return complain(l.begin, end, "A condition compares two values once. Put a second IF inside this one.");
  if (operator_from_symbol(l.text) && i_.op == Opcode::compute)
    return complain(l.begin, end, "An assignment has one operation. Do the rest on the next line.");
  if (operator_from_symbol(l.text) && shape_of(i_.op) == Shape::link_and_test)
    return complain(l.begin, end,
                    "A condition does not calculate. Put the result in a variable on the line above.");
  if (l.text == "(" || l.text == ")")
    return complain(l, "The language has no brackets. Use a variable in between.");
  if (l.text == ",") return complain(l, "There are no commas between the parts of a statement.");
  return complain(l.begin, end,
                  "Nothing may follow here. Put each statement on its own line; a comment begins with ;.");
}

bool LineParser::expect_equals(const std::string& what) {
  if (take("=")) return true;
  if (here().is(Kind::sign, "==")) return complain(here(), "A single = assigns a value.", "=");
  return complain(here(), what + " needs = and a value.");
}

bool LineParser::number(std::int32_t& value) {
  const Lexeme& first = here();
  const bool minus = take("-");
  too_large_ = false;
  if (!minus) take("+");
  if (!here().is(Kind::number)) {
    if (here().is(Kind::word) && here().text.front() == 'V' && ahead().is(Kind::number))
      return complain(here().begin, ahead().end, "Only a number is possible here, not a variable.");
    return complain(here(), "A number is missing here.");
  }
  const auto n = whole_number<std::int64_t>(here().text);
  const std::int64_t with_sign = n ? (minus ? -*n : *n) : highest + 1;
  too_large_ = with_sign < lowest || with_sign > highest;
  if (too_large_)
    return complain(
        first.begin, here().end,
        "This number is out of range: it must be " + grouped(lowest) + " to " + grouped(highest) + ".");
  advance();
  value = static_cast<std::int32_t>(with_sign);
  return true;
}

bool LineParser::bounded_number(std::int64_t minimum, std::int64_t maximum, const std::string& sentence,
                                std::int32_t& value) {
  const int begin = here().begin;
  const std::size_t problems = problems_.size();
  if (!number(value)) {
    // A number beyond 32 bits is out of this range as well.
    if (problems_.size() > problems && too_large_) problems_.back().sentence = sentence;
    return false;
  }
  if (value >= minimum && value <= maximum) return true;
  return complain(begin, (*lexemes_)[at_ - 1].end, sentence);
}

bool LineParser::variable(Operand& value) {
  const Lexeme& letter = here();
  advance();
  if (!here().is(Kind::number)) return complain(letter, "A variable has a number: V0 to V99.");
  const auto n = whole_number<std::int64_t>(here().text);
  if (!n || *n >= variables) return complain(letter.begin, here().end, "The variables are V0 to V99.");
  advance();
  value = variable_operand(static_cast<int>(*n));
  return true;
}

/// A name of the dialect, with its number.
bool LineParser::named(Operand& value, const NameRow*& row, std::string& name) {
  const Lexeme& word = here();
  const bool numbered = ahead().is(Kind::number);
  const auto found =
      find_name(dialect_, word.text,
                numbered ? static_cast<int>(whole_number<std::int64_t>(ahead().text).value_or(999)) : -1);
  if (!found) return complain_about_word(at_);
  row = found->row;
  const int end = numbered ? ahead().end : word.end;
  name = std::string(word.text) + (numbered ? std::string(ahead().text) : std::string());
  if (row->indexing == Indexing::number && (found->index < row->first || found->index > row->last)) {
    const std::string spelling(row->spelling);
    return complain(word.begin, end,
                    "There is no " + name + " on the " + std::string(dialect_.model_name) + ": " + spelling +
                        std::to_string(row->first) + " to " + spelling + std::to_string(row->last) + ".");
  }
  if (!row->usual.empty()) {
    std::string usual(row->usual);
    if (row->indexing == Indexing::axis) usual += word.text.back();
    warn(word.begin, end, name + " is taken as " + usual + ".", usual);
  }
  value = quantity_operand(row->quantity, found->index);
  advance();
  if (numbered) advance();
  return true;
}

bool LineParser::operand(Operand& value) {
  const Lexeme& l = here();
  if (l.is(Kind::sign, "-") && ahead().is(Kind::word))
    return complain(l, "A minus sign can precede numbers only. Subtract from 0 in a variable first.");
  if (l.is(Kind::number) || l.is(Kind::sign, "-") || l.is(Kind::sign, "+")) {
    std::int32_t n = 0;
    if (!number(n)) return false;
    value = number_operand(n);
    return true;
  }
  if (l.is(Kind::word, "V")) return variable(value);
  if (!l.is(Kind::word)) {
    if (l.text == "(") return complain_about_rest();
    return complain(l, "A value is missing here: a number, a variable, or a name such as PX.");
  }
  const NameRow* row = nullptr;
  std::string name;
  const int begin = l.begin;
  if (!named(value, row, name)) return false;
  if (!row->readable)
    return complain(begin, (*lexemes_)[at_ - 1].end, name + " can only be written, not read.");
  return true;
}

}  // namespace hw::arcus::language
