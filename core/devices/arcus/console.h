#pragma once
// The driver context that all parts share (see DriverContext), and the forms of the model.
#include <string>
#include <utility>

#include <fmt/core.h>

#include "core/device/axis_check.h"
#include "core/device/driver.h"
#include "core/devices/arcus/forms.h"

namespace hw::arcus {

struct Console : DriverContext {
  Console(DriverContext context, const Forms& model_forms)
      : DriverContext(std::move(context)), forms(model_forms) {}

  void report(Notice::Kind kind, std::string text) const {
    notify(Notice(kind, scheduler.now(), std::move(text)));
  }
  [[nodiscard]] const Model& model() const { return *forms.model; }
  [[nodiscard]] int axes() const { return model().axes(); }
  [[nodiscard]] const std::string& axis_name(int axis) const {
    return catalog.axes[static_cast<std::size_t>(axis)].name;
  }
  [[nodiscard]] Result<> has_axis(int axis) const { return check_axis(catalog, axis); }

  const Forms& forms;
};

}  // namespace hw::arcus
