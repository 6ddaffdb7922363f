#pragma once
// A page of the manual as headings, paragraphs, lists, tables and code: as much Markdown as the manual uses.
// No ImGui.
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace hw::panels {

/// A piece of a line that is set in one way.
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
  int level = 0;                                   ///< of a heading from 1; of an item how far it is indented
  std::string mark = {};                           ///< of an item: "1.", or a dot; of a heading its anchor
  ManualLine line = {};                            ///< all but of tables and code
  std::vector<std::string> code = {};              ///< its lines
  std::vector<std::vector<ManualLine>> rows = {};  ///< of a table; the first is its titles
};
using BlockKind = ManualBlock::Kind;

struct ManualText {
  std::string title;
  std::vector<ManualBlock> blocks;
};

ManualText read_manual(std::string_view markdown);
/// "Holding a jog, and leaving" -> "holding-a-jog-and-leaving": what links say behind the #.
std::string manual_anchor(std::string_view heading);
/// Code, links and strong words within a line.
ManualLine read_manual_line(std::string_view line);

}  // namespace hw::panels
