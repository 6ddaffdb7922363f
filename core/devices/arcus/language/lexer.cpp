#include "core/devices/arcus/language/lexer.h"

#include <algorithm>

#include "core/base/number_text.h"

namespace hw::arcus::language {
namespace {

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\f' || c == '\v'; }
bool is_letter(char c) { return c >= 'A' && c <= 'Z'; }
char capital(char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; }

/// Operators of two characters: the language's own, and those of other languages that are easily typed by
/// mistake.
constexpr std::string_view double_signs[] = {
    ">=", "<=", "!=", ">>", "<<", "==", "<>", "=>", "=<", "&&", "||"};
constexpr std::string_view single_signs = "=<>+-*/%&|~:()[]{},.";

std::size_t sign_length(std::string_view rest) {
  for (const std::string_view sign : double_signs)
    if (rest.starts_with(sign)) return 2;
  return single_signs.find(rest.front()) != std::string_view::npos ? 1 : 0;
}

/// The rest of a character that a program cannot contain, UTF-8 taken as a whole.
std::size_t unknown_length(std::string_view rest) {
  std::size_t n = 1;
  while (n < rest.size() && (static_cast<unsigned char>(rest[n]) & 0xC0) == 0x80) ++n;
  return n;
}

/// Blanks found in text that is copied from a printed manual: U+00A0, U+2000 to U+200A, U+202F, and the byte
/// order mark of a file. They become plain blanks of the same length in bytes.
void flatten_blanks(std::string& text) {
  const auto byte = [&](std::size_t at) {
    return at < text.size() ? static_cast<unsigned char>(text[at]) : 0;
  };
  for (std::size_t at = 0; at < text.size(); ++at) {
    if (byte(at) < 0x80) continue;
    const bool two = byte(at) == 0xC2 && byte(at + 1) == 0xA0;
    const bool general = byte(at) == 0xE2 && byte(at + 1) == 0x80 &&
                         ((byte(at + 2) >= 0x80 && byte(at + 2) <= 0x8A) || byte(at + 2) == 0xAF);
    const bool mark = byte(at) == 0xEF && byte(at + 1) == 0xBB && byte(at + 2) == 0xBF;
    if (two || general || mark) text.replace(at, two ? 2 : 3, two ? 2 : 3, ' ');
  }
}

template <class Test>
std::size_t run_length(std::string_view rest, Test test) {
  return static_cast<std::size_t>(std::find_if_not(rest.begin(), rest.end(), test) - rest.begin());
}

}  // namespace

void LexedLine::find_comment() {
  const std::string_view text(capitals_);
  const auto semicolon = text.find(';'), stars = text.find("**"), first = text.find_first_not_of(" \t");
  auto begin = std::min(semicolon, stars);
  if (first != std::string_view::npos && text[first] == '*') begin = std::min(begin, first);
  comment_ = begin == std::string_view::npos ? -1 : static_cast<int>(begin);
  star_comment_ = comment_ >= 0 && text[begin] == '*';
}

void LexedLine::read(std::string_view line) {
  capitals_.assign(line);
  std::transform(capitals_.begin(), capitals_.end(), capitals_.begin(), capital);
  flatten_blanks(capitals_);
  lexemes_.clear();
  find_comment();
  const std::string_view code = std::string_view(capitals_).substr(0, static_cast<std::size_t>(comment_));
  std::size_t at = 0, code_end = 0;
  while (at < code.size()) {
    const std::string_view rest = code.substr(at);
    if (is_blank(rest.front())) {
      ++at;
      continue;
    }
    Lexeme::Kind kind = Lexeme::Kind::sign;
    std::size_t length = sign_length(rest);
    if (is_letter(rest.front()))
      kind = Lexeme::Kind::word, length = run_length(rest, is_letter);
    else if (is_digit(rest.front()))
      kind = Lexeme::Kind::number, length = run_length(rest, is_digit);
    else if (length == 0)
      kind = Lexeme::Kind::unknown, length = unknown_length(rest);
    lexemes_.push_back({kind, static_cast<int>(at), static_cast<int>(at + length), rest.substr(0, length)});
    code_end = at += length;
  }
  const int end = static_cast<int>(code_end);
  lexemes_.push_back({Lexeme::Kind::end, end, end, {}});
}

}  // namespace hw::arcus::language
