#include "core/devices/arcus/language/complaints.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <map>
#include <numeric>
#include <optional>
#include <vector>

namespace hw::arcus::language {
namespace {

/// Commands that have another name in a program than on the wire (AMB-030 and the tables).
struct WireName {
  std::string_view wire, program;
  bool axis;  ///< an axis letter may stand behind both
};
constexpr WireName wire_names[] = {
    {"HS", "HSPD", true},    {"LS", "LSPD", true},    {"CLR", "ECLEAR", true},
    {"JE", "JOYENA", false}, {"SYNO", "SYNON", true}, {"SYNF", "SYNOFF", true},
};

constexpr std::string_view flow_words[] = {"IF",       "ELSEIF", "ELSE",  "ENDIF",  "WHILE",
                                           "ENDWHILE", "END",    "SUB",   "ENDSUB", "GOSUB",
                                           "PRG",      "DELAY",  "STORE", "ABS",    "INC"};

std::string axes_in_words(const Dialect& dialect) {
  if (dialect.axes.size() == 1) return "one axis, " + std::string(dialect.axes);
  return "the axes X, Y, Z and U";
}

/// HOME, WAIT, P ...: only the axis letter is missing.
bool lacks_axis(const Dialect& dialect, std::string_view letters) {
  const auto is_word = [&](const WordRow& row) { return row.spelling == letters; };
  const auto is_name = [&](const NameRow& row) {
    return row.indexing == Indexing::axis && row.spelling == letters && row.usual.empty();
  };
  return std::any_of(dialect.words.begin(), dialect.words.end(), is_word) ||
         std::any_of(dialect.names.begin(), dialect.names.end(), is_name);
}

bool knows(const Dialect& dialect, std::string_view letters, int number) {
  const bool arc = letters.starts_with("ARC") || letters.starts_with("CIR");
  if (arc) return dialect.arcs;
  return find_name(dialect, letters, number) || find_word(dialect, letters) ||
         (letters.size() == 1 && dialect.axis_of(letters.front()) >= 0);
}

/// Letters to change, add or drop until one word is the other (Levenshtein).
int distance(std::string_view a, std::string_view b) {
  std::array<int, 24> row{};
  if (b.size() >= row.size()) return static_cast<int>(b.size());
  std::iota(row.begin(), row.end(), 0);
  for (std::size_t i = 0; i < a.size(); ++i) {
    int diagonal = row[0];
    row[0] = static_cast<int>(i) + 1;
    for (std::size_t k = 0; k < b.size(); ++k) {
      const int change = diagonal + (a[i] == b[k] ? 0 : 1);
      diagonal = row[k + 1];
      row[k + 1] = std::min({change, row[k] + 1, diagonal + 1});
    }
  }
  return row[b.size()];
}

/// All words that could stand in a program without a number behind them.
std::vector<std::string> make_vocabulary(const Dialect& dialect) {
  std::vector<std::string> words(std::begin(flow_words), std::end(flow_words));
  const auto with_each_axis = [&](std::string_view spelling) {
    for (const char axis : dialect.axes) words.push_back(std::string(spelling) + axis);
  };
  for (const NameRow& row : dialect.names) {
    if (!row.usual.empty()) continue;
    if (row.indexing == Indexing::axis)
      with_each_axis(row.spelling);
    else
      words.emplace_back(row.spelling);
  }
  for (const WordRow& row : dialect.words) with_each_axis(row.spelling);
  return words;
}

const std::vector<std::string>& vocabulary(const Dialect& dialect) {
  static const auto all = [] {
    std::map<const Dialect*, std::vector<std::string>> made;
    for (const Dialect* each : all_dialects()) made[each] = make_vocabulary(*each);
    return made;
  }();
  return all.at(&dialect);
}

/// Another model whose programs know the word.
const Dialect* other_home_of(const Dialect& dialect, std::string_view letters, int number) {
  for (const Dialect* other : all_dialects())
    if (other != &dialect && knows(*other, letters, number)) return other;
  return nullptr;
}

/// Two adjacent letters are swapped: the commonest typing error.
bool swapped(std::string_view a, std::string_view b) {
  if (a.size() != b.size()) return false;
  const auto at = static_cast<std::size_t>(std::mismatch(a.begin(), a.end(), b.begin()).first - a.begin());
  return at + 1 < a.size() && a[at] == b[at + 1] && a[at + 1] == b[at] &&
         a.substr(at + 2) == b.substr(at + 2);
}

std::string nearest(const Dialect& dialect, std::string_view letters) {
  const std::string* best = nullptr;
  int closer_than = letters.size() < 4 ? 2 : 3;
  for (const std::string& word : vocabulary(dialect)) {
    const auto length_difference = static_cast<int>(word.size()) - static_cast<int>(letters.size());
    if (std::abs(length_difference) >= closer_than) continue;
    if (const int d = swapped(letters, word) ? 1 : distance(letters, word); d < closer_than)
      closer_than = d, best = &word;
  }
  return best ? *best : std::string();
}

/// IFV1: the blank between a keyword and its operand is missing.
std::optional<Complaint> glued_keyword(const Dialect& dialect, std::string_view word) {
  for (const std::string_view keyword : {"IF", "ELSEIF", "WHILE", "GOSUB"}) {
    if (!word.starts_with(keyword)) continue;
    const std::string_view operand = word.substr(keyword.size());
    const std::string_view letters = operand.substr(0, operand.find_first_of("0123456789"));
    const bool with_number = letters.size() < operand.size();
    const bool variable = letters == "V" && with_number;
    if (!variable && !find_name(dialect, letters, with_number ? 1 : -1)) continue;
    if (keyword == "GOSUB")
      return Complaint{"GOSUB takes only a number, not " + std::string(operand) + ".", {}};
    std::string apart = std::string(keyword) + " " + std::string(operand);
    return Complaint{"A blank is missing: " + apart + ".", std::move(apart)};
  }
  return std::nullopt;
}

}  // namespace

std::string grouped(std::int64_t number) {
  std::string digits = std::to_string(number < 0 ? -number : number);
  for (int at = static_cast<int>(digits.size()) - 3; at > 0; at -= 3)
    digits.insert(static_cast<std::size_t>(at), ",");
  return (number < 0 ? "-" : "") + digits;
}

std::string value_range(const NameRow& row, const std::string& name) {
  return name + " takes " + (row.also_zero ? "0 or " : "") + grouped(row.minimum) + " to " +
         grouped(row.maximum) + ".";
}

std::string position_range(const Dialect& dialect) {
  return "Positions are " + grouped(dialect.min_position) + " to " + grouped(dialect.max_position) +
         " (28 bits).";
}

Complaint unknown_word(const Dialect& dialect, std::string_view word) {
  const std::string shown(word);
  const std::string_view letters = word.substr(0, word.find_first_of("0123456789"));
  const int number = letters.size() < word.size() ? 1 : -1;
  const std::string name(dialect.model_name);

  for (const WireName& w : wire_names) {
    if (!letters.starts_with(w.wire)) continue;
    const std::string_view behind = letters.substr(w.wire.size());
    if (behind.size() > (w.axis ? 1U : 0U) || (behind.size() == 1 && dialect.axis_of(behind.front()) < 0))
      continue;
    std::string program = std::string(w.program) + std::string(behind);
    if (!knows(dialect, program, -1) && lacks_axis(dialect, program)) program += dialect.axes.front();
    return {shown + " is a command for the terminal. A program says " + program + ".", program};
  }
  if (lacks_axis(dialect, letters) && number < 0) {
    const std::string with_axis = shown + dialect.axes.front();
    const bool one = dialect.axes.size() == 1;
    return {shown + " needs the letter of its axis" + (one ? ": " : ", for instance ") + with_axis + ".",
            one ? with_axis : std::string()};
  }
  if (const Dialect* other = other_home_of(dialect, letters, number)) {
    const bool only_the_axis =
        letters.size() == 1 || lacks_axis(dialect, letters.substr(0, letters.size() - 1));
    if (only_the_axis && dialect.axis_of(letters.back()) < 0 && other->axis_of(letters.back()) >= 0)
      return {shown + ": the " + name + " has " + axes_in_words(dialect) + ".", {}};
    return {
        shown + " belongs to the " + std::string(other->model_name) + ". The " + name + " does not know it.",
        {}};
  }
  if (auto about = glued_keyword(dialect, word)) return *about;
  const bool one_letter_and_number = letters.size() == 1 && number >= 0;  // it resembles too many words
  std::string guess = one_letter_and_number ? std::string() : nearest(dialect, letters);
  if (guess.empty()) return {shown + " is not a statement of a " + name + " program.", {}};
  if (number >= 0) {
    if (find_name(dialect, guess, -1)) guess += "=";  // the number is its value, not part of its name
    if (!find_word(dialect, guess)) guess += word.substr(letters.size());
  }
  return {shown + " is not known. Is it " + guess + "?", guess};
}

}  // namespace hw::arcus::language
