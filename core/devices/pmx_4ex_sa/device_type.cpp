#include "core/devices/pmx_4ex_sa/device_type.h"

#include "core/devices/arcus/explain.h"
#include "core/devices/pmx_4ex_sa/catalog.h"
#include "core/devices/pmx_4ex_sa/driver.h"
#include "core/devices/pmx_4ex_sa/emulator.h"
#include "core/devices/pmx_4ex_sa/facts.h"
#include "core/devices/pmx_4ex_sa/program_language.h"

namespace hw::pmx_4ex_sa {
namespace {

std::string explain(std::string_view bytes, Way way, TrafficKind kind, std::string_view asked) {
  static const std::vector<CommandInfo> known = command_help();
  return arcus::explain(model, known, bytes, way, kind, asked);
}

bool recognises(std::string_view reply) { return arcus::names_product(reply, model); }

}  // namespace

DeviceType device_type() {
  DeviceType t{};
  t.model = model.name;
  t.make_catalog = make_catalog;
  t.make_driver = make_driver;
  t.make_emulator = make_emulator;
  t.language = program_language;
  t.explain = explain;
  t.probe = "\r@NNID\r";
  t.recognises = recognises;
  return t;
}

}  // namespace hw::pmx_4ex_sa
