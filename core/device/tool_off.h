#pragma once
// The outputs that switch a tool (pen, laser) off, and the comment that names them in a program text.
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
  bool on;     ///< the state in which the tool is off
  bool operator==(const ToolOutput&) const = default;
};
using ToolOff = std::vector<ToolOutput>;

bool uses_tool(const sequence::Sequence& sequence);
/// The outputs that "pen down" and "pen up" leave in different states.
ToolOff tool_off_of(const sequence::Sequence& sequence, int outputs);
/// The line of a program, without the comment mark.
std::string tool_off_line(const ToolOff& tool);
/// The tool that a program text names; the fault names a line that cannot be understood.
Result<ToolOff> tool_off_in(std::string_view text);
/// "output 1", "outputs 1 and 3"
std::string tool_outputs_words(const ToolOff& tool);

}  // namespace hw
