#include "core/devices/pmx_4ex_sa/emulator.h"
#include "tests/fuzz/arcus_emulator_session.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  hw::fuzz::Bytes in(data, size);
  auto made = hw::pmx_4ex_sa::make_emulator({});
  hw::fuzz::require(made.has_value());
  hw::fuzz::session(**made, "00", in);
  return 0;
}
