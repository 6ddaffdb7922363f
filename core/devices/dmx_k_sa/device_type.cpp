#include "core/devices/dmx_k_sa/device_type.h"

#include "core/devices/arcus/device_type.h"
#include "core/devices/dmx_k_sa/catalog.h"
#include "core/devices/dmx_k_sa/driver.h"
#include "core/devices/dmx_k_sa/emulator.h"
#include "core/devices/dmx_k_sa/facts.h"
#include "core/devices/dmx_k_sa/program_language.h"

namespace hw::dmx_k_sa {

DeviceType device_type() {
  DeviceType t = arcus::family_type<model, command_help>();
  t.make_catalog = make_catalog;
  t.make_driver = make_driver;
  t.make_emulator = make_emulator;
  t.language = program_language;
  return t;
}

}  // namespace hw::dmx_k_sa
