// Any bytes as a bench file: read or refused with a place, never more.
#include <cstddef>
#include <cstdint>
#include <cstdlib>

#include "core/emulation/bench_file.h"

namespace {

hw::Catalog catalog() {
  hw::Catalog c;
  c.axes = {{"1", ""}, {"2", ""}, {"X", ""}};
  c.inputs.resize(4);
  c.analog = {{"Analog", "counts", 0, 1024}};
  c.bench.buttons = {{"Run", true, 0}, {"1-", true, 0}};
  return c;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const hw::Catalog known = catalog();
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  const auto file = hw::parse_bench_file(text, known, "f");
  if (!file && file.error().what.substr(0, 2) != "f:") std::abort();
  if (file)
    for (std::size_t i = 1; i < file->later.size(); ++i)
      if (file->later[i].at < file->later[i - 1].at) std::abort();
  return 0;
}
