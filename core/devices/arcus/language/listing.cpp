#include "core/devices/arcus/language/listing.h"

#include <algorithm>

#include "core/base/number_text.h"
#include "core/devices/arcus/language/program.h"
#include "core/devices/arcus/language/text_lines.h"

namespace hw::arcus::language {
namespace {

constexpr std::string_view mark = "LISTING";

std::string_view trimmed(std::string_view text) {
  const auto begin = text.find_first_not_of(" \t");
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(" \t") - begin + 1);
}

/// Takes the word in front of `text`.
std::string_view take_word(std::string_view& text) {
  const auto end = text.find_first_of(" \t");
  const std::string_view word = text.substr(0, end);
  text = end == std::string_view::npos ? std::string_view() : trimmed(text.substr(end));
  return word;
}

/// Also in small letters, which a program may use (AMB-112).
bool is_mark(std::string_view word) {
  return std::equal(word.begin(), word.end(), mark.begin(), mark.end(),
                    [](char c, char m) { return c == m || (c >= 'a' && c <= 'z' && c - 'a' + 'A' == m); });
}

class ListingReader {
 public:
  explicit ListingReader(const Dialect& dialect) : dialect_(dialect) {}

  void see(std::string_view whole, int number) {
    const std::string_view text = trimmed(whole.substr(0, whole.find(';')));
    if (text.empty()) return;
    if (headed_)
      read_line(text, number);
    else
      read_head(text, number);
  }
  ReadListing finish(int last_line) {
    const int lines = static_cast<int>(out_.lines.size());
    if (promised_ >= 0 && lines != promised_)
      report(last_line, "The listing promises " + std::to_string(promised_) + " lines and has " +
                            std::to_string(lines) + ". It is not complete.");
    return std::move(out_);
  }

 private:
  void report(int line, std::string sentence) {
    Problem& problem = out_.problems.emplace_back();
    problem.line = line;
    problem.sentence = std::move(sentence);
  }
  void read_head(std::string_view text, int number) {
    headed_ = true;
    take_word(text);
    const std::string_view model = take_word(text);
    if (model != dialect_.model)
      report(number, "This listing is for another controller: " + std::string(model) + ", not " +
                         std::string(dialect_.model) + ".");
    promised_ = whole_number<int>(text).value_or(-1);
    if (promised_ < 0 || promised_ > program_lines)
      report(number, "Put the number of lines, 0 to 1,275, after the model.");
  }
  void read_line(std::string_view text, int number) {
    const int expected = static_cast<int>(out_.lines.size());
    const std::string_view its_number = take_word(text);
    if (whole_number<int>(its_number) != expected)
      report(number,
             "Line " + std::to_string(expected) + " is expected here, not " + std::string(its_number) + ".");
    out_.lines.emplace_back(text);
    out_.source_line.push_back(number);
  }

  const Dialect& dialect_;
  ReadListing out_;
  bool headed_ = false;
  int promised_ = -1;
};

}  // namespace

std::string write_listing(const std::vector<std::string>& lines, const Dialect& dialect) {
  std::string text =
      std::string(mark) + " " + std::string(dialect.model) + " " + std::to_string(lines.size()) + "\n";
  for (std::size_t n = 0; n < lines.size(); ++n) {
    const std::string number = std::to_string(n);
    text += std::string(4 - number.size(), ' ') + number;
    if (!lines[n].empty()) text += "  " + lines[n];
    text += '\n';
  }
  return text;
}

bool is_listing(std::string_view text) {
  bool found = false, listing = false;
  for_each_line(text, [&](std::string_view line, int) {
    std::string_view statement = trimmed(line.substr(0, line.find(';')));
    if (found || statement.empty()) return;
    found = true;
    listing = is_mark(take_word(statement));
  });
  return listing;
}

ReadListing read_listing(std::string_view text, const Dialect& dialect) {
  ListingReader reader(dialect);
  int last = 0;
  for_each_line(text, [&](std::string_view line, int number) {
    reader.see(line, number);
    if (!trimmed(line).empty()) last = number;
  });
  return reader.finish(last);
}

}  // namespace hw::arcus::language
