#include "core/devices/arcus/held_lines.h"

#include <algorithm>

#include "core/base/index.h"
#include "core/devices/arcus/codec.h"
#include "core/devices/arcus/facts.h"

namespace hw::arcus {
namespace {

bool is_stored_line(std::int64_t line) { return line >= 0 && line < program_lines; }

}  // namespace

HeldLines::HeldLines() : lines_(static_cast<std::size_t>(program_lines)) {}

const std::string* HeldLines::known(int line) const {
  return is_stored_line(line) && lines_[ix(line)] ? &*lines_[ix(line)] : nullptr;
}

void HeldLines::was_read(int line, std::string text) {
  if (is_stored_line(line)) lines_[ix(line)] = std::move(text);
}

// SA12=... writes one line. Any other spelling may write any line, so all lines are forgotten.
void HeldLines::goes_out(std::string_view command) {
  const auto equals = command.find('=');
  if (!command.starts_with("SA") || equals == command.npos) return;
  const auto line = decode_number(command.substr(2, equals - 2));
  if (line && is_stored_line(*line))
    lines_[ix(static_cast<int>(*line))].reset();
  else
    forget();
}

void HeldLines::forget() { std::fill(lines_.begin(), lines_.end(), std::nullopt); }

}  // namespace hw::arcus
