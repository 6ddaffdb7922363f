#include "core/devices/vme58/device_type.h"

#include "core/devices/vme58/catalog.h"
#include "core/devices/vme58/driver.h"
#include "core/devices/vme58/emulator.h"
#include "core/devices/vme58/explain.h"
#include "core/devices/vme58/facts.h"
#include "core/devices/vme58/program_language.h"

namespace hw::vme58 {

// The board is on no serial line, so a search sends no question.
DeviceType device_type() {
  DeviceType t{};
  t.model = "vme58";
  t.make_catalog = make_catalog;
  t.make_driver = make_driver;
  t.make_emulator = make_emulator;
  t.language = program_language;
  t.explain = explain;
  t.probe = "";
  t.recognises = recognises;
  t.acceleration = acceleration_unit;
  return t;
}

}  // namespace hw::vme58
