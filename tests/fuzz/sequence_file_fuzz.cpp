// Any bytes as a sequence file: a sentence, or a sequence that reads back as the same.
#include <cstddef>
#include <cstdint>
#include <cstdlib>

#include "core/sequence/sequence_file.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  const auto read = hw::sequence::read_sequence(text, "fuzz.toml");
  if (!read) {
    if (read.error().what.empty()) std::abort();
    return 0;
  }
  const auto again = hw::sequence::read_sequence(hw::sequence::write_sequence(*read), "fuzz.toml");
  if (!again || !(*again == *read)) std::abort();
  return 0;
}
