// Any bytes as a drawing file: a sentence, or a drawing of numbers.
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>

#include "core/drawing/dxf_reader.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  const auto drawing = hw::drawing::read_dxf(text, "fuzz.dxf", hw::drawing::Tolerance{0.1});
  if (!drawing) {
    if (drawing.error().what.empty()) std::abort();
    return 0;
  }
  if (!std::isfinite(hw::drawing::box_of(*drawing).low.x)) std::abort();
  for (const hw::drawing::LeftOut& l : drawing->left_out)
    if (l.what.empty() || l.why.empty()) std::abort();
  return 0;
}
