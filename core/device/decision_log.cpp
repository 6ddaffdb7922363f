#include "core/device/decision_log.h"

namespace hw {

log::Subject& pump_log() {
  static log::Subject& one = log::subject("pump");
  return one;
}

log::Subject& driver_log(const Catalog& catalog) { return log::subject("driver." + catalog.model); }

}  // namespace hw
