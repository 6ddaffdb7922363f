// Any text, for either model. The compiler may complain as it likes, but what it reports lies inside the
// text, what it makes is within the limits of a controller, and good programs survive every way there and
// back.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>

#include "core/devices/arcus/language/compiler.h"
#include "core/devices/arcus/language/decompiler.h"
#include "core/devices/arcus/language/listing.h"

namespace {

using namespace hw::arcus::language;

void require(bool condition) {
  if (!condition) std::abort();
}

void check_report(const Compilation& compiled) {
  const int lines = static_cast<int>(compiled.text.size());
  for (const hw::Problem& p : compiled.problems)
    require(p.line >= 0 && p.line < lines && p.column >= 0 && p.length >= 0 && !p.sentence.empty());
  for (const int line : compiled.source_line) require(line >= 0 && line < lines);
  for (const SourceLine& line : compiled.text) {
    int end = 0;
    for (const hw::Token& token : line.tokens) {
      require(token.begin >= end && token.end >= token.begin);
      end = token.end;
    }
  }
}

void check_program(const Compilation& compiled, const Dialect& dialect) {
  require(compiled.lines.size() <= hw::arcus::program_lines &&
          compiled.lines.size() == compiled.source_line.size());
  const Program loaded = decode(compiled.lines, dialect);
  require(loaded.bad_lines.empty() && encode(loaded, dialect) == compiled.lines);
  const Compilation again = compile(decompile(compiled.lines, dialect).text, dialect);
  require(again.ok() && again.lines == compiled.lines);
  require(compile(write_listing(compiled.lines, dialect), dialect).lines == compiled.lines);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const Dialect& dialect = data[0] & 1 ? dmx_k_sa() : pmx_4ex_sa();
  const std::string_view text(reinterpret_cast<const char*>(data) + 1, size - 1);
  const Compilation compiled = compile(text, dialect);
  check_report(compiled);
  if (compiled.ok() && !is_listing(text)) check_program(compiled, dialect);
  return 0;
}
