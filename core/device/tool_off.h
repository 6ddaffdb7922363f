#pragma once
// Which outputs switch a tool (pen, laser) off, and how the text of a program says so: by a comment, which
// goes wherever the text goes.
//
//   ; Tool off: output 1 off, output 3 on
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"

namespace hw::sequence {
struct Sequence;
}

namespace hw {

struct ToolOutput {
  int number;  ///< the maker's
  bool on;     ///< so, the tool is off
  bool operator==(const ToolOutput&) const = default;
};
using ToolOff = std::vector<ToolOutput>;

bool uses_tool(const sequence::Sequence& sequence);
/// The outputs that "pen down" leaves one way and "pen up" the other.
ToolOff tool_off_of(const sequence::Sequence& sequence, int outputs);
/// As a line of a program, without the mark of a comment.
std::string tool_off_line(const ToolOff& tool);
/// What a program text says of its tool; the fault names the line that says it in no way that is understood.
Result<ToolOff> tool_off_in(std::string_view text);
/// "output 1", "outputs 1 and 3"
std::string tool_outputs_words(const ToolOff& tool);

}  // namespace hw
