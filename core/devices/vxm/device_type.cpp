#include "core/devices/vxm/device_type.h"

#include "core/devices/vxm/catalog.h"
#include "core/devices/vxm/codec.h"
#include "core/devices/vxm/driver.h"
#include "core/devices/vxm/emulator.h"
#include "core/devices/vxm/explain.h"
#include "core/devices/vxm/facts.h"
#include "core/devices/vxm/program_language.h"

namespace hw::vxm {

DeviceType device_type() {
  DeviceType t{};
  t.model = "vxm";
  t.make_catalog = make_catalog;
  t.make_driver = make_driver;
  t.make_emulator = make_emulator;
  t.language = program_language;
  t.explain = explain;
  t.probe = probe;
  t.recognises = recognises;
  t.acceleration = acceleration_unit;
  t.refuses = reports_error;
  return t;
}

}  // namespace hw::vxm
