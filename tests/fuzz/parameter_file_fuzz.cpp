// Any bytes as a parameter file: read or refused in words, and what was read is the same after it was
// written.
#include <cstddef>
#include <cstdint>
#include <cstdlib>

#include "core/devices/vxm/catalog.h"
#include "core/session/parameter_file.h"

static void require(bool held) {
  if (!held) std::abort();
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const hw::Catalog catalog = *hw::vxm::make_catalog({});
  const auto file = hw::parse_backup({reinterpret_cast<const char*>(data), size}, "f");
  if (!file) {
    require(!file.error().sentence().empty());
    return 0;
  }
  const auto again = hw::parse_backup(hw::write_backup(*file, catalog), "f");
  require(again && again->model == file->model && again->name == file->name &&
          again->programs == file->programs);
  require(again->parameters.size() == file->parameters.size());
  for (std::size_t i = 0; i < file->parameters.size(); ++i)
    require(again->parameters[i].mnemonic == file->parameters[i].mnemonic &&
            again->parameters[i].value == file->parameters[i].value);

  hw::Backup of_this_model = *file;
  of_this_model.model = catalog.model;
  const auto checked = hw::check_backup(of_this_model, catalog, "f");
  require(checked.has_value());
  for (const hw::ParameterEntry& entry : checked->parameters)
    require(
        catalog.params[static_cast<std::size_t>(catalog.find_param(entry.mnemonic))].accepts(entry.value));
  for (const auto& [slot, text] : checked->programs) require(slot >= 0 && slot < catalog.program.slots);
  return 0;
}
