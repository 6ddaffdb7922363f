#pragma once
// Splits one line of a program text into words, numbers, signs, and the comment after them.
#include <string>
#include <string_view>
#include <vector>

namespace hw::arcus::language {

struct Lexeme {
  enum class Kind { word, number, sign, unknown, end };
  Kind kind = Kind::end;
  int begin = 0, end = 0;  ///< bytes within the line
  std::string_view text;   ///< in capitals (AMB-112)

  [[nodiscard]] bool is(Kind k) const { return kind == k; }
  [[nodiscard]] bool is(Kind k, std::string_view t) const { return kind == k && text == t; }
};

/// Valid until the next `read`.
class LexedLine {
 public:
  void read(std::string_view line);

  /// Never empty: the last lexeme has kind `end` and stands after the last character of the statement.
  [[nodiscard]] const std::vector<Lexeme>& lexemes() const { return lexemes_; }
  [[nodiscard]] int comment() const { return comment_; }             ///< where it begins, or -1
  [[nodiscard]] bool star_comment() const { return star_comment_; }  ///< begins with '*' (AMB-105)
  [[nodiscard]] int length() const { return static_cast<int>(capitals_.size()); }

 private:
  void find_comment();

  std::string capitals_;
  std::vector<Lexeme> lexemes_;
  int comment_ = -1;
  bool star_comment_ = false;
};

}  // namespace hw::arcus::language
