#pragma once
// Reads vme58.forms: cases, and what saves writing a line several times. All of it is done before a case
// runs.
//
//   [vme58.axis.A{X Y}]      a case for each word; {} in its lines stands for the word
//   each N 1..49             its lines, up to "end", once for each word; {N} stands for it. "1..49" are
//   numbers, end                      "variants" the models, "axes" the letters of the axes, "axes-T" all but
//   T
//   [: slide AXIS TEXT]      lines that have a name; ": slide X AC5 VL7" puts them there, the last parameter
//   takes
//                            the rest of the line
//   # text                   a remark
#include <string>
#include <vector>

namespace hw::vme58::proof {

struct WrittenLine {
  int number = 0;
  std::string text;
};

struct BoardCase {
  std::string id;
  int number = 0;  ///< of its first line
  std::vector<WrittenLine> lines;
};

std::vector<BoardCase> read_board_cases(const std::string& file);

using Words = std::vector<std::string>;
Words words_in(const std::string& text);

}  // namespace hw::vme58::proof
