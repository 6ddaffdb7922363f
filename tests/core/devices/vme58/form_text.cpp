#include "tests/core/devices/vme58/form_text.h"

#include <fstream>
#include <map>
#include <sstream>

#include <gtest/gtest.h>

#include "core/devices/vme58/facts.h"

namespace hw::vme58::proof {
namespace {

using WrittenLines = std::vector<WrittenLine>;

/// Lines under their heading, as they stand in the file.
struct WrittenBlock {
  std::string heading;
  int number = 0;
  WrittenLines lines;
};

std::vector<WrittenBlock> blocks_of(const std::string& name) {
  std::vector<WrittenBlock> blocks;
  std::ifstream file(name);
  int number = 0;
  for (std::string line; std::getline(file, line);) {
    ++number;
    if (line.empty() || line[0] == '#') continue;
    if (line.front() == '[')
      blocks.push_back({line.substr(1, line.size() - 2), number, {}});
    else if (!blocks.empty())
      blocks.back().lines.push_back({number, line});
  }
  return blocks;
}

bool begins(const std::string& text, std::string_view head) {
  return text.compare(0, head.size(), head) == 0;
}

void put_in(std::string& text, const std::string& name, const std::string& value) {
  const std::string place = "{" + name + "}";
  for (auto at = text.find(place); at != text.npos; at = text.find(place, at + value.size()))
    text.replace(at, place.size(), value);
}

WrittenLines with(WrittenLines lines, const std::string& name, const std::string& value) {
  for (WrittenLine& line : lines) put_in(line.text, name, value);
  return lines;
}

/// What an "each" goes through.
Words meant_by(const Words& written) {
  Words all;
  for (const std::string& word : written) {
    if (const auto dots = word.find(".."); dots != word.npos) {
      for (int n = std::stoi(word); n <= std::stoi(word.substr(dots + 2)); ++n)
        all.push_back(std::to_string(n));
    } else if (word == "variants") {
      for (const Variant& v : variants) all.emplace_back(v.name);
    } else if (begins(word, "axes")) {
      for (const char letter : axis_letters)
        if (word.find(letter, 4) == word.npos) all.emplace_back(1, letter);
    } else {
      all.push_back(word);
    }
  }
  return all;
}

class Expander {
 public:
  void define(const WrittenBlock& block) {
    const Words words = words_in(block.heading);
    named_[words.at(1)] = {Words(words.begin() + 2, words.end()), block.lines};
  }

  [[nodiscard]] WrittenLines expanded(const WrittenLines& lines) const {
    WrittenLines all;
    for (std::size_t i = 0; i < lines.size(); ++i) {
      const std::string& text = lines[i].text;
      if (begins(text, "each ")) {
        const std::size_t end = end_of(lines, i);
        const WrittenLines inner(lines.begin() + static_cast<std::ptrdiff_t>(i) + 1,
                                 lines.begin() + static_cast<std::ptrdiff_t>(end));
        const Words words = words_in(text);
        for (const std::string& word : meant_by({words.begin() + 2, words.end()}))
          append(all, expanded(with(inner, words.at(1), word)));
        i = end;
      } else if (begins(text, ": ")) {
        append(all, called(words_in(text)));
      } else {
        all.push_back(lines[i]);
      }
    }
    return all;
  }

 private:
  struct Named {
    Words parameters;
    WrittenLines lines;
  };

  static void append(WrittenLines& all, const WrittenLines& more) {
    all.insert(all.end(), more.begin(), more.end());
  }

  static std::size_t end_of(const WrittenLines& lines, std::size_t begin) {
    int depth = 0;
    for (std::size_t i = begin; i < lines.size(); ++i) {
      depth += begins(lines[i].text, "each ");
      depth -= lines[i].text == "end";
      if (depth == 0) return i;
    }
    ADD_FAILURE() << "line " << lines[begin].number << " has no end";
    return lines.size();
  }

  [[nodiscard]] WrittenLines called(const Words& words) const {
    const auto found = named_.find(words.at(1));
    if (found == named_.end()) {
      ADD_FAILURE() << "there are no lines called " << words[1];
      return {};
    }
    const Words& parameters = found->second.parameters;
    WrittenLines lines = found->second.lines;
    for (std::size_t i = 0; i < parameters.size(); ++i) {
      std::string value = i + 2 < words.size() ? words[i + 2] : "";
      if (i + 1 == parameters.size())
        for (std::size_t rest = i + 3; rest < words.size(); ++rest) value += " " + words[rest];
      lines = with(std::move(lines), parameters[i], value);
    }
    return expanded(lines);
  }

  std::map<std::string, Named> named_;
};

/// "vme58.axis.A{X Y}": the words; empty: there are none.
Words words_of_heading(const std::string& heading) {
  const auto open = heading.find('{');
  return open == heading.npos ? Words() : words_in(heading.substr(open + 1, heading.find('}') - open - 1));
}

}  // namespace

Words words_in(const std::string& text) {
  std::istringstream in(text);
  Words words;
  for (std::string word; in >> word;) words.push_back(word);
  return words;
}

std::vector<BoardCase> read_board_cases(const std::string& file) {
  const std::vector<WrittenBlock> blocks = blocks_of(file);
  Expander expander;
  for (const WrittenBlock& block : blocks)
    if (begins(block.heading, ": ")) expander.define(block);
  std::vector<BoardCase> cases;
  for (const WrittenBlock& block : blocks) {
    if (begins(block.heading, ": ")) continue;
    const Words each = words_of_heading(block.heading);
    if (each.empty()) cases.push_back({block.heading, block.number, expander.expanded(block.lines)});
    const auto open = block.heading.find('{');
    for (const std::string& word : each)
      cases.push_back(
          {block.heading.substr(0, open) + word + block.heading.substr(block.heading.find('}') + 1),
           block.number, expander.expanded(with(block.lines, "", word))});
  }
  return cases;
}

}  // namespace hw::vme58::proof
