#include "panels/help/manual_text.h"

#include <algorithm>
#include <cctype>
#include <optional>

namespace hw::panels {
namespace {

std::string_view without_blanks(std::string_view s) {
  const auto first = s.find_first_not_of(" \t\r");
  if (first == s.npos) return {};
  return s.substr(first, s.find_last_not_of(" \t\r") - first + 1);
}

std::size_t indent_of(std::string_view line) {
  const auto first = line.find_first_not_of(' ');
  return first == line.npos ? 0 : first;
}

void append(ManualLine& line, SpanKind kind, std::string_view text, std::string_view target = {}) {
  if (text.empty()) return;
  if (!line.empty() && line.back().kind == kind && kind != SpanKind::link)
    line.back().text += text;
  else
    line.push_back({kind, std::string(text), std::string(target)});
}

/// "[words](target)" at the start of `s`.
struct LinkParts {
  std::string_view words, target;
  std::size_t size;
};
std::optional<LinkParts> link_at(std::string_view s) {
  const auto close = s.find("](");
  const auto end = close == s.npos ? s.npos : s.find(')', close);
  if (s.empty() || s[0] != '[' || end == s.npos) return std::nullopt;
  return LinkParts{s.substr(1, close - 1), s.substr(close + 2, end - close - 2), end + 1};
}

std::string without_marks(std::string_view words) {
  std::string s(words);
  std::erase_if(s, [](char c) { return c == '`' || c == '*'; });
  return s;
}

/// "- ", "1. " at the start, and the text after it.
struct ItemParts {
  std::string mark;
  std::string_view rest;
};
std::optional<ItemParts> item_at(std::string_view line) {
  if (line.starts_with("- ") || line.starts_with("* ")) return ItemParts{"\u2013", line.substr(2)};
  const auto digits = line.find_first_not_of("0123456789");
  if (digits == 0 || digits == line.npos || digits > 2 || !line.substr(digits).starts_with(". "))
    return std::nullopt;
  return ItemParts{std::string(line.substr(0, digits + 1)), line.substr(digits + 2)};
}

/// Reads lines in order. Each line belongs to the open block or opens a block.
class BlockReader {
 public:
  void take(std::string_view line) {
    const std::string_view words = without_blanks(line);
    if (words.starts_with("```"))
      toggle_code();
    else if (in_code_)
      text_.blocks.back().code.emplace_back(line);
    else if (words.empty())
      finish();
    else if (words[0] == '#')
      take_heading(words);
    else if (words[0] == '|')
      take_row(words);
    else if (words.starts_with("![") && link_at(words.substr(1)))
      take_picture(words);
    else if (const auto item = item_at(words))
      take_item(*item, indent_of(line));
    else
      go_on(words);
  }
  ManualText take_all() {
    finish();
    return std::move(text_);
  }

 private:
  ManualBlock& open(BlockKind kind) {
    finish();
    text_.blocks.push_back({kind});
    return text_.blocks.back();
  }
  /// Turns the collected text into the line of the block.
  void finish() {
    if (!gathered_.empty()) text_.blocks.back().line = read_manual_line(gathered_);
    gathered_.clear();
    in_table_ = false;
  }
  void toggle_code() {
    if (!in_code_) open(BlockKind::code);
    in_code_ = !in_code_;
  }
  void take_heading(std::string_view words) {
    const auto level = words.find_first_not_of('#');
    if (level == words.npos) return;
    ManualBlock& block = open(BlockKind::heading);
    block.level = static_cast<int>(level);
    const std::string_view sentence = without_blanks(words.substr(level));
    block.mark = manual_anchor(sentence);
    block.line = read_manual_line(sentence);
    if (text_.title.empty()) text_.title = without_marks(sentence);
  }
  void take_row(std::string_view words) {
    if (!in_table_) {
      open(BlockKind::table);
      in_table_ = true;
    }
    if (words.find_first_not_of("|-: ") == words.npos) return;  // below the titles
    std::vector<ManualLine>& row = text_.blocks.back().rows.emplace_back();
    std::string cell;
    bool code = false;
    for (std::size_t i = 1; i < words.size(); ++i) {
      if (words[i] == '`') code = !code;
      if (words[i] == '\\' && i + 1 < words.size() && words[i + 1] == '|') {
        cell += words[++i];
      } else if (words[i] == '|' && !code) {
        row.push_back(read_manual_line(without_blanks(cell)));
        cell.clear();
      } else {
        cell += words[i];
      }
    }
  }
  void take_picture(std::string_view words) {
    append(open(BlockKind::picture).line, SpanKind::plain, link_at(words.substr(1))->words);
  }
  void take_item(const ItemParts& item, std::size_t indent) {
    ManualBlock& block = open(BlockKind::item);
    block.level = static_cast<int>(indent / 2);
    block.mark = item.mark;
    gathered_ = item.rest;
  }
  /// Continues the open paragraph or item, or begins a paragraph.
  void go_on(std::string_view words) {
    if (gathered_.empty()) open(BlockKind::paragraph);
    if (!gathered_.empty()) gathered_ += ' ';
    gathered_ += words;
  }

  ManualText text_;
  std::string gathered_;
  bool in_code_ = false, in_table_ = false;
};

}  // namespace

std::string manual_anchor(std::string_view heading) {
  std::string anchor;
  for (const char c : heading) {
    const auto byte = static_cast<unsigned char>(c);
    if (std::isalnum(byte) || c == '-' || c == '_' || byte >= 0x80)
      anchor += static_cast<char>(byte < 0x80 ? std::tolower(byte) : byte);
    else if (c == ' ')
      anchor += '-';
  }
  return anchor;
}

ManualLine read_manual_line(std::string_view s) {
  ManualLine line;
  bool strong = false;
  std::size_t from = 0, i = 0;
  const auto flush = [&] {
    append(line, strong ? SpanKind::strong : SpanKind::plain, s.substr(from, i - from));
  };
  while (i < s.size()) {
    std::size_t marks = 1;
    if (s[i] == '`' && s.find('`', i + 1) != s.npos) {
      flush();
      const auto end = s.find('`', i + 1);
      append(line, SpanKind::code, s.substr(i + 1, end - i - 1));
      i = from = end + 1;
      continue;
    }
    if (const auto link = link_at(s.substr(i))) {
      flush();
      append(line, SpanKind::link, without_marks(link->words), link->target);
      i = from = i + link->size;
      continue;
    }
    // One star or two around words: strong. A star between spaces is a literal star.
    if (s[i] == '*') {
      if (i + 1 < s.size() && s[i + 1] == '*') marks = 2;
      const bool opens =
          !strong && i + marks < s.size() && s[i + marks] != ' ' && s.find('*', i + marks) != s.npos;
      if (opens || (strong && i > 0 && s[i - 1] != ' ')) {
        flush();
        strong = !strong;
        i = from = i + marks;
        continue;
      }
    }
    i += marks;
  }
  flush();
  return line;
}

ManualText read_manual(std::string_view markdown) {
  BlockReader reader;
  while (!markdown.empty()) {
    const auto end = markdown.find('\n');
    reader.take(markdown.substr(0, end));
    markdown = end == markdown.npos ? std::string_view() : markdown.substr(end + 1);
  }
  return reader.take_all();
}

}  // namespace hw::panels
