#include "gui/app/program_file.h"

#include <fmt/core.h>

#include "core/device/registry.h"
#include "core/session/address.h"
#include "core/session/text_file.h"

namespace hw::app {

// Of the controller as its options make it; one that has no such option does not take it.
static Result<Catalog> catalog_for(const DeviceType& type, const Given& given) {
  DeviceOptions keys;
  for (const char* key : {"variant", "jumpers"})
    if (given.has(key)) keys[key] = given.one(key);
  auto catalog = type.make_catalog(keys);
  if (catalog && catalog->made_from.size() < keys.size())
    return fail(FaultKind::text, fmt::format("A {} has no --{}.", type.model, keys.begin()->first));
  return catalog;
}

Result<ProgramFile> read_program(const Given& given) {
  if (!given.has("for"))
    return fail(FaultKind::text, "It is not said which controller the program is for.", {},
                fmt::format("Add --for MODEL ({}).", known_models()));
  const DeviceType* type = find_device_type(given.one("for"));
  if (!type)
    return fail(FaultKind::text, fmt::format("There is no controller model \"{}\".", given.one("for")), {},
                fmt::format("Known: {}.", known_models()));
  if (!type->language)
    return fail(FaultKind::port, fmt::format("Programs for the {} are not understood yet.", type->model));
  auto catalog = catalog_for(*type, given);
  if (!catalog) return fail(catalog.error());
  auto file = load_text(given.words[0]);
  if (!file) {
    Fault fault = file.error();
    fault.kind = FaultKind::port;  // the job failed: the command was right
    return fail(std::move(fault));
  }
  ProgramFile program;
  program.path = given.words[0];
  program.text = std::move(file->text);
  program.language = &type->language();
  program.catalog = std::move(*catalog);
  return program;
}

}  // namespace hw::app
