#pragma once
// Parses a manual page into headings, paragraphs, lists, tables and code: the Markdown that the manual uses.
// No ImGui.
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace hw::panels {

/// A piece of a line in a single style.
struct ManualSpan {
  enum class Kind : std::uint8_t { plain, strong, code, link };
  Kind kind = Kind::plain;
  std::string text;
  std::string target = {};  ///< of a link: "scripts.md#read", "#read"
};
using SpanKind = ManualSpan::Kind;
using ManualLine = std::vector<ManualSpan>;

struct ManualBlock {
  enum class Kind : std::uint8_t { heading, paragraph, item, code, table, picture };
  Kind kind = Kind::paragraph;
  int level = 0;                                   ///< of a heading, from 1; of an item, its indentation
  std::string mark = {};                           ///< of an item: "1." or a dot; of a heading: its anchor
  ManualLine line = {};                            ///< text of all blocks but tables and code
  std::vector<std::string> code = {};              ///< lines of code
  std::vector<std::vector<ManualLine>> rows = {};  ///< of a table; the first row holds its titles
};
using BlockKind = ManualBlock::Kind;

struct ManualText {
  std::string title;
  std::vector<ManualBlock> blocks;
};

ManualText read_manual(std::string_view markdown);
/// The part of a link after the #: "Holding a jog, and leaving" -> "holding-a-jog-and-leaving".
std::string manual_anchor(std::string_view heading);
/// Parses code, links and strong words within a line.
ManualLine read_manual_line(std::string_view line);

}  // namespace hw::panels
