// Any bytes as a program text: every place of the report is in the text, and a text that suits another slot
// costs the same there.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "core/devices/vxm/program_analysis.h"

static void require(bool held) {
  if (!held) std::abort();
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const std::string_view text(reinterpret_cast<const char*>(data + 1), size - 1);
  hw::vxm::Analysis analysis = hw::vxm::analyse_text(text, data[0] % 5);
  hw::vxm::check_programs(analysis);
  const hw::ProgramReport& report = analysis.report;
  const int lines = static_cast<int>(report.lines.size());
  for (const hw::Problem& p : report.problems) {
    require(p.line >= 0 && p.line < std::max(lines, 1) && p.column >= 0 && p.length >= 0);
    require(!p.sentence.empty());
  }
  for (const hw::LineReport& line : report.lines) {
    int at = 0;
    for (const hw::Token& token : line.tokens) {
      require(token.begin >= at && token.end >= token.begin && token.end <= static_cast<int>(text.size()));
      at = token.end;
    }
    require(line.cost >= 0 && line.command_count >= 0);
  }
  for (const auto& [slot, cost] : report.cost) require(slot >= 0 && cost >= 0);
  return 0;
}
