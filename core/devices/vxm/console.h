#pragma once
// The context that all parts of the driver share: see DriverContext.
#include <string>
#include <utility>

#include "core/device/driver.h"

namespace hw::vxm {

struct Console : DriverContext {
  explicit Console(DriverContext context) : DriverContext(std::move(context)) {}
  void report(Notice::Kind kind, std::string text) const {
    if (notify) notify(Notice(kind, scheduler.now(), std::move(text)));
  }
};

}  // namespace hw::vxm
